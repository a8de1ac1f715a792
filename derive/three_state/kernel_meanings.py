"""What the outputs of the kernels stand for, as expressions over the named quantities."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.three_state.kernel_curvature_covariances import SCALE
from gainproof.derive.three_state.names import DEVIATION, INDEX, XI

NAMED = {
    "position": real("predictor_position"),
    "velocity": real("predictor_velocity"),
    "acceleration": real("gamma"),
    "pole_product": 1 - real("alpha"),
}


def meant(kernel: str, output: str) -> sp.Expr:
    """What an output of a kernel stands for."""
    if output.endswith(SCALE):
        return _parts(output.removesuffix(SCALE))
    if output.startswith("d_"):
        return sp.Derivative(real(output.removeprefix("d_")), INDEX)
    value = NAMED.get(output, real(output))
    if kernel.endswith("_second_derivatives"):
        return sp.Derivative(value, (INDEX, 2))
    if kernel.endswith("_derivatives") and kernel != "gains_with_derivatives":
        return sp.Derivative(value, INDEX)
    return value


def _parts(name: str) -> sp.Expr:
    """The sum of the parts whose difference a second derivative is.

    Those of M11 are (sigma psi/Lambda)^2 and sigma^2 psi chi/Lambda^2; the falling part of M12 is
    -M12' xi'/xi; those of X are M'' and what the update takes from it.
    """
    value = real(name)
    second = sp.Derivative(value, (INDEX, 2))
    if name == "predicted_11":
        return -sp.Derivative(real("alpha"), (INDEX, 2)) * DEVIATION**4
    if name == "predicted_12":
        slope = sp.Derivative(value, INDEX)
        return second - 2 * slope * sp.Derivative(XI, INDEX) / XI
    before = real(name.replace("updated", "predicted"))
    return 2 * sp.Derivative(before, (INDEX, 2)) - second
