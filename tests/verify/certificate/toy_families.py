"""Two toy certificates written by hand: random acceleration, and the line through all samples."""

from __future__ import annotations

from typing import Any

import sympy as sp
from tests.verify.certificate.toy_writer import (
    Data,
    fraction,
    graph,
    poly,
    riccati_evidence,
    statement,
)

p, s = sp.symbols("p s")
P = [p, s]
RELATION = s**2 - (p**2 + 8) / 4
SIGMA = (p**2 + 4 + 2 * p * s) / 4

MODEL: Data = {
    "name": "random-acceleration",
    "title": "Acceleration constant over each interval",
    "transition": [["1", "1"], ["0", "1"]],
    "process_noise": [["1/4", "1/2"], ["1/2", "1"]],
    "measurement": [["1", "0"]],
    "measurement_noise": [["1"]],
}

alpha, beta, sigma, index, g, k, j, f, z = sp.symbols("alpha beta sigma tracking_index g k j f z")


def _elements() -> Data:
    values: dict[str, tuple[Any, Any]] = {
        "tracking_index": (p**2, 1),
        "sigma": (SIGMA, 1),
        "alpha": (p * s, SIGMA),
        "beta": (p**2, SIGMA),
        "m11": (p * s * SIGMA, 1),
        "m12": (p**2 * SIGMA, 1),
        "m22": (p**3 * (2 * s + p) / 2, 1),
        "x22": (4 * p**3, 2 * s + p),
    }
    return {name: fraction(*value, P) for name, value in values.items()}


def _limit(name: str, expression: Any, point: str, value: Any, **evidence: Any) -> Data:
    empty: Data = {"weights": {"s": 0}, "constants": [], "boundary": {"s": []}, "nonzero": []}
    stated = value if value == "infinity" else graph(value)
    return statement(
        name,
        "limit",
        {
            "expression": graph(expression),
            "variable": "tracking_index",
            "point": point,
            "value": stated,
        },
        {**empty, **evidence},
    )


AT_ZERO: Data = {
    "weights": {"s": 0},
    "constants": [{"symbol": "c", "power": 2, "radicand": [["2", [0]]]}],
    "boundary": {"s": [["1", [1]]]},
}
AT_INFINITY: Data = {"weights": {"s": 1}, "constants": [], "boundary": {"s": [["1/2", []]]}}


def _kernel() -> Data:
    nodes = [
        ["symbol", "tracking_index"],
        ["pow", 0, "1/2"],
        ["number", "4"],
        ["div", 2, 1],
        ["number", "2"],
        ["mul", 4, 3],
        ["add", 1, 5],
        ["mul", 1, 6],
        ["pow", 7, "1/2"],
        ["div", 8, 4],
        ["add", 1, 3],
        ["div", 10, 4],
        ["add", 11, 9],
        ["mul", 4, 9],
        ["div", 13, 12],
        ["mul", 4, 1],
        ["div", 15, 12],
    ]
    return {
        "inputs": {"tracking_index": "tracking_index"},
        "graph": {"nodes": nodes, "outputs": {"alpha": 14, "beta": 16}},
    }


