"""What is known to be positive (semi)definite, and what follows from it.

A reference is ["given", n], a letter by hypothesis; ["statement", id], larger - smaller of an
earlier order; ["unit", size], x' x > 0. Four rules, D standing for what is so known:

1. `squares`. c F' D F >= 0 for c > 0 and D >= 0: with y = F x, x' (c F' D F) x = c y' D y >= 0.
   Sums of such terms are >= 0, being sums of numbers >= 0.
2. `require_full_rank`. A sum of c_k F_k' D_k F_k is > 0 if D_k > 0 and sum L_k F_k = I over some k:
   were x' (sum) x = 0, each F_k x = 0, hence x = sum L_k F_k x = 0. The same for one F_k of full
   column rank: F_k x = 0 only for x = 0. Where D_k >= 0 only, D_k F_k stands for F_k: with
   y = F_k x and y' D_k y = 0, for every u and number s, (y + s u)' D_k (y + s u) = 2 s u' D_k y +
   s^2 u' D_k u is not negative, D_k being symmetric, hence u' D_k y = 0, and so D_k y = 0.
3. `require_vanishing`. N' D N = 0 with D > 0 makes N = 0: (N x)' D (N x) = 0 only for N x = 0.
   Where D >= 0 only, D N = 0: (N x)' D (N x) = 0 makes D N x = 0 as in rule 2.
4. `require_both_orders`. N >= 0 and -N >= 0 make N = 0: then x' N x = 0 for all x, so by polarity
   2 x' N y = (x + y)' N (x + y) - x' N x - y' N y = 0 for all x and y, N being symmetric.

Schur complements, orders of inverses, M = F X F' + Q and Joseph's form need no rules of their own:
they are such sums of squares.
"""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.matrix_words.combination import combination, require_combination
from gainproof.verify.certificate.matrix_words.polynomial import Polynomial, Shape
from gainproof.verify.certificate.matrix_words.relations import Ground
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.rejection import MalformedError, RejectedError

MAXIMUM_SQUARES = 50


@dataclass(frozen=True, slots=True)
class Square:
    """c F' D F with F = `factor` and D = `middle`; `strict`: D is positive definite."""

    value: Polynomial
    factor: Polynomial
    middle: Polynomial
    strict: bool


def known_definite(reference: Plain, ground: Ground, place: str) -> tuple[Polynomial, bool]:
    """A symmetric matrix that is positive semidefinite, and whether it is positive definite."""
    entries = schema.items(reference, place)
    if len(entries) != 2:
        raise MalformedError(f"{place}: two entries are wanted")
    if entries[0] == "given":
        found = ground.hypothesis(entries[1], ("definite", "semidefinite"), place)
        return ground.setting.letter(found.letter), found.kind == "definite"
    if entries[0] == "statement":
        earlier = ground.earlier(entries[1], "matrix_order", place)
        return earlier.difference, earlier.strict
    if entries[0] == "unit":
        size = schema.text(entries[1], place)
        if not any(size in shape for shape in ground.setting.shapes):
            raise RejectedError(f"{place}: there is no size {size!r}")
        return ground.setting.unit(size), True
    raise MalformedError(f"{place}: given, statement or unit is wanted")


def squares(value: Plain, shape: Shape, ground: Ground, place: str) -> list[Square]:
    """The squares of a list of {"weight", "factor", "definite"}: c a polynomial in positive
    parameters with positive coefficients, of no letters.
    """
    entries = schema.items(value, place)
    if len(entries) > MAXIMUM_SQUARES:
        raise MalformedError(f"{place}: more than {MAXIMUM_SQUARES} squares")
    setting, meter = ground.setting, ground.setting.meter
    found: list[Square] = []
    for number, entry in enumerate(entries):
        here = f"{place}[{number}]"
        fields = schema.record(entry, ("weight", "factor", "definite"), here)
        weight = setting.polynomial(fields["weight"], None, here)
        for (powers, _), coefficient in weight.terms.items():
            free = [p for p, positive in zip(powers, setting.positive, strict=True) if not positive]
            if coefficient < 0 or any(power % 2 for power in free):
                raise RejectedError(f"{here}: the weight is not positive")
        if not any(
            all(not p or s for p, s in zip(powers, setting.positive, strict=True))
            for powers, _ in weight.terms
        ):
            raise RejectedError(f"{here}: the weight is not positive")
        middle, strict = known_definite(fields["definite"], ground, here)
        assert middle.shape is not None
        factor = setting.polynomial(fields["factor"], (middle.shape[0], shape[1]), here)
        if not factor.terms or next(iter(factor.terms.values())) < 0:
            # minus the factor has the same square
            raise RejectedError(f"{here}: the first term of a factor is positive")
        product = factor.transposed(meter).times(middle, meter, here).times(factor, meter, here)
        found.append(Square(weight.times(product, meter, here), factor, middle, strict))
    return found


