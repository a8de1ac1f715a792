"""Proofs that `gainproof.verify.check_answer` multiplies out: zeros, signs, parts with values."""

from __future__ import annotations

from fractions import Fraction
from math import gcd, lcm
from typing import Any

from gainproof.verify.check_answer import ONE, VALUE, ZERO, Poly
from gainproof.verify.judge.answer_coefficients import by_coefficients
from gainproof.verify.judge.answer_polynomials import (
    Polynomials,
    constant,
    letter,
    pair,
    said,
    text_of,
)


class Proof(Polynomials):
    """What is looked for: each answer is the number of a fact that the checker has."""

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
        found = by_coefficients(self, p, strict)
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
