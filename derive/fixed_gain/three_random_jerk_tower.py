"""Random jerk along its curve, for kernels: x = 1 + 2 w; all of it is stable."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.expression import real

F = real("f")
BY_LAG, BY_GAIN = "jerk_by_lag", "jerk_by_gain"
ROOT_THREE = real("root_three")
WIDE = sp.Rational(1, 2) + F
KALMAN = ROOT_THREE / 3 + F


def _polynomial(w: sp.Expr) -> sp.Expr:
    return (1 + w) ** 2 * (2 + 6 * w + 3 * w**2)


def _elements(w: sp.Expr, d: sp.Expr) -> dict[str, sp.Expr]:
    x, top = 1 + 2 * w, _polynomial(w)
    m = (9 * x**2 - 1) * (x**2 - 1) / (24 * x)
    return {
        "alpha": x * (3 * x**2 + 1) / (2 * top),
        "beta": 6 * x**2 / top,
        "gamma": 12 * x / top,
        "lag": top / (12 * x),
        "predicted_11": 2 * top / (3 * x) * (x * (1 + x) + m) / (d * m) - 1,
        "x": x,
    }


def curve_towers() -> tuple[Tower, ...]:
    """w from 1/2 on, g being 3 (1 + 2 w) times the cube root of four lags; w from 1/sqrt(3) on,
    where alpha is below 1.
    """
    x = 1 + 2 * WIDE
    d = (48 * F**4 + 192 * F**3 + 248 * F**2 + 112 * F + 7) / (24 * x)
    cube = Generator("g", sp.expand(9 * x**2 * sp.expand(_polynomial(WIDE))), 3)
    beyond = F * (3 * F + 2 * ROOT_THREE)  # 3 w^2 - 1
    within = (2 * beyond * (1 + KALMAN) ** 2 + 2 * KALMAN + 1) / (3 * (1 + 2 * KALMAN))
    root = Generator("root_three", sp.Integer(3))
    return (
        Tower(BY_LAG, above_zero("f"), (cube,), _elements(WIDE, d)),
        Tower(BY_GAIN, above_zero("f"), (root,), _elements(KALMAN, within)),
    )


def curve_roots() -> dict[str, sp.Expr]:
    """The roots in the kernels of the curve, by lag c and z, by the gain w."""
    s, cube = 1 + WIDE, real("g") / (3 * (1 + 2 * WIDE))
    # s - c = (s^3 - c^3)/(s^2 + s c + c^2) with s^3 - c^3 = s^2 (3 s^2 - 3 s + 1)/(3 (2 s - 1))
    z = 3 * (2 * s - 1) * (s**2 + s * cube + cube**2) / (s**2 * (3 * s**2 - 3 * s + 1))
    scaled = real("alpha") * KALMAN
    by_lag = {"c": cube, "c_of_map": cube**2, "z": z, "z_of_map": z**2, "z_inside": z**4}
    return {**by_lag, "w": scaled, "w_of_map": scaled**2, "w_inside": scaled**4}
