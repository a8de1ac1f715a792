"""What is shown of a filter with free gains before it is used, and what is cited."""

from __future__ import annotations

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import symbol
from gainproof.verify.judge.exact.poly import Poly, fraction, terms
from gainproof.verify.judge.fixed_gain.loop import Loop, steps_of_gains
from gainproof.verify.judge.fixed_gain.rational_system import numerator_and_denominator
from gainproof.verify.judge.setting.environment import Fact, NotEstablished

HURWITZ = (
    (
        "a real polynomial with a positive leading coefficient has all roots in the left half "
        "plane exactly if its coefficients and Hurwitz determinants are positive"
    ),
    "F. R. Gantmacher, Applications of the Theory of Matrices, 1959, chapter V",
)
LYAPUNOV = (
    (
        "the Lyapunov equation of a stable matrix has one solution, to which the covariance tends "
        "whatever it starts from"
    ),
    "P. Lancaster, L. Rodman, Algebraic Riccati Equations, Oxford 1995, chapter 5",
)
METHOD = "identity of polynomials"


def loop_facts() -> tuple[Fact, ...]:
    """What holds for all gains; the equations are checked where they are solved."""
    return (
        Fact("covariances satisfy their Lyapunov equation for all gains", METHOD),
        Fact("lags satisfy the recursion of errors for all gains", METHOD),
        Fact(f"cited: {HURWITZ[0]}", HURWITZ[1]),
        Fact(f"cited: {LYAPUNOV[0]}", LYAPUNOV[1]),
    )


def chart_facts(loop: Loop) -> tuple[Fact, ...]:
    """That the steps reach stable filters only, and each of them. Raises NotEstablished."""
    for rel in loop.region:
        moved = substituted(rel.left, dict(loop.chart))
        top, bottom = numerator_and_denominator(moved, loop.steps)
        if not (_positive(top) and _positive(bottom)):
            raise NotEstablished("coordinates that leave the stable region")
    back = steps_of_gains(loop)
    for name, value in loop.chart.items():
        again = substituted(value, back) - symbol(name)
        if not numerator_and_denominator(again, loop.gains)[0].is_zero():
            raise NotEstablished("coordinates that miss a stable filter")
    return (
        Fact("positive steps give stable filters: polynomials without a negative term", METHOD),
        Fact("each stable filter has positive steps, found from its gains", METHOD),
    )


def _positive(p: Poly) -> bool:
    """Whether a polynomial has terms and none is negative: positive for positive variables."""
    return not p.is_zero() and all(fraction(c) > 0 for _, c in terms(p))
