"""The variable of a limit or a derivative: a parameter, or an element that runs with one alone.

Every other parameter of the tower is held at any value of its domain. So an element serves only if
one parameter occurs in it and no other, also inside generators.

A limit in an element x(p) is the limit in the parameter p at the same end only if x reaches 0 (or
infinity) there and nowhere else. That is read off when x is a manifestly positive quotient of
polynomials in p (generators that do not depend on p may occur in the coefficients), with orders
measured in the distance of p from its lower end:

- 0 at the lower end: the numerator's lowest order exceeds the denominator's, and its degree is not
  below the denominator's, so that x stays away from 0 elsewhere, also at infinity;
- infinity at infinity: the numerator's degree exceeds the denominator's, and its lowest order is
  not below the denominator's, so that x stays bounded elsewhere, also at the lower end.
"""

from __future__ import annotations

from gainproof.verify.certificate.field import Field
from gainproof.verify.certificate.polynomial import Polynomial
from gainproof.verify.certificate.rejection import RejectedError
from gainproof.verify.certificate.tower import Tower


def running_parameter(tower: Tower, name: str) -> int:
    """The place of the parameter of that name, or of the one on which the element alone depends."""
    position = tower.parameter_position(name)
    value = tower.value(name)
    if position is not None:
        return position
    if name not in tower.elements:
        raise RejectedError(f"{name!r} is neither a parameter nor an element")
    field = tower.field
    found = field.depends_on(value.numerator).union(
        *(field.depends_on(factor) for factor in value.factors)
    )
    if len(found) != 1:
        raise RejectedError(
            f"{name!r} depends on {len(found)} parameters: an element that depends on one alone "
            "is wanted, the others being held"
        )
    return next(iter(found))


def require_end(tower: Tower, name: str, at_infinity: bool) -> int:
    """The parameter that ``name`` runs with.

    Raises RejectedError unless ``name`` tends to 0 (or infinity) exactly when that parameter does.
    """
    field = tower.field
    position = running_parameter(tower, name)
    if tower.parameter_position(name) is not None:
        if not at_infinity and field.parameters[position].lower != 0:
            raise RejectedError(f"the parameter {name!r} does not reach 0")
        return position
    value = tower.value(name)
    if not field.positive_inside(value.numerator):
        raise RejectedError(f"{name!r} is not manifestly positive")
    lowest, degree = _orders(field, value.numerator, position)
    for factor, multiplicity in value.factors.items():
        inner_lowest, inner_degree = _orders(field, factor, position)
        lowest -= multiplicity * inner_lowest
        degree -= multiplicity * inner_degree
    reached = degree > 0 and lowest >= 0 if at_infinity else lowest > 0 and degree >= 0
    if not reached:
        end = "infinity" if at_infinity else "0"
        raise RejectedError(
            f"{name!r} is not shown to tend to {end} with the parameter, and only then"
        )
    return position


def require_increasing_bijection(tower: Tower, name: str) -> int:
    """The parameter itself, or that of an element which tends to 0 and to infinity with it.

    The derivative by the element is formed by dividing by the element's own derivative, shown
    nonzero; so the element then increases from 0 to infinity.
    """
    if tower.parameter_position(name) is None:
        require_end(tower, name, at_infinity=False)
        require_end(tower, name, at_infinity=True)
    return running_parameter(tower, name)


def _orders(field: Field, value: Polynomial, position: int) -> tuple[int, int]:
    """Lowest order and degree in the distance of the parameter from its lower end."""
    for index, generator in enumerate(field.generators):
        if value.occurs(field.position(index)) and field.depends_on(generator.radicand):
            raise RejectedError(
                "the variable of a limit holds a generator that depends on the parameter"
            )
    exponents = field.shifted_at(value, position).by_power(position)
    return min(exponents), max(exponents)
