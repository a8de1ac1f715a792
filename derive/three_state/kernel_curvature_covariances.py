"""Second derivatives of both covariances by the index, in the numbers of `kernel_curvature`.

(q xi)'', (q eta)'' and (q tau)'' of `curvature` without a difference:
(q eta)'' tau^2 = P/(4 xi^2) + ... with P = 4 eta^5 + 5 a1 eta^4 + (16 a2 + 2 a1^2) eta^3
+ 22 a1 a2 eta^2 + (6 a1^2 a2 + 12 a2^2) eta + 5 a1 a2^2, and
2 tau^2 + 2 tau delta - 3 delta xi^3 = (a1 eta^3 + (a1^2/2 + 8 a2) eta^2 + 7 a1 a2 eta
+ 3 a1^2 a2/2)/xi^2.
"""

from __future__ import annotations

from typing import Any

from gainproof.derive.three_state import kernel_rational
from gainproof.derive.three_state.kernel_basis import KernelBasis
from gainproof.derive.three_state.kernel_curvature import Bend, weighted_or_none
from gainproof.derive.three_state.kernel_forms import (
    HALF,
    QUARTER,
    Forms,
    Noise,
    total,
)

SCALE = "_scale"
"""Ends the name of what an output of changing sign is measured by: its parts, added."""


def of_xi(b: Bend) -> Any:
    """(q xi)''."""
    return b.xi * (b.less * (b.less + 1) + b.fall * b.slowing)


def of_eta(b: Bend) -> Any:
    """(q eta)''."""
    a1, a2 = b.k.spectrum.a1, b.k.spectrum.a2
    first = b.polynomial(
        4,
        5 * a1,
        16 * a2 + 2 * a1 * a1,
        22 * a1 * a2,
        6 * a1 * a1 * a2 + 12 * a2 * a2,
        5 * a1 * a2 * a2,
    )
    main = (first / b.t) / b.t + (b.fall * b.slowing) * b.square
    if b.share is None:
        return b.eta * main
    cubic = (b.polynomial(4, 3 * a1, 4 * a2, a1 * a2) / b.t) * 2
    cross = b.polynomial(1, 2 * a1, 3 * a2) / b.t + b.share * 2
    return b.eta * (main + b.share * (cubic + b.square * cross + b.y * (2 * a1)))


def of_tau(b: Bend) -> Any:
    """(q tau)''."""
    a1, a2 = b.k.spectrum.a1, b.k.spectrum.a2
    rest = b.polynomial(a1, a1 * a1 / 2 + 8 * a2, 7 * a1 * a2, 3 * a1 * a1 * a2 / 2)
    first = ((b.y / b.t) * (rest / b.t)) * (b.less * 4)
    inner = total(first, (b.fall * b.slowing) * b.slope)
    if b.share is not None:
        over = ((b.square * b.y) / b.t) * (6 * a1) + b.part * 6
        inner = inner + b.share * total(b.less * over, b.much_less * 4, b.fall)
    k = b.k
    return (k.e / k.x) * ((((k.e / k.p) * (b.t * 4)) * inner) / k.r)


def predicted(k: KernelBasis, noise: Noise) -> Forms:
    """Of the predicted covariance: the entries that bend up everywhere."""
    b = Bend(k)
    inner = b.growth * (b.growth + 1) + (b.fall * b.bulk) * b.xi
    first = {"predicted_13": (inner * k.deviation) / k.index}
    return first | _rates(b, noise, of_xi(b), of_eta(b))


def _rates(b: Bend, noise: Noise, xi: Any, eta: Any) -> Forms:
    """Entries 22, 23 and 33 of the predicted covariance."""
    second = (of_tau(b) + xi) * (QUARTER * HALF) + (eta * QUARTER + (HALF + 2 * noise.rate))
    return {
        "predicted_22": second,
        "predicted_23": (eta + xi) * QUARTER + (HALF + noise.q23 - 2 * noise.q13),
        "predicted_33": total(xi * HALF, weighted_or_none(1, 2 * (1 - noise.q23))),
    }


def predicted_position(k: KernelBasis, _: Noise) -> Forms:
    """Of the predicted covariance: the entries of the position that bend down, then up."""
    b, per = Bend(k), k.deviation / k.index
    second = (k.x / k.r) * per
    bulk, ahead = (b.fall * b.bulk) * b.xi, b.less + b.growth
    return {
        **_difference(
            "predicted_11",
            ((b.growth * b.growth) * per) * (per * 4),
            ((b.bent * b.xi) * per) * (per * 2),
        ),
        **_difference(
            "predicted_12",
            second * total(ahead * b.growth, bulk, b.fall * b.slowing),
            second * (ahead * b.fall),
        ),
    }


def updated(k: KernelBasis, noise: Noise) -> Forms:
    """Of the updated covariance; the first row is the gain.

    But for one family of noises it is the difference of M'' and (M H' H M/(H M H' + R))''. Entry 22
    changes its sign; in entries 23 and 33 the two stay apart.
    """
    if k.spectrum.rational_in_root:
        return kernel_rational.second_derivatives(kernel_rational.Rational(k, noise))
    b = Bend(k)
    xi, eta = of_xi(b), of_eta(b)
    rates = _rates(b, noise, xi, eta)
    # the 2 is a product, since only a difference of computed numbers is measured by its parts
    taken = {"22": eta * HALF + k.spectrum.a1 / 2, "23": xi * HALF, "33": b.xi * (b.v * 2)}
    found: Forms = {}
    for place, value in taken.items():
        found |= _difference(f"updated_{place}", rates[f"predicted_{place}"], value)
    return found


def _difference(name: str, rising: Any, falling: Any) -> Forms:
    """A difference, and what measures its error: the sum of both parts."""
    return {name: rising - falling, f"{name}{SCALE}": rising + falling}
