"""The stabilising steady state of a model in numbers, with the certificate that encloses it.

Parts of the model that do not meet are solved apart; what is known without an error is split off.
The rest is found by doubling in long floats (Anderson, 1978): from a start P0 the map Z -> Ric(P0 +
Z) - P0 is a Riccati map again, whose measurement noise H P0 H' + R is definite and not correlated.
So singular R and correlated noises need nothing of their own, and from a start near the end it is a
Newton step. X and Y are the solution plus and minus a small multiple of what the closed loop makes
of noise in all states, rounded to decimals. Nothing rests on floats: the checker decides.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, log10
from typing import Any

import flint

from gainproof.verify.check_enclosure import FORMAT, Box, decide
from gainproof.verify.enclosure.structure import (
    Model,
    NoSteadyState,
    Relations,
    ball,
    exact,
    fraction_of,
    kernel,
    reduced,
    require_seen,
    told,
)

ASKED = 54
"""Half widths are at most 2^-54 of the deviations that belong to an entry."""
LEAST_BITS, MOST_BITS, MOST_BITS_OF_BOXES = 192, 1 << 12, 1 << 10
MOST_DOUBLINGS, MOST_TRIES = 400, 12
GUARD = 10
"""Bits by which roundings are below what has to be told from 0."""
Grid = list[list[Fraction]]


@dataclass(frozen=True)
class Found:
    """The certificate, as the checker reads it, and what it encloses: the covariances `predicted`
    and `updated`, the gains `filter` and `predictor`.
    """

    certificate: Mapping[str, Any]
    enclosures: Mapping[str, Box]


class _TooFew(ArithmeticError):
    """More bits are needed, or there is nothing to be found."""


def steady(model: Model, asked: int = ASKED) -> Found:
    """The steady state within 2^-`asked` of sqrt(P_ii P_jj) for covariances, for the filter gain of
    sqrt(P_ii/(H P H' + R)_jj), for that of the predictor with F P F' in place of P.

    Raises NoSteadyState, with the reason, where there is none or none was found.
    """
    states, measured = _labels(model)
    n, m = len(states), len(measured)
    shapes = {"upper": (n, n), "slack": (n, n), "predictor": (n, m), "filter": (n, m)}
    grids = {name: [["0"] * b for _ in range(a)] for name, (a, b) in shapes.items()}
    grids["floor"] = [["0"] * m]
    for label in sorted({*states, *measured}):
        i, j = ([k for k, x in enumerate(own) if x == label] for own in (states, measured))
        found = _part(_cut(model, i, j), asked)
        if len(i) == n and len(j) == m:
            return found
        places = {"upper": (i, i), "slack": (i, i), "floor": ([0], j)}
        for name, grid in grids.items():
            rows, columns = places.get(name, (i, j))
            for a, row in zip(rows, found.certificate[name], strict=False):
                for b, x in zip(columns, row, strict=False):
                    grid[a][b] = x
    data = _stated(model, [states, measured]) | grids
    return Found(data, decide(data))


def _labels(model: Model) -> tuple[list[int], list[int]]:
    """Of states and of measurements the part to which each belongs."""
    n, m = len(model.f.c), len(model.h.c)
    found = list(range(n + m))
    places = ((model.f, 0, 0), (model.q, 0, 0), (model.h, n, 0), (model.r, n, n), (model.s, 0, n))
    for box, top, left in places:
        for i, row in enumerate(box.most, top):
            for j in (j for j, x in enumerate(row, left) if x):
                found = [found[i] if x == found[j] else x for x in found]
    return found[:n], found[n:]


def _cut(model: Model, states: list[int], measured: list[int]) -> Model:
    """A part of the model; one without measurements has one of noise alone."""

    def cut(box: Box, rows: list[int], columns: list[int]) -> Box:
        c, r = ([[grid[i][j] for j in columns] for i in rows] for grid in (box.c, box.radius))
        return Box(c, r)

    names = [model.names[0][i] for i in states], [model.names[1][j] for j in measured]
    f, q = (cut(box, states, states) for box in (model.f, model.q))
    if not measured:
        none = [[Fraction(0)] for _ in states]
        h, r, s = Box([[Fraction(0)] * len(states)]), Box([[Fraction(1)]]), Box(none)
        return Model(f, h, q, r, s, (tuple(names[0]), ("",)))
    h, r = cut(model.h, measured, states), cut(model.r, measured, measured)
    return Model(f, h, q, r, cut(model.s, states, measured), (tuple(names[0]), tuple(names[1])))


def _stated(model: Model, labels: Sequence[Sequence[int]]) -> dict[str, Any]:
    """What a certificate says of the model."""
    boxes = {"F": model.f, "H": model.h, "Q": model.q, "R": model.r, "S": model.s}
    data: dict[str, Any] = {"format": FORMAT, "parts": [list(own) for own in labels]}
    for name, box in boxes.items():
        rows = zip(box.c, box.radius, strict=True)
        pairs = [zip(*row, strict=True) for row in rows]
        data[name] = [[[_text(x), _text(e)] if e else _text(x) for x, e in row] for row in pairs]
    return data


def _text(x: Fraction) -> str:
    """A decimal where it is one that is not long, else a fraction."""
    below, fives, twos = x.denominator, 0, 0
    while below % 10 == 0:
        below, fives, twos = below // 10, fives + 1, twos + 1
    while below % 5 == 0:
        below, fives = below // 5, fives + 1
    while below % 2 == 0:
        below, twos = below // 2, twos + 1
    places = max(fives, twos)
    if below > 1 or not 0 < places < 1000:
        return str(x)
    return f"{x.numerator * 10**places // x.denominator}e-{places}"


def _part(model: Model, asked: int) -> Found:
    """Of a part whose states and measurements all meet; of one without states the floor alone."""
    if not model.f.c:
        if not model.is_exact or kernel(exact(model.r)).nrows():
            own = ", ".join(model.names[1])
            raise NoSteadyState(f"{own}: no state is seen there, and the noise is not definite")
        floor = [_text(x) for x in _floor(_balls(model.r))]
        return Found(
            {"upper": [], "slack": [], "predictor": [], "filter": [], "floor": [floor]}, {}
        )
    # of a box the centre is asked: what it lacks cannot be shown of the others
    require_seen(model)
    known = told(model)
    if not model.is_exact:
        known = _never_driven(model)
    most = MOST_BITS if model.is_exact else MOST_BITS_OF_BOXES
    bits = LEAST_BITS
    while bits <= most:
        with flint.ctx.workprec(bits):
            try:
                return _certified(model, known, asked)
            except (_TooFew, ZeroDivisionError):
                bits *= 2
    raise NoSteadyState(
        f"none was found with {most} bits: a mode is seen by no measurement or driven by no noise, "
        "or nearly so, or numbers lie too far apart"
    )


def _never_driven(model: Model) -> Relations:
    """States that no noise and no other state reaches, where they decay."""
    n, m = len(model.f.c), len(model.h.c)
    inner = [i for i in range(n) if not any(model.q.most[i]) and not any(model.s.most[i])]
    while any(x and j not in inner for i in inner for j, x in enumerate(model.f.most[i])):
        inner = [
            i for i in inner if all(j in inner or not x for j, x in enumerate(model.f.most[i]))
        ]
    none = Relations(flint.fmpq_mat(0, n), flint.fmpq_mat(0, m), ())
    if not inner:
        return none
    power = flint.arb_mat([[ball(model.f, i, j) for j in inner] for i in inner])
    for _ in range(MOST_DOUBLINGS):
        if all(sum((abs(x) for x in row), flint.arb(0)) < 1 for row in power.tolist()):
            rows = [[int(i == j) for j in range(n)] for i in inner]
            return Relations(flint.fmpq_mat(rows), flint.fmpq_mat(len(inner), m), tuple(inner))
        power = power * power
    return none


def _certified(model: Model, known: Relations, asked: int) -> Found:
    """A certificate that was decided. Raises _TooFew."""
    n = len(model.f.c)
    free = [i for i in range(n) if i not in known.pivots]
    back = _back(known, free)
    f, h, q, r, s = (_balls(box) for box in (model.f, model.h, model.q, model.r, model.s))
    p = flint.arb_mat(n, n)
    if free:
        b = _balls(back)
        inner = _steady(_rows(f, free) * b, h * b, _picked(q, free, free), r, _rows(s, free))
        p = _even(b * inner * b.transpose())
    seen = p * h.transpose()
    sigma = (h * seen + r).mid()
    inverse = sigma.inv().mid()
    predictor, gain = (f * seen + s) * inverse, seen * inverse
    loop = (f - predictor * h).mid()
    margin, in_units = _margins(loop, h, p, sigma)
    below = _summed(loop, margin)
    if free:
        above = _summed(_rows(loop, free) * b, [margin[i] for i in free])
    floor, noiseless = _floor(sigma), _noiseless(model, known)
    guard = GUARD + n.bit_length() + 2 * max([0, *(_log2(x) for x in in_units.entries() if x != 0)])
    k = asked + 2 + _lost(f, h, gain, loop, p, sigma, below, floor)
    for _ in range(MOST_TRIES):
        small = flint.arb(2) ** -k
        grid = [[(_log2(x) + _log2(y)) / 2 - k - guard for y in margin] for x in margin]
        upper = Box([[Fraction(0)] * n for _ in range(n)])
        if free:
            x = _rounded(inner + small * above, [[grid[i][j] for j in free] for i in free])
            upper = back @ Box(x) @ back.turned()
        slack = upper - Box(_rounded(p - small * below, grid))
        gains = _grid_of_gains(p, sigma, f, q, k)
        grids = {"upper": upper.c, "slack": slack.c}
        grids["predictor"] = _with_rows(_rounded(predictor, gains), known)
        grids["filter"] = _with_rows(_rounded(gain, gains), noiseless)
        data = _stated(model, [[0] * n, [0] * len(model.h.c)])
        data |= {name: [[_text(x) for x in row] for row in grid] for name, grid in grids.items()}
        data["floor"] = [[_text(x) for x in floor]]
        try:
            found = decide(data)
        except ValueError:
            k += 16
            continue
        lacking = _lacking(model, found, sigma, asked)
        if lacking <= 0:
            return Found(data, found)
        k += lacking + 1
    raise _TooFew


def _lost(
    f: Any, h: Any, gain: Any, loop: Any, p: Any, sigma: Any, below: Any, floor: list[Fraction]
) -> int:
    """By how many bits enclosures are wider than what is put between X and Y, about."""
    n, m = range(p.nrows()), range(sigma.nrows())
    least = [flint.arb(_fmpq(x)) for x in floor]
    seen = h * below * h.transpose()
    share = sum((seen[j, j] / least[j] for j in m), flint.arb(0))
    share = 4 * share * max(sigma[j, j] / least[j] for j in m)
    found = [_log2(below[i, i]) - _log2(p[i, i]) for i in n if p[i, i] > 0]
    unit = flint.arb_mat([[int(i == j) for j in n] for i in n])
    for keep, size in ((unit - gain * h, p), (loop, f * p * f.transpose())):
        wide = keep * below * keep.transpose()
        ratios = [share * wide[i, i] / size[i, i] for i in n if size[i, i] > 0]
        found += [_log2(x) // 2 for x in ratios if x > 0]
    return max(found, default=0)


def _back(known: Relations, free: Sequence[int]) -> Box:
    """The states over those that are free, where L x = 0."""
    n = known.rows.ncols()
    rows = [[Fraction(int(i == j)) for j in free] for i in range(n)]
    for i, own in zip(known.pivots, known.rows.tolist(), strict=True):
        rows[i] = [-_fraction(own[j]) for j in free]
    return Box(rows)


def _steady(f: Any, h: Any, q: Any, r: Any, s: Any) -> Any:
    """The limit of the Riccati map from a definite start, found again from near to it."""
    n = f.nrows()
    if not n:
        return f
    largest = [max((abs(x) for x in a.entries()), default=flint.arb(0)) for a in (q, r, h)]
    size = largest[0] + (largest[1] / largest[2] ** 2 if largest[2] > 0 else 0)
    unit = flint.arb_mat([[int(i == j) for j in range(n)] for i in range(n)])
    start = unit * (size if size > 0 else flint.arb(1))
    for _ in range(2):
        start = _doubled(f, h, q, r, s, start.mid(), unit)
    return start


def _doubled(f: Any, h: Any, q: Any, r: Any, s: Any, start: Any, unit: Any) -> Any:
    sigma = (h * start * h.transpose() + r).mid()
    inverse = sigma.inv().mid()
    gain = ((f * start * h.transpose() + s) * inverse).mid()
    a = (f - gain * h).transpose().mid()
    g = _even(h.transpose() * inverse * h)
    c = _even(f * start * f.transpose() + q - gain * sigma * gain.transpose() - start)
    near = flint.arb(2) ** -(flint.ctx.prec // 2)
    last = False
    for _ in range(MOST_DOUBLINGS):
        w = (unit + g * c).inv().mid()
        step = _even(a.transpose() * c * w * a)
        g, a, c = _even(g + a * w * g * a.transpose()), (a * w * a).mid(), (c + step).mid()
        p = start + c
        if last:
            return _even(p)
        last = all(abs(step[i, i]) <= near * abs(p[i, i]) for i in range(f.nrows()))
    raise _TooFew


def _summed(loop: Any, margin: Sequence[Any]) -> Any:
    """The sum of A^k D A'^k for a diagonal D."""
    n = len(margin)
    total = flint.arb_mat([[margin[i] if i == j else 0 for j in range(n)] for i in range(n)])
    for _ in range(MOST_DOUBLINGS):
        step = _even(loop * total * loop.transpose())
        total = (total + step).mid()
        if all(step[i, i] <= total[i, i] * flint.arb(2) ** -40 for i in range(n)):
            return total
        loop = (loop * loop).mid()
    raise _TooFew


def _margins(loop: Any, h: Any, p: Any, sigma: Any) -> tuple[list[Any], Any]:
    """What the inequalities are to hold by, on the diagonal: as much as P; where that is 0, so much
    that no other state and no innovation takes much of it. And the loop in these units.
    """
    n = loop.nrows()
    margin = [p[i, i] for i in range(n)]
    still = [i for i in range(n) if not margin[i] > 0]
    if still:
        of = _summed(loop, [flint.arb(int(i in still)) for i in range(n)])
        at = (h * of * h.transpose()).mid()
        ratios = [p[i, i] / of[i, i] for i in range(n) if i not in still and of[i, i] > 0]
        ratios += [sigma[j, j] / at[j, j] for j in range(h.nrows()) if at[j, j] > 0]
        small = min(ratios, default=flint.arb(1)).mid()
        margin = [small if i in still else x for i, x in enumerate(margin)]
    scaled = [
        [x * (margin[j] / margin[i]).sqrt() for j, x in enumerate(row)]
        for i, row in enumerate(loop.tolist())
    ]
    return margin, flint.arb_mat(scaled)


def _noiseless(model: Model, known: Relations) -> Relations:
    """What is told of the updated state without an error, by the filter gain J: L J = 0, and
    N H J = N where N R = 0.
    """
    n, m = len(model.f.c), len(model.h.c)
    if model.is_exact:
        quiet = kernel(exact(model.r))
    else:
        unit = [[int(i == j) for j in range(m)] for i in range(m)]
        still = [j for j in range(m) if not any(model.r.most[j]) and not any(model.h.radius[j])]
        quiet = flint.fmpq_mat([unit[j] for j in still]) if still else flint.fmpq_mat(0, m)
    rows = [*(quiet * exact(Box(model.h.c))).tolist(), *known.rows.tolist()]
    values = [*quiet.tolist(), *([flint.fmpq(0)] * m for _ in known.pivots)]
    return reduced(rows, values, n, m)


def _with_rows(gain: Grid, known: Relations) -> Grid:
    """A gain that satisfies L K = M: the rows at the pivots come from the others."""
    found = [list(row) for row in gain]
    rows, values = known.rows.tolist(), known.values.tolist()
    for i, own, value in zip(known.pivots, rows, values, strict=True):
        for j, x in enumerate(value):
            others = (_fraction(c) * gain[k][j] for k, c in enumerate(own) if k != i and c)
            found[i][j] = _fraction(x) - sum(others, Fraction(0))
    return found


def _grid_of_gains(p: Any, sigma: Any, f: Any, q: Any, bits: int) -> list[list[float]]:
    """Roundings of gains to so many bits, and some more, of the deviations that belong to them."""
    moved = f * p * f.transpose() + q
    grid = []
    for i in range(p.nrows()):
        sizes = [_log2(x) for x in (p[i, i], moved[i, i]) if x > 0]
        across = [_log2(sigma[j, j]) for j in range(sigma.nrows())]
        grid.append([(min(sizes, default=0) - x) / 2 - bits - GUARD for x in across])
    return grid


def _floor(sigma: Any) -> list[Fraction]:
    """Numbers d with sigma > diag(d), since a matrix is at most its size times its diagonal."""
    inverse, m = sigma.inv(), sigma.nrows()
    share = [1 / (inverse[j, j] * (m + flint.arb(2) ** -10)) for j in range(m)]
    return _rounded(flint.arb_mat([share]), [[_log2(x) - 20 for x in share]])[0]


def _lacking(model: Model, found: Mapping[str, Box], sigma: Any, asked: int) -> int:
    """Bits by which the widest enclosure is wider than asked, 0 or below where none is."""
    p = found["predicted"]
    least = [max(p.c[i][i] - p.radius[i][i], Fraction(0)) for i in range(len(p.c))]
    moved = (model.f @ Box(p.c) @ model.f.turned()).c
    driven = [row[i] or model.q.c[i][i] for i, row in enumerate(moved)]
    across = [fraction_of(sigma[j, j].mid()) for j in range(sigma.nrows())]
    sizes = {
        "predicted": [[a * b for b in least] for a in least],
        "updated": [[a * b for b in least] for a in least],
        "filter": [[a / b for b in across] for a in least],
        "predictor": [[a / b for b in across] for a in driven],
    }
    lacking = -1
    for name, wanted in sizes.items():
        for row, own in zip(found[name].radius, wanted, strict=True):
            for e, w in zip(row, own, strict=True):
                if e:
                    lacking = max(lacking, 64 if not w else ceil(_log2_of(e * e / w) / 2) + asked)
    return lacking


def _log2_of(x: Fraction) -> int:
    """Of a positive number, rounded up."""
    return x.numerator.bit_length() - x.denominator.bit_length() + 1


def _log2(x: Any) -> int:
    """Of a positive float, rounded up."""
    man, exp = x.mid().man_exp()
    return int(exp) + int(abs(man)).bit_length()


def _balls(box: Box) -> Any:
    """Floats next to the centre."""
    return flint.arb_mat([[flint.arb(_fmpq(x)).mid() for x in row] for row in box.c])


def _even(a: Any) -> Any:
    return ((a + a.transpose()) * flint.arb(0.5)).mid()


def _rows(a: Any, rows: Sequence[int]) -> Any:
    return _picked(a, rows, range(a.ncols()))


def _picked(a: Any, rows: Sequence[int], columns: Sequence[int]) -> Any:
    if not rows:
        return flint.arb_mat(0, len(columns))
    return flint.arb_mat([[a[i, j] for j in columns] for i in rows])


def _rounded(a: Any, grid: Sequence[Sequence[float]]) -> Grid:
    """To the nearest multiples of powers of ten that are at most 2^grid."""
    found = []
    for row, powers in zip(a.tolist(), grid, strict=True):
        places = [ceil(-power * log10(2)) for power in powers]
        scales = [Fraction(10) ** k for k in places]
        found.append(
            [round(fraction_of(x.mid()) * c) / c for x, c in zip(row, scales, strict=True)]
        )
    return found


def _fmpq(x: Fraction) -> flint.fmpq:
    return flint.fmpq(x.numerator, x.denominator)


def _fraction(x: flint.fmpq) -> Fraction:
    return Fraction(int(x.p), int(x.q))
