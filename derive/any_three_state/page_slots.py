"""What the page `first-measured-three-states` does not say: the model's polynomials, and statements
that have as many parts as their forms.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from gainproof.derive.algebra.leading_elements import NoLeadingTerm
from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.positive_forms import NoPlainSign
from gainproof.derive.algebra.riccati import definite_evidence
from gainproof.derive.any_three_state import derivatives, forms
from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.covariances import hidden_entries
from gainproof.derive.any_three_state.limits import limit_steps
from gainproof.derive.any_three_state.names import (
    GAIN_ROWS,
    GAINS,
    INDEX,
    ROOT,
    ROOTS,
    TOTAL,
    S,
    Z,
    entries,
    symmetric,
)
from gainproof.derive.any_three_state.quantities import Values
from gainproof.derive.any_three_state.towers import powers_of_root
from gainproof.derive.any_two_state.free_numbers import free_number_steps
from gainproof.derive.any_two_state.page_slots import followed, left_out, subtractions
from gainproof.derive.any_two_state.signed_values import Signed
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError
from gainproof.derive.pages.derivation import Given
from gainproof.derive.pages.model_slots import model_slots
from gainproof.derive.relation import Relation, equal

PLACE = (1 + S) / (1 - S)
SHOWN = (
    *("alpha", "beta", "gamma"),
    *(f"predicted_{place}" for place in ("11", "12", "13", "22", "23", "33")),
    *("updated_22", "updated_23", "updated_33"),
)
Slots = dict[str, Any]


def given(c: Context, kernels: Sequence[Step]) -> Given:
    """What the page of that model needs; `kernels`: the steps on these."""
    stable = {name: c.quantities.value(c.basis, name) for name in SHOWN}
    slopes, minors = _slopes(c), _minors(c)
    power, ends = powers_of_root(c.shape), _ends(c)
    slots = {
        **model_slots(c.original, c.model),
        "measured": "has three entries, of which the first is",
        "power": sp.Integer(power),
        "power_is_known": power > 1 and bool(ends),
        "power_has_no_ends": power > 1 and not ends,
        **_spectrum(c),
        **{f"hidden_{place}": value for place, value in hidden_entries(c.shape).items()},
        "subtractions": subtractions(stable),
        "forms_left_out": left_out(value.value for value in stable.values()),
        "derivatives_left_out": left_out(value.value for value in slopes.values()),
        "minors_are_positive": bool(minors),
        "definite_by_a_theorem": "" if minors else "definite-by-a-theorem",
        "reached": "`Q0`, `F Q0 F'` and `F^2 Q0 F^2'`",
    }
    hints: dict[str, Slots] = {
        "hurwitz": {"form": c.basis.determinant},
        "riccati-innovation": {"form": TOTAL**2 / 64},
        **{f"definite-{kind}": {"minors": found} for kind, found in minors.items()},
    }
    if slots["power_is_known"]:
        hints["parameter-range"] = {"form": power * ROOT ** (power - 1)}
    return Given(
        towers=(c.tower,),
        slots={"": slots},
        hints=hints,
        ends={"main": ends},
        steps={
            "free-numbers": free_number_steps(c.original),
            "forms": [followed(_id("stable", x), equal(real(x), stable[x].value)) for x in stable],
            "stable": [_stable(c)],
            "derivatives": [
                followed(f"derivative-{x}", equal(sp.Derivative(real(x), INDEX), value.value))
                for x, value in slopes.items()
                if not value.is_zero
            ],
            **limit_steps(c),
            "kernels": kernels,
        },
    )


def _id(word: str, name: str) -> str:
    return f"{word}-{name}".replace("_", "-")


def _ends(c: Context) -> Mapping[str, End]:
    """Of the tower; nothing where a root has no leading term."""
    try:
        small, large = c.edges
    except NoLeadingTerm:
        return {}
    return {"0": small.end, "infinity": large.end}


def _spectrum(c: Context) -> Slots:
    """The coefficients of the model's polynomials, and what they come from."""
    inner = PLACE * sp.eye(3) - c.model.transition
    line = c.model.measurement * inner.adjugate()
    known = sp.Add(*(own * S**k for k, own in enumerate(c.shape.open_loop)))
    gain = sp.ImmutableDenseMatrix(GAINS)
    closed = Z * sp.eye(3) - c.model.transition * (sp.eye(3) - gain * c.model.measurement)
    polynomial = sp.collect(sp.expand(closed.det(method="berkowitz")), Z)
    n0, n1, n2 = c.shape.noise_numerator
    _, n0_and_n1, n1_and_n2, _ = c.shape.shaken
    return {
        **{f"g{k}": value for k, value in enumerate(c.shape.open_loop)},
        **{f"f{k}": value for k, value in enumerate(c.shape.still)},
        "n0": n0,
        "n1": n1,
        "n2": n2,
        "n0_and_n1": n0_and_n1,
        "n1_and_n2": n1_and_n2,
        "open_loop": _determinant(inner),
        "open_loop_squared": sp.Mul(known, known.subs(S, -S), evaluate=False),
        "row": sp.ImmutableDenseMatrix(line.applyfunc(sp.factor)),
        "column": sp.ImmutableDenseMatrix(line.subs(S, -S).T.applyfunc(sp.factor)),
        "closed_loop": _determinant(closed),
        "polynomial": polynomial,
        "polynomial_in_s": sp.collect(sp.expand(polynomial), Z).subs(Z, PLACE),
    }


