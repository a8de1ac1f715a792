"""Signs of polynomials by their coefficients, once variables are moved to what bounds them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import product
from typing import Any

from gainproof.verify.check_answer import ONE, ZERO, Poly
from gainproof.verify.judge.answer_polynomials import Polynomials, constant, letter, pair

ELEVATIONS = (0, 1, 3, 8, 20)
"""Powers of what is positive that are tried as a factor of a polynomial in one variable."""
SMALL = (Fraction(1), Fraction(1, 8), Fraction(1, 1000))


def by_coefficients(proof: Polynomials, p: Poly, strict: bool) -> int | None:
    """The number of the fact that a polynomial is positive, or not negative if not strict: its
    coefficients have one sign once variables are counted from their bounds. None if not found.
    """
    if any(not m for m in p) and len(p) == 1:
        return proof.shows(p, ">", [[pair(p[()]), []]]) if p[()] > 0 else None
    sign = ">" if strict else ">="
    variables = [n for n in proof.order if proof.checker.letters[n][0] == "real"]
    for chosen in _choices(proof, variables):
        for power in ELEVATIONS if len({k for m in p for k in m}) == 1 else (0,):
            moved = _moved(proof, p, chosen, power)
            if moved is not None:
                terms, times = moved
                found = proof.shows(p, sign, terms, times)
                if found is not None:
                    return found
                if strict:
                    for least in SMALL:
                        rest = by_coefficients(proof, p - constant(least), False)
                        if rest is not None:
                            return proof.shows(p, ">", [[[1], [rest]], [pair(least), []]])
    return None


def _choices(proof: Polynomials, variables: Sequence[str]) -> Iterator[dict[str, tuple[Any, Any]]]:
    """For each variable a fact that bounds it from below and one from above, or none."""
    options = []
    for name in variables:
        low: list[Any] = []
        high: list[Any] = []
        for k in proof.bounds:
            g, sign = proof.checker.facts[k]
            slope = proof.by_degree(g, name)
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


def _moved(
    proof: Polynomials, p: Poly, chosen: Mapping[str, tuple[Any, Any]], power: int
) -> tuple[list[Any], list[Any]] | None:
    """Terms of a sum that is a factor times the polynomial, and that factor, as `shows` has them;
    None if some coefficient is negative. A variable with one bound is written as that and a new
    one above 0, one between two bounds as their mean by weights above 0.
    """
    facts, scale, factor = dict[str, int](), Fraction(1), list[int]()
    waiting = [n for n in chosen if chosen[n] != (None, None)]
    made = False
    while waiting:
        met = {k for m in p for k in m}
        below = {
            n: {k for f in chosen[n] if f is not None for m in proof.checker.facts[f][0] for k in m}
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
        parts, total = proof.by_degree(p, name), ZERO
        one = proof.by_degree(proof.checker.facts[low if low is not None else high][0], name)
        slope, rest = one[1][()], one.get(0, ZERO)
        if low is None or high is None:
            # facts are slope v + rest, under the name of the variable from here on
            value = (letter(name) - rest) * constant(1 / Fraction(slope))
            bottom = ONE
            facts[name] = low if low is not None else high
            extra = ONE + letter(name)
            grown = proof.shows(
                ONE + proof.checker.facts[facts[name]][0], ">", [[[1], []], [[1], [facts[name]]]]
            )
            raise_by = [grown] * power if power else []
        else:
            two = proof.by_degree(proof.checker.facts[high][0], name)
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
                wide = proof.shows(width, ">", terms)
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
            if own is None and proof.checker.letters[name][0] in ("sqrt", "exp", "over"):
                own = proof.fact(letter(name), ">", ">=")
            if own is None:
                odd.append(name)
            else:
                used.append(own)
        if c < 0 or any(odd.count(name) % 2 for name in odd):
            return None
        root = tuple(name for name in sorted({*odd}) for _ in range(odd.count(name) // 2))
        terms.append([pair(c), used, *([[[[1], *root]]] if root else [])])
    return terms, [pair(scale), factor]
