"""Decides one certificate about least squares of growing or fading memory with Python alone.

Usage: check_memory.py certificate.json. It prints a statement, of rational functions and square
roots of variables, and decides it: quotients and roots are letters, all positive, and an equation
is multiplied by what its quotients divide by until polynomials are left, which are compared.
"""

import ast
import json
import re
import sys
from fractions import Fraction
from functools import reduce
from keyword import iskeyword
from operator import add, mul, sub
from time import process_time
from typing import Any

FORMAT = "gainproof memory certificate 1"
GROWING = "N = sum of (H F^-i)' H F^-i, i = 0 .. n; V N = 1, K = V H', X = r V"
FADING = "N = sum of w^i (H F^-i)' H F^-i, i = 0, 1, ..; V N = 1, K = V H', X = r V Z V, P = F X F'"
MEANING = """samples y = H x + noise, of variance r, x being F times that before, in least squares
K is the gain, X the covariance of the estimate after a sample, P that of the prediction
growing: of the samples 0 .. n, n is whole; fading: a sample i steps old counts w^i times, 0 < w < 1
Z is N with w^2 for w; lines of `typed`, `convention`, `name` are what is said, not checked"""
MOST_BYTES, MOST_WORK, MOST_DEGREE, MOST_BITS, SECONDS = 1_000_000, 2_000_000, 150, 20_000, 20
MOST_TERMS = 50_000
TEXT = re.compile(r"(?a:(?!.*\b\d+[a-zA-Z_])[\w+*/()\[\],<>=! -]{0,20000})")
SUMS: Any = {ast.Add: add, ast.Sub: sub, ast.Mult: mul}
SIGNS = {ast.Eq: "==", ast.Gt: ">", ast.GtE: ">="}


def require(condition: object, *reason: object) -> None:
    if not condition:
        raise ValueError(" ".join(map(str, reason)))


class Poly(dict[tuple[str, ...], Any]):
    """Letters, sorted, each as often as its power -> a number that is not 0."""

    work, latest = 0, 0.0  # of all products so far, and when they have to be done

    def __add__(self, other: "Poly", factor: int = 1) -> "Poly":
        found = {m: self.get(m, 0) + factor * other.get(m, 0) for m in {**self, **other}}
        return Poly({m: c for m, c in found.items() if c})

    def __sub__(self, other: "Poly") -> "Poly":
        return self.__add__(other, -1)

    def __mul__(self, other: "Poly") -> "Poly":
        found = Poly()
        few, many = sorted((self, other), key=len)
        Poly.work += len(few) * len(many)
        require(Poly.work < MOST_WORK, "too much work")
        for a, x in many.items():
            require(len(found) < MOST_TERMS and process_time() < Poly.latest, "late, or too long")
            for b, y in few.items():
                m = tuple(sorted(a + b))
                found[m] = found.get(m, 0) + x * y
        long = any((c.numerator * c.denominator).bit_length() > MOST_BITS for c in found.values())
        require(not long and max(map(len, found), default=0) < MOST_DEGREE, "too long")
        return found + Poly()

    def __pow__(self, e: int) -> "Poly":
        return reduce(mul, [self] * e, ONE)

    def by_power(self, name: str) -> dict[int, "Poly"]:
        """What stands with each power of a letter."""
        found = dict[int, Poly]()
        for m, c in self.items():
            found.setdefault(m.count(name), Poly())[tuple(k for k in m if k != name)] = c
        return found

    def put(self, name: str, top: "Poly", bottom: "Poly") -> "Poly":
        """With a quotient for a letter, times the power of what that divides by."""
        parts = self.by_power(name)
        most = max(parts, default=0)
        return reduce(add, (p * top**e * bottom ** (most - e) for e, p in parts.items()), ZERO)


Matrix = list[list[Poly]]
ZERO, ONE = Poly(), Poly({(): 1})


def constant(c: Fraction | int) -> Poly:
    return Poly({(): c}) + ZERO


def turned(a: Matrix) -> Matrix:
    return [[*column] for column in zip(*a, strict=True)]


def product(a: Matrix, *more: Matrix) -> Matrix:
    for b in map(turned, more):
        a = [[reduce(add, (x * y for x, y in zip(r, c, strict=True))) for c in b] for r in a]
    return a


def less(a: Matrix, b: Matrix) -> Matrix:
    return [[x - y for x, y in zip(*rows, strict=True)] for rows in zip(a, b, strict=True)]


def times(c: Poly, a: Matrix) -> Matrix:
    return [[c * e for e in row] for row in a]


