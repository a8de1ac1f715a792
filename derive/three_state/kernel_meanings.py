"""What the outputs of the kernels stand for, as expressions over the named quantities."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.expression import real
from gainproof.derive.pages.kernel_formulas import FIRST, SCALE, SECOND, formula_of
from gainproof.derive.three_state.names import DEVIATION, INDEX, XI

NAMED = {
    "position": real("predictor_position"),
    "velocity": real("predictor_velocity"),
    "acceleration": real("gamma"),
    "pole_product": 1 - real("alpha"),
}


def meant(kernel: str, output: str) -> sp.Expr:
    """What an output of a kernel stands for."""
    name = formula_of(kernel, output)
    plain = name.removeprefix(SECOND).removeprefix(FIRST)
    order = 2 if name.startswith(SECOND) else int(plain != name)
    if plain.endswith(SCALE):
        return _parts(plain.removesuffix(SCALE), order)
    value = NAMED.get(plain, real(plain))
    return sp.Derivative(value, (INDEX, order)) if order else value


def _parts(name: str, order: int) -> sp.Expr:
    """The sum of the parts whose difference a derivative is.

    Those of M11 are (sigma psi/Lambda)^2 and sigma^2 psi chi/Lambda^2; the falling part of M12 is
    -M12' xi'/xi; those of X are the derivative of M and of what the update takes from it.
    """
    value = real(name)
    own = sp.Derivative(value, (INDEX, order))
    if name == "predicted_11":
        return -sp.Derivative(real("alpha"), (INDEX, 2)) * DEVIATION**4
    if name == "predicted_12":
        slope = sp.Derivative(value, INDEX)
        return own - 2 * slope * sp.Derivative(XI, INDEX) / XI
    before = real(name.replace("updated", "predicted"))
    return 2 * sp.Derivative(before, (INDEX, order)) - own
