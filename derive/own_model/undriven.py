"""Why a process noise that leaves something undriven has no steady state of its own."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.any_two_state.domain import FreeNumbers, NoSign, shown
from gainproof.derive.model import ScaledModel


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