class Certificate:
    def __init__(self, data: Any) -> None:
        require(isinstance(data, dict) and data.get("format") == FORMAT, f"no {FORMAT}")
        self.data, Poly.work, Poly.latest = data, 0, process_time() + SECONDS
        self.meaning = dict[str, Any]()  # of names: polynomials, or matrices
        self.letters = dict[str, tuple[str, Poly]]()  # kind, and what it is made of: letters before
        self.low = dict[str, tuple[Fraction, bool]]()  # of variables; whether they may be that
        self.high = dict[str, Fraction]()
        self.lines, self.claims = list[str](), 0

    def decide(self) -> list[str]:
        """The lines to print. Raises ValueError and others where it is not so."""
        for title, text in self.data["lines"]:
            self.line(title, text)
        require(self.claims and "K" in self.meaning, "nothing is claimed of a memory")
        return [*self.lines, *MEANING.splitlines(), "proved"]

    def line(self, title: str, text: str) -> None:
        require(text.isprintable() and len(text) < 20_000 and "  " not in text, "what misleads")
        self.lines.append(f"{title + ':':<12}{text}")
        name, equals, said = (word.strip() for word in text.partition("="))
        new = name.isidentifier() and not iskeyword(name) and name not in self.meaning
        if title == "real" and new and not equals:
            self.letters[name], self.meaning[name] = ("real", ZERO), Poly({(name,): 1})
        elif title == "with" and new:
            self.meaning[name] = self.value(said, ast.List if said[:1] == "[" else ast.expr)
        elif title == "where":
            self.bound(*self.value(text, ast.Compare))
        elif title == "memory" and text in (GROWING, FADING):
            self.memory(text)
        elif title == "claim":
            p, sign = self.value(text, ast.Compare)
            require(sign == "==" and self.zero(p), "not shown:", text)
            self.claims += 1
        else:
            require(title in ("typed", "convention", "name"), "no line:", title)

    def bound(self, p: Poly, sign: str) -> None:
        """Of a variable by a number: one from below, one from above that is not reached."""
        ((name,),) = filter(None, p)
        end, above = Fraction(-p.get((), 0)) / p[(name,)], p[(name,)] < 0
        known = name in (self.high if above else self.low) or self.letters[name][0] != "real"
        require(not known and sign in ((">",) if above else (">", ">=")), "no bound")
        if above:
            self.high[name] = end
        else:
            self.low[name] = end, sign == ">="
        low, _ = self.low.get(name, (end - 1, False))
        require(low < self.high.get(name, low + 1), "no number is left")

    def value(self, node: Any, sort: type = ast.expr) -> Any:
        """The polynomial of an expression; of rows, or a relation and its sign, where wanted."""
        if isinstance(node, str):
            require(TEXT.fullmatch(node), "no expression:", node)
            node = ast.parse(node.strip(), mode="eval").body
        require(isinstance(node, sort) and process_time() < Poly.latest, "late, or no", sort)
        match node:
            case ast.Compare(left=a, ops=[op], comparators=[b]) if sort is ast.Compare:
                return self.value(a) - self.value(b), SIGNS[type(op)]
            case ast.Constant(value=number) if type(number) is int:
                return ONE * Poly({(): number})
            case ast.Name(id=name) if type(self.meaning.get(name)) is Poly:
                return self.meaning[name]
            case ast.Subscript(ast.Name(id=name), ast.Tuple([ast.Constant(i), ast.Constant(j)])):
                if type(i) is int and type(j) is int and min(i, j) > 0:
                    return self.meaning[name][i - 1][j - 1]
            case ast.List(elts=rows) if sort is ast.List:
                return [[self.value(e) for e in getattr(row, "elts", [None])] for row in rows]
            case ast.UnaryOp(op=ast.USub(), operand=a):
                return ZERO - self.value(a)
            case ast.BinOp(left=a, op=ast.Add() | ast.Sub() | ast.Mult() as op, right=b):
                return SUMS[type(op)](self.value(a), self.value(b))
            case ast.BinOp(a, ast.Pow(), ast.Constant(e)) if type(e) is int and e <= 64:
                return self.value(a) ** e
            case ast.BinOp(left=a, op=ast.Div(), right=b):
                return self.value(a) * self.inverse(b)
            case ast.Call(func=ast.Name(id="sqrt"), args=[a], keywords=[]):
                return self.letter("sqrt", self.value(a))
        raise ValueError(f"not known: {ast.unparse(node)}")

    def inverse(self, node: ast.expr) -> Poly:
        match node:
            case ast.BinOp(left=a, op=ast.Mult(), right=b):
                return self.inverse(a) * self.inverse(b)
            case ast.BinOp(a, ast.Pow(), ast.Constant(e)) if type(e) is int and e <= 64:
                return self.inverse(a) ** e
        p: Poly = self.value(node)
        if [*p] == [()]:
            return constant(1 / Fraction(p[()]))
        sign = constant(1 if self.positive(p) else -1)
        return sign * self.letter("over", sign * p)

    def letter(self, kind: str, inner: Poly) -> Poly:
        """The one of a reciprocal or root of what is positive."""
        known = (name for name, what in self.letters.items() if what == (kind, inner))
        name = next(known, f"{kind} {len(self.letters)}")
        require(name in self.letters or self.positive(inner), "not seen to be positive:", inner)
        self.letters[name] = kind, inner
        return Poly({(name,): 1})

    def positive(self, p: Poly) -> bool:
        """Whether it has no negative coefficient when variables are counted from their bounds."""
        free = set[str]()  # what may be 0 or less
        for name in [k for k, (kind, _) in self.letters.items() if kind == "real"]:
            low, closed = self.low.get(name, (None, True))
            free |= {name} if closed else set()
            if low is not None and name in self.high:  # (low + high v)/(1 + v)
                v = Poly({(name,): 1})
                p = p.put(name, constant(low) + constant(self.high[name]) * v, ONE + v)
            elif low is not None:
                p = p.put(name, constant(low) + Poly({(name,): 1}), ONE)
            elif any(m.count(name) % 2 for m in p):
                return False
        return all(c > 0 for c in p.values()) and any(not free & {*m} for m in p)

    def zero(self, p: Poly) -> bool:
        """Whether it is shown to be 0 on the whole domain."""
        require(process_time() < Poly.latest, "late")
        met = {name for m in p for name in m if self.letters[name][0] != "real"}
        if not met:
            return not p
        name = next(k for k in [*self.letters][::-1] if k in met)
        kind, inner = self.letters[name]
        if kind == "over":
            return self.zero(p.put(name, ONE, inner))
        parts = [ZERO, ZERO]  # a + b root, of which a - b root is not 0
        for e, q in p.by_power(name).items():
            parts[e % 2] = parts[e % 2] + q * inner ** (e // 2)
        a, b = parts
        unlike = any(self.positive(x) and self.positive(ZERO - y) for x, y in ((a, b), (b, a)))
        return (not b and self.zero(a)) or (unlike and self.zero(a * a - b * b * inner))

    def zeros(self, a: Matrix, exactly: bool = False) -> None:
        wrong = [e for row in a for e in row if (e if exactly else not self.zero(e))]
        require(not wrong, "not 0:", wrong)

    def memory(self, text: str) -> None:
        """Shows what N and V are; K and X have a meaning from then on, P of a fading memory."""
        f, h, n, v = (self.meaning[name] for name in "FHNV")
        r, size = self.meaning["r"], range(len(f))
        unit = [[ONE if i == j else ZERO for j in size] for i in size]
        require(self.positive(r) and not {*"KXP"} & {*self.meaning}, "r or a name")
        self.zeros([row[: i + 1] for i, row in enumerate(less(f, unit))], exactly=True)
        seen = product(turned([*h[:1]]), h)  # of one measurement
        self.zeros(less(product(v, n), unit))
        back = product(turned(f), less(n, seen), f)
        if text == GROWING:  # no term for n = -1, one more at each step: as polynomials
            fixed = {k for row in (*f, *h, [r]) for e in row for m in e for k in m}
            letters = fixed | {k for row in n for e in row for m in e for k in m}
            require({self.letters[k][0] for k in letters} <= {"real"}, "no polynomials")
            require("n" not in {*fixed, *self.high}, "what changes with n, or an n that has an end")
            self.zeros([[e.put("n", constant(-1), ONE) for e in row] for row in n], exactly=True)
            before = Poly({("n",): 1, (): -1})
            self.zeros(less(back, [[e.put("n", before, ONE) for e in row] for row in n]), True)
            self.meaning |= {"X": times(r, v), "P": None}
        else:  # w times itself moved on, and the last term: there is one such sum
            w, z = self.meaning["w"], self.meaning["Z"]
            require(self.positive(w) and self.positive(ONE - w), "w is not between 0 and 1")
            self.zeros(less(back, times(w, n)))
            self.zeros(less(product(turned(f), less(z, seen), f), times(w * w, z)))
            self.meaning["X"] = times(r, product(v, z, v))
            self.meaning["P"] = product(f, self.meaning["X"], turned(f))
        self.meaning["K"] = product(v, turned(h))


def main(arguments: list[str]) -> int:
    """0 if the certificate shows what it says, else 1."""
    try:
        with open(arguments[0], "rb") as file:
            lines = Certificate(json.loads(file.read(MOST_BYTES))).decide()
    except Exception as error:  # noqa: BLE001  whatever is wrong with it, it shows nothing
        lines = [f"REJECTED: {type(error).__name__}: {' '.join(ascii(str(error)).split()):.300}"]
    print("\n".join(lines).encode("ascii", "backslashreplace").decode())
    return int(lines[-1].startswith("REJECTED"))


if __name__ == "__main__":
    sys.exit(__doc__ if sys.argv[1:] in ([], ["-h"], ["--help"]) else main(sys.argv[1:]))
