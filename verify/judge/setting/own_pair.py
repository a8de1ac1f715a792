"""Models of a source's own with position and velocity measured: H = I, R diagonal."""

from __future__ import annotations

from fractions import Fraction

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import mul, power, symbol
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.freed.monomials import monomials
from gainproof.verify.judge.setting.environment import RATIO, Environment
from gainproof.verify.judge.setting.own_matrices import (
    SIGMA,
    Rows,
    T,
    in_units,
    interval_symbol,
    noise_in_units,
    read_matrices,
    require_sign,
    source_token,
)
from gainproof.verify.judge.setting.position_velocity import position_velocity, with_assigned
from gainproof.verify.judge.setting.two_measurements import Noise


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