def require_order(
    difference: Polynomial, evidence: dict[str, Plain], ground: Ground, place: str
) -> list[Square]:
    """Reject unless the difference is a sum of squares and cofactors. Rule 1."""
    assert difference.shape is not None
    found = squares(evidence["squares"], difference.shape, ground, f"{place}.squares")
    rest = difference
    for square in found:
        rest = rest.minus(square.value, ground.setting.meter, place)
    require_combination(rest, evidence["cofactors"], ground, f"{place}.cofactors")
    return found


def require_full_rank(
    found: list[Square], value: Plain, shape: Shape, ground: Ground, place: str
) -> None:
    """Reject unless the squares together vanish at zero only. Rule 2.

    {"left_inverses": [[k, polynomial], ...], "cofactors"}: the unit matrix less the sum of
    L_k F_k, for [k, polynomial, "middle"] of L_k D_k F_k; or {"square": k, "given": n}: F_k is one
    letter, of full column rank by hypothesis.
    """
    setting, meter = ground.setting, ground.setting.meter
    if "square" in schema.table(value, place):
        fields = schema.record(value, ("square", "given"), place)
        square = _strict(found, fields["square"], place)
        letter = ground.hypothesis(fields["given"], ("full_column_rank",), place).letter
        if square.factor != setting.letter(letter):
            raise RejectedError(f"{place}: the factor is another matrix")
        return
    fields = schema.record(value, ("left_inverses", "cofactors"), place)
    rest = setting.unit(shape[0])
    for entry in schema.items(fields["left_inverses"], place):
        pair = schema.items(entry, place)
        if len(pair) != 2 and pair[2:] != ["middle"]:
            raise MalformedError(f"{place}: pairs of a number and a polynomial are wanted")
        if len(pair) == 2:
            factor = _strict(found, pair[0], place).factor
        else:
            square = found[schema.integer(pair[0], 0, len(found) - 1, place)]
            factor = square.middle.times(square.factor, meter, place)
        assert factor.shape is not None
        inverse = setting.polynomial(pair[1], (shape[0], factor.shape[0]), place)
        rest = rest.minus(inverse.times(factor, meter, place), meter, place)
    require_combination(rest, fields["cofactors"], ground, place)


def require_vanishing(
    difference: Polynomial, evidence: dict[str, Plain], ground: Ground, place: str
) -> None:
    """Reject unless N' D N is a combination of equations for a known D > 0. Rule 3.

    N is the difference ("side": "left") or its transpose ("right"). With "factor", K, and "rest" it
    is K' D K for a known D >= 0, and N - D K is the combination "rest".
    """
    meter = ground.setting.meter
    if evidence["side"] not in ("left", "right"):
        raise MalformedError(f'{place}: "side" is "left" or "right"')
    factor = difference if evidence["side"] == "left" else difference.transposed(meter)
    middle, strict = known_definite(evidence["definite"], ground, place)
    if "factor" in evidence:
        if middle.shape is None or factor.shape is None:
            raise RejectedError(f"{place}: a matrix is wanted, not a number")
        shape = (middle.shape[0], factor.shape[1])
        inner = ground.setting.polynomial(evidence["factor"], shape, f"{place}.factor")
        rest = factor.minus(middle.times(inner, meter, place), meter, place)
        require_combination(rest, evidence["rest"], ground, f"{place}.rest")
        factor = inner
    elif not strict:
        raise RejectedError(f"{place}: the matrix in the middle is not positive definite")
    product = factor.transposed(meter).times(middle, meter, place).times(factor, meter, place)
    assert product.shape is not None
    total = combination(evidence["cofactors"], product.shape, ground, place)
    if product.minus(total, meter, place).terms:
        raise RejectedError(f"{place}: the product is not shown to vanish")


def require_both_orders(difference: Polynomial, value: Plain, ground: Ground, place: str) -> None:
    """Reject unless the difference and minus it are known to be positive semidefinite. Rule 4.

    {"above": reference, "below": reference, "cofactors", "opposite"}: the difference less what is
    known "above" is the combination "cofactors", the sum of both is the combination "opposite".
    """
    evidence = schema.record(value, ("above", "below", "cofactors", "opposite"), place)
    meter = ground.setting.meter
    above, _ = known_definite(evidence["above"], ground, f"{place}.above")
    below, _ = known_definite(evidence["below"], ground, f"{place}.below")
    rest = difference.minus(above, meter, place)
    require_combination(rest, evidence["cofactors"], ground, f"{place}.cofactors")
    total = above.plus(below, meter, place)
    require_combination(total, evidence["opposite"], ground, f"{place}.opposite")


def _strict(found: list[Square], number: Plain, place: str) -> Square:
    square = found[schema.integer(number, 0, len(found) - 1, place)]
    if not square.strict:
        raise RejectedError(f"{place}: the middle of that square is only semidefinite")
    return square
