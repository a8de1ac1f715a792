"""The innovation spectrum of a model, exactly, as a polynomial.

For a scalar measurement the spectrum of the innovations' driving process is, on the unit circle,

    R + H (z I - F)^-1 q Q0 (I / z - F')^-1 H'

and multiplied by det(z I - F) det(I / z - F) it becomes a Laurent polynomial with the same
coefficients at z^k and z^-k. Such a polynomial is an ordinary one in v = 2 - z - 1/z, of half the
degree, and is kept here in v: ``still`` for the part without process noise, ``driven`` for the
part that q multiplies. Everything is computed from the matrices in exact rational numbers
(Faddeev and LeVerrier's algorithm for the determinant and the adjugate), none of it is read from
a formula.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import flint

from gainproof.verify.oracles.matrices import Matrix, add, identity, product, scale
from gainproof.verify.oracles.state_space import StateSpace

Polynomial = list[Fraction]


@dataclass(frozen=True)
class Spectrum:
    """Exact polynomials of a model with scalar measurement, coefficients from low to high.

    ``still`` and ``driven``: the spectrum is still(v) + q driven(v). ``characteristic`` is
    det(z I - F) in powers of x = 1 - z. ``gain_matrix`` L solves for the predictor gain: with
    c the closed-loop polynomial in powers of x, F K = L (c - characteristic).
    """

    model: StateSpace
    still: flint.fmpq_poly
    driven: flint.fmpq_poly
    characteristic: tuple[flint.fmpq, ...]
    gain_matrix: flint.fmpq_mat


def spectrum(model: StateSpace) -> Spectrum:
    """The spectrum of ``model``, whose process noise is taken as the one for q = 1.

    Raises ValueError when the measurement is not scalar or the model is not observable.
    """
    if len(model.measurement) != 1:
        raise ValueError(f"needs one measured quantity, got {len(model.measurement)}")
    characteristic, adjugate = characteristic_and_adjugate(model.transition)
    row = [product(model.measurement, power)[0] for power in adjugate]
    sensor = model.measurement_noise[0][0]
    still = _laurent([characteristic], ((sensor,),))
    columns = [list(column) for column in zip(*row, strict=True)]
    driven = _laurent(columns, model.process_noise)
    shifted = [_in_distance_from_one(column) for column in columns]
    matching = flint.fmpq_mat(
        [[_rational(column[power]) for column in shifted] for power in range(model.size)]
    )
    try:
        gain_matrix = matching.inv()
    except ZeroDivisionError as singular:
        raise ValueError("not observable: the poles do not determine the gain") from singular
    return Spectrum(
        model,
        _in_v(still),
        _in_v(driven),
        tuple(_rational(x) for x in _in_distance_from_one(characteristic)),
        gain_matrix,
    )


def characteristic_and_adjugate(f: Matrix) -> tuple[Polynomial, list[Matrix]]:
    """det(z I - F) and the matrices of adj(z I - F), by powers of z from low to high."""
    size = len(f)
    coefficients = [Fraction(1)]
    unit = identity(size, Fraction(1))
    term = unit
    adjugate = [term]
    for k in range(1, size + 1):
        carried = product(f, term)
        coefficient = -sum((carried[i][i] for i in range(size)), Fraction(0)) / k
        coefficients.append(coefficient)
        term = add(carried, scale(coefficient, unit))
        adjugate.append(term)
    # the last term is zero by the theorem of Cayley and Hamilton
    if any(x != 0 for row in adjugate.pop() for x in row):
        raise ArithmeticError("F does not satisfy its own characteristic equation")
    return coefficients[::-1], adjugate[::-1]


def _laurent(rows: list[Polynomial], weight: Matrix) -> Polynomial:
    """Coefficients at z^0, z^1, ... of sum over i, j of rows_i(z) weight_ij rows_j(1/z)."""
    size = len(rows[0])
    total = [Fraction(0)] * size
    for i, left in enumerate(rows):
        for j, right in enumerate(rows):
            for lag in range(size):
                total[lag] += weight[i][j] * sum(
                    (left[k + lag] * right[k] for k in range(size - lag)), Fraction(0)
                )
    return total


def _in_v(laurent: Polynomial) -> flint.fmpq_poly:
    """The polynomial in v = 2 - z - 1/z that equals c_0 + sum of c_k (z^k + z^-k)."""
    around = flint.fmpq_poly([2, -1])
    before, current = flint.fmpq_poly([2]), around
    total = flint.fmpq_poly([_rational(laurent[0])])
    for coefficient in laurent[1:]:
        total += _rational(coefficient) * current
        before, current = current, around * current - before
    return total


def _in_distance_from_one(polynomial: Polynomial) -> Polynomial:
    """The coefficients in powers of x = 1 - z of a polynomial given in powers of z."""
    result = [Fraction(0)] * len(polynomial)
    for coefficient in reversed(polynomial):
        # Horner: result * (1 - x) + coefficient
        for k in reversed(range(1, len(result))):
            result[k] -= result[k - 1]
        result[0] += coefficient
    return result


def _rational(value: Fraction | int) -> flint.fmpq:
    return flint.fmpq(value.numerator, value.denominator)
