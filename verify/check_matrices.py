"""Decides one certificate about matrices of any size: `python check_matrices.py certificate.json`.

It needs Python alone. Expressions are polynomials in letters that do not commute. A step is a sum
of facts that are 0, between two factors, and of squares F' D F of what is known to be positive: it
is multiplied out and compared, nothing is looked for. Matrices of numbers meet what is supposed.
"""

import ast
import json
import re
import sys
from fractions import Fraction
from keyword import iskeyword
from time import process_time
from typing import Any

FORMAT = "gainproof matrix certificate 1"
MEANING = """matrices are real, of all sizes; a number stands for that multiple of the unit matrix
A > 0: A is symmetric and positive definite, A >= 0: positive semidefinite
what is random is a vector with mean 0 and the variance given, uncorrelated; E is the mean
lines of `typed` and `name` are what the writer says and are not checked"""
MOST_BYTES, MOST_WORK, SECONDS, LARGE = 4_000_000, 4_000_000, 20, 1 << 1_000  # words and letters
TEXT = re.compile(r"(?a:(?!.*\b(\d+[a-zA-Z_]|0\d))[\w+*/(). <>=-]{0,20000})")
NAME = re.compile(r"(?a:(?!E$|size_)[A-Za-z]\w{0,80})")  # E is the mean
SIZE = re.compile(r"(?a:size_(?!\d+$)\w{1,80}|[1-9]|[1-3]\d)")
NUMBER = re.compile(r"-?[0-9]{1,60}(/[0-9]{1,60})?")
SIGNS = {ast.Eq: "==", ast.Gt: ">", ast.GtE: ">="}
Rows = list[list[Fraction]]


def require(condition: object, reason: str) -> None:
    if not condition:
        raise ValueError(reason)


class Poly(dict[tuple[str, ...], Fraction]):
    """Words -> numbers that are not 0; shape: names of rows and columns, none of a number."""

    def __init__(self, terms: Any = (), shape: tuple[str, ...] = ()) -> None:
        super().__init__({word: c for word, c in dict(terms).items() if c})
        self.shape = shape
        self.size = len(self) + sum(map(len, self))
        large = max((abs(x) for c in self.values() for x in c.as_integer_ratio()), default=0)
        require(large < LARGE, "too long")

    def less(self, other: "Poly") -> "Poly":
        a, b = self.shape, other.shape
        square = a[:1] == a[1:] and b[:1] == b[1:]
        # a number stands beside what is square, zero beside anything
        fits = a == b or (not a and (square or not self)) or (not b and (square or not other))
        require(fits, f"shapes do not fit: {a} and {b}")
        return Poly({w: self.get(w, 0) - other.get(w, 0) for w in {**self, **other}}, a or b)

    def turned(self) -> "Poly":
        """(A B)' = B' A'."""
        words = [[sys.intern(f"{k}'".removesuffix("''")) for k in word[::-1]] for word in self]
        return Poly(zip(map(tuple, words), self.values(), strict=True), self.shape[::-1])


ONE = Poly({(): Fraction(1)})


