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
from gainproof.verify.judge.exact.expression import Expr, mul, number, power, symbol
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.square_matrices import determinant
from gainproof.verify.judge.setting.environment import (
    DEVIATION,
    INDEX,
    INTERVAL,
    RATIO,
    Environment,
)
from gainproof.verify.judge.setting.free_numbers import over_gains
from gainproof.verify.judge.setting.own_matrices import (
    SIGMA,
    Rows,
    T,
    in_units,
    interval_symbol,
    noise_in_units,
    not_symmetric,
    read_matrices,
    read_own,
    require_sign,
    source_token,
)
from gainproof.verify.judge.setting.position_velocity import position_velocity, with_assigned
from gainproof.verify.judge.setting.quantities import steady_state
from gainproof.verify.judge.setting.spectral_factor import number_root
from gainproof.verify.judge.setting.two_measurements import Noise
from gainproof.verify.judge.transcendental.monomials import monomials


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
    try:
        model = scaled_model(setting)
    except Undecided:
        found = over_gains(setting)
        if found is None:
            raise
        return found
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
    own = read_own(setting)
    f, q, h, interval, variance = own.f, own.q, own.h, own.interval, own.variance
    driven = noise_in_units(q, interval, own.scale)
    _require_covariance([[Fraction(x) for x in row] for row in driven.rows])
    transition = in_units(f, (1, -1), interval, "transition")
    for token in driven.intensity:
        # a transition that keeps a state as it is has no steady state without process noise
        if not _keeps_a_state(transition):
            require_sign(token, own.scope, ">")
        elif driven.is_root:
            require_sign(token, own.scope, ">=")
    data = {
        "name": setting.name,
        "transition": transition,
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
    if own.without_interval(setting):
        known[INTERVAL] = interval
    return Scaled(
        data,
        {**own.assigned, **driven.intensity},
        next(iter(driven.intensity), None),
        driven.squared_index,
        known,
    )


def _keeps_a_state(transition: list[list[str]]) -> bool:
    """Whether 1 is an eigenvalue."""
    size = range(len(transition))
    moved = tuple(tuple(number(Fraction(transition[i][j]) - (i == j)) for j in size) for i in size)
    return constant_value(determinant(moved)) == 0


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
            raise not_symmetric(i, j)
    if not positive_semidefinite(q):
        raise Undecided(
            "the process noise of the model is no covariance: it is not positive semidefinite"
        )


def both_measured(setting: Setting) -> Environment:
    """The steady state where H = I and R is diagonal, with a symbol of its own for the deviation
    of the measured velocity. Raises Undecided, Malformed, NotEstablished.
    """
    scope, (f, q, h, r) = read_matrices(setting)
    deviation = _velocity_noise(r)
    require_sign(deviation, scope, ">")
    velocity = {deviation: mul(symbol(RATIO), SIGMA, power(T, -1))}
    assigned = {**interval_symbol(setting, scope), **velocity}
    # the process noise may hold the deviation of the measured velocity too
    put_in = {free_name(token): expr for token, expr in assigned.items()}
    f, q = ([[substituted(x, put_in) for x in row] for row in matrix] for matrix in (f, q))
    numbers = in_units(f, (1, -1), T, "transition"), in_units(h, (0, 0), T, "measurement")
    if numbers != ([["1", "1"], ["0", "1"]], [["1", "0"], ["0", "1"]]):
        raise Undecided("two measurements of other than position and velocity of a straight motion")
    driven = noise_in_units(q, T, power(SIGMA, 2))
    data, intensity = driven.rows, driven.intensity
    if not intensity:
        raise Undecided("two measurements with a process noise that has no symbol as its strength")
    for token in intensity if driven.is_root else ():
        require_sign(token, scope, ">=")
    (position, mixed), (other, last) = ([Fraction(x) for x in row] for row in data)
    if last > 0 and last != 1:
        raise Undecided(
            "with position and velocity measured the process noise is solved with the strength as "
            f"last entry, which holds the number {last} here: take it into the strength's symbol"
        )
    if mixed != other or last != 1:
        raise Undecided("the process noise of the model is no covariance with driven velocity")
    solved = position_velocity(Noise(position, mixed), setting.name)
    return with_assigned(solved, {**assigned, **intensity}, (*intensity, *velocity))


def _velocity_noise(r: Rows) -> str:
    """The symbol for the deviation of the measured velocity in R. Raises Undecided."""
    place = monomials(r[0][0]) == monomials(power(SIGMA, 2))
    apart = all(monomials(x) == {} for x in (r[0][1], r[1][0]))
    if place and apart and len(found := monomials(r[1][1])) == 1:
        ((monomial, c),) = found.items()
        for base, exponent in monomial:
            if c == 1 and len(monomial) == 1 and exponent == 2 and source_token(base):
                return source_token(base)
    raise Undecided("two measurements with a noise that is no diagonal of squared deviations")
