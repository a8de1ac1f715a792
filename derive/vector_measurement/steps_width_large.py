"""Steps on the width of the step for a large index, where it settles."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, monotone, same_sign
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.corners import T, W
from gainproof.derive.vector_measurement.steps_limits import times_text
from gainproof.derive.vector_measurement.steps_width_small import MORE
from gainproof.derive.vector_measurement.towers import rational

B = real("b")


def large_index_steps(c: Context) -> list[Step]:
    """Where S1 and S2 go as the index grows without bound."""
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
