"""Kernels' expression graphs against what they are said to compute."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.expression_graph import read_graph, read_values
from gainproof.verify.judge.exact.graph_matrices import Grid
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.verdict import Finding, finding_of
from judged_derivations.fixed_point import with_known_roots, without_fixed_points
from judged_derivations.surroundings import Surroundings


def judge_program(
    where: Surroundings, claim: Mapping[str, Any], programs: Mapping[str, Any]
) -> Finding:
    """Whether every claimed output, and every claimed node, of a kernel's graph equals its formula.

    Raises Undecided, Malformed.
    """
    program = programs.get(claim["program"])
    if program is None:
        raise Undecided(f"the program {claim['program']} was not given")
    inputs = {name: _input(where, value) for name, value in program["inputs"].items()}
    outputs = read_values(program["graph"])
    nodes = _nodes(program["graph"], claim.get("nodes", {}))
    found = [(outputs.get(name), name, formula) for name, formula in claim["outputs"].items()]
    finding: Finding | None = None
    for made, name, formula in [*found, *nodes]:
        if not isinstance(made, Expr):
            raise Malformed(f"the program has no output {name}")
        computed = with_known_roots(where, substituted(made, inputs))
        computed = without_branches(where, without_fixed_points(where, computed))
        wanted, needed = where.resolved(read_graph(formula))
        statement = Statement((Rel("=", computed, wanted),), needed=tuple(needed))
        finding = finding_of(settle(statement, where.boxes, where.parameter, {}))
        if finding.verdict != "proved":
            return finding
    if finding is None:
        raise Undecided("a program without outputs")
    return finding


def _nodes(
    graph: Mapping[str, Any], claimed: Mapping[str, Any]
) -> list[tuple[Expr | Grid, str, Any]]:
    """What the claimed nodes compute, with their numbers and formulas."""
    if not claimed:
        return []
    if not all(number.isdecimal() for number in claimed):
        raise Malformed("nodes are claimed by their numbers")
    values = read_values({**graph, "outputs": {number: int(number) for number in claimed}})
    return [(values[number], number, formula) for number, formula in claimed.items()]


def _input(where: Surroundings, value: Any) -> Expr:
    return where.value(value) if isinstance(value, str) else where.resolved(read_graph(value))[0]


def without_branches(where: Surroundings, expr: Expr) -> Expr:
    """select(a, b, x, y) replaced by its branch, which must be the same everywhere."""
    done: dict[bytes, Expr] = {}
    for node in walk(expr):
        parts = tuple(done[p.key] for p in node.parts)
        if node.kind == "call":
            if node.name != "select" or len(parts) != 4:
                raise Undecided(f"the function {node.name} is not covered")
            done[node.key] = parts[2] if _less(where, parts[0], parts[1]) else parts[3]
        else:
            done[node.key] = Expr(node.kind, node.value, parts)
    return done[expr.key]


def _less(where: Surroundings, a: Expr, b: Expr) -> bool:
    for operator in ("<", ">="):
        outcome = settle(Statement((Rel(operator, a, b),)), where.boxes, where.parameter, {})
        if outcome.verdict == "proved":
            return operator == "<"
    raise Undecided("a branch of the program depends on the parameter")
