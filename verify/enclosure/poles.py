"""The poles of a filter whose gain is enclosed: eigenvalues of F - K H."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from math import inf, nextafter

import flint

from gainproof.verify.check_enclosure import Box
from gainproof.verify.enclosure.structure import Model, ball

BITS = 128
FINEST, COARSEST = 52, -1
"""Powers of 1/2 between which eigenvalues are tried as one cluster."""


@dataclass(frozen=True)
class Pole:
    """`count` eigenvalues lie within `radius` of `centre`, all inside of the unit circle; more than
    one where they cannot be told apart.
    """

    centre: complex
    radius: float
    count: int


Disc = tuple[flint.acb, flint.arb, int]
"""Centre, radius, and how many lie within."""


def poles(model: Model, enclosures: Mapping[str, Box], parts: Sequence[int]) -> tuple[Pole, ...]:
    """Enclosures of the poles, the largest first; `parts` says which states meet."""
    loop = model.f - enclosures["predictor"] @ model.h
    halves = [_half(row[i]) for i, row in enumerate(enclosures["predicted"].c)]
    with flint.ctx.workprec(BITS):
        found: list[Disc] = []
        for part in sorted(set(parts)):
            own = [i for i, x in enumerate(parts) if x == part]
            # in units of the deviations
            rows = [
                [ball(loop, i, j) * flint.arb(2) ** (halves[j] - halves[i]) for j in own]
                for i in own
            ]
            found += _discs(flint.arb_mat(rows))
        while pair := _meeting(found):
            found = [disc for disc in found if disc not in pair] + [_united(*pair)]
        made = [_pole(disc, found) for disc in found]
    return tuple(sorted(made, key=lambda pole: (-abs(pole.centre), -pole.centre.imag)))


def _half(x: Fraction) -> int:
    """The power of two next to a square root."""
    return (x.numerator.bit_length() - x.denominator.bit_length()) // 2 if x else 0


def _discs(loop: flint.arb_mat) -> list[Disc]:
    """Discs with the eigenvalues of all these matrices, which are stable."""
    try:
        values = flint.acb_mat(loop).eig(algorithm="rump")  # the other one fails more often
    except ValueError:
        return _clusters(loop)
    return [(z.mid(), (z - z.mid()).abs_upper(), 1) for z in values]


def _clusters(loop: flint.arb_mat) -> list[Disc]:
    """By Rouche: a disc holds k roots where of the polynomial moved to its centre the k-th term is
    the largest on the circle, larger than all others together.
    """
    polynomial = flint.acb_poly(loop.charpoly())
    values = [z.mid() for z in flint.acb_mat(loop.mid()).eig(algorithm="approx")]
    for k in range(FINEST, COARSEST, -1):
        near = flint.arb(2) ** -k
        groups: list[list[flint.acb]] = []
        for z in values:
            met = [own for own in groups if any(abs(z - o) < near for o in own)]
            groups = [own for own in groups if own not in met] + [[z, *(o for g in met for o in g)]]
        found = []
        for group in groups:
            centre = (sum(group, flint.acb(0)) / len(group)).mid()
            terms = [abs(c) for c in polynomial(flint.acb_poly([centre, 1])).coeffs()]
            radius = near + 2 * max((abs(z - centre).upper() for z in group), default=near)
            sizes = [(c * radius**i).upper() for i, c in enumerate(terms)]
            largest = (terms[len(group)] * radius ** len(group)).lower()
            if not sum(sizes, flint.arb(0)) - sizes[len(group)] < largest:
                break
            found.append((centre, radius.upper(), len(group)))
        apart = len(found) == len(groups) and not _meeting(found)
        if apart and all(radius < 1 for _, radius, _ in found):
            return found
    return [(flint.acb(0), flint.arb(1), loop.nrows())]


def _meeting(discs: Sequence[Disc]) -> tuple[Disc, Disc] | None:
    for a, b in combinations(discs, 2):
        if not abs(a[0] - b[0]) > a[1] + b[1]:
            return a, b
    return None


def _united(a: Disc, b: Disc) -> Disc:
    centre = ((a[0] + b[0]) / 2).mid()
    return centre, max(abs(c - centre).upper() + r for c, r, _ in (a, b)).upper(), a[2] + b[2]


def _pole(disc: Disc, all_discs: Sequence[Disc]) -> Pole:
    """The one eigenvalue of a disc is real where its conjugate, which is one too, can lie in no
    other.
    """
    centre, radius, count = disc
    turned = centre.conjugate(), radius, count
    others = [other for other in all_discs if other is not disc]
    real = count == 1 and not any(_meeting((turned, other)) for other in others)
    shown = complex(float(centre.real), 0.0 if real else float(centre.imag))
    if real:
        centre = flint.acb(centre.real)
    away = (abs(centre - flint.acb(shown.real, shown.imag)) + radius).upper()
    # upwards, where a double has few bits too: a radius of 0 says that the pole is exact
    radius_told = nextafter(float(away) * (1 + 2.0**-40), inf) if away > 0 else 0.0
    return Pole(shown, radius_told, count)