def random_acceleration() -> Data:
    """Every kind of statement but "sum", over p > 0 and s = sqrt((p^2 + 8)/4)."""
    above = sp.Matrix([[p * s * SIGMA, p**2 * SIGMA], [p**2 * SIGMA, p**3 * (2 * s + p) / 2]])
    matrix = sp.Matrix([[alpha, beta], [beta, sp.Symbol("x22")]])
    quadratic = z**2 - (2 - alpha - beta) * z + 1 - alpha
    statements = [
        statement("index", "definition", {"left": graph(p), "right": graph(sp.sqrt(index))}, {}),
        statement(
            "root", "definition", {"left": graph(s), "right": graph(sp.sqrt((p**2 + 8) / 4))}, {}
        ),
        statement(
            "sigma",
            "definition",
            {"left": graph(sigma), "right": graph((index + 4 + 2 * p * s) / 4)},
            {},
        ),
        statement("units", "definition", {"text": "T = R = 1"}, {}),
        statement(
            "relation",
            "equal",
            {
                "left": graph(4 * alpha**2 + 4 * alpha * beta + beta**2),
                "right": graph(8 * beta),
                "free": [],
            },
            {"nonzero": []},
        ),
        statement(
            "quotient",
            "equal",
            {"left": graph(1 / (1 - alpha)), "right": graph(sigma**2), "free": []},
            {"nonzero": [fraction(1, SIGMA**2, P)]},
        ),
        statement(
            "free",
            "equal",
            {
                "left": graph(quadratic / (z - 1 + alpha / 2)),
                "right": graph(
                    sp.Add(z**2, -(2 - alpha - beta) * z, 1 - alpha, evaluate=False)
                    / (z - 1 + alpha / 2)
                ),
                "free": ["z"],
            },
            {"nonzero": []},
        ),
        statement(
            "matrix",
            "equal",
            {"left": graph(matrix * 2), "right": graph(matrix + matrix), "free": []},
            {"nonzero": []},
        ),
        statement(
            "slope",
            "equal",
            {
                "left": graph(sp.Derivative(sigma, index)),
                "right": graph(1 / (2 * alpha)),
                "free": [],
            },
            {"nonzero": []},
        ),
        statement(
            "updated",
            "positive",
            {"expression": graph(1 - alpha)},
            {"value": fraction(1, SIGMA**2, P), "nonzero": []},
        ),
        statement(
            "sign",
            "same_sign",
            {"left": graph(alpha * (p - 1)), "right": graph(p - 1)},
            {"factor": fraction(p * s, SIGMA, P), "nonzero": []},
        ),
        _limit("start", alpha / p, "0", sp.sqrt(2), **AT_ZERO),
        _limit("end", beta, "infinity", 2, **AT_INFINITY),
        _limit("growth", sigma / p, "infinity", "infinity", **AT_INFINITY),
        statement(
            "monotone",
            "increasing_onto",
            {
                "expression": graph(alpha),
                "variable": "tracking_index",
                "from": graph(0),
                "to": graph(1),
            },
            {
                "derivative": fraction(1, SIGMA**2 * p * s, P),
                "start": AT_ZERO,
                "end": AT_INFINITY,
                "nonzero": [],
            },
        ),
        statement(
            "bijection",
            "increasing_onto",
            {"expression": graph(index), "variable": "p", "from": graph(0), "to": "infinity"},
            {
                "derivative": fraction(2 * p, 1, P),
                "start": AT_ZERO,
                "end": AT_INFINITY,
                "nonzero": [],
            },
        ),
        statement(
            "steady_state",
            "riccati",
            {
                "model": MODEL,
                "predicted": [["m11", "m12"], ["m12", "m22"]],
                "updated": [["alpha", "beta"], ["beta", "x22"]],
                "gain": ["alpha", "beta"],
                "index": "tracking_index",
            },
            riccati_evidence(MODEL, sp.Integer(1), above, p**4, RELATION, P),
        ),
        statement(
            "loop",
            "stable",
            {"model": MODEL, "gain": ["alpha", "beta"]},
            {
                "values": [
                    fraction(p * s, SIGMA, P),
                    fraction(SIGMA**2 + 1, SIGMA**2, P),
                    fraction(4 * p * s, SIGMA**2, P),
                    fraction(p**3 * s, SIGMA**2, P),
                ]
            },
        ),
        statement(
            "definite",
            "positive_definite",
            {"matrix": [["m11", "m12"], ["m12", "m22"]]},
            {"minors": [fraction(p * s * SIGMA, 1, P), fraction(p**4 * SIGMA, 1, P)]},
        ),
        statement(
            "kernel",
            "program",
            {"program": "gains", "outputs": {"alpha": graph(alpha), "beta": graph(beta)}},
            {
                "roots": {"1": fraction(p, 1, P), "8": fraction(2 * s, 1, P)},
                "branches": {},
                "gaps": {},
                "nonzero": [],
            },
        ),
        statement(
            "unique",
            "cited",
            {
                "theorem": "A stabilising solution of the Riccati equation is unique.",
                "reference": "Lancaster and Rodman, Algebraic Riccati Equations, 1995",
            },
            {},
        ),
    ]
    return {
        "format": "gainproof certificate 1",
        "subject": "random-acceleration",
        "towers": {
            "main": {
                "parameters": [{"symbol": "p", "above": "0"}],
                "generators": [{"symbol": "s", "power": 2, "radicand": poly((p**2 + 8) / 4, P)}],
                "elements": _elements(),
            }
        },
        "programs": {"gains": _kernel()},
        "statements": statements,
    }


