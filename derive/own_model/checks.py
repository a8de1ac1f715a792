"""What a model must be like to have a steady state that is derived: noises, what is seen, driven.

All of it raises ModelError, a ValueError, which says what was wanted and what came.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.any_two_state.domain import FreeNumbers, NoSign, shown
from gainproof.derive.model import Model, ModelError, Parameter, ScaledModel


def require_steady_state(model: Model, scaled: ScaledModel) -> None:
    """Definite noises, an observable pair, and noise that reaches every state."""
    ratios = tuple(Parameter(entry.name) for entry in model.ratios)
    numbers = FreeNumbers((*model.parameters, *ratios))
    size = scaled.transition.rows
    _require_definite(model, numbers, "process_noise", scaled.process_noise, strictly=False)
    _require_definite(model, numbers, "measurement_noise", scaled.measurement_noise, strictly=True)
    lines = sp.Matrix.vstack(*(scaled.measurement * scaled.transition**k for k in range(size)))
    if lines.rank(simplify=True) < size:
        raise ModelError(
            f"model {model.name}: the pair (F, H) should be observable, the rank of H, H F, ... is "
            f"{lines.rank(simplify=True)} of {size}: a state is never seen in the measurement"
        )
    reach = sp.zeros(size, size)
    for k in range(size):
        power = scaled.transition**k
        reach += power * scaled.process_noise * power.T
    reach = reach.applyfunc(sp.factor)
    driven = sp.factor(reach.det())
    if driven == 0:
        raise ModelError(f"model {model.name}: {undriven(scaled, reach, numbers)}")
    try:
        numbers.sign(driven)
    except NoSign as error:
        raise ModelError(
            f"model {model.name}: the process noise should drive every state for all parameters: "
            f"{error}"
        ) from None


def _require_definite(
    model: Model,
    numbers: FreeNumbers,
    name: str,
    matrix: sp.ImmutableDenseMatrix,
    *,
    strictly: bool,
) -> None:
    """Every principal minor is not negative, or every leading one positive."""
    size = matrix.rows
    chosen = (
        [list(range(n)) for n in range(1, size + 1)]
        if strictly
        else [[i for i in range(size) if subset >> i & 1] for subset in range(1, 1 << size)]
    )
    for places in chosen:
        minor = sp.factor(matrix.extract(places, places).det())
        listed = ", ".join(str(place + 1) for place in places)
        wanted = "positive definite" if strictly else "positive semidefinite"
        try:
            sign = numbers.sign(minor)
        except NoSign as error:
            raise ModelError(
                f"model {model.name}: {name} should be {wanted}, and each minor of it 0 or of one "
                f"sign for all parameters: of its minor of rows {listed}, {error}"
            ) from None
        if sign < 0 or (strictly and sign == 0):
            raise ModelError(
                f"model {model.name}: {name} should be {wanted}; in units T = 1 and sigma_v = 1 "
                f"its minor of rows {listed} is {shown(minor)}"
            )


def undriven(scaled: ScaledModel, reach: sp.MatrixBase, numbers: FreeNumbers) -> str:
    """Why a noise that leaves something undriven has no steady state of its own."""
    space = sp.Matrix.hstack(*reach.nullspace())
    share = (space.T * space).inv() * space.T * scaled.transition.T * space
    moduli = [sp.Abs(entry) for entry in share.applyfunc(sp.factor).eigenvals()]
    mode = ", ".join(shown(sp.factor(entry)) for entry in share.applyfunc(sp.factor).eigenvals())
    told = f"the process noise never drives the mode {mode} of F"
    if any(_compared(entry, numbers) > 0 for entry in moduli):
        return (
            f"the pair (F, process noise) should be stabilisable, {told}, which lies outside the "
            "unit circle"
        )
    if any(_compared(entry, numbers) == 0 for entry in moduli):
        return (
            f"the process noise should drive every state, {told}, which lies on the unit circle: "
            "the Riccati equation has no stabilising solution"
        )
    return (
        f"the process noise should drive every state, {told}, which dies out: its variance tends "
        "to 0; leave that state out of the model"
    )


def _compared(modulus: sp.Expr, numbers: FreeNumbers) -> int:
    """The sign of a modulus less 1; of one without a sign that is shown -1."""
    if not modulus.free_symbols:
        return int(sp.sign(sp.nsimplify(modulus - 1)))
    inner = modulus.args[0] if isinstance(modulus, sp.Abs) else modulus
    try:
        return numbers.sign(sp.factor(inner**2 - 1))
    except NoSign:
        return -1
