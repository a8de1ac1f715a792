"""Signs of polynomials in v and w where 0 < v < w < sqrt(3).

With w = sqrt(3) / (1 + s) and v = w / (1 + t) the triangle becomes the set of all positive s and t.
A polynomial times its powers of 1 + s and 1 + t has coefficients x + y sqrt(3) there; if none is
negative and one is not zero, it is positive on the open triangle. Each sign is that of a number.
"""

from __future__ import annotations

from math import comb, lcm

from gainproof.verify.judge.exact.polynomial import Poly, fraction, terms

Surd = tuple[int, int]
"""x + y sqrt(3)."""


def sign_on_triangle(p: Poly, low: int, high: int) -> int | None:
    """1 or -1 where a polynomial in variables number `low` (v) and `high` (w) alone is shown to
    keep that sign on the open triangle; None where it is not.
    """
    signs = {_sign(value) for value in _moved(p, low, high).values()} - {0}
    return signs.pop() if len(signs) == 1 else None


def _moved(p: Poly, low: int, high: int) -> dict[tuple[int, int], Surd]:
    """Coefficients by powers of t and s, times one positive number that makes them whole."""
    known = [(int(e[low]), int(e[low] + e[high]), fraction(c)) for e, c in terms(p)]
    whole = lcm(*(c.denominator for _, _, c in known))
    entries = [(i, k, c.numerator * (whole // c.denominator)) for i, k, c in known]
    width = max((i for i, _, _ in entries), default=0)
    height = max((k for _, k, _ in entries), default=0)
    found: dict[tuple[int, int], list[int]] = {}
    for i, k, c in entries:
        value = c * 3 ** (k // 2)
        ways = [comb(height - k, b) for b in range(height - k + 1)]
        for a in range(width - i + 1):
            scaled = value * comb(width - i, a)
            for b, way in enumerate(ways):
                found.setdefault((a, b), [0, 0])[k % 2] += scaled * way
    return {key: (x, y) for key, (x, y) in found.items()}


def _sign(value: Surd) -> int:
    x, y = value
    if x * y >= 0:
        return (x + y > 0) - (x + y < 0)
    # of opposite signs: the greater square decides
    return (x > 0) - (x < 0) if x * x > 3 * y * y else (y > 0) - (y < 0)
