"""What a model's zeros and exact relations say of its steady state, in rational linear algebra.

A combination L x of the states is *told* where L x(k+1) = Lambda L x(k) + M y(k) without any noise:
its error changes by Lambda alone. All of them form one largest subspace, whose Lambda has the zeros
of the model as eigenvalues. What decays is known without an error in the steady state, an
eigenvalue on the unit circle leaves no stable filter, and one beyond it is turned round.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import flint

from gainproof.verify.check_enclosure import Box

MOST_BITS = 1 << 16
"""Precision for the places of roots, beyond which whether they lie on the circle is not asked."""


class NoSteadyState(ValueError):
    """There is no stabilising steady state, or none was found; the message says why."""


@dataclass(frozen=True)
class Model:
    """x+ = F x + w, y = H x + v, with the covariances Q of w, R of v and S of w with v; `names` are
    those of the states and of the measurements.
    """

    f: Box
    h: Box
    q: Box
    r: Box
    s: Box
    names: tuple[tuple[str, ...], tuple[str, ...]]

    @property
    def is_exact(self) -> bool:
        """Whether all numbers are known exactly."""
        return all(box.r is None for box in (self.f, self.h, self.q, self.r, self.s))


@dataclass(frozen=True)
class Relations:
    """`rows` times the states is `values` times the measurements; rows are reduced, with ones at
    the `pivots`.
    """

    rows: flint.fmpq_mat
    values: flint.fmpq_mat
    pivots: tuple[int, ...]


def exact(box: Box) -> flint.fmpq_mat:
    """The centre as a matrix of python-flint."""
    rows = [[flint.fmpq(x.numerator, x.denominator) for x in row] for row in box.c]
    return flint.fmpq_mat(rows)


def ball(box: Box, i: int, j: int) -> flint.arb:
    """All values of an entry, at the precision that is set."""
    c, r = (flint.fmpq(x.numerator, x.denominator) for x in (box.c[i][j], box.radius[i][j]))
    return flint.arb(c) + flint.arb(0, flint.arb(r).abs_upper())


def fraction_of(x: flint.arb) -> Fraction:
    """The value of a ball without a radius."""
    man, exp = x.man_exp()
    return Fraction(int(man)) * Fraction(2) ** int(exp)


def bits_of(x: flint.arb) -> int:
    """The least power of two above all of a ball, 0 of 0. Fractions of far ones fill any memory."""
    man, exp = x.abs_upper().man_exp()
    return int(exp) + int(man).bit_length() if man else 0


def rounded(x: flint.arb, least: int) -> tuple[Fraction, Fraction]:
    """Centre and radius of a ball, both 0 below 2^least, by which the radius is then more."""
    parts = x.mid(), x.rad()
    near = [fraction_of(part) if bits_of(part) > least else Fraction(0) for part in parts]
    lost = sum(1 for part, kept in zip(parts, near, strict=True) if part != 0 and not kept)
    return near[0], near[1] + (lost * Fraction(2) ** least if lost else 0)


Rows = Sequence[Sequence[flint.fmpq]]


def reduced(rows: Rows, values: Rows, n: int, m: int) -> Relations:
    """The relations of these rows, which must be independent, over n states and m measurements."""
    table = _matrix([[*row, *value] for row, value in zip(rows, values, strict=True)], n + m)
    found = table.rref()[0].tolist() if rows else []
    pivots = tuple(next(j for j, x in enumerate(row) if x) for row in found)
    return Relations(_matrix([r[:n] for r in found], n), _matrix([r[n:] for r in found], m), pivots)


def kernel(a: flint.fmpq_mat) -> flint.fmpq_mat:
    """Rows that span all x with a x = 0, reduced."""
    reduced, rank = a.rref()
    table, n = reduced.tolist(), a.ncols()
    pivots = [next(j for j, x in enumerate(row) if x) for row in table[:rank]]
    free = [j for j in range(n) if j not in pivots]
    found = []
    for j in free:
        x = [flint.fmpq(int(i == j)) for i in range(n)]
        for row, pivot in zip(table, pivots, strict=False):
            x[pivot] = -row[j]
        found.append(x)
    return _matrix(found, n).rref()[0] if found else _matrix([], n)


def require_seen(model: Model) -> None:
    """Raises NoSteadyState for a mode that does not decay and that no measurement sees."""
    f, block = exact(model.f), exact(model.h)
    blocks = [[block]]
    for _ in range(f.nrows() - 1):
        block = block * f
        blocks.append([block])
    unseen = kernel(_joined(blocks))
    if not unseen.nrows():
        return
    pivots = [next(j for j, x in enumerate(row) if x) for row in unseen.tolist()]
    moved = (unseen * f.transpose()).tolist()
    action = flint.fmpq_mat([[row[j] for j in pivots] for row in moved])
    for factor, _, roots in modes(action):
        bad = [z for where, z in roots if where >= 0]
        if bad:
            modal = (kernel(at(factor, action).transpose()) * unseen).tolist()
            raise NoSteadyState(
                f"not seen: no measurement sees the mode with the eigenvalue {_shown(bad[0])}, in "
                f"{_among(modal, model.names[0])}, which does not decay"
            )


def told(model: Model) -> Relations:
    """The combinations of states that are known without an error in the steady state, as relations
    L x+ = Lambda L x + M y with `values` M. Raises NoSteadyState where an eigenvalue of the largest
    Lambda lies on the unit circle, or the innovations have no definite covariance.
    """
    f, h, q, r, s = (exact(x) for x in (model.f, model.h, model.q, model.r, model.s))
    n, m = f.nrows(), h.nrows()
    rows = _unit(n)
    while True:
        system = _joined(
            [[q, s, f], [-s.transpose(), -r, -h], [flint.fmpq_mat(rows.nrows(), n + m), -rows]]
        )
        found = kernel(system.transpose()).tolist()
        own = [row for row in found if any(row[:n])]
        if len(own) == rows.nrows():
            break
        rows = _matrix([row[:n] for row in own], n)
    spare = [row[n : n + m] for row in found if not any(row[:n])]
    if spare:
        raise NoSteadyState(
            f"the innovation of {_among(spare[:1], model.names[1])} has no variance: what is "
            "measured there without noise is known already, so that its gain is not determined; "
            "leave it out"
        )
    if not own:
        return reduced([], [], n, m)
    action = _matrix([row[n + m :] for row in own], len(own))
    values = _matrix([row[n : n + m] for row in own], m)
    decaying = _unit(len(own))
    for factor, times, roots in modes(action):
        still = [z for where, z in roots if where == 0]
        if still:
            modal = (kernel(at(factor, action).transpose()) * rows).tolist()
            raise NoSteadyState(
                f"not driven: no noise reaches the mode with the eigenvalue {_shown(still[0])}, in "
                f"{_among(modal, model.names[0])}, which neither grows nor decays: its gain falls "
                "to 0 and its error never ends; give it process noise, or leave it out"
            )
        if all(where < 0 for where, _ in roots):
            for _ in range(times):
                decaying = decaying * at(factor, action)
    known = kernel(decaying.transpose())
    return reduced((known * rows).tolist(), (known * values).tolist(), n, m)


def modes(a: flint.fmpq_mat) -> Iterator[tuple[flint.fmpz_poly, int, list[tuple[int, flint.acb]]]]:
    """The factors of the characteristic polynomial over the rationals, how often each occurs, and
    their roots with -1 inside of the unit circle, 0 on it, 1 outside.
    """
    for factor, times in a.charpoly().numer().factor()[1]:
        yield factor, times, _placed(factor)


def _placed(factor: flint.fmpz_poly) -> list[tuple[int, flint.acb]]:
    """An irreducible polynomial with a root on the circle has the inverse of each root as a root:
    a root that is told from all others and whose inverse conjugate is not lies on it.
    """
    c = [int(x) for x in factor.coeffs()]
    turned = c in (c[::-1], [-x for x in c[::-1]])
    bits = 64
    while bits <= MOST_BITS:
        with flint.ctx.workprec(bits):
            pairs: Any = factor.complex_roots()
            roots = [z for z, _ in pairs]
            found: list[tuple[int, flint.acb]] = []
            for z in roots:
                size = abs(z)
                if size < 1 or size > 1:
                    found.append((-1 if size < 1 else 1, z))
                elif turned and not any(
                    o is not z and o.overlaps(1 / z.conjugate()) for o in roots
                ):
                    found.append((0, z))
            if len(found) == len(roots):
                return found
        bits *= 2
    raise NoSteadyState("an eigenvalue is too near to the unit circle to be told from it")


def at(polynomial: flint.fmpz_poly, a: flint.fmpq_mat) -> flint.fmpq_mat:
    """The polynomial of a matrix."""
    unit = _unit(a.nrows())
    total = unit * 0
    for c in reversed(polynomial.coeffs()):
        total = total * a + unit * flint.fmpq(c)
    return total


def _among(rows: Rows, names: Sequence[str]) -> str:
    """The names at which a row is not 0."""
    found = [name for j, name in enumerate(names) if any(row[j] for row in rows)]
    return found[0] if len(found) == 1 else f"{', '.join(found[:-1])} and {found[-1]}"


def _shown(z: flint.acb) -> str:
    real, imaginary = float(z.real.mid()), float(z.imag.mid())
    if z.imag.contains(0):
        return f"{real:.6g}"
    return f"{real:.6g} {'+' if imaginary > 0 else '-'} {abs(imaginary):.6g}i"


def _joined(blocks: Sequence[Sequence[flint.fmpq_mat]]) -> flint.fmpq_mat:
    rows = []
    for parts in blocks:
        lists = [part.tolist() for part in parts]
        rows += [[x for own in row for x in own] for row in zip(*lists, strict=True)]
    return flint.fmpq_mat(rows)


def _unit(n: int) -> flint.fmpq_mat:
    return flint.fmpq_mat([[int(i == j) for j in range(n)] for i in range(n)])


def _matrix(rows: Sequence[Sequence[flint.fmpq]], columns: int) -> flint.fmpq_mat:
    return flint.fmpq_mat(rows) if rows else flint.fmpq_mat(0, columns)
