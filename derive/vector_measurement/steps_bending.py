"""Steps on second derivatives with respect to the index, the velocity's error held.

D is the derivative of the updated covariance by Lambda^2, that is by the process noise.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from gainproof.derive.algebra.derivative import derivative
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, limit, positive
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import (
    GAINS,
    INDEX,
    PREDICTED,
    RATIO,
    ROOT,
    UPDATED,
    gain_matrix,
    row,
    symmetric,
)
from gainproof.derive.vector_measurement.steps_trends import index_ends

CHANGES = ("change_11", "change_12", "change_22")
BENDING_LATEX = {name: f"D_{{{name[-2:]}}}" for name in CHANGES}
TOWER = "bending"
SHARE = {"gain_11": sp.Integer(1), "gain_12": RATIO**-2, "gain_21": sp.Integer(1)}
SHARE["gain_22"] = RATIO**-2


def bending_tower(c: Context) -> Tower:
    """The main tower with D by name."""
    named = {
        name: c.tower.expression(derivative(c.tower, real(entry), "tracking_index")) / (2 * INDEX)
        for name, entry in zip(CHANGES, UPDATED, strict=True)
    }
    main = c.tower
    return Tower(TOWER, main.parameters, main.generators, {**main.expressions, **named})


def bending_steps(c: Context) -> list[Step]:
    """The covariance bends down over the square of the index; the gains' second derivatives."""
    first, *others = _down(c)
    return [
        *_equation(c),
        replace(
            first,
            sentence="So over the square of the index the velocity's variance bends down, and "
            "with it the velocity's gain `K22 = U22/S^2`.",
            reason="What is taken away is a covariance, and what the stable `(I - K) F` leaves "
            "of all earlier ones adds up. The checker writes the derivative as a quotient of sums "
            "without a minus sign.",
            joins=False,
        ),
        *others,
        Step(
            "second-derivative-gains",
            "Over the index itself a gain's second derivative is a sum of two terms. On the "
            "diagonal the first is positive and the second negative, so that the sum may have "
            "either sign: no form without a subtraction is to be had for all, and no kernel gives "
            "them.",
            equal(
                row(*(_second(name) for name in GAINS)),
                row(*(SHARE[name] * _twice(name) for name in GAINS)),
            ),
            "The chain rule, twice: `dU/dLambda = 2 Lambda D`, and `K = U R^-1`.",
            tower=TOWER,
        ),
        *_ends(c),
    ]


def _of(gain: str) -> sp.Expr:
    """The entry of D that belongs to a gain."""
    return real("change_12" if gain == "gain_21" else gain.replace("gain", "change"))


def _twice(gain: str) -> sp.Expr:
    """The second derivative by the index of the entry of U that belongs to a gain."""
    return 2 * (_of(gain) + INDEX * sp.Derivative(_of(gain), INDEX))


def _second(name: str) -> sp.Expr:
    return sp.Derivative(real(name), (INDEX, 2))


def _equation(c: Context) -> list[Step]:
    """D, and the equation of its derivative."""
    change, identity = symmetric(CHANGES), sp.eye(2)
    slopes = [sp.Derivative(real(name), INDEX) / (2 * INDEX) for name in UPDATED]
    bend = change.applyfunc(lambda entry: sp.Derivative(entry, INDEX) / (2 * INDEX))
    loop = (identity - gain_matrix()) * c.model.transition
    gain = change * sp.diag(1, RATIO**-2)
    innovation = symmetric(PREDICTED) + sp.diag(1, RATIO**2)
    right = sp.MatAdd(sp.MatMul(loop, bend, loop.T), sp.MatMul(-2 * gain, innovation, gain.T))
    return [
        Step(
            "change-of-updated",
            "How does the steady state bend? Take the square of the index as the variable, of "
            "which `Q` is a multiple. The derivative of the updated covariance is `D`, with the "
            "entries `D11`, `D12`, `D22`.",
            equal(row(*map(real, CHANGES)), row(*slopes)),
            "Its name; `d/d(Lambda^2)` is `(1/(2 Lambda)) d/dLambda`.",
            tower=TOWER,
            heading="How the steady state bends",
        ),
        Step(
            "bend-of-updated",
            "The derivative of `D` follows the closed loop, less twice the covariance that the "
            "change of the gain, `D R^-1`, makes of the innovations.",
            equal(bend, right),
            "Differentiate step @riccati by `Lambda^2` twice. Once it is "
            "`D = (I - K) (F D F' + Q0) (I - K)'`; `P + R` is the covariance of the innovations.",
            tower=TOWER,
        ),
    ]


def _down(c: Context) -> list[Step]:
    """The entries whose derivative shows its sign."""
    both = c.noise.interval and not c.noise.e
    names = ("change_22", "change_11") if both else ("change_22",)
    return [
        joined(
            f"bends-down-{name.replace('_', '-')}",
            positive(-sp.Derivative(real(name), INDEX)),
            TOWER,
            {"form": -_slope(c, name.replace("change", "updated"))},
        )
        for name in names
    ]


def _slope(c: Context, updated: str) -> sp.Expr:
    """The derivative of an entry of D, evaluated."""
    change = c.tower.expression(derivative(c.tower, real(updated), "tracking_index")) / (2 * INDEX)
    return c.tower.expression(derivative(c.tower, change, "tracking_index"))


def _ends(c: Context) -> list[Step]:
    """The gains' second derivatives where the index vanishes."""
    ends, root = index_ends(c.noise), sp.sqrt(sp.Integer(2))
    near = {
        "gain_11": (ROOT**3, -root / 4),
        "gain_12": (ROOT, -3 * root / (8 * RATIO**2)),
        "gain_21": (ROOT, -3 * root / 8),
        "gain_22": (ROOT, 3 * root / (4 * RATIO**2)),
    }
    first, *others = (
        joined(
            f"small-second-{name.replace('_', '-')}",
            limit(_second(name) * power, "0", value),
            hint={"ends": ends},
        )
        for name, (power, value) in near.items()
    )
    return [
        replace(
            first,
            sentence="Near a vanishing index, `S` held, all of them grow beyond all bounds; those "
            "of the gains on the measured position as without a measured velocity.",
            reason="Differentiate the entries twice and insert the leading terms of the roots.",
            joins=False,
        ),
        *others,
    ]