def growing_memory() -> Data:
    """Sums, substitution and a limit over k from 1; and a kernel with branches over g from 0."""
    a, b, u = sp.symbols("a b u")
    below = (k + 1) * (k + 2)
    step = 1 - sp.Subs(a, k, k - 1, evaluate=False)
    statements = [
        statement(
            "squares",
            "sum",
            {
                "index": "j",
                "start": "1",
                "upper": "k",
                "summand": graph(j**2),
                "closed": graph(k * (k + 1) * (2 * k + 1) / 6),
            },
            {},
            "samples",
        ),
        statement(
            "line",
            "equal",
            {"left": graph(2 * a + b * k), "right": graph((14 * k + 4) / below), "free": []},
            {"nonzero": []},
            "samples",
        ),
        statement(
            "first",
            "equal",
            {"left": graph(sp.Subs(a, k, 1, evaluate=False)), "right": graph(1), "free": []},
            {"nonzero": []},
            "samples",
        ),
        statement(
            "shifted",
            "equal",
            {"left": graph(step), "right": graph((k**2 - 3 * k + 2) / (k * (k + 1))), "free": []},
            {"nonzero": []},
            "samples",
        ),
        statement(
            "tail",
            "limit",
            {"expression": graph(a * k), "variable": "k", "point": "infinity", "value": graph(4)},
            {"weights": {}, "constants": [], "boundary": {}, "nonzero": []},
            "samples",
        ),
        statement(
            "root",
            "program",
            {"program": "root", "outputs": {"low": graph(g), "high": graph(g**2)}},
            {
                "roots": {"3": fraction(g, 1, [g])},
                "branches": {"5": "else", "6": "positive"},
                "gaps": {"5": fraction(g**2, 1, [g]), "6": fraction(g**2, 1, [g])},
                "nonzero": [],
            },
            "branch",
        ),
        statement(
            "onto",
            "increasing_onto",
            {"expression": graph(u), "variable": "g", "from": graph(1), "to": "infinity"},
            {
                "derivative": fraction(2 * g, 1, [g]),
                "start": _NOTHING,
                "end": _NOTHING,
                "nonzero": [],
            },
            "branch",
        ),
    ]
    kernel = {
        "inputs": {"u": "u"},
        "graph": {
            "nodes": [
                ["symbol", "u"],
                ["number", "-1"],
                ["add", 0, 1],
                ["pow", 2, "1/2"],
                ["number", "1"],
                ["call", "select", 0, 4, 1, 3],
                ["call", "abs", 2],
            ],
            "outputs": {"low": 5, "high": 6},
        },
    }
    return {
        "format": "gainproof certificate 1",
        "subject": "growing-memory",
        "towers": {
            "samples": {
                "parameters": [{"symbol": "k", "from": "1"}],
                "generators": [],
                "elements": {
                    "a": fraction(2 * (2 * k + 1), below, [k]),
                    "b": fraction(6, below, [k]),
                },
            },
            "branch": {
                "parameters": [{"symbol": "g", "from": "0"}],
                "generators": [],
                "elements": {"u": fraction(1 + g**2, 1, [g])},
            },
        },
        "programs": {"root": kernel},
        "statements": statements,
    }


_NOTHING: Data = {"weights": {}, "constants": [], "boundary": {}}
