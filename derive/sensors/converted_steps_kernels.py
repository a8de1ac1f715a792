"""Steps on what the kernels in the plane compute: the formulas as the papers print them."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import column
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation, equal
from gainproof.derive.sensors.converted_graphs import KERNELS, PLANE
from gainproof.derive.sensors.converted_names import (
    COS_A,
    KEPT,
    LOSS,
    SIGMA_A,
    SIGMA_R,
    SIN_A,
    G,
    K,
    L,
    R,
)

WHOLE = R**2 + SIGMA_R**2
TWICE = COS_A**2 - SIN_A**2, 2 * SIN_A * COS_A
"""Cosine and sine of twice the azimuth."""
AHEAD = {COS_A: 1, SIN_A: 0}
"""At azimuth 0 the line of sight is the x axis."""
ALONG = column(COS_A**2, SIN_A * COS_A, SIN_A**2)
"""The entries xx, xy, yy of a unit variance along the line of sight."""
TURNED = column(
    WHOLE * (1 + L**2 * TWICE[0]) / 2,
    WHOLE * L**2 * TWICE[1] / 2,
    WHOLE * (1 - L**2 * TWICE[0]) / 2,
)
"""Mean squares of the true place given the measurement."""


def kernel_steps(graphs: Mapping[str, Graph]) -> list[Step]:
    """Each kernel computes what it says; `graphs` are without calls."""
    below = (1 + G**2) * (1 + K**2)
    circle = equal(
        column(COS_A, SIN_A, COS_A**2 + SIN_A**2),
        column(
            (4 * G * K - (1 - G**2) * (1 - K**2)) / below,
            -(2 * G * (1 - K**2) + 2 * K * (1 - G**2)) / below,
            1,
        ),
    )
    return [
        Step("plane-azimuth", "The azimuth.", circle, "As a bearing.", tower="plane", shown=False),
        Step(
            "plane-kept",
            "What noise keeps.",
            equal(
                column(KEPT, sp.Symbol("change_azimuth", real=True)), column(1 / (1 + LOSS), L - 1)
            ),
            "`exp(-sigma^2/2)`, and `exp(-sigma^2) - 1` (expm1).",
            tower="plane",
            shown=False,
        ),
        *(_kernel(name, graphs[f"{KERNELS[name]}{PLANE}"]) for name in KERNELS),
    ]


def printed(name: str) -> tuple[sp.Expr, sp.Matrix]:
    """The factor of a conversion, and xx, xy, yy of its covariance as its paper prints them."""
    match name:
        case "classical":
            across = column(SIN_A**2, -SIN_A * COS_A, COS_A**2)
            return sp.Integer(1), SIGMA_R**2 * ALONG + (R * SIGMA_A) ** 2 * across
        case "debiased":
            return 1 - (L - KEPT), _debiased()
        case "unbiased":
            return 1 / KEPT, (1 / L - 2) * R**2 * ALONG + TURNED
    return KEPT, TURNED - L * R**2 * ALONG


def _debiased() -> sp.Matrix:
    """(13a) to (13c), hyperbolic functions written out."""
    cosh = {k: (L**k + L**-k) / 2 for k in (1, 2)}
    sinh = {k: (L**-k - L**k) / 2 for k in (1, 2)}
    even = R**2 * (cosh[2] - cosh[1]) + SIGMA_R**2 * (2 * cosh[2] - cosh[1])
    odd = R**2 * (sinh[2] - sinh[1]) + SIGMA_R**2 * (2 * sinh[2] - sinh[1])
    return column(
        L**2 * (COS_A**2 * even + SIN_A**2 * odd),
        SIN_A * COS_A * L**4 * (SIGMA_R**2 + WHOLE * (1 - 1 / L)),
        L**2 * (SIN_A**2 * even + COS_A**2 * odd),
    )


def _kernel(name: str, graph: Graph) -> Step:
    kernel = f"{KERNELS[name]}{PLANE}"
    factor, (xx, xy, yy) = printed(name)
    meant = {
        "x": factor * R * COS_A,
        "y": factor * R * SIN_A,
        "covariance_xx": xx,
        "covariance_xy": xy,
        "covariance_yy": yy,
        "radial_variance": xx.subs(AHEAD, simultaneous=True),
        "cross_variance": yy.subs(AHEAD, simultaneous=True),
        "kept_azimuth_of": -(SIGMA_A**2) / 2,
        "change_azimuth_of": -(SIGMA_A**2),
    }
    return Step(
        f"kernel-{kernel.replace('_', '-')}",
        f"The kernel {kernel} computes what it says.",
        Relation(
            "program",
            {"program": kernel, "outputs": {each: meant[each] for each in graph["outputs"]}},
        ),
        "Its forms without cancellation equal the printed ones; the value of a sine, cosine or "
        "exponential stands as the quantity that it is, and what an exponential is taken of is "
        "claimed too.",
        tower="plane",
        hint={"graph": graph},
        shown=False,
    )
