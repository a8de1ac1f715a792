"""Divisors for which the evidence gives another form: found by numbers, proved by tools."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import isclose, prod

from gainproof.certify.expression import Tree, number
from gainproof.certify.goals import Goal, Tower


def divisors(goal: Goal) -> list[Tree]:
    """Every divisor of the goal once, inner ones first."""
    found: dict[int, Tree] = {}
    for side in (goal.left, goal.right):
        for tree in side.nodes():
            if tree.operation == "div" or tree.exponent < 0:
                found[id(tree.parts[-1])] = tree.parts[-1]
    return list(found.values())


def known_forms(goal: Goal, tower: Tower) -> Iterator[tuple[Tree, Tree, Tree]]:
    """Divisors as they are, with those inside them replaced, and their forms; in order of use."""
    if not goal.nonzero:
        return
    values = point(tower)
    listed = [(form, evaluated(form, values, {})) for form in goal.nonzero]
    forms: dict[int, Tree] = {}
    numbers: dict[int, float] = {}
    for divisor in divisors(goal):
        if divisor.symbols() & set(goal.free):
            continue
        value = evaluated(divisor, values, numbers)
        for form, size in listed:
            if isclose(abs(value), size, rel_tol=1e-9):
                new = form if value > 0 else number(-1) * form
                yield divisor, replaced(divisor, forms), new
                forms[id(divisor)] = new
                break


def point(tower: Tower) -> dict[str, float]:
    """A point of the tower: parameters as they come, roots and elements by their meaning."""
    values = {
        name: float(tower.shifted.get(name, 0)) + 0.7 + 0.31 * place
        for place, name in enumerate(tower.parameters)
    }
    values |= {relation.symbol: 1.0 for relation in tower.relations}
    for _ in range(100):  # two coupled roots settle
        for relation in tower.relations:
            radicand = evaluated(relation.radicand, values, {})
            values[relation.symbol] = radicand ** (1 / relation.power)
    return values | {name: evaluated(value, values, {}) for name, value in tower.elements.items()}


def evaluated(tree: Tree, values: Mapping[str, float], known: dict[int, float]) -> float:
    """The value at a point; those known by the tree's id are not formed again."""
    for node in tree.nodes():
        if id(node) not in known:
            known[id(node)] = _value(node, [known[id(part)] for part in node.parts], values)
    return known[id(tree)]


def _value(tree: Tree, parts: list[float], values: Mapping[str, float]) -> float:
    match tree.operation:
        case "number":
            return float(tree.value)
        case "symbol":
            return values[tree.name]
        case "add":
            return sum(parts)
        case "mul":
            return prod(parts)
        case "div":
            return parts[0] / parts[1]
    return float(parts[0] ** tree.exponent)


def replaced(tree: Tree, forms: Mapping[int, Tree]) -> Tree:
    """The tree with others in place of some of its parts, by their ids."""
    if id(tree) in forms:
        return forms[id(tree)]
    parts = tuple(replaced(part, forms) for part in tree.parts)
    same = all(new is old for new, old in zip(parts, tree.parts, strict=True))
    return tree if same else replace(tree, parts=parts)
