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
from gainproof.verify.judge.exact.statement import Rel, Statement
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
from gainproof.verify.judge.setting.growing_memory import first, growing_memory, taylor
from gainproof.verify.judge.setting.matrices import (
    Exprs,
    exprs,
    minus,
    model_matrices,
    times,
    transposed,
)
from gainproof.verify.judge.setting.steady_state import SteadyState, solve
from gainproof.verify.judge.setting.steady_state_conditions import characteristic

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


def model_data(
    environment: Environment, meanings: Mapping[str, Expr], named: Mapping[str, str]
) -> dict[str, Any]:
    """The matrices of a filter as graphs, and what symbols of the source stand for in terms of gain
    K, covariances P and X, innovation variance S and lag L; empty without a model. `named` are the
    quantities that symbols are.
    """
    if not environment.model:
        return {}
    known = _of_matrices(environment)
    letters = {
        token: rebuilt(expr, lambda node, _: known.get(node.key))
        for token, expr in meanings.items()
    }
    model = {name: rows for name, rows in environment.model.items() if name != "units"}
    if "L" in model:
        lags = {
            t: name.split(".")[1:] for t, name in named.items() if name.startswith("predicted_lag")
        }
        orders = {order for _, order in lags.values()}
        if orders != {str(len(model["L"]))}:
            # beside no motion, or one that the states follow, there is no lag
            model |= dict.fromkeys("LD", ((number(0),),) * len(model["L"]))
        if len(orders) == 1 and int(min(orders)) <= len(model["L"]):
            letters |= {token: symbol(f"L[{i},1]") for token, (i, _) in lags.items()}
    if all(letters[token] == expr for token, expr in meanings.items()):
        return {}
    entries = [entry for rows in model.values() for row in rows for entry in row]
    names = symbols_of(*entries)
    boxes = {n: ANY_REAL for n in names if n.startswith("filter_gain.")}
    boxes |= {n: POSITIVE for n in names if Rel(">", symbol(n), number(0)) in environment.rests}
    boxes |= {n: box for n, box in environment.boxes.items() if n in names}
    return {
        "model": {
            name: [[graph_of(entry) for entry in row] for row in rows]
            for name, rows in model.items()
        },
        "domain of the model": statement_data(Statement(()), boxes, None, {})["domain"],
        "letters": {token: graph_of(expr) for token, expr in letters.items()},
    }


def _of_matrices(environment: Environment) -> dict[bytes, Expr]:
    """Entries of K, P, X and S for the quantities that they are, by the keys of these."""
    quantities, model = environment.quantities, environment.model
    (units,) = model["units"]
    size = range(len(units))
    columns = [symbol(f"K[{i + 1},1]") for i in size]
    gains = [
        mul(k, unit) if i else k for i, (k, unit) in enumerate(zip(columns, units, strict=True))
    ]
    entries = {f"filter_gain.{i + 1}": gain for i, gain in enumerate(gains)}
    if "A" in model:
        entries = {f"continuous_gain.{i + 1}": gain for i, gain in enumerate(gains)}
    elif "R" in model:
        entries["innovation_variance"] = symbol("S[1,1]")
    if "F" in model:
        f, h = (tuple(map(tuple, model[name])) for name in "FH")
        for i, unit in enumerate(units):
            moved = add(*(mul(e, k) for e, k in zip(f[i], columns, strict=True)), number(0))
            entries[f"predictor_gain.{i + 1}"] = mul(moved, unit)
    covariances = {"predicted_covariance": "P", "updated_covariance": "X", "covariance": "P"}
    if "n" in model:
        del covariances["predicted_covariance"]  # of another sample than the matrices
    for which, name in covariances.items():
        places = [(i + 1, j + 1) for i in size for j in size]
        entries |= {f"{which}.{i}.{j}": symbol(f"{name}[{i},{j}]") for i, j in places}
    if "F" in model and len(h) == 1:
        kept = minus(exprs(taylor(len(size), 0)), times(tuple((k,) for k in columns), h))
        for j, value in enumerate(characteristic(times(f, kept))):
            entries[f"closed_loop_coefficient.{j}"] = value
    found: dict[bytes, Expr] = {}
    for name, entry in entries.items():
        if name in quantities and quantities[name].kind != "number":
            found.setdefault(quantities[name].key, entry)
    return found


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
    sums = {"N": fit.information, "V": fit.updated}
    model = _fitted_model(fit.transition, sums, n=symbol(SAMPLE))
    return Environment(name, quantities, boxes, SAMPLE, fit.facts, missing, continued, model=model)


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
    sums = {"N": fit.information, "V": fit.inverse, "Z": fit.squared}
    model = _fitted_model(fit.transition, sums, w=symbol(WEIGHT))
    return Environment(name, quantities, boxes, WEIGHT, fit.facts, missing, model=model)


def _fitted_model(
    transition: Exprs, sums: Mapping[str, Exprs], **parameter: Expr
) -> dict[str, Exprs]:
    """Sums of squares N (with the weight squared Z) and the inverse V of N in the source's units,
    the variance r of a sample, and the parameter; `units` of the gains.
    """
    states = range(len(transition))

    def scaled(rows: Exprs, sign: int) -> Exprs:
        return tuple(
            tuple(_times(rows[i][j], whole_power(T, sign * (i + j))) for j in states)
            for i in states
        )

    return {
        "F": tuple(
            tuple(
                _times(transition[i][j], whole_power(T, j - i)) if j >= i else number(0)
                for j in states
            )
            for i in states
        ),
        "H": first(len(transition)),
        **{name: scaled(rows, -1 if name == "V" else 1) for name, rows in sums.items()},
        "r": ((power(SIGMA, 2),),),
        **{name: ((value,),) for name, value in parameter.items()},
        "units": (tuple(whole_power(T, i) for i in states),),
    }


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
