"""Steps of growing-memory least squares: the batch, and the recursion that equals it."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.growing_memory.fit import (
    Fit,
    J,
    K,
    entry_names,
    gain_vector,
    named,
)
from gainproof.derive.relation import Relation, cited, described, equal
from gainproof.derive.source import GAUSS_MARKOV

SHAPES = ("constant", "line", "parabola")


def batch_steps(f: Fit) -> list[Step]:
    """From the normal equations to the gain."""
    size = f.size
    information, covariance = named("information", size), named("updated", size)
    steps = [
        Step(
            "model",
            f"A {SHAPES[f.degree]} is fitted by least squares to the samples 0, 1, ..., k; the "
            "state is the fitted value at sample k and its derivatives, in units of the sampling "
            "interval.",
            described("minimise the sum of squared residuals over samples 0..k"),
            "This is the problem; everything below follows from it.",
        )
    ]
    steps += [
        Step(
            f"power-sum-{m}",
            f"The sum of j^{m} for j = 0..k in closed form.",
            Relation(
                "sum",
                {
                    "index": "j",
                    "start": "0",
                    "upper": "k",
                    "summand": J**m,
                    "closed": total,
                },
            ),
            "Its difference from k - 1 to k is k^m, and it starts right.",
        )
        for m, total in enumerate(f.power_sums)
    ]
    steps += [
        Step(
            "information",
            "The matrix of the normal equations.",
            equal(
                information,
                sp.ImmutableDenseMatrix(
                    size,
                    size,
                    lambda a, b: (
                        (-1) ** (a + b) * f.power_sums[a + b] / (sp.factorial(a) * sp.factorial(b))
                    ),
                ),
            ),
            "Sum the squares of the rows (1, -j, j^2/2, ...).",
        ),
        Step(
            "definite",
            f"It is positive definite from sample {f.degree} on: the fit is unique.",
            Relation("positive_definite", {"matrix": entry_names("information", size)}),
            "Leading minors without a minus sign in k minus the first sample.",
        ),
        Step(
            "covariance",
            "Its inverse is the covariance of the fit for measurement noise of variance 1.",
            equal(sp.MatMul(information, covariance, evaluate=False), sp.eye(size).as_immutable()),
            "Multiply out.",
        ),
        Step(
            "gain",
            "The newest sample enters the fit at sample k with this gain.",
            equal(gain_vector(size), f.gain),
            "The first column of the covariance, since sample k is seen through (1, 0, ...).",
        ),
    ]
    return steps


def recursion_steps(f: Fit) -> list[Step]:
    """Batch and recursion agree, and the recursion is a Kalman filter without process noise."""
    size = f.size
    information, covariance = named("information", size), named("updated", size)
    predicted, gain = named("predicted", size), gain_vector(size)
    back = f.transition.inv()
    earlier = information.applyfunc(lambda entry: sp.Subs(entry, K, K - 1))
    before = covariance.applyfunc(lambda entry: sp.Subs(entry, K, K - 1))
    variance = predicted[0, 0] + 1
    return [
        Step(
            "information-recursion",
            "One more sample moves the information matrix on and adds one square: batch and "
            "recursion agree for every k.",
            equal(
                information,
                sp.MatAdd(
                    sp.MatMul(back.T, earlier, back, evaluate=False),
                    f.measurement.T * f.measurement,
                    evaluate=False,
                ),
            ),
            "Sums over j = 0..k, split at j = 0.",
        ),
        Step(
            "prediction",
            "The predicted covariance of a Kalman filter without process noise.",
            equal(
                predicted,
                sp.MatMul(f.transition, before, f.transition.T, evaluate=False),
            ),
            "M(k) = F P(k - 1) F'.",
            tower="later",
        ),
        Step(
            "kalman-gain",
            "Its Kalman gain is the least-squares gain.",
            equal(gain * variance, predicted[:, 0].as_immutable()),
            "K (H M H' + 1) = M H'.",
            tower="later",
        ),
        Step(
            "kalman-update",
            "Its updated covariance is that of the fit.",
            equal(covariance, predicted - gain * predicted[0, :]),
            "P = (I - K H) M.",
            tower="later",
        ),
        Step(
            "equivalence",
            "So the recursion with these gains is the fit, once started right.",
            cited(
                "Recursive least squares is the Kalman filter without process noise.",
                GAUSS_MARKOV.text(),
            ),
            "Cited for the name only; the equalities above prove it for these gains.",
        ),
    ]
