"""The innovation spectrum of a model with one scalar measurement.

With d(z) = det(zI - F) and the noise of the state seen through H adj(zI - F), the spectrum of the
measurement times d(z) d(1/z) is N(z) = S c(z) c(1/z), where c is the closed-loop polynomial and S
the innovation variance.
"""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.setting.matrices import Numbers

Laurent = dict[int, Fraction]


def resolvent(f: Numbers) -> tuple[list[Fraction], list[Numbers]]:
    """d(z) = det(zI - F), and adj(zI - F) as matrices, both by powers of z from 0 up.

    Faddeev and LeVerrier: adj = sum of B_k z^k with B_(n-1) = I and B_(k-1) = F B_k + d_k I.
    """
    size = len(f)
    unit = _scaled_unit(size, Fraction(1))
    d = [Fraction(0)] * size + [Fraction(1)]
    parts: list[Numbers] = [unit] * size
    current = unit
    for k in range(size - 1, -1, -1):
        parts[k] = current
        moved = _times(f, current)
        d[k] = -sum((moved[i][i] for i in range(size)), Fraction(0)) / (size - k)
        current = _plus(moved, _scaled_unit(size, d[k]))
    return d, parts


def spectrum(f: Numbers, q: Numbers, h: Numbers, r: Fraction) -> tuple[Laurent, Laurent]:
    """N(z) as the part without noise of the state and the part that is multiplied by the index
    squared.
    """
    d, parts = resolvent(f)
    rest: Laurent = {}
    for i, x in enumerate(d):
        for j, y in enumerate(d):
            rest[i - j] = rest.get(i - j, Fraction(0)) + r * x * y
    rows = [_times(h, part)[0] for part in parts]
    noise: Laurent = {}
    for i, row in enumerate(rows):
        for j, column in enumerate(rows):
            value = sum(
                (x * q[a][b] * y for a, x in enumerate(row) for b, y in enumerate(column)),
                Fraction(0),
            )
            noise[i - j] = noise.get(i - j, Fraction(0)) + value
    return rest, noise


def at_point(laurent: Laurent, z: int) -> Fraction:
    """The value at z = 1 or z = -1."""
    return sum((value * z ** abs(k) for k, value in laurent.items()), Fraction(0))


def _times(a: Numbers, b: Numbers) -> Numbers:
    columns = list(zip(*b, strict=True))
    return tuple(
        tuple(sum((x * y for x, y in zip(row, c, strict=True)), Fraction(0)) for c in columns)
        for row in a
    )


def _plus(a: Numbers, b: Numbers) -> Numbers:
    return tuple(tuple(x + y for x, y in zip(p, q, strict=True)) for p, q in zip(a, b, strict=True))


def _scaled_unit(size: int, value: Fraction) -> Numbers:
    return tuple(tuple(value if i == j else Fraction(0) for j in range(size)) for i in range(size))
