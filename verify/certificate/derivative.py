"""Derivatives over a tower, generators following."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.certificate.coupled_roots import Pair
from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.nonzero_divisors import Nonzero
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.ratio import Ratio, number, polynomial, total
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.tower import Tower
from gainproof.verify.certificate.variable import running_parameter


def derivative(tower: Tower, value: Ratio, symbol: str, nonzero: Nonzero) -> Ratio:
    """The derivative of ``value`` by ``symbol``, generators following.

    The symbol is a parameter (other parameters and free symbols held), a free symbol (everything
    else held), or an element x that depends on one parameter p alone: then (dE/dp) / (dx/dp), the
    other parameters held.
    """
    field = tower.field
    position = tower.parameter_position(symbol)
    if position is None and symbol in field.free:
        position = field.free_positions()[field.free.index(symbol)]
    if position is not None:
        tower.used.add(symbol)
        return by_variable(value, position)
    if symbol not in tower.elements:
        raise RejectedError(
            f"no derivative by {symbol!r}: a parameter is wanted, or an element that depends on "
            "one alone"
        )
    position = running_parameter(tower, symbol)
    return nonzero.quotient(
        by_variable(value, position), by_variable(tower.value(symbol), position)
    )


def by_variable(value: Ratio, position: int) -> Ratio:
    """The total derivative by one parameter or free symbol, generators following."""
    field = value.field
    rates = _rates(field, position)
    result = _along(field, value.numerator, rates)
    for factor, multiplicity in value.factors.items():
        share = _along(field, factor, rates) * polynomial(field, value.numerator)
        share = share * number(field, multiplicity)
        result = result - Ratio(field, share.numerator, _more(share, factor))
    return Ratio(field, result.numerator, _merged(result, value))


def _rates(field: Field, position: int) -> list[Ratio]:
    """The derivative of every variable by the one at ``position``."""
    rates = [number(field, int(i == position)) for i in range(field.ring.size)]
    for index, generator in enumerate(field.generators):
        place = field.position(index)
        if generator.pair is not None:
            if generator.pair.position == place:
                rates[place : place + 2] = _pair_rates(field, generator.pair, rates)
            continue
        slope = _along(field, generator.radicand, rates)
        below = field.ring.monomial({place: generator.power - 1})
        rates[place] = slope.over(polynomial(field, below.times(Fraction(generator.power))))
    return rates


def _pair_rates(field: Field, pair: Pair, rates: list[Ratio]) -> tuple[Ratio, Ratio]:
    """x' and y' of a coupled pair, by Cramer's rule over its positive determinant."""
    x, y = (polynomial(field, entry) for entry in pair.variables)
    b, e = (polynomial(field, entry) for entry in pair.slopes)
    da, dc, db, de = (_along(field, entry, rates) for entry in pair.coefficients)
    first, second = da + db * y, dc + de * x
    below = polynomial(field, pair.determinant)
    if not field.positive(below.numerator):
        raise RejectedError(f"the determinant of {pair.symbols} is not manifestly positive")
    both, two = x * y, number(field, 2)
    return (
        (both * (two * y * first + b * second)).over(below),
        (both * (two * x * second + e * first)).over(below),
    )


def _along(field: Field, value: Polynomial, rates: list[Ratio]) -> Ratio:
    """The sum of the partial derivatives times the rates of the variables."""
    return total(
        field,
        (
            polynomial(field, value.partial(i)) * rate
            for i, rate in enumerate(rates)
            if not rate.is_zero() and value.occurs(i)
        ),
    )


def _more(value: Ratio, factor: Polynomial) -> dict[Polynomial, int]:
    factors = dict(value.factors)
    factors[factor] = factors.get(factor, 0) + 1
    return factors


def _merged(value: Ratio, other: Ratio) -> dict[Polynomial, int]:
    factors = dict(value.factors)
    for factor, multiplicity in other.factors.items():
        factors[factor] = factors.get(factor, 0) + multiplicity
    return factors
