"""Decides one certificate of an answer with Python alone. Usage: check_answer.py certificate.json

A certificate is a statement and its proof: sums of products of polynomials in variables, quotients,
roots, functions; or p q = 0 of analytic p and q on a convex domain, q not being 0 at a point of it.
"""

import ast
import json
import re
import sys
from fractions import Fraction
from functools import reduce
from keyword import iskeyword
from math import isqrt
from operator import add, mul, sub
from time import process_time
from typing import Any

FORMAT = "gainproof answer certificate 2"
MOST_BYTES, MOST_TERMS, MOST_DEGREE, MOST_BITS, SECONDS = 4_000_000, 200_000, 250, 20_000, 20
TEXT = re.compile(r"(?a:(?!.*\b\d+[a-zA-Z_])[\w+*/()\[\],<>=! -]{0,2000})")
SUMS: Any = {ast.Add: add, ast.Sub: sub, ast.Mult: mul}
SIGNS = {ast.Eq: "==", ast.NotEq: "!=", ast.Gt: ">", ast.GtE: ">="}
NOT = {"==": "!=", "!=": "==", ">": ">=", ">=": ">"}  # of -p
FILTER = "K S = PH', P = FXF' + Q, S = HPH' + R, X = P - KHP; Q >= 0, R > 0; F - FKH is stable"
GAINS = FILTER.replace("K S = PH'", "L = FL - FKHL + D").replace("KHP;", "KHP - PH'K' + KSK';")
KALMAN_BUCY = "dx/dt = Ax + w; KR = PH', AP + PA' + Q = KRK'; Q >= 0, R > 0; A - KH is stable"
FUNCTIONS, FINE = ("sqrt", "cos", "sin", "exp"), 1 << 200
VALUE = {"over": ("!=", ">"), "sqrt": (">=", ">", "==")}  # wanted of a divisor, a radicand


def require(condition: object, *reason: object) -> None:
    if not condition:
        raise ValueError(" ".join(map(str, reason)))


