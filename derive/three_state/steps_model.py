"""Steps on the model and its scaling."""

from __future__ import annotations

import re

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import definition, described, equal
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import INDEX


def model_steps(c: Context) -> list[Step]:
    """The model in its own quantities, and scaled to numbers and one ratio."""
    return [*_own_model(c), *_scaling(c)]


def _own_model(c: Context) -> list[Step]:
    model = c.original
    meanings = ", ".join(
        f"`{_plain(quantity.latex)}` {'is ' if number == 0 else ''}the {quantity.meaning}"
        for number, quantity in enumerate(model.quantities)
    )
    return [
        Step(
            "model",
            "The state `x` holds position, velocity and acceleration. From one sample to the next "
            "it moves by `F` and is shaken by process noise; the position is measured as `y`. Both "
            "noises are white and independent of each other.",
            described("`x(k+1) = F x(k)` + process noise of covariance `Q`"),
            f"This is the model. Here {meanings}.",
            heading="The model",
        ),
        joined(
            "model-measurement",
            described("`y(k) = H x(k)` + measurement noise of covariance `R`"),
        ),
        *(
            joined(f"model-{name.replace('_', '-')}", definition(real(name), matrix))
            for name, matrix in (
                ("transition_matrix", model.transition),
                ("process_noise", model.process_noise),
                ("measurement_matrix", model.measurement),
                ("measurement_noise", model.measurement_noise),
            )
        ),
    ]


def _scaling(c: Context) -> list[Step]:
    """The scaled matrices are the model's own, in the units of the scaling."""
    forward = sp.diag(*c.model.state_scale).as_immutable()
    backward = sp.diag(*(1 / entry for entry in c.model.state_scale)).as_immutable()
    plain = {q.symbol: sp.Symbol(_plain(q.latex)) for q in c.original.quantities}
    units = [str(entry.subs(plain)).replace("**", "^") for entry in c.model.state_scale]
    ratio = str(c.model.noise_ratio.subs(plain)).replace("**", "^").replace("*", " ")
    transition = (backward, c.original.transition, forward)
    weighted = (c.model.noise_ratio * forward).as_immutable()
    noise = (weighted, c.model.process_noise, forward)
    return [
        Step(
            "scaled-transition",
            f"Measure time in units of `T`, position in units of `{units[0]}`, velocity in units "
            f"of `{units[1]}` and acceleration in units of `{units[2]}`. The transition is then a "
            "matrix of numbers.",
            equal(sp.MatMul(*transition, evaluate=False), c.model.transition, _free(c, transition)),
            "New coordinates turn `F` of step @model into `D^-1 F D`, where `D` holds the three "
            "units on its diagonal.",
        ),
        Step(
            "scaled-process-noise",
            f"In the same units the process noise is the ratio `{ratio}` times a matrix `Q0` of "
            "numbers, the middle one on the right side.",
            equal(
                c.original.process_noise,
                sp.MatMul(*noise, evaluate=False),
                _free(c, (*noise, c.original.process_noise)),
            ),
            "A covariance `Q` becomes `D^-1 Q D^-1`, so that `Q` is `D` times the new matrix times "
            "`D`; the ratio stands with the first `D` here. `R` becomes 1.",
        ),
        Step(
            "index",
            "The root of this ratio is the tracking index `Lambda`, the only number that is left. "
            "From here on `T = 1`, `sigma_v = 1`, and the process noise has covariance "
            "`Lambda^2 Q0`.",
            definition(INDEX**2, c.model.noise_ratio),
            "Entry 33 of step @scaled-process-noise.",
        ),
    ]


def _free(c: Context, factors: tuple[sp.ImmutableDenseMatrix, ...]) -> tuple[str, ...]:
    """Names of the model's quantities in these matrices."""
    found = {str(symbol) for factor in factors for symbol in factor.free_symbols}
    return tuple(q.name for q in c.original.quantities if q.name in found)


def _plain(latex: str) -> str:
    """A quantity's symbol as it is written on a line of text."""
    return re.sub(r"[\\{} ]|tilde", "", latex)
