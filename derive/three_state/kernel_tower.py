"""The tower in which the kernels of the index are evaluated, and what ties it to the model.

Where all is rational in w it is the main tower with the index's fourth root. Elsewhere it is over
the index's twelfth root r, since near a vanishing index all goes by the cube root: with the index
r^12, delta = h/r^12, xi = X/r^4 and eta = E/r^8 one has h^2 = 64 + e r^24, and X and E are a
coupled pair, X^2 = a1 r^8 + 2 E and E^2 = a2 r^16 + 2 h X. No number's root stands in it, and
proofs are many times shorter than over xi. That its elements are the steady state is shown again
in it, by the equations of the filter.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Generator, Parameter, Tower, coupled
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, equal, positive
from gainproof.derive.three_state import towers
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import (
    BETA,
    DELTA,
    ETA,
    GAINS,
    GAMMA,
    INDEX,
    NU,
    XI,
    gain_vector,
    rows,
)
from gainproof.derive.three_state.tower_ends import number_limits
from gainproof.derive.three_state.towers import named_elements

NAME = "kernels"
R, H, X, E = real("r"), real("h"), real("x_scaled"), real("e_scaled")


def kernel_tower(c: Context) -> Tower:
    """The tower of the kernels."""
    if c.spectrum.rational_in_root:
        return towers.kernel_tower(c.tower)
    a1, a2, e = c.numbers
    own = [Generator("h", 64 + e * R**24)] if e else []
    height: sp.Expr = H if e else sp.Integer(8)
    pair = coupled((str(X), a1 * R**8, sp.Integer(2)), (str(E), a2 * R**16, 2 * height))
    elements: dict[str, sp.Expr] = {
        "tracking_index": R**12,
        "fourth_root": R**3,
        "xi": X / R**4,
        "eta": E / R**8,
        "delta": height / R**12,
    }
    named = named_elements(c.model, c.spectrum)
    elements |= {name: value for name, value in named.items() if name not in elements}
    generators = (*c.constants.generators, *own, *pair)
    return Tower(NAME, (Parameter("r"),), generators, elements)


def ends(c: Context) -> dict[str, End]:
    """Behaviour of that tower over the twelfth root as the index tends to an end."""
    known, boundary, k = number_limits(c.spectrum)
    pair = {str(X): sp.Integer(4), str(E): sp.Integer(8)}
    far: dict[str, sp.Expr] = {str(X): k.least, str(E): k.b + k.c}
    weights = {str(X): 4, str(E): 8}
    if not c.spectrum.e:
        return {
            "0": End(constants=known, boundary={**boundary, **pair}),
            "infinity": End(weights, known, {**boundary, **far}),
        }
    return {
        "0": End(constants=known, boundary={**boundary, "h": sp.Integer(8), **pair}),
        "infinity": End({**weights, "h": 12}, known, {**boundary, "h": k.c, **far}),
    }


def kernel_tower_steps(c: Context) -> list[Step]:
    """The equations of the filter in a tower of its own; none where it is the main one."""
    if c.spectrum.rational_in_root:
        return []
    before, after = (
        sp.ImmutableDenseMatrix([[real(name) for name in row] for row in rows(kind)])
        for kind in ("predicted", "updated")
    )
    column, gain = before[:, 0], gain_vector()
    moved = sp.MatMul(c.model.transition, after, c.model.transition.T, evaluate=False)
    noise = sp.ImmutableDenseMatrix(INDEX**2 * c.model.process_noise)
    claims = {
        "ratio": (equal(XI, 2 * BETA / GAMMA), {}),
        "prediction": (equal(before, sp.MatAdd(moved, noise, evaluate=False)), {}),
        "gain": (equal(gain * (column[0] + 1), column), {}),
        "update": (equal(after, before - gain * column.T), {}),
        "innovation": (positive(column[0] + 1), {"form": (INDEX * NU) ** 2 / 64}),
        "stable": (
            Relation("stable", {"model": c.model_data, "gain": list(GAINS)}),
            {"values": _schur_cohn(c)},
        ),
    }
    return [
        Step(f"over-the-root-{name}", "", relation, "", tower=NAME, hint=hint, shown=False)
        for name, (relation, hint) in claims.items()
    ]


def _schur_cohn(c: Context) -> list[sp.Expr]:
    """The quantities of Schur and Cohn as sums, quotients and products of positive terms."""
    a1, a2, _ = c.numbers
    apart = (3 * ETA**2 + 2 * a1 * ETA + a2) / (2 * XI)  # tau
    return [
        2 * (XI + DELTA) / NU,
        2 * (1 + ETA) / NU,
        8 * apart / NU**2,
        8 * (XI + 2 * DELTA + ETA * DELTA) / NU**2,
        128 * DELTA * (1 + ETA) * apart / NU**4,
        128 * (XI + DELTA) * apart / NU**4,
    ]
