"""The steady-state Kalman filter of a model with one scalar measurement: solved here, then
established.

Solved from the model's matrices alone: spectral factor, gains by matching the closed-loop
polynomial, covariance from linear equations. None of this is trusted: what makes the result the
steady state is that the Riccati residual vanishes identically, that the closed loop is stable and
that the covariance is positive, each shown with the exact tools for all values of the parameter;
and, where the parameter is not the tracking index, that it runs through all positive indices
(`established`). A stabilising solution is unique (a textbook theorem, cited).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from operator import mul
from typing import Any

from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import Fact
from gainproof.verify.judge.setting.matrices import (
    Exprs,
    Numbers,
    exprs,
    minus,
    model_matrices,
    solve_rows,
    times,
)
from gainproof.verify.judge.setting.spectral_factor import Factor
from gainproof.verify.judge.setting.spectrum import resolvent
from gainproof.verify.judge.setting.stable_factor import stable_factor
from gainproof.verify.judge.setting.steady_state_conditions import established
from gainproof.verify.judge.transcendental.constant_folding import folded


@dataclass(frozen=True)
class SteadyState:
    """All in units T = 1, measurement noise variance of the model; expressions of the parameter of
    `factor`, which for one and two states is the tracking index, and for three is none. `put_in` is
    what they were solved in.
    """

    transition: Exprs
    measurement: Exprs
    filter_gain: tuple[Expr, ...]
    predictor_gain: tuple[Expr, ...]
    predicted: Exprs
    updated: Exprs
    factor: Factor
    facts: tuple[Fact, ...]
    put_in: Mapping[str, Expr] = field(default_factory=dict)

    @property
    def innovation(self) -> Expr:
        """The innovation variance."""
        return self.factor.innovation


def solve(model: Mapping[str, Any], squared_index: Fraction | None = None) -> SteadyState:
    """The established steady state of a model, for all tracking indices or for one. Raises
    Malformed, Undecided, NotEstablished.
    """
    f, q, h, r = model_matrices(model)
    if len(h) != 1:
        raise Undecided(f"a steady state with {len(h)} measurements is not covered")
    d, rows = _observed(f, h)
    # looked at first: what is not seen would be told as a mode that is not driven
    if solve_rows(rows, [number(0) for _ in rows]) is None:
        raise Undecided("the state is not observable")
    factor = stable_factor(f, q, h, r[0][0], squared_index)
    predictor = _predictor_gain(d, rows, factor)
    gain = solve_rows(f, predictor)
    predicted = _predicted(f, q, h, r[0][0], gain, predictor, factor)
    big, seen = exprs(f), exprs(h)
    observed = times(seen, predicted)
    if gain is None:
        gain = [folded(x / factor.innovation) for x in observed[0]]
    updated = minus(predicted, times(tuple((g,) for g in gain), observed))
    facts = established(big, exprs(q), seen, r[0][0], predicted, updated, gain, predictor, factor)
    return SteadyState(
        big,
        seen,
        tuple(factor.placed(e) for e in gain),
        tuple(factor.placed(e) for e in predictor),
        tuple(tuple(factor.placed(e) for e in row) for row in predicted),
        tuple(tuple(factor.placed(e) for e in row) for row in updated),
        factor.in_parameter(),
        facts,
        dict(factor.put_in),
    )


def _observed(f: Numbers, h: Numbers) -> tuple[Sequence[Fraction], Numbers]:
    """det(zI - F) and H adj(zI - F), by powers of z; the rows are independent where the state is
    observable.
    """
    d, parts = resolvent(f)
    rows = tuple(
        tuple(sum((x * part[i][j] for i, x in enumerate(h[0])), Fraction(0)) for j in range(len(f)))
        for part in parts
    )
    return d, rows


def _predictor_gain(d: Sequence[Fraction], rows: Numbers, factor: Factor) -> list[Expr]:
    """L with det(zI - F + L H) = c(z), linear because it is det(zI - F) + H adj(zI - F) L."""
    right = [c - number(before) for c, before in zip(factor.coefficients, d, strict=False)]
    solved = solve_rows(rows, right)
    assert solved is not None, "an observable state"
    return [folded(x) for x in solved]


def _predicted(
    f: Numbers,
    q: Numbers,
    h: Numbers,
    r: Fraction,
    gain: list[Expr] | None,
    predictor: list[Expr],
    factor: Factor,
) -> Exprs:
    """M from M H' = S K and M - F M F' = index^2 Q - S L L', linear in its upper entries; where F
    has no inverse, so that L does not tell K, from F M H' = S L and H M H' = S - R instead.
    """
    size = len(f)
    pairs = [(i, j) for i in range(size) for j in range(i, size)]
    index2, innovation = factor.squared_index, factor.innovation
    rows: list[list[Fraction]] = []
    right: list[Expr] = []
    seen = [[_share(h[0], i, pair) for pair in pairs] for i in range(size)]
    if gain is not None:
        rows += seen
        right += [innovation * g for g in gain]
    else:
        for weights, value in zip(
            (*f, h[0]), (*[innovation * g for g in predictor], innovation - number(r)), strict=True
        ):
            columns = zip(*seen, strict=True)
            rows.append([sum(map(mul, weights, column), Fraction(0)) for column in columns])
            right.append(value)
    for i, j in pairs:
        row = []
        for p, s in pairs:
            moved = f[i][p] * f[j][s] + (f[i][s] * f[j][p] if p != s else 0)
            row.append(Fraction(int((i, j) == (p, s))) - moved)
        rows.append(row)
        right.append(number(q[i][j]) * index2 - innovation * predictor[i] * predictor[j])
    solved = solve_rows(rows, right)
    if solved is None:
        raise Undecided("the covariance is not fixed by gain and Riccati equation")
    entries = dict(zip(pairs, map(folded, solved), strict=True))
    return tuple(tuple(entries[min(i, j), max(i, j)] for j in range(size)) for i in range(size))


def _share(row: tuple[Fraction, ...], i: int, pair: tuple[int, int]) -> Fraction:
    """What an entry of M counts in component i of M H'."""
    p, s = pair
    if p == s:
        return row[p] if i == p else Fraction(0)
    return (row[s] if i == p else Fraction(0)) + (row[p] if i == s else Fraction(0))
