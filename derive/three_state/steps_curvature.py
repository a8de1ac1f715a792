"""Steps on second derivatives by the index: which entries of the steady state bend which way."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import equal, increasing_onto, positive, same_sign
from gainproof.derive.three_state import bending, curvature, shown_signs
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.covariance_entries import updated
from gainproof.derive.three_state.names import (
    BEND,
    DEVIATION,
    ETA,
    FALL,
    GAINS,
    GROWTH,
    INDEX,
    SLOWING,
    TAU,
    XI,
    label,
    second,
)
from gainproof.derive.three_state.steps_change import numbers
from gainproof.derive.three_state.surds import plain_number

UPWARD = ("predicted_13", "predicted_22", "predicted_23", "predicted_33")
UPDATED = ("updated_23", "updated_33")


def turns(c: Context) -> bool:
    """Whether the second derivative of X22 changes its sign; elsewhere it is negative."""
    return not c.spectrum.rational_in_root


def curvature_steps(c: Context) -> list[Step]:
    """The four powers, the second derivatives, and their signs."""
    steps = (*_powers(c), *_gains(c), *_covariances(c), *_turning(c))
    return [replace(step, tower=bending.NAME) for step in steps]


def _powers(c: Context) -> list[Step]:
    n = numbers(c)
    slope = {name: INDEX * sp.Derivative(name, INDEX) for name in (XI, FALL, GROWTH)}
    variance = INDEX * sp.Derivative(DEVIATION**2, INDEX)
    return [
        Step(
            "powers",
            "The second derivatives need four numbers, powers of the index: near each index `xi` "
            "falls like the power `omega` of the index, `omega` itself like the power `mu`; "
            "`sigma^2` grows like the power `psi`, and `psi` like the power `1 - chi`.",
            equal(FALL * XI, -slope[XI]),
            "Their names.",
            heading="How the steady state bends",
        ),
        joined("power-mu", equal(SLOWING * FALL, -slope[FALL])),
        joined("power-psi", equal(GROWTH * DEVIATION**2, variance)),
        joined("power-chi", equal((1 - BEND) * GROWTH, slope[GROWTH])),
        Step(
            "power-forms",
            f"All are sums of positive terms: `delta^2` is more than `{n.e}` (step @above-e)."
            if n.e
            else "All are sums of positive terms.",
            equal(FALL, curvature.fall(n)),
            "Steps @derivative-delta and @derivative-deviation, differentiated once more; what is "
            "subtracted goes by step @three-equations.",
        ),
        joined("form-mu", equal(SLOWING, curvature.slowing(n))),
        joined("form-psi", equal(GROWTH, curvature.growth(n))),
        joined("form-chi", equal(BEND, curvature.bend(n))),
        joined("form-less-chi", equal(1 - BEND, curvature.straightening(n))),
    ]


def _equal(entries: Mapping[str, sp.Expr]) -> Iterable[Step]:
    return (
        joined(label("second-derivative", name), equal(second(name), form))
        for name, form in entries.items()
    )


def _signs(c: Context, names: Iterable[str], up: bool) -> Iterable[Step]:
    """Steps on the sign of second derivatives, all alike; own noises may leave a sign open."""
    word, sign = ("convex", 1) if up else ("concave", -1)
    hints = ((name, shown_signs.curve(c, name, up)) for name in names)
    return (
        joined(label(word, name), positive(sign * second(name)), hint=hint)
        for name, hint in hints
        if hint
    )


def _opened(steps: Iterable[Step], sentence: str, reason: str) -> list[Step]:
    """The steps, the first of which speaks for all; none for none."""
    return [
        step if number else replace(step, sentence=sentence, reason=reason, joins=False)
        for number, step in enumerate(steps)
    ]


def _gains(c: Context) -> list[Step]:
    return [
        *_opened(
            _equal(curvature.gain_second_derivatives(numbers(c))),
            "The second derivatives of the gains.",
            "Differentiate `alpha = 1 - 1/sigma^2` (step @variance), `gamma = Lambda/sigma` and "
            "`beta = gamma xi/2` (steps @deviation and @gains) twice, with step @powers.",
        ),
        *_opened(
            _signs(c, GAINS, up=False),
            "They are negative: each gain rises ever more slowly.",
            "But for the minus before them all three are sums, products and quotients of positive "
            "terms.",
        ),
    ]


def _covariances(c: Context) -> list[Step]:
    forms = curvature.covariance_second_derivatives(numbers(c))
    falling = (
        []
        if turns(c)
        else _opened(
            _signs(c, ("updated_22",), up=False),
            "The variance of the updated velocity bends down everywhere.",
            "Over `p` its negative is a quotient of sums without a minus sign.",
        )
    )
    return [
        *_opened(
            _equal(forms),
            "And those of the covariances; the first row of `X` are the gains.",
            "`M11 = sigma^2 - 1`, `M12 = Lambda sigma xi/2` and `M13 = Lambda sigma` with step "
            "@powers; the others of step @predicted-33 are `Lambda^2` times a sum, and "
            "`(d/dLambda)^2 (Lambda^2 f) = 2 f + 3 L f + L L f` with `L` of step "
            "@derivative-delta.",
        ),
        *_opened(
            _signs(c, (*UPWARD, *UPDATED), up=True),
            "These bend up everywhere.",
            "Over `p` they are quotients of sums without a minus sign.",
        ),
        *falling,
    ]


def _turning(c: Context) -> list[Step]:
    """M11, M12 and in all but one family of noises X22 bend down first and then up."""
    n, share = numbers(c), sp.Rational(1, 9)
    first, other = GROWTH - BEND, curvature.cross()
    found = [
        _same_sign("predicted_11", first, DEVIATION**2 * GROWTH / INDEX**2),
        _rising(c, "predicted_11", (first, first), (-6 * share, sp.Integer(1))),
        _same_sign("predicted_12", other, DEVIATION * XI / (2 * INDEX)),
        _rising(c, "predicted_12", (other, other), (-2 * share, sp.Integer(2))),
    ]
    if turns(c):
        form = curvature.covariance_second_derivatives(n)["updated_22"] / ETA
        end = plain_number(_far_rate(c) / (c.constants.b + c.constants.c))
        found.append(_rising(c, "updated_22", (second("updated_22") / ETA, form), (-share, end)))
    if c.spectrum.m2 and not all("form" in step.hint for step in found):
        return []  # some own noise, of which more cannot be shown
    return _opened(
        found,
        f"`M11`{', `M12` and `X22`' if turns(c) else ' and `M12`'} turn once: they bend down up to "
        "some index and up from there. Kernels give their second derivatives with an error that is "
        "relative to the parts whose difference they are.",
        "Step @second-derivative-predicted-11; the derivatives by `p` of what increases are "
        "quotients of sums without a minus sign.",
    )


def _same_sign(name: str, value: sp.Expr, factor: sp.Expr) -> Step:
    return joined(label("turning", name), same_sign(second(name), value), hint={"form": factor})


def _rising(
    c: Context, name: str, value: tuple[sp.Expr, sp.Expr], ends: tuple[sp.Expr, sp.Expr]
) -> Step:
    """That the first of two equal expressions rises; the second holds no derivative."""
    shown, plain = value
    return joined(
        label("turns-once", name),
        increasing_onto(shown, *ends, c.running),
        hint={"ends": c.ends, **shown_signs.slope_by_parameter(c, plain)},
    )


def _far_rate(c: Context) -> sp.Expr:
    """Twice X22/Lambda^2 for an infinite index."""
    k, a1 = c.constants, c.numbers[0]
    known = {XI: k.least, ETA: k.b + k.c, TAU: k.least * (k.b + k.c) - k.c, INDEX: sp.Integer(1)}
    return sp.expand(2 * updated(c.model.process_noise, a1)["updated_22"].subs(known))
