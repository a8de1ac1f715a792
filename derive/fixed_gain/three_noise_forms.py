"""What process noises of three states add to covariances, in the order in which it is printed.

D = A D A' + Q over the coordinates x, y, d, m of a stable filter and n = 1 + x + y + d, for a Q of
noise ratio 1. The four noises differ by a few numbers only. All terms are positive before the
update; after it x and d change their sign, and n becomes (1 - alpha) n. The forms take anything
with + - * /: SymPy's symbols, where they are proved, and the nodes of graphs.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from typing import Any, NamedTuple


class Noise(NamedTuple):
    """A noise: its numbers, entry 33 of Q being 1."""

    a: int
    b: int
    c: int
    f: int
    h: int
    size: int

    @property
    def after(self) -> Fraction:
        """What is taken from the last entry after the update, which takes 1 from it in all."""
        return 1 - Fraction(16 * self.h, self.size)


INCREMENTS = Noise(1, 1, 0, 0, 4, 64)
ACCELERATION = INCREMENTS._replace(h=0)
JERK = Noise(9, 6, 1, 9, 18, 576)
WHITE_JERK = Noise(15, 15, 2, 10, 30, 960)


@dataclass(frozen=True)
class Place:
    """w x, w y, w d, w (1 + y), w (1 + x + y) and w n, and w^2 m, of any w above 0."""

    w: Any
    x: Any
    y: Any
    d: Any
    m: Any
    more: Any
    total: Any
    n: Any

    def over_w(self, value: Any) -> Any:
        """Left alone where w is 1."""
        return value if self.w is ONE else value / self.w

    def times_w(self, value: Any) -> Any:
        return value if self.w is ONE else value * self.w


ONE = 1


@dataclass(frozen=True)
class After:
    """w (x - 1), which is positive for alpha below 1, and w (1 - alpha) n.

    `one` is 1, of graphs as a sum: a difference from a number has no terms to be measured by.
    """

    less: Any
    n: Any
    one: Any


def predicted(noise: Noise, at: Place) -> dict[str, Any]:
    """The entries before the update, row by row."""
    e, r, v = _parts(noise, at)
    k, size = _with(e, r, at.times_w), at.x + at.w
    second = at.over_w(e * at.total)
    first = at.over_w(k) * (at.n / at.m) * at.n / noise.size
    cross = second
    others = at.d * (at.d * noise.a + at.x * noise.b)
    if r is not None:
        cross = cross + (at.times_w(noise.c) + r * size)
        others = others + (size * size * (r + noise.c) + at.times_w(at.more) * noise.c)
    square = second * at.total + others
    last, beside = v / at.m, at.over_w(at.x * noise.a)
    wide = at.over_w(size) * last + beside
    whole = last + beside
    return {
        "11": first,
        "12": cross * 2 * (at.n / at.m) / noise.size,
        "13": (k / at.m + at.over_w(noise.a)) * at.n * 4 / noise.size,
        "22": square * 4 / at.m / noise.size,
        "23": _plus(wide, noise.f) * 8 / noise.size,
        "33": _plus(whole, noise.h) * 16 / noise.size,
    }


def updated(noise: Noise, at: Place, after: After) -> dict[str, tuple[Any, Any]]:
    """The entries after it, each as a sum of positive terms and what is taken from it."""
    e, r, v = _parts(noise, at)
    k, size = _with(e, r, at.times_w), after.less
    first = at.over_w(k) * (after.n / at.m) * after.n / noise.size
    weight, share = at.over_w(e), after.n / at.m * 2 / noise.size
    plus, minus = weight * at.more, weight * at.x
    others = at.d * (at.d * noise.a + at.x * noise.b)
    if r is not None:
        plus, minus = plus + at.times_w(noise.c), minus + r * size
        others = others + (size * size * (r + noise.c) + at.times_w(at.more) * noise.c)
    # (1 + y - x)^2 is (1 + y + x)^2 less 4 (1 + y) x
    wide = weight * at.total * at.total + others
    part = 4 / at.m / noise.size
    last, beside = v / at.m, at.over_w(at.x * noise.a)
    return {
        "11": (first, None),
        "12": (plus * share, minus * share),
        "13": (
            at.over_w(noise.a) * after.n * 4 / noise.size,
            k / at.m * after.n * 4 / noise.size,
        ),
        "22": (wide * part, weight * at.more * at.x * 4 * part),
        "23": (
            _plus(at.over_w(size) * last, noise.f) * 8 / noise.size,
            beside * 8 / noise.size,
        ),
        "33": ((last + beside) * 16 / noise.size, after.one * noise.after),
    }


def _parts(noise: Noise, at: Place) -> tuple[Any, Any, Any]:
    """w (a y + b), c x/d (None where c is 0) and w^2 ((1 + y)(a y + b) + c + c x/d)."""
    if not noise.c:
        return at.more, None, at.more * at.more
    e, r = at.y * noise.a + at.times_w(noise.b), at.x * noise.c / at.d
    return e, r, at.more * e + at.times_w(at.times_w(r + noise.c))


def _with(e: Any, r: Any, times_w: Any) -> Any:
    return e if r is None else e + times_w(r)


def _plus(value: Any, number: int) -> Any:
    return value + number if number else value
