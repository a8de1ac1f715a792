"""A tower with a coupled pair, and true statements over it, written without the project's writer.

Parameters p, k > 0, the root r of 1 + p^2, and the pair x^2 = k + 4 p y, y^2 = 1 + r x/2. For large
p x grows like 2 p and y like p; for p -> 0 x tends to the root c of k and y to that of 1 + c/2.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from tests.verify.certificate.toy_writer import fraction, graph, poly, statement

Data = dict[str, Any]

P, K, R, X, Y = VARIABLES = sp.symbols("p k r x y")
C, D = sp.symbols("c d")
PLACES: list[Any] = [P, K, R, X, Y]
PAIR: Data = {
    "coupled": ["x", "y"],
    "free": [poly(K, PLACES), poly(1, PLACES)],
    "slopes": [poly(4 * P, PLACES), poly(R / 2, PLACES)],
}
DETERMINANT = 4 * X * Y - 2 * P * R
PLAIN = 4 * K + 2 * K * R * X + 16 * P * Y + 6 * P * R * X * Y
"""The determinant times x y, without a minus sign."""
X_BY_P = (8 * Y**2 + 2 * P**2 * X / R) / DETERMINANT
Y_BY_K = R / 2 / DETERMINANT

LARGE: Data = {
    "weights": {"r": 1, "x": 1, "y": 1},
    "constants": [],
    "boundary": {"r": poly(1, [K]), "x": poly(2, [K]), "y": poly(1, [K])},
}
SMALL: Data = {
    "weights": {"r": 0, "x": 0, "y": 0},
    "constants": [
        {"symbol": "c", "power": 2, "radicand": poly(K, [K, C, D])},
        {"symbol": "d", "power": 2, "radicand": poly(1 + C / 2, [K, C, D])},
    ],
    "boundary": {"r": poly(1, [K, C, D]), "x": poly(C, [K, C, D]), "y": poly(D, [K, C, D])},
}
KERNEL: Data = {
    "nodes": [
        ["symbol", "p"],
        ["symbol", "k"],
        ["number", "1"],
        ["mul", 0, 0],
        ["add", 2, 3],
        ["pow", 4, "1/2"],
        ["number", "2"],
        ["div", 5, 6],
        ["call", "unknown", 2, 6],
        ["mul", 7, 8],
        ["add", 2, 9],
        ["pow", 10, "1/2"],
        ["mul", 6, 6, 0],
        ["mul", 12, 11],
        ["add", 1, 13],
        ["pow", 14, "1/2"],
        ["call", "fixed_point", 8, 15, 11],
    ],
    "outputs": {"y": 16},
}


def tower(pair: Data | None = None) -> Data:
    """The tower, with another pair where one is given."""
    return {
        "parameters": [{"symbol": "p", "above": "0"}, {"symbol": "k", "above": "0"}],
        "generators": [
            {"symbol": "r", "power": 2, "radicand": poly(1 + P**2, PLACES)},
            PAIR if pair is None else pair,
        ],
        "elements": {},
    }


def equality(identifier: str, left: Any, right: Any, shown: bool = False) -> Data:
    """left = right; with the determinant shown nonzero where it divides."""
    claim = {"left": graph(left), "right": graph(right), "free": []}
    listed = [fraction(PLAIN, X * Y, PLACES)] if shown else []
    return statement(identifier, "equal", claim, {"nonzero": listed})


def tends(identifier: str, expression: Any, point: str, value: Any, evidence: Data) -> Data:
    """A limit in p, k held."""
    claim = {
        "expression": graph(expression),
        "variable": "p",
        "point": point,
        "value": value if value == "infinity" else graph(value),
    }
    return statement(identifier, "limit", claim, {**evidence, "nonzero": []})


def grows(identifier: str, trend: str = "increasing", sign: int = 1) -> Data:
    """x with p."""
    claim = {"expression": graph(X), "variable": "p", "trend": trend}
    rate = fraction(sign * (8 * R * Y**2 + 2 * P**2 * X) * X * Y, R * PLAIN, PLACES)
    return statement(identifier, "monotone", claim, {"derivative": rate, "nonzero": []})


def program(root_of_x: Any = X, root_of_y: Any = Y) -> Data:
    """The kernel finds y."""
    roots = {"5": R, "8": root_of_x, "11": root_of_y, "15": root_of_x}
    proof = {
        "roots": {key: fraction(value, 1, PLACES) for key, value in roots.items()},
        "branches": {},
        "gaps": {},
        "nonzero": [],
    }
    return statement("kernel", "program", {"program": "y", "outputs": {"y": graph(Y)}}, proof)


def statements() -> list[Data]:
    """True ones of the kinds that a pair touches."""
    gap = statement(
        "gap",
        "positive",
        {"expression": graph(DETERMINANT)},
        {"value": fraction(PLAIN, X * Y, PLACES), "nonzero": []},
    )
    return [
        equality("square", X**2, K + 4 * P * Y),
        equality("fourth", X**4, K**2 + 8 * K * P * Y + 16 * P**2 * (1 + R * X / 2)),
        equality("other", (X * Y) ** 2, (K + 4 * P * Y) * (1 + R * X / 2)),
        equality("root", sp.sqrt(1 + R * X / 2), Y),
        equality("by_p", sp.Derivative(X, P), X_BY_P, shown=True),
        equality("by_k", sp.Derivative(Y, K), Y_BY_K, shown=True),
        gap,
        grows("trend"),
        tends("large", X / P, "infinity", sp.Integer(2), LARGE),
        tends("small", X * Y, "0", sp.sqrt(K) * sp.sqrt(1 + sp.sqrt(K) / 2), SMALL),
        program(),
    ]


def certificate(listed: list[Data] | None = None, pair: Data | None = None) -> Data:
    """The certificate of these statements, or of all."""
    chosen = statements() if listed is None else listed
    used = any(entry["kind"] == "program" for entry in chosen)
    return {
        "format": "gainproof certificate 1",
        "subject": "coupled",
        "towers": {"main": tower(pair)},
        "programs": {"y": {"inputs": {"p": "p", "k": "k"}, "graph": KERNEL}} if used else {},
        "statements": chosen,
    }
