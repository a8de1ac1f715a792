"""The steady state of a Kalman-Bucy filter: dx/dt = A x + w, z = H x + v with white noises of
densities Q and R, one measurement.

The polynomial c of the poles of A - K H obeys c(s) c(-s) = d(s) d(-s) + N(s) Q N(-s)' / R, where d
is that of A and N(s) = H adj(sI - A). For one and two states its coefficients are square roots; for
three where the right side is c_0^2 - s^6 they are those of Butterworth's polynomial. With
h_k = H A^k the gain follows from c by Ackermann's formula, and the covariance from its products
P h_0' = K R and P h_k+1' = (R K K' - Q) h_k' - A P h_k'. None of this is trusted: that the Riccati
equation holds, that the filter is stable and that Q and R are densities is shown, for all values
of the symbols in their domains. A stabilising solution is unique (a textbook theorem, cited).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from itertools import combinations

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    number,
    power,
    sqrt,
    symbol,
    symbols_of,
)
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.formal_identities import decide_formally
from gainproof.verify.judge.exact.free_names import is_free, with_tokens
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.rational_system import lowest
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.meaning.square_matrices import determinant, inverse
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import (
    ANY_REAL,
    Environment,
    Fact,
    NotEstablished,
)
from gainproof.verify.judge.setting.matrices import Exprs, minus, plus, scaled, times, transposed
from gainproof.verify.judge.setting.own_matrices import not_symmetric, read_matrices
from gainproof.verify.judge.setting.stability_conditions import left_half_plane
from gainproof.verify.judge.setting.steady_state_conditions import UNIQUENESS, characteristic

ZERO, ONE = number(0), number(1)
MOST_STATES = 3
NONE = (
    "there is no steady state: A has {}, which no noise drives, so that the Riccati equation has "
    "no stabilising solution"
)
UNSOLVED = (
    "a Kalman-Bucy filter with {} states: covered are up to two, and three integrators in a row of "
    "which the last is driven"
)
METHOD = "tower of radicals, domains of the symbols"


@dataclass(frozen=True)
class Domain:
    """What the source says of the symbols of its model."""

    said: tuple[Rel, ...]

    def holds(self, *relations: Rel, given: Sequence[Rel] = ()) -> bool:
        """Whether these are proved wherever the symbols lie."""
        statement = Statement(relations, (*self.said, *given))
        boxes = {name: Box() for name in statement.symbols()}
        try:
            return settle(statement, boxes, None, {}, only_proof=True).verdict == "proved"
        except Undecided:
            return False

    def equal(self, left: Expr, right: Expr) -> bool:
        """Whether sides that have a value wherever the symbols lie are proved to be equal there:
        mostly by the relations of their roots alone, which is the quicker way.
        """
        statement = Statement((Rel("=", left, right),))
        anywhere = dict.fromkeys(statement.symbols(), ANY_REAL)
        try:
            return decide_formally(statement, anywhere, {}).verdict == "proved"
        except Undecided:
            return self.holds(*statement.relations)

    def require(self, expr: Expr, operator: str, what: str) -> None:
        """Raises Undecided unless it compares so with 0."""
        if not self.holds(Rel(operator, expr, ZERO)):
            told = labelled(expr, with_tokens({}, symbols_of(expr)))
            why = "has to follow from the domains of its symbols"
            why = "is false" if constant_value(expr) is not None else why
            raise Undecided(f"{what}: {told} {operator} 0 {why}")


def kalman_bucy(setting: Setting) -> Environment:
    """The established steady state; base variables are the free symbols. Raises Undecided,
    NotEstablished.
    """
    scope, (a, q, h, r) = read_matrices(setting)
    names = symbols_of(*[x for m in (a, q, h, r) for row in m for x in row])
    if not all(is_free(symbol(name)) for name in names):
        raise Undecided("the matrices of a Kalman-Bucy filter hold free symbols and numbers alone")
    if len(r) != 1:
        raise Undecided(f"a Kalman-Bucy filter with {len(r)} measurements is not covered")
    a, q, h = (tuple(map(tuple, rows)) for rows in (a, q, h))
    said = _said(scope)
    gain, covariance, facts = _solved(a, q, h, r[0][0], tuple(sorted(names)), Domain(said))
    quantities = {f"continuous_gain.{i + 1}": row[0] for i, row in enumerate(gain)}
    quantities |= {
        f"covariance.{i + 1}.{j + 1}": covariance[max(i, j)][min(i, j)]
        for i in range(len(gain))
        for j in range(len(gain))
    }
    return Environment("a Kalman-Bucy filter", quantities, facts=facts, rests=said)


def _said(scope: Scope) -> tuple[Rel, ...]:
    """What the source says of the symbols of the matrices, and of those that it says it with."""
    found: dict[str, tuple[Rel, ...]] = {}
    while pending := [token for token in scope.used if token not in found]:
        for token in pending:
            found[token] = tuple(map(scope.relation, scope.setting.symbols[token].domain))
    return tuple(rel for relations in found.values() for rel in relations)


def _solved(
    a: Exprs, q: Exprs, h: Exprs, r: Expr, names: tuple[str, ...], domain: Domain
) -> tuple[Exprs, Exprs, tuple[Fact, ...]]:
    """Gain, covariance and what was shown of them."""
    size = len(a)
    if size > MOST_STATES:
        raise Undecided(UNSOLVED.format(size))
    domain.require(r, ">", "the density of the measurement noise has to be positive")
    _require_density(q, domain)
    observed = [h]
    while len(observed) < size:
        observed.append(times(observed[-1], a))
    seen = tuple(row[0] for row in observed)
    unseen = determinant(seen)
    if lowest(unseen, names) == ZERO:
        raise Undecided(
            "the state is not observable: the measurement tells nothing of a part of it, which is "
            "not covered"
        )
    domain.require(unseen, "!=", "the state has to be observable")
    before = characteristic(a)
    spectrum = _spectrum(observed, q, r, [*before, ONE], names)
    coefficients, roots = _poles(spectrum, names, domain)
    turned = inverse(seen)
    assert isinstance(turned, tuple), "the inverse of a matrix"
    # Ackermann: (c(A) - d(A)) times the last column, as d(A) = 0
    column: Exprs = tuple((row[-1],) for row in turned)
    gain: Exprs = tuple((ZERO,) for _ in a)
    for c, d in zip(coefficients, before, strict=True):
        gain = plus(gain, scaled(column, c - d))
        column = times(a, column)
    gain = _lowest(gain, (*names, *roots))
    driven = minus(scaled(times(gain, transposed(gain)), r), q)
    products = [scaled(gain, r)]
    for row in observed[:-1]:
        products.append(minus(times(driven, transposed(row)), times(a, products[-1])))
    whole: Exprs = tuple(tuple(p[i][0] for p in products) for i in range(size))
    covariance = _lowest(times(whole, transposed(turned)), (*names, *roots))
    residual = minus(plus(times(a, covariance), times(covariance, transposed(a))), driven)
    other = [
        *minus(times(covariance, transposed(h)), scaled(gain, r)),
        *minus(covariance, transposed(covariance)),
    ]
    loop = characteristic(minus(a, times(gain, h)))
    relations = [Rel("=", x, ZERO) for row in (*residual, *other) for x in row]
    relations += [Rel("=", x, c) for x, c in zip(loop, coefficients, strict=True)]
    for rel in relations:
        # they divide by the density r and the determinant alone, which are not 0 on the domains
        if not domain.equal(substituted(rel.left, roots), substituted(rel.right, roots)):
            raise NotEstablished("the Riccati equation does not hold identically")
    stable = left_half_plane([*(substituted(c, roots) for c in coefficients), ONE])
    if not domain.holds(*stable):
        raise NotEstablished("the filter is not shown to be stable")
    facts = (
        Fact("A P + P A' + Q = R K K', P H' = R K and P = P' hold identically", METHOD),
        Fact("A - K H is stable (Hurwitz), so that P is a covariance", METHOD),
        Fact(f"cited: {UNIQUENESS[0]}", UNIQUENESS[1]),
    )
    return _put_in(gain, roots), _put_in(covariance, roots), facts


def _put_in(matrix: Exprs, values: dict[str, Expr]) -> Exprs:
    return tuple(tuple(substituted(x, values) for x in row) for row in matrix)


def _lowest(matrix: Exprs, names: Sequence[str]) -> Exprs:
    return tuple(tuple(lowest(x, names) for x in row) for row in matrix)


def _require_density(q: Exprs, domain: Domain) -> None:
    """Raises Undecided where the noise is not shown to be symmetric and nowhere negative."""
    for i, j in combinations(range(len(q)), 2):
        if q[i][j] != q[j][i]:
            raise not_symmetric(i, j)
    for count in range(1, len(q) + 1):
        for chosen in combinations(range(len(q)), count):
            minor = determinant(tuple(tuple(q[i][j] for j in chosen) for i in chosen))
            domain.require(minor, ">=", "the process noise has to have a density")


def _spectrum(
    rows: Sequence[Exprs], q: Exprs, r: Expr, d: Sequence[Expr], names: tuple[str, ...]
) -> list[Expr]:
    """The coefficients of s^0, s^2, ... in d(s) d(-s) + N(s) Q N(-s)' / R, but for the last; the
    rows are H A^k.
    """
    size = len(rows)
    # N by powers of s: N_k = d_k+1 H + d_k+2 H A + ...
    n = [reduce(plus, map(scaled, rows, d[k + 1 :])) for k in range(size)]
    found = []
    for m in range(size):
        terms = [ZERO]
        for k in range(max(0, 2 * m - size), min(size, 2 * m) + 1):
            other = 2 * m - k
            part = d[k] * d[other]
            if max(k, other) < size:
                part = part + times(times(n[k], q), transposed(n[other]))[0][0] / r
            terms.append(number((-1) ** k) * part)
        found.append(lowest(add(*terms), names))
    return found


def _poles(
    spectrum: Sequence[Expr], names: tuple[str, ...], domain: Domain
) -> tuple[list[Expr], dict[str, Expr]]:
    """The coefficients of c over roots, and what these are. Raises Undecided."""
    size, first = len(spectrum), spectrum[0]
    if first == ZERO:
        raise Undecided(NONE.format("the eigenvalue 0"))
    domain.require(first, ">", "noise has to drive an eigenvalue 0 of A")
    low, high = symbol("c 0"), symbol("c 1")
    if size == 1:
        return [low], {low.name: sqrt(first)}
    if size == 2:
        linear = lowest(-spectrum[1], names)
        if not domain.holds(Rel(">=", linear, ZERO)):
            # x^2 + linear x + first, the spectrum at -s^2 = x >= 0, is to be positive all the same
            rest = lowest(4 * first - power(linear, 2), names)
            if rest == ZERO:
                raise Undecided(NONE.format("imaginary eigenvalues"))
            if not domain.holds(Rel(">", rest, ZERO), given=(Rel("<", linear, ZERO),)):
                domain.require(rest, ">", "noise has to drive imaginary eigenvalues of A")
        root = sqrt(first)
        return [low, high], {low.name: root, high.name: sqrt(add(2 * root, linear))}
    if size == MOST_STATES and spectrum[1] == spectrum[2] == ZERO:
        bandwidth = power(first, Fraction(1, 6))
        return [power(low, 3), 2 * power(low, 2), 2 * low], {low.name: bandwidth}
    raise Undecided(UNSOLVED.format(size))
