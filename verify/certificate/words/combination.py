"""Cofactors: a polynomial as a sum of products with equations in the middle, expanded and compared.

    residual = sum of left * (equation, or its transpose) * right

Each equation is zero wherever the hypotheses hold, so the residual is. The record is {"source",
"left": polynomial, "right": polynomial} and possibly "transposed": "yes".
"""

from __future__ import annotations

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.plain import Plain
from gainproof.verify.certificate.rejection import MalformedError, RejectedError
from gainproof.verify.certificate.words.polynomial import Polynomial, Shape
from gainproof.verify.certificate.words.relations import Ground

MAXIMUM_COFACTORS = 2_000


def combination(value: Plain, shape: Shape, ground: Ground, place: str) -> Polynomial:
    """The sum of all products, which have this shape."""
    entries = schema.items(value, place)
    if len(entries) > MAXIMUM_COFACTORS:
        raise MalformedError(f"{place}: more than {MAXIMUM_COFACTORS} cofactors")
    meter = ground.setting.meter
    total = ground.setting.zero(shape)
    for number, entry in enumerate(entries):
        here = f"{place}[{number}]"
        fields = dict(schema.table(entry, here))
        transposed = fields.pop("transposed", "no")
        schema.record(fields, ("source", "left", "right"), here)
        equation = ground.equation(fields["source"], here)
        if transposed == "yes":
            if equation.transposed() == equation:
                raise RejectedError(f"{here}: the equation is its own transpose")
            equation = equation.transposed()
        elif "transposed" in schema.table(entry, here):
            raise MalformedError(f'{here}: "transposed" is "yes" or not there')
        assert equation.shape is not None
        rows, columns = equation.shape
        left = ground.setting.polynomial(fields["left"], (shape[0], rows), here)
        right = ground.setting.polynomial(fields["right"], (columns, shape[1]), here)
        if not (left.terms and right.terms):
            raise RejectedError(f"{here}: a cofactor that is zero")
        product = left.times(equation, meter, here).times(right, meter, here)
        total = total.plus(product, meter, here)
    return total


def require_combination(residual: Polynomial, value: Plain, ground: Ground, place: str) -> None:
    """Reject unless the residual is the sum of these products."""
    assert residual.shape is not None
    total = combination(value, residual.shape, ground, place)
    rest = residual.plus(total.negative(), ground.setting.meter, place)
    if rest.terms:
        raise RejectedError(f"{place}: {len(rest.terms)} terms are left over")
