"""The gains together with their derivatives, in the fewest operations that keep both accurate.

`gain_kernels` spends operations on the last half of a rounding: it chooses by the index and takes
the root last. Where derivatives are wanted too, the time counts more: here

    p = sqrt(Lambda), h = sqrt(16/Lambda + e Lambda), r = sqrt(p ((1 + e) p + 2 h)) = 2 rho p,
    alpha = 2 r/(p + h + r), beta = 4 p/(p + h + r)

serve every index without a choice, and so do, with y = beta/Lambda = 1/sigma, the derivatives

    d alpha = 2 y^2 (h + e p)/(p h r), d beta = 2 y^2 (2 + 2 p/r)/(p h).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gainproof.derive.printer.graph import GraphBuilder, Node
from gainproof.derive.steady_state.forms import times
from gainproof.derive.steady_state.kernels import Names, NodesOf

SCALE = Fraction(1, 2**40)
"""Comes with h, p and r in sums where e > 0: 16/Lambda stays finite and p normal in either format.
"""
HALF = Fraction(1, 2)
"""Does where e = 0: Lambda + 8 could overflow."""


def scale_of(e: Fraction) -> Fraction:
    """What h, p and r are multiplied by in sums."""
    return SCALE if e else HALF


def gains_with_derivatives(
    builder: GraphBuilder, e: Fraction, n: Fraction
) -> tuple[Mapping[str, Node], Names]:
    """Filter gain and its derivatives, whose names begin with d_."""
    del n  # the gains do not depend on it
    return _undamped(builder) if e == 0 else _damped(builder, e)


GAINS_WITH_DERIVATIVES = NodesOf(gains_with_derivatives)


def _undamped(builder: GraphBuilder) -> tuple[Mapping[str, Node], Names]:
    """e = 0: h = 4/p, and sigma^2 is what the derivatives share."""
    index = builder.symbol("tracking_index")
    p = builder.sqrt(index)
    small = p * HALF
    r = builder.sqrt(index * HALF**2 + 8 * HALF**2)
    half = ((small + (4 * HALF) / p) + r) / 2
    deviation = p * half
    square = 1 / (deviation * deviation)
    derivatives = {"d_alpha": square / (p * r), "d_beta": square * (small / r + 1)}
    return {"alpha": r / half, "beta": p / half, **derivatives}, {"p": p, "twice_ratio": r}


def _damped(builder: GraphBuilder, e: Fraction) -> tuple[Mapping[str, Node], Names]:
    """e > 0: h, r and p times SCALE."""
    index = builder.symbol("tracking_index")
    p = builder.sqrt(index)
    small, twice = p * SCALE, p * (2 * SCALE)
    h = builder.sqrt((16 * SCALE**2) / index + index * (e * SCALE**2))
    total = small + h
    near = total if e == 1 else times(e, small) + h
    # the mean of both stands with 2 p under the root
    r = builder.sqrt(twice * total if e == 1 else small * (total + near))
    half = (total + r) / 2
    deviation = p * half
    square = (8 * SCALE**3) / ((deviation * deviation) * (p * h))
    ratio = twice / r
    # for e = 1 h + p is r^2/(2 p)
    d_alpha = square / ratio if e == 1 else square * (near / r)
    outputs = {"alpha": r / half, "beta": twice / half}
    outputs |= {"d_alpha": d_alpha, "d_beta": square * (ratio + 2)}
    return outputs, {"p": p, "h_at_once": h, "twice_ratio": r}