class Poly(dict[tuple[str, ...], Any]):
    """Letters, sorted, each as often as its power -> a number that is not 0."""

    def __add__(self, other: "Poly", factor: int = 1) -> "Poly":
        found = {m: self.get(m, 0) + factor * other.get(m, 0) for m in {**self, **other}}
        return Poly({m: c for m, c in found.items() if c})

    def __sub__(self, other: "Poly") -> "Poly":
        return self.__add__(other, -1)

    def __mul__(self, other: "Poly") -> "Poly":
        found = Poly()
        fine = max([1, *(c.denominator for p in (self, other) for c in p.values())]).bit_length()
        require(len(self) * len(other) * (1 + fine // 512) ** 2 < MOST_TERMS, "too many terms")
        for a, x in self.items():
            for b, y in other.items():
                m = tuple(sorted(a + b))
                found[m] = found.get(m, 0) + x * y
        long = any((c.numerator * c.denominator).bit_length() > MOST_BITS for c in found.values())
        require(not long and max(map(len, found), default=0) < MOST_DEGREE, "too long")
        return found + Poly()


Matrix = list[list[Poly]]
ZERO, ONE = Poly(), Poly({(): 1})


def product(a: Matrix, b: Matrix) -> Matrix:
    return [[reduce(add, (x * y for x, y in zip(r, c, strict=True))) for c in turned(b)] for r in a]


def turned(a: Matrix) -> Matrix:
    return [[*column] for column in zip(*a, strict=True)]


def less(a: Matrix, b: Matrix) -> Matrix:
    return [[x - y for x, y in zip(*rows, strict=True)] for rows in zip(a, b, strict=True)]


def symmetric(a: Matrix) -> list[Poly]:
    """Sums of products of 1, 2, 3 eigenvalues, as many as there are, by Newton's identities."""
    require(len(a) <= 3, "a matrix of more than 3 rows")
    powers = a, product(a, a), product(product(a, a), a)
    t1, t2, t3 = (reduce(add, (m[i][i] for i in range(len(a)))) for m in powers)
    e2 = (t1 * t1 - t2) * Poly({(): Fraction(1, 2)})
    return [t1, e2, (e2 * t1 - t1 * t2 + t3) * Poly({(): Fraction(1, 3)})][: len(a)]


def series(name: str, x: Fraction, end: int) -> Fraction:
    """A bound of exp, sin or cos; beyond k = 2 |x| each term is at most half of the one before."""
    require(abs(x) <= 40, f"{name} of a large number")
    signs = {"exp": (1, 1, 1, 1), "cos": (1, 0, -1, 0), "sin": (0, 1, 0, -1)}[name]
    term, total, k = Fraction(1), Fraction(0), 0
    while k < 2 * abs(x) + 2 or abs(term) * (1 << 160) > 1:
        total, k, term = total + signs[k % 4] * term, k + 1, term * x / (k + 1)
    return total + 2 * end * abs(term)


class Certificate:
    def __init__(self, data: Any) -> None:
        require(isinstance(data, dict) and data.get("format") == FORMAT, f"no {FORMAT}")
        self.meaning: dict[str, Any] = {"S": None, "X": None}  # of names: polynomials, or matrices
        self.letters = dict[str, tuple[str, Poly]]()  # kind, and what it is made of
        self.ends = dict[str, tuple[Fraction, Fraction]]()  # round the letters at a point
        self.facts, self.wanted = list[tuple[Poly, str]](), list[tuple[Poly, str]]()  # p == 0, > 0
        self.lines, self.verdicts, self.latest = list[str](), set[str](), process_time() + SECONDS
        self.data, self.straight = data, True  # the domain is convex, and letters analytic

    def decide(self) -> list[str]:
        """The lines to print. Raises ValueError and others where it is not so."""
        for title, *said in self.data["lines"]:
            self.line(title, *said)
        for p, sign in self.wanted:
            require((p, sign) in self.facts and process_time() < self.latest, "not shown:", p, sign)
        require(len(self.verdicts) == 1, "nothing is claimed, or what is true and what is false")
        return [*self.lines, *self.verdicts]

    def line(self, title: str, *said: Any) -> None:
        """Reads one more: a step of the proof, or what is printed."""
        if title in ("shows", "opens", "sums"):
            getattr(self, title)(*said)
            return
        (text,) = said
        require(text.isprintable() and len(text) < 4000 and "  " not in text, "what misleads")
        self.lines.append(f"{title + ':':<12}{text}")
        name, equals, value = (word.strip() for word in text.partition("="))
        new = name.isidentifier() and not iskeyword(name) and name not in self.meaning
        if title == "real" and new and not equals:
            self.letters[name], self.meaning[name] = ("real", ZERO), Poly({(name,): 1})
        elif title == "with" and new:
            p = self.value(value, ast.List if value[:1] == "[" else ast.expr)
            self.meaning[name] = self.letter(name, "part", p) if len(p) > 40 else p
        elif title == "filter" and text in (FILTER, GAINS, KALMAN_BUCY):
            self.filter(text)
        elif title == "where":
            p, sign = self.value(text, ast.Compare)
            a, b = self.enclosed(p)
            met = {"==": a == b == 0, "!=": a * b > 0, ">": a > 0, ">=": a >= 0}
            require(met[sign], "the point is outside the domain")
            flat = all(len(m) < 2 and {self.letters[k][0] for k in m} <= {"real"} for m in p)
            self.straight = self.straight and flat and sign != "!="
            self.facts.append((p, sign))
        elif title not in ("typed", "convention", "name"):
            p, sign = self.value(text, ast.Compare)
            self.verdicts.add({"claim": "proved", "false": "refuted"}[title])
            self.wanted.append((p, sign) if title == "claim" else (ZERO - p, NOT[sign]))

    def value(self, node: Any, sort: type = ast.expr) -> Any:
        """The polynomial of an expression; of a list, or a relation and its sign, where wanted."""
        if isinstance(node, str):
            require(TEXT.fullmatch(node), "no expression:", node)
            node = ast.parse(node.strip(), mode="eval").body
        require(isinstance(node, sort) and process_time() < self.latest, "late, or no", sort)
        match node:
            case ast.Compare(left=a, ops=[op], comparators=[b]) if sort is ast.Compare:
                return self.value(a) - self.value(b), SIGNS[type(op)]
            case ast.Constant(value=number) if type(number) is int:
                return ONE * Poly({(): number})
            case ast.Name() | ast.Subscript() if type(self.meaning.get(ast.unparse(node))) is Poly:
                return self.meaning[ast.unparse(node)]
            case ast.List(elts=parts) if sort is ast.List:
                return [self.value(p, ast.List if type(p) is ast.List else ast.expr) for p in parts]
            case ast.UnaryOp(op=ast.USub(), operand=operand):
                return ZERO - self.value(operand)
            case ast.BinOp(left=a, op=ast.Add() | ast.Sub() | ast.Mult() as op, right=b):
                return SUMS[type(op)](self.value(a), self.value(b))
            case ast.BinOp(a, ast.Pow(), ast.Constant(e)) if type(e) is int and e <= 64:
                return reduce(mul, [self.value(a)] * e, ONE)
            case ast.BinOp(left=a, op=ast.Div(), right=b):
                top, bottom = self.value(a), self.value(b)
                if [*bottom] == [()]:
                    return top * Poly({(): 1 / Fraction(bottom[()])})
                return top * self.letter(f"1/({ast.unparse(b)})", "over", bottom)
            case ast.Call(func=ast.Name(id=kind), args=[a], keywords=[]) if kind in FUNCTIONS:
                return self.letter(ast.unparse(node), kind, self.value(a))
        raise ValueError(f"not known: {ast.unparse(node)}")

    def letter(self, name: str, kind: str, inner: Poly) -> Poly:
        """A new letter, of which it is wanted that it has a value, or the one that is the same."""
        name = next((k for k, what in self.letters.items() if what == (kind, inner)), name)
        if name not in self.letters:
            self.letters[name] = kind, inner
            self.facts += [(Poly({(name,): 1}) - inner, "==")] if kind == "part" else []
            self.wanted += [(inner, VALUE[kind][0])] if kind in VALUE else []
        return Poly({(name,): 1})

    def filter(self, text: str) -> None:
        """Wants what the sentence says; entries of P, K, S, X, L have a meaning from then on."""
        steps, lag = text != KALMAN_BUCY, self.meaning["L"] if text == GAINS else []
        f, h, q, r, p, k = (self.meaning[name] for name in ("FHQRPK" if steps else "AHQRPK"))
        fp, ph, kh, kr = product(f, p), product(p, turned(h)), product(k, h), product(k, r)
        s, x = less(product(h, ph), less(less(r, r), r)), less(p, product(kh, p))
        zero = gap = less(ph, product(k, s))
        if text == GAINS:
            x, moved = less(x, product(gap, turned(k))), less(lag, product(kh, lag))
            zero = less(less(lag, product(f, moved)), self.meaning["D"])
        if steps:
            zero = [*zero, *less(less(p, product(product(f, x), turned(f))), q)]
            a, b, c = [*symmetric(less(f, product(f, kh))), ZERO, ZERO][:3]
            stable = [ONE + a + b + c, ONE - a + b - c, ONE + c, ONE - c, ONE - b + a * c - c * c]
        else:
            zero = [*less(kr, ph), *less(less(less(product(kr, turned(k)), q), fp), turned(fp))]
            stable = symmetric(less(kh, f)) + [ZERO] * (len(f) > 2)  # of 1 or 2 states
        zero += [row for a in (p, q, r) for row in less(a, turned(a))]
        for name, matrix in zip("PKSXL", (p, k, s, x, lag) if steps else (p, k), strict=False):
            for i, row in enumerate(matrix, 1):
                self.meaning |= {f"{name}[{i}, {j}]": e for j, e in enumerate(row, 1)}
        self.wanted += [(e, "==") for row in zero for e in row] + [(e, ">=") for e in symmetric(q)]
        self.wanted += [(e, ">") for e in (*symmetric(r), *stable)]

    def ends_of(self, name: str) -> tuple[Fraction, Fraction]:
        kind, inner = self.letters[name]
        a, b = self.enclosed(inner)
        if kind == "real":
            a = b = self.poly([[self.data["point"][name]]]).get((), Fraction(0))
        elif kind == "over":
            require(a * b > 0, "a divisor that may be 0 at the point")
            a, b = 1 / b, 1 / a
        elif kind == "sqrt":
            a, b = (Fraction(isqrt(int(x * FINE**2)) + up, FINE) for up, x in enumerate((a, b)))
        elif kind != "part":
            wide = 0 if kind == "exp" else b - a  # sine and cosine have a slope of at most 1
            a, b = series(kind, a, -1) - wide, series(kind, b, 1) + wide
        rounded = Fraction(a * FINE // 1, FINE), -Fraction(-b * FINE // 1, FINE)
        return (a, b) if a == b and a.denominator < FINE else rounded

    def enclosed(self, p: Poly) -> tuple[Fraction, Fraction]:
        low = high = Fraction(0)
        for m, c in p.items():
            require(process_time() < self.latest, "late")
            a = b = Fraction(c)
            for name in m:
                self.ends[name] = self.ends.get(name) or self.ends_of(name)
                ends = [x * y for x in (a, b) for y in self.ends[name]]
                a, b = min(ends), max(ends)
            low, high = low + a, high + b
        return low, high

    def poly(self, said: Any) -> Poly:
        """Of terms [number, letter, letter, ...]; a number is [top, bottom]."""
        return Poly({tuple(sorted(m)): Fraction(*map(int, c)) for c, *m in said}) + ZERO

    def term(self, number: Any, facts: list[int], other: Any = (([1],),)) -> tuple[Poly, str]:
        """A number times facts times a square, or any polynomial if a fact is 0; its sign."""
        signs = {self.facts[k][1] for k in facts}
        root, scale = self.poly(other), self.poly([[number]])
        require(scale and process_time() < self.latest, "late, or a term that is 0")
        value = reduce(mul, [self.facts[k][0] for k in facts], scale * root)
        if "==" in signs:
            return value, "=="
        signs |= {">" if scale[()] > 0 else "!=", ">" if root == ONE else ">="}
        ranks = (">", {">"}), (">=", {">", ">="}), ("!=", {">", "!="})
        return value * root, next((s for s, among in ranks if signs <= among), "")

    def shows(self, said: Any, sign: str, factor: Any, terms: Any, by: Any = None) -> None:
        """A polynomial has this sign, since a factor (or any polynomial) times it is a sum."""
        p, (times, its) = self.poly(said), self.term(*factor) if by is None else (self.poly(by), "")
        found = [self.term(*term) for term in terms]
        total = reduce(sub, [value for value, _ in found], times * p)
        signs = [s for _, s in found if s != "=="]
        weak = {*signs} <= {">", ">="}
        more = weak and (its in (">", ">=") and ">" in signs if sign == ">" else its == ">")
        fine = not signs and its in (">", "!=") if sign == "==" else signs in ([">"], ["!="])
        fine = more if sign in (">", ">=") else fine and sign in ("==", "!=")
        if total or not fine:  # by a sign at the point
            low, high = self.enclosed(times if sign == "==" else p)
            kept = low > 0 and sign == ">" and its == ">" and signs == ["!="]
            kept = kept or (low * high > 0 and sign == "==" and not signs)
            fine = kept and self.straight and not total
            fine = fine or (low > 0 and sign == ">" and "real" not in dict(self.letters.values()))
        require(fine, "not so:", said, sign, 0)
        self.facts.append((p, sign))

    def opens(self, name: str, by: int) -> None:
        """A letter has a value, since a fact says so of its divisor or radicand."""
        ((name,),) = self.value(name)
        (kind, inner), (p, sign), me = self.letters[name], self.facts[by], Poly({(name,): 1})
        require(p == inner and sign in VALUE[kind], "no value is shown of", name)
        self.straight = self.straight and sign in (">", "!=")
        self.facts.append((me * p - ONE if kind == "over" else me * me - p, "=="))
        self.facts += [(me, ">" if sign == ">" else ">=")] if kind == "sqrt" else []

    def sums(self, *texts: str) -> None:
        """Theorems of addition for x + y = z."""
        x, y, z = (self.value(text) for text in texts)
        require(x + y == z, "no sum")
        values = ([self.value(f"{f}({text})") for text in texts] for f in FUNCTIONS[1:])
        (c1, c2, c3), (s1, s2, s3), (e1, e2, e3) = values
        zero = c1 * c1 + s1 * s1 - ONE, c3 - c1 * c2 + s1 * s2, s3 - s1 * c2 - c1 * s2, e3 - e1 * e2
        self.facts += [(p, "==") for p in zero] + [(e, ">") for e in (e1, e2, e3)]


def main(arguments: list[str]) -> int:  # 0 if the certificate shows what it says, else 1
    try:
        with open(arguments[0], "rb") as file:
            lines = Certificate(json.loads(file.read(MOST_BYTES))).decide()
    except Exception as error:  # noqa: BLE001  whatever is wrong with it, it shows nothing
        lines = [f"REJECTED: {type(error).__name__}: {' '.join(ascii(str(error)).split()):.300}"]
    print("\n".join(lines).encode("ascii", "backslashreplace").decode())
    return int(lines[-1].startswith("REJECTED"))


if __name__ == "__main__":
    sys.exit(__doc__ if sys.argv[1:] in ([], ["-h"], ["--help"]) else main(sys.argv[1:]))
