"""Values at random for the free letters of a setting, such that hypotheses are likely to hold."""

from __future__ import annotations

import random
from collections.abc import Sequence

from flint import fmpq, fmpq_mat

from gainproof.verify.judge.matrices.exact_instance import Instance
from gainproof.verify.judge.matrices.letters import (
    DEFINITE,
    INVERTIBLE,
    SEMIDEFINITE,
    SYMMETRIC,
    Letter,
)
from gainproof.verify.judge.matrices.tree import Chain
from gainproof.verify.judge.matrices.used_definitions import is_block

SPECIAL = 0.5
"""How often such columns are tried, and how often they are not 0."""
RARE = 0.15
"""How often a letter without facts is 0, which refutes much that is said of all of them."""
SMALL = fmpq(1, 16)


def fill(instance: Instance, given: Sequence[Chain], source: random.Random) -> None:
    """Values for all free letters; those that a hypothesis names alone on a side come from it."""
    setting = instance.setting
    named = {s.name for chain in given for s in chain.sides if s.kind == "name"}
    for letter in setting.letters.values():
        if letter.definition is None and not letter.scalar and letter.name not in named:
            instance.values[letter.name] = _of_letter(letter, instance, source)
    later = [
        letter
        for letter in setting.letters.values()
        if letter.name in named and letter.definition is None and not letter.scalar
    ]
    while later:
        found = ((one, _from_hypothesis(one.name, instance, given, later, source)) for one in later)
        letter, value = next((pair for pair in found if pair[1] is not None), (later[0], None))
        if value is None:
            value = _of_letter(letter, instance, source)
        instance.values[letter.name] = value
        later.remove(letter)
    if source.random() < SPECIAL:
        _simple_values(instance, given, source)
    for chain in given:
        if chain.operators == ("=",):
            _clear_block(chain, instance)


def _simple_values(instance: Instance, given: Sequence[Chain], source: random.Random) -> None:
    """Columns that hypotheses speak of as unit vectors or 0, and square matrices in equations among
    them as one diagonal of 1 and -1, since e^T e = 1 and B C = C B are rare at random.
    """
    names = {part.name for chain in given for s in chain.sides for part in s.walk()}
    equations = [chain for chain in given if "=" in chain.operators]
    equated = {p.name for chain in equations for s in chain.sides for p in s.walk()}
    equated = equated if source.random() < SPECIAL else set()
    signs = [source.choice((1, -1)) for _ in range(5)]
    for name in sorted(names & set(instance.values)):
        value = instance.values[name]
        if value.ncols() == 1:
            column = fmpq_mat(value.nrows(), 1)
            if value.nrows() and source.random() < SPECIAL:
                column[source.randrange(value.nrows()), 0] = 1
            instance.values[name] = column
        elif name in equated and value.nrows() == value.ncols():
            diagonal = fmpq_mat(value.nrows(), value.nrows())
            for i in range(value.nrows()):
                diagonal[i, i] = signs[i % len(signs)]
            instance.values[name] = diagonal


def simplify(instance: Instance, source: random.Random) -> None:
    """Square matrices as unit matrices, their negatives, projections or 0, as facts allow: random
    ones rarely meet what makes a claim false, such as S Q = 1.
    """
    for name, value in instance.values.items():
        facts = instance.setting.letters[name].facts
        rows = value.nrows()
        if rows != value.ncols() or source.random() < SPECIAL:
            continue
        regular = DEFINITE in facts or INVERTIBLE in facts
        entries = [1] if regular else [0, 0, 1]
        if not facts or facts == (SYMMETRIC,):
            entries = [*entries, -1]
        same = source.choice(entries)
        simple = fmpq_mat(rows, rows)
        for i in range(rows):
            simple[i, i] = same if source.random() < SPECIAL else source.choice(entries)
        instance.values[name] = simple


def _of_letter(letter: Letter, instance: Instance, source: random.Random) -> fmpq_mat:
    rows, columns = instance.dimensions(letter.shape)
    if DEFINITE in letter.facts or SEMIDEFINITE in letter.facts:
        strict = DEFINITE in letter.facts
        width = rows if strict or INVERTIBLE in letter.facts else source.randint(0, rows)
        return gram(rows, width, strict, source) * source.choice((fmpq(1), fmpq(1), SMALL))
    if not letter.facts and source.random() < RARE:
        return fmpq_mat(rows, columns)
    found = _random(rows, columns, source)
    if SYMMETRIC in letter.facts:
        found = found + found.transpose()
    return found


def gram(rows: int, width: int, strict: bool, source: random.Random) -> fmpq_mat:
    """A positive semidefinite matrix of at most that rank, or where `strict` a definite one."""
    found = fmpq_mat(rows, rows)
    if width:
        root = _random(rows, width, source)
        found = root * root.transpose()
    for i in range(rows if strict else 0):
        found[i, i] += source.randint(1, 3)
    return found


def _random(rows: int, columns: int, source: random.Random) -> fmpq_mat:
    return fmpq_mat(rows, columns, [source.randint(-3, 3) for _ in range(rows * columns)])


def _from_hypothesis(
    name: str,
    instance: Instance,
    given: Sequence[Chain],
    later: Sequence[Letter],
    source: random.Random,
) -> fmpq_mat | None:
    """A value that makes the first comparison of the letter with known ones true."""
    waiting = {letter.name for letter in later if letter.name not in instance.values}
    for chain in given:
        pairs = zip(chain.sides, chain.operators, chain.sides[1:], strict=False)
        for left, operator, right in pairs:
            for own, other, above in ((left, right, ">"), (right, left, "<")):
                if own.kind != "name" or own.name != name:
                    continue
                if any(part.kind == "name" and part.name in waiting for part in other.walk()):
                    continue
                value = instance.with_values({}).of(other)
                if operator == "=":
                    return value
                size = value.nrows()
                strict = "=" not in operator
                gap = gram(size, source.randint(0, size), strict, source)
                if operator.startswith(above):
                    return value + gap
                return value - gap * SMALL  # so that it may be positive as well
    return None


def _clear_block(chain: Chain, instance: Instance) -> None:
    """V_ld = 0 for a block of a free letter: that block and its mirror image become 0."""
    for own, other in (chain.sides, chain.sides[::-1]):
        block = instance.setting.letters[own.name].definition if own.kind == "name" else None
        if other.kind != "zero" or block is None or not is_block(block):
            continue
        owner = block.parts[1].name
        if owner not in instance.values:
            continue
        value = fmpq_mat(instance.values[owner])
        rows = _picked(instance.of(block.parts[0].parts[0]))
        columns = _picked(instance.of(block.parts[2]))
        for i in rows:
            for j in columns:
                value[i, j] = 0
                if value.nrows() == value.ncols():
                    value[j, i] = 0
        instance.values[owner] = value


def _picked(columns: fmpq_mat) -> list[int]:
    return [i for i in range(columns.nrows()) for j in range(columns.ncols()) if columns[i, j] != 0]
