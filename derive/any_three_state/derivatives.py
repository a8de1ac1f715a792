"""First derivatives of the gains with respect to the index, in the manner of `forms`.

d0 d0' = Lambda n0, d3 d3' = Lambda n3, and with r1 = Lambda n1 + d0' d2, r2 = Lambda n2 + d3' d1
the coupled pair gives (d1 d2 - d0 d3) d1' = r1 d2 + r2 d0 and (d1 d2 - d0 d3) d2' = r2 d1 + r1 d3.
A gain's derivative times d0 d3 (d1 d2 - d0 d3) is a polynomial in the roots, as the gain is one.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from gainproof.derive.algebra.derivative import along
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.any_three_state import forms
from gainproof.derive.any_three_state.basis import Basis
from gainproof.derive.any_three_state.forms import Form
from gainproof.derive.any_three_state.model_numbers import Shape
from gainproof.derive.any_three_state.names import DETERMINANT, INDEX, ROOTS
from gainproof.derive.any_two_state.signed_values import Signed, total


def slopes(x: Basis) -> tuple[Signed, Signed, Signed, Signed]:
    """The derivatives of d0, ..., d3."""
    d0, d1, d2, d3 = x.roots
    n0, n1, n2, n3 = (x.term(noise, x.index) for noise in x.shape.shaken)
    first, last = n0.over(d0), n3.over(d3)
    rise1, rise2 = n1 + first.times(d2), n2 + last.times(d1)
    below = x.determinant
    one = (rise1.times(d2) + rise2.times(d0)).over(below)
    two = (rise2.times(d1) + rise1.times(d3)).over(below)
    return first, one, two, last


def alpha(x: Basis) -> Any:
    """The derivative of the first gain, 128 N'/N^3: a sum without a minus sign."""
    n = x.sum_of_roots
    return (total(*slopes(x)).plus / n) * ((128 / n) / n)


def gain_form(shape: Shape, tower: Tower, name: str) -> Form:
    """The derivative of the second or the third gain."""
    weights, _ = shape.closed_loop
    row = (weights[{"beta": 1, "gamma": 2}[name], :] * sp.Matrix(ROOTS))[0]
    d0, d1, d2, d3 = ROOTS
    n0, n1, n2, n3 = (INDEX * noise for noise in shape.shaken)
    rates = (
        n0 * d3 * DETERMINANT,
        d3 * d2 * (n1 * d0 + n0 * d2) + d0**2 * (n2 * d3 + n3 * d1),
        d0 * d1 * (n2 * d3 + n3 * d1) + d3**2 * (n1 * d0 + n0 * d2),
        n3 * d0 * DETERMINANT,
    )
    whole = row * (d1 + d3 - d0 - d2) / (64 * shape.determinant)
    value = along(whole, dict(zip(ROOTS, rates, strict=True)))
    return forms.find(shape, tower, tower.fraction(value), (d0, d3, DETERMINANT))
