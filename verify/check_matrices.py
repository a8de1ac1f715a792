"""Decides one certificate about matrices of any size: `python check_matrices.py certificate.json`.

It needs Python alone. A certificate is a statement, printed as it is checked, steps that prove it,
and matrices that meet its conditions. Expressions are polynomials in letters that do not commute. A
step is a sum of facts that are 0, each between two factors, and of squares F' D F of what is known
to be positive. This is multiplied out and compared, word by word; nothing is looked for.
"""

import ast
import json
import re
import sys
from fractions import Fraction
from typing import Any

FORMAT = "gainproof matrix certificate 1"
MEANING = """matrices are real, of all sizes; a number stands for that multiple of the unit matrix
A > 0: A is symmetric and positive definite, A >= 0: positive semidefinite
what is random is a vector with mean 0 and the variance given, uncorrelated; E is the mean"""
MOST_BYTES, MOST_TERMS, MOST_LETTERS, MOST_BITS, MOST_ROWS = 4_000_000, 100_000, 64, 4_000, 40
TEXT = re.compile(r"(?a:[\w+*/(). <>=-]{0,20000})")
NAME = re.compile(r"(?a:(?!E$)[A-Za-z]\w{0,80})")  # E is the mean
SIZE = re.compile(r"(?a:[A-Za-z]\w{0,80}|[1-9]\d?)")
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
        require(len(self) < MOST_TERMS, "too many terms")
        for word, c in self.items():
            short = (c.numerator * c.denominator).bit_length() < MOST_BITS
            require(short and len(word) < MOST_LETTERS, "too long")

    def plus(self, other: "Poly", factor: int = 1) -> "Poly":
        a, b = self.shape, other.shape
        square = a[:1] == a[1:] and b[:1] == b[1:]
        # a number stands beside what is square, zero beside anything
        fits = a == b or (not a and (square or not self)) or (not b and (square or not other))
        require(fits, f"shapes do not fit: {a} and {b}")
        found = {w: self.get(w, Fraction()) + factor * other.get(w, 0) for w in {**self, **other}}
        return Poly(found, a or b)

    def less(self, other: "Poly") -> "Poly":
        return self.plus(other, -1)

    def times(self, other: "Poly") -> "Poly":
        a, b = self.shape, other.shape
        require(not a or not b or a[1] == b[0], f"shapes do not fit: {a} times {b}")
        require(len(self) * len(other) < MOST_TERMS, "too many terms")
        found: dict[tuple[str, ...], Fraction] = {}
        for one, x in self.items():
            for two, y in other.items():
                found[one + two] = found.get(one + two, Fraction()) + x * y
        return Poly(found, (a[0], b[1]) if a and b else a or b)

    def turned(self) -> "Poly":
        """(A B)' = B' A'."""
        words = [[f"{k}'".removesuffix("''") for k in reversed(word)] for word in self]
        return Poly(zip(map(tuple, words), self.values(), strict=True), self.shape[::-1])


def is_positive(a: Rows, strict: bool) -> bool:
    """Whether a matrix of numbers is symmetric and positive definite, or semidefinite."""
    if a != (a := [[*row] for row in zip(*a, strict=True)]):
        return False
    for k, row in enumerate(a):
        pivot = row[k]
        if pivot < 0 or (pivot == 0 and (strict or any(row[k:]))):
            return False
        for below in a[k + 1 :] if pivot else []:
            below[:] = [x - below[k] / pivot * y for x, y in zip(below, row, strict=True)]
    return True


def shape_of(p: Poly, sizes: dict[str, int]) -> tuple[int, int]:
    rows, columns = (int(name) if name.isdigit() else sizes[name] for name in p.shape)
    require(0 < rows <= MOST_ROWS and 0 < columns <= MOST_ROWS, "a size that is not positive")
    return rows, columns


def evaluated(p: Poly, numbers: dict[str, Rows], sizes: dict[str, int]) -> Rows:
    rows, columns = shape_of(p, sizes)
    total = [[Fraction()] * columns for _ in range(rows)]
    for word, c in p.items():
        a = [[c * (i == j) for j in range(rows)] for i in range(rows)]
        for k in word:
            b = numbers[k.removesuffix("'")]
            b = [[*row] for row in zip(*b, strict=True)] if k in numbers else b  # its columns
            a = [[sum(map(Fraction.__mul__, row, v), Fraction()) for v in b] for row in a]
        total = [[*map(Fraction.__add__, *both)] for both in zip(total, a, strict=True)]
    return total


ONE = Poly({(): Fraction(1)})
SUMS: Any = {ast.Add: Poly.plus, ast.Sub: Poly.less, ast.Mult: Poly.times}


