"""Steps on the covariances, on the forms that kernels compute, and on derivatives."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.any_three_state import derivatives
from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.covariances import hidden_entries
from gainproof.derive.any_three_state.names import DEVIATION, GAINS, INDEX
from gainproof.derive.any_three_state.quantities import Values
from gainproof.derive.any_two_state.names import row
from gainproof.derive.any_two_state.page_slots import followed, left_out
from gainproof.derive.any_two_state.signed import Signed
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError
from gainproof.derive.relation import equal

HIDDEN = ("22", "23", "33")


def covariance_steps(c: Context) -> list[Step]:
    """Both covariances over the gains."""
    alpha, beta, gamma = GAINS
    square = DEVIATION**2
    hidden = hidden_entries(c.shape)
    return [
        Step(
            "covariances",
            "The covariance of the predicted state's error is `M`, that of the updated state's "
            "error `X`. Their first rows are the gains.",
            equal(
                row(*(real(f"{k}_1{i}") for k in ("predicted", "updated") for i in (1, 2, 3))),
                row(square - 1, beta * square, gamma * square, alpha, beta, gamma),
            ),
            "`K = M H'/(H M H' + R)`, where `H M H' + R = sigma^2`, gives the first column of `M`, "
            "and `X = (I - K H) M`.",
            heading="The covariances",
        ),
        Step(
            "hidden-covariances",
            "The entries of `X` that no gain shows:",
            equal(
                row(*(real(f"updated_{place}") for place in HIDDEN)),
                row(*(hidden[place] for place in HIDDEN)),
            ),
            "Three of the equations `M = F X F' + Lambda^2 Q0` with `X = M - sigma^2 K K'`, solved "
            "for them.",
        ),
        joined(
            "hidden-predicted",
            equal(
                row(*(real(f"predicted_{place}") for place in HIDDEN)),
                row(
                    *(
                        real(f"updated_{i}{j}") + GAINS[i - 1] * GAINS[j - 1] * square
                        for i, j in ((2, 2), (2, 3), (3, 3))
                    )
                ),
            ),
        ),
    ]


def form_steps(c: Context) -> list[Step]:
    """The forms without a subtraction, or with both parts of one that is left."""
    q = c.quantities
    names = ("alpha", "beta", "gamma")
    entries = ("11", "12", "13", *HIDDEN)
    listed = [*names, *(f"predicted_{e}" for e in entries), *(f"updated_{e}" for e in HIDDEN)]
    found = {name: q.value(c.basis, name) for name in listed}
    left = [_written(name) for name, value in found.items() if value.cancels]
    text = (
        "No two computed numbers are subtracted, so no digit cancels in a computer."
        if not left
        else f"Where a subtraction is left, both parts are positive: {', '.join(left)}."
    )
    (first, relation), *others = (
        (f"stable-{name.replace('_', '-')}", equal(real(name), value.value))
        for name, value in found.items()
    )
    return [
        Step(
            first,
            f"The same in forms for a computer. {text}",
            relation,
            "Times sums of the roots, and by the equations of step @roots, each is a sum of terms "
            "of one sign." + left_out(value.value for value in found.values()),
            heading="Forms for a computer",
        ),
        *(followed(name, entry) for name, entry in others),
    ]


def derivative_steps(c: Context) -> list[Step]:
    """How the gains change with the index."""
    found: Values
    try:
        found = c.quantities.gain_derivatives(c.basis)
    except ModelError:  # the step on the kernel that is not printed says why
        found = {"alpha": Signed(derivatives.alpha(c.basis))}
    (first, relation), *others = (
        (f"derivative-{name}", equal(sp.Derivative(real(name), INDEX), value.value))
        for name, value in found.items()
        if not value.is_zero
    )
    return [
        Step(
            first,
            "The gains change with the index like this.",
            relation,
            "Differentiate the equations of step @roots: two of them are linear equations for the "
            "derivatives of `d1` and `d2`, whose determinant is that of step @hurwitz."
            + left_out(value.value for value in found.values()),
            heading="How the steady state changes with the index",
        ),
        *(followed(name, entry) for name, entry in others),
    ]


def _written(name: str) -> str:
    kind, _, place = name.partition("_")
    letter = {"predicted": "M", "updated": "X"}
    return f"`{letter[kind]}{place}`" if place else f"`{kind}`"
