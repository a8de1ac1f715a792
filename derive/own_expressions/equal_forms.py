"""That two polynomials over parts are equal, as an identity of polynomials.

Of a part over_k = 1/d is known that 1 - over_k d is 0, of part_k = sqrt(a) that part_k^2 - a is, of
part_k = |a| that part_k^2 - a^2 is; of two parts of equal arguments that their difference is. A
difference that is a sum of multiples of these is 0; that it
is such a sum is an identity in all symbols, whatever they stand for.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import sympy as sp
from sympy.polys.rings import PolyElement, PolyRing

from gainproof.derive.expression import real
from gainproof.derive.own_expressions.parts import OVER, SQRT, NotReadError, Part

MOST = 2000
"""Terms of a polynomial on the way: a guard."""


def difference(value: sp.Expr, parts: Sequence[Part]) -> sp.Expr:
    """A polynomial over inputs and parts as a sum of multiples of what is 0; `parts` in the order
    in which they were read, each over those before it. NotReadError where it is none.
    """
    symbols = sorted({value, *(a for part in parts for a in part.arguments)}, key=str)
    names = sorted(
        {s for each in symbols for s in each.free_symbols} | {p.symbol for p in parts}, key=str
    )
    ring = PolyRing(names, sp.QQ, sp.lex)
    left, times, found = ring.from_expr(value), ring.one, list[sp.Expr]()
    alike = _alike(parts)
    for part in reversed(parts):
        if not left:
            break
        place = names.index(part.symbol)
        if part.symbol in alike:
            other = names.index(alike[part.symbol])
            left, factor = _renamed(left, place, other)
            power, zero = 0, part.symbol - alike[part.symbol]
        elif part.function == OVER:
            divisor = ring.from_expr(part.arguments[0])
            left, factor, power = _over(left, place, divisor)
            zero = 1 - part.symbol * part.arguments[0]
        elif part.function in (SQRT, "abs"):
            (argument,) = part.arguments
            square = argument if part.function == SQRT else argument**2
            left, factor = _squared(left, place, ring.from_expr(square))
            power, zero = 0, part.symbol**2 - square
        else:
            continue
        if factor:
            found.append((times * factor).as_expr() * zero)
        times = times * ring.gens[place] ** power
        if len(left) > MOST or len(times) > MOST:
            raise NotReadError("forms too long to be compared")
    if left:
        raise NotReadError("forms that are not shown to be equal")
    return sp.Add(*(_real(each) for each in found))


def same_arguments(parts: Sequence[Part]) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """Arguments that are equal polynomials, of parts that are therefore one number."""
    by_symbol = {part.symbol: part for part in parts}
    alike = _alike(parts)
    for symbol, first in alike.items():
        pairs = zip(by_symbol[symbol].arguments, by_symbol[first].arguments, strict=True)
        for one, other in pairs:
            if one.xreplace(alike) != other.xreplace(alike):
                yield one.xreplace(alike), other.xreplace(alike)


def require_values(
    printed: Sequence[Part], every: Sequence[Part], positive: Sequence[sp.Expr]
) -> None:
    """NotReadError for a divisor among `every` part that may be 0 where no `printed` one is, and
    for a root of what may be negative that is not printed: what was given has no value there, and
    what is printed would have one. `positive`: what inputs are asked to make so.
    """
    alike = _alike(every)
    fine = {factor for value in positive for factor in _factors(value, alike)}
    for part in printed:
        fine |= _factors(part.arguments[0], alike) if part.function == OVER else set()
    for part in reversed(every):  # of a root that is not 0 its argument is not
        if part.function == SQRT and part.symbol.xreplace(alike) in fine:
            fine |= _factors(part.arguments[0], alike)
    for part in every:
        left_out = part not in printed and part.symbol not in alike
        if part.function == "atan2" and left_out:
            raise NotReadError(f"{part}, where it has no value, is left out")
        if part.function == SQRT and left_out and not _never_negative(part.arguments[0]):
            raise NotReadError(
                f"{part.arguments[0]} may be negative, and no root is taken any more"
            )
        if part.function == SQRT and _factors(part.arguments[0], alike) <= fine:
            fine.add(part.symbol)
        if part.function == OVER and not _factors(part.arguments[0], alike) <= fine:
            raise NotReadError(f"{part.arguments[0]} may be 0, and is not divided by any more")


def _never_negative(value: sp.Expr) -> bool:
    """Whether a polynomial shows it: even powers with positive factors."""
    terms = sp.Poly(value, *sorted(value.free_symbols, key=str)).terms()
    return all(c > 0 and all(power % 2 == 0 for power in powers) for powers, c in terms)


def _factors(value: sp.Expr, alike: Mapping[sp.Symbol, sp.Symbol]) -> set[sp.Expr]:
    """The factors of a polynomial that are no numbers, each made monic."""
    _, factors = sp.factor_list(value.xreplace(dict(alike)))
    return {
        sp.Poly(factor, *sorted(factor.free_symbols, key=str)).monic().as_expr()
        for factor, _ in factors
    }


def _alike(parts: Sequence[Part]) -> dict[sp.Symbol, sp.Symbol]:
    """Parts that are another one before them, since their arguments are equal polynomials."""
    known: dict[tuple[object, ...], sp.Symbol] = {}
    found: dict[sp.Symbol, sp.Symbol] = {}
    for part in parts:
        arguments = (sp.expand(each.xreplace(found)) for each in part.arguments)
        first = known.setdefault((part.function, *arguments), part.symbol)
        if first != part.symbol:
            found[part.symbol] = first
    return found


def _renamed(poly: PolyElement, place: int, other: int) -> tuple[PolyElement, PolyElement]:
    """With s and t the symbols: poly = (s - t) factor + the same with t for s."""
    symbol, first = poly.ring.gens[place], poly.ring.gens[other]
    rest, factor = poly.ring.zero, poly.ring.zero
    for degree, coefficient in _by_power(poly, place).items():
        rest += coefficient * first**degree
        powers = (symbol**k * first ** (degree - 1 - k) for k in range(degree))
        factor += coefficient * sum(powers, poly.ring.zero)
    return rest, factor


def _over(
    poly: PolyElement, place: int, divisor: PolyElement
) -> tuple[PolyElement, PolyElement, int]:
    """With o the symbol of the part and d its divisor: poly = (1 - o d) factor + o^power rest."""
    by_power = _by_power(poly, place)
    power = max(by_power, default=0)
    one, symbol = poly.ring.one, poly.ring.gens[place]
    rest, factor, unit = poly.ring.zero, poly.ring.zero, symbol * divisor
    for degree, coefficient in by_power.items():
        rest += coefficient * divisor ** (power - degree)
        total = sum((unit**k for k in range(power - degree)), poly.ring.zero)
        factor += coefficient * symbol**degree * total
    return rest, factor * one, power


def _squared(poly: PolyElement, place: int, square: PolyElement) -> tuple[PolyElement, PolyElement]:
    """With s the symbol of the part: poly = (s^2 - square) factor + rest, at most linear in s."""
    symbol, factor = poly.ring.gens[place], poly.ring.zero
    while poly.degree(place) > 1:
        high = sum(
            (c * symbol ** (n - 2) for n, c in _by_power(poly, place).items() if n > 1),
            poly.ring.zero,
        )
        factor += high
        poly = poly - high * (symbol**2 - square)
    return poly, factor


def _by_power(poly: PolyElement, place: int) -> dict[int, PolyElement]:
    """Coefficients of the powers of one symbol."""
    found: dict[int, dict[tuple[int, ...], sp.Rational]] = {}
    for term, value in poly.terms():
        found.setdefault(term[place], {})[(*term[:place], 0, *term[place + 1 :])] = value
    return {power: poly.ring.from_dict(terms) for power, terms in found.items()}


def _real(value: sp.Expr) -> sp.Expr:
    """With the real symbols of expressions, not those of rings."""
    return value.xreplace({symbol: real(symbol.name) for symbol in value.free_symbols})
