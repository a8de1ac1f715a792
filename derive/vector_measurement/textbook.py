"""The steady state as the literature prints it: what kernels are compared with.

These forms subtract computed values and lose digits; nothing is printed from them.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.vector_measurement import radicands
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import INDEX, RATIO
from gainproof.derive.vector_measurement.pole_kernels import MEAN, MODULUS, POLES, SQUARE
from gainproof.derive.vector_measurement.towers import rational, symbolic_noise

Forms = Mapping[str, sp.Expr]


def textbook_forms(c: Context) -> Mapping[str, Forms]:
    """Expressions by kernel and output, over Lambda and S alone: sigma from its quadratic, then
    the equations of the filter solved one after another.
    """
    noise, area = symbolic_noise(c.noise), INDEX**2
    n = rational(c.noise.n)
    one = sp.sqrt(c.spectrum.constant)
    mean = (one + sp.sqrt(radicands.eta_squared(noise, INDEX, RATIO)) / RATIO) / 2
    delta = sp.sqrt(mean**2 - 4)
    sigma = (mean + delta) / 2
    cross = (area * (1 / sigma + n * delta) + RATIO**2 * one) / (delta**2 + RATIO**2)
    rate = delta * cross - n * area
    step = 2 * cross / sigma + rate + rational(c.noise.first) * area
    first = 1 - (rate + area + RATIO**2) / (RATIO**2 * sigma**2)
    updated = {"updated_11": first, "updated_12": cross / sigma, "updated_22": rate}
    gains = {
        "gain_11": first,
        "gain_12": cross / sigma / RATIO**2,
        "gain_21": cross / sigma,
        "gain_22": rate / RATIO**2,
    }
    return {
        "gains": gains,
        POLES: _poles(gains),
        "updated_covariance": updated,
        "predicted_covariance": {
            "predicted_11": first + step,
            "predicted_12": cross * sigma,
            "predicted_22": rate + area,
        },
    }


def _poles(gains: Forms) -> Forms:
    """From trace and determinant of F (I - K)."""
    half = (2 - gains["gain_11"] - gains["gain_21"] - gains["gain_22"]) / 2
    product = (1 - gains["gain_11"]) * (1 - gains["gain_22"]) - gains["gain_12"] * gains["gain_21"]
    return {
        MEAN: half,
        MODULUS: sp.sqrt(product),
        SQUARE: half**2 - product,
    }
