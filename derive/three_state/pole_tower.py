"""The tower of the single poles: over the level G of the real one, or the kernels' with more roots.

G is the positive root of G (G^2 + (2 - m1) G + 1 - m1 + m2) = 64/Lambda^2. With y = 1/sqrt(G),
w = y^2, s = sqrt(1 + w), R = sqrt(1 + (2 - m1) w + (1 - m1 + m2) w^2) and
k = sqrt(1 + (1 - m1) w + m2 w^2) the index is 8 y^3/R, t = s/y, g = k/w, and
a^2 = (2 k + m1 w - 1)/w, where 2 k - 1 = k + (k^2 - 1)/(k + 1) + ... shows its sign over k + 1.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.expression import real
from gainproof.derive.steady_state.towers import rational
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.kernel_basis import UNIT
from gainproof.derive.three_state.names import DELTA, DEVIATION, ETA, INDEX, NU, XI
from gainproof.derive.three_state.pole_places import middle, numbers, places, turn
from gainproof.derive.three_state.spectrum import Spectrum
from gainproof.derive.three_state.towers import kernel_tower

NAME = "poles"
Y, R, K, SIDE, STEP = real("y"), real("rise"), real("k"), real("side"), real("step")
LEVEL, T, A, G = real("level"), real("t"), real("a"), real("g")
REAL, MODULUS = real("real_pole"), real("modulus")
MEAN, SQUARE = real("half_sum"), real("quarter_discriminant")


def within_reach(spectrum: Spectrum) -> bool:
    """Whether every quantity of these towers is positive by its looks."""
    if spectrum.rational_in_root:
        return True
    if spectrum.m1 > 1 or spectrum.m2 >= 1:
        return False
    squares = [
        sp.Poly(place.square, *place.square.free_symbols, sp.Dummy()) for place in places(spectrum)
    ]
    return all(value > 0 for square in squares for value in square.coeffs())


def level_tower(c: Context) -> Tower:
    """The steady state over y, poles among its elements."""
    s = c.spectrum
    m1, m2 = numbers(s)
    w = Y**2
    generators = {entry.symbol: entry for place in places(s) for entry in place.generators}
    side = 1 + (1 - m1) * w + m2 * w**2
    above, clear = 1 + (2 - m1) * w + (1 - m1 + m2) * w**2, s.m1**2 == 4 * s.m2
    rise: sp.Expr = 1 + (1 - m1 / 2) * w if clear else R
    cube = sp.expand(rise**3) if clear else R * above
    step = (K + 1) * (K + 1 + m1 * w * K + (2 - m1) * w + 2 * m2 * w**2)
    found = [
        *generators.values(),
        Generator("upper", 1 + w),
        *(() if clear else (Generator("rise", sp.expand(above)),)),
        Generator("k", side),
        Generator("step", sp.expand(step)),
        Generator("r", sp.expand(8 * Y**3 * cube), 4),
    ]
    width = STEP / (K + 1)
    below = w + width * Y + K
    elements = {
        "tracking_index": 8 * Y**3 / rise,
        "fourth_root": real("r") / rise,
        "level": 1 / w,
        "t": real("upper") / Y,
        "a": width / Y,
        "g": K / w,
        "xi": T + A,
        "eta": T * A + G,
        "delta": T * G,
        "nu": 1 + XI + ETA + DELTA,
        "alpha": 2 * (1 + ETA) / NU,
        "beta": 4 * XI / NU,
        "gamma": 8 / NU,
        "real_pole": 1 / (real("upper") + Y) ** 2,
        "modulus": rise / below,
        "half_sum": (K - w) / below,
        "quarter_discriminant": w * (m1 * w - 1 - 2 * K) / below**2,
        "rest_of_root": w
        * (3 + 3 * (2 - m1) * w + 2 * (1 - m1 + m2) * w**2)
        / (3 * above)
        / real("fourth_root") ** 3,
    }
    return Tower(NAME, (Parameter("y"),), tuple(found), elements)


def root_tower(c: Context) -> Tower:
    """The kernels' tower with the roots of the single poles, where all is rational in w."""
    inner = kernel_tower(c.tower)
    main = c.tower.fraction(1 / DEVIATION)
    whole = c.tower.expression(c.tower.make(main.num * main.den, c.tower.ring.one))
    below = c.tower.expression(c.tower.make(main.den, c.tower.ring.one))
    generators = (
        Generator("root_2", sp.Integer(2)),
        Generator("root_3", sp.Integer(3)),
        *inner.generators,
        Generator("side", whole),
    )
    elements = {**inner.expressions, "modulus": SIDE / below}
    return Tower(NAME, inner.parameters, generators, elements)


def pole_tower(c: Context) -> Tower:
    """The one that fits the family."""
    return root_tower(c) if c.spectrum.rational_in_root else level_tower(c)


def kernel_roots(c: Context) -> dict[str, sp.Expr]:
    """Tower values of the roots in `kernel_poles`."""
    s, r = c.spectrum, real("fourth_root")
    if s.rational_in_root:
        return {
            "p": r**2,
            "r": r,
            "x": XI * r / 2,
            "e": ETA * r**2 / 4,
            "eta_of_map": ETA * r**2 / 4,
            "root_2": real("root_2"),
            "root_3": real("root_3"),
            "modulus_inverse": 1 / MODULUS,
        }
    z = real("rest_of_root") / (1 + INDEX * r / 64)
    found = {
        "p": r**2,
        "r": r,
        "z": z,
        "inner": z**2,
        "v_root": Y / r**2,
        "t": T,
        "a": A,
        "c_scaled": rational(UNIT) * DELTA * r**2 / 8,
        "middle_surd": middle(s).surd,
        "middle_root": middle(s).root,
    }
    other = turn(s)
    if other is not None:
        found |= {"turning_surd": other.surd, "turning_root": other.root}
    return found


def ends(c: Context) -> dict[str, End]:
    """Behaviour of the tower over the level at both ends of y, as far as y itself needs it."""
    found = [entry for place in places(c.spectrum) for entry in place.generators]
    swap = {real(entry.symbol): real(f"limit_{entry.symbol}") for entry in found}
    constants = {f"limit_{entry.symbol}": entry.radicand.subs(swap) for entry in found}
    held = {str(old): new for old, new in swap.items()}
    start = {"upper": 1, "rise": 1, "k": 1, "step": 2, "r": 0}
    weights = {"upper": 2, "rise": 3, "k": 3, "step": 4, "r": 3}
    kept = {entry.symbol for entry in level_tower(c).generators}
    near = {name: sp.Integer(value) for name, value in start.items() if name in kept}
    far = {name: sp.Integer(0) for name in near}
    above = {name: value for name, value in weights.items() if name in kept}
    return {
        "0": End(constants=constants, boundary={**held, **near}),
        "infinity": End(weights=above, constants=constants, boundary={**held, **far}),
    }
