"""Steps on the change with the index: first derivatives and trends."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, equal, monotone
from gainproof.derive.three_state import forms, shown_signs
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import DELTA, DEVIATION, GAINS, INDEX, TAU, XI

UPDATED = ("updated_22", "updated_23", "updated_33")


def numbers(c: Context) -> forms.Numbers:
    """The family's numbers in the forms of the derivatives."""
    return forms.numbers(c.model, c.spectrum)


def change_steps(c: Context) -> list[Step]:
    """First derivatives by the index and the trends."""
    n = numbers(c)
    gains, predicted = forms.gain_derivatives(n), forms.predicted_derivatives(n)
    return [
        *_logarithmic(n),
        *_derivatives(
            gains,
            "The gains change with the index like this.",
            "Differentiate step @gains with the derivatives of step @derivative-delta and gather "
            "positive terms.",
        ),
        *_hidden(_derivatives(forms.predictor_derivatives(n), "", "")),
        *_derivatives(
            predicted,
            "And the predicted covariance; the first row of `X` are the gains.",
            "Differentiate the entries of steps @predicted-covariance and @predicted-33 in the "
            "same way.",
        ),
        *_trends(c, predicted),
    ]


def _logarithmic(n: forms.Numbers) -> list[Step]:
    slope = (DELTA**2 - n.e) / DELTA
    rows = {"delta": slope, "xi": slope * XI / TAU, "eta": slope * XI**2 / TAU}
    first, *others = (
        (f"derivative-{name}", equal(-INDEX * sp.Derivative(real(name), INDEX), form))
        for name, form in rows.items()
    )
    return [
        Step(
            first[0],
            "All three coefficients of `d` fall as the index grows.",
            first[1],
            "Write `L f` for `Lambda (d/dLambda) f`. Step @three-equations gives "
            "`delta L delta = -64/Lambda^2`, `xi L xi = L eta` and "
            "`eta L eta = xi L delta + delta L xi`. Solve the last two; `xi eta - delta = tau`.",
            heading="How the steady state changes with the index",
        ),
        *(joined(*entry) for entry in others),
        Step(
            "derivative-deviation",
            "The deviation of the innovations grows.",
            equal(
                sp.Derivative(DEVIATION, INDEX),
                DEVIATION * forms.deviation_rate(n) / INDEX,
            ),
            "Differentiate step @deviation and put sums for differences with step "
            "@three-equations.",
        ),
    ]


def _derivatives(entries: Mapping[str, sp.Expr], sentence: str, reason: str) -> list[Step]:
    first, *others = (
        (f"derivative-{name.replace('_', '-')}", equal(sp.Derivative(real(name), INDEX), form))
        for name, form in entries.items()
    )
    return [Step(first[0], sentence, first[1], reason), *(joined(*entry) for entry in others)]


def _hidden(steps: list[Step]) -> Iterator[Step]:
    """Steps that are proved and not shown again."""
    return (replace(step, shown=False) for step in steps)


def _trends(c: Context, predicted: Mapping[str, sp.Expr]) -> list[Step]:
    def rising(name: str) -> Relation:
        return monotone(real(name), "increasing")

    names = (*GAINS, *predicted, *UPDATED)
    return [
        Step(
            "increasing-alpha",
            "Gains and covariances all grow with the index.",
            rising("alpha"),
            "Their derivatives over `p` are quotients of sums without a minus sign.",
            hint=shown_signs.slope(c, "alpha"),
        ),
        *(
            joined(
                f"increasing-{name.replace('_', '-')}",
                rising(name),
                hint=shown_signs.slope(c, name),
            )
            for name in names[1:]
        ),
    ]
