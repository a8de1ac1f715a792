"""Steps on the covariance of the truth in space: that it is positive definite."""

from __future__ import annotations

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import column
from gainproof.derive.relation import Relation, equal, positive
from gainproof.derive.sensors.converted_names import COS2, KEPT, LOSS, SIN2
from gainproof.derive.sensors.converted_space_names import (
    COS_E,
    ENTRY,
    KEPT_E,
    LA,
    LE,
    LOSS_E,
    ONCE,
    SIN_E,
    UPRIGHT,
    WHOLE,
    A,
    squares,
)
from gainproof.derive.sensors.converted_space_steps import (
    azimuth_squares,
    flat,
    mean_square_error,
    modified,
    upright,
)

UNBIASED, MODIFIED = ENTRY["space_unbiased"], ENTRY["space_modified"]


def space_sign_steps() -> list[Step]:
    """Leading minors."""
    ahead, across, up, tilt = MODIFIED
    level = WHOLE * ONCE[0]
    form = LA * flat()[0] * flat()[1] + (1 - LA) ** 2 * level / 2 * UPRIGHT[1]
    return [
        *_tied(),
        Step(
            "space-definite",
            "It is positive definite whatever the noise.",
            positive(ahead),
            "Leading minors; below the plane of x and y everything is the mirror image. The "
            "determinant of ahead and up is the sum of `lambda^2` times that of the plane and of "
            "what the azimuth adds ahead, times the variance up.",
            tower="signs",
        ),
        _of_signs("space-definite-across", positive(across)),
        _of_signs("space-definite-up", positive(up)),
        joined("space-definite-minor", positive(ahead * up - tilt**2), "signs", {"form": form}),
    ]


def _tied() -> list[Step]:
    """The same quantities in the tower in which signs are shown."""
    circle = 2 * A / (1 + A**2), (A**2 - 1) / (1 + A**2)
    kept = 1 / (1 + LOSS_E), 1 / (1 + LOSS)
    return [
        _quiet("signs-circle", equal(column(COS_E, SIN_E, KEPT_E, KEPT), column(*circle, *kept))),
        _quiet("signs-squares", equal(column(*ONCE), column(*squares(LE**2)))),
        _quiet("signs-azimuth", equal(column(COS2, SIN2), column(*azimuth_squares()))),
        _quiet("signs-upright", equal(column(*UPRIGHT), column(*upright()))),
        _quiet("signs-modified", equal(column(*MODIFIED), column(*modified()))),
        _quiet("signs-unbiased", equal(column(*UNBIASED), column(*mean_square_error()))),
    ]


def _quiet(name: str, relation: Relation) -> Step:
    return Step(name, "What the names mean.", relation, "As before.", tower="signs", shown=False)


def _of_signs(name: str, relation: Relation) -> Step:
    return joined(name, relation, "signs")
