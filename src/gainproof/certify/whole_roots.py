"""Roots multiplied by integers, so that the relations that they obey have integer coefficients."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import lcm, prod

from gainproof.certify.expression import Tree
from gainproof.certify.goals import Tower


def multiples(tower: Tower) -> dict[str, int]:
    """For each root an integer by which it is multiplied, so that the relations are of integers."""
    scales: dict[str, int] = {}
    for relation in tower.relations:
        scales[relation.symbol] = _denominator(relation.radicand, scales)
    return scales


def _denominator(tree: Tree, scales: Mapping[str, int]) -> int:
    inner = [_denominator(part, scales) for part in tree.parts]
    match tree.operation:
        case "number":
            return tree.value.denominator
        case "symbol":
            return scales.get(tree.name, 1)
        case "add":
            return lcm(*inner)
        case "pow":
            return int(inner[0] ** tree.exponent)
    return prod(inner)


def expanded(tree: Tree) -> dict[tuple[tuple[str, int], ...], Fraction]:
    """A polynomial of names as terms."""
    match tree.operation:
        case "number":
            return {(): tree.value}
        case "symbol":
            return {((tree.name, 1),): Fraction(1)}
        case "add":
            pieces = [item for part in tree.parts for item in expanded(part).items()]
        case "pow":
            return expanded(Tree("mul", tree.parts * tree.exponent))
        case _:
            pieces = [((), Fraction(1))]
            for part in tree.parts:
                inner = expanded(part).items()
                pieces = [(_joined(a, b), x * y) for a, x in pieces for b, y in inner]
    result: dict[tuple[tuple[str, int], ...], Fraction] = {}
    for powers, value in pieces:
        result[powers] = result.get(powers, Fraction(0)) + value
    return result


def _joined(
    left: tuple[tuple[str, int], ...], right: tuple[tuple[str, int], ...]
) -> tuple[tuple[str, int], ...]:
    powers = dict(left)
    for name, power in right:
        powers[name] = powers.get(name, 0) + power
    return tuple(sorted(powers.items()))
