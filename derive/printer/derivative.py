"""Derivatives of a map by its unknown, as sums of products of the graph's own nodes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

from gainproof.derive.printer.graph import GraphNode, operands


@dataclass(frozen=True)
class Term:
    """A coefficient times nodes, over nodes."""

    coefficient: Fraction
    above: tuple[int, ...] = ()
    below: tuple[int, ...] = ()


Sum = Sequence[Term]


def derivative(nodes: Sequence[GraphNode], number: int, known: Mapping[int, Sum]) -> Sum:
    """Of one sum, product, quotient or square root; those of its operands are known or 0."""
    node, parts = nodes[number], operands(nodes[number])
    match node[0]:
        case "add":
            return [term for part in parts for term in known.get(part, ())]
        case "mul":
            return [
                _times(term, [other for i, other in enumerate(parts) if i != which], nodes)
                for which, part in enumerate(parts)
                for term in known.get(part, ())
            ]
        case "div":
            return [
                Term(term.coefficient, term.above, (*term.below, parts[1]))
                for term in known[parts[0]]
            ]
    return [
        Term(term.coefficient / 2, term.above, (*term.below, number)) for term in known[parts[0]]
    ]


def over_one(terms: Sum) -> tuple[Sum, tuple[int, ...]]:
    """The terms without denominators, and the product of nodes that they are to be divided by."""
    below: list[int] = []
    for term in terms:
        below += _missing(term.below, below)
    return [
        Term(term.coefficient, (*term.above, *_missing(below, term.below))) for term in terms
    ], tuple(below)


def _missing(wanted: Sequence[int], present: Sequence[int]) -> list[int]:
    """What is wanted more often than it is present."""
    left, missing = list(present), []
    for factor in wanted:
        if factor in left:
            left.remove(factor)
        else:
            missing.append(factor)
    return missing


def _times(term: Term, factors: Sequence[int], nodes: Sequence[GraphNode]) -> Term:
    """Numbers join the coefficient, other nodes the product above the line."""
    coefficient, above = term.coefficient, list(term.above)
    for factor in factors:
        if nodes[factor][0] == "number":
            coefficient *= Fraction(str(nodes[factor][1]))
        else:
            above.append(factor)
    return Term(coefficient, tuple(above), term.below)
