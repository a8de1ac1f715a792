"""Models of a source's own: four matrices in its symbols, brought to units T = 1 and measurement
noise 1.

State i counts T^(1-i) position units, so that F_ij = F1_ij T^(j-i), H_j = H1_j T^(j-1) and
Q_ij = index^2 variance Q1_ij T^(2-i-j), with numbers F1, H1, Q1 and the last entry that is not zero
on the diagonal of Q1 equal to 1. The measurement noise variance and one intensity of the process
noise may be symbols: they are then determined by the tracking index, T and the noise deviation.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.claim_record import Setting
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import (
    Expr,
    mul,
    number,
    power,
    sqrt,
    symbol,
    symbols_of,
)
from gainproof.verify.judge.exact.free_names import free_name, is_free, token_of
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.freed.monomials import UNIT, Monomial, monomials
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import DEVIATION, INDEX, INTERVAL, Environment
from gainproof.verify.judge.setting.quantities import steady_state

T, SIGMA = symbol(INTERVAL), symbol(DEVIATION)
Rows = Sequence[Sequence[Expr]]


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
    if setting.own_model is None:
        raise Undecided("the setting has no model of its own")
    known = Environment(
        "the matrices of the model",
        {
            INTERVAL: T,
            DEVIATION: SIGMA,
            "measurement_noise_variance": power(SIGMA, 2),
            INDEX: symbol(INDEX),
        },
    )
    scope = Scope(setting, known)

    def rows(matrix: Sequence[Sequence[Graph]]) -> Rows:
        return [[scope.expression(entry) for entry in row] for row in matrix]

    own = setting.own_model
    f, q, h, r = (
        rows(m) for m in (own.transition, own.process_noise, own.measurement, own.measurement_noise)
    )
    if len(r) != 1:
        raise Undecided(f"a steady state with {len(r)} measurements is not covered")
    assigned = {**_interval(setting, scope), **_noise(r[0][0])}
    put_in = {free_name(token): expr for token, expr in assigned.items()}
    f, q, h = ([[substituted(x, put_in) for x in row] for row in matrix] for matrix in (f, q, h))
    names = symbols_of(*[x for matrix in (f, q, h) for row in matrix for x in row])
    # a model without the sampling interval is in units of it
    interval = T if INTERVAL in names else number(1)
    in_units = r[0][0] == number(1)
    deviation = number(1) if in_units else SIGMA
    noise, intensity = _process_noise(q, interval, deviation)
    data = {
        "name": setting.name,
        "transition": _scaled(f, (1, -1), interval, "transition"),
        "process_noise": noise,
        "measurement": _scaled(h, (0, -1), interval, "measurement"),
        "measurement_noise": [["1"]],
    }
    return Scaled(data, {**assigned, **intensity}, in_units and bool(intensity), intensity)


def _scaled(matrix: Rows, exponents: tuple[int, int], interval: Expr, name: str) -> list[list[str]]:
    """The numbers x T^(a i + b j), as text. Raises Undecided where they are none."""
    a, b = exponents
    return [
        [str(_number(mul(x, power(interval, a * i + b * j)), name)) for j, x in enumerate(row)]
        for i, row in enumerate(matrix)
    ]


def _interval(setting: Setting, scope: Scope) -> dict[str, Expr]:
    """The one free symbol with the unit of a time is the sampling interval."""
    found = [
        token
        for token, value in scope.used.items()
        if value == symbol(free_name(token)) and _is_time(setting, token)
    ]
    return {found[0]: T} if len(found) == 1 else {}


def _is_time(setting: Setting, token: str) -> bool:
    unit = setting.symbols[token].unit
    return unit is not None and unit.metre == 0 and unit.second == 1


def _noise(r: Expr) -> dict[str, Expr]:
    """What the symbol in the measurement noise is: R or sigma; empty where it is the variance."""
    found = monomials(r)
    if r == number(1) or found == monomials(power(SIGMA, 2)):
        return {}
    if len(found) == 1:
        ((monomial, c),) = found.items()
        for base, exponent in monomial:
            if c == 1 and len(monomial) == 1 and exponent in (1, 2) and _token(base):
                return {_token(base): power(SIGMA, 2) if exponent == 1 else SIGMA}
    raise Undecided("the measurement noise of a model must be 1, a variance or a squared deviation")


def _token(base: Expr) -> str:
    """The source's symbol that a free variable stands for, else nothing."""
    return token_of(base.name) if is_free(base) else ""


def _number(expr: Expr, name: str) -> Fraction:
    found = monomials(expr)
    if not set(found) <= {UNIT}:
        raise Undecided(
            f"the {name} of the model holds symbols other than powers of the sampling interval "
            "that its units ask for"
        )
    return found.get(UNIT, Fraction(0))


def _process_noise(
    q: Rows, interval: Expr, deviation: Expr
) -> tuple[list[list[str]], dict[str, Expr]]:
    """Q1, and what the intensity is."""
    below = power(deviation, -2)
    entries = [
        [monomials(mul(x, below, power(interval, i + j))) for j, x in enumerate(row)]
        for i, row in enumerate(q)
    ]
    common = {m for row in entries for found in row for m in found}
    if len(common) != 1 or any(len(found) > 1 for row in entries for found in row):
        raise Undecided("the process noise of the model is no one intensity times a matrix")
    (shared,) = common
    diagonal = [row[i].get(shared, Fraction(0)) for i, row in enumerate(entries)]
    last = next((c for c in reversed(diagonal) if c), None)
    if last is None or last < 0:
        raise Undecided("the process noise of the model is no covariance")
    ratio, intensity = _intensity(shared, last)
    rows = [
        [str(found.get(shared, Fraction(0)) / (last * ratio)) for found in row] for row in entries
    ]
    return rows, intensity


def _intensity(shared: Monomial, last: Fraction) -> tuple[Fraction, dict[str, Expr]]:
    """From index^2 = last * shared what the one free symbol of it is.

    Without symbols the numbers stand for index 1; the first result is what they are divided by.
    """
    powers = dict(shared)
    if not powers or powers == {symbol(INDEX): 2}:
        return 1 / last, {}
    unknown = [base for base in powers if _token(base)]
    if len(unknown) != 1 or powers[unknown[0]] not in (1, 2):
        raise Undecided("the process noise of the model must have one symbol as its intensity")
    rest = [power(base, -n) for base, n in powers.items() if base != unknown[0]]
    value = mul(power(symbol(INDEX), 2), number(1 / last), *rest)
    if powers[unknown[0]] == 2:
        value = _root(powers, unknown[0], last)
    return Fraction(1), {_token(unknown[0]): value}


def _root(powers: Mapping[Expr, int], unknown: Expr, last: Fraction) -> Expr:
    """The square root of index^2 / (last * the other powers), all of which are positive."""
    factors = [symbol(INDEX), sqrt(number(1 / last))]
    for base, n in powers.items():
        if base != unknown:
            factors.append(power(base, Fraction(-n, 2)))
    return mul(*factors)
