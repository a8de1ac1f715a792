"""What two coupled generators do where the first parameter tends to 0 or to infinity.

Of x^2 = a + b y and y^2 = c + e x the orders p and q of x and y in the parameter satisfy
2 p = max(order a, order b + q), 2 q = max(order c, order e + p) at infinity, with min at 0. What
attains them is left of the equations.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import sympy as sp

from gainproof.derive.algebra.leading_terms import NoLeadingTerm, leading, square_root
from gainproof.derive.algebra.limits import ConstantPair, End
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.expression import real

Order = Fraction | None


@dataclass(frozen=True)
class Found:
    """What is known of the generators so far, to be added to."""

    weights: dict[str, int]
    constants: dict[str, Any]
    boundary: dict[str, sp.Expr]
    roots: dict[str, sp.Expr]

    @property
    def end(self) -> End:
        """The same as an end."""
        return End(dict(self.weights), dict(self.constants), dict(self.boundary))


def add_pair(
    tower: Tower, number: int, found: Found, likely: Mapping[str, sp.Expr], *, at_infinity: bool
) -> None:
    """Add the pair that starts at this generator. Raises NoLeadingTerm.

    `likely`: values at the boundary that may solve what is left of the equations.
    """
    first, second = (entry.symbol for entry in tower.generators[number : number + 2])
    polys = [*tower.couplings(number), *tower.couplings(number + 1)]
    parts = [
        leading(tower, poly, found.end, found.roots, at_infinity) if poly else None
        for poly in polys
    ]
    orders = [None if part is None else Fraction(part[0].order) for part in parts]
    p, q = _orders(orders, at_infinity=at_infinity)
    if p.denominator != 1 or q.denominator != 1:
        raise NoLeadingTerm(f"{first} and {second} have no integer orders")
    wanted = (2 * p, 2 * p - q, 2 * q, 2 * q - p)
    a, b, c, e = (
        part[1] if part is not None and order == want else sp.Integer(0)
        for part, order, want in zip(parts, orders, wanted, strict=True)
    )
    side = 1 if at_infinity else -1
    found.weights[first], found.weights[second] = side * int(p), side * int(q)
    if b == 0:
        _add_root(found, first, a)
        _add_root(found, second, c + e * found.boundary[first])
    elif e == 0:
        _add_root(found, second, c)
        _add_root(found, first, a + b * found.boundary[second])
    elif not _add_likely(found, (first, second), likely, (a, b, c, e)):
        one, other = f"root_of_{first}", f"root_of_{second}"
        found.constants[one] = ConstantPair(other, (a, c), (b, e))
        for symbol, name in ((first, one), (second, other)):
            found.boundary[symbol] = found.roots[name] = real(name)


def _orders(orders: list[Order], *, at_infinity: bool) -> tuple[Fraction, Fraction]:
    """The one solution: each of the two equations is attained by one of its terms."""
    a, b, c, e = orders
    assert b is not None
    assert e is not None
    best: Callable[..., Fraction] = max if at_infinity else min

    def solves(p: Fraction, q: Fraction) -> bool:
        one = [order for order in (a, b + q) if order is not None]
        two = [order for order in (c, e + p) if order is not None]
        return best(one) == 2 * p and best(two) == 2 * q

    tried = [((2 * b + e) / 3, (2 * e + b) / 3)]
    if a is not None:
        tried.append((a / 2, (e + a / 2) / 2))
    if c is not None:
        tried.append(((b + c / 2) / 2, c / 2))
    if a is not None and c is not None:
        tried.append((a / 2, c / 2))
    for p, q in tried:
        if solves(p, q):
            return p, q
    raise NoLeadingTerm("no orders solve the equations of a coupled pair")


def _add_root(found: Found, symbol: str, square: sp.Expr) -> None:
    """The value of a generator whose rescaled square is known."""
    outside, inside = square_root(sp.expand(square))
    if inside == 1:
        found.boundary[symbol] = outside
        return
    name = f"root_of_{symbol}"
    found.constants[name] = inside
    found.roots[name] = sp.sqrt(inside.subs({real(k): root for k, root in found.roots.items()}))
    found.boundary[symbol] = outside * real(name)


def _add_likely(
    found: Found,
    symbols: tuple[str, str],
    likely: Mapping[str, sp.Expr],
    parts: tuple[sp.Expr, sp.Expr, sp.Expr, sp.Expr],
) -> bool:
    """Take the likely values where they solve what is left of the equations."""
    if any(symbol not in likely for symbol in symbols):
        return False
    (x, y), (a, b, c, e) = (likely[symbol] for symbol in symbols), parts
    if any(sp.expand(gap) != 0 for gap in (x**2 - a - b * y, y**2 - c - e * x)):
        return False
    found.boundary[symbols[0]], found.boundary[symbols[1]] = sp.expand(x), sp.expand(y)
    return True
