"""A reading as its printed sides and the signs between them; a chain shares its sides."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.formula import Decimals, Reading, Relation

MOST_NODES = 400


@dataclass(frozen=True)
class Link:
    """The sides with numbers `left` and `right`, the sign between them, the decimals that a side
    shows which is one number.
    """

    operator: str
    left: int
    right: int
    left_decimals: Decimals | None = None
    right_decimals: Decimals | None = None


@dataclass(frozen=True)
class Printed:
    """`links` are claimed where `conditions` hold; both join `sides`."""

    sides: tuple[Expr, ...]
    links: tuple[Link, ...]
    conditions: tuple[Link, ...] = ()
    connective: str = "if"

    def with_side(self, number: int, side: Expr) -> Printed:
        """Another side in one place."""
        return self.with_sides((*self.sides[:number], side, *self.sides[number + 1 :]))

    def with_sides(self, sides: tuple[Expr, ...]) -> Printed:
        """Other sides."""
        return Printed(sides, self.links, self.conditions, self.connective)

    def claimed(self) -> tuple[int, ...]:
        """Numbers of the sides that the claim itself is about."""
        return tuple(dict.fromkeys(n for link in self.links for n in (link.left, link.right)))

    def reading(self) -> Reading:
        """As the reader would hand it over."""

        def relations(links: Sequence[Link]) -> tuple[Relation, ...]:
            return tuple(
                Relation(
                    x.operator,
                    graph_of(self.sides[x.left]),
                    graph_of(self.sides[x.right]),
                    x.left_decimals,
                    x.right_decimals,
                )
                for x in links
            )

        return Reading(relations(self.links), relations(self.conditions), self.connective)


def printed(reading: Reading) -> Printed:
    """The sides of a reading. Raises Malformed for graphs the judge cannot read as scalars."""
    sides: list[Expr] = []

    def links(relations: Sequence[Relation]) -> tuple[Link, ...]:
        made: list[Link] = []
        before: Relation | None = None
        for relation in relations:
            if before is not None and before.right == relation.left:
                left = made[-1].right
            else:
                sides.append(read_graph(relation.left))
                left = len(sides) - 1
            sides.append(read_graph(relation.right))
            decimals = (relation.left_decimals, relation.right_decimals)
            made.append(Link(relation.operator, left, len(sides) - 1, *decimals))
            before = relation
        return tuple(made)

    return Printed(
        links=links(reading.relations),
        conditions=links(reading.conditions),
        sides=tuple(sides),
        connective=reading.connective,
    )
