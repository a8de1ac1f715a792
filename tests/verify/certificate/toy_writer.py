"""Writes small certificates with SymPy: polynomials, fractions, graphs, cofactors.

Test support only, and on purpose independent of the project's own writer of certificates.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

Data = dict[str, Any]


def text(value: Any) -> str:
    """A rational number as text."""
    number = sp.Rational(value)
    return str(number.p) if number.q == 1 else f"{number.p}/{number.q}"


def poly(expression: Any, variables: list[Any]) -> list[Any]:
    """A polynomial in the variables, terms in descending order."""
    if not variables:
        value = sp.Rational(expression)
        return [[text(value), []]] if value else []
    terms = sp.Poly(sp.expand(expression), *variables).terms()
    return [[text(c), list(m)] for m, c in sorted(terms, reverse=True) if c]


def fraction(numerator: Any, denominator: Any, variables: list[Any]) -> Data:
    """numerator / denominator as written, nothing cancelled."""
    return {"num": poly(numerator, variables), "den": poly(denominator, variables)}


class Nodes:
    """Collects the nodes of a graph."""

    def __init__(self) -> None:
        self.nodes: list[list[Any]] = []

    def put(self, *node: Any) -> int:
        """The number of this node, added if it is new."""
        entry = list(node)
        if entry not in self.nodes:
            self.nodes.append(entry)
        return self.nodes.index(entry)

    def add(self, expression: Any) -> int:
        """The number of the node of a SymPy expression."""
        expression = sp.sympify(expression)
        if isinstance(expression, sp.MatrixBase):
            return self.put("matrix", *expression.shape, *map(self.add, list(expression)))
        if expression.is_Rational:
            return self.put("number", text(expression))
        if expression.is_Symbol:
            return self.put("symbol", expression.name)
        if expression.is_Pow:
            return self.put("pow", self.add(expression.base), text(expression.exp))
        if isinstance(expression, sp.Derivative):
            return self.put("derivative", self.add(expression.expr), expression.variables[0].name)
        if isinstance(expression, sp.Subs):
            return self.put(
                "at",
                self.add(expression.expr),
                expression.variables[0].name,
                self.add(expression.point[0]),
            )
        name = {sp.Add: "add", sp.Mul: "mul"}[expression.func]
        return self.put(name, *map(self.add, expression.args))


def graph(expression: Any) -> Data:
    """The graph of one expression."""
    nodes = Nodes()
    return {"outputs": {"value": nodes.add(expression)}, "nodes": nodes.nodes}


def cofactors(residual: Any, relation: Any, generator: Any, variables: list[Any]) -> list[Any]:
    """The quotient of a residual by the relation of the only generator."""
    quotient, rest = sp.div(sp.expand(residual), relation, generator)
    assert sp.expand(rest) == 0
    return [poly(quotient, variables)]


def riccati_evidence(
    model: Data,
    below: Any,
    above: Any,
    noise: Any,
    relation: Any,
    variables: list[Any],
) -> Data:
    """The evidence of a riccati statement over a tower with one generator (the last variable)."""
    transition, process, measurement, measured = (
        sp.Matrix([[sp.Rational(x) for x in row] for row in model[field]])
        for field in ("transition", "process_noise", "measurement", "measurement_noise")
    )
    column = above * measurement.T
    variance = (measurement * column)[0] + measured[0] * below
    residual = variance * (transition * above * transition.T - above + below * noise * process)
    residual = residual - transition * column * column.T * transition.T
    size = transition.shape[0]
    return {
        "denominator": poly(below, variables),
        "numerators": [[poly(above[i, j], variables) for j in range(size)] for i in range(size)],
        "cofactors": {
            f"{i + 1},{j + 1}": cofactors(residual[i, j], relation, variables[-1], variables)
            for i in range(size)
            for j in range(i, size)
        },
    }


def statement(identifier: str, kind: str, claim: Data, evidence: Data, tower: str = "main") -> Data:
    """One statement."""
    return {"id": identifier, "kind": kind, "tower": tower, "claim": claim, "evidence": evidence}


def expectations(certificate: Data) -> Data:
    """What a caller who wants exactly this certificate's claims would expect."""
    return {
        "claims": [
            {key: s[key] for key in ("id", "kind", "tower", "claim")}
            for s in certificate["statements"]
        ],
        "domain": {name: tower["parameters"] for name, tower in certificate["towers"].items()},
        "programs": certificate["programs"],
    }
