"""Variables replaced by values, all at once."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.certificate.nonzero import Nonzero
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.ratio import Ratio, number, polynomial
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.tower import Tower


def replaceable(tower: Tower, symbol: str) -> int:
    """The place of a symbol that may be replaced: a parameter or free symbol, no generators."""
    if tower.field.generators:
        raise RejectedError("substitution is possible only in a tower without generators")
    if symbol not in tower.field.variables():
        raise RejectedError(f"{symbol!r} cannot be replaced: it is not a variable of the tower")
    tower.used.add(symbol)
    return tower.field.variables().index(symbol)


def substituted(value: Ratio, new: Mapping[int, Ratio], nonzero: Nonzero) -> Ratio:
    """``value`` with the variables at some places replaced; denominators are shown nonzero again.

    The denominators must be all that the expression meant by ``value`` divides by, as is so for
    variables and named elements.
    """
    result = _put(value.numerator, new, value)
    for factor, multiplicity in value.factors.items():
        divisor = _put(factor, new, value)
        for _ in range(multiplicity):
            result = nonzero.quotient(result, divisor)
    return result


def _put(value: Polynomial, new: Mapping[int, Ratio], over: Ratio) -> Ratio:
    """Horner in one variable after the other; what was put in is not replaced again."""
    if not new:
        return polynomial(over.field, value)
    (position, replacement), *others = new.items()
    parts = value.by_power(position)
    result = number(over.field, 0)
    for exponent in range(max(parts, default=0), -1, -1):
        result = result * replacement
        if exponent in parts:
            result = result + _put(parts[exponent], dict(others), over)
    return result
