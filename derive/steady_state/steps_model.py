"""Steps on the model: scaling and innovation spectrum."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from fractions import Fraction

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import definition, described, equal
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import DEVIATION, INDEX, Z
from gainproof.derive.steady_state.spectrum import (
    V,
    closed_loop_matrix,
    noise_numerator,
)


def model_steps(c: Context) -> list[Step]:
    """The model, its scaling and its innovation spectrum."""
    return [*_own_model(c), *_scaling_steps(c), *_spectrum_steps(c)]


def _own_model(c: Context) -> list[Step]:
    """The model in its own quantities."""
    model = c.original
    meanings = (
        f"`{_plain(quantity.latex)}` the {quantity.meaning}" for quantity in model.quantities
    )
    return [
        Step(
            "model",
            "The state `x` holds position and velocity. From one sample to the next it moves by "
            "`F` and is shaken by process noise; the position is measured as `y`. Both noises are "
            "white and independent of each other.",
            described("`x(k+1) = F x(k)` + process noise of covariance `Q`"),
            " ".join(("This is the model.", *_sentence(meanings))),
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


def _sentence(meanings: Iterable[str]) -> Iterator[str]:
    """Here A is this, B that."""
    listed = ", ".join(meanings)
    if listed:
        yield f"Here {listed.replace('` the', '` is the', 1)}."


def _scaling_steps(c: Context) -> list[Step]:
    """The scaled matrices are the model's own, in the units of the scaling."""
    forward = sp.diag(*c.model.state_scale).as_immutable()
    backward = sp.diag(*(1 / entry for entry in c.model.state_scale)).as_immutable()
    plain = {q.symbol: sp.Symbol(_plain(q.latex)) for q in c.original.quantities}
    first, second = (str(entry.subs(plain)) for entry in c.model.state_scale)
    transition = (backward, c.original.transition, forward)
    noise = (backward, c.original.process_noise, backward)
    return [
        Step(
            "scaled-transition",
            f"Measure time in units of `T`, the first entry of the state in units of `{first}` and "
            f"the second in units of `{second}`. The transition is then a matrix of numbers.",
            equal(sp.MatMul(*transition, evaluate=False), c.model.transition, _free(c, transition)),
            "New coordinates turn `F` of step @model into `D^-1 F D`, where `D` holds the two "
            "units on its diagonal.",
        ),
        Step(
            "scaled-process-noise",
            "In the same units the process noise is one ratio times a matrix `Q0` of numbers.",
            equal(
                sp.MatMul(*noise, evaluate=False),
                sp.ImmutableDenseMatrix(c.model.noise_ratio * c.model.process_noise),
                _free(c, noise),
            ),
            "A covariance `Q` becomes `D^-1 Q D^-1`; `R` becomes 1.",
        ),
        Step(
            "index",
            "The root of this ratio is the tracking index `Lambda`, the only number that is left. "
            "From here on `T = 1`, `sigma_v = 1`, and the process noise has covariance "
            "`Lambda^2 Q0`.",
            definition(INDEX**2, c.model.noise_ratio),
            "Entry 22 of step @scaled-process-noise.",
        ),
    ]


def _free(c: Context, factors: tuple[sp.ImmutableDenseMatrix, ...]) -> tuple[str, ...]:
    """Names of the model's quantities in these matrices."""
    found = {str(symbol) for factor in factors for symbol in factor.free_symbols}
    return tuple(q.name for q in c.original.quantities if q.name in found)


def _spectrum_steps(c: Context) -> list[Step]:
    """The spectrum of the measurements, from the model and from the filter."""
    v = 2 - Z - 1 / Z
    inner = Z * sp.eye(2) - closed_loop_matrix(c.model)
    determinant = sp.Add(
        sp.Mul(inner[0, 0], inner[1, 1]), sp.Mul(-1, inner[0, 1], inner[1, 0]), evaluate=False
    )
    open_loop = sp.factor((Z * sp.eye(2) - c.model.transition).det())
    noise = c.spectrum.noise
    closed = _by_powers(c.spectrum.closed_loop, Z)
    mirrored = _by_powers(c.spectrum.closed_loop, 1 / Z)
    return [
        Step(
            "closed-loop",
            "In the steady state the gain `K = (alpha, beta)'` of the filter no longer changes: "
            "`alpha` is the position gain, `beta` the velocity gain. The error of a prediction is "
            "carried to the next by `F (I - K H)`. The roots of `c(z) = det(z I - F (I - K H))` "
            "are the poles of the filter.",
            equal(determinant, closed, free=("z",)),
            "The error of an update is `I - K H` times that of the prediction, plus noise; `F` "
            "leads to the next prediction. Write out the determinant.",
            heading="The spectrum of the measurements",
        ),
        Step(
            "open-loop",
            "The model without a filter has the polynomial `det(z I - F)`. Its product with "
            "`det(I/z - F)` is a square in `v = 2 - z - 1/z`; from here on `v` is this number, "
            "which runs from 0 at `z = 1` to 4 at `z = -1`.",
            equal(open_loop * open_loop.subs(Z, 1 / Z), v**2, free=("z",)),
            "`F` has ones on its diagonal (step @scaled-transition): `det(z I - F) = (z - 1)^2`.",
        ),
        Step(
            "noise-spectrum",
            "What the process noise adds to the spectrum of the measurements has the numerator "
            f"`noise(v) = H adj(z I - F) Q0 adj(I/z - F)' H'`; here `noise(v) = "
            f"{_polynomial(noise)}`.",
            equal(
                noise_numerator(c.model),
                sp.ImmutableDenseMatrix([[noise.subs(V, v)]]),
                free=("z",),
            ),
            "The inverse of `z I - F` is its adjugate `adj(z I - F)` over its determinant. "
            "Multiply out and collect powers of `v`.",
        ),
        Step(
            "factorisation",
            "Spectral factorisation: this spectrum is also that of the innovations, which in the "
            "steady state are white, seen through the filter; `sigma` is the standard deviation "
            "of an innovation. So `v^2 + Lambda^2 noise(v) = sigma^2 c(z) c(1/z)` for every `z`.",
            equal(
                v**2 + INDEX**2 * noise.subs(V, v),
                sp.Mul(DEVIATION**2, closed, mirrored, evaluate=False),
                free=("z",),
            ),
            "Both sides are the spectrum times the square `v^2` of step @open-loop: on the left "
            "the measurement noise, of variance 1, and the process noise of step "
            "@noise-spectrum. We solve this for the gains; that they then satisfy it is what is "
            "proved.",
        ),
    ]


def _by_powers(polynomial: sp.Expr, at: sp.Expr) -> sp.Expr:
    """A polynomial in z at a place, its highest power first."""
    terms = [
        sp.Mul(coefficient, at**power) for (power,), coefficient in sp.Poly(polynomial, Z).terms()
    ]
    return sp.Add(*terms, evaluate=False)


def _polynomial(noise: sp.Expr) -> str:
    """A polynomial of degree 1 in v as text: `1 - v/4`."""
    constant, slope = noise.subs(V, 0), noise.coeff(V, 1)
    if slope == 0:
        return str(constant)
    size = Fraction(str(abs(slope)))
    top = "v" if size.numerator == 1 else f"{size.numerator} v"
    below = "" if size.denominator == 1 else f"/{size.denominator}"
    return f"{constant} {'-' if slope < 0 else '+'} {top}{below}"


def _plain(latex: str) -> str:
    """A quantity's symbol as it is written on a line of text."""
    return re.sub(r"[\\{} ]|tilde", "", latex)
