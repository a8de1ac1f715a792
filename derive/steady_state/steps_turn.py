"""Steps on the predicted variance of the position, which bends down and then up."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, increasing_onto, same_sign
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.curvature_covariances import (
    first_second_derivative_round_turn,
    turning_index,
)
from gainproof.derive.steady_state.names import BEND, DEVIATION, GROWTH, INDEX
from gainproof.derive.steady_state.steps_curvature import second
from gainproof.derive.steady_state.towers import KAPPA, RHO, rational

ROOT_3 = real("root_3")
TURN_TOWER = "with_root_of_3"


def turn_tower(c: Context) -> tuple[Tower, ...]:
    """Where e = 0: the main tower with sqrt(3), in which the turn of M11 lies."""
    if c.e:
        return ()
    roots = (Generator("root_3", sp.Integer(3)), *c.tower.generators)
    return (Tower(TURN_TOWER, c.tower.parameters, roots, c.tower.expressions),)


def turn_steps(c: Context) -> list[Step]:
    """The predicted variance of the position bends down, then up."""
    name, root = "predicted_11", sp.sqrt(rational(c.e))
    sign = _sign(c.e)
    e = rational(c.e)
    share = DEVIATION**2 * GROWTH * KAPPA**2 / (2 * (INDEX * RHO) ** 2 * (KAPPA + e / 2))
    largest = sp.radsimp((1 + root) ** 3 / root) if c.e else "infinity"
    return [
        Step(
            "second-derivative-predicted-11",
            "The predicted variance of the position is the one entry that turns: it bends down "
            "while `psi` is less than `chi`, up from there.",
            equal(second(name), DEVIATION**2 * GROWTH * (GROWTH - BEND) / INDEX**2),
            "Differentiate `M11 = sigma^2 - 1` twice, with step @growth-and-bend.",
        ),
        Step(
            "one-turn",
            "It turns once: the difference has the sign of a function that grows with the index "
            "from -1 up, and so vanishes once.",
            same_sign(second(name), sign),
            "Insert step @growth-by-ratios in `psi - chi` and divide by the positive "
            f"`{_text(c.e)}`. The derivative of the result is a quotient of sums without a "
            "minus sign.",
            hint={"form": share},
        ),
        joined(
            "one-turn-range",
            increasing_onto(sign, sp.Integer(-1), largest),
            hint={"ends": c.ends},
        ),
        _place(c, share),
    ]


def _place(c: Context, share: sp.Expr) -> Step:
    """Where the predicted variance of the position turns."""
    left = second("predicted_11")
    if c.e == 0:
        form = first_second_derivative_round_turn(c.basis, ROOT_3)
        turn = INDEX - turning_index(ROOT_3)
        return Step(
            "turn",
            "The place, in closed form.",
            same_sign(left, turn),
            "The function of step @one-turn vanishes where `1 + 2 y - 2 y^2` does, with "
            "`y = rho - 1/2`: at `y = (1 + sqrt(3))/2`, and `Lambda = 2/(y (y + 1))`.",
            tower=TURN_TOWER,
            hint={"form": form / turn},
        )
    polynomial, rest = _turn_polynomial(c.e)
    return Step(
        "turn",
        "The place is the largest root of a polynomial in the ratio of the gains, which has the "
        f"same sign. The index there is about {turning_number(c.e)}.",
        same_sign(left, polynomial),
        "Insert `kappa` from step @roots-in-the-index in the function of step @one-turn and drop "
        "positive factors. The number is computed, not proved.",
        hint={"form": share * rest / KAPPA**4},
    )


def _sign(number: Fraction) -> sp.Expr:
    """2 rho^2 (kappa + e/2)/kappa^2 times psi - chi."""
    e = rational(number)
    rising = 2 * RHO * (1 + e / (2 * KAPPA)) ** 2 / KAPPA
    falling = (1 / (2 * KAPPA), e / (4 * KAPPA**2), 3 * e**2 / (8 * KAPPA**3))
    return rising - 1 - sp.Add(*falling) - (1 + e) * e**2 / (16 * KAPPA**4)


def _text(number: Fraction) -> str:
    """kappa^2/(2 rho^2 (kappa + e/2)) in a sentence."""
    if number == 0:
        return "kappa/(2 rho^2)"
    return f"kappa^2/(2 rho^2 (kappa + {number / 2}))"


def _turn_polynomial(number: Fraction) -> tuple[sp.Expr, sp.Expr]:
    """The factor of that difference, as a polynomial in rho, that changes its sign; the others."""
    e = rational(number)
    whole = sp.Poly(sp.expand(_sign(number) * KAPPA**4).subs(KAPPA, RHO**2 - (1 + e) / 4), RHO)
    least = sp.Rational(int(500_000 * (1 + float(number) ** 0.5)), 1_000_000)
    factors = (part for part, _ in whole.factor_list()[1])
    (factor,) = (part for part in factors if part.count_roots(inf=least))
    factor = factor if factor.LC() < 0 else -factor
    return factor.as_expr(), sp.factor(whole.quo(factor).as_expr())


def turning_number(number: Fraction) -> str:
    """The index at which M11 turns, to six digits."""
    polynomial, _ = _turn_polynomial(number)
    ratio = max(map(sp.re, sp.Poly(polynomial, RHO).nroots(30)))
    e = rational(number)
    kappa = ratio**2 - (1 + e) / 4
    return str(sp.N(2 / sp.sqrt(kappa**2 - e / 4), 6))
