"""Models of one's own with odd entries: whatever they hold, they are derived or refused by name."""

from __future__ import annotations

import random
from typing import Any

import numpy as np
import scipy.linalg
import sympy as sp
from graph_kernels import balls

from gainproof.derive.model import Model, ModelError, Parameter
from gainproof.derive.own_model.choice import derive_own_model
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.quantity import (
    MEASUREMENT_DEVIATION,
    METRE,
    SAMPLING_INTERVAL,
    SECOND,
    Quantity,
    Unit,
)
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.rechecking import expected_of, recheck

T, SIGMA = SAMPLING_INTERVAL.symbol, MEASUREMENT_DEVIATION.symbol
SHAKE = Quantity("shake", "w", "strength", METRE)
OTHER = Quantity("jitter", "d", "another strength", METRE)
RATE = Quantity("rate", "b", "a rate", SECOND**-1)
BELOW = Quantity("rho", r"\rho", "a number below 1", Unit())
ABOVE = Quantity("ratio", "r", "a number", Unit())
RHO, R, W, D, B = (q.symbol for q in (BELOW, ABOVE, SHAKE, OTHER, RATE))
PLAIN = [0, 0, 0, 1, 1, 1, 2, -1, sp.Rational(1, 2), sp.Rational(-3, 4), sp.Rational("0.917")]
FREE = [RHO, 1 - RHO, R, -R, RHO**2, RHO * R, (1 - RHO) / (1 + R), 1 / RHO, R - 1, RHO - R]
ODD = [
    *(sp.sqrt(2), sp.pi, sp.Float(0.3), sp.I, sp.oo, sp.zoo, sp.nan, sp.sqrt(RHO), RHO**R),
    *(sp.exp(-RHO), sp.log(RHO), sp.cos(R), sp.Abs(R - 1), sp.Max(RHO, R), sp.exp(-B * T)),
    *(sp.Piecewise((1, R > 1), (0, True)), sp.Symbol("unknown"), B * T, 1 / (RHO - RHO**2)),
    *(T, SIGMA, W, D / SIGMA, 10**40, sp.Rational(1, 10**40), sp.Rational("0.123456789012345678")),
]

GAINS = ("alpha", "beta", "gamma")
TOLERANCE = 1e-7
"""SciPy is good to about nine digits."""


def drawn(seed: int) -> Model:
    """A model of one to four states; one in three has something odd."""
    chosen = random.Random(seed)
    size = chosen.choice([1, 2, 2, 2, 2, 2, 3, 3, 4])
    seen = chosen.choice([1, 1, 1, 1, 1, 2])
    is_free, is_odd = chosen.random() < 0.3, chosen.random() < 0.35

    def entry() -> Any:
        if is_odd and chosen.random() < 0.12:
            return sp.sympify(chosen.choice(ODD))
        return sp.sympify(chosen.choice(FREE if is_free and chosen.random() < 0.4 else PLAIN))

    scale = sp.diag(*(T**-k for k in range(size)))
    transition = scale * sp.Matrix(size, size, lambda *_: entry()) * scale.inv()
    through = sp.Matrix(size, chosen.randint(1, size), lambda *_: entry())
    noise = (
        through * through.T if chosen.random() < 0.8 else sp.Matrix(size, size, lambda *_: entry())
    )
    strength = chosen.choice(
        [W**2] * 20 + [W, W**2 + D**2, sp.Integer(1), W**2 / 9, SIGMA**2, -(W**2)]
    )
    first = sp.Matrix(seen, size, lambda i, j: int(i == j))
    measurement = first if chosen.random() < 0.85 else sp.Matrix(seen, size, lambda *_: entry())
    variance = sp.eye(seen) * chosen.choice([SIGMA**2] * 25 + [SIGMA, 4 * SIGMA**2, 0, -1, 1, D**2])
    used = transition.row_join(noise).free_symbols | measurement.free_symbols
    units = [METRE / SECOND**k for k in range(size)]
    if is_odd and chosen.random() < 0.2:
        chosen.shuffle(units)
    if is_odd and chosen.random() < 0.1:
        noise = noise[:, 1:] if size > 1 else noise.row_join(noise)
    free = [Parameter(BELOW, below_one=True), Parameter(ABOVE)]
    return Model(
        name="trial",
        title="Trial",
        transition=sp.ImmutableDenseMatrix(transition),
        process_noise=sp.ImmutableDenseMatrix(
            strength * scale * noise * scale if noise.shape == (size, size) else noise
        ),
        measurement=sp.ImmutableDenseMatrix(measurement),
        measurement_noise=sp.ImmutableDenseMatrix(variance),
        quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, SHAKE, OTHER, RATE),
        state_units=tuple(units),
        measurement_units=(METRE,) * seen,
        parameters=tuple(each for each in free if each.quantity.symbol in used),
    )


def outcome(model: Model) -> str:
    """`derived`, or the message of the refusal; anything else is raised, a certificate that is
    rejected and gains that are not SciPy's too.
    """
    try:
        subject = derive_own_model(model)
    except ModelError as error:
        return str(error)
    derived = plain_subject(subject)
    report = recheck(derived.certificate, expected_of(derived))
    if not report["accepted"]:
        raise ValueError(f"the certificate is rejected: {report['reason']}")
    for kernel in subject.module.kernels:
        if kernel.name == "gains" and model.measurement.rows == 1:
            _require_gains(model, kernel)
    return "derived"


def _require_gains(model: Model, kernel: Kernel) -> None:
    """Raises ValueError unless they are those of SciPy's Riccati equation, where it has one."""
    for index, rho, ratio in ((0.3, 0.4, 1.7), (2.0, 0.8, 0.6), (9.0, 0.15, 1.1)):
        values = {T: 1, SIGMA: 1, B: 1, W: index, D: index, RHO: rho, R: ratio}
        matrices = (model.transition, model.process_noise, model.measurement)
        f, q, h = (np.array(each.subs(values).tolist(), float) for each in matrices)
        try:
            p = scipy.linalg.solve_discrete_are(f.T, h.T, q, [[1.0]])
        except np.linalg.LinAlgError:
            continue
        wanted = (p @ h.T / (h @ p @ h.T + 1))[:, 0]
        found = balls(kernel.graph, {"tracking_index": index, "rho": rho, "ratio": ratio})
        shown = [each.name for each in kernel.outputs]
        # a gain that is 0 is no output
        gains = [float(found[n].mid()) if n in shown else 0.0 for n in GAINS[: len(wanted)]]
        if np.abs(gains - wanted).max() > TOLERANCE * np.abs(wanted).max():
            raise ValueError(f"gains {gains} at index {index}, SciPy has {wanted}")