def _determinant(matrix: sp.MatrixBase) -> sp.Expr:
    """By the first row, not multiplied out."""
    minors = [matrix.minor_submatrix(0, k).det(method="berkowitz") for k in range(3)]
    terms = [
        (-1) ** k * matrix[0, k] * minors[k] for k in range(3) if minors[k] * matrix[0, k] != 0
    ]
    return sp.Add(*terms, evaluate=False)


def _stable(c: Context) -> Step:
    """The quantities of Schur and Cohn over the roots: sums, and d1 d2 - d0 d3."""
    d0, d1, d2, d3 = ROOTS
    apart = c.basis.determinant
    values = [
        2 * (d1 + d3) / TOTAL,
        2 * (d0 + d2) / TOTAL,
        8 * apart / TOTAL**2,
        8 * (d0 * d1 + 2 * d0 * d3 + d2 * d3) / TOTAL**2,
        128 * d3 * (d0 + d2) * apart / TOTAL**4,
        128 * d0 * (d1 + d3) * apart / TOTAL**4,
    ]
    coefficients = [
        (d0 - d1 + d2 - d3) / TOTAL,
        (3 * d0 - d1 - d2 + 3 * d3) / TOTAL,
        (3 * d0 + d1 - d2 - 3 * d3) / TOTAL,
    ]
    claim = {"model": c.model.data(), "gain": [list(line) for line in GAIN_ROWS]}
    hint = {"values": values, "coefficients": coefficients}
    return Step("stable", "", Relation("stable", claim), "", hint=hint)


def _slopes(c: Context) -> Values:
    """The gains' derivatives that have a form; the first gain's always has one."""
    try:
        return c.quantities.gain_derivatives(c.basis)
    except ModelError:  # the step on the kernel that is not printed says why
        return {"alpha": Signed(derivatives.alpha(c.basis))}


def _minors(c: Context) -> Mapping[str, list[sp.Expr]]:
    """Leading minors of both covariances where their forms show a sign, else none."""
    found = {}
    try:
        for kind in ("predicted", "updated"):
            found[kind] = _leading_minors(c, kind)
            relation = Relation("positive_definite", {"matrix": entries(kind)})
            definite_evidence(Step("", "", relation, "", hint={"minors": found[kind]}), c.tower)
    except (ModelError, NoPlainSign):
        return {}
    return found


def _leading_minors(c: Context, kind: str) -> list[sp.Expr]:
    """Raises NoPlainSign where one has no form without a subtraction."""
    if len(c.tower.parameters) > 2:
        raise NoPlainSign("with several free numbers the search takes too long")
    matrix = symmetric(kind)
    found = [c.quantities.value(c.basis, f"{kind}_11").value]
    for size in (2, 3):
        form = forms.find(c.shape, c.tower, c.tower.fraction(matrix[:size, :size].det()))
        value = c.basis.valued(form)
        if not value.is_positive:
            raise NoPlainSign(f"a leading minor of {kind}")
        found.append(value.plus)
    return found
