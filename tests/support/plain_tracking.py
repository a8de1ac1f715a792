"""Filters for one target in plain loops over numbers: what the arrays of tracks are held against.

Independent: textbook covariances (I - K H) P in nested lists, no array of tracks, steady gains from
running the recursion until it stands still, derivatives from differences of these. Measurements
come converted: the conversions have tests of their own.
"""

from __future__ import annotations

from collections.abc import Sequence

Matrix = list[list[float]]


def times(a: Matrix, b: Matrix) -> Matrix:
    return [
        [sum(a[i][k] * b[k][j] for k in range(len(b))) for j in range(len(b[0]))]
        for i in range(len(a))
    ]


def plus(a: Matrix, b: Matrix, sign: float = 1.0) -> Matrix:
    pairs = zip(a, b, strict=True)
    return [[x + sign * y for x, y in zip(r, s, strict=True)] for r, s in pairs]


def turned(a: Matrix) -> Matrix:
    return [list(column) for column in zip(*a, strict=True)]


def inverted(a: Matrix) -> Matrix:
    (p, q), (r, s) = a
    d = p * s - q * r
    return [[s / d, -q / d], [-r / d, p / d]]


H: Matrix = [[1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]
ONE: Matrix = [[float(i == j) for j in range(4)] for i in range(4)]


def kalman_track(
    times_of: Sequence[float], places: Sequence[Matrix], noises: Sequence[Matrix], sigma: float
) -> list[tuple[list[float], Matrix]]:
    """States (x, vx, y, vy) with covariances from the second measurement on; places are columns."""
    x, p = two_points(times_of[1] - times_of[0], places, noises, sigma)
    found = [(x, p)]
    for k in range(2, len(places)):
        t = times_of[k] - times_of[k - 1]
        f: Matrix = [[1, t, 0, 0], [0, 1, 0, 0], [0, 0, 1, t], [0, 0, 0, 1]]
        g: Matrix = [[t * t / 2, 0], [t, 0], [0, t * t / 2], [0, t]]
        state = times(f, [[value] for value in x])
        noise = [[sigma**2 * value for value in row] for row in times(g, turned(g))]
        p = plus(times(times(f, p), turned(f)), noise)
        s = plus(times(times(H, p), turned(H)), noises[k])
        gain = times(times(p, turned(H)), inverted(s))
        state = plus(state, times(gain, plus(places[k], times(H, state), -1)))
        p = times(plus(ONE, times(gain, H), -1), p)
        x = [row[0] for row in state]
        found.append((x, p))
    return found


def two_points(
    t: float, places: Sequence[Matrix], noises: Sequence[Matrix], sigma: float
) -> tuple[list[float], Matrix]:
    """The state is linear in both positions, and so its error in theirs: as a place on the line
    that ends in the present state the first one also misses t^2/2 times the acceleration.
    """
    state_of: Matrix = [[0, 0, 1, 0], [-1 / t, 0, 1 / t, 0], [0, 0, 0, 1], [0, -1 / t, 0, 1 / t]]
    missed = (sigma * t * t / 2) ** 2
    first = plus(noises[0], [[missed, 0.0], [0.0, missed]])
    both = [[*row, 0.0, 0.0] for row in first] + [[0.0, 0.0, *row] for row in noises[1]]
    x = times(state_of, [*places[0], *places[1]])
    return [row[0] for row in x], times(times(state_of, both), turned(state_of))


def steady_gains(index: float) -> tuple[float, float]:
    """alpha and beta by running the recursion with T = R = 1 until nothing changes."""
    p, q, r = 1.0, 0.5, 1.0
    strength = index * index
    last = (0.0, 0.0)
    for _ in range(200_000):
        p, q, r = p + 2 * q + r + strength / 4, q + r + strength / 2, r + strength
        s = p + 1
        gains = p / s, q / s
        p, q, r = p / s, q / s, r - q * q / s
        if all(abs(a - b) <= 1e-14 * abs(a) for a, b in zip(gains, last, strict=True)):
            return gains
        last = gains
    return last


def steady_slopes(index: float) -> tuple[float, float]:
    """Derivatives of both by central differences."""
    step = 1e-4 * index
    above, below = steady_gains(index + step), steady_gains(index - step)
    return (above[0] - below[0]) / (2 * step), (above[1] - below[1]) / (2 * step)


def line_gains(number: int) -> tuple[float, float]:
    """Of a line fitted to samples 0 to ``number``, at the last one, by normal equations."""
    n = number + 1
    mean = number / 2
    spread = sum((k - mean) ** 2 for k in range(n))
    slope = (number - mean) / spread
    return 1 / n + slope * (number - mean), slope


def fixed_gain_track(
    times_of: Sequence[float],
    places: Sequence[Matrix],
    gains: Sequence[tuple[tuple[float, float], tuple[float, float]]],
) -> list[list[float]]:
    """With (alpha, beta) of x and of y at every sample from the third on; least squares before."""
    t = times_of[1] - times_of[0]
    x = []
    for axis in (0, 1):
        x += [places[1][axis][0], (places[1][axis][0] - places[0][axis][0]) / t]
    found = [x]
    for k in range(2, len(places)):
        t = times_of[k] - times_of[k - 1]
        after = []
        for axis in (0, 1):
            alpha, beta = gains[k][axis]
            line = line_gains(k)
            if line[0] >= alpha:
                alpha, beta = line
            ahead = x[2 * axis] + t * x[2 * axis + 1]
            off = places[k][axis][0] - ahead
            after += [ahead + alpha * off, x[2 * axis + 1] + beta / t * off]
        x = after
        found.append(x)
    return found
