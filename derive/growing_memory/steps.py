"""Steps of growing-memory least squares: batch, recursion, starts, ends."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.growing_memory.fit import (
    GAIN_NAMES,
    Fit,
    J,
    K,
    entry_names,
    gain_vector,
    named,
)
from gainproof.derive.relation import Relation, cited, described, equal, limit
from gainproof.derive.source import GAUSS_MARKOV
from gainproof.derive.steady_state.towers import End

SHAPES = ("constant", "line", "parabola")
ENDS = {"0": End(), "infinity": End()}


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


def start_steps(f: Fit) -> list[Step]:
    """Which starts are admitted: how an error of the start reaches the first full fit."""
    size = f.size
    errors = tuple(f"d{n}" for n in range(1, size + 1))
    error = sp.ImmutableDenseMatrix([[real(name)] for name in errors])
    first = f.gain.subs(K, f.degree)
    steps = [
        Step(
            "start-gain",
            f"At sample {f.degree} the gain is this.",
            equal(
                gain_vector(size).applyfunc(lambda entry: sp.Subs(entry, K, sp.Integer(f.degree))),
                sp.ImmutableDenseMatrix(first),
            ),
            "Put k.",
        ),
        Step(
            "start",
            _start_sentence(f.degree),
            equal(
                sp.MatMul(_error_matrix(f, f.degree), error, evaluate=False),
                _start_errors(f.degree),
                free=errors,
            ),
            "(I - K H) F applied to the error (d1, ...) of the state one sample earlier.",
        ),
    ]
    if f.degree:
        factors = [_error_matrix(f, number) for number in range(f.degree, -1, -1)]
        steps.append(
            Step(
                "any-start",
                f"Run from sample 0 with the formula's own gains, any start at all is forgotten "
                f"at sample {f.degree}.",
                equal(sp.MatMul(*factors, evaluate=False), sp.zeros(size, size).as_immutable()),
                f"The product of (I - K H) F over samples 0..{f.degree} vanishes.",
            )
        )
    return steps


def _error_matrix(f: Fit, number: int) -> sp.ImmutableDenseMatrix:
    gain = gain_vector(f.size).applyfunc(lambda entry: sp.Subs(entry, K, sp.Integer(number)))
    return sp.ImmutableDenseMatrix((sp.eye(f.size) - gain * f.measurement) * f.transition)


def _start_sentence(degree: int) -> str:
    sentences = (
        "Any start is admitted: the first sample replaces it.",
        (
            "A start at sample 0 is admitted exactly if its position is the first measurement; "
            "its velocity does not matter."
        ),
        (
            "A start at sample 1 is admitted exactly if its position and its velocity less half "
            "its acceleration (in units T) are those of the line through the first two samples."
        ),
    )
    return sentences[degree]


def _start_errors(degree: int) -> sp.ImmutableDenseMatrix:
    d1, d2, d3 = real("d1"), real("d2"), real("d3")
    slope = d2 - d3 / 2
    return (
        sp.ImmutableDenseMatrix([[sp.Integer(0)]]),
        sp.ImmutableDenseMatrix([[sp.Integer(0)], [-d1]]),
        sp.ImmutableDenseMatrix(
            [[sp.Integer(0)], [-sp.Rational(3, 2) * d1 - slope / 2], [-d1 - slope]]
        ),
    )[degree]


def end_steps(f: Fit) -> list[Step]:
    """The gains fall to zero; how fast."""
    steps = []
    for order, (name, value) in enumerate(zip(GAIN_NAMES, f.gain, strict=False)):
        leading = sp.limit(value * K ** (order + 1), K, sp.oo)
        for label, expression, target in (
            (f"vanishing-{name}", real(name), sp.Integer(0)),
            (f"leading-{name}", real(name) * K ** (order + 1), leading),
        ):
            steps.append(
                Step(
                    label,
                    f"As samples accumulate, {name} falls like {leading}/k^{order + 1}."
                    if label.startswith("leading")
                    else f"As samples accumulate, {name} falls to zero.",
                    limit(expression, "infinity", target, variable="k"),
                    "Compare the leading coefficients.",
                    hint={"ends": ENDS},
                )
            )
    return steps
