"""Polynomials of the letters of a certificate: the last letter is eliminated by what defines it.

Each line is given to the checker as it is written here, so that what it does not accept is found at
once. The polynomials are those of the checker, computed with on python-flint.
"""

from __future__ import annotations

import ast
from collections.abc import Mapping, Sequence
from fractions import Fraction
from time import process_time
from typing import Any

import flint

from gainproof.verify.check_answer import FORMAT, ONE, ZERO, Certificate, Poly

Flint = Any
"""A polynomial of python-flint, which has no types."""


def constant(value: Fraction | int) -> Poly:
    return Poly({(): value}) if value else ZERO


def letter(name: str, power: int = 1) -> Poly:
    return Poly({(name,) * power: 1})


class Polynomials:
    """Facts of a certificate so far, as the checker has read them; what eliminates its letters."""

    def __init__(self, point: Mapping[str, list[int]], latest: float) -> None:
        self.latest = latest
        self.checker = Certificate({"format": FORMAT, "point": point})
        self.lines: list[list[Any]] = []
        self.indexed = 0
        self.index: dict[tuple[frozenset[Any], str], int] = {}  # facts, the first of what is equal
        self.bounds: list[int] = []  # conditions that are no equations
        self.values: dict[str, Flint] = {}  # balls round the letters at the point
        self.known: dict[Any, int | None] = {}  # what was looked for, and the fact that was found
        self.of_sums: dict[str, int] = {}  # functions of a sum, and the theorem of addition
        self.solved: dict[str, tuple[int | None, Poly]] = {}  # variables by an equation
        self.angles_done: set[str] = set()
        self.order: list[str] = []  # letters, the last first
        self.context: Any = None  # of python-flint, for that order

    # lines

    def say(self, *line: Any) -> int:
        """The number of the last fact once the checker has read it. Raises ValueError."""
        if process_time() > self.latest:
            raise TimeoutError("no proof was found in time")
        self.checker.line(*line)
        self.lines.append([*line])
        for k in range(self.indexed, len(self.checker.facts)):
            p, sign = self.checker.facts[k]
            self.index.setdefault((frozenset(p.items()), sign), k)
        self.indexed = len(self.checker.facts)
        if line[0] == "where":
            k = len(self.checker.facts) - 1
            if self.checker.facts[k][1] == "==":
                self.solve(self.checker.facts[k][0], k)
            else:
                self.bounds.append(k)
            self.known = {key: found for key, found in self.known.items() if found is not None}
        return len(self.checker.facts) - 1

    def read(self, text: str) -> Any:
        """The polynomial of a relation and its sign."""
        return self.checker.value(text, ast.Compare)

    def shows(
        self, p: Poly, sign: str, terms: Sequence[Any], times: Any = None, by: Poly | None = None
    ) -> int | None:
        """The number of the fact, None where the checker does not see it."""
        if (found := self.fact(p, sign)) is not None:
            return found
        line = ["shows", said(p), sign, times or [[1], []], terms]
        try:
            return self.say(*line, *([said(by)] if by is not None else []))
        except ValueError:
            return None

    def fact(self, p: Poly, *signs: str) -> int | None:
        key = frozenset(p.items())
        return next((self.index[key, s] for s in signs if (key, s) in self.index), None)

    # polynomials of python-flint, the last letter first

    def to_flint(self, p: Poly) -> Flint:
        self.sort()
        place = {name: k for k, name in enumerate(self.order)}
        terms = {}
        for m, c in p.items():
            powers = [0] * len(self.order)
            for name in m:
                powers[place[name]] += 1
            terms[tuple(powers)] = flint.fmpq(Fraction(c).numerator, Fraction(c).denominator)
        return self.context.from_dict(terms)

    def from_flint(self, f: Flint) -> Poly:
        found = Poly()
        for powers, c in f.to_dict().items():
            m = tuple(
                sorted(name for name, e in zip(self.order, powers, strict=True) for _ in range(e))
            )
            found[m] = Fraction(int(c.p), int(c.q))
        return found

    def sort(self) -> None:
        """Letters after those that they are made of come first."""
        letters = self.checker.letters
        if len(self.order) == len(letters) and self.context is not None:
            return
        done: list[str] = []

        def visit(name: str) -> None:
            if name in done:
                return
            below = {k for m in letters[name][1] for k in m}
            if letters[name][0] == "sin":
                below |= {f"cos{name[3:]}"} & {*letters}
            if name in self.of_sums:
                below |= {k for m in self.checker.facts[self.of_sums[name]][0] for k in m}
            if name in self.solved:
                below |= {k for m in self.solved[name][1] for k in m}
            for other in sorted(below - {name}):
                visit(other)
            done.append(name)

        for name in letters:
            visit(name)
        self.order = done[::-1]
        self.context = flint.fmpq_mpoly_ctx.get(("x", max(1, len(done))), "lex")

    def relation(self, name: str) -> tuple[str, int | None, Poly]:
        """How it is eliminated ("", "monic" or "over"), the number and polynomial of the fact."""
        kind, inner = self.checker.letters[name]
        me = letter(name)
        if name in self.solved:
            return "over", *self.solved[name]
        if name in self.of_sums:
            p = self.checker.facts[self.of_sums[name]][0]
            return ("monic" if (name,) in p else "over"), self.of_sums[name], p
        if kind == "over":
            p = me * inner - ONE
            return "over", self.fact(p, "=="), p
        if kind == "part":
            p = me - inner
            return "monic", self.fact(p, "=="), p
        if kind == "sqrt":
            p = me * me - inner
            return "monic", self.fact(p, "=="), p
        if kind == "sin":
            p = me * me + letter(f"cos{name[3:]}", 2) - ONE
            return "monic", self.fact(p, "=="), p
        return "", None, ZERO

    def eliminable(self, p: Poly) -> str | None:
        """The last letter that something defines by others."""
        self.sort()
        used = {k for m in p for k in m}
        for name in self.order:
            if name in used and self.relation(name)[0]:
                kind, _, relation = self.relation(name)
                powers = max(m.count(name) for m in p)
                alone = kind == "monic" and powers < max(m.count(name) for m in relation)
                if not (alone and self.checker.letters[name][0] == "sin"):
                    return name
        return None

    def by_degree(self, p: Poly, name: str) -> dict[int, Poly]:
        found: dict[int, Poly] = {}
        for m, c in p.items():
            e = m.count(name)
            found.setdefault(e, Poly())[tuple(k for k in m if k != name)] = c
        return found

    def solve(self, p: Poly, number: int | None) -> None:
        """Uses p = 0, a fact if it has a number, for a variable that is of degree 1 in it."""
        while (name := next((k for m in p for k in m if self.is_short(k)), None)) is not None:
            _, own, relation = self.relation(name)
            e, bottom, other, cofactor = self.cleared(p, name, relation)
            if number is not None:
                power = self.from_flint(self.to_flint(bottom) ** e)
                terms = [[[1], [number], said(power)], [[-1], [own], said(cofactor)]]
                number = self.shows(other, "==", terms)
            p = other
        letters = self.checker.letters
        bounded = {k for b in self.bounds for m in self.checker.facts[b][0] for k in m}
        for name in sorted({k for m in p for k in m}, key=lambda k: (k in bounded, k)):
            parts = self.by_degree(p, name)
            below = {k for m in p for k in m if self.rests_on(k, name)}
            alone = letters[name][0] == "real" and max(parts) == 1 and below == {name}
            if alone and self.seen(parts[1]):
                self.solved[name] = number, p
                self.order = []
                return

    def is_short(self, name: str) -> bool:
        return name in self.solved or self.checker.letters[name][0] == "part"

    def rests_on(self, name: str, other: str) -> bool:
        inner = {k for m in self.checker.letters[name][1] for k in m}
        return name == other or any(self.rests_on(k, other) for k in inner)

    def divided(self, p: Poly, relation: Poly) -> tuple[Poly, Poly]:
        quotient, rest = divmod(self.to_flint(p), self.to_flint(relation))
        return self.from_flint(quotient), self.from_flint(rest)

    def cleared(self, p: Poly, name: str, relation: Poly) -> tuple[int, Poly, Poly, Poly]:
        """Of p with u = a/b: e, b and b^e p = other + cofactor relation."""
        top = ZERO - self.by_degree(relation, name).get(0, ZERO)
        bottom = self.by_degree(relation, name)[1]
        parts = self.by_degree(p, name)
        e = max(parts)
        a, b = self.to_flint(top), self.to_flint(bottom)
        other = sum((self.to_flint(q) * a**k * b ** (e - k) for k, q in parts.items()), 0 * a)
        cofactor = divmod(b**e * self.to_flint(p) - other, self.to_flint(relation))[0]
        return e, bottom, self.from_flint(other), self.from_flint(cofactor)

    def conjugate(self, p: Poly, name: str) -> tuple[Poly, Poly, Poly, Poly]:
        """Of p = A + B r with r^2 = a: A, B, A - B r and A^2 - B^2 a."""
        parts = self.by_degree(p, name)
        one, other = parts.get(0, ZERO), parts.get(1, ZERO)
        a, b = self.to_flint(one), self.to_flint(other)
        inner = self.to_flint(self.checker.letters[name][1])
        norm = self.from_flint(a * a - b * b * inner)
        return one, other, one - self.from_flint(b * self.to_flint(letter(name))), norm

    def seen(self, p: Poly) -> int:
        """Its sign at the point; 0 where it is not seen."""
        total = flint.arb(0)
        try:
            with flint.ctx.workprec(400):
                for m, c in p.items():
                    term = flint.arb(_ball(Fraction(c)))
                    for name in m:
                        if name not in self.values:
                            low, high = self.checker.enclosed(letter(name))
                            self.values[name] = _ball(low).union(_ball(high))
                        term *= self.values[name]
                    total += term
        except (KeyError, ValueError, ZeroDivisionError):
            return 0
        return int(total > 0) - int(total < 0)


def _ball(value: Fraction) -> Flint:
    return flint.arb(flint.fmpq(value.numerator, value.denominator))


def pair(c: Fraction | int) -> list[int]:
    top, bottom = Fraction(c).as_integer_ratio()
    return [top] if bottom == 1 else [top, bottom]


def said(p: Poly) -> list[list[Any]]:
    return [[pair(c), *m] for m, c in p.items()]


def text_of(p: Poly) -> str:
    """An expression of a polynomial."""
    terms = []
    for m, c in sorted(p.items(), key=lambda item: (item[1] < 0, item[0])):
        factors = [f"({name})" if not name.isidentifier() else name for name in m]
        number = [str(abs(c))] if abs(c) != 1 or not m else []
        terms.append((" - " if c < 0 else " + ") + "*".join([*number, *factors]))
    text = "".join(terms) or " + 0"
    return text[3:] if text.startswith(" + ") else f"-{text[3:]}"
