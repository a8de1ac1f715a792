"""Models of a source's own: four matrices in its symbols, brought to units T = 1 and measurement
noise 1.

State i counts T^(1-i) position units, so that F_ij = F1_ij T^(j-i), H_j = H1_j T^(j-1) and
Q_ij = index^2 variance Q1_ij T^(2-i-j), with numbers F1, H1, Q1 and the last entry that is not zero
on the diagonal of Q1 equal to 1. The measurement noise variance and one intensity of the process
noise may be symbols: they are then determined by the tracking index, T and the noise deviation.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations
from typing import Any

from gainproof.verify.judge.claim.models import positive_semidefinite
from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, number, power, symbols_of
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.freed.monomials import monomials
from gainproof.verify.judge.setting.environment import DEVIATION, INDEX, INTERVAL, Environment
from gainproof.verify.judge.setting.own_matrices import (
    SIGMA,
    Rows,
    T,
    in_units,
    interval_symbol,
    noise_in_units,
    read_matrices,
    source_token,
)
from gainproof.verify.judge.setting.own_pair import both_measured
from gainproof.verify.judge.setting.quantities import steady_state


@dataclass(frozen=True)
class Scaled:
    """A model in numbers, and what symbols of the source are in terms of index, T and deviation.

    `in_units` says that the source's numbers are in units of the measurement noise.
    """

    data: Mapping[str, Any]
    assigned: Mapping[str, Expr]
    in_units: bool
    intensity: Mapping[str, Expr]


def own_environment(setting: Setting) -> Environment:
    """The steady state of the setting's own model. Raises Undecided, Malformed, NotEstablished."""
    if setting.own_model is not None and len(setting.own_model.measurement) == 2:
        return both_measured(setting)
    model = scaled_model(setting)
    solved = steady_state(model.data)
    put_in = {INDEX: solved.quantities[INDEX]}
    assigned = {token: substituted(expr, put_in) for token, expr in model.assigned.items()}
    quantities = dict(solved.quantities)
    if model.in_units:
        unit = {DEVIATION: number(1)}
        quantities = {name: substituted(expr, unit) for name, expr in quantities.items()}
    changing = next(iter(model.intensity), None)
    return replace(solved, assigned=assigned, quantities=quantities, intensity=changing)


def scaled_model(setting: Setting) -> Scaled:
    """The model's numbers. Raises Undecided where a matrix does not scale like that."""
    scope, (f, q, h, r) = read_matrices(setting)
    if len(r) != 1:
        raise Undecided(f"a steady state with {len(r)} measurements is not covered")
    assigned = {**interval_symbol(setting, scope), **_noise(r[0][0])}
    put_in = {free_name(token): expr for token, expr in assigned.items()}
    f, q, h = ([[substituted(x, put_in) for x in row] for row in matrix] for matrix in (f, q, h))
    names = symbols_of(*[x for matrix in (f, q, h) for row in matrix for x in row])
    # a model without the sampling interval is in units of it
    interval = T if INTERVAL in names else number(1)
    is_one = r[0][0] == number(1)
    deviation = number(1) if is_one else SIGMA
    noise, intensity = noise_in_units(q, interval, deviation)
    _require_covariance([[Fraction(x) for x in row] for row in noise])
    data = {
        "name": setting.name,
        "transition": in_units(f, (1, -1), interval, "transition"),
        "process_noise": noise,
        "measurement": _measured(h, interval),
        "measurement_noise": [["1"]],
    }
    return Scaled(data, {**assigned, **intensity}, is_one and bool(intensity), intensity)


def _measured(h: Rows, interval: Expr) -> list[list[str]]:
    try:
        return in_units(h, (0, -1), interval, "measurement")
    except Undecided:
        if monomials(h[0][0]):
            raise
        raise Undecided(
            "the measurement of the model leaves out the first state, in whose unit the others and "
            "the noise are counted: that is not covered"
        ) from None


def _require_covariance(q: list[list[Fraction]]) -> None:
    """Undecided where the process noise, in numbers, is not symmetric and nowhere negative."""
    for i, j in combinations(range(len(q)), 2):
        if q[i][j] != q[j][i]:
            raise Undecided(
                f"the process noise of the model is not symmetric: row {i + 1}, column {j + 1} and "
                f"row {j + 1}, column {i + 1} differ"
            )
    if not positive_semidefinite(q):
        raise Undecided(
            "the process noise of the model is no covariance: it is not positive semidefinite"
        )


def _noise(r: Expr) -> dict[str, Expr]:
    """What the symbol in the measurement noise is: R or sigma; empty where it is the variance."""
    found = monomials(r)
    if r == number(1) or found == monomials(power(SIGMA, 2)):
        return {}
    if len(found) == 1:
        ((monomial, c),) = found.items()
        for base, exponent in monomial:
            if c == 1 and len(monomial) == 1 and exponent in (1, 2) and source_token(base):
                return {source_token(base): power(SIGMA, 2) if exponent == 1 else SIGMA}
    raise Undecided("the measurement noise of a model must be 1, a variance or a squared deviation")
