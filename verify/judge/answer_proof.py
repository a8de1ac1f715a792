"""Proofs that `gainproof.verify.check_answer` multiplies out: zeros, signs, that parts have values.

The checker reads each line as it is written here, so that what it does not accept is found at once.
Polynomials are those of its letters, on python-flint; the last letter is eliminated by what defines
it, until a polynomial in variables is left.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product
from math import gcd, lcm
from time import process_time
from typing import Any

import flint

from gainproof.verify.check_answer import FORMAT, ONE, VALUE, ZERO, Certificate, Poly

Flint = Any
"""A polynomial of python-flint, which has no types."""
ELEVATIONS = (0, 1, 3, 8, 20)
"""Powers of what is positive that are tried as a factor of a polynomial in one variable."""
SMALL = (Fraction(1), Fraction(1, 8), Fraction(1, 1000))


def constant(value: Fraction | int) -> Poly:
    return Poly({(): value}) if value else ZERO


def letter(name: str, power: int = 1) -> Poly:
    return Poly({(name,) * power: 1})


class Proof:
    """Lines of a certificate so far, as the checker has read them."""

    def __init__(self, point: Mapping[str, list[int]], latest: float) -> None:
        self.latest = latest
        self.checker = Certificate({"format": FORMAT, "point": point})
        self.lines: list[list[Any]] = []
        self.indexed = 0
        self.index: dict[tuple[frozenset[Any], str], int] = {}
        self.bounds: list[int] = []
        self.values: dict[str, Flint] = {}
        self.known: dict[Any, int | None] = {}
        self.of_sums: dict[str, int] = {}
        self.solved: dict[str, tuple[int | None, Poly]] = {}
        self.angles_done: set[str] = set()
        self.order: list[str] = []
        self.context: Any = None

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

    # what vanishes

    def zero(self, p: Poly) -> int | None:
        """The number of the fact that it is 0; None where that is not found."""
        key = "==", frozenset(p.items())
        if key not in self.known:
            self.known[key] = None
            self.known[key] = self.fact(p, "==")
            if self.known[key] is None:
                self.known[key] = self.found_zero(p)
        return self.known[key]

    def found_zero(self, p: Poly) -> int | None:
        if not p:
            return self.shows(p, "==", [])
        if self.seen(p) or (name := self.eliminable(p)) is None:
            return None
        kind, number, relation = self.relation(name)
        if kind == "over":
            e, bottom, other, cofactor = self.cleared(p, name, relation)
            rest, nonzero = self.zero(other), self.nonzero(bottom)
            if rest is None or nonzero is None or number is None:
                return None
            terms = [[[1], [number], said(cofactor)], [[1], [rest]]]
            return self.shows(p, "==", terms, [[1], [nonzero] * e])
        if number is None:
            return None
        quotient, other = self.divided(p, relation)
        if quotient:
            rest = self.zero(other)
            terms = [[[1], [number], said(quotient)], [[1], [rest]]]
            return None if rest is None else self.shows(p, "==", terms)
        one, factor, conjugate, norm = self.conjugate(p, name)
        rest = self.zero(norm)
        if rest is None:
            return None
        terms = [[[-1], [number], said(factor * factor)], [[1], [rest]]]
        found = self.shows(p, "==", terms, by=conjugate)
        if found is None and (positive := self.sign(conjugate)) is not None:
            found = self.shows(p, "==", terms, [[1], [positive]])
        if found is None:
            each = self.zero(one), self.zero(factor)
            if None not in each:
                terms = [[[1], [each[0]]], [[1], [each[1]], said(letter(name))]]
                found = self.shows(p, "==", terms)
        return found

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

    # signs

    def nonzero(self, p: Poly) -> int | None:
        found = self.fact(p, ">", "!=")
        if found is None and (found := self.sign(p)) is None:
            negative = self.sign(ZERO - p)
            if negative is not None:
                found = self.shows(p, "!=", [[[-1], [negative]]])
        return found

    def sign(self, p: Poly, strict: bool = True) -> int | None:
        """The number of the fact that it is positive, or not negative if not strict."""
        key = strict, frozenset(p.items())
        if key not in self.known:
            self.known[key] = None
            found = self.fact(p, ">") if strict else self.fact(p, ">", ">=")
            seen = self.seen(p) if found is None else 0
            if found is None and seen >= 0:
                found = self.found_sign(p, strict)
                if found is None and not strict and not seen and (rest := self.zero(p)) is not None:
                    found = self.shows(p, ">=", [[[1], [rest]]])
            self.known[key] = found
        return self.known[key]

    def found_sign(self, p: Poly, strict: bool) -> int | None:
        if all(kind != "real" for kind, _ in self.checker.letters.values()):
            return self.shows(p, ">", [])
        sign = ">" if strict else ">="
        for root, (sort, inner) in self.checker.letters.items() if strict else ():
            positive = self.fact(letter(root), ">") if sort == "sqrt" and inner == p else None
            if positive is not None and (square := self.relation(root)[1]) is not None:
                return self.shows(p, sign, [[[1], [positive, positive]], [[-1], [square]]])
        name = self.eliminable(p)
        kind, number, relation = self.relation(name) if name else ("", None, ZERO)
        if name and kind == "over":
            return self.sign_of_quotient(p, sign, name)
        if name and number is not None:
            quotient, other = self.divided(p, relation)
            if quotient:
                rest = self.sign(other, strict)
                terms = [[[1], [number], said(quotient)], [[1], [rest]]]
                return None if rest is None else self.shows(p, sign, terms)
        found = self.by_coefficients(p, strict)
        if found is None:
            found = self.by_factors(p, strict)
        if found is None and name and number is not None and kind == "monic":
            _, factor, conjugate, norm = self.conjugate(p, name)
            for scale in (1, -1):
                rest = self.sign(norm * constant(scale))
                if rest is not None:
                    terms = [[[scale], [rest]], [[-1], [number], said(factor * factor)]]
                    other_than_0 = self.shows(p, "!=", terms, by=conjugate)
                    return self.shows(p, ">", [[[1], [other_than_0]]])
        return found

    def sign_of_quotient(self, p: Poly, sign: str, name: str) -> int | None:
        _, number, relation = self.relation(name)
        e, bottom, other, cofactor = self.cleared(p, name, relation)
        if number is None:
            return None
        flip, positive = 1, self.sign(bottom)
        if positive is None and (positive := self.sign(ZERO - bottom)) is not None:
            flip = (-1) ** e
        if positive is None and (nonzero := self.nonzero(bottom)) is not None:
            square = bottom * bottom
            other_than_0 = self.shows(square, "!=", [[[1], [nonzero, nonzero]]])
            positive = self.shows(square, ">", [[[1], [other_than_0]]])
            if e % 2:
                other, cofactor = other * bottom, cofactor * bottom
            e = (e + 1) // 2
        rest = None if positive is None else self.sign(other * constant(flip), sign == ">")
        if rest is None:
            return None
        terms = [[[1], [rest]], [[flip], [number], said(cofactor)]]
        return self.shows(p, sign, terms, [[1], [positive] * e])

    def by_factors(self, p: Poly, strict: bool) -> int | None:
        number, factors = self.to_flint(p).factor()
        if len(factors) < 2 and all(e == 1 for _, e in factors):
            return None
        scale, facts, square = Fraction(int(number.p), int(number.q)), list[int](), ONE
        for factor, e in factors:
            q = self.from_flint(factor)
            found = self.sign(q, strict)
            if found is None and (found := self.sign(ZERO - q, strict)) is not None:
                scale *= (-1) ** int(e)
            if found is None and (strict or e % 2):
                return None
            facts += [found] * int(e) if found is not None else []
            for _ in range(int(e) // 2 if found is None else 0):
                square = square * q
        term = [pair(scale), facts, said(square)]
        return self.shows(p, ">" if strict else ">=", [term]) if scale > 0 else None

    def by_coefficients(self, p: Poly, strict: bool) -> int | None:
        """Since all coefficients have one sign once variables are moved to their bounds."""
        if any(not m for m in p) and len(p) == 1:
            return self.shows(p, ">", [[pair(p[()]), []]]) if p[()] > 0 else None
        sign = ">" if strict else ">="
        variables = [n for n in self.order if self.checker.letters[n][0] == "real"]
        for chosen in self.choices(variables):
            for power in ELEVATIONS if len({k for m in p for k in m}) == 1 else (0,):
                moved = self.moved(p, chosen, power)
                if moved is not None:
                    terms, times = moved
                    found = self.shows(p, sign, terms, times)
                    if found is not None:
                        return found
                    if strict:
                        for least in SMALL:
                            rest = self.by_coefficients(p - constant(least), False)
                            if rest is not None:
                                return self.shows(p, ">", [[[1], [rest]], [pair(least), []]])
        return None

    def choices(self, variables: Sequence[str]) -> Iterator[dict[str, tuple[Any, Any]]]:
        """For each variable a fact that bounds it from below and one from above, or none."""
        options = []
        for name in variables:
            low: list[Any] = []
            high: list[Any] = []
            for k in self.bounds:
                g, sign = self.checker.facts[k]
                slope = self.by_degree(g, name)
                fine = sign in (">", ">=") and {*slope} <= {0, 1} and [*slope.get(1, ZERO)] == [()]
                if fine:
                    (low if slope[1][()] > 0 else high).append(k)
            both = [*product(low or [None], high or [None])]
            both += [(k, None) for k in low if high] + [(None, k) for k in high if low]
            options.append(both)
        for count, combination in enumerate(product(*options)):
            if count == 40:
                return
            yield dict(zip(variables, combination, strict=True))

    def moved(
        self, p: Poly, chosen: Mapping[str, tuple[Any, Any]], power: int
    ) -> tuple[list[Any], list[Any]] | None:
        """Terms of its sum, and the factor; None if some coefficient is negative."""
        facts, scale, factor = dict[str, int](), Fraction(1), list[int]()
        waiting = [n for n in chosen if chosen[n] != (None, None)]
        made = False
        while waiting:
            met = {k for m in p for k in m}
            below = {
                n: {
                    k
                    for f in chosen[n]
                    if f is not None
                    for m in self.checker.facts[f][0]
                    for k in m
                }
                for n in waiting
            }
            first = [n for n in waiting if not any(n in below[o] for o in waiting if o != n)]
            if not first:
                return None
            name = first[0]
            waiting.remove(name)
            if name not in met:
                continue
            low, high = chosen[name]
            parts, total = self.by_degree(p, name), ZERO
            one = self.by_degree(self.checker.facts[low if low is not None else high][0], name)
            slope, rest = one[1][()], one.get(0, ZERO)
            if low is None or high is None:
                # facts are slope v + rest, under the name of the variable from here on
                value = (letter(name) - rest) * constant(1 / Fraction(slope))
                bottom = ONE
                facts[name] = low if low is not None else high
                extra = ONE + letter(name)
                grown = self.shows(
                    ONE + self.checker.facts[facts[name]][0], ">", [[[1], []], [[1], [facts[name]]]]
                )
                raise_by = [grown] * power if power else []
            else:
                two = self.by_degree(self.checker.facts[high][0], name)
                start = rest * constant(-1 / Fraction(slope))
                end = two.get(0, ZERO) * constant(-1 / Fraction(two[1][()]))
                from_start = letter(name) * constant(1 / Fraction(slope))
                to_end = letter(f"{name}|") * constant(-1 / Fraction(two[1][()]))
                facts |= {name: low, f"{name}|": high}
                width = end - start
                bottom = from_start + to_end
                value = start * to_end + end * from_start
                extra = bottom
                top = max(parts) + power
                if {*width} <= {()}:
                    scale *= Fraction(width.get((), 0)) ** top
                    raise_by = []
                else:
                    terms = [
                        [pair(1 / Fraction(slope)), [low]],
                        [pair(-1 / Fraction(two[1][()])), [high]],
                    ]
                    wide = self.shows(width, ">", terms)
                    if wide is None:
                        return None
                    raise_by = [wide] * top
            if None in raise_by:
                return None
            factor += raise_by  # type: ignore[arg-type]
            powers = [ONE]
            for _ in range(max(parts)):
                powers.append(powers[-1] * value)
            bottoms = [ONE]
            for _ in range(max(parts)):
                bottoms.append(bottoms[-1] * bottom)
            for e, part in parts.items():
                total += part * powers[e] * bottoms[max(parts) - e]
            for _ in range(power):
                total = total * extra
            p, made = total, True
        if scale <= 0 or (power and not made):
            return None
        terms = []
        for m, c in p.items():
            used, odd = list[int](), list[str]()
            for name in m:
                own = facts.get(name)
                if own is None and self.checker.letters[name][0] in ("sqrt", "exp", "over"):
                    own = self.fact(letter(name), ">", ">=")
                if own is None:
                    odd.append(name)
                else:
                    used.append(own)
            if c < 0 or any(odd.count(name) % 2 for name in odd):
                return None
            root = tuple(name for name in sorted({*odd}) for _ in range(odd.count(name) // 2))
            terms.append([pair(c), used, *([[[[1], *root]]] if root else [])])
        return terms, [pair(scale), factor]

    # values

    def open(self) -> None:
        """Says of letters that they have a value, as far as it is found."""
        for name in self.closed():
            kind, inner = self.checker.letters[name]
            if kind == "over":
                found = self.nonzero(inner)
            else:
                found = self.sign(inner)
                if found is None and not self.seen(inner):
                    found = self.zero(inner)
                if found is None:
                    found = self.sign(inner, strict=False)
            if found is None:
                continue
            self.say("opens", name, found)
            sign = VALUE[kind][0]
            if self.fact(inner, sign) is None:
                self.shows(inner, sign, [[[1], [found]]])
            self.known = {key: k for key, k in self.known.items() if k is not None}

    def closed(self) -> list[str]:
        """Letters that are not known to have a value."""
        letters = self.checker.letters.items()
        return [k for k, (kind, p) in letters if kind in VALUE and self.relation(k)[1] is None]

    # functions of sums

    def angles(self) -> None:
        """Theorems of addition from parts that all arguments are whole multiples of."""
        arguments: dict[frozenset[Any], Poly] = {}
        for kind, inner in self.checker.letters.values():
            if kind in ("sin", "cos", "exp"):
                arguments[frozenset(inner.items())] = inner
        unit: dict[tuple[str, ...], Fraction] = {}
        for p in arguments.values():
            for m, c in p.items():
                c, old = Fraction(c), unit.get(m, Fraction(0))
                bottom = lcm(c.denominator, old.denominator)
                unit[m] = Fraction(gcd(int(c * bottom), int(old * bottom)), bottom)
        for p in arguments.values():
            steps = [
                (m, 1 if c > 0 else -1)
                for m, c in sorted(p.items(), key=lambda item: item[1] < 0)
                for _ in range(abs(int(c / unit[m])))
            ]
            if len(steps) > 24:
                raise ValueError("a function of too many parts")
            current = ZERO
            for m, way in steps:
                part = Poly({m: unit[m]})
                self.add_angle(part, ZERO, 1)  # exp > 0, and the sum of squares
                if current:
                    self.add_angle(current, part, way)
                current += part * constant(way)
        self.order = []

    def add_angle(self, current: Poly, part: Poly, way: int) -> None:
        following = current + part * constant(way)
        one, two, three = text_of(current), text_of(part), text_of(following)
        if text_of(following) in self.angles_done:
            return
        self.angles_done.add(text_of(following))
        self.say("sums", *((one, two, three) if way > 0 else (three, two, one)))
        c3, s3, e3 = (self.named(f"{name}({three})") for name in ("cos", "sin", "exp"))
        if not part:
            return
        last = len(self.checker.facts) - 4  # that e is e e, before three that are positive
        self.of_sums[e3] = last
        if way > 0:
            self.of_sums |= {c3: last - 2, s3: last - 1}
            return
        c1, s1, c2, s2 = (
            letter(self.named(f"{name}({text})")) for text in (one, two) for name in ("cos", "sin")
        )
        norm = self.fact(s2 * s2 + c2 * c2 - ONE, "==")
        for name, p, factors in (
            (c3, letter(c3) - c1 * c2 - s1 * s2, (ZERO - c2, ZERO - s2, ZERO - letter(c3))),
            (s3, letter(s3) - s1 * c2 + c1 * s2, (s2, ZERO - c2, ZERO - letter(s3))),
        ):
            facts = (last - 2, last - 1, norm)
            found = self.shows(
                p, "==", [[[1], [f], said(q)] for f, q in zip(facts, factors, strict=True)]
            )
            if found is None:
                raise ValueError("a difference of angles")
            self.of_sums[name] = found

    def named(self, text: str) -> str:
        ((name,),) = self.checker.value(text)
        return str(name)


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
