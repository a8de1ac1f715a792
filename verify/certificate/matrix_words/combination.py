"""Cofactors: a polynomial as a sum of products with equations in the middle, expanded and compared.

    residual = sum of left * (equation, or its transpose) * right

Each equation is zero wherever the hypotheses hold, so the residual is. The record is {"source",
"left": polynomial, "right": polynomial} and possibly "transposed": "yes".

No equation is 0 = 0, and the cofactors of one source do not cancel: with a letter of its own in the
place of the equation, their sum is not zero.
"""

from __future__ import annotations

from fractions import Fraction
from json import dumps

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.matrix_words.polynomial import Polynomial, Shape
from gainproof.verify.certificate.matrix_words.relations import Ground
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import MalformedError, RejectedError

MAXIMUM_COFACTORS = 2_000


def combination(value: Plain, shape: Shape, ground: Ground, place: str) -> Polynomial:
    """The sum of all products, which have this shape."""
    entries = schema.items(value, place)
    if len(entries) > MAXIMUM_COFACTORS:
        raise MalformedError(f"{place}: more than {MAXIMUM_COFACTORS} cofactors")
    meter = ground.setting.meter
    total = ground.setting.zero(shape)
    formal: dict[str, Polynomial] = {}
    for number, entry in enumerate(entries):
        here = f"{place}[{number}]"
        fields = dict(schema.table(entry, here))
        transposed = fields.pop("transposed", "no")
        schema.record(fields, ("source", "left", "right"), here)
        equation = ground.equation(fields["source"], here)
        if not equation.terms:
            raise RejectedError(f"{here}: the equation is 0 = 0")
        if transposed == "yes":
            turned = equation.transposed(meter)
            if equation in (turned, turned.negative(meter)):
                raise RejectedError(f"{here}: the equation is its own transpose, up to the sign")
            equation = turned
        elif "transposed" in schema.table(entry, here):
            raise MalformedError(f'{here}: "transposed" is "yes" or not there')
        assert equation.shape is not None
        word = (2 * len(ground.setting.names) + (transposed == "yes"),)
        unknown = Polynomial({(ground.setting.no_powers, word): Fraction(1)}, equation.shape)
        rows, columns = equation.shape
        left = ground.setting.polynomial(fields["left"], (shape[0], rows), here)
        right = ground.setting.polynomial(fields["right"], (columns, shape[1]), here)
        if not (left.terms and right.terms):
            raise RejectedError(f"{here}: a cofactor that is zero")
        product = left.times(equation, meter, here).times(right, meter, here)
        total = total.plus(product, meter, here)
        source = dumps(fields["source"])
        place_of_it = left.times(unknown, meter, here).times(right, meter, here)
        before = formal.get(source, ground.setting.zero(shape))
        formal[source] = before.plus(place_of_it, meter, here)
    for source, rest in formal.items():
        if not rest.terms:
            raise RejectedError(f"{place}: the cofactors of {source[:60]} cancel")
    return total


def require_combination(residual: Polynomial, value: Plain, ground: Ground, place: str) -> None:
    """Reject unless the residual is the sum of these products."""
    assert residual.shape is not None
    total = combination(value, residual.shape, ground, place)
    rest = residual.minus(total, ground.setting.meter, place)
    if rest.terms:
        raise RejectedError(f"{place}: {len(rest.terms)} terms are left over")
