"""The variable of a limit: the parameter itself, or an element that runs with it.

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


def require_end(tower: Tower, name: str, at_infinity: bool) -> None:
    """Reject unless ``name`` tends to 0 (or infinity) exactly when the parameter does."""
    field = tower.field
    if len(field.parameters) != 1:
        raise RejectedError("limits are possible in towers with one parameter only")
    value = tower.value(name)
    if tower.parameter_position(name) is not None:
        if not at_infinity and field.parameters[0].lower != 0:
            raise RejectedError(f"the parameter {name!r} does not reach 0")
        return
    if name not in tower.elements:
        raise RejectedError(f"{name!r} is neither the parameter nor an element")
    if not field.positive_inside(value.numerator):
        raise RejectedError(f"{name!r} is not manifestly positive")
    lowest, degree = _orders(field, value.numerator)
    for factor, multiplicity in value.factors.items():
        inner_lowest, inner_degree = _orders(field, factor)
        lowest -= multiplicity * inner_lowest
        degree -= multiplicity * inner_degree
    reached = degree > 0 and lowest >= 0 if at_infinity else lowest > 0 and degree >= 0
    if not reached:
        end = "infinity" if at_infinity else "0"
        raise RejectedError(
            f"{name!r} is not shown to tend to {end} with the parameter, and only then"
        )


def require_increasing_bijection(tower: Tower, name: str) -> None:
    """Reject unless ``name`` is the parameter, or an element that tends to 0 and to infinity.

    The derivative by the element is formed by dividing by the element's own derivative, shown
    nonzero; so the element then increases from 0 to infinity.
    """
    if tower.parameter_position(name) is None:
        require_end(tower, name, at_infinity=False)
        require_end(tower, name, at_infinity=True)


def _orders(field: Field, value: Polynomial) -> tuple[int, int]:
    """Lowest order and degree in the distance of the parameter from its lower end."""
    for index in range(len(field.generators)):
        if value.occurs(field.position(index)) and not _is_constant(field, index):
            raise RejectedError(
                "the variable of a limit holds a generator that depends on the parameter"
            )
    exponents = [monomial[0] for monomial in field.shifted(value).terms]
    return min(exponents), max(exponents)


def _is_constant(field: Field, index: int) -> bool:
    radicand = field.generators[index].radicand
    return not radicand.occurs(0) and all(
        _is_constant(field, i) for i in range(index) if radicand.occurs(field.position(i))
    )
