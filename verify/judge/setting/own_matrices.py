"""The matrices of a model of the source's own, in base variables and free symbols, and what is
common to all such models: the interval, numbers in units, the intensity of the process noise.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction

from gainproof.verify.judge.claim.record import Setting, Unit
from gainproof.verify.judge.claim_symbols import closure
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    mul,
    number,
    power,
    symbol,
    symbols_of,
)
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.free_names import free_name, is_free, token_of
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.meaning.definition_names import Reach, names_in
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import (
    DEVIATION,
    INDEX,
    INTERVAL,
    POSITIVE,
    Environment,
)
from gainproof.verify.judge.setting.spectral_factor import number_root
from gainproof.verify.judge.transcendental.monomials import UNIT, Monomial, monomials, ordered

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
    # domains too may speak of further symbols, which have their own
    used = sorted(closure(direct.union(*[reach.of(name) for name in direct]), setting.symbols))
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


@dataclass(frozen=True)
class Own:
    """F, Q and H of a model with one measurement, in T, the deviation of the measurement and free
    symbols; `variance` where that of the measurement is a number. `interval` is T, or 1 where the
    model does without it. `assigned` are symbols of the source that T and the deviation tell.
    """

    f: Rows
    q: Rows
    h: Rows
    interval: Expr
    variance: Fraction | None
    assigned: Mapping[str, Expr]
    scope: Scope

    @property
    def scale(self) -> Expr:
        """The variance of the measurement."""
        return power(SIGMA, 2) if self.variance is None else number(self.variance)

    def without_interval(self, setting: Setting) -> bool:
        """Whether neither the model nor its source speaks of the sampling interval."""
        named = any(entry.quantity == INTERVAL for entry in setting.symbols.values())
        return self.interval != T and not named


def read_own(setting: Setting) -> Own:
    """The matrices of a model with one measurement. Raises Undecided."""
    scope, (f, q, h, r) = read_matrices(setting)
    if len(r) != 1:
        raise Undecided(f"a steady state with {len(r)} measurements is not covered")
    noise = measurement_noise(r[0][0])
    for token, value in noise.items():
        # a variance of which nothing is said is positive, as the quantity of that name
        if setting.symbols[token].domain or substituted(value, {DEVIATION: -SIGMA}) != value:
            require_sign(token, scope, ">")
    assigned = {**interval_symbol(setting, scope), **noise}
    put_in = {free_name(token): expr for token, expr in assigned.items()}
    f, q, h = ([[substituted(x, put_in) for x in row] for row in matrix] for matrix in (f, q, h))
    names = symbols_of(*[x for matrix in (f, q, h) for row in matrix for x in row])
    # a model without the sampling interval is in units of it
    interval = T if INTERVAL in names else number(1)
    return Own(f, q, h, interval, variance_in(r[0][0]), assigned, scope)


def require_sign(token: str, scope: Scope, operator: str) -> None:
    """Raises Undecided unless a symbol of the noises is > or >= 0, whichever is asked, by what the
    domains say of the symbols of the model.

    The model holds its square, or its filters leave out where it is 0: what is found of them is
    true of a positive symbol.
    """
    said = [scope.relation(r) for t in tuple(scope.used) for r in scope.setting.symbols[t].domain]
    asked = Rel(operator, symbol(free_name(token)), number(0))
    statement = Statement((asked,), tuple(said))
    boxes = {name: Box() for name in statement.symbols()}
    boxes |= {name: POSITIVE for name in (INTERVAL, DEVIATION, INDEX) if name in boxes}
    try:
        shown = settle(statement, boxes, None, {}).verdict == "proved"
    except Undecided:
        shown = False
    if not shown:
        raise Undecided(f"the model is solved for {token} > 0 only: say {token} > 0 in its domain")


def variance_in(r: Expr) -> Fraction | None:
    """The variance of the measurement where it is a number. Raises Undecided where it is none."""
    value = constant_value(r)
    if value is not None and value <= 0:
        raise Undecided(f"the variance of the measurement is {value}: it must be positive")
    return value


def measurement_noise(r: Expr) -> dict[str, Expr]:
    """What the symbol in the measurement noise is, a variance or a deviation; empty where there is
    none, or the variance itself. Raises Undecided.
    """
    found = monomials(r)
    if constant_value(r) is not None or found == monomials(power(SIGMA, 2)):
        return {}
    if len(found) == 1:
        ((monomial, c),) = found.items()
        powers = dict(ordered(monomial))
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


def interval_symbol(setting: Setting, scope: Scope) -> dict[str, Expr]:
    """The one free symbol with the unit of a time is the sampling interval, unless another symbol
    is.
    """
    if T in scope.used.values():
        return {}
    found = [
        token
        for token, value in scope.used.items()
        if value == symbol(free_name(token)) and _is_time(setting, token)
    ]
    return {found[0]: T} if len(found) == 1 else {}


def _is_time(setting: Setting, token: str) -> bool:
    unit = setting.symbols[token].unit
    return unit == Unit(second=Fraction(1))


def not_symmetric(i: int, j: int) -> Undecided:
    """The reason for a process noise in which two entries differ."""
    return Undecided(
        f"the process noise of the model is not symmetric: row {i + 1}, column {j + 1} and "
        f"row {j + 1}, column {i + 1} differ"
    )


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


@dataclass(frozen=True)
class Driven:
    """The process noise over the variance of the measurement: index^2 times `rows`.

    `squared_index` is known where both are numbers. Otherwise `intensity` is what the source's
    symbol of the strength is, or `deviation` that of the measurement, in terms of the index;
    `is_root` says that the strength is that symbol's square.
    """

    rows: list[list[str]]
    squared_index: Fraction | None = None
    intensity: Mapping[str, Expr] = field(default_factory=dict)
    deviation: Expr | None = None
    is_root: bool = False


def noise_in_units(q: Rows, interval: Expr, variance: Expr) -> Driven:
    """The square of the index is what all entries share beside their numbers, as in `derive`; where
    all are numbers, the last one on the diagonal that is not zero. Raises Undecided.
    """
    below = 1 / variance
    entries = [
        [monomials(mul(x, below, power(interval, i + j))) for j, x in enumerate(row)]
        for i, row in enumerate(q)
    ]
    common = {m for row in entries for found in row for m in found}
    if not common:
        return Driven([["0" for _ in row] for row in q], Fraction(0))
    if len(common) != 1 or any(len(found) > 1 for row in entries for found in row):
        raise Undecided(
            "the process noise of the model is no one strength times a matrix of numbers: several "
            "strengths are not covered"
        )
    (shared,) = common
    values = [[found.get(shared, Fraction(0)) for found in row] for row in entries]
    last = next((c for c in reversed([row[i] for i, row in enumerate(values)]) if c), None)
    if last is None or last < 0:
        found = "all 0" if last is None else "negative"
        raise Undecided(
            f"the process noise of the model is no covariance: on its diagonal is what is {found}"
        )
    if not shared:
        return Driven([[str(x / last) for x in row] for row in values], last)
    rows = [[str(x) for x in row] for row in values]
    if dict(shared) == {symbol(INDEX): 2}:
        return Driven(rows)
    return replace(_strength(shared), rows=rows)


def _strength(shared: Monomial) -> Driven:
    """From index^2 = shared what the one free symbol of it is, be it of the process noise or
    of the measurement. Raises Undecided.
    """
    powers = dict(ordered(shared))
    unknown = [base for base in powers if source_token(base)]
    if len(unknown) == 1 and powers[unknown[0]] in (1, 2):
        rest = [power(base, -n) for base, n in powers.items() if base != unknown[0]]
        value = mul(power(symbol(INDEX), 2), *rest)
        is_root = powers[unknown[0]] == 2
        if is_root:
            value = _root(powers, unknown[0])
        return Driven([], intensity={source_token(unknown[0]): value}, is_root=is_root)
    if not unknown and powers.get(SIGMA) == -2 and symbol(INDEX) not in powers:
        return Driven([], deviation=1 / _root(powers, SIGMA))
    raise Undecided(
        "the process noise or the measurement noise of the model must have one symbol as its "
        "strength, all else numbers and powers of the sampling interval"
    )


def _root(powers: Mapping[Expr, int], unknown: Expr) -> Expr:
    """The square root of index^2 over the other powers, all of which are positive."""
    rest = [power(base, Fraction(-n, 2)) for base, n in powers.items() if base != unknown]
    return mul(symbol(INDEX), *rest)