class Certificate:
    def __init__(self, data: Any) -> None:
        require(isinstance(data, dict) and data.get("format") == FORMAT, f"no {FORMAT}")
        self.data = data
        self.meaning = dict[str, Poly]()
        self.letters = dict[str, Poly]()  # in words with ' behind it where transposed
        self.facts = list[tuple[Poly, str]]()  # p == > >= 0
        self.inverses = dict[str, Poly]()  # not known to exist, and of what
        self.conditions = list[tuple[Poly, str]]()  # that the numbers of the certificate meet
        self.wanted = list[tuple[Poly, str]]()
        self.random = dict[str, Poly]()  # vectors, and their variances
        self.lines = [MEANING]

    def decide(self) -> list[str]:
        """The lines to print. Raises ValueError and others."""
        for title, *said in self.data["lines"]:
            self.line(title, *said)
        require(all(each in self.facts for each in self.wanted), "the claim is not shown")
        require(self.wanted and not self.inverses, "no claim, or inverses not shown to exist")
        self.meet()
        return [*self.lines, "proved"]

    def line(self, title: str, *said: Any) -> None:
        """Reads one more: a step of the proof, or what is printed."""
        if title in ("shows", "opens", "equal"):
            getattr(self, title)(*said)
            return
        (text,) = said
        self.lines.append(f"{title + ':':<12}{text}")
        name, _, value = (word.strip() for word in text.partition("="))
        new = NAME.fullmatch(name) and name not in self.meaning
        require(text.isprintable() and len(text) < 20_000, "what cannot be printed")
        if title in ("typed", "name"):
            return
        if title == "matrix" and new:
            rows, columns = value.split(" by ")
            require(SIZE.fullmatch(rows) and SIZE.fullmatch(columns), "no size")
            self.letter(name, (rows, columns))
        elif title == "unit" and new and SIZE.fullmatch(value):
            self.meaning[name] = Poly({(): Fraction(1)}, (value, value))
        elif title == "with" and new:
            self.meaning[name] = self.value(value)
        elif title == "let" and new:
            p = self.fixed(self.value(value))
            self.fact(self.letter(name, p.shape).less(p), "==", given=True)
        elif title == "inverse" and new:
            p = self.fixed(self.letters[value.removesuffix("**-1")])
            require(value.endswith("**-1") and p.shape[0] == p.shape[1], "no inverse")
            self.inverses[name] = p
            self.conditions.append((p.times(self.letter(name, p.shape)).less(ONE), "=="))
        elif title == "where":
            p, sign = self.value(text)
            self.fact(p, sign, given=True)
        elif title == "random" and new:
            self.random[name] = p = self.fixed(self.value(value))
            self.letter(name, (p.shape[0], "1"))
            self.conditions.append((p, ">="))  # so it is square
        else:
            require(title == "claim", f"not known: {title}")
            self.wanted.append(self.value(text))

    def fixed(self, p: Poly) -> Poly:
        letters = {k.removesuffix("'") for word in p for k in word}
        require(letters.isdisjoint(self.random), "of what is random")
        return p

    def mean(self, p: Poly) -> Poly:
        """E v = 0, E v v' is the variance, E v w' = 0; other words of two or more are not read."""
        total = Poly({}, p.shape)
        for word, c in p.items():
            at = [i for i, k in enumerate(word) if k.removesuffix("'") in self.random]
            require(len(at) < 3, "a mean of three")
            if len(at) == len({word[i].removesuffix("'") for i in at}) > 0:
                continue
            term = Poly({word: c}, p.shape)
            if at:
                i, v = at[0], self.letters[word[at[0]]]
                require(word[i + 1] == f"{word[i]}'", "a mean that is not of v v'")
                before = Poly({word[:i]: c}, (p.shape[0], v.shape[0]))
                after = Poly({word[i + 2 :]: Fraction(1)}, (v.shape[0], p.shape[1]))
                term = before.times(self.random[word[i]]).times(after)
            total = total.plus(term)
        return total

    def letter(self, name: str, shape: tuple[str, ...]) -> Poly:
        self.letters[name] = self.meaning[name] = Poly({(name,): Fraction(1)}, shape)
        return self.letters[name]

    def value(self, node: Any) -> Any:
        """The polynomial of an expression, or that and its sign of a relation with 0."""
        if isinstance(node, str):
            require(TEXT.fullmatch(node), f"no expression: {node}")
            node = ast.parse(node.strip(), mode="eval").body
        match node:
            case ast.Compare(left=a, ops=[op], comparators=[b]):
                return self.value(a).less(self.value(b)), SIGNS[type(op)]
            case ast.Constant(value=number) if type(number) is int:
                return Poly({(): Fraction(number)})
            case ast.Name(id=name):
                return self.meaning[name]
            case ast.Call(func=ast.Name(id="E"), args=[a], keywords=[]):
                return self.mean(self.value(a))
            case ast.Attribute(value=a, attr="T"):
                return self.value(a).turned()
            case ast.UnaryOp(op=ast.USub(), operand=a):
                return Poly().less(self.value(a))
            case ast.BinOp(left=a, op=ast.Add() | ast.Sub() | ast.Mult() as op, right=b):
                return SUMS[type(op)](self.value(a), self.value(b))
            case ast.BinOp(left=a, op=ast.Div(), right=ast.Constant(value=int(number))):
                return self.value(a).times(Poly({(): 1 / Fraction(number)}))
        raise ValueError(f"not known: {ast.unparse(node)}")

    def fact(self, p: Poly, sign: str, given: bool = False) -> None:
        """With its transpose, or that it is symmetric (what is not square, does not fit)."""
        self.conditions += [(self.fixed(p), sign)] if given else []
        self.facts += [(p, sign), (p.turned() if sign == "==" else p.less(p.turned()), "==")]

    def zeros(self, p: Poly, terms: Any) -> Poly:
        """A polynomial less terms [left, fact, right], each of a fact that is 0."""
        for left, k, right in terms:
            fact, sign = self.facts[k]
            require(sign == "==", "a fact that is not 0")
            p = p.less(self.value(left).times(fact).times(self.value(right)))
        return p

    def shows(
        self, text: str, terms: Any, squares: Any = (), inverses: Any = (), ones: Any = ()
    ) -> None:
        """p is the sum of terms and of squares [number, F, fact D > 0 or >= 0, or none of D = 1].

        It is definite if no x but 0 makes all squares 0: the sum of L F of those with D > 0 and
        of L D F is 1, by inverses [L, square] and terms. (x' F' D F x = 0 makes D F x = 0.)
        """
        p, sign = self.value(text)
        rest, factors = p, list[Poly]()
        for number, root, k in squares:
            factor, scale = self.value(root), self.value(number)
            middle, its = (ONE, ">") if k is None else self.facts[k]
            require(its in (">", ">=") and not scale.shape and scale.get((), 0) > 0, "no square")
            rest = rest.less(scale.times(factor.turned()).times(middle).times(factor))
            factors.append(factor if its == ">" else middle.times(factor))
        require(not self.zeros(rest, terms), f"not so: {text}")
        require(sign != "==" or not squares, "an equation by squares")
        if sign == ">":
            rest = ONE.plus(Poly({}, p.shape))
            for left, k in inverses:
                rest = rest.less(self.value(left).times(factors[k]))
            require(not self.zeros(rest, ones), f"not definite: {text}")
        self.fact(p, sign)

    def equal(self, least: int, most: int) -> None:
        """p >= 0 and -p >= 0: x' p x = 0 for all x, and p is symmetric, so p = 0."""
        (p, one), (q, two) = self.facts[least], self.facts[most]
        require({one, two} <= {">", ">="} and not p.plus(q), "no bounds that meet")
        self.fact(p, "==")

    def opens(self, name: str, by: int, left: str = "0") -> None:
        """An inverse exists: of what is definite by a fact, or L A = 1 by a fact (A is square)."""
        p, me = self.inverses.pop(name), self.letters[name]
        known = (p, ">"), (self.value(left).times(p).less(ONE), "==")
        require(self.facts[by] in known, f"{name} is not shown to exist")
        self.fact(p.times(me).less(ONE), "==")
        self.fact(me.times(p).less(ONE), "==")

    def meet(self) -> None:
        """Numbers for all letters meet the conditions: the statement is not about nothing."""
        sizes = {name: int(n) for name, n in self.data["sizes"].items()}
        numbers = dict[str, Rows]()
        for name, p in self.letters.items():
            (rows, columns), said = shape_of(p, sizes), self.data["numbers"][name]
            require([*map(len, said)] == [columns] * rows, f"{name} has another shape")
            require(all(NUMBER.fullmatch(x) for row in said for x in row), "no number")
            numbers[name] = [[*map(Fraction, row)] for row in said]
        for p, sign in self.conditions:
            a = evaluated(p, numbers, sizes)
            met = not any(map(any, a)) if sign == "==" else is_positive(a, sign == ">")
            require(met, f"the numbers do not meet {dict(p)} {sign} 0")


def main(arguments: list[str]) -> int:
    """0 if the certificate shows what it says, else 1."""
    try:
        with open(arguments[0], "rb") as file:
            lines = Certificate(json.loads(file.read(MOST_BYTES))).decide()
    except Exception as error:  # noqa: BLE001  whatever is wrong with it, it shows nothing
        lines = [f"REJECTED: {type(error).__name__}: {' '.join(str(error).split()):.300}"]
    print("\n".join(lines).encode("ascii", "backslashreplace").decode())
    return int(lines[-1].startswith("REJECTED"))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