class Certificate:
    def __init__(self, data: Any) -> None:
        require(isinstance(data, dict) and data.get("format") == FORMAT, f"no {FORMAT}")
        self.data, self.lines = data, [MEANING]
        self.meaning = dict[str, Poly]()
        self.names = dict[str, str]()  # letters and sizes, and their names in the source
        self.letters = dict[str, Poly]()  # in words with ' behind it where transposed
        self.facts = list[tuple[Poly, str]]()  # p == > >= 0
        self.inverses = dict[str, Poly]()  # not known to exist, and of what
        self.conditions = list[tuple[Poly, str]]()  # that the numbers of the certificate meet
        self.wanted = list[tuple[Poly, str]]()
        self.random = dict[str, Poly]()  # vectors, and their variances
        self.work, self.latest = 0, process_time() + SECONDS

    def decide(self) -> list[str]:
        """The lines to print. Raises ValueError and others."""
        for title, *said in self.data["lines"]:
            self.line(title, *said)
        self.spend(sum(p.size for p, _ in self.wanted) * len(self.facts))
        shown = self.wanted and all(each in self.facts for each in self.wanted)
        require(shown and not self.inverses, "the claim is not shown, or that inverses exist")
        known = {*self.meaning, *(sizes := self.meet())}
        require(self.names.keys() <= known and known.isdisjoint(self.names.values()), "two things")
        met = ", ".join(f"{name} = {n}" for name, n in sizes.items())
        return [*self.lines, f"{'met at:':<12}{met}", "proved"]

    def spend(self, work: int, rows: Rows | tuple[()] = ()) -> None:
        self.work += work
        require(self.work < MOST_WORK and process_time() < self.latest, "too much work")
        large = max((abs(n) for row in rows for x in row for n in x.as_integer_ratio()), default=0)
        require(large < LARGE, "too long")

    def line(self, title: str, *said: Any) -> None:
        """Reads one more: a step of the proof, or what is printed."""
        if title in ("shows", "opens"):
            getattr(self, title)(*said)
            return
        (text,) = said
        self.lines.append(f"{title + ':':<12}{text}")
        require(text.isprintable() and text == " ".join(text.split()), "what misleads")
        name, _, value = (word.strip() for word in text.partition("="))
        new = NAME.fullmatch(name) and not iskeyword(name) and name not in self.meaning
        if title == "matrix" and new:
            self.letter(name, tuple(value.split(" by ")))
        elif title == "unit" and new and SIZE.fullmatch(value):
            self.meaning[name] = Poly({(): Fraction(1)}, (value, value))
        elif title == "with" and new:
            self.meaning[name] = self.value(value)
        elif title == "let" and new:
            p = self.value(value)
            self.fact(self.letter(name, p.shape).less(p), "==")
        elif title == "inverse" and new:
            self.inverses[name] = p = self.letters[value.removesuffix("**-1")]
            require(value.endswith("**-1") and p.shape[0] == p.shape[1], "no inverse")
            self.conditions.append((self.times(p, self.letter(name, p.shape)).less(ONE), "=="))
        elif title == "where":
            self.fact(*self.value(text, True))
        elif title == "random" and new:
            self.conditions.append(self.value(f"{value} >= 0", True))
            self.random[name] = p = self.conditions[-1][0]
            self.letter(name, (p.shape[0], "1"))
        elif title == "name":
            name, _, token = text.partition(" for ")
            require(name not in self.names and token not in self.names.values(), "two things")
            self.names[name] = token
        elif title == "claim":
            self.wanted.append(self.value(text, True))
        else:
            require(title == "typed", f"not known: {title}")
        self.conditions += self.facts[-2:-1] if title in ("let", "where") else []

    def mean(self, p: Poly) -> Poly:
        """E v = 0, E v v' is the variance, E v w' = 0; other words of two or more are not read."""
        found = dict[tuple[str, ...], Fraction]()
        for word, c in p.items():
            at = [i for i, k in enumerate(word) if k.removesuffix("'") in self.random]
            different = len({word[i].removesuffix("'") for i in at}) == len(at) < 3
            term = {} if at and different else {word: c}
            if not different:
                i, j = at  # not of three
                require(j == i + 1 and word[j] == f"{word[i]}'", "a mean that is not of v v'")
                variance = self.random[word[i]].items()
                term = {word[:i] + w + word[j + 1 :]: c * x for w, x in variance}
            self.spend(1 + len(term) + sum(map(len, term)))
            found |= {w: x + found.get(w, 0) for w, x in term.items()}
        return Poly(found, p.shape)

    def letter(self, name: str, shape: tuple[str, ...]) -> Poly:
        require(len(shape) == 2 and all(map(SIZE.fullmatch, shape)), f"no shape: {name}")
        self.letters[name] = self.meaning[name] = Poly({(name,): Fraction(1)}, shape)
        return self.letters[name]

    def value(self, node: Any, relation: bool = False) -> Any:
        """The polynomial of an expression; of a relation left less right, and the sign."""
        if isinstance(node, str):
            require(TEXT.fullmatch(node), f"no expression: {node}")
            node = ast.parse(node.strip(), mode="eval").body
        require(relation == isinstance(node, ast.Compare), "a relation, or none")
        match node:
            case ast.Compare(left=a, ops=[op], comparators=[b]):
                p, sign = self.value(ast.BinOp(a, ast.Sub(), b)), SIGNS[type(op)]
                require(sign == "==" or p.shape[:1] == p.shape[1:], "what is not square")
                return p, sign
            case ast.Constant(value=number) if type(number) is int:
                return Poly({(): Fraction(number)})
            case ast.Name(id=name) if name in self.meaning:
                return self.meaning[name]
            case ast.Call(func=ast.Name(id="E"), args=[a], keywords=[]):
                return self.mean(self.value(a))
            case ast.Attribute(value=a, attr="T"):
                return self.times(ONE, self.value(a)).turned()
            case ast.UnaryOp(op=ast.USub(), operand=a):
                return self.value(ast.BinOp(ast.Constant(0), ast.Sub(), a))
            case ast.BinOp(a, ast.Add() | ast.Sub() | ast.Mult() | ast.Div() as op, b):
                one, two = self.value(a), self.value(b)
                self.spend(one.size + two.size)
                if isinstance(op, ast.Add | ast.Sub):
                    return one.less(Poly().less(two) if isinstance(op, ast.Add) else two)
                if isinstance(op, ast.Div):
                    require([*two] == [()] and not two.shape, "a divisor that is no number")
                    two = Poly({(): 1 / two[()]})
                return self.times(one, two)
        raise ValueError(f"not known: {ast.unparse(node)}")

    def fact(self, p: Poly, sign: str) -> None:
        """With its transpose, or that it is symmetric (what is not square, does not fit)."""
        self.spend(2 * p.size)
        self.facts += [(p, sign), (p.turned() if sign == "==" else p.less(p.turned()), "==")]

    def times(self, one: Poly, *others: Poly) -> Poly:
        for two in others:
            a, b, found = one.shape, two.shape, dict[tuple[str, ...], Fraction]()
            require(not a or not b or a[1] == b[0], f"shapes do not fit: {a} times {b}")
            self.spend(len(one) * two.size + len(two) * one.size)
            for v, x in one.items():
                for w, y in two.items():
                    found[v + w] = found.get(v + w, 0) + x * y
            one = Poly(found, (a[0], b[1]) if a and b else a or b)
        return one

    def zeros(self, p: Poly, terms: Any, facts: list[tuple[Poly, str]]) -> Poly:
        """A polynomial less terms [left, fact, right], each of a fact that is 0."""
        for left, k, right in terms:
            fact, sign = facts[k]
            require(sign == "==", "a fact that is not 0")
            self.spend(p.size)
            p = p.less(self.times(self.value(left), fact, self.value(right)))
        return p

    def shows(self, text: str, terms: Any, squares: Any = (), by: Any = (), ones: Any = ()) -> None:
        """p is the sum of terms and of squares [number, F, fact D > 0 or >= 0, or none of D = 1].

        It is definite if no x but 0 makes all squares 0: `by` [L, square, "1"] and terms `ones` are
        L F of D > 0, and L D F, with the sum 1. (x' F' D F x = 0 makes D F x = 0.)
        """
        p, sign = self.value(text, True)
        rest, factors = p, list[tuple[Poly, str]]()
        for number, root, k in squares:
            factor, scale = self.value(root), self.value(number)
            middle, its = (ONE, ">") if k is None else self.facts[k]
            require(its in (">", ">=") and [*scale] == [()] and scale[()] > 0, "no square")
            self.spend(rest.size + factor.size)
            rest = rest.less(self.times(scale, factor.turned(), middle, factor))
            factors.append((factor if its == ">" else self.times(middle, factor), "=="))
        shown = not self.zeros(rest, terms, self.facts) and (sign != "==" or not squares)
        require(shown, f"not so: {text}")
        if sign == ">":
            require(all(right == "1" for *_, right in by), "no multiple from the left")
            rest = self.zeros(Poly(ONE, p.shape), by, factors)
            require(not self.zeros(rest, ones, self.facts), f"not definite: {text}")
        self.fact(p, sign)

    def opens(self, name: str, by: int, left: str = "0") -> None:
        """An inverse exists: of what is definite by a fact, or L A = 1 by a fact (A is square)."""
        p, me = self.inverses.pop(name), self.letters[name]
        known = (p, ">"), (self.times(self.value(left), p).less(ONE), "==")
        require(self.facts[by] in known, f"{name} is not shown to exist")
        self.fact(self.times(p, me).less(ONE), "==")
        self.fact(self.times(me, p).less(ONE), "==")

    def meet(self) -> dict[str, int]:
        """Shows that conditions are met at sizes above 1 that differ, so not at one size alone."""
        sides = {side for p in self.meaning.values() for side in p.shape}
        named = {side: self.data["sizes"][side] for side in sorted(sides) if not side.isdigit()}
        fine = {*map(type, named.values())} <= {int} and len({*named.values()}) == len(named)
        require(fine and all(1 < n < 40 for n in named.values()), "sizes alike, of 1, or large")
        sizes = {side: named.get(side) or int(side) for side in sides}
        numbers = dict[str, Rows]()  # none of what is random, of which there are no conditions
        for name in self.letters.keys() - self.random.keys():
            rows, columns = (sizes[side] for side in self.letters[name].shape)
            said = self.data["numbers"][name]
            require([*map(len, said)] == [columns] * rows, f"{name} has another shape")
            require(all(NUMBER.fullmatch(x) for row in said for x in row), "no number")
            numbers[name] = [[*map(Fraction, row)] for row in said]
        for p, sign in self.conditions:
            a = self.evaluated(p, numbers, sizes)
            met = not any(map(any, a)) if sign == "==" else self.is_positive(a, sign == ">")
            require(met, "the numbers do not meet a condition")
        return named

    def evaluated(self, p: Poly, numbers: dict[str, Rows], sizes: dict[str, int]) -> Rows:
        rows, columns = (sizes[side] for side in p.shape)
        total = [[Fraction()] * columns for _ in range(rows)]
        for word, c in p.items():
            a = [[c * (i == j) for j in range(rows)] for i in range(rows)]
            for k in word:
                b = numbers[k.removesuffix("'")]
                b = [[*row] for row in zip(*b, strict=True)] if k in numbers else b  # its columns
                self.spend(rows * len(b) * len(b[0]), a)
                a = [[sum(map(Fraction.__mul__, row, v), Fraction()) for v in b] for row in a]
            total = [[*map(Fraction.__add__, *both)] for both in zip(total, a, strict=True)]
            self.spend(len(a), total)
        return total

    def is_positive(self, a: Rows, strict: bool) -> bool:
        """Whether a matrix of numbers is symmetric and positive definite, or semidefinite."""
        while a:
            self.spend(len(a) ** 2, a)
            (p, *row), *rest = a
            if p < 0 or (p == 0 and (strict or any(row))) or [b[0] for b in rest] != row:
                return False
            a = [[x - b[0] * z / (p or 1) for x, z in zip(b[1:], row, strict=True)] for b in rest]
        return True


def main(arguments: list[str]) -> int:
    """0 if the certificate shows what it says, else 1."""
    try:
        with open(arguments[0], "rb") as file:
            lines = Certificate(json.loads(file.read(MOST_BYTES))).decide()
    except Exception as error:  # noqa: BLE001  whatever is wrong with it, it shows nothing
        lines = [f"REJECTED: {type(error).__name__}: {' '.join(ascii(str(error)).split()):.200}"]
    print("\n".join(lines).encode("ascii", "backslashreplace").decode())
    return int(lines[-1].startswith("REJECTED"))


if __name__ == "__main__":
    sys.exit(__doc__ if sys.argv[1:] in ([], ["-h"], ["--help"]) else main(sys.argv[1:]))
