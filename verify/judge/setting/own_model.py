"""Models of a source's own: four matrices in its symbols, brought to units T = 1 and measurement
noise 1.

State i counts T^(1-i) position units, so that F_ij = F1_ij T^(j-i), H_j = H1_j T^(j-1) and
Q_ij = index^2 variance Q1_ij T^(2-i-j), with numbers F1, H1, Q1: the square of the index is the
strength as it stands before the numbers. Where Q and R are numbers, or one multiple of another, the
last entry that is not zero on the diagonal of Q1 is 1, the index is a number, and there is one
filter. The variance of the measurement and one strength of the
process noise may be symbols: of the two, and of T, the index determines one.
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
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, mul, number, power, symbols_of
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.freed.monomials import monomials
from gainproof.verify.judge.setting.environment import DEVIATION, INDEX, INTERVAL, Environment
from gainproof.verify.judge.setting.factor import number_root
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

    `known` is what the model says of these base variables themselves.
    """

    data: Mapping[str, Any]
    assigned: Mapping[str, Expr]
    intensity: str | None
    squared_index: Fraction | None
    known: Mapping[str, Expr]


def own_environment(setting: Setting) -> Environment:
    """The steady state of the setting's own model. Raises Undecided, Malformed, NotEstablished."""
    if setting.own_model is not None and len(setting.own_model.measurement) == 2:
        return both_measured(setting)
    model = scaled_model(setting)
    solved = steady_state(model.data, squared_index=model.squared_index)
    put_in = {INDEX: solved.quantities[INDEX]}

    def placed(values: Mapping[str, Expr], said: Mapping[str, Expr]) -> dict[str, Expr]:
        return {name: substituted(expr, said) for name, expr in values.items()}

    known = placed(model.known, put_in)
    assigned = placed(placed(model.assigned, known), put_in)
    quantities = placed(solved.quantities, known)
    matrices = {
        name: tuple(tuple(substituted(e, known) for e in row) for row in rows)
        for name, rows in solved.model.items()
    }
    return replace(
        solved,
        assigned=assigned,
        quantities=quantities,
        intensity=model.intensity,
        model=matrices,
    )


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
    variance = _variance(r[0][0])
    driven = noise_in_units(q, interval, power(SIGMA, 2) if variance is None else number(variance))
    _require_covariance([[Fraction(x) for x in row] for row in driven.rows])
    data = {
        "name": setting.name,
        "transition": in_units(f, (1, -1), interval, "transition"),
        "process_noise": driven.rows,
        "measurement": _measured(h, interval),
        "measurement_noise": [["1"]],
    }
    known: dict[str, Expr] = {}
    # with an index of the source's own, R = 1 is the unit of all that it says
    family = driven.squared_index is None and not driven.intensity
    if variance is not None and not (family and variance == 1):
        known[DEVIATION] = number_root(variance)
    if driven.deviation is not None:
        known[DEVIATION] = driven.deviation
    if interval != T and all(s.quantity != INTERVAL for s in setting.symbols.values()):
        known[INTERVAL] = interval
    return Scaled(
        data,
        {**assigned, **driven.intensity},
        next(iter(driven.intensity), None),
        driven.squared_index,
        known,
    )


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


def _variance(r: Expr) -> Fraction | None:
    """The variance of the measurement where it is a number. Raises Undecided where it is none."""
    value = constant_value(r)
    if value is not None and value <= 0:
        raise Undecided(f"the variance of the measurement is {value}: it must be positive")
    return value


def _noise(r: Expr) -> dict[str, Expr]:
    """What the symbol in the measurement noise is, a variance or a deviation; empty where there is
    none, or the variance itself. Raises Undecided.
    """
    found = monomials(r)
    if constant_value(r) is not None or found == monomials(power(SIGMA, 2)):
        return {}
    if len(found) == 1:
        ((monomial, c),) = found.items()
        powers = dict(monomial)
        unknown = [base for base in powers if source_token(base)]
        if len(unknown) == 1 and powers[unknown[0]] in (1, 2) and len(powers) == 1 and c > 0:
            exponent = Fraction(1, powers[unknown[0]])
            scale = number_root(1 / c) if exponent != 1 else number(1 / c)
            value = SIGMA if exponent != 1 else power(SIGMA, 2)
            return {source_token(unknown[0]): value if c == 1 else mul(scale, value)}
    raise Undecided(
        "the measurement noise of a model must be a positive number, or one symbol or its square "
        "times one"
    )
