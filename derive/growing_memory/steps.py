"""Steps of growing-memory least squares: the batch, and the recursion that equals it."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
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
            f"A {SHAPES[f.degree]} is fitted by least squares to the samples 0, 1, ..., `k`; the "
            "state is the fitted value at sample `k`"
            + (" and its derivatives, in units of the sampling interval." if f.degree else "."),
            described("minimise the sum of squared residuals over samples 0..k"),
            "This is the problem; everything below follows from it.",
            heading="The fit",
        )
    ]
    sums = [
        Relation(
            "sum", {"index": "j", "start": "0", "upper": "k", "summand": J**m, "closed": total}
        )
        for m, total in enumerate(f.power_sums)
    ]
    steps += [
        Step(
            "power-sum-0",
            "Sums over the samples in closed form." if f.degree else "The number of samples.",
            sums[0],
            f"{'Each' if f.degree else 'It'} is right for `k = 0`, and from `k - 1` to `k` it "
            "grows by the last term.",
        ),
        *(joined(f"power-sum-{m}", relation) for m, relation in enumerate(sums[1:], 1)),
    ]
    steps += [
        Step(
            "information",
            _rows_sentence(f.degree),
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
            "Entry by entry the products are powers of `j`; insert step @power-sum-0.",
        ),
        Step(
            "definite",
            f"It is positive definite from sample {f.degree} on: the fit is unique.",
            Relation("positive_definite", {"matrix": entry_names("information", size)}),
            f"Its leading minors have no minus sign when written in `k - {f.degree}`."
            if f.degree
            else "It has no minus sign.",
        ),
        Step(
            "covariance",
            "Its inverse `P` is the covariance of the fit for measurement noise of variance 1; its "
            "entries are `P11` and so on.",
            equal(sp.MatMul(information, covariance, evaluate=False), sp.eye(size).as_immutable()),
            "Multiply out.",
        ),
        Step(
            "gain",
            "The newest sample enters the fit at sample `k` with the gain `K` of these entries.",
            equal(gain_vector(size), f.gain),
            "The first column of `P` (step @covariance), since the row of the newest sample, "
            "`j = 0`, has a 1 in its first place and zeros else.",
        ),
    ]
    return steps


def _rows_sentence(degree: int) -> str:
    """What the information matrix is made of."""
    row = ("(1)", "(1, -j)", "(1, -j, j^2/2)")[degree]
    return (
        f"Sample `k - j` is seen through the row `{row}` of coefficients of the state. The matrix "
        "`N` of the normal equations, with entries `N11` and so on, is the sum of the squares of "
        "these rows over `j = 0..k`."
    )


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
            "The sum of step @information, split at `j = 0`: the older samples are seen from one "
            "interval further away.",
            heading="The recursion",
        ),
        Step(
            "prediction",
            "A Kalman filter without process noise predicts, from the covariance `P` one sample "
            "earlier, the covariance `M` with entries `M11` and so on.",
            equal(
                predicted,
                sp.MatMul(f.transition, before, f.transition.T, evaluate=False),
            ),
            "`M(k) = F P(k - 1) F'`, where `F` moves the state on by one interval.",
            tower="later",
        ),
        Step(
            "kalman-gain",
            "Its gain is the least-squares gain.",
            equal(gain * variance, predicted[:, 0].as_immutable()),
            "`K (H M H' + 1) = M H'`, where `H` takes the position from the state; insert steps "
            "@gain and @prediction.",
            tower="later",
        ),
        Step(
            "kalman-update",
            "Its updated covariance is that of the fit.",
            equal(covariance, predicted - gain * predicted[0, :]),
            "`P = (I - K H) M`; insert steps @covariance, @gain and @prediction.",
            tower="later",
        ),
        Step(
            "equivalence",
            "So the recursion with these gains is the fit, once started right.",
            cited(
                "Recursive least squares is the Kalman filter without process noise.",
                GAUSS_MARKOV.text(),
            ),
            "Cited for the name only; steps @kalman-gain and @kalman-update prove it for these "
            "gains.",
        ),
    ]
