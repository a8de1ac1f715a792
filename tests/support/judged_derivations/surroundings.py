"""What the symbols of a derivation's relations mean to the judge: its own solution, never the
derivation's.

A tower of the derivation gives names only: its parameter, roots as abbreviations, and the tracking
index in terms of the parameter. Gains, covariances and poles are those of the judge's own steady
state or fit.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.book.exercises.tower_values import add_roots, element_of
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, rebuilt, substituted
from gainproof.verify.judge.exact.decision import decide
from gainproof.verify.judge.exact.expression import (
    Expr,
    number,
    power,
    sqrt,
    symbol,
    symbols_of,
)
from gainproof.verify.judge.exact.expression_graph import rational
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import (
    DEVIATION,
    INDEX,
    INTERVAL,
    SAMPLE,
    Environment,
    algebra,
)
from gainproof.verify.judge.setting.quantities import memory, steady_state
from judged_derivations.third_state import in_tower

QUANTITIES: Mapping[str, str] = {
    "alpha": "filter_gain.1",
    "beta": "filter_gain.2",
    "gamma": "filter_gain.3",
    "predictor_position": "predictor_gain.1",
    "predictor_velocity": "predictor_gain.2",
    "innovation_variance": "innovation_variance",
    **{
        f"{which}_{i}{j}": f"{which}_covariance.{i}.{j}"
        for which in ("predicted", "updated")
        for i in (1, 2, 3)
        for j in (1, 2, 3)
    },
    **{f"information_{i}{j}": f"information.{i}.{j}" for i in (1, 2, 3) for j in (1, 2, 3)},
}
"""Names in derivations -> quantities of the judge."""
ABBREVIATIONS = (
    *("kappa", "rho", "psi", "chi"),
    *("xi", "eta", "delta", "nu", "tau", "w", "omega", "mu"),
    *("level", "t", "a", "g", "real_pole", "modulus", "half_sum", "quarter_discriminant"),
)
"""Names that derivations give to parts of formulas: no quantities, so each is as defined."""


@dataclass(frozen=True)
class Surroundings:
    """`values`: symbol -> expression of the parameter; `boxes`: domains."""

    values: Mapping[str, Expr]
    boxes: Mapping[str, Box]
    parameter: str | None
    index: Expr | None

    def resolved(self, expr: Expr, free: Sequence[str] = ()) -> tuple[Expr, list[Expr]]:
        """The expression in base variables, and what was differentiated in it. Raises Undecided."""
        needed: list[Expr] = []

        def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
            match node.kind:
                case "symbol":
                    return (
                        symbol(free_name(node.name)) if node.name in free else self.value(node.name)
                    )
                case "derivative":
                    needed.append(parts[0])
                    return self._derivative(parts[0], node.name)
                case "at":
                    target = self.value(node.name)
                    if target.kind != "symbol":
                        raise Undecided(f"substitution for {node.name}, which is no variable")
                    return substituted(parts[0], {target.name: parts[1]})
                case _:
                    return None

        return rebuilt(expr, change), needed

    def value(self, name: str) -> Expr:
        """What a symbol stands for. Raises Undecided."""
        if name not in self.values:
            raise Undecided(f"the symbol {name} has no meaning for the judge")
        return self.values[name]

    def _derivative(self, expr: Expr, name: str) -> Expr:
        target = self.value(name)
        if self.parameter is None or symbols_of(target) != {self.parameter}:
            raise Undecided(f"a derivative with respect to {name}")
        top = differentiated(expr, self.parameter)
        if target.kind == "symbol":
            return top
        return top / differentiated(target, self.parameter)


def surroundings(
    model: Mapping[str, Any] | None = None,
    degree: int | None = None,
    tower: Mapping[str, Any] | None = None,
    environment: Environment | None = None,
) -> Surroundings:
    """The surroundings of relations about a model, a fit of that degree, or neither.

    `tower` is a tower of a certificate; without it the parameter is the tracking index or the
    sample number. Raises Undecided, Malformed, NotEstablished.
    """
    if environment is None:
        environment = steady_state(model) if model is not None else algebra()
        if degree is not None:
            environment = memory(degree)
    base = environment.parameter
    name, box = _parameter(tower, environment)
    values: dict[str, Expr] = {} if name is None else {name: symbol(name)}
    add_roots(values, tower)
    for short in ABBREVIATIONS:
        if tower is not None and short in tower.get("elements", {}):
            values[short] = element_of(tower, short, values)
    boxes = {} if name is None or box is None else {name: box}
    index = None if base in (None, SAMPLE) else _index(values, tower, environment)
    put_in: dict[str, Expr] = {INTERVAL: number(1), DEVIATION: number(1)}
    if base == INDEX and index is not None:
        put_in[INDEX] = index
    if base == SAMPLE and name is not None:
        put_in[SAMPLE] = symbol(name)
    known = {**environment.quantities, **environment.continued}
    if index is not None:
        values[INDEX] = index
        if name is not None:
            _check_index(index, name, boxes)
        if base != INDEX:
            gains = ("alpha", "beta", "gamma") if tower is not None else ()
            told = {g: element_of(tower or {}, g, values) for g in gains} | values
            known = in_tower(known, base or "", told, name, boxes)
    for short, long in QUANTITIES.items():
        if long in known:
            values[short] = substituted(known[long], put_in)
    _add_derived(values, known, put_in)
    return Surroundings(values, boxes, name, index)


def _parameter(
    tower: Mapping[str, Any] | None, environment: Environment
) -> tuple[str | None, Box | None]:
    if tower is None:
        base = environment.parameter
        return base, None if base is None else environment.boxes[base]
    parameters = tower.get("parameters", [])
    if not parameters:
        return None, None
    if len(parameters) != 1:
        raise Undecided("a tower with several parameters")
    entry = parameters[0]
    if "above" in entry:
        return entry["symbol"], Box(lower=rational(entry["above"]))
    whole = environment.parameter == SAMPLE
    return entry["symbol"], Box(lower=rational(entry["from"]), lower_open=False, integer=whole)


def _index(
    values: Mapping[str, Expr], tower: Mapping[str, Any] | None, environment: Environment
) -> Expr:
    if tower is None:
        return environment.quantities[INDEX]
    if INDEX in values:
        return symbol(INDEX)
    return element_of(tower, INDEX, values)


def _check_index(index: Expr, name: str, boxes: Mapping[str, Box]) -> None:
    """The steady state is established for positive indices only."""
    outcome = decide(Statement((Rel(">", index, number(0)),)), boxes, name)
    if outcome.verdict != "proved":
        raise Undecided(f"the tracking index is not positive for every {name}")


def _add_derived(
    values: dict[str, Expr], known: Mapping[str, Expr], put_in: Mapping[str, Expr]
) -> None:
    """Quantities that are named after others: deviation of the innovation, poles, 1 - alpha."""
    if "alpha" in values:
        values["rest"] = 1 - values["alpha"]
    if "innovation_variance" in values:
        values["innovation_deviation"] = sqrt(values["innovation_variance"])
    two = "filter_gain.2" in known and "filter_gain.3" not in known
    if two and "closed_loop.trace" in known:
        trace = substituted(known["closed_loop.trace"], put_in)
        product = substituted(known["closed_loop.determinant"], put_in)
        half, spread = trace / 2, power(trace, 2) - 4 * product
        values["pole_real"] = half
        values["pole_imaginary"] = sqrt(-spread) / 2
        values["first_pole"] = half - sqrt(spread) / 2
        values["second_pole"] = half + sqrt(spread) / 2
