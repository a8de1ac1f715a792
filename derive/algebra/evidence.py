"""Evidence for relations: the numbers from which the checker decides a statement.

A hint of a step may carry: "form" (an expression that shows a sign), "differentiated" (one equal to
the claim's whose derivative shows its sign), "limit_form" (one whose limit can be read off where
that of the claim's own expression cannot; refused where it can), "roots" (the tower value of
each named square root of a kernel graph), "branches" and "gaps", "ends" (the `limits.End` of the
variable's parameter at "0" and "infinity").
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sympy as sp

from gainproof.derive.algebra.derivative import derivative
from gainproof.derive.algebra.limits import end_evidence
from gainproof.derive.algebra.plain_data import fraction_data
from gainproof.derive.algebra.positive_forms import nonnegative_form
from gainproof.derive.algebra.riccati import definite_evidence, riccati_evidence, stable_evidence
from gainproof.derive.algebra.sign_evidence import divisors_shown, shown
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.derivation import Step

Evidence = dict[str, Any]


def evidence(step: Step, tower: Tower) -> Evidence:
    """The evidence of one step's relation in its tower."""
    return _WRITERS[step.relation.kind](step, tower)


def _none(_step: Step, _tower: Tower) -> Evidence:
    return {}


def _equal(step: Step, tower: Tower) -> Evidence:
    parts = step.relation.parts
    wider = tower.with_free(tuple(parts["free"]))
    return {"nonzero": divisors_shown(wider, parts["left"], parts["right"])}


def _positive(step: Step, tower: Tower) -> Evidence:
    expression = step.relation.parts["expression"]
    return {
        "value": shown(tower, step.hint.get("form") or differentiated(tower, expression)),
        "nonzero": divisors_shown(tower, expression),
    }


def _same_sign(step: Step, tower: Tower) -> Evidence:
    parts = step.relation.parts
    left = differentiated(tower, parts["left"])
    return {
        "factor": shown(tower, step.hint.get("form", left / parts["right"])),
        "nonzero": divisors_shown(tower, parts["left"], parts["right"]),
    }


def differentiated(tower: Tower, expression: Any) -> Any:
    """The expression with its derivatives worked out."""

    def value(found: sp.Derivative) -> sp.Expr:
        made = found.expr
        for variable in found.variables:
            made = tower.expression(derivative(tower, made, variable.name))
        return made

    return expression.replace(sp.Derivative, lambda *parts: value(sp.Derivative(*parts)))


def _limit(step: Step, tower: Tower) -> Evidence:
    parts = step.relation.parts
    return {
        **end_evidence(tower, step.hint["ends"][parts["point"]], parts["variable"]),
        "nonzero": divisors_shown(tower, parts["expression"]),
        **_limit_form(step, tower),
    }


def _increasing_onto(step: Step, tower: Tower) -> Evidence:
    parts, ends = step.relation.parts, step.hint["ends"]
    return {
        # at a closed end of the domain the derivative may vanish
        "derivative": fraction_data(nonnegative_form(tower, _slope(step, tower))),
        "start": end_evidence(tower, ends["0"], parts["variable"]),
        "end": end_evidence(tower, ends["infinity"], parts["variable"]),
        "nonzero": divisors_shown(tower, parts["expression"]),
        **_limit_form(step, tower),
    }


def _limit_form(step: Step, tower: Tower) -> Evidence:
    """The expression in a form whose leading terms show their signs, where the hint gives one."""
    if "limit_form" not in step.hint:
        return {}
    return {"form": fraction_data(tower.fraction(step.hint["limit_form"]))}


def _monotone(step: Step, tower: Tower) -> Evidence:
    return {
        "derivative": fraction_data(nonnegative_form(tower, _slope(step, tower))),
        "nonzero": divisors_shown(tower, step.relation.parts["expression"]),
    }


def _slope(step: Step, tower: Tower) -> Any:
    """The derivative of the claim's expression, or its negative where it should decrease."""
    if "form" in step.hint:
        return step.hint["form"]
    parts = step.relation.parts
    expression = step.hint.get("differentiated", parts["expression"])
    slope = derivative(tower, expression, parts["variable"])
    rising = parts.get("trend", "increasing") == "increasing"
    return slope if rising else Fraction(-slope.num, slope.den)


def _program(step: Step, tower: Tower) -> Evidence:
    graph = step.hint["graph"]
    names: Mapping[str, int] = graph.get("names", {})

    def numbered(entry: str, operation: str) -> dict[str, Any]:
        values = step.hint.get(entry, {})
        used = {
            names[name]: value
            for name, value in values.items()
            if name in names and graph["nodes"][names[name]][0] == operation
        }
        return {str(number): used[number] for number in sorted(used)}

    values: dict[int, Any] = {}
    for name, value in step.hint.get("roots", {}).items():
        if name in names:
            values |= dict.fromkeys(_rooted(graph["nodes"], names[name]), value)
    return {
        "roots": {str(key): _root(tower, values[key]) for key in sorted(values)},
        "branches": numbered("branches", "call"),
        "gaps": {key: _root(tower, value) for key, value in numbered("gaps", "call").items()},
        "nonzero": step.hint.get("nonzero", []),
    }


def _rooted(nodes: Sequence[Any], number: int) -> list[int]:
    """The nodes whose root a named node is: itself, or of a fixed point the unknown and the map."""
    node = nodes[number]
    if node[:2] != ["call", "fixed_point"]:
        return [number] if node[0] == "pow" else []
    _, _, unknown, image, value = node
    return [unknown, *_rooted(nodes, image)] if value == image else _rooted(nodes, value)


def _root(tower: Tower, value: Any) -> dict[str, Any]:
    return fraction_data(nonnegative_form(tower, sp.sympify(value)))


_WRITERS: Mapping[str, Callable[[Step, Tower], Evidence]] = {
    "equal": _equal,
    "positive": _positive,
    "same_sign": _same_sign,
    "limit": _limit,
    "increasing_onto": _increasing_onto,
    "monotone": _monotone,
    "riccati": riccati_evidence,
    "stable": stable_evidence,
    "positive_definite": definite_evidence,
    "program": _program,
    "sum": _none,
    "definition": _none,
    "cited": _none,
}
