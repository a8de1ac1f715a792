"""Decides one certificate of an answer: `python check_answer.py certificate.json`.

This file needs Python alone. A certificate is data: a formula, what its letters stand for, a domain
and, of a filter, its model. All of it is printed from the expressions that are checked; then comes
`proved`, `refuted` (false at the point that is printed) or `REJECTED: reason`. Whether the formula
as typed says the same as the formula as checked is for the reader to see.

Expressions become polynomials in letters, of which some stand for roots (t^n = polynomial) or for
divisors (t polynomial = 1). These are eliminated by multiplying, the last one first, until 0 is
left. Where p q = 0 and q is not 0 at one point, p = 0: on a product of intervals on which no
divisor and no radicand vanishes all is analytic. A sign is seen from coefficients of one sign once
variables are moved to (0, infinity), or at one point of what has no zero.
"""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import reduce
from io import TextIOWrapper
from math import isqrt, lcm
from operator import or_
from typing import Any

FORMAT = "gainproof answer certificate 1"
MOST_BYTES, MOST_NODES, MOST_DIGITS, MOST_LETTERS = 4_000_000, 40_000, 400, 250
MOST_POWER, MOST_DEGREE, MOST_WORK, MOST_BITS = 64, 1000, 3_000_000, 20_000
FIELD = 16  # bits of an exponent; a monomial is a number, whose lowest field is the degree
NO_VALUES = "that every part has a value is not shown"
HOLDS = {"=": (0,), "!=": (1, -1), "<": (-1,), "<=": (-1, 0), ">": (1,), ">=": (1, 0)}

GREEK = (
    "(?:var)?(?:[Aa]lpha|[Bb]eta|[Gg]amma|[Dd]elta|[Ee]psilon|[Zz]eta|[Ee]ta|[Tt]heta|[Ii]ota|[Kk]appa"
    "|[Ll]ambda|[Mm]u|[Nn]u|[Xx]i|[Pp]i|[Rr]ho|[Ss]igma|[Tt]au|[Uu]psilon|[Pp]hi|[Cc]hi|[Pp]si|[Oo]mega)"
)
SIGN = rf"(?:[A-Za-z0-9]+|\\{GREEK})"
ACCENT = r"\\(?:hat|bar|tilde|dot|ddot|check|breve|vec|mathrm|mathbf|mathcal|text|ell)"
PLAIN = re.compile(
    rf"(?:[A-Za-z][A-Za-z0-9]*|\\{GREEK}|{ACCENT}(?:{{{SIGN}}})?)'*"
    rf"(?:_(?:{SIGN}|{{(?:{SIGN}|[,_])+}}))*'*(?:\[[0-9],[0-9]\])?"
)
ENTRY = re.compile(r"[PKSX]\[[0-9]+,[0-9]+\]")  # what a model gives a meaning to

Poly = dict[int, Any]  # monomial -> whole number or fraction, not 0
Ball = tuple[int, int]  # ends in units of 2^-bits
Box = tuple[Fraction | None, bool, Fraction | None, bool]  # ends, and whether they are left out
Matrix = Sequence[Sequence[Poly]]
ONE: Poly = {0: 1}
POSITIVE: Box = (Fraction(0), True, None, True)


class Rejected(Exception):
    """Why a certificate does not show what it says."""


def require(condition: object, reason: str) -> None:
    if not condition:
        raise Rejected(reason)


def rational(text: object) -> Fraction:
    parts = text.removeprefix("-").split("/") if isinstance(text, str) else []
    fine = all(p.isascii() and p.isdigit() and len(p) <= MOST_DIGITS for p in parts)
    require(len(parts) in (1, 2) and fine and int((*parts, "1")[1]), f"no number: {text!r:.60}")
    return Fraction(str(text))


def exponent(m: int, k: int) -> int:
    return m >> FIELD * (k + 1) & (1 << FIELD) - 1


def power_of(k: int, e: int = 1) -> int:
    return e + (e << FIELD * (k + 1))


def degree(p: Poly) -> int:
    return max((m & (1 << FIELD) - 1 for m in p), default=0)


def plus(p: Poly, q: Poly, factor: int = 1) -> Poly:
    found = dict(p)
    for m, c in q.items():
        found[m] = found.get(m, 0) + factor * c
    return {m: c for m, c in found.items() if c}


def parts_of(p: Poly, k: int) -> dict[int, Poly]:
    """The coefficients of the powers of a letter."""
    found: dict[int, Poly] = {}
    for m, c in p.items():
        e = exponent(m, k)
        found.setdefault(e, {})[m - power_of(k, e)] = c
    return found


def root_of(value: int, n: int) -> int:
    """The largest whole number whose n-th power is at most the value, which is not negative."""
    if n == 2:
        return isqrt(value)
    low, high = 0, 1 << value.bit_length() // n + 1
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if middle**n <= value else (low, middle)
    return low


def enclosed(value: Fraction | int, bits: int) -> Ball:
    top = value.numerator << bits
    return top // value.denominator, -(-top // value.denominator)


