"""The source's closed form (16) to (19), operation by operation as it is printed.

It is evaluated as anyone would who copies the paper: nothing is rearranged, so that it shows
where the printed form loses its digits. Numbers may be arrays of float64 or multiprecision
floats; the tests evaluate it with many digits and compare it with a Riccati solver, which shows
that it is copied rightly.

The symbol B of (17b) to (17e) is never defined in the source. The value taken here,
S^4 + A(S^2/3 - 1), is the one that the source's equations fix.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any


def printed_form(r: Any, s: Any, sqrt: Callable[[Any], Any]) -> Mapping[str, Any]:
    """The ten quantities by equation number, in units sigma_o = T = 1; ``sqrt`` of the numbers."""
    a = (4 / r) ** 2  # (14a)
    k = a * (s**2 + a / 4)  # (17g)
    c = a * k * (1 + s**2 / 6)  # (17h)
    b = s**4 + a * (s**2 / 3 - 1)
    p1 = b**2  # (17d)
    p2 = 2 * b * c - s**2 * k**2 * (s**2 - 4)  # (17e)
    p3 = c**2 - 4 * s**2 * k**3  # (17f)
    x = sqrt((-p2 + sqrt(p2**2 - 4 * p1 * p3)) / (2 * p1))  # (17a)
    q1 = b * x**2 + s**2 * k * x + c  # (17b)
    q2 = b * x**2 - s**2 * k * x + c  # (17c)
    k11 = (2 * k * s**4 * x - q2 * (a / 2 + x)) / (s**2 * q1)
    return {
        "16a": (2 * k * s**4 * x + q1 * (a / 2 - x)) / (s**2 * q2),
        "16b": q1 / (2 * k * s**2),
        "16c": x + a / 2,
        "18a": k11,
        "18b": q2 / (2 * k * s**4),
        "18c": q2 / (2 * k * s**2),
        "18d": (x - a / 2) / s**2,
        "19a": k11,
        "19b": q2 / (2 * k * s**2),
        "19c": x - a / 2,
    }
