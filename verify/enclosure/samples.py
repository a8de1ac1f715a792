"""Covariances and gains sample by sample from a start, in ball arithmetic: all are enclosed.

Nothing is looked for, so that there is no certificate: the recursion is carried out, with as many
bits as the half widths ask for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import flint

from gainproof.verify.check_enclosure import Box
from gainproof.verify.enclosure.steady import ASKED
from gainproof.verify.enclosure.structure import Model, ball, bits_of, rounded

LEAST_BITS, MOST_BITS = 512, 1 << 14
ZERO_BITS = 300
"""A variance of so many bits less than the largest may be 0, of which balls cannot tell."""
Balls = dict[str, Any]


class NoGain(ValueError):
    """The gain of a sample is not determined, or not told; the message says which."""


def gains_by_sample(model: Model, start: Box, count: int) -> tuple[Mapping[str, Box], ...]:
    """Of each of the first samples the enclosures of the covariances `predicted` and `updated` and
    of the gains `filter` and `predictor`, with the half widths of `steady`; `start` is the
    covariance of the prediction of the first one.

    Raises NoGain where innovations have no definite covariance, or the bits do not suffice.
    """
    bits = LEAST_BITS
    while bits <= MOST_BITS:
        with flint.ctx.workprec(bits):
            found = list(_run(model, start, count))
            if len(found) == count:
                return tuple({name: _box(x) for name, x in each.items()} for each in found)
        bits *= 2
    raise NoGain(
        f"sample {len(found) + 1}: with {MOST_BITS} bits its innovation is not told from one "
        "without variance, or its gain is not told to the digits asked"
    )


def _run(model: Model, start: Box, count: int) -> Iterator[Balls]:
    """Each sample, as long as the balls are narrow enough."""
    f, h, q, r, s = (_balls(box) for box in (model.f, model.h, model.q, model.r, model.s))
    p = _balls(start)
    for _ in range(count):
        seen = p * h.transpose()
        sigma = _even(h * seen + r)
        try:
            inverse = sigma.inv()
        except ZeroDivisionError:
            return
        gain, cross = seen * inverse, f * seen + s
        predictor = cross * inverse
        updated = _even(p - gain * seen.transpose())
        found = {"predicted": p, "updated": updated, "filter": gain, "predictor": predictor}
        moved = f * p * f.transpose()
        sizes = moved + q if any(map(any, model.s.most)) else moved
        if not _narrow(found, p, sizes, sigma):
            return
        yield found
        p = _even(moved + q - predictor * cross.transpose())


def _narrow(found: Balls, p: Any, moved: Any, sigma: Any) -> bool:
    """Whether half widths are at most 2^-54 of the deviations that belong to the entries."""
    n, m = range(p.nrows()), range(sigma.nrows())
    zero = max(abs(x).upper() for x in p.entries()) * flint.arb(2) ** -ZERO_BITS
    of, driven = ([max(a[i, i].lower(), zero) for i in n] for a in (p, moved))
    across = [1 / sigma[j, j] for j in m]
    sizes = {"predicted": (of, of), "updated": (of, of), "filter": (of, across)}
    sizes["predictor"] = driven, across
    share = flint.arb(2) ** (-2 * ASKED)
    return all(
        x.is_exact() or x.rad() ** 2 < share * a * b
        for name, (rows, columns) in sizes.items()
        for row, a in zip(found[name].tolist(), rows, strict=True)
        for x, b in zip(row, columns, strict=True)
    )


def _even(a: Any) -> Any:
    """A symmetric matrix from balls round it, of which either side will do."""
    n = range(a.nrows())
    return flint.arb_mat([[a[max(i, j), min(i, j)] for j in n] for i in n])


def _balls(box: Box) -> Any:
    return flint.arb_mat(
        [[ball(box, i, j) for j in range(len(row))] for i, row in enumerate(box.c)]
    )


def _box(a: Any) -> Box:
    """Rational centres and radii."""
    if any(bits_of(x) > MOST_BITS for x in a.entries()):
        raise NoGain("a number of a sample is beyond float64: scale the units")
    rows = [[rounded(x, -MOST_BITS) for x in row] for row in a.tolist()]
    return Box([[c for c, _ in row] for row in rows], [[e for _, e in row] for row in rows])
