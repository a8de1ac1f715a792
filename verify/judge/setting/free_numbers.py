"""Steady states of models with free numbers in their matrices and several strengths of the noise.

A Riccati equation is hard to solve for the gains, but linear in what drives it. In units T = 1 and
measurement noise 1, with K the gain and S = 1/(1 - H K), the equations M H' = S K and
M = F (M - S K K') F' + sum of x_s C_s are linear in M and in the strengths x_s. So the gains are
the base variables; covariances and strengths are rational in them and in the free numbers. Where
there are fewer strengths than gains, equations between these are left, each of which is solved for
a gain that it holds linearly.

Every steady state has gains, of which all this is true. Conversely, where S > 0, the closed loop is
stable and the process noise a covariance, these are the steady state, as there is only one.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import combinations

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, mul, number, power, symbol, symbols_of
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.free_names import free_name, is_free, token_of, with_tokens
from gainproof.verify.judge.exact.polynomial import Poly, coefficients_in, degree
from gainproof.verify.judge.exact.simplification import expression_of, tidied
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.fixed_gain.rational_system import lowest, numerator_and_denominator
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.meaning.square_matrices import determinant
from gainproof.verify.judge.setting.environment import (
    DEVIATION,
    INDEX,
    INTERVAL,
    Environment,
    Fact,
    NotEstablished,
)
from gainproof.verify.judge.setting.matrices import Exprs, minus, plus, times, transposed
from gainproof.verify.judge.setting.own_matrices import (
    SIGMA,
    Own,
    Rows,
    T,
    not_symmetric,
    read_own,
    require_sign,
)
from gainproof.verify.judge.setting.quantities import environment_of
from gainproof.verify.judge.setting.spectral_factor import Factor, number_root
from gainproof.verify.judge.setting.stability_conditions import circle_moved, left_half_plane
from gainproof.verify.judge.setting.steady_state import SteadyState
from gainproof.verify.judge.setting.steady_state_conditions import UNIQUENESS, characteristic
from gainproof.verify.judge.transcendental.monomials import (
    Monomial,
    monomial_expr,
    monomials,
    ordered,
)

MOST_STATES = 3
ONE, ZERO = number(1), number(0)


@dataclass(frozen=True)
class Strength:
    """A symbol to a power that drives the filter: `base`^`exponent` is a number over `unit`, and
    that number times `matrix` is its part of the process noise.
    """

    base: Expr
    exponent: int
    unit: Expr
    matrix: Exprs

    def symbol_at(self, x: Expr) -> Expr:
        """The symbol where the number is x."""
        found = x if self.unit == ONE else x / self.unit
        return found if self.exponent == 1 else power(found, Fraction(1, self.exponent))


@dataclass(frozen=True)
class Model:
    """A model in units T = 1 and measurement noise 1: rational expressions of free numbers."""

    f: Exprs
    h: Exprs
    rest: Exprs
    strengths: tuple[Strength, ...]
    free: tuple[str, ...]


@dataclass(frozen=True)
class Solution:
    """The covariance of the prediction and the numbers of the strengths over the gains, and `gains`
    themselves.
    """

    gains: tuple[Expr, ...]
    predicted: Exprs
    numbers: tuple[Expr, ...]


def over_gains(setting: Setting) -> Environment | None:
    """The steady state, or None for a model without free numbers and with at most one strength.
    Raises Undecided, NotEstablished.
    """
    own = read_own(setting)
    model = _scaled(own)
    if set(model.free) <= {INTERVAL} and len(model.strengths) < 2:
        return None
    for strength in model.strengths:
        if strength.exponent == 2 and is_free(strength.base):
            require_sign(token_of(strength.base.name), own.scope, ">=")
    if len(model.f) > MOST_STATES:
        raise Undecided(f"a steady state with {len(model.f)} states and free numbers")
    said = _said(setting, own, model)
    found = _solved(model, tuple(rel for rel in said if _names(rel) <= set(model.free)))
    state, conditions = _state(model, found, said)
    solved = environment_of(state, setting.name)
    numbers = zip(model.strengths, found.numbers, strict=True)
    values = {strength.base: strength.symbol_at(x) for strength, x in numbers}
    known = {base.name: x for base, x in values.items() if not is_free(base)}
    if own.variance is not None:
        known[DEVIATION] = number_root(own.variance)
    if own.without_interval(setting):
        known[INTERVAL] = ONE
    assigned = {token_of(base.name): x for base, x in values.items() if is_free(base)}
    conditions = tuple(
        Rel(r.operator, substituted(r.left, known), substituted(r.right, known)) for r in conditions
    )
    quantities = dict(solved.quantities)
    missing = {}
    if INDEX not in known:
        del quantities[INDEX]
        missing[INDEX] = "a filter with several strengths or free numbers has no one tracking index"
    hidden = frozenset(e.name for e in found.gains if e.kind == "symbol")
    return replace(
        solved,
        quantities={name: substituted(e, known) for name, e in quantities.items()},
        boxes={**solved.boxes, **dict.fromkeys(hidden, Box())},
        missing=missing,
        assigned={n: substituted(e, known) for n, e in {**own.assigned, **assigned}.items()},
        conditions=conditions,
        hidden=hidden,
    )


def _scaled(own: Own) -> Model:
    """The model in units. Raises Undecided where a matrix does not scale."""
    f = _in_units(own.f, 1, -1, own.interval, "transition")
    h = _in_units(own.h, 0, -1, own.interval, "measurement")
    fixed = symbols_of(*[x for row in (*f, *h) for x in row])
    entries = [
        [monomials(mul(x, 1 / own.scale, power(own.interval, i + j))) for j, x in enumerate(row)]
        for i, row in enumerate(own.q)
    ]
    for i, j in combinations(range(len(entries)), 2):
        if entries[i][j] != entries[j][i]:
            raise not_symmetric(i, j)
    parts: dict[tuple[Expr, int, Expr] | None, list[list[Expr]]] = {}
    for i, row in enumerate(entries):
        for j, found in enumerate(row):
            for monomial, c in found.items():
                key, factor = _driving(monomial, fixed)
                zeros = [[ZERO for _ in row] for _ in entries]
                part = parts.setdefault(key, zeros)
                part[i][j] = part[i][j] + mul(number(c), factor)
    rest = parts.pop(None, [[ZERO for _ in row] for row in entries])
    strengths = tuple(
        Strength(base, exponent, unit, _grid(part))
        for key, part in parts.items()
        if key is not None
        for base, exponent, unit in [key]
    )
    names = symbols_of(*[x for part in (f, h, rest, *parts.values()) for row in part for x in row])
    bases = [s.base.name for s in strengths]
    if len(set(bases)) < len(bases) or names & {*bases, DEVIATION, INDEX}:
        raise Undecided("the noises of the model are no sum of strengths times matrices of numbers")
    return Model(f, h, _grid(rest), strengths, tuple(sorted(names)))


def _grid(rows: Sequence[Sequence[Expr]]) -> Exprs:
    return tuple(map(tuple, rows))


def _in_units(matrix: Rows, a: int, b: int, interval: Expr, name: str) -> Exprs:
    """The entries times T^(a i + b j). Raises Undecided where they are no numbers in units."""
    found = tuple(
        tuple(tidied(mul(x, power(interval, a * i + b * j))) for j, x in enumerate(row))
        for i, row in enumerate(matrix)
    )
    if symbols_of(*[x for row in found for x in row]) & {DEVIATION, INDEX}:
        raise Undecided(f"the {name} of the model holds what belongs to the noises")
    return found


def _driving(monomial: Monomial, fixed: set[str]) -> tuple[tuple[Expr, int, Expr] | None, Expr]:
    """The strength in a monomial of the process noise, with its exponent and unit, and all other
    factors. Raises Undecided for several.
    """
    powers = dict(ordered(monomial))
    own = [b for b in powers if (is_free(b) and b.name not in fixed) or b == symbol(INDEX)]
    if not own and SIGMA in powers:
        own = [SIGMA]
    if not own:
        return None, monomial_expr(monomial)
    if len(own) > 1 or powers[own[0]] not in ((1, 2) if own != [SIGMA] else (-2,)):
        raise Undecided("the process noise of the model holds a product of symbols as a strength")
    base, exponent = own[0], powers.pop(own[0])
    # an interval that the transition holds, over a time constant say, is a number like others
    units = (SIGMA,) if INTERVAL in fixed else (T, SIGMA)
    unit = frozenset((b, n) for b, n in powers.items() if b in units)
    factor = frozenset((b, n) for b, n in powers.items() if b not in units)
    return (base, exponent, monomial_expr(unit)), monomial_expr(factor)


def _said(setting: Setting, own: Own, model: Model) -> tuple[Rel, ...]:
    """What the setting says of the symbols of its model, by the numbers of the strengths."""
    unknown = {s.base.name: (s, symbol(f"strength {k}")) for k, s in enumerate(model.strengths)}
    values = {name: strength.symbol_at(x) for name, (strength, x) in unknown.items()}
    values |= {free_name(token): expr for token, expr in own.assigned.items()}
    found = [Rel(">", T, ZERO)] if INTERVAL in model.free else []
    for token in tuple(own.scope.used):
        for relation in setting.symbols[token].domain:
            rel = own.scope.relation(relation)
            if rel.right == ZERO and rel.left.kind == "symbol" and rel.left.name in unknown:
                left, right = unknown[rel.left.name][1], ZERO
            else:
                left, right = (substituted(side, values) for side in (rel.left, rel.right))
            found.append(Rel(rel.operator, left, right))
    # T and the deviation are positive
    return tuple(rel for rel in found if not _names(rel) <= {INTERVAL, DEVIATION} - set(model.free))


def _names(rel: Rel) -> set[str]:
    return symbols_of(rel.left, rel.right)


def _solved(model: Model, said: tuple[Rel, ...]) -> Solution:
    """Covariance and strengths from the equations, which are linear in them. Raises Undecided."""
    size = range(len(model.f))
    gains = [symbol(f"filter_gain.{i + 1}") for i in size]
    column = tuple((g,) for g in gains)
    whole = tuple(tuple(symbol(f"covariance {min(i, j)} {max(i, j)}") for j in size) for i in size)
    numbers = tuple(symbol(f"strength {k}") for k in range(len(model.strengths)))
    # times 1 - H K all equations are polynomials in the gains
    share = 1 - times(model.h, column)[0][0]
    noise = _noise(model, numbers, share)
    updated = minus(whole, times(column, transposed(column)))
    moved = plus(times(times(model.f, updated), transposed(model.f)), noise)
    seen = times(whole, transposed(model.h))
    equations = [a[0] - b for a, b in zip(seen, gains, strict=True)]
    equations += [whole[i][j] - moved[i][j] for i in size for j in size if i <= j]
    unknown = [e.name for e in dict.fromkeys(x for row in whole for x in row)]
    unknown += [x.name for x in numbers]
    stable = (Rel(">", share, ZERO), *_stable(model, column), *said)
    values = _eliminated(equations, unknown, [g.name for g in reversed(gains)], model.free, stable)
    if any(name not in values for name in unknown):
        raise Undecided("the noise of the model has more strengths than the gains tell")
    names = (*[g.name for g in gains], *model.free)

    def over(expr: Expr) -> Expr:
        return lowest(substituted(expr, values), names)

    return Solution(
        tuple(over(g) for g in gains),
        tuple(tuple(over(x / share) for x in row) for row in whole),
        tuple(over(x / share) for x in numbers),
    )


def _eliminated(
    equations: Sequence[Expr],
    unknown: Sequence[str],
    gains: Sequence[str],
    free: Sequence[str],
    conditions: tuple[Rel, ...],
) -> dict[str, Expr]:
    """What equations tell of the unknowns, and of the gains where these hold them linearly. Raises
    Undecided, also where a divisor may be zero under `conditions`. These hold of every filter; what
    follows from the solution says nothing of filters at which it divides by zero.
    """
    names = (*unknown, *gains, *free)
    values: dict[str, Expr] = {}
    left = list(equations)
    while left:
        rows = [numerator_and_denominator(substituted(e, values), names)[0] for e in left]
        rows = [p for p in rows if not p.is_zero()]
        if not rows:
            break
        choices = [_linear(p, k, names) for p in rows for k in range(len(unknown))]
        chosen = min((c for c in choices if c is not None), key=lambda c: c.cost, default=None)
        if chosen is None:
            parts = [_one_factor(p, names, conditions) for p in rows]
            spots = range(len(unknown), len(unknown) + len(gains))
            choices = [_linear(p, k, names) for p in parts for k in spots]
            chosen = next((c for c in choices if c is not None), None)
        if chosen is None:
            raise Undecided("the gains of the model are no rational functions of one another")
        put_in = {chosen.name: lowest(chosen.value, names)}
        if chosen.cost and not _is_nonzero(chosen.divisor, conditions):
            raise Undecided(
                "the gains do not tell the covariance of the model where "
                f"{_in_words(chosen.divisor)} is 0, which no domain excludes"
            )
        values = {name: substituted(e, put_in) for name, e in values.items()} | put_in
        left = [expression_of(p, names) for p in rows]
    return values


@dataclass(frozen=True)
class Linear:
    """A symbol with its value by an equation; `cost` is 0 where the divisor is a number."""

    name: str
    value: Expr
    divisor: Expr
    cost: int


def _linear(p: Poly, place: int, names: Sequence[str]) -> Linear | None:
    """The variable at a place by the equation p = 0, if it holds it linearly."""
    if degree(p, place) != 1:
        return None
    rest, divisor = coefficients_in(p, place, 2)
    bottom = expression_of(divisor, names)
    cost = 0 if divisor.is_constant() else len(divisor)
    return Linear(names[place], -expression_of(rest, names) / bottom, bottom, cost)


def _one_factor(p: Poly, names: Sequence[str], conditions: tuple[Rel, ...]) -> Poly:
    """The one factor of p that may be zero. Raises Undecided where it is not known which it is."""
    factors = [factor for factor, _ in p.factor()[1]]
    if len(factors) > 1:
        factors = [f for f in factors if not _is_nonzero(expression_of(f, names), conditions)]
    if len(factors) != 1:
        raise Undecided("the gains of the model are no rational functions of one another")
    return factors[0]


def _in_words(expr: Expr) -> str:
    """The text of an expression of gains, free numbers and T."""
    return labelled(expr, with_tokens({INTERVAL: "T"}, symbols_of(expr)))


def _is_nonzero(expr: Expr, conditions: tuple[Rel, ...]) -> bool:
    """Whether it is shown to be nowhere zero under conditions."""
    boxes = dict.fromkeys(
        symbols_of(expr, *[e for r in conditions for e in (r.left, r.right)]), Box()
    )
    try:
        found = settle(Statement((Rel("!=", expr, ZERO),), conditions), boxes, None, {})
    except Undecided:
        return False
    return found.verdict == "proved"


def _noise(model: Model, numbers: Sequence[Expr], share: Expr) -> Exprs:
    """Its covariance over the variance of the measurement, `share` of what is no strength."""
    noise = tuple(tuple(ZERO if x == ZERO else mul(share, x) for x in row) for row in model.rest)
    for x, strength in zip(numbers, model.strengths, strict=True):
        part = tuple(
            tuple(ZERO if c == ZERO else mul(x, c) for c in row) for row in strength.matrix
        )
        noise = plus(noise, part)
    return noise


def _stable(model: Model, gain: Exprs) -> list[Rel]:
    """That the closed loop F (I - K H) is stable."""
    loop = minus(model.f, times(times(model.f, gain), model.h))
    return left_half_plane(circle_moved([*characteristic(loop), ONE]))


def _state(
    model: Model, found: Solution, said: tuple[Rel, ...]
) -> tuple[SteadyState, tuple[Rel, ...]]:
    """The steady state, and where it is one. Raises NotEstablished."""
    gain = tuple((g,) for g in found.gains)
    names = (*[g.name for g in found.gains if g.kind == "symbol"], *model.free)
    share = 1 - times(model.h, gain)[0][0]
    innovation = lowest(1 / share, names)
    noise = _noise(model, found.numbers, ONE)
    updated = minus(found.predicted, times(times(gain, model.h), found.predicted))
    again = plus(times(times(model.f, updated), transposed(model.f)), noise)
    variance = times(times(model.h, found.predicted), transposed(model.h))[0][0] + 1
    residuals = [x for row in minus(again, found.predicted) for x in row]
    residuals += [
        a[0] - variance * g
        for a, g in zip(times(found.predicted, transposed(model.h)), found.gains, strict=True)
    ]
    residuals.append(variance - innovation)
    sentence = (
        "the Riccati equation, gain and innovation variance hold identically: "
        "M = F X F' + Q, S K = M H', S = H M H' + R"
    )
    if any(lowest(e, names) != ZERO for e in residuals):
        raise NotEstablished(sentence)
    loop = minus(model.f, times(times(model.f, gain), model.h))
    coefficients = characteristic(loop)
    predictor = tuple(row[0] for row in times(model.f, gain))
    numbers = {f"strength {k}": x for k, x in enumerate(found.numbers)}
    stated = [
        Rel(rel.operator, substituted(rel.left, numbers), substituted(rel.right, numbers))
        for rel in said
    ]
    # a deviation is a root of its number; that of the measurement, and the index, are positive
    stated += [
        Rel(">=" if is_free(strength.base) else ">", x, ZERO)
        for x, strength in zip(found.numbers, model.strengths, strict=True)
        if strength.exponent != 1
    ]
    signs = (rel for rel in stated if rel.operator == ">" and rel.right == ZERO)
    positive = [rel.left for rel in signs if _names(rel) <= set(names)]
    covariance = [
        e
        for e in _covariance(noise)
        if not any((constant_value(lowest(e / x, names)) or 0) > 0 for x in positive)
    ]
    conditions = (
        Rel(">", share, ZERO),
        *left_half_plane(circle_moved([*coefficients, ONE])),
        *[Rel(">=", e, ZERO) for e in covariance],
        *dict.fromkeys(stated),
    )
    facts = (
        Fact(sentence, "rational functions"),
        Fact(
            "gains count where the innovation has a variance, the closed loop is stable and the "
            "process noise is a covariance",
            "conditions of every claim",
        ),
        Fact(f"cited: {UNIQUENESS[0]}", UNIQUENESS[1]),
    )
    factor = Factor(tuple(coefficients), innovation, None)
    return (
        SteadyState(
            model.f, model.h, found.gains, predictor, found.predicted, updated, factor, facts
        ),
        conditions,
    )


def _covariance(noise: Exprs) -> list[Expr]:
    """The principal minors, none of which is negative; of a diagonal matrix its entries."""
    size = range(len(noise))
    diagonal = all(noise[i][j] == ZERO for i in size for j in size if i != j)
    minors = []
    for count in range(1, 2 if diagonal else len(noise) + 1):
        minors += [
            determinant(tuple(tuple(noise[i][j] for j in chosen) for i in chosen))
            for chosen in combinations(size, count)
        ]
    return [e for e in minors if e != ZERO]
