"""Values for which hypotheses are true: of a letter in which a comparison is linear."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from contextlib import suppress
from itertools import product

from flint import fmpq_mat

from gainproof.verify.judge.matrices.definite_values import compared
from gainproof.verify.judge.matrices.exact_instance import Instance, NoValueError
from gainproof.verify.judge.matrices.letters import Letter
from gainproof.verify.judge.matrices.random_values import gram
from gainproof.verify.judge.matrices.statement_letters import SYMMETRIC_FACTS
from gainproof.verify.judge.matrices.tree import REGULAR, Chain

MOST_UNKNOWNS = 36
Gap = Callable[[fmpq_mat], fmpq_mat]


def solve(given: Sequence[Chain], instance: Instance, source: random.Random) -> None:
    """Make comparisons true that are not, each by the value of one letter. What was true before may
    be no more: all are tested afterwards.
    """
    for chain in given:
        if len(chain.operators) == 1 and chain.operators[0] != REGULAR:
            here = instance.with_values({})
            if not compared(here.of(chain.sides[0]), chain.operators[0], here.of(chain.sides[1])):
                _solve_one(chain, instance, source)


def _solve_one(chain: Chain, instance: Instance, source: random.Random) -> None:
    (left, right), (operator,) = chain.sides, chain.operators
    value = instance.with_values({}).of(left)
    wanted = fmpq_mat(value.nrows(), value.ncols())
    if operator != "=":
        size, strict = wanted.nrows(), "=" not in operator
        wanted = gram(size, source.randint(0, size), strict, source)
        wanted = -wanted if operator.startswith(">") else wanted
    names = {part.name for side in chain.sides for part in side.walk() if part.kind == "name"}
    letters = sorted(names & set(instance.values))
    source.shuffle(letters)
    for name in letters:
        before = instance.values[name]

        def gap(value: fmpq_mat, name: str = name) -> fmpq_mat:
            there = instance.with_values({name: value})
            return there.of(right) - there.of(left) - wanted

        basis = _basis(instance.setting.letters[name], before)
        found = _zero_of(gap, basis, before, source)
        if found is None:
            found = _simple_zero(gap, before, source)
        if found is not None:
            instance.values[name] = found
            return


def _simple_zero(gap: Gap, like: fmpq_mat, source: random.Random) -> fmpq_mat | None:
    """One of few simple matrices at which the gap is 0: of projections, permutations, and those Y
    with Y Y = 0.
    """
    rows, columns = like.nrows(), like.ncols()
    if rows != columns or not rows:
        return None
    places = [
        [(i, i) for i in source.sample(range(rows), source.randint(0, rows))],
        [(0, rows - 1)],
        [(i, (i + 1) % rows) for i in range(rows)],
    ]
    for some in places:
        value = fmpq_mat(rows, rows)
        for i, j in some:
            value[i, j] = 1
        with suppress(NoValueError):
            if not any(gap(value).entries()):
                return value
    return None


def _basis(letter: Letter, like: fmpq_mat) -> list[fmpq_mat]:
    """Matrices of whose multiples every value of the letter is a sum; none where they are many."""
    rows, columns = like.nrows(), like.ncols()
    symmetric = any(fact in SYMMETRIC_FACTS for fact in letter.facts)
    found: list[fmpq_mat] = []
    for i, j in product(range(rows), range(columns)):
        if symmetric and i > j:
            continue
        one = fmpq_mat(rows, columns)
        one[i, j] = 1
        if symmetric:
            one[j, i] = 1
        found.append(one)
    return found if len(found) <= MOST_UNKNOWNS else []


def _zero_of(
    gap: Gap, basis: Sequence[fmpq_mat], like: fmpq_mat, source: random.Random
) -> fmpq_mat | None:
    """A value at which the gap is 0, whatever is free in it as it was; None if there is none, or
    the gap is not linear.
    """
    if not basis:
        return None
    try:
        return _linear_zero(gap, basis, like, source)
    except NoValueError:
        return None


def _linear_zero(
    gap: Gap, basis: Sequence[fmpq_mat], like: fmpq_mat, source: random.Random
) -> fmpq_mat | None:
    start = _column(gap(like))
    changes = [entry for one in basis for entry in (_column(gap(like + one)) - start).entries()]
    steps = fmpq_mat(len(basis), start.nrows(), changes).transpose()
    weights = fmpq_mat(len(basis), 1, [source.choice((-1, 0, 1, 2)) for _ in basis])
    if _column(gap(_added(like, basis, weights))) != start + steps * weights:
        return None
    found = _solution(steps, -start)
    return None if found is None else _added(like, basis, found)


def _added(value: fmpq_mat, basis: Sequence[fmpq_mat], weights: fmpq_mat) -> fmpq_mat:
    for k, one in enumerate(basis):
        value = value + one * weights[k, 0]
    return value


def _column(value: fmpq_mat) -> fmpq_mat:
    return fmpq_mat(value.nrows() * value.ncols(), 1, value.entries())


def _solution(left: fmpq_mat, right: fmpq_mat) -> fmpq_mat | None:
    """x with left x = right; what is free is 0. None if there is none."""
    unknowns = left.ncols()
    both = fmpq_mat(1 + unknowns, right.nrows(), left.transpose().entries() + right.entries())
    form, rank = both.transpose().rref()
    found = fmpq_mat(unknowns, 1)
    for i in range(rank):
        lead = next(j for j in range(unknowns + 1) if form[i, j] != 0)
        if lead == unknowns:
            return None
        found[lead, 0] = form[i, unknowns]
    return found
