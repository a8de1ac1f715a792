"""Statements read: chains of relations, conditions, limits and one-sided arrows."""

from __future__ import annotations

from collections.abc import Mapping

from lark import Token

from gainproof.verify.judge.formula import (
    INFINITY,
    MINUS_INFINITY,
    Graph,
    Reading,
    Relation,
)
from gainproof.verify.judge.reader.decimals import decimals_shown
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.graph_building import build_graph
from gainproof.verify.judge.reader.syntax_tree import Branch, children, start, tokens
from gainproof.verify.judge.reader.vocabulary import Vocabulary


def read_statements(
    tree: Branch, text: str, extents: Mapping[int, int], vocabulary: Vocabulary, words: str | None
) -> Reading:
    """One reading of a whole formula; `words` name it where there are several."""
    reader = _Statements(text, extents, vocabulary)
    first, *rest = children(tree)
    relations = reader.relations(first)
    connectives = [child for child in tree.children if isinstance(child, Token)]
    connective = str(connectives[0]) if connectives else "if"
    below = reader.below
    reader.below = []
    conditions: list[Relation] = []
    for branch in rest:
        statements = branch if branch.data == "statements" else children(branch)[0]
        conditions += reader.conditions(statements)
    if (below or reader.below) and connective != "if":
        problem = "a limit on one side of a double arrow: write f \\to v (x \\to a)"
        raise ReaderError(problem, text, start(tree), "\\lim")
    return Reading(relations, (*below, *conditions), connective, words)


def read_relations(
    statements: Branch, text: str, extents: Mapping[int, int], vocabulary: Vocabulary
) -> tuple[Relation, ...]:
    """Relations that are conditions."""
    return tuple(_Statements(text, extents, vocabulary).conditions(statements))


class _Statements:
    """Reads relations; `below` collects what stands under `\\lim`."""

    def __init__(self, text: str, extents: Mapping[int, int], vocabulary: Vocabulary) -> None:
        self.text = text
        self.extents = extents
        self.vocabulary = vocabulary
        self.below: list[Relation] = []

    def relations(self, statements: Branch) -> tuple[Relation, ...]:
        """The relations claimed. ReaderError for a one-sided arrow, which only a condition has."""
        found: list[Relation] = []
        for chain in children(statements):
            found += self._chain(chain, is_condition=False)
        return tuple(found)

    def conditions(self, statements: Branch) -> list[Relation]:
        """Relations under which others are claimed."""
        found: list[Relation] = []
        for chain in children(statements):
            found += self._chain(chain, is_condition=True)
        return found

    def _chain(self, chain: Branch, is_condition: bool) -> list[Relation]:
        sides = children(chain)
        operators = [child for child in chain.children if isinstance(child, Token)]
        found: list[Relation] = []
        for number, operator in enumerate(operators):
            left, right = sides[number], sides[number + 1]
            shown = self.text[operator.start_pos or 0 : operator.end_pos]
            if shown == "\\equiv" and any(chain.find_data("modulo")):
                problem = "a congruence is not read: write that both remainders are equal"
                raise ReaderError(problem, self.text, operator.start_pos or 0, shown)
            self._refuse_infinity(left, operator, right)
            found.append(self._relation(left, operator, right))
            for side in (left, right):
                found += self._one_sided(side, operator, left, is_condition and side is right)
        return found

    def _relation(self, left: Branch, operator: Token, right: Branch) -> Relation:
        inner = children(left)[0], children(right)[0]
        limits = [side for side in inner if side.data == "limit"]
        if not limits:
            first, second = self._graph(left), self._graph(right)
            decimals = decimals_shown(inner[0], first), decimals_shown(inner[1], second)
            return Relation(str(operator), first, second, *decimals)
        if len(limits) > 1 or operator != "=":
            problem = "a limit must be said to equal something that is none"
            raise ReaderError(problem, self.text, start(limits[0]), "\\lim")
        (limit,) = limits
        other = right if inner[0] is limit else left
        chain, body = children(limit)
        conditions = self._chain(chain, is_condition=True)
        if [relation.operator for relation in conditions][:1] != ["->"] or len(children(chain)) > 2:
            problem = "under \\lim a symbol \\to value is wanted"
            raise ReaderError(problem, self.text, start(chain), "\\lim")
        if self.below and self.below != conditions:
            problem = "two limits in different variables: make two claims"
            raise ReaderError(problem, self.text, start(limit), "\\lim")
        self.below = conditions
        value = self._graph(other)
        shown = decimals_shown(children(other)[0], value)
        return Relation("->", self._built(body), value, None, shown)

    def _one_sided(
        self, side: Branch, operator: Token, left: Branch, allowed: bool
    ) -> list[Relation]:
        """`x \\to 0+` says x > 0 too."""
        marks = tokens(side, "ONE_SIDED")
        if not marks:
            return []
        if not allowed or operator != "->":
            problem = "a side from which may only be said behind the arrow of a condition"
            raise ReaderError(problem, self.text, marks[0].start_pos or 0, str(marks[0]))
        which = ">" if marks[0] == "+" else "<"
        first, second = self._graph(left), self._graph(side)
        decimals = (
            decimals_shown(children(left)[0], first),
            decimals_shown(children(side)[0], second),
        )
        return [Relation(which, first, second, *decimals)]

    def _refuse_infinity(self, left: Branch, operator: Token, right: Branch) -> None:
        left_kind, right_kind = children(left)[0].data, children(right)[0].data
        arrow = operator == "->" or (operator == "=" and left_kind == "limit")
        if left_kind == "infinity" or (right_kind == "infinity" and not arrow):
            problem = "\\infty may only stand alone on the right of an arrow"
            raise ReaderError(problem, self.text, operator.start_pos or 0, "\\infty")

    def _graph(self, side: Branch) -> Graph:
        inner = children(side)[0]
        if inner.data == "infinity":
            return MINUS_INFINITY if tokens(inner, "MINUS") else INFINITY
        return self._built(inner)

    def _built(self, tree: Branch) -> Graph:
        return build_graph(tree, self.text, self.extents, self.vocabulary)
