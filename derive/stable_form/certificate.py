"""The certificate that a graph has the value that was given: data for the checker of certificates.

Both graphs are programs, and each is claimed to have the value of one and the same element of a
tower, on the whole domain. A root is the positive one, and every divisor is shown to have a sign.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from gainproof.derive.algebra.plain import fraction_data, tower_data
from gainproof.derive.algebra.tower import Fraction, Tower
from gainproof.derive.expression import real
from gainproof.derive.printer.graph import Graph, operands
from gainproof.derive.stable_form.reading import Reading
from gainproof.derive.stable_form.shown import Shown, expanded, needed
from gainproof.derive.subject import FORMAT

Data = dict[str, Any]
GIVEN, STABLE = "given", "stable"


def document(name: str, graphs: Mapping[str, Graph], proofs: Mapping[str, Data]) -> Data:
    """The certificate of all outputs; `graphs`: the given and the stable one, `proofs` by output.

    Each of the proofs is made by `proof`.
    """
    inputs = {
        key: {str(node[1]): str(node[1]) for node in graph["nodes"] if node[0] == "symbol"}
        for key, graph in graphs.items()
    }
    return {
        "format": FORMAT,
        "subject": name,
        "towers": {output: each["tower"] for output, each in proofs.items()},
        "programs": {
            key: {
                "inputs": inputs[key],
                "graph": {"nodes": graph["nodes"], "outputs": graph["outputs"]},
            }
            for key, graph in graphs.items()
        },
        "statements": [
            {**claim, "evidence": evidence}
            for output, each in proofs.items()
            for claim, evidence in zip(claims([output]), each["evidence"], strict=True)
        ],
    }


def claims(outputs: Sequence[str]) -> list[Data]:
    """What a certificate has to prove: each output of both programs is the element of its name."""
    value = {"nodes": [["symbol", "value"]], "outputs": {"value": 0}}
    return [
        {
            "id": f"{output}_{program}",
            "kind": "program",
            "tower": output,
            "claim": {"program": program, "outputs": {output: value}},
        }
        for output in outputs
        for program in (GIVEN, STABLE)
    ]


def proof(output: str, reading: Reading, value: sp.Expr, graphs: Mapping[str, Graph]) -> Data:
    """The tower of one output, and for both graphs the roots and divisors shown.

    NotShown if a divisor or a root has no sign that was found.
    """
    roots = {key: _roots(graph, output, reading) for key, graph in graphs.items()}
    tower = reading.tower
    data = tower_data(tower)
    data["elements"]["value"] = fraction_data(expanded(tower, reading.product(value), above=True))
    return {
        "tower": data,
        "evidence": [
            _evidence(
                tower, graphs[key], output, {n: _positive(reading, e) for n, e in found.items()}
            )
            for key, found in roots.items()
        ],
    }


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
