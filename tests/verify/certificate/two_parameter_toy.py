"""A steady state with two parameters and two measurements of one state, small enough to be known.

A random walk of variance L^2 a step is measured twice, with variances 1 and S^2. With the
information i = 1 + 1/S^2 its updated variance solves U^2 + L^2 U = L^2/i, so that U = L (w - L)/2
and M = L (w + L)/2 with w^2 = L^2 + 4/i. Written by the project's own writer.
"""

from __future__ import annotations

import json
from typing import Any

import sympy as sp

from gainproof.derive.algebra.evidence import evidence
from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.plain_data import tower_data
from gainproof.derive.algebra.tower import Generator, Parameter, Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import graph_of, real
from gainproof.derive.relation import Relation, equal, increasing_onto, limit, monotone, positive

Data = dict[str, Any]

L, S, C, Y = (real(name) for name in ("tracking_index", "ratio", "c", "y"))
U, M = real("updated"), real("predicted")

MODEL: Data = {
    "name": "walk",
    "title": "A random walk measured twice",
    "transition": [["1"]],
    "process_noise": [["1"]],
    "measurement": [["1"], ["1"]],
    "measurement_noise": [["1", "0"], ["0", graph_of(S**2)]],
}
PLAIN = 2 * L * S**2 / (C * (Y + L * C))
"""The updated variance without a subtraction."""


def tower() -> Tower:
    """c = sqrt(1 + S^2), y = sqrt(L^2 (1 + S^2) + 4 S^2), so that w = y/c."""
    return Tower(
        "main",
        (Parameter("tracking_index"), Parameter("ratio")),
        (Generator("c", 1 + S**2), Generator("y", L**2 * (1 + S**2) + 4 * S**2)),
        {
            "updated": L * (Y - L * C) / (2 * C),
            "predicted": L * (Y + L * C) / (2 * C),
            "first_gain": U,
            "second_gain": U / S**2,
            "noise": L**2,
            "variance": S**2,
            "product": L * S,
        },
    )


_C, _Y, _H = real("root_c"), real("root_y"), real("root_h")
ENDS = {
    ("tracking_index", "0"): End({}, {"root_c": 1 + S**2}, {"c": _C, "y": 2 * S}),
    ("tracking_index", "infinity"): End({"y": 1}, {"root_c": 1 + S**2}, {"c": _C, "y": _C}),
    ("ratio", "0"): End({}, {}, {"c": sp.Integer(1), "y": L}),
    ("ratio", "infinity"): End(
        {"c": 1, "y": 1}, {"root_h": L**2 + 4}, {"c": sp.Integer(1), "y": _H}
    ),
}


def tends(
    identifier: str, expression: Any, variable: str, point: str, value: Any, **hint: Any
) -> Step:
    """The step that states a limit, with the behaviour of the tower there."""
    end = ENDS["ratio" if variable in ("ratio", "variance") else "tracking_index", point]
    relation = limit(expression, point, value, variable=variable)
    return Step(identifier, "", relation, "", hint={"ends": {point: end}, **hint})


KERNEL: Data = {
    "nodes": [
        ["symbol", "index"],
        ["symbol", "deviation"],
        ["number", "1"],
        ["mul", 1, 1],
        ["add", 2, 3],
        ["pow", 4, "1/2"],
        ["number", "4"],
        ["mul", 0, 0],
        ["mul", 7, 4],
        ["mul", 6, 3],
        ["add", 8, 9],
        ["pow", 10, "1/2"],
        ["div", 11, 5],
        ["add", 12, 0],
        ["mul", 0, 13],
        ["number", "2"],
        ["div", 14, 15],
    ],
    "outputs": {"predicted": 16},
    "names": {"c": 5, "y": 11},
}


def steps() -> list[Step]:
    """Every kind of statement that two parameters touch."""
    ends = {point: ENDS["tracking_index", point] for point in ("0", "infinity")}
    gain = [["first_gain", "second_gain"]]
    return [
        Step(
            "steady",
            "",
            Relation(
                "riccati",
                {
                    "model": MODEL,
                    "predicted": [["predicted"]],
                    "updated": [["updated"]],
                    "gain": gain,
                    "index": "tracking_index",
                },
            ),
            "",
        ),
        Step(
            "loop",
            "",
            Relation("stable", {"model": MODEL, "gain": gain}),
            "",
            hint={"coefficients": [-PLAIN / M], "values": [1 + PLAIN / M, L**2 / M]},
        ),
        Step("form", "", equal(U, PLAIN), ""),
        Step("sign", "", positive(U), "", hint={"form": PLAIN}),
        Step("walked", "", equal(M - U, sp.Pow(real("noise"), 1)), ""),
        Step("by_ratio", "", equal(sp.Derivative(U, S), 2 * L * S / (C**3 * Y)), ""),
        Step("by_variance", "", equal(sp.Derivative(M, real("variance")), L / (C**3 * Y)), ""),
        tends("small_index", PLAIN / (L * S), "tracking_index", "0", 1 / sp.sqrt(1 + S**2)),
        tends("small_ratio", PLAIN / (L * S), "ratio", "0", sp.Integer(0)),
        tends("large_noise", U, "noise", "infinity", S**2 / (1 + S**2), limit_form=PLAIN),
        tends("bad_second", M, "ratio", "infinity", (L * sp.sqrt(L**2 + 4) + L**2) / 2),
        tends("bad_variance", C, "variance", "infinity", "infinity"),
        Step(
            "range",
            "",
            increasing_onto(U, sp.Integer(0), S**2 / (1 + S**2)),
            "",
            hint={"ends": ends, "limit_form": PLAIN, "differentiated": PLAIN},
        ),
        Step("grows", "", monotone(M, "increasing", "ratio"), ""),
        Step(
            "falls",
            "",
            monotone(real("second_gain"), "decreasing", "variance"),
            "",
            hint={"differentiated": PLAIN / S**2},
        ),
        Step(
            "kernel",
            "",
            Relation("program", {"program": "predicted", "outputs": {"predicted": M}}),
            "",
            hint={"graph": KERNEL, "roots": {"c": C, "y": Y}},
        ),
    ]


def certificate(chosen: list[Step] | None = None) -> Data:
    """The certificate of the chosen steps, or of all."""
    main = tower()
    listed = steps() if chosen is None else chosen
    statements = [
        {
            "id": step.id,
            "kind": step.relation.kind,
            "tower": "main",
            "claim": step.relation.claim(),
            "evidence": evidence(step, main),
        }
        for step in listed
    ]
    data = tower_data(main)
    named = json.dumps([entry["claim"] for entry in statements])
    data["elements"] = {
        name: value for name, value in data["elements"].items() if f'"{name}"' in named
    }
    programs = {
        "predicted": {
            "inputs": {"index": "tracking_index", "deviation": "ratio"},
            "graph": {key: KERNEL[key] for key in ("nodes", "outputs")},
        }
    }
    plain: Data = json.loads(
        json.dumps(
            {
                "format": "gainproof certificate 1",
                "subject": "walk",
                "towers": {"main": data},
                "programs": programs if '"program"' in named else {},
                "statements": statements,
            }
        )
    )
    return plain
