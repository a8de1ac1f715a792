"""What the page `first-measured-two-states` does not say: numbers and forms of the model."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from gainproof.derive.algebra.positive_forms import NoPlainSign
from gainproof.derive.algebra.riccati import definite_evidence
from gainproof.derive.any_two_state import covariance_forms, curvature, derivatives, forms
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.free_numbers import free_number_steps
from gainproof.derive.any_two_state.limits import limit_steps
from gainproof.derive.any_two_state.names import (
    ALPHA,
    BETA,
    D0,
    D1,
    D2,
    DEVIATION,
    GAIN_ROWS,
    INDEX,
    PREDICTED,
    UPDATED,
    S,
    Z,
)
from gainproof.derive.any_two_state.signed_values import Signed
from gainproof.derive.any_two_state.towers import starts_with_half_powers
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError
from gainproof.derive.pages.derivation import Given
from gainproof.derive.pages.model_slots import model_slots
from gainproof.derive.relation import Relation, equal

LONGEST = 250
"""Operations of what stands on a page: about fifteen lines."""
PLACE = (1 + S) / (1 - S)
TOTAL = D0 + D1 + D2
Slots = dict[str, Any]


def given(c: Context, kernels: Sequence[Step]) -> Given:
    """What the page of that model needs; `kernels`: the steps on these."""
    stable: Mapping[str, Signed] = {
        **forms.gains(c.basis),
        **covariance_forms.predicted_covariance(c.basis),
        "updated_22": covariance_forms.updated_22(c.basis),
    }
    half, whole = starts_with_half_powers(c.shape), _is_written(c)
    minors, second = _minors(c), _second(c)
    slots = {
        **model_slots(c.original, c.model),
        "measured": "has two entries, of which the first is",
        **_spectrum(c),
        **{name: value.value for name, value in stable.items()},
        "subtractions": subtractions(dict(sorted(stable.items()))),
        "half_powers": half,
        "written_whole": whole,
        "riccati_by_entries": "" if whole else "riccati-by-entries",
        "minors_are_positive": bool(minors),
        "definite_by_a_theorem": "" if minors else "definite-by-a-theorem",
        "reached": "`Q0` and `F Q0 F'`",
        "left_out": left_out(value.value for value in second.values()),
    }
    hints: dict[str, Slots] = {f"definite-{word}": {"minors": minors[word]} for word in minors}
    if not whole:
        hints["riccati-innovation"] = {"form": TOTAL**2 / 16}
    ends = {}
    if half:
        hints["parameter-range"] = {"form": "2 p"}
        ends["main"] = {"0": c.edges[0].end, "infinity": c.edges[1].end}
    return Given(
        towers=(c.tower,),
        slots={"": slots},
        hints=hints,
        ends=ends,
        steps={
            "free-numbers": free_number_steps(c.original),
            "riccati": [_riccati(c)],
            "stable": [_stable(c)],
            "derivatives": _derivative_steps("derivative", 1, _first(c)),
            "second-derivatives": _derivative_steps("second-derivative", 2, second),
            **limit_steps(c),
            "kernels": kernels,
        },
    )


def _spectrum(c: Context) -> Slots:
    (f0, f1, f2), (n0, n1) = c.shape.open_loop, c.shape.noise_ends
    inner = PLACE * sp.eye(2) - c.model.transition
    known = f2 * S**2 + f1 * S + f0
    gain = sp.ImmutableDenseMatrix([[ALPHA], [BETA]])
    closed = Z * sp.eye(2) - c.model.transition * (sp.eye(2) - gain * c.model.measurement)
    polynomial = sp.collect(sp.expand(closed.det()), Z)
    numbers = {"f0": f0, "f1": f1, "f2": f2, "n0": n0, "n1": n1}
    return {
        **{name: sp.sympify(value) for name, value in numbers.items()},
        "open_loop": _determinant(inner),
        "row": sp.ImmutableDenseMatrix(c.model.measurement * inner.adjugate()),
        "column": sp.ImmutableDenseMatrix((c.model.measurement * inner.subs(S, -S).adjugate()).T),
        "open_loop_squared": sp.Mul(known, known.subs(S, -S), evaluate=False),
        "closed_loop": _determinant(closed),
        "polynomial": polynomial,
        "polynomial_in_s": sp.Mul(
            DEVIATION, (1 - S) ** 2, polynomial.subs(Z, PLACE), evaluate=False
        ),
    }


def _determinant(matrix: sp.MatrixBase) -> sp.Expr:
    products = sp.Mul(matrix[0, 0], matrix[1, 1]), sp.Mul(-1, matrix[0, 1], matrix[1, 0])
    return sp.Add(*(entry for entry in products if entry != 0), evaluate=False)


def subtractions(found: Mapping[str, Signed]) -> str:
    """A sentence on what is left of them."""
    left = [name for name, value in found.items() if value.cancels]
    if not left:
        return "No two computed numbers are subtracted, so no digit cancels in a computer."
    listed = ", ".join(f"`{_written(name)}`" for name in left)
    return f"Where a subtraction is left, both parts are positive: {listed}."


def _written(name: str) -> str:
    kind, _, place = name.partition("_")
    return {"predicted": "M", "updated": "X"}[kind] + place if place else kind


def _is_written(c: Context) -> bool:
    """Whether the Riccati equation is proved as a whole. Where the transition is no polynomial in
    the tower, or a long radicand makes written cofactors longer than the proof, the checker reduces
    it entry by entry.
    """
    entries = [*c.model.transition.flat(), *c.model.process_noise.flat()]
    # the checker takes an entry as it is written, and cancels nothing in it
    return (
        all(generator.symbol != "product" for generator in c.tower.generators)
        and all(sp.sympify(entry).is_polynomial() for entry in entries)
        and all(c.tower.fraction(each).den == c.tower.ring.one for each in entries)
    )


def _square(names: tuple[str, str, str]) -> list[list[str]]:
    first, cross, second = names
    return [[first, cross], [cross, second]]


def _riccati(c: Context) -> Step:
    claim = {
        "model": c.model.data(),
        "predicted": _square(PREDICTED),
        "updated": _square(UPDATED),
        "gain": [list(line) for line in GAIN_ROWS],
        "index": "tracking_index",
    }
    return Step("riccati", "", Relation("riccati", claim), "", hint={"innovation": [TOTAL**2 / 16]})


def _stable(c: Context) -> Step:
    values = [2 * D1 / TOTAL, 2 * (D0 + D2) / TOTAL]
    values += [8 * D1 * D2 / TOTAL**2, 8 * D0 * D1 / TOTAL**2]
    claim = {"model": c.model.data(), "gain": [list(line) for line in GAIN_ROWS]}
    hint = {"values": values, "coefficients": [1 - values[0], 2 * (D0 - D2) / TOTAL]}
    return Step("stable", "", Relation("stable", claim), "", hint=hint)


def _minors(c: Context) -> Mapping[str, list[sp.Expr]]:
    """Leading minors of both covariances where their forms show a sign, else none."""
    try:
        determinant = covariance_forms.updated_determinant(c.basis)
        found = {
            "predicted": [forms.variance_excess(c.basis), TOTAL**2 / 16 * determinant],
            "updated": [forms.alpha(c.basis), determinant],
        }
        for names, minors in zip((PREDICTED, UPDATED), found.values(), strict=True):
            relation = Relation("positive_definite", {"matrix": _square(names)})
            definite_evidence(Step("", "", relation, "", hint={"minors": minors}), c.tower)
    except (ModelError, NoPlainSign):
        return {}
    return found


def _first(c: Context) -> Mapping[str, Signed]:
    """Those that have a form; the first gain always has one for the first derivative."""
    try:
        return derivatives.gains(c.basis)
    except ModelError:
        return {"alpha": Signed(derivatives.gains_slope(c.basis))}


def _second(c: Context) -> Mapping[str, Signed]:
    try:
        return curvature.gains(c.basis)
    except ModelError:
        return {}


def _derivative_steps(word: str, degree: int, found: Mapping[str, Signed]) -> list[Step]:
    """That the derivatives of named quantities are these; the first is shown in any case."""
    steps = [
        followed(f"{word}-{name}", equal(sp.Derivative(real(name), (INDEX, degree)), value.value))
        for name, value in found.items()
        if not value.is_zero
    ]
    return [replace(step, shown=True) if step is steps[0] else step for step in steps]


def left_out(values: Iterable[sp.Expr]) -> str:
    """A sentence on those that are not shown, if there are any."""
    if all(sp.count_ops(value) <= LONGEST for value in values):
        return ""
    return " What would fill half a page is checked like the rest and not shown."


def followed(name: str, relation: Relation) -> Step:
    """A step that joins the one before it; one too long for a page is not shown."""
    if sp.count_ops(relation.parts["right"]) <= LONGEST:
        return joined(name, relation)
    return Step(name, "", relation, "", shown=False)
