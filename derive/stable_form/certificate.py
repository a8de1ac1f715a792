"""The certificate that a graph has the value that was given: data for the checker of certificates.

Both graphs are programs, and each is claimed to have the value of one and the same element of a
tower, on the whole domain. A root is the positive one, and every divisor is shown to have a sign.
Functions of a library are symbols here (see `function_atoms`); their arguments have proofs of their
own. So has whatever else must be positive for a rule to hold, and for what was given to be a real
number.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.algebra.plain_data import fraction_data, tower_data
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph, operands
from gainproof.derive.stable_form.program_values import Shown, expanded, needed
from gainproof.derive.stable_form.root_tower import Reading
from gainproof.derive.subject import FORMAT

Data = dict[str, Any]
GIVEN, STABLE = "given", "stable"


@dataclass(frozen=True)
class Proof:
    """One value as it was given and, where it is printed, as it is written: `graphs` by `GIVEN` and
    `STABLE`, with one output of the name.

    `positive`: what it is needed for, if it has to be positive.
    """

    name: str
    graphs: Mapping[str, Graph]
    reading: Reading
    value: sp.Expr
    positive: str = ""


def document(proofs: Sequence[Proof]) -> Data:
    """The certificate of all; NotShown if a divisor or a root has no sign that was found."""
    towers: dict[str, Data] = {}
    evidence: list[Data] = []
    for each in proofs:
        towers[each.name], found = _proved(each)
        evidence += found
    return {
        "format": FORMAT,
        "subject": "stable form",
        "towers": towers,
        "programs": {
            f"{key}_{each.name}": _program(graph)
            for each in proofs
            for key, graph in each.graphs.items()
        },
        "statements": [
            {**claim, "evidence": found}
            for claim, found in zip(claims(proofs), evidence, strict=True)
        ],
    }


def claims(proofs: Sequence[Proof]) -> list[Data]:
    """What a certificate has to prove: its programs are the element "value" of their tower."""
    value = {"nodes": [["symbol", "value"]], "outputs": {"value": 0}}
    found: list[Data] = []
    for each in proofs:
        for key in each.graphs:
            program = f"{key}_{each.name}"
            claim = {"program": program, "outputs": {each.name: value}}
            found.append({"id": program, "kind": "program", "tower": each.name, "claim": claim})
        if each.positive:
            positive = {"id": f"positive_{each.name}", "kind": "positive", "tower": each.name}
            found.append({**positive, "claim": {"expression": value}})
    return found


def _program(graph: Graph) -> Data:
    symbols = (str(node[1]) for node in graph["nodes"] if node[0] == "symbol")
    return {
        "inputs": {symbol: symbol for symbol in symbols},
        "graph": {"nodes": graph["nodes"], "outputs": graph["outputs"]},
    }


def _proved(each: Proof) -> tuple[Data, list[Data]]:
    """The tower, and for each graph the roots and divisors shown."""
    reading, graphs = each.reading, each.graphs.values()
    roots = [_roots(graph, each.name, reading) for graph in graphs]
    tower = reading.tower
    value = fraction_data(expanded(tower, reading.product(each.value), above=True))
    data = tower_data(tower)
    data["elements"]["value"] = value
    evidence = [
        _evidence(
            tower, graph, each.name, {n: _positive(reading, root) for n, root in found.items()}
        )
        for graph, found in zip(graphs, roots, strict=True)
    ]
    if each.positive:
        evidence.append({"value": value, "nonzero": []})
    return data, evidence


def _positive(reading: Reading, value: sp.Expr) -> Fraction:
    return expanded(reading.tower, reading.product(value))


def _evidence(tower: Tower, graph: Graph, output: str, roots: Mapping[int, Fraction]) -> Data:
    shown = Shown(tower, graph, roots)
    shown.output(output)
    return {
        "roots": {str(number): fraction_data(root) for number, root in roots.items()},
        "branches": {},
        "gaps": {},
        "nonzero": [fraction_data(each) for each in shown.nonzero],
    }


def _roots(graph: Graph, output: str, reading: Reading) -> dict[int, sp.Expr]:
    """The square roots that an output needs, in variables of the tower, which grows with them."""
    values: dict[int, sp.Expr] = {}
    found: dict[int, sp.Expr] = {}
    for number in needed(graph, graph["outputs"][output]):
        node = graph["nodes"][number]
        parts = [values[part] for part in operands(node)]
        match node[0]:
            case "number":
                values[number] = sp.Rational(node[1])
            case "symbol":
                values[number] = real(str(node[1]))
            case "add":
                values[number] = sp.Add(*parts)
            case "mul":
                values[number] = sp.Mul(*parts)
            case "div":
                values[number] = parts[0] / parts[1]
            case "neg":
                values[number] = -parts[0]
            case _:
                power = sp.Rational(node[2])
                values[number] = parts[0] ** power
                if power.q == 2:
                    found[number] = reading.root(parts[0])
                    values[number] = found[number] ** power.p
    return found
