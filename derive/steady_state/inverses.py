"""From one gain back to the index and to the other gain, in positive forms.

Differences here are between exact inputs and exact constants only. With
R(alpha) = sqrt(4 (1 - alpha) + e alpha^2) and W(beta) = sqrt(beta (8 + e beta)):
beta = 2 alpha^2/((2 - alpha) + R), Lambda = beta/sqrt(1 - alpha),
alpha = beta (8 - (1 - e) beta)/(2 (W + beta)),
1 - alpha = (4 - 4 beta + (1 - e) beta^2)/(2 (2 + beta + W)), whose numerator is
(1 - e)(b - beta)(b' - beta) with b = 2/(1 + sqrt(e)) and b' = 2/(1 - sqrt(e)).
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from gainproof.derive.steady_state.gain_kernels import times

Root = Callable[[Any], Any]
SCALE = 2**30  # kernels hold 2^30 W, so that subnormal gains lose nothing


def alpha_radical(alpha: Any, e: Fraction, root: Root) -> Any:
    """R(alpha)."""
    four = 4 * (1 - alpha)
    return root(four if e == 0 else four + times(e, alpha * alpha))


def beta_radical(beta: Any, e: Fraction, root: Root, scale: int = 1) -> Any:
    """W(beta) times the scale."""
    scaled = beta if scale == 1 else beta * scale**2
    return root(scaled * 8 if e == 0 else scaled * (8 + times(e, beta)))


def beta_from_alpha(alpha: Any, radical: Any) -> Any:
    """The velocity gain that belongs to a position gain."""
    return (2 * (alpha * alpha)) / ((2 - alpha) + radical)


def index_from_alpha(alpha: Any, radical: Any, root_of_rest: Any) -> Any:
    """Lambda, with the root of 1 - alpha."""
    return beta_from_alpha(alpha, radical) / root_of_rest


def alpha_from_beta(beta: Any, e: Fraction, radical: Any, scale: int = 1) -> Any:
    """The position gain that belongs to a velocity gain; `radical` is W times the scale."""
    c, scaled = 1 - e, beta if scale == 1 else beta * scale**2
    top = scaled * 8 if c == 0 else scaled * times(c, 8 / c - beta)
    return top / ((radical + (beta if scale == 1 else beta * scale)) * (2 * scale))


def rest_from_beta(beta: Any, e: Fraction, radical: Any, root_e: Any) -> Any:
    """1 - alpha; `root_e` is sqrt(e), a constant."""
    if e == 1:
        top = 4 * (1 - beta)
    elif e == 0:
        top = (2 - beta) * (2 - beta)
    else:
        c = 1 - e
        top = times(c, ((2 - 2 * root_e) / c - beta) * ((2 + 2 * root_e) / c - beta))
    return top / (2 * ((2 + beta) + radical))
