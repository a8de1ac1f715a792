"""Environments of settings: the quantities of a steady state, of a growing or a fading memory in
the source's units.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.certificate import statement_data
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    mul,
    number,
    power,
    symbol,
    symbols_of,
    whole_power,
)
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.statement import Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import (
    ANY_REAL,
    DEVIATION,
    INDEX,
    INTERVAL,
    POSITIVE,
    SAMPLE,
    WEIGHT,
    Environment,
)
from gainproof.verify.judge.setting.fading_memory import WITHIN, fading_memory
from gainproof.verify.judge.setting.growing_memory import first, growing_memory
from gainproof.verify.judge.setting.matrices import Exprs, model_matrices, times, transposed
from gainproof.verify.judge.setting.steady_state import SteadyState, solve

T, SIGMA = symbol(INTERVAL), symbol(DEVIATION)
POLYNOMIALS = ("mean", "line", "parabola", "cubic")


def steady_state(model: Mapping[str, Any], squared_index: Fraction | None = None) -> Environment:
    """The steady state of a model. Without `squared_index` the tracking index is free."""
    if model.get("measurement_noise") != [["1"]] and model.get("measurement_noise") != (("1",),):
        raise Undecided(
            "model data must be in units of the measurement noise, with measurement_noise [['1']]"
        )
    found = environment_of(solve(model, squared_index), str(model.get("name", "model")))
    return replace(found, model=_model(model, found.quantities))


def environment_of(state: SteadyState, name: str) -> Environment:
    """The environment of a steady state that was solved."""
    factor, size = state.factor, len(state.filter_gain)
    quantities = {**common_quantities(), **state.put_in, INDEX: factor.index}
    for i in range(size):
        quantities[f"gain.{i + 1}"] = state.filter_gain[i]
        quantities[f"filter_gain.{i + 1}"] = state.filter_gain[i]
        quantities[f"predictor_gain.{i + 1}"] = state.predictor_gain[i]
    quantities |= covariances_in_units("predicted", state.predicted) | covariances_in_units(
        "updated", state.updated
    )
    quantities["innovation_variance"] = state.innovation * power(SIGMA, 2)
    quantities["closed_loop.trace"] = -factor.coefficients[-1]
    quantities["closed_loop.determinant"] = (-1) ** size * factor.coefficients[0]
    for j, coefficient in enumerate((*factor.coefficients, number(1))):
        quantities[f"closed_loop_coefficient.{j}"] = coefficient
    quantities |= filter_states(state.transition, state.filter_gain, state.measurement)
    boxes = {**factor.boxes(), **base_boxes(size)}
    return Environment(
        f"process noise {name}",
        quantities,
        boxes,
        factor.parameter,
        state.facts,
        conditions=factor.conditions,
    )


def _model(model: Mapping[str, Any], quantities: Mapping[str, Expr]) -> dict[str, Exprs]:
    """The matrices of the model and its steady state in the source's units; `units` of the gains,
    by which K has to be multiplied.
    """
    f, q, h, _ = model_matrices(model)
    states = range(len(f))
    strength = power(quantities[INDEX], 2) * power(SIGMA, 2)

    def entry(value: Fraction, interval: int, strength: Expr | None = None) -> Expr:
        factors = [] if value == 1 else [number(value)]
        factors += [] if strength is None else [strength]
        factors += [whole_power(T, interval)] if interval else []
        return mul(*factors or [number(1)]) if value else number(0)

    return {
        "F": tuple(tuple(entry(f[i][j], j - i) for j in states) for i in states),
        "H": tuple(tuple(entry(row[j], j) for j in states) for row in h),
        "Q": tuple(tuple(entry(q[i][j], -i - j, strength) for j in states) for i in states),
        "R": ((power(SIGMA, 2),),),
        "P": tuple(
            tuple(quantities[f"predicted_covariance.{i + 1}.{j + 1}"] for j in states)
            for i in states
        ),
        "K": tuple(
            (mul(quantities[f"filter_gain.{i + 1}"], power(T, -i)),)
            if i
            else (quantities["filter_gain.1"],)
            for i in states
        ),
        "units": (tuple(whole_power(T, i) for i in states),),
    }


def model_data(environment: Environment, meanings: Mapping[str, Expr]) -> dict[str, Any]:
    """The matrices of a steady state as graphs, and what symbols of the source stand for in terms
    of gain K, covariances P and X = P - K H P, and innovation variance S; empty without a model.
    """
    if not environment.model:
        return {}
    quantities, size = environment.quantities, len(environment.model["F"])
    known = {quantities["innovation_variance"].key: symbol("S[1,1]")}
    columns = [symbol(f"K[{i + 1},1]") for i in range(size)]
    for i, unit in enumerate(environment.model["units"][0]):
        gain = mul(columns[i], unit) if i else columns[i]
        known[quantities[f"filter_gain.{i + 1}"].key] = gain
        row = environment.model["F"][i]
        moved = add(*(mul(f, k) for f, k in zip(row, columns, strict=True)), number(0))
        known.setdefault(quantities[f"predictor_gain.{i + 1}"].key, mul(moved, unit))
        for j in range(size):
            for name, which in (("P", "predicted"), ("X", "updated")):
                entry = quantities[f"{which}_covariance.{i + 1}.{j + 1}"]
                known.setdefault(entry.key, symbol(f"{name}[{i + 1},{j + 1}]"))
    letters = {
        token: rebuilt(expr, lambda node, _: known.get(node.key))
        for token, expr in meanings.items()
    }
    if all(letters[token] == expr for token, expr in meanings.items()):
        return {}
    model = {name: rows for name, rows in environment.model.items() if name != "units"}
    entries = [entry for rows in environment.model.values() for row in rows for entry in row]
    boxes = {name: environment.boxes[name] for name in symbols_of(*entries)}
    return {
        "model": {
            name: [[graph_of(entry) for entry in row] for row in rows]
            for name, rows in model.items()
        },
        "domain of the model": statement_data(Statement(()), boxes, None, {})["domain"],
        "letters": {token: graph_of(expr) for token, expr in letters.items()},
    }


def memory(degree: int) -> Environment:
    """Least squares over all samples with a polynomial of this degree. Raises Undecided."""
    fit = growing_memory(degree)
    size = degree + 1
    before = tuple(
        tuple(substituted(e, {SAMPLE: symbol(SAMPLE) - 1}) for e in row) for row in fit.updated
    )
    predicted = times(times(fit.transition, before), transposed(fit.transition))
    quantities = _fitted(fit.transition, fit.gain, predicted, fit.updated)
    quantities |= covariances_in_units("information", fit.information)
    quantities[SAMPLE] = symbol(SAMPLE)
    missing = {}
    if degree == 0:
        quantities["first_updated_state.1"] = symbol("first_measurement")
    else:
        missing["first_updated_state.1"] = "one sample does not determine the least-squares fit"
    boxes = {
        SAMPLE: Box(lower=Fraction(degree), lower_open=False, integer=True),
        **base_boxes(size),
    }
    continued = {f"filter_gain.{i + 1}": gain for i, gain in enumerate(fit.continued_gain)}
    name = f"least squares, {POLYNOMIALS[degree]}"
    return Environment(name, quantities, boxes, SAMPLE, fit.facts, missing, continued)


def fading(degree: int) -> Environment:
    """Weighted least squares over all samples of the past with a polynomial of this degree, in the
    weight. Raises Undecided.
    """
    fit = fading_memory(degree)
    size = degree + 1
    quantities = _fitted(fit.transition, fit.gain, fit.predicted, fit.updated)
    del quantities[INDEX]
    quantities[WEIGHT] = symbol(WEIGHT)
    quantities |= {f"closed_loop_coefficient.{i}": c for i, c in enumerate(fit.closed_loop)}
    quantities[f"closed_loop_coefficient.{size}"] = number(1)
    motion = symbol(f"target_motion.{size}")
    quantities[f"target_motion.{size}"] = motion
    for which, lags in (("predicted", fit.predicted_lag), ("updated", fit.updated_lag)):
        for i, lag in enumerate(lags):
            found = {m: number(0) for m in range(size)}
            found[size] = lag * motion * whole_power(T, size - i)
            quantities |= {f"{which}_lag.{i + 1}.{m}": value for m, value in found.items()}
    boxes = {WEIGHT: WITHIN, f"target_motion.{size}": ANY_REAL, **base_boxes(size)}
    missing = {INDEX: "a fading memory has no tracking index"}
    name = f"fading memory, {POLYNOMIALS[degree]}"
    return Environment(name, quantities, boxes, WEIGHT, fit.facts, missing)


def _fitted(
    transition: Exprs, gain: tuple[Expr, ...], predicted: Exprs, updated: Exprs
) -> dict[str, Expr]:
    """The quantities of a polynomial fitted to positions, by its gain and covariances in units."""
    predictor = tuple(row[0] for row in times(transition, tuple((g,) for g in gain)))
    quantities = common_quantities()
    for i in range(len(gain)):
        quantities[f"gain.{i + 1}"] = gain[i]
        quantities[f"filter_gain.{i + 1}"] = gain[i]
        quantities[f"predictor_gain.{i + 1}"] = predictor[i]
    quantities |= covariances_in_units("predicted", predicted)
    quantities |= covariances_in_units("updated", updated)
    quantities["innovation_variance"] = (predicted[0][0] + 1) * power(SIGMA, 2)
    return quantities | filter_states(transition, gain, first(len(gain)))


def common_quantities() -> dict[str, Expr]:
    names = (INTERVAL, DEVIATION, "measurement", "first_measurement")
    return {
        **{name: symbol(name) for name in names},
        INDEX: symbol(INDEX),
        "measurement_noise_variance": power(SIGMA, 2),
    }


def base_boxes(size: int) -> dict[str, Box]:
    free = ("measurement", "first_measurement", *[f"previous_state.{i + 1}" for i in range(size)])
    return {INTERVAL: POSITIVE, DEVIATION: POSITIVE, **dict.fromkeys(free, ANY_REAL)}


def covariances_in_units(which: str, matrix: Exprs) -> dict[str, Expr]:
    found = {}
    for i, row in enumerate(matrix):
        for j, entry in enumerate(row):
            scale = power(SIGMA, 2) if i + j == 0 else power(SIGMA, 2) / power(T, i + j)
            name = which if which == "information" else f"{which}_covariance"
            found[f"{name}.{i + 1}.{j + 1}"] = entry / scale if name == which else entry * scale
    return found


def filter_states(transition: Exprs, gain: tuple[Expr, ...], measurement: Exprs) -> dict[str, Expr]:
    """Predicted and updated state from the previous state and the new measurement; T enters with
    its powers.
    """
    size = len(gain)
    before = [symbol(f"previous_state.{i + 1}") for i in range(size)]
    predicted = [_sum(transition[i], before, i) for i in range(size)]
    innovation = symbol("measurement") - _sum(measurement[0], predicted, 0)
    found: dict[str, Expr] = {}
    for i in range(size):
        found[f"previous_state.{i + 1}"] = before[i]
        found[f"predicted_state.{i + 1}"] = predicted[i]
        factor = gain[i] if i == 0 else gain[i] / whole_power(T, i)
        found[f"updated_state.{i + 1}"] = predicted[i] + factor * innovation
    return found


def _sum(row: tuple[Expr, ...], states: list[Expr], i: int) -> Expr:
    """Sum of entry * T^(j - i) * state j; zeros are left out."""
    kept = [
        _times(_times(entry, whole_power(T, j - i)), state)
        for j, (entry, state) in enumerate(zip(row, states, strict=True))
        if entry != number(0)
    ]
    return add(*kept) if kept else number(0)


def _times(a: Expr, b: Expr) -> Expr:
    one = number(1)
    return b if a == one else a if b == one else a * b
