"""Transition, measurement and process noise of a filter with free gains, from its setting."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import factorial

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, power, symbol, symbols_of
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.meaning.definition_names import Reach, names_in
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import DEVIATION, INTERVAL, Environment
from gainproof.verify.judge.setting.matrices import Numbers, numbers
from gainproof.verify.judge.setting.own_matrices import T, in_units, interval_symbol


@dataclass(frozen=True)
class GainModel:
    """F and H in units T = 1; `noise` holds the entries of Q that are not zero, by pair of
    components from 0, the first not above the second, in the source's units and symbols.
    `assigned` are symbols of the source that stand for the sampling interval.
    """

    transition: Numbers
    measurement: tuple[Fraction, ...]
    noise: Mapping[tuple[int, int], Expr] = field(default_factory=dict)
    assigned: Mapping[str, Expr] = field(default_factory=dict)


def gain_model(setting: Setting) -> GainModel:
    """The model of a setting of kind `fixed_gain`. Raises Undecided."""
    scope = Scope(setting, _known())
    own = setting.gain_matrices
    given = {name: _rows(rows, scope) for name, rows in own.items()}
    assigned = interval_symbol(setting, scope) if given else {}
    put_in = {free_name(token): expr for token, expr in assigned.items()}
    given = {
        name: [[substituted(x, put_in) for x in row] for row in rows]
        for name, rows in given.items()
    }
    if "transition" in given:
        f, h = given["transition"], given["measurement"]
        names = symbols_of(*[x for matrix in (f, h) for row in matrix for x in row])
        interval = T if INTERVAL in names else number(1)
        transition = numbers(in_units(f, (1, -1), interval, "transition"), "transition")
        (measurement,) = numbers(in_units(h, (0, -1), interval, "measurement"), "measurement")
    else:
        transition, measurement = _kinematic(setting.states or 0)
    noise = _noise(given["process_noise"]) if "process_noise" in given else {}
    return GainModel(transition, measurement, noise, assigned)


def gain_model_key(setting: Setting) -> str:
    """All that the environment depends on."""
    trees = [
        read_tree(entry) for rows in setting.gain_matrices.values() for row in rows for entry in row
    ]
    direct = {name for tree in trees for name in names_in(tree)}
    reach = Reach(setting.symbols)
    used = sorted(direct.union(*[reach.of(name) for name in direct]))
    symbols = [(name, setting.symbols.get(name)) for name in used]
    return repr((setting.states, setting.gain_matrices, symbols))


def _known() -> Environment:
    deviation = symbol(DEVIATION)
    return Environment(
        "the matrices of the filter",
        {INTERVAL: T, DEVIATION: deviation, "measurement_noise_variance": power(deviation, 2)},
    )


def _rows(rows: Sequence[Sequence[Graph]], scope: Scope) -> list[list[Expr]]:
    return [[scope.expression(entry) for entry in row] for row in rows]


def _kinematic(states: int) -> tuple[Numbers, tuple[Fraction, ...]]:
    size = range(states)
    transition = tuple(
        tuple(Fraction(1, factorial(j - i)) if j >= i else Fraction(0) for j in size) for i in size
    )
    return transition, tuple(Fraction(int(i == 0)) for i in size)


def _noise(rows: Sequence[Sequence[Expr]]) -> dict[tuple[int, int], Expr]:
    """The entries above and on the diagonal. Raises Undecided where they are seen to be no
    covariance: a matrix that is not symmetric.
    """
    found = {}
    for i, row in enumerate(rows):
        for j in range(i, len(rows)):
            if row[j] != rows[j][i]:
                raise Undecided("the process noise is not written as a symmetric matrix")
            if constant_value(row[j]) != 0:
                found[i, j] = row[j]
    return found
