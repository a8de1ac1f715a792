"""Steps on the poles one by one: the real one, and modulus and mean of the other two."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import equal, increasing_onto, positive, same_sign
from gainproof.derive.three_state import pole_tower
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import ALPHA, BETA, DELTA, ETA, GAMMA, INDEX, XI, S, Z
from gainproof.derive.three_state.pole_places import middle, numbers
from gainproof.derive.three_state.pole_tower import (
    LEVEL,
    MEAN,
    MODULUS,
    REAL,
    SQUARE,
    A,
    G,
    T,
    Y,
)
from gainproof.derive.three_state.steps_poles import W
from gainproof.derive.three_state.steps_spectrum import D_OF_S

D = sp.Mul(1 + T * S, 1 + A * S + G * S**2, evaluate=False)


def single_pole_towers(c: Context) -> tuple[Tower, ...]:
    """That of the poles; none where the noise is out of reach."""
    return (pole_tower.pole_tower(c),) if pole_tower.within_reach(c.spectrum) else ()


def single_pole_steps(c: Context) -> list[Step]:
    """The poles themselves."""
    if not pole_tower.within_reach(c.spectrum):
        return []
    steps = _in_root() if c.spectrum.rational_in_root else [*_factors(c), *_forms(c)]
    return [replace(step, tower=pole_tower.NAME) for step in steps]


def poles_meant(c: Context) -> dict[str, sp.Expr]:
    """What the outputs of the kernel stand for."""
    if not c.spectrum.rational_in_root:
        return {str(output): output for output in (REAL, MODULUS, MEAN, SQUARE)}
    return {
        "real_pole": W,
        "modulus": MODULUS,
        "half_sum": (XI**2 - 8) / (XI * (XI + 2)),
        "quarter_discriminant": 4 * (16 - 3 * XI**2) / (XI * (XI + 2)) ** 2,
    }


def _in_root() -> list[Step]:
    square, less = MODULUS**2, 1 - MODULUS**2
    mean, turn = (XI**2 - 8) / (XI * (XI + 2)), 4 * sp.Symbol("root_2", real=True)
    whole = XI**2 + turn / 2 * XI + 4
    factor = (INDEX * turn * whole * XI * (XI + 2)) ** -1 * 64 * (XI + turn / 2)
    return [
        Step(
            "modulus-of-pair",
            "The modulus of these two while they are a complex pair, beyond that the geometric "
            "mean of their moduli, is the square root `rho` of `w`.",
            equal(MODULUS**2, W),
            "The product of a number and its conjugate is the square of its modulus. The gains are "
            "rational in `w`.",
        ),
        joined(
            "gains-of-modulus",
            equal(
                sp.ImmutableDenseMatrix([[ALPHA, BETA, GAMMA]]),
                sp.ImmutableDenseMatrix([[1 - square**2, 2 * less**2, 2 * less**3 / (1 + square)]]),
            ),
        ),
        Step(
            "sign-of-half-sum",
            "Half their sum, the real part of a complex pair, is positive up to one index and "
            "negative beyond.",
            same_sign(mean, turn - INDEX),
            "`xi^3 - 4 xi = 64/Lambda`, and `xi^2 = 8` there.",
            hint={"form": factor},
        ),
    ]


def _factors(c: Context) -> list[Step]:
    m1, m2 = numbers(c.spectrum)
    a1, a2, e = c.numbers
    w = Y**2
    cubic = LEVEL * (LEVEL**2 + (2 - m1) * LEVEL + 1 - m1 + m2)
    rise = 1 + (2 - m1) * w + (1 - m1 + m2) * w**2
    equations = sp.ImmutableDenseMatrix([[DELTA**2, XI**2, ETA**2]])
    sums = sp.ImmutableDenseMatrix([[64 / INDEX**2 + e, a1 + 2 * ETA, a2 + 2 * DELTA * XI]])
    gains = sp.ImmutableDenseMatrix([[2 * (1 + ETA), 4 * XI, 8]]) / (1 + XI + ETA + DELTA)
    return [
        Step(
            "level",
            "For the poles one by one another parameter is better. A real pole belongs to a real "
            "zero `-1/t` of `d(s)`. With `t^2 = 1 + G` the left side of step @line-factorisation "
            "becomes a cubic in `G` that has one positive root. Choose `G = 1/y^2`, `y` positive.",
            equal(INDEX**2 * cubic, sp.Integer(64)),
            "Insert `u = -1/t^2` and multiply by `Lambda^2 t^6`. The left side grows with `G`.",
        ),
        joined("level-of-t", equal(T**2, 1 + LEVEL)),
        Step(
            "level-range",
            "Every positive index belongs to exactly one `y`; its square is this.",
            increasing_onto(64 * Y**6 / rise, sp.Integer(0), "infinity", "y"),
            "It increases with `y`: its derivative is a quotient of sums without a minus sign.",
            hint={"ends": pole_tower.ends(c)},
        ),
        joined("index-of-level", equal(INDEX**2, 64 * Y**6 / rise)),
        Step(
            "factors-of-d",
            "Then `d(s)` is the product of `1 + t s` and `1 + a s + g s^2` with these positive `g` "
            "and `a`.",
            equal(D_OF_S, D, free=("s",)),
            "`(1 + a s + g s^2)(1 - a s + g s^2)` times `1 + t^2 u` is the left side of step "
            "@line-factorisation over `Lambda^2`; compare coefficients.",
        ),
        joined("factor-g", equal(G**2, LEVEL**2 + (1 - m1) * LEVEL + m2)),
        joined("factor-a", equal(A**2, m1 + 2 * G - LEVEL)),
        Step(
            "factors-are-those",
            "So over `y`, too, `xi`, `eta` and `delta` satisfy step @three-equations: they are "
            "those of the steady state.",
            equal(equations, sums),
            "For each index three positive numbers satisfy these equations: the first gives "
            "`delta`, and `xi = sqrt(a1 + 2 sqrt(a2 + 2 delta xi))` for one `xi`, since the right "
            "side over `xi` falls.",
        ),
        joined("gains-of-factors", equal(sp.ImmutableDenseMatrix([[ALPHA, BETA, GAMMA]]), gains)),
        *(
            Step(f"positive-factored-{entry}", "", positive(entry), "", shown=False)
            for entry in (DELTA, XI, ETA)
        ),
    ]


def _forms(c: Context) -> list[Step]:
    m1, _ = numbers(c.spectrum)
    place, below = middle(c.spectrum), 1 + A + G
    c_of_z = sum(c.spectrum.closed_loop.coeff(Z, n) * Z**n for n in range(4))
    factors = ((Z - REAL), (Z**2 - 2 * MEAN * Z + MODULUS**2))
    limit = 8 / place.root
    share = LEVEL**2 + (2 - m1 + place.level) * LEVEL + 2 - m1 + place.level
    factor = (LEVEL + place.level + 1 - m1) / ((G + 1) * below) / share
    number = sp.N(8 / sp.sqrt(_plain(place.square)), 6)
    return [
        Step(
            "poles-one-by-one",
            "One pole is a positive number `z1`. The others have half the sum `m` and the product "
            "`rho^2`: `rho` is the modulus of a complex pair, and the geometric mean of the moduli "
            "of two real poles.",
            equal(c_of_z, sp.Mul(*factors, evaluate=False), free=("z",)),
            "Insert these gains.",
        ),
        Step(
            "real-pole",
            "In forms without a subtraction the real pole and the modulus are these.",
            equal(REAL, LEVEL / (T + 1) ** 2),
            "`z1 = (t - 1)/(t + 1)`. With the other two zeros `-1/t2` and `-1/t3` of `d(s)` the "
            "product is `(t2 - 1)(t3 - 1)/((t2 + 1)(t3 + 1))`, and `(t2^2 - 1)(t3^2 - 1)` is the "
            "product `64/(Lambda^2 G)` of the other two roots of the cubic.",
        ),
        joined("modulus-of-pair", equal(MODULUS**2, 64 / (INDEX**2 * LEVEL * below**2))),
        Step(
            "half-sum-of-pair",
            "Half the sum, and the square `h` of half the distance: a complex pair while it is "
            "negative.",
            equal(MEAN, (G - 1) / below),
            "`t2 t3 = g` and `t2 + t3 = a`.",
        ),
        joined("spread-of-pair", equal(SQUARE, MEAN**2 - MODULUS**2)),
        joined("spread-by-level", equal(SQUARE, (m1 - LEVEL - 2 * G) / below**2)),
        Step(
            "sign-of-half-sum",
            "Half the sum, the real part of a complex pair, is positive up to one index and "
            f"negative beyond; with the positive number `k` of the second line it is `8/k`, about "
            f"{number}.",
            same_sign(MEAN, limit - INDEX),
            "`g = 1` there: a quadratic equation for `G`. The cubic of step @level, less that of "
            "this root, has a factor of one sign. The digits are computed, not proved.",
            hint={"form": factor * 64 * (limit + INDEX) / (INDEX * limit) ** 2},
        ),
        joined("number-k", equal(place.root**2, place.square)),
    ]


def _plain(value: sp.Expr) -> sp.Expr:
    """The roots of integers put in by name."""
    names = {symbol: str(symbol).removeprefix("root_") for symbol in value.free_symbols}
    return value.subs({symbol: sp.sqrt(int(name)) for symbol, name in names.items()})
