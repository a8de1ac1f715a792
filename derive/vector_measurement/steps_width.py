"""Steps on the step: from 1.1 times the accuracy with an exact velocity to 1/1.1 without it.

S1 is where P11 is 1.1 times its value at S = 0, S2 where it is 1/1.1 times its limit for large S.
In each corner P11 tends to a function of one variable; S1 and S2 tend to where these take the
value, being the crossings of monotone functions.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import (
    cited,
    equal,
    increasing_onto,
    monotone,
    same_sign,
)
from gainproof.derive.source import ELEMENTARY
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.corners import T, W, X
from gainproof.derive.vector_measurement.ends import ratio_ends
from gainproof.derive.vector_measurement.steps_limits import times_text
from gainproof.derive.vector_measurement.towers import rational

MORE = sp.Rational(11, 10)
OUTER, B = real("outer"), real("b")
LATEX = {"outer": "u"}
P11 = real("predicted_11")


def outer_tower() -> Tower:
    """x and sqrt(1 + 2 x^2): the shape of P11 where a small index forgets the velocity."""
    generators = (Generator("outer", 1 + 2 * X**2),)
    return Tower("outer", (Parameter("x"),), generators, {})


def width_steps(c: Context) -> list[Step]:
    """Existence and uniqueness of S1 and S2, and where they go for small and large index."""
    noise = c.noise
    if not noise.determinant:
        return []
    ends = ratio_ends(noise)
    return [
        Step(
            "width-range",
            "For every index `P11` takes each value between its limits at exactly one `S`. So "
            "`S1`, where it is 1.1 times the first, and `S2`, where it is the second over 1.1, "
            "exist and are unique: the step of `P11` reaches from `S1` to `S2`.",
            increasing_onto(
                P11, real("known_predicted_11"), real("only_predicted_11"), "velocity_ratio"
            ),
            "`P11` grows with `S` (step @increasing-predicted-11-velocity-ratio); its limits are "
            "in steps @velocity-known-predicted-11 and @velocity-absent-predicted-11. The ratio of "
            "both is below `1/1.1^2` by step @improvement-range, so `S1` lies before `S2`.",
            tower="ends",
            heading="The width of the step",
            hint={"ends": ends},
        ),
        *_small_index(c),
        *_large_index(c),
        Step(
            "width-crossings",
            "That `S1` and `S2` themselves tend to these crossings of the limits rests on a "
            "theorem.",
            cited(
                "If strictly monotone functions tend at every point to a strictly monotone "
                "function, the points where they cross a value tend to where it does.",
                ELEMENTARY.text(),
            ),
            "Compare the values a little before and a little after the limit's crossing. The "
            "theorem is cited, not proved here.",
        ),
    ]


def _small_index(c: Context) -> list[Step]:
    d = rational(c.noise.determinant)
    first = d * (MORE**2 - 1)
    outer = X * OUTER / (1 + X**2)
    return [
        Step(
            "width-start-small-trend",
            "Where is `S1` for a small index (large `r`)? There, `t` held, `P11/Lambda` tends to "
            "`w/t`, which falls as `t` grows.",
            monotone(W / T, "decreasing", "t"),
            "Step @small-velocity-index-predicted-11; the derivative is `-1/(w t^2)`.",
            tower="fixed_velocity_index",
        ),
        Step(
            "width-start-small",
            f"It is 1.1 times its limit for large `t` where `1/t^2 = {first}`. So `S1/Lambda` "
            f"tends to the root of {first}, and `r S1` to `{sp.sqrt(16 * first)}`, about "
            f"{float(sp.sqrt(16 * first)):.6f}.",
            equal((W / T) ** 2 - MORE**2 * d, 1 / T**2 - first),
            f"`w^2 = 1 + {times_text(d, 't^2')}` (step @level), so the limit of `w^2/t^2` is {d}; "
            "square `w/t`. `S1/Lambda` is `1/t`, and `r = 4/Lambda`.",
            tower="fixed_velocity_index",
        ),
        Step(
            "width-end-small-trend",
            "And `S2`? For a small index, `x = S/sqrt(Lambda)` held, `P11/sqrt(Lambda)` tends to a "
            "function that grows with `x`; here `u = sqrt(1 + 2 x^2)`.",
            monotone(outer, "increasing", "x"),
            "Step @small-narrow-predicted-11; differentiate.",
            tower="outer",
        ),
        Step(
            "width-end-small",
            "It is its limit `sqrt(2)` over 1.1 where `42 x^4 - 279 x^2 - 200 = 0`. So "
            f"`S2/sqrt(Lambda)` tends to {_narrow_root():.6f}, `sqrt(r) S2` to twice that, and the "
            "width `S2/S1` of the step grows like `sqrt(r)`.",
            equal(
                MORE**2 * outer**2 - 2,
                (42 * X**4 - 279 * X**2 - 200) / (100 * (1 + X**2) ** 2),
            ),
            "Square 1.1 times the function and compare with 2. The quadratic in `x^2` has one "
            "positive root.",
            tower="outer",
        ),
    ]


def _narrow_root() -> float:
    z = sp.Symbol("z", positive=True)
    return float(sp.sqrt(max(sp.solve(42 * z**2 - 279 * z - 200, z))))


def _large_index(c: Context) -> list[Step]:
    e, first = rational(c.noise.e), rational(c.noise.first)
    root = sp.sqrt(e)
    shape = B * (W + B) / (2 * (W * B + e * T**2 / 4)) - (1 - e) / 4
    steps = [
        Step(
            "width-large-trend",
            "For a large index (small `r`), `t` held, `P11/Lambda^2` tends to a function that "
            "falls as `t` grows; here `b` is `gamma` times half the root of "
            f"{e}, so `b^2 = {times_text(e, '(1 + t^2/4)')}`.",
            monotone(shape, "decreasing", "t"),
            "Step @large-velocity-index-predicted-11; differentiate.",
            tower="fixed_velocity_index",
        )
    ]
    for label, name, text, level in (
        ("start", "S1", "1.1 times its limit for large `t`", MORE * first),
        ("end", "S2", "its limit for small `t` over 1.1", (1 + root) ** 2 / (4 * MORE)),
    ):
        slope, square = _crossing(e, level)
        crossing = 1 / sp.sqrt(square)
        steps += [
            Step(
                f"width-{label}-large",
                f"It is {text} where `w/b` is `{_written(slope)}`.",
                same_sign(shape - _in_tower(level), W - _in_tower(slope) * B),
                "Multiply out: the left difference is a positive multiple of the right one.",
                tower="fixed_velocity_index",
                hint={"form": _factor(e, _in_tower(level))},
            ),
            Step(
                f"width-{label}-large-root",
                f"That is where `t^2` is `{_written(square)}`. So `{name}/Lambda` tends to "
                f"{float(crossing):.6f}, and `r {name}` to {float(4 * crossing):.6f}.",
                equal(
                    W**2 - _in_tower(slope**2) * B**2,
                    _in_tower((slope**2 - 1) * e / 4) * (_in_tower(square) - T**2),
                ),
                f"Square both sides of step @width-{label}-large and insert `w^2` and `b^2`, both "
                "linear in `t^2`.",
                tower="fixed_velocity_index",
            ),
        ]
    return steps


def _crossing(e: sp.Expr, level: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """w/b and t^2 where P11/Lambda^2 tends to the level."""
    share = level + (1 - e) / 4
    slope = _plain((share - (1 - e) / 2) / (share * e))
    return slope, _plain(4 / e * (1 - slope**2 * e) / (slope**2 - 1))


def _written(number: sp.Expr) -> str:
    """A number of Q(sqrt(3)) in a sentence, its positive term first."""
    terms = sorted(sp.Add.make_args(number), key=lambda term: bool(term < 0))
    first, *others = (sp.sstr(abs(term)).replace("*", " ") for term in terms)
    signs = ("-" if term < 0 else "+" for term in terms[1:])
    return " ".join([first, *(f"{sign} {text}" for sign, text in zip(signs, others, strict=True))])


def _plain(number: sp.Expr) -> sp.Expr:
    return sp.expand(sp.radsimp(sp.expand(sp.radsimp(number))))


def _in_tower(number: sp.Expr) -> sp.Expr:
    """A number of Q(sqrt(3)) over the tower's own root; e = 1/3 is the only case so far."""
    return sp.expand(number).subs(sp.sqrt(3), real("root_3"))


def _factor(e: sp.Expr, level: sp.Expr) -> sp.Expr:
    """The positive factor share e/(b - e w), its denominator over the conjugate."""
    share = level + (1 - e) / 4
    square = (e - e**2) + (e / 4 - e**3 / 4) * T**2
    return share * e * (B + e * W) / square
