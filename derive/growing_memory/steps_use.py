"""Steps on the use of a growing-memory fit: which starts are admitted, how the gains vanish."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.growing_memory.fit import GAIN_NAMES, Fit, K, gain_vector
from gainproof.derive.relation import equal, limit

ENDS = {"0": End(), "infinity": End()}


def start_steps(f: Fit) -> list[Step]:
    """Which starts are admitted: how an error of the start reaches the first full fit."""
    size = f.size
    errors = tuple(f"d{n}" for n in range(1, size + 1))
    error = sp.ImmutableDenseMatrix([[real(name)] for name in errors])
    first = f.gain.subs(K, f.degree)
    steps = [
        Step(
            "start-gain",
            f"At sample {f.degree} the fit is determined for the first time. Its gain there:",
            equal(
                gain_vector(size).applyfunc(lambda entry: sp.Subs(entry, K, sp.Integer(f.degree))),
                sp.ImmutableDenseMatrix(first),
            ),
            f"Put `k = {f.degree}` in step @gain.",
            heading="How to start",
        ),
        Step(
            "start",
            f"{_start_sentence(f.degree)} Let {_listed(errors)} be the errors of the start in "
            f"{_listed(('position', 'velocity', 'acceleration')[:size], '')}; the first fit makes "
            "of them:",
            equal(
                sp.MatMul(_error_matrix(f, f.degree), error, evaluate=False),
                _start_errors(f.degree),
                free=errors,
            ),
            "`(I - K H) F` carries the error of the state on by one sample; insert step "
            "@start-gain.",
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
                f"The product of the matrices `(I - K H) F` of samples 0 to {f.degree} vanishes.",
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
    limits = []
    rates = []
    for order, (name, value) in enumerate(zip(GAIN_NAMES, f.gain, strict=False)):
        leading = sp.limit(value * K ** (order + 1), K, sp.oo)
        rates.append(f"`{name}_k` like `{leading}/k{f'^{order + 1}' if order else ''}`")
        limits += [
            (f"vanishing-{name}", real(name), sp.Integer(0)),
            (f"leading-{name}", real(name) * K ** (order + 1), leading),
        ]
    first, *others = (
        joined(label, limit(expression, "infinity", target, variable="k"), hint={"ends": ENDS})
        for label, expression, target in limits
    )
    return [
        replace(
            first,
            sentence=f"As samples accumulate the gains fall to zero, {', '.join(rates)}.",
            reason="Compare the leading coefficients of step @gain.",
            heading="Many samples",
            joins=False,
        ),
        *others,
    ]


def _listed(names: tuple[str, ...], mark: str = "`") -> str:
    """`d1`, `d2` and `d3`."""
    marked = [f"{mark}{name}{mark}" for name in names]
    return " and ".join([", ".join(marked[:-1]), marked[-1]] if marked[1:] else marked)
