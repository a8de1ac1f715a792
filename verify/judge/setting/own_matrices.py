"""The matrices of a model of the source's own, in base variables and free symbols, and what is
common to all such models: the interval, numbers in units, the intensity of the process noise.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from gainproof.verify.judge.claim.record import Setting, Unit
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
from gainproof.verify.judge.exact.rational_root import integer_root
from gainproof.verify.judge.exact.tree import read_tree
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.freed.monomials import UNIT, Monomial, monomials
from gainproof.verify.judge.meaning.reach import Reach, names_in
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import DEVIATION, INDEX, INTERVAL, Environment

T, SIGMA = symbol(INTERVAL), symbol(DEVIATION)
Rows = Sequence[Sequence[Expr]]


def model_key(setting: Setting) -> str:
    """All that the environment depends on: the matrices, and the symbols that they use."""
    own = setting.own_model
    if own is None:
        return repr(setting)
    matrices = (own.transition, own.process_noise, own.measurement, own.measurement_noise)
    trees = [read_tree(entry) for matrix in matrices for row in matrix for entry in row]
    direct = {name for tree in trees for name in names_in(tree)}
    reach = Reach(setting.symbols)
    used = sorted(direct.union(*[reach.of(name) for name in direct]))
    return repr((setting.name, own, [setting.symbols.get(name) for name in used]))


def read_matrices(setting: Setting) -> tuple[Scope, tuple[Rows, Rows, Rows, Rows]]:
    """F, Q, H and R in base variables and free symbols. Raises Undecided."""
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
    return scope, (
        rows(own.transition),
        rows(own.process_noise),
        rows(own.measurement),
        rows(own.measurement_noise),
    )


def interval_symbol(setting: Setting, scope: Scope) -> dict[str, Expr]:
    """The one free symbol with the unit of a time is the sampling interval."""
    found = [
        token
        for token, value in scope.used.items()
        if value == symbol(free_name(token)) and _is_time(setting, token)
    ]
    return {found[0]: T} if len(found) == 1 else {}


def _is_time(setting: Setting, token: str) -> bool:
    unit = setting.symbols[token].unit
    return unit == Unit(second=Fraction(1))


def in_units(
    matrix: Rows, exponents: tuple[int, int], interval: Expr, name: str
) -> list[list[str]]:
    """The numbers x T^(a i + b j), as text. Raises Undecided where they are none."""
    a, b = exponents
    return [
        [str(_number(mul(x, power(interval, a * i + b * j)), name)) for j, x in enumerate(row)]
        for i, row in enumerate(matrix)
    ]


def source_token(base: Expr) -> str:
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


def noise_in_units(
    q: Rows, interval: Expr, deviation: Expr
) -> tuple[list[list[str]], dict[str, Expr]]:
    """Q1, and what the intensity is. Raises Undecided, also where symbols cancel in the index: a
    number would be left of it, and it is free in all that is shown.
    """
    below = power(deviation, -2)
    entries = [
        [monomials(mul(x, below, power(interval, i + j))) for j, x in enumerate(row)]
        for i, row in enumerate(q)
    ]
    common = {m for row in entries for found in row for m in found}
    if len(common) != 1 or any(len(found) > 1 for row in entries for found in row):
        raise Undecided("the process noise of the model is no one intensity times a matrix")
    (shared,) = common
    if not dict(shared) and any(symbols_of(x) for row in q for x in row):
        raise Undecided("the process noise of the model fixes the tracking index")
    diagonal = [row[i].get(shared, Fraction(0)) for i, row in enumerate(entries)]
    last = next((c for c in reversed(diagonal) if c), None)
    if last is None or last < 0:
        found = "all 0" if last is None else "negative"
        raise Undecided(
            f"the process noise of the model is no covariance: on its diagonal is what is {found}"
        )
    ratio, intensity = _intensity(shared, last)
    rows = [
        [str(found.get(shared, Fraction(0)) / (last * ratio)) for found in row] for row in entries
    ]
    return rows, intensity


def _intensity(shared: Monomial, last: Fraction) -> tuple[Fraction, dict[str, Expr]]:
    """From index^2 = last * shared what the one free symbol of it is.

    Numbers alone stand for index 1; the first result is what they are divided by.
    """
    powers = dict(shared)
    if not powers or powers == {symbol(INDEX): 2}:
        return 1 / last, {}
    unknown = [base for base in powers if source_token(base)]
    if len(unknown) != 1 or powers[unknown[0]] not in (1, 2):
        raise Undecided("the process noise of the model must have one symbol as its intensity")
    rest = [power(base, -n) for base, n in powers.items() if base != unknown[0]]
    value = mul(power(symbol(INDEX), 2), number(1 / last), *rest)
    if powers[unknown[0]] == 2:
        value = _root(powers, unknown[0], last)
    return Fraction(1), {source_token(unknown[0]): value}


def _root(powers: Mapping[Expr, int], unknown: Expr, last: Fraction) -> Expr:
    """The square root of index^2 / (last * the other powers), all of which are positive."""
    top, bottom = (integer_root(n, 2) for n in (last.denominator, last.numerator))
    whole = None if top is None or bottom is None else number(Fraction(top, bottom))
    factors = [symbol(INDEX), whole or sqrt(number(1 / last))]
    for base, n in powers.items():
        if base != unknown:
            factors.append(power(base, Fraction(-n, 2)))
    return mul(*factors)
