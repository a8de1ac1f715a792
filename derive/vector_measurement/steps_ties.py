"""Steps that tie a side tower to the model: there too the names are those of the steady state."""

from __future__ import annotations

from typing import Any

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    DELTA,
    ETA,
    GAIN_ROWS,
    INDEX,
    MEAN,
    PREDICTED,
    RATIO,
    SIGMA,
    UPDATED,
)


def riccati_step(c: Context, name: str, tower: str, **written: Any) -> Step:
    """The filter's equations over the named entries of a tower; `written` are fields of the step.

    Without it a statement in that tower is about elements that merely bear the names of the
    model's quantities.
    """
    relation = Relation(
        "riccati",
        {
            "model": c.model_data,
            "predicted": square(PREDICTED),
            "updated": square(UPDATED),
            "gain": gain_rows(),
            "index": str(INDEX),
        },
    )
    hint = {"innovation": [real("predicted_11") + 1, SIGMA**2 * RATIO**2]}
    return Step(name, relation=relation, tower=tower, hint=hint, **written)


def stable_step(c: Context, name: str, tower: str, **written: Any) -> Step:
    """Both poles lie inside the unit circle, over the named gains of a tower."""
    relation = Relation("stable", {"model": c.model_data, "gain": gain_rows()})
    values = [
        DELTA / SIGMA,
        MEAN / SIGMA,
        DELTA * ETA / SIGMA**2,
        DELTA * INDEX * c.level / SIGMA**2,
    ]
    return Step(name, relation=relation, tower=tower, hint={"values": values}, **written)


def tie_steps(c: Context, tower: str) -> list[Step]:
    """The covariances and gains of a side tower are the steady state of the model."""
    key = tower.replace("_", "-")
    return [
        riccati_step(
            c,
            f"{key}-riccati",
            tower,
            sentence="The same covariances and gains, over the parameters of this part.",
            reason="As in step @riccati.",
            shown=False,
        ),
        stable_step(
            c,
            f"{key}-stable",
            tower,
            sentence="So they are the steady state here too.",
            reason="As in step @stable.",
            shown=False,
        ),
    ]


def square(entries: tuple[str, str, str]) -> list[list[str]]:
    """The names of a symmetric 2 x 2 matrix by its entries 11, 12, 22."""
    first, cross, second = entries
    return [[first, cross], [cross, second]]


def gain_rows() -> list[list[str]]:
    """The names of the gains, by rows."""
    return [list(row) for row in GAIN_ROWS]
