"""The poles of any alpha-beta-gamma filter, stable or not, by the numbers of their reduced cubic.

c(1 + u) = u^3 + s u^2 + b u + gamma with s = alpha + beta + gamma/2 and b = beta + 3 gamma/2 has
positive coefficients; u = w - s/3 takes the square away: w^3 = 3 p w + 2 q. The poles themselves
have no bound that holds everywhere: next to a threefold one they move by the cube root of what the
gains move by. So the kernel ends at p, q and p^3 - q^2, which is 1/108 of the discriminant.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.fixed_gain.three_towers import LOOP
from gainproof.derive.fixed_gain.two_kernels import SCALE, difference
from gainproof.derive.printer.graph import Graph, GraphBuilder
from gainproof.derive.printer.kernel import Input, closed

POLES = "closed_loop_poles"
TOWER = "any_gains"
MEAN, LINEAR, CONSTANT, WHOLE = (
    "mean_distance",
    "reduced_linear",
    "reduced_constant",
    "discriminant",
)
TURNING = (LINEAR, CONSTANT, WHOLE)
MEANINGS = {
    MEAN: "1 less the mean of the poles",
    LINEAR: "p of the reduced cubic",
    CONSTANT: "q of the reduced cubic",
    WHOLE: "p^3 - q^2, 0 or more where all poles are real",
}
SUMMARY = "Closed-loop poles, 1 - mean_distance + w with w^3 = 3 p w + 2 q, of any positive gains."
EQUATIONS = (
    "s = alpha + beta + gamma/2, b = beta + 3 gamma/2, mean_distance = s/3,",
    "p = reduced_linear = s^2/9 - b/3, q = reduced_constant = s b/6 - s^3/27 - gamma/2,",
    "discriminant = p^3 - q^2 = (s^2 b^2 + 18 s b gamma - 4 b^3 - 4 s^3 gamma - 27 gamma^2)/108.",
    "Three real poles where it is not negative: w = 2 sqrt(p) cos(t + 2 pi k/3), cos(3 t) =",
    "q/p^(3/2); else with r = (|q| + sqrt(-discriminant))^(1/3) and the sign of q the real one",
    "has w = +-(r + p/r), the pair real parts of -1/2 and imaginary parts of +-sqrt(3)/2 times",
    "r + p/r and r - p/r. No bound of the poles themselves holds everywhere: next to a threefold",
    "pole they move by the cube root of what p and q move by. The domain holds all stable gains",
    "from 1e-20 on, and others",
)
ALPHA, BETA, GAMMA = LOOP.gains
S, B = ALPHA + BETA + GAMMA / 2, BETA + 3 * GAMMA / 2
P, Q = S**2 / 9 - B / 3, S * B / 6 - S**3 / 27 - GAMMA / 2


def pole_input(entry: str, meaning: str) -> Input:
    """Gains up to the ends of the region of stability, where it touches them."""
    most = {"alpha": "2", "beta": "4", "gamma": "8"}[entry]
    return closed(entry, meaning, "1e-20", most, ("1e-4", most))


def poles() -> Graph:
    """From the gains: sums of positive terms and differences of such sums."""
    builder = GraphBuilder()
    alpha, beta, gamma = (builder.symbol(name) for name in ("alpha", "beta", "gamma"))
    half = gamma / 2
    s, b = alpha + beta + half, beta + gamma + half
    square, product = s * s, s * b
    p = square / 9, b / 3
    q = product / 6, square * s / 27 + half
    # 4 b^3 + 4 s^3 gamma + 27 gamma^2
    less = (b * b * b + square * s * gamma) * 4 + gamma * gamma * 27
    whole = (product + gamma * 18) * product / 108, less / 108
    outputs = {MEAN: s / 3}
    differences = {}
    for name, (ahead, behind) in zip(TURNING, (p, q, whole), strict=True):
        outputs[name] = ahead - behind
        outputs[name + SCALE] = ahead + behind
        differences[difference(name)] = outputs[name]
    return builder.graph(outputs, differences)


def pole_meanings() -> dict[str, sp.Expr]:
    """What the outputs stand for."""
    return {
        MEAN: S / 3,
        LINEAR: P,
        CONSTANT: Q,
        WHOLE: P**3 - Q**2,
        LINEAR + SCALE: S**2 / 9 + B / 3,
        CONSTANT + SCALE: S * B / 6 + S**3 / 27 + GAMMA / 2,
        WHOLE + SCALE: (
            S**2 * B**2 + 18 * S * B * GAMMA + 4 * B**3 + 4 * S**3 * GAMMA + 27 * GAMMA**2
        )
        / 108,
    }
