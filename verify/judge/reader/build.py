"""From syntax trees to expression graphs: one graph for each choice of readings."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from lark import Token, Tree

from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.reader.constant import constant_value
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.limits import MOST_EXPONENT
from gainproof.verify.judge.reader.nodes import NodeList
from gainproof.verify.judge.reader.slash import factors_under, product_parts, refuse_open_slash

Branch = Tree[Token]


def build_graph(tree: Branch, text: str, extents: Mapping[int, int]) -> Graph:
    """The graph of one expression. `extents` maps the position of each ambiguous slash to the
    number of factors it divides by.
    """
    builder = _Builder(text, extents)
    return builder.nodes.graph(builder.value(tree))


def children(tree: Branch) -> list[Branch]:
    """The subtrees among the children."""
    return [child for child in tree.children if isinstance(child, Tree)]


def tokens(tree: Branch, kind: str) -> list[Token]:
    """The tokens of one kind among the children."""
    return [child for child in tree.children if isinstance(child, Token) and child.type == kind]


class _Builder:
    def __init__(self, text: str, extents: Mapping[int, int]) -> None:
        self.text = text
        self.extents = extents
        self.nodes = NodeList()

    def value(self, tree: Branch) -> int:
        add = self.nodes.add
        match tree.data:
            case "number":
                return add("number", str(Fraction(str(tree.children[0]))))
            case "symbol":
                return add("symbol", str(tree.children[0]))
            case "group" | "braced" | "single":
                return self.value(children(tree)[0])
            case "absolute":
                return add("call", "abs", self.value(children(tree)[0]))
            case "sum" | "minus_sum":
                return self._sum(tree)
            case "product":
                return self._product(tree)
            case "times_big":
                return self._many(
                    "mul", [self._product(children(tree)[0]), self.value(children(tree)[1])]
                )
            case "fraction":
                numerator, denominator = children(tree)
                return add("div", self.value(numerator), self.value(denominator))
            case "raised" | "root":
                return self._power(tree)
            case "call":
                return add(
                    "call", str(tree.children[0]), *[self.value(child) for child in children(tree)]
                )
            case "big_sum":
                return self._big_sum(tree)
            case "derivative" | "derivative_operator":
                return self._derivative(tree)
        raise AssertionError(
            f"no rule for {tree.data}"
        )  # pragma: no cover - the grammar has no other rule

    def _many(self, kind: str, numbers: list[int]) -> int:
        return numbers[0] if len(numbers) == 1 else self.nodes.add(kind, *numbers)

    def _sum(self, tree: Branch) -> int:
        negative = tree.data == "minus_sum"
        numbers: list[int] = []
        for child in tree.children:
            if isinstance(child, Token):
                negative = child.type == "MINUS"
            else:
                number = self.value(child)
                numbers.append(self.nodes.add("neg", number) if negative else number)
        return self._many("add", numbers)

    def _product(self, tree: Branch) -> int:
        """Factors from left to right; a slash divides what came before by as many factors as its
        reading says.
        """
        parts = product_parts(tree, self.text)
        factors: list[int] = []
        position = 0
        while position < len(parts):
            operator, slash, factor = parts[position]
            if operator != "divided":
                factors.append(self.value(factor))
                position += 1
                continue
            extent = self.extents.get(slash, 1)
            above = self._many("mul", factors)
            below = [self.value(part.factor) for part in parts[position : position + extent]]
            factors = [self.nodes.add("div", above, self._many("mul", below))]
            position += extent
        return self._many("mul", factors)

    def _power(self, tree: Branch) -> int:
        if tree.data == "raised":
            base, exponent_tree = children(tree)
            exponent = constant_value(exponent_tree)
            place = exponent_tree.meta.start_pos
            if exponent is None:
                raise ReaderError(
                    "an exponent must be a number", self.text, place, self._slice(exponent_tree)
                )
        else:
            base = children(tree)[0]
            place = base.meta.start_pos
            indices = tokens(tree, "NUMBER")
            index = Fraction(str(indices[0])) if indices else Fraction(2)
            if index.denominator != 1 or index < 2:
                raise ReaderError(
                    "the index of a root must be 2, 3, ...", self.text, place, str(index)
                )
            exponent = 1 / index
        if max(abs(exponent.numerator), exponent.denominator) > MOST_EXPONENT:
            problem = f"an exponent beyond {MOST_EXPONENT}"
            raise ReaderError(problem, self.text, place, str(exponent)[:40])
        return self.nodes.add("pow", self.value(base), str(exponent))

    def _big_sum(self, tree: Branch) -> int:
        lower, upper, summand = children(tree)
        index = self.nodes.add("symbol", str(tokens(tree, "SYMBOL")[0]))
        return self.nodes.add(
            "call", "sum", self.value(summand), index, self.value(lower), self.value(upper)
        )

    def _derivative(self, tree: Branch) -> int:
        parts = {child.data: child for child in children(tree)}
        symbol = str(tokens(parts.pop("over_symbol"), "SYMBOL")[0])
        (inner,) = parts.values()
        return self.nodes.add("derivative", self.value(inner), symbol)

    def _slice(self, tree: Branch) -> str:
        return self.text[tree.meta.start_pos : tree.meta.end_pos][:40]


def extents_of(tree: Branch, text: str) -> dict[int, tuple[int, ...]]:
    """Every ambiguous slash below `tree` by position, with the numbers of factors that it may
    divide by.
    """
    found: dict[int, tuple[int, ...]] = {}
    for branch in tree.iter_subtrees():
        if branch.data == "product":
            found.update(factors_under(branch, text))
        elif branch.data == "times_big":
            refuse_open_slash(branch, text)
    return found
