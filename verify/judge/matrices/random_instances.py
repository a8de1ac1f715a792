"""Instances at random, in which all hypotheses are true: some by construction, all by test."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence

from gainproof.verify.judge.matrices.definite_values import (
    bad_direction,
    compared,
    is_symmetric,
)
from gainproof.verify.judge.matrices.exact_instance import Instance, NoValueError, Unsupported
from gainproof.verify.judge.matrices.hypothesis_solutions import solve
from gainproof.verify.judge.matrices.letters import (
    DEFINITE,
    INVERTIBLE,
    SEMIDEFINITE,
    SYMMETRIC,
    Letter,
    MatrixSetting,
)
from gainproof.verify.judge.matrices.random_values import fill, simplify
from gainproof.verify.judge.matrices.tree import REGULAR, Bound, Chain, Node

MOST_TRIES = 120
EMPTY = 4
"""In one of so many instances a step of sizes is 0."""
PATIENCE = 12
"""After so many, hypotheses of which no instance came up are solved; later ones always are."""
SIMPLE = 2
"""Where the first instances do not refute a claim, one of so many of the others is simple."""
STEPS = (1, 2, 3, 2, 1, 4, 6, 7, 8)
"""What the steps of sizes are tried with, small ones first; six unknowns want six equations."""


def holds(chain: Chain, instance: Instance) -> bool:
    """Whether a chain is true. Raises NoValueError."""
    values = [instance.of(side) for side in chain.sides]
    if chain.operators == (REGULAR,):
        return bool(values[0].det() != 0)
    return all(
        compared(left, operator, right)
        for left, operator, right in zip(values, chain.operators, values[1:], strict=False)
    )


def instances(
    setting: MatrixSetting,
    given: Sequence[Chain],
    invertible: Sequence[Node],
    bounds: Sequence[Bound] = (),
    seed: int = 1,
    tries: int = MOST_TRIES,
) -> Iterator[Instance]:
    """Instances that satisfy all facts of letters, the hypotheses and the bounds on sizes."""
    letters = list(setting.letters.values())
    doubtful = _touched(setting, given)
    source, found = random.Random(seed), 0
    for number in range(tries):
        base = STEPS[number % len(STEPS)]
        steps = {name: max(1, base + source.choice((-1, 0, 0, 1))) for name in setting.sizes.steps}
        if number % EMPTY == EMPTY - 1 and steps:
            steps[source.choice(list(steps))] = 0
        if not all(_within(bound, steps) for bound in bounds):
            continue
        try:
            instance = Instance(setting, steps)
            fill(instance, given, source)
            # values were changed while others were formed: nothing is kept of those
            instance = instance.with_values({})
            # with a source of its own: what is drawn otherwise does not depend on it
            other = random.Random(f"{seed} {number}")
            if seed > 1 and number % SIMPLE == 0:
                simplify(instance, other)
            if given and (seed > 1 or (not found and number >= PATIENCE)):
                solve(given, instance, other)
            instance = instance.with_values({})
            if (
                all(holds(chain, instance) for chain in given)
                and all(instance.of(node).det() != 0 for node in invertible)
                and all(_as_declared(letter, instance, doubtful) for letter in letters)
            ):
                found += 0 not in steps.values()
                yield instance
        except (NoValueError, Unsupported):
            continue


def _within(bound: Bound, steps: dict[str, int]) -> bool:
    left, right = bound.left.value(steps), bound.right.value(steps)
    return left < right if bound.strict else left <= right


def _touched(setting: MatrixSetting, given: Sequence[Chain]) -> set[str]:
    """Letters whose value a hypothesis may have given or changed, with owners of blocks."""
    found: set[str] = set()
    for chain in given:
        for side in chain.sides:
            for part in side.walk():
                if part.kind == "name":
                    found.add(part.name)
                    block = setting.letters[part.name].definition
                    found |= {p.name for p in block.walk()} if block is not None else set()
    return found


def _as_declared(letter: Letter, instance: Instance, doubtful: set[str]) -> bool:
    """What is said of a free letter is tested where a hypothesis may have given it its value;
    definite ones at random are made so.
    """
    made = DEFINITE in letter.facts or SEMIDEFINITE in letter.facts
    if letter.definition is not None or (
        letter.name not in doubtful and made and INVERTIBLE not in letter.facts
    ):
        return True
    value = instance.letter(letter.name)
    if letter.variance is not None:
        variance = instance.of(letter.variance)
        if not (is_symmetric(variance) and bad_direction(variance, False) is None):
            return False
    for fact in letter.facts:
        if fact == INVERTIBLE:
            if value.det() == 0:
                return False
        elif not is_symmetric(value) or (
            fact != SYMMETRIC and bad_direction(value, fact == DEFINITE) is not None
        ):
            return False
    return True
