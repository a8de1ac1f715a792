"""From syntax trees to expression graphs: one graph for each choice of readings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from lark import Token, Tree

from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.reader.calculus_nodes import (
    derivative,
    derivative_there,
    evaluated,
    family,
    integral,
    long_sum,
)
from gainproof.verify.judge.reader.call_nodes import call, named, named_raised
from gainproof.verify.judge.reader.constant import constant_value
from gainproof.verify.judge.reader.dotted_terms import dotted_product, dotted_sum, has_dots
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_EXPONENT
from gainproof.verify.judge.reader.graph_nodes import NodeList
from gainproof.verify.judge.reader.matrix_nodes import kronecker, matrix, transposed
from gainproof.verify.judge.reader.slash import Part, product_parts
from gainproof.verify.judge.reader.syntax_tree import Branch, children, printed, start, tokens
from gainproof.verify.judge.reader.tokens import NORM
from gainproof.verify.judge.reader.vocabulary import Vocabulary
from gainproof.verify.judge.reader.words import OF_CASES

MOST_CASES = 16
COMPARED = ("=", "!=", "<", "<=", ">", ">=")


def build_graph(
    tree: Branch, text: str, extents: Mapping[int, int], vocabulary: Vocabulary
) -> Graph:
    """The graph of one expression. `extents` maps the position of each ambiguous slash to the
    number of factors it divides by, that of each ambiguous bar to the number it applies to.
    """
    builder = Builder(text, extents, vocabulary)
    return builder.nodes.graph(builder.value(tree))


class Builder:
    """Makes the nodes of one expression; the forms that are not arithmetic have modules of their
    own. `indices` keeps the nodes of indices met in names.
    """

    def __init__(self, text: str, extents: Mapping[int, int], vocabulary: Vocabulary) -> None:
        self.text = text
        self.extents = extents
        self.vocabulary = vocabulary
        self.nodes = NodeList(vocabulary.matrices)
        self.indices: dict[str, int | None] = {}

    def value(self, tree: Branch) -> int:
        """The number of the node for a tree. ReaderError where the print is open to doubt."""
        add = self.nodes.add
        match tree.data:
            case "number":
                digits, _, power = str(tree.children[0]).partition("e")
                number = add("number", str(Fraction(digits)))
                if not power:
                    return number
                return add("mul", number, add("pow", add("number", "10"), power))
            case "symbol":
                return add("symbol", str(tree.children[0]))
            case "constant":
                return add("call", str(tree.children[0]))
            case "group" | "braced" | "single" | "bound":
                inner = children(tree)
                return self.value(inner[0]) if inner else add("symbol", "infinity")
            case "infinity":
                number = add("symbol", "infinity")
                return add("neg", number) if tokens(tree, "MINUS") else number
            case "absolute":
                name = _BARS[str(tokens(tree, "BAR_OPEN")[0])]
                return add("call", name, self.value(children(tree)[0]))
            case "expectation" | "order_of" | "euler":
                return add("call", _CALLS[tree.data], self.value(children(tree)[0]))
            case "sum" | "minus_sum" | "plus_sum":
                return self._sum(tree)
            case "product":
                return self._product(tree)
            case "modulo":
                self._refuse_signs_behind_mod(tree)
                return add("call", "mod", *map(self.value, children(tree)))
            case "times_big":
                return self.many("mul", [self.value(child) for child in children(tree)])
            case "fraction" | "over":
                numerator, denominator = children(tree)
                return add("div", self.value(numerator), self.value(denominator))
            case "raised" | "root":
                return self._power(tree)
        return self._form(tree)

    def _form(self, tree: Branch) -> int:
        match tree.data:
            case "call" | "call_raised" | "call_transposed":
                return call(self, tree)
            case "named":
                return named(self, tokens(tree, "NAMED")[0], children(children(tree)[0]), tree)
            case "word_call":
                return named(self, tokens(tree, "WORD")[0], children(tree), tree)
            case "named_raised":
                return named_raised(self, tree)
            case "matrix":
                return matrix(self, tree)
            case "cases":
                return cases(self, tree)
            case "transposed":
                base = children(tree)[0]
                return transposed(self, self.value(base), tokens(tree, "TRANSPOSE")[0])
            case "big_sum" | "big_sum_from_above":
                return long_sum(self, tree)
            case "family":
                return family(self, tree)
            case "dots":
                raise self.error("dots stand for a pattern that is not declared", tree)
            case "integral" | "integral_from_above":
                return integral(self, tree)
            case "derivative" | "derivative_operator":
                return derivative(self, tree)
            case "derivative_there":
                return derivative_there(self, tree)
            case "evaluated_group":
                inner, statements = children(tree)
                return evaluated(self, self.value(inner), statements)
        raise AssertionError(
            f"no rule for {tree.data}"
        )  # pragma: no cover - the grammar has no other rule

    def error(self, problem: str, tree: Branch) -> ReaderError:
        """An error at a tree."""
        return ReaderError(problem, self.text, start(tree), printed(tree, self.text))

    def many(self, kind: str, numbers: Sequence[int]) -> int:
        """A sum or product of nodes; of one node it is the node."""
        return numbers[0] if len(numbers) == 1 else self.nodes.add(kind, *numbers)

    def refuse_entries(self, tree: Branch, *numbers: int) -> None:
        """ReaderError if one of the nodes is a matrix, of which each entry is meant."""
        if any(map(self.nodes.is_matrix, numbers)):
            problem = "entry by entry, which is not read of matrices: write out the entries"
            raise self.error(problem, tree)

    def _refuse_signs_behind_mod(self, tree: Branch) -> None:
        """ReaderError for `a mod 2*b`, which languages read as `(a mod 2)*b`."""
        modulus = children(tree)[1]
        signs = ("dotted", "divided", "crossed")
        if any(each.data in signs for each in children(modulus)):
            raise self.error("what the modulus is is not clear: write brackets", modulus)

    def _sum(self, tree: Branch) -> int:
        if has_dots(children(tree)):
            return dotted_sum(self, tree)
        negative = False
        numbers: list[int] = []
        for child in tree.children:
            if isinstance(child, Token):
                negative = child.type == "MINUS"
            elif child.data == "modulo" and child is not tree.children[0]:
                raise self.error("what the modulus is of is not clear: write brackets", child)
            else:
                number = self.value(child)
                numbers.append(self.nodes.add("neg", number) if negative else number)
        return self.many("add", numbers)

    def _product(self, tree: Branch) -> int:
        """Factors from left to right; a slash divides what came before by as many factors as its
        reading says.
        """
        parts = product_parts(tree, self.text)
        if len(parts) > 1 and has_dots([part.factor for part in parts]):
            return dotted_product(self, parts)
        if len(parts) > 1 and parts[1].operator == "crossed":
            return kronecker(self, [self._factor(part) for part in parts])
        factors: list[int] = []
        position = 0
        while position < len(parts):
            part = parts[position]
            if part.operator != "divided":
                number = self._factor(part)
                if part.entrywise and any(map(self.nodes.is_matrix, factors)):
                    self.refuse_entries(part.factor, number)
                factors.append(number)
                position += 1
                continue
            extent = self.extents.get(part.place, 1)
            above = self.many("mul", factors)
            below = [self._factor(other) for other in parts[position : position + extent]]
            if part.entrywise:
                self.refuse_entries(part.factor, *below)
            factors = [self.nodes.add("div", above, self.many("mul", below))]
            position += extent
        whole = self.many("mul", factors)
        for bar in parts[-1].bars:
            if self.extents.get(start(bar), 1) > 1:
                whole = evaluated(self, whole, children(bar)[0])
        return whole

    def _factor(self, part: Part) -> int:
        number = self.value(part.factor)
        for bar in part.bars:
            if self.extents.get(start(bar), 1) == 1:
                number = evaluated(self, number, children(bar)[0])
        return number

    def _power(self, tree: Branch) -> int:
        if tree.data == "raised":
            base, above = children(tree)
            number = self.value(base)
            sign = tokens(tree, "POWER")[0]
            if sign == ".^":
                self.refuse_entries(above, number, self.value(above))
            return self.power(number, above, of_code=sign in ("**", ".^"))
        base = children(tree)[0]
        indices = tokens(tree, "NUMBER")
        index = Fraction(str(indices[0])) if indices else Fraction(2)
        if index.denominator != 1 or index < 2:
            raise ReaderError(
                "the index of a root must be 2, 3, ...", self.text, start(base), str(index)
            )
        return self._raised(self.value(base), 1 / index, base)

    def power(self, base: int, above: Tree[Token], *, of_code: bool = False) -> int:
        """A node with an exponent: a number, an inverse of a matrix, or any other expression. With
        `of_code` odd roots are of no negative numbers: `pow(-8, 1/3)` has no value in C.
        """
        exponent = constant_value(above)
        if of_code and exponent is not None and exponent.denominator % 2 and exponent % 1:
            base, exponent = self._raised(base, Fraction(1, 2), above), 2 * exponent
        if exponent is None:
            return self.nodes.add("call", "power", base, self.value(above))
        return self._raised(base, exponent, above)

    def _raised(self, base: int, exponent: Fraction, place: Branch) -> int:
        if exponent == -1 and self.nodes.is_matrix(base):
            return self.nodes.add("inverse", base)
        if max(abs(exponent.numerator), exponent.denominator) > MOST_EXPONENT:
            raise ReaderError(
                f"an exponent beyond {MOST_EXPONENT}", self.text, start(place), str(exponent)[:40]
            )
        return self.nodes.add("pow", base, str(exponent))


_BARS = {"|": "abs", NORM: "norm", "floor": "floor", "ceil": "ceil"}
_CALLS = {"expectation": "expectation", "order_of": "order", "euler": "exp"}


def cases(builder: Builder, tree: Branch) -> int:
    """A call whose name says how its parts are compared: `cases >,<= -` has a value under two
    conditions, then one for all else; its parts are a value, four sides, a value.
    """
    lines = children(tree)
    if len(lines) > MOST_CASES:
        raise builder.error(f"more than {MOST_CASES} cases", tree)
    words: list[str] = []
    parts: list[int] = []
    for line in lines:
        value, *conditions = children(line)
        if not conditions and line is not lines[-1]:
            raise builder.error("a value for all else, before the last one", value)
        if not conditions and tokens(line, "CELL") and not tokens(line, "OTHERWISE"):
            raise builder.error("a condition is missing: write \\text{otherwise}", value)
        parts.append(builder.value(value))
        operators: list[str] = []
        for chain in children(conditions[0]) if conditions else ():
            sides = children(chain)
            signs = [child for child in chain.children if isinstance(child, Token)]
            for left, sign, right in zip(sides, signs, sides[1:], strict=False):
                inner = [children(side)[0] for side in (left, right)]
                if str(sign) not in COMPARED or any(
                    side.data in ("infinity", "limit") for side in inner
                ):
                    raise builder.error("a condition of a case is to compare numbers", chain)
                operators.append(str(sign))
                parts += map(builder.value, inner)
        words.append(",".join(operators) or "-")
    if words == ["-"]:
        raise builder.error("cases without a condition", tree)
    return builder.nodes.add("call", f"{OF_CASES}{' '.join(words)}", *parts)