def series(name: str, x: Fraction, bits: int) -> Ball:
    """exp, sin or cos; beyond k = 2 |x| each term is at most half of the one before."""
    if abs(x) > 40 or bits > 512:
        raise ArithmeticError(f"{name} of a large number")
    signs = {"exp": (1, 1, 1, 1), "cos": (1, 0, -1, 0), "sin": (0, 1, 0, -1)}[name]
    term, total, k = Fraction(1), Fraction(0), 0
    while k < 2 * abs(x) + 2 or abs(term) * (1 << bits) > 1:
        total, k = total + signs[k % 4] * term, k + 1
        term = term * x / k
    return enclosed(total - 2 * abs(term), bits)[0], enclosed(total + 2 * abs(term), bits)[1]


def bracketed(text: str, signs: str) -> str:
    return f"({text})" if text[0] == "-" or any(sign in text for sign in signs) else text


class Algebra:
    """Polynomials in letters, and what can be shown of these on a box.

    A letter is (kind, detail, polynomial): "variable" with its name; "root" of an order, "over",
    "exp", "sin" and "cos" of the polynomial, and "short" for a long one that is a number.
    """

    def __init__(self, unit: int) -> None:
        self.unit, self.work = unit, 0
        self.boxes: dict[str, Box] = {}
        self.whole: set[str] = set()
        self.letters: list[tuple[str, Any, Poly]] = []
        self.places: dict[Any, int] = {}
        self.meaning: dict[str, Poly] = {}
        self.signs: dict[Any, int] = {}
        self.long: list[str] = []
        self.numbers: dict[tuple[int, int], Ball] = {}
        self.fixed: set[int] = set()

    def read(self, graph: Any) -> tuple[Poly, str]:
        """A list of nodes, each made of nodes before it: value and text of the last one."""
        require(isinstance(graph, list) and 0 < len(graph) <= MOST_NODES, "no list of nodes")
        read: list[tuple[Poly, str]] = []
        for entry in graph:
            fine = isinstance(entry, list) and all(type(e) in (int, str) for e in entry)
            require(fine and len(entry) <= 500, f"no node: {entry!r:.60}")
            parts = [e for e in entry if type(e) is int]
            require(all(0 <= k < len(read) for k in parts), "a part that does not come before")
            words, values = [e for e in entry if type(e) is str], [read[k][0] for k in parts]
            value, text = self.node(words, values, [read[k][1] for k in parts])
            if len(value) > 30 and not self.variables(value):
                value = self.letter("short", None, value)
            if len(text) > 240:
                if text not in self.long:
                    self.long.append(text)
                    require(len(self.long) <= 1500, "too long to be printed")
                text = f"#{self.long.index(text) + 1}"
            read.append((value, text))
        return read[-1]

    def node(self, words: list[str], p: list[Poly], t: list[str]) -> tuple[Poly, str]:
        match words, p:
            case ["number", value], []:
                number = rational(value)
                return self.constant(number), str(number)
            case ["symbol", name], []:
                require(name in self.meaning, f"nothing is said of {name}")
                return self.meaning[name], named(name)
            case ["add"], [found, *more] if more:
                for other in more:
                    self.spend(len(found) + len(other))
                    found = plus(found, other)
                rest = (f" - {x[1:]}" if x[0] == "-" else f" + {x}" for x in t[1:])
                return found, t[0] + "".join(rest)
            case ["mul"], [found, *more] if more:
                for other in more:
                    found = self.times(found, other)
                return found, " * ".join(bracketed(x, "+-") for x in t)
            case ["neg"], [a]:
                return plus({}, a, -1), f"-{bracketed(t[0], '+-')}"
            case ["div"], [a, b]:
                text = f"{bracketed(t[0], '+-')} / {bracketed(t[1], '+-*/ ')}"
                return self.times(a, self.over(b)), text
            case ["pow", value], [a]:
                e = rational(value)
                require(abs(e.numerator) <= MOST_POWER and e.denominator <= 3, f"a power {e}")
                base = a if e.denominator == 1 else self.letter("root", e.denominator, a)
                found = self.raised(base if e >= 0 else self.over(base), abs(e.numerator))
                power = f"{bracketed(t[0], '+-*/^ ')}^{bracketed(str(e), '/')}"
                return found, f"sqrt({t[0]})" if e == Fraction(1, 2) else power
            case ["call", "tan"], [a]:
                tangent = self.times(self.angle("sin", a), self.over(self.angle("cos", a)))
                return tangent, f"tan({t[0]})"
            case ["call", ("sin" | "cos" | "exp") as name], [a]:
                return self.angle(name, a), f"{name}({t[0]})"
        raise Rejected(f"not known: {' '.join(words)[:60]} of {len(p)}")

    def constant(self, value: Fraction) -> Poly:
        return {0: int(value) if value.denominator == 1 else value} if value else {}

    def letter(self, kind: str, detail: Any, p: Poly) -> Poly:
        key = kind, detail, frozenset(p.items())
        if key not in self.places:
            if kind == "sin":
                self.letter("cos", None, p)  # of which its square is made
            require(len(self.letters) < MOST_LETTERS, f"more than {MOST_LETTERS} letters")
            self.places[key] = len(self.letters)
            self.letters.append((kind, detail, p))
            if kind != "variable" and not self.variables(p):
                self.fixed.add(self.places[key])
        return {power_of(self.places[key]): 1}

    def over(self, p: Poly) -> Poly:
        """One over it, letters that are a factor each for itself."""
        require(p, "a divisor is 0")
        found = {0: 1 / Fraction(p[max(p)])}
        p = self.times(p, found)
        for k in range(len(self.letters)):
            e = min(exponent(m, k) for m in p)
            if e:
                each = self.letter("over", None, {power_of(k): 1})
                found = self.times(found, self.raised(each, e))
                p = {m - power_of(k, e): c for m, c in p.items()}
        return found if p == ONE else self.times(found, self.letter("over", None, p))

    def angle(self, name: str, p: Poly) -> Poly:
        """exp, sin or cos by the theorems of addition, from unit parts of each term."""
        cosine, sine = ONE, dict[int, Any]()
        for m, c in p.items():
            count = Fraction(c) * self.unit if m else Fraction(1)
            require(count.denominator == 1 and abs(count) <= 24, f"{name} of {count} parts")
            part = {m: Fraction(1, self.unit) if m else c}
            for _ in range(abs(int(count))):
                if name == "exp":
                    e = self.letter("exp", None, part)
                    cosine = self.times(cosine, e if count > 0 else self.over(e))
                    continue
                c1, s1 = self.letter("cos", None, part), self.letter("sin", 2, part)
                s1 = s1 if count > 0 else plus({}, s1, -1)
                both = self.times(sine, s1)
                sine = plus(self.times(sine, c1), self.times(cosine, s1))
                cosine = plus(self.times(cosine, c1), both, -1)
        return sine if name == "sin" else cosine

    def times(self, p: Poly, q: Poly) -> Poly:
        self.spend(len(p) * len(q))
        require(degree(p) + degree(q) < MOST_DEGREE, "polynomials of too high degree")
        ends = (end for r in (p, q) for c in r.values() for end in (c.numerator, c.denominator))
        long = any(abs(end) >> MOST_BITS for end in ends)
        require(not long, "numbers that are too long")
        found: Poly = {}
        for a, x in p.items():
            for b, y in q.items():
                found[a + b] = found.get(a + b, 0) + x * y
        return self.reduced({m: c for m, c in found.items() if c})

    def spend(self, work: int) -> None:
        self.work += work
        require(self.work < MOST_WORK, "too much work")

    def raised(self, p: Poly, e: int) -> Poly:
        found = ONE
        for _ in range(e):
            found = self.times(found, p)
        return found

    def replaced(self, p: Poly, k: int, value: Poly) -> Poly:
        """With a value for a letter, in what other letters stand for too."""
        total: Poly = {}
        for m, c in p.items():
            term: Poly = {0: c}
            for j in range(m.bit_length() // FIELD):
                if e := exponent(m, j):
                    kind, detail, inner = self.letters[j]
                    each = {power_of(j): 1}
                    if j == k:
                        each = value
                    elif k in self.below(each):
                        each = self.replaced(inner, k, value)
                        each = (
                            self.over(each) if kind == "over" else self.letter(kind, detail, each)
                        )
                    term = self.times(term, self.raised(each, e))
            total = plus(total, term)
        return total

    def reduced(self, p: Poly) -> Poly:
        """With powers of roots below their order, and of sines below 2."""
        for k in range(reduce(or_, p, 0).bit_length() // FIELD - 1, -1, -1):
            kind, n, inner = self.letters[k]
            if kind in ("root", "sin") and any(exponent(m, k) >= n for m in p):
                if kind == "sin":
                    cosine = self.places["cos", None, frozenset(inner.items())]
                    inner = {0: 1, power_of(cosine, 2): -1}
                total: Poly = {}
                for e, part in parts_of(p, k).items():
                    left = {m + power_of(k, e % n): c for m, c in part.items()}
                    total = plus(total, self.times(left, self.raised(inner, e // n)))
                p = total
        return p

    def below(self, p: Poly) -> set[int]:
        """The letters in it, and in what these stand for."""
        waiting, found = [p], set[int]()
        while waiting:
            every = reduce(or_, waiting.pop(), 0)
            new = {k for k in range(every.bit_length() // FIELD) if exponent(every, k)} - found
            waiting += [self.letters[k][2] for k in new]
            found |= new
        return found

    def variables(self, p: Poly) -> bool:
        return any(self.letters[k][0] == "variable" for k in self.below(p))

    def last(self, p: Poly, *kinds: str) -> int | None:
        every = reduce(or_, p, 0)
        mine = (k for k, letter in enumerate(self.letters) if letter[0] in kinds)
        return max((k for k in mine if exponent(every, k)), default=None)

    def cleared(self, p: Poly, signed: bool = False) -> tuple[Poly, int]:
        """p times powers of its divisors, and if wanted the sign of these, 0 where not known."""
        sign = 1
        while (k := self.last(p, "over")) is not None:
            parts, total = parts_of(p, k), dict[int, Any]()
            for e, part in parts.items():
                total = plus(
                    total, self.times(part, self.raised(self.letters[k][2], max(parts) - e))
                )
            sign *= self.sign(self.letters[k][2]) ** max(parts) if signed else 0
            p = total
        common = lcm(*(Fraction(c).denominator for c in p.values()))
        return {m: int(c * common) for m, c in p.items()}, sign

    def conjugate(self, p: Poly, k: int) -> Poly:
        """What makes its product with p free of a root."""
        n, parts = self.letters[k][1], parts_of(p, k)
        terms = [{m + power_of(k, e): c for m, c in parts.get(e, {}).items()} for e in range(n)]
        if n == 2:
            return plus(terms[0], terms[1], -1)
        found: Poly = {}
        for e, u in enumerate(terms):
            found = plus(plus(found, self.times(u, u)), self.times(u, terms[e - 1]), -1)
        return found

    # what holds on the whole box

    def vanishes(self, p: Poly) -> bool:
        """Whether it is seen to be 0 wherever it has a value."""
        p = self.cleared(self.reduced(p))[0]
        k = self.last(p, "root", "short")
        if not p or k is None:
            return not p
        if self.letters[k][0] == "short":
            return self.vanishes(self.replaced(p, k, self.letters[k][2]))
        q = self.conjugate(p, k)
        return self.vanishes(self.times(p, q)) and self.analytic(p) and self.seen(q) != 0

    def analytic(self, p: Poly) -> bool:
        """Whether it is a number, or all its letters are analytic on the whole box."""
        letters = [self.letters[k] for k in self.below(p)]
        fine = (k == "variable" or (k in ("root", "over") and self.sign(q)) for k, _, q in letters)
        return all(fine) or not self.variables(p)

    def points(self) -> Iterator[dict[str, Fraction]]:
        for spread in ((1, 2, 3, 5, 7), (2, 1, 5, 1, 4), (13, 3, 11, 17, 6), (3, 2, 1, 9, 1)):
            point = {}
            for k, (name, (low, _, high, _)) in enumerate(self.boxes.items()):
                step = Fraction(spread[k % 5] + k // 5)
                if low is not None and high is not None:
                    point[name] = low + (high - low) * step / (step + 1)
                elif low is None and high is None:
                    point[name] = step - Fraction(7, 2)
                else:
                    point[name] = low + step if low is not None else (high or 0) - step
                if name in self.whole:
                    point[name] = Fraction(point[name] // 1)
            yield point

    def seen(self, p: Poly) -> int:
        """The sign at a point, the first at which it is seen not to be 0; else 0."""
        for bits in (64, 256, 1024, 2048):
            for point in self.points():
                try:
                    low, high = self.value(p, point, bits, {})
                except ArithmeticError:
                    continue
                if low > 0 or high < 0:
                    return 1 if low > 0 else -1
        return 0

    def value(self, p: Poly, point: dict[str, Fraction], bits: int, known: dict[int, Ball]) -> Ball:
        """An interval round the value at a point. Raises ArithmeticError where there is none."""
        low = high = 0
        self.spend(len(p) * (1 + degree(p)) * (1 + bits // 512) // 4)
        for m, c in p.items():
            term = enclosed(c, bits)
            for k in range(m.bit_length() // FIELD):
                for _ in range(exponent(m, k)):
                    if k not in known:
                        known[k] = self.letter_value(k, point, bits, known)
                    ends = [x * y for x in term for y in known[k]]
                    term = min(ends) >> bits, -(-max(ends) >> bits)
            low, high = low + term[0], high + term[1]
        return low, high

    def letter_value(
        self, k: int, point: dict[str, Fraction], bits: int, known: dict[int, Ball]
    ) -> Ball:
        if k in self.fixed:
            if (k, bits) not in self.numbers:
                self.numbers[k, bits] = self.own_value(k, point, bits, known)
            return self.numbers[k, bits]
        return self.own_value(k, point, bits, known)

    def own_value(
        self, k: int, point: dict[str, Fraction], bits: int, known: dict[int, Ball]
    ) -> Ball:
        kind, n, inner = self.letters[k]
        if kind == "variable":
            return enclosed(point[n], bits)
        low, high = self.value(inner, point, bits, known)
        if kind == "over":
            if low <= 0 <= high:
                raise ArithmeticError("a divisor that may be 0")
            return (1 << 2 * bits) // high, -(-(1 << 2 * bits) // low)
        if kind == "root":
            if low < 0 and (n == 2 or high > 0):
                raise ArithmeticError("a root of what may be negative")
            ends = [root_of(abs(end) << bits * (n - 1), n) for end in (low, high)]
            return (ends[0], ends[1] + 1) if high > 0 or not low else (-ends[0] - 1, -ends[1])
        if kind == "short":
            return low, high
        self.spend(20_000)
        first = series(kind, Fraction(low, 1 << bits), bits)
        if kind == "exp":
            return first[0], series(kind, Fraction(high, 1 << bits), bits)[1]
        return first[0] - (high - low), first[1] + (high - low)  # the slope is at most 1

    def sign(self, p: Poly, strict: bool = True) -> int:
        """1 or -1 where it has this sign on the whole box (or is 0, if not strict); else 0."""
        key = strict, frozenset(p.items())
        if key not in self.signs:
            self.signs[key] = 0  # what rests on itself is not shown
            self.signs[key] = self.own_sign(self.reduced(p), strict)
        return self.signs[key]

    def own_sign(self, p: Poly, strict: bool) -> int:
        found = self.by_coefficients(p, self.boxes, strict, 30)
        if found or not p:
            return found
        if not self.variables(p):
            return self.seen(p)
        if self.last(p, "over") is not None:
            less, sign = self.cleared(p, signed=True)
            return sign and sign * self.sign(less, strict)
        k = self.last(p, "root")
        if k is None or not self.analytic(p) or not self.sign(self.times(p, self.conjugate(p, k))):
            return 0
        return self.seen(p)

    def by_coefficients(self, p: Poly, boxes: dict[str, Box], strict: bool, halvings: int) -> int:
        """The sign that all coefficients have once variables are moved to (0, infinity), and that
        it has on closed ends; of polynomials in one variable the interval is halved where needed.
        """
        self.spend(len(p) * (1 + len(self.letters) // 8))
        for k, (kind, name, _) in enumerate(self.letters):
            low, low_open, high, high_open = boxes[name] if kind == "variable" else POSITIVE
            unsaid = low is None and high is None
            alone = halvings > 0 and self.below(p) == {k}
            if kind != "variable" or unsaid or not self.has(p, k):
                continue
            if boxes[name] == POSITIVE and not alone:
                continue
            signs = set()
            for end, left_out in ((low, low_open), (high, high_open)):
                if strict and end is not None and not left_out:
                    signs.add(self.by_coefficients(self.moved(p, k, end, end), boxes, strict, 0))
            if low is None or high is None or low < high:
                inner = self.moved(p, k, low, high)
                signs.add(self.by_coefficients(inner, {**boxes, name: POSITIVE}, strict, 0))
            if 0 in signs and alone and low != high:
                middle = self.middle(low, high)
                halves = (low, low_open, middle, False), (middle, False, high, high_open)
                signs = {
                    self.by_coefficients(p, {**boxes, name: half}, strict, halvings - 1)
                    for half in halves
                }
            return signs.pop() if len(signs) == 1 else 0
        return self.of_coefficients(p, boxes, strict)

    def has(self, p: Poly, k: int) -> bool:
        return any(exponent(m, k) for m in p)

    def middle(self, low: Fraction | None, high: Fraction | None) -> Fraction:
        if low is None or high is None:
            end = low if high is None else high
            assert end is not None
            return end + (1 + abs(end)) * (1 if high is None else -1)
        return (low + high) / 2

    def of_coefficients(self, p: Poly, boxes: dict[str, Box], strict: bool) -> int:
        signs, clear = set(), not strict
        for m, c in p.items():
            sign, never = (1 if c > 0 else -1), True
            for k, (kind, detail, inner) in enumerate(self.letters):
                if not (e := exponent(m, k)):
                    continue
                own = int(kind == "exp" or (kind == "variable" and boxes[detail] == POSITIVE))
                if kind in ("root", "over"):
                    own = self.sign(inner)
                never = never and own != 0
                if (kind, detail) == ("root", 2):
                    own = 1  # a square root that is 0 somewhere is not negative elsewhere
                if not own and e % 2:
                    return 0
                sign *= (own or 1) ** e
            signs.add(sign)
            clear = clear or never
        return signs.pop() if len(signs) == 1 and clear else 0

    def moved(self, p: Poly, k: int, low: Fraction | None, high: Fraction | None) -> Poly:
        """With low + s, high - s or (low + high s) / (1 + s), times a power of 1 + s, for a
        variable; with the end itself where both ends are the same.
        """
        s, bottom = {power_of(k): 1}, ONE
        if low is None or high is None:
            end = high if low is None else low
            assert end is not None
            top = plus(self.constant(end), s, -1 if low is None else 1)
        elif low == high:
            top = self.constant(low)
        else:
            top, bottom = (
                {**self.constant(low), **({power_of(k): high} if high else {})},
                {**ONE, **s},
            )
        parts, total = parts_of(p, k), dict[int, Any]()
        for e, part in parts.items():
            power = self.times(self.raised(top, e), self.raised(bottom, max(parts) - e))
            total = plus(total, self.times(part, power))
        return total

    def valued(self) -> bool:
        """Whether on the whole box no divisor is 0 and no square root is of what is negative."""
        return all(
            (kind != "over" or self.sign(inner) != 0)
            and (
                (kind, n) != ("root", 2)
                or self.sign(inner, strict=False) > 0
                or self.vanishes(inner)
            )
            for kind, n, inner in [*self.letters]
        )

    def has_a_value(self) -> bool:
        """Whether all letters have a value at one of the points, which lies in the domain."""
        for bits, point in ((b, p) for b in (128, 512, 2048) for p in self.points()):
            try:
                known: dict[int, Ball] = {}
                for k in range(len(self.letters)):
                    known[k] = self.letter_value(k, point, bits, known)
                if all(self.inside(name, point, bits, known) for name in self.boxes):
                    return True
            except ArithmeticError:
                continue
        return False

    def inside(self, name: str, point: dict[str, Fraction], bits: int, known: Any) -> bool:
        """Whether what a variable equals lies in its interval at a point."""
        own = {power_of(self.places["variable", name, frozenset()]): 1}
        low, high = self.value(self.meaning.get(name, own), point, bits, known)
        bottom, bottom_out, top, top_out = self.boxes[name]
        above = bottom is None or low >= enclosed(bottom, bits)[1] + bottom_out
        below = top is None or high <= enclosed(top, bits)[0] - top_out
        whole = name not in self.whole or (low == high and not low % (1 << bits))
        return above and below and whole


class Certificate:
    """What a certificate says, in lines to print, and whether it is so."""

    def __init__(self, data: Any) -> None:
        require(isinstance(data, dict) and data.get("format") == FORMAT, f"no {FORMAT}")
        require(data.get("verdict") in ("proved", "refuted"), "no verdict")
        unit = data.get("unit")
        require(type(unit) is int and 0 < unit <= 24, "no unit of angles")
        self.data: dict[str, Any] = data
        self.refutes = data["verdict"] == "refuted"
        self.algebra = Algebra(unit)

    def part(self, name: str, kind: type) -> Any:
        found = self.data.get(name)
        require(isinstance(found, kind), f"{name} is missing, or no {kind.__name__}")
        return found

    def decide(self, say: Callable[[str], None]) -> None:
        """Says what is shown, line by line. Raises Rejected."""
        algebra = self.algebra
        given, domain = self.domain()
        model = self.model() if self.data.get("model") is not None else []
        letters = self.letters()
        formula = [self.relation(entry) for entry in self.part("relations", list)]
        needed = [algebra.read(graph)[1] for graph in self.part("needed", list)]
        require(formula, "nothing is claimed")
        say(f"{'formula as typed:':<22}{harmless(self.part('typed', str))}")
        if self.data.get("convention") is not None:
            say(f"{'convention:':<22}{harmless(self.part('convention', str))}")
        for title, lines in (
            ("formula as checked", [text for _, _, text in formula]),
            ("model", model),
            ("letters", letters),
            ("where", domain),
            ("has a value too", [] if self.refutes else needed),
            ("with", [f"#{n} = {text}" for n, text in enumerate(algebra.long, 1)]),
        ):
            for line in lines:
                say(f"{title + ':':<22}{line}")
        if self.refutes:
            require(all(self.holds(*relation) for relation in given), "the point is outside")
            require(algebra.has_a_value(), "that every part has a value at the point is not shown")
            false = [text for p, sign, text in formula if not self.holds(p, sign, text)]
            require(false, "the formula holds at the point")
            say(f"{'false at this point:':<22}{false[0]}")
            return
        for p, operator, text in formula:
            require(self.shown(p, operator), f"not shown: {text}")
        require(algebra.has_a_value(), "no point was found at which every part has a value")
        everywhere = self.data.get("everywhere") is True
        require(not everywhere or algebra.valued(), NO_VALUES)
        all_of_it = "every part has a value there, as is shown too"
        say(f"{'values:':<22}{all_of_it if everywhere else 'said where every part has a value'}")

    def relation(self, entry: Any) -> tuple[Poly, str, str]:
        """Left minus right, the operator, and the text."""
        require(isinstance(entry, list) and len(entry) == 3, "no relation")
        require(isinstance(entry[1], str) and entry[1] in HOLDS, "no relation")
        (left, first), (right, second) = self.algebra.read(entry[0]), self.algebra.read(entry[2])
        return plus(left, right, -1), entry[1], f"{first} {entry[1]} {second}"

    def shown(self, p: Poly, operator: str) -> bool:
        if operator == "!=":
            return self.algebra.sign(p) != 0
        if operator != "=" and self.algebra.sign(p, operator in "<>") == HOLDS[operator][0]:
            return True
        return 0 in HOLDS[operator] and self.algebra.vanishes(p)

    def holds(self, p: Poly, operator: str, text: str) -> bool:
        """Of numbers. Raises Rejected where it is not seen."""
        sign = self.algebra.seen(p)
        require(sign or self.algebra.vanishes(p), f"not decided at the point: {text}")
        return sign in HOLDS[operator]

    def domain(self) -> tuple[list[tuple[Poly, str, str]], list[str]]:
        """Variables with their intervals, and conditions; a refutation has a value for each."""
        algebra, told = self.algebra, []
        point = self.part("point", dict) if self.refutes else {}
        for name, box in self.part("domain", dict).items():
            require(isinstance(box, list) and len(box) == 5, "no interval")
            low, high = (None if end is None else rational(end) for end in (box[0], box[2]))
            require(low is None or high is None or low <= high, "an interval turned round")
            algebra.boxes[name] = low, box[1] is True, high, box[3] is True
            algebra.whole |= {name} if box[4] is True else set()
            self.define(name, algebra.letter("variable", name, {}))
            told.append(interval(name, algebra.boxes[name], box[4] is True))
            if self.refutes:
                value = rational(point.get(name))
                above = low is None or low < value or (low == value and box[1] is not True)
                below = high is None or value < high or (value == high and box[3] is not True)
                whole = box[4] is not True or value.denominator == 1
                require(above and below and whole, "the point is outside")
                algebra.meaning[name] = algebra.constant(value)
                told[-1] += f"; here {named(name)} = {value}"
        given = []
        for entry in self.part("given", list):
            given.append(self.relation(entry))
            told.append(given[-1][2])
            if not self.refutes:
                self.put_in(*given[-1][:2])
        return given, told

    def put_in(self, p: Poly, operator: str) -> tuple[int, Poly] | None:
        """Uses `p operator 0` where it is of degree 1 in a variable: puts in for it what it equals,
        or what lies between its bound and its other end. What is not used is not supposed.
        """
        algebra = self.algebra
        p, factor = algebra.cleared(p, signed=True)
        for name in self.part("domain", dict):
            own = algebra.places["variable", name, frozenset()]
            parts = parts_of(p, own)
            slope, rest = parts.get(1, {}), parts.get(0, {})
            bent = max(parts, default=0) != 1 or own in algebra.below(slope) | algebra.below(rest)
            rising = 0 if bent or operator == "!=" else algebra.sign(slope)
            if not rising or (operator != "=" and not factor):
                continue
            value = plus({}, algebra.times(rest, algebra.over(slope)), -1)
            if operator != "=":
                less = (operator[0] == "<") == (rising * factor > 0)
                value = self.between(name, less, operator in "<>", value)
            for other, meaning in [*algebra.meaning.items()]:
                algebra.meaning[other] = algebra.replaced(meaning, own, value)
            return own, value
        return None

    def between(self, name: str, less: bool, strict: bool, bound: Poly) -> Poly:
        """bound -/+ s for a new s > 0 (>= 0), or what lies between the bound and the other end."""
        algebra, box = self.algebra, self.algebra.boxes[name]
        end, left_out = (box[0], box[1]) if less else (box[2], box[3])
        slack = f"part of {name}"
        require(slack not in algebra.boxes, "a part said twice")
        algebra.boxes[slack] = Fraction(0), strict and (end is None or left_out), None, True
        s = algebra.letter("variable", slack, {})
        if end is None or not strict:
            return plus(bound, s, -1 if less else 1)
        # what lies between is there only where the bound lies on its side of the other end
        between = self.put_in(plus(bound, algebra.constant(end), -1), ">" if less else "<")
        bound = bound if between is None else algebra.replaced(bound, *between)
        top = plus(algebra.constant(end), algebra.times(bound, s))
        return algebra.times(top, algebra.over(plus(ONE, s)))

    def letters(self) -> list[str]:
        told = []
        for entry in self.part("letters", list):
            fine = isinstance(entry, list) and len(entry) == 2 and isinstance(entry[0], str)
            require(fine, "no letter")
            value, text = self.algebra.read(entry[1])
            self.define(entry[0], value)
            told.append(f"{named(entry[0])} stands for {text}")
        return told

    def define(self, name: str, value: Poly, of_model: str = "") -> None:
        require(0 < len(name) <= 200, "a name that is too long, or none")
        require(of_model or not ENTRY.fullmatch(name), f"{name} is said without a model")
        require(name not in self.algebra.meaning, f"{harmless(name)[:60]} is said twice")
        self.algebra.meaning[name] = value

    def model(self) -> list[str]:
        """Gain and Riccati equation, and the stability that tells P from other solutions."""
        read, told = dict[str, Matrix](), []
        for name in "FHQRPK":
            rows = self.part("model", dict).get(name)
            fine = isinstance(rows, list) and 0 < len(rows) <= 3
            require(
                fine and all(isinstance(row, list) and row for row in rows), f"no matrix {name}"
            )
            entries = [[self.algebra.read(graph) for graph in row] for row in rows]
            read[name] = [[value for value, _ in row] for row in entries]
            told.append(f"{name} = [{'; '.join(', '.join(t for _, t in row) for row in entries)}]")
        f, h, q, r, p, k = read.values()
        n, m = len(f), len(h)
        shapes = (f, n, n), (h, m, n), (q, n, n), (r, m, m), (p, n, n), (k, n, m)
        fit = m == 1 and all(len(a) == x and {len(row) for row in a} == {y} for a, x, y in shapes)
        require(fit, "matrices that do not fit")
        ph = self.product(p, turned(h))
        s, x = self.sum(self.product(h, ph), r), self.sum(p, self.product(k, turned(ph)), -1)
        riccati = self.sum(self.product(self.product(f, x), turned(f)), q)
        zero = [self.sum(self.product(k, s), ph, -1), self.sum(riccati, p, -1)]
        zero += [self.sum(a, turned(a), -1) for a in (p, q, r)]
        vanish = all(self.algebra.vanishes(e) for a in zero for row in a for e in row)
        require(vanish, "the Riccati equation or the gain is not shown")
        require(self.shown(r[0][0], ">"), "that R is positive is not shown")
        for chosen in range(1, 1 << n):
            which = [i for i in range(n) if chosen >> i & 1]
            minor = self.determinant([[q[i][j] for j in which] for i in which])
            require(self.shown(minor, ">="), "that Q is a covariance is not shown")
        loop = self.sum(f, self.product(f, self.product(k, h)), -1)
        stable = all(self.algebra.sign(e) > 0 for e in self.stability(loop))
        require(stable, "that F - F K H is stable is not shown")
        for name, a in (("P", p), ("K", k), ("S", s), ("X", x)):
            for i, row in enumerate(a):
                for j, value in enumerate(row):
                    self.define(f"{name}[{i + 1},{j + 1}]", value, name)
        return [
            "state F x + noise of covariance Q, measured H x + noise of covariance R",
            *told,
            "S = H P H' + R, X = P - K H P; shown too: K S = P H', P = F X F' + Q",
            "shown too: Q >= 0, R > 0; F - F K H is stable with this P, and no other, so P >= 0",
        ]

    def stability(self, a: Matrix) -> list[Poly]:
        """What is positive exactly where all eigenvalues of up to three lie in the unit circle."""
        n, times = len(a), self.algebra.times
        found, current = [ONE], [[ONE if i == j else {} for j in range(n)] for i in range(n)]
        for k in range(1, n + 1):
            moved, trace = self.product(a, current), dict[int, Any]()
            for i in range(n):
                trace = plus(trace, moved[i][i])
            found.append(times(trace, {0: Fraction(-1, k)}))
            current = [
                [plus(e, found[-1]) if i == j else e for j, e in enumerate(row)]
                for i, row in enumerate(moved)
            ]
        signs = {
            1: ((1, 1), (1, -1)),
            2: ((1, 1, 1), (1, -1, 1), (1, 0, -1)),
            3: ((1, 1, 1, 1), (1, -1, 1, -1), (3, 1, -1, -3), (3, -1, -1, 3)),
        }
        sums = []
        for row in signs[n]:
            total: Poly = {}
            for w, c in zip(row, found, strict=True):
                total = plus(total, c, w)
            sums.append(total)
        if n == 3:
            last = plus(times(found[3], found[3]), times(found[1], found[3]), -1)
            sums.append(plus(plus(ONE, found[2], -1), last, -1))
        return sums

    def determinant(self, a: Matrix) -> Poly:
        total: Poly = {} if a else ONE
        for j, x in enumerate(a[0] if a else ()):
            rest = [[*row[:j], *row[j + 1 :]] for row in a[1:]]
            total = plus(total, self.algebra.times(x, self.determinant(rest)), (-1) ** j)
        return total

    def product(self, a: Matrix, b: Matrix) -> Matrix:
        def entry(row: Sequence[Poly], column: Sequence[Poly]) -> Poly:
            total: Poly = {}
            for x, y in zip(row, column, strict=True):
                total = plus(total, self.algebra.times(x, y))
            return total

        return [[entry(row, column) for column in turned(b)] for row in a]

    def sum(self, a: Matrix, b: Matrix, factor: int = 1) -> Matrix:
        pairs = (zip(x, y, strict=True) for x, y in zip(a, b, strict=True))
        return [[plus(x, y, factor) for x, y in row] for row in pairs]


def turned(a: Matrix) -> Matrix:
    return [list(column) for column in zip(*a, strict=True)]


def interval(name: str, box: Box, whole: bool) -> str:
    low, low_open, high, high_open = box
    left = "" if low is None else f"{low} {'<' if low_open else '<='} "
    right = "" if high is None else f" {'<' if high_open else '<='} {high}"
    return f"{left}{named(name)}{right}, {'a whole' if whole else 'a real'} number"


def named(name: str) -> str:
    """A name, in quotes where it could be taken for a formula."""
    return name if PLAIN.fullmatch(name) else json.dumps(name)


def harmless(text: str) -> str:
    return "".join(c if c.isprintable() else "?" for c in " ".join(text.split()))[:4000]


def main(arguments: Sequence[str]) -> int:
    """0 if the certificate shows what it says, else 1."""
    if isinstance(sys.stdout, TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")  # of a terminal that knows ASCII alone
    try:
        require(len(arguments) == 1, "wanted: the file of one certificate")
        with open(arguments[0], "rb") as file:
            text = file.read(MOST_BYTES + 1)
        require(len(text) <= MOST_BYTES, f"more than {MOST_BYTES} bytes")
        certificate = Certificate(json.loads(text))
        certificate.decide(print)
    except Rejected as reason:
        print(f"REJECTED: {harmless(str(reason))[:500]}")
        return 1
    except Exception as error:  # noqa: BLE001  whatever is wrong with it, it shows nothing
        print(f"REJECTED: not read: {type(error).__name__}: {harmless(str(error))[:200]}")
        return 1
    print("refuted" if certificate.refutes else "proved")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
