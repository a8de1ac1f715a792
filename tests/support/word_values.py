"""Matrix formulas of certificates in numbers: an oracle for statements, never a proof.

Graphs and polynomials are read as plain data and evaluated by NumPy with the matrices that are
given; nothing of derive or of the checker is used.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]
Values = Mapping[str, Matrix | float]
TOLERANCE = 1e-7
"""Of matrices with entries around 1 and inverses of condition below 1e4, in some tens of steps."""


def completed(setting: Mapping[str, Any], given: Values) -> dict[str, Matrix | float]:
    """With units, elements and inverses, once what they are made of is known.

    A singular matrix has any matrix for its inverse: here the zero matrix.
    """
    found = dict(given)
    for name, (rows, _) in setting["matrices"].items():
        found.setdefault(f"size of {rows}", float(np.atleast_2d(given.get(name, 0)).shape[0]))
    waiting = {**setting["elements"], **setting["inverses"]}
    while waiting:
        before = len(waiting)
        for name, meaning in list(waiting.items()):
            if name in setting["inverses"]:
                ready = meaning in found
            else:
                ready = {e.rstrip("'") for term in meaning for e in term[2]} <= set(found)
            if not ready:
                continue
            if name in setting["inverses"]:
                base = np.asarray(found[meaning])
                regular = np.linalg.cond(base) < 1e12
                found[name] = np.linalg.inv(base) if regular else np.zeros_like(base)
            else:
                found[name] = _polynomial(setting, name, meaning, found)
            del waiting[name]
        if len(waiting) == before:
            raise LookupError(f"no value for what {sorted(waiting)} are made of")
    return found


def _polynomial(
    setting: Mapping[str, Any], name: str, terms: list[Any], values: Values
) -> Matrix | float:
    sizes = {size: int(_rows(setting, size, values)) for size in setting["matrices"][name]}
    rows, columns = (sizes[size] for size in setting["matrices"][name])
    total = np.zeros((rows, columns))
    for coefficient, powers, letters in terms:
        numerator, _, denominator = coefficient.partition("/")
        product: Any = np.eye(rows)
        for letter in letters:
            factor = np.asarray(values[letter.rstrip("'")])
            product = product @ (factor.T if letter.endswith("'") else factor)
        number = int(numerator) / int(denominator or 1)
        for parameter, power in zip(setting["parameters"], powers, strict=True):
            number *= float(np.asarray(values[parameter["symbol"]])) ** power
        total = total + number * product
    return total


def _rows(setting: Mapping[str, Any], size: str, values: Values) -> float:
    """A size, from a matrix that has it."""
    if size.isdigit():
        return float(size)
    for name, shape in setting["matrices"].items():
        if name in values and size in shape:
            return float(np.asarray(values[name]).shape[shape.index(size)])
    raise LookupError(size)


def value(setting: Mapping[str, Any], graph: Mapping[str, Any], values: Values) -> Any:
    """The value of a graph: a matrix, or a number."""
    found: list[Any] = []
    for kind, *rest in graph["nodes"]:
        if kind == "number":
            numerator, _, denominator = rest[0].partition("/")
            found.append(int(numerator) / int(denominator or 1))
        elif kind == "symbol":
            size = setting["units"].get(rest[0])
            found.append(np.eye(int(_rows(setting, size, values))) if size else values[rest[0]])
        elif kind == "pow":
            found.append(found[rest[0]] ** int(rest[1]))
        else:
            found.append(_operation(kind, [found[number] for number in rest]))
    return found[graph["outputs"]["value"]]


def _operation(kind: str, parts: list[Any]) -> Any:
    if kind == "add":
        return sum(parts[1:], start=parts[0])
    if kind == "neg":
        return -parts[0]
    if kind == "div":
        return parts[0] / parts[1]
    if kind == "transpose":
        return np.transpose(parts[0])
    if kind == "inverse":
        return np.linalg.inv(parts[0])
    product = parts[0]
    for part in parts[1:]:
        numbers = np.ndim(product) == 0 or np.ndim(part) == 0
        product = product * part if numbers else product @ part
    return product


def holds(setting: Mapping[str, Any], entry: Mapping[str, Any], values: Values) -> bool:
    """Whether a hypothesis is true of these matrices."""
    if entry["kind"] == "equal":
        return near(*(value(setting, entry[side], values) for side in ("left", "right")))
    matrix = np.asarray(values[entry["matrix"]])
    if entry["kind"] == "full_column_rank":
        return bool(np.linalg.matrix_rank(matrix) == matrix.shape[1])
    if entry["kind"] == "invertible":
        return bool(np.linalg.cond(matrix) < 1e12)
    if not near(matrix, matrix.T):
        return False
    least = float(np.linalg.eigvalsh(matrix).min())
    return (
        least
        > {"symmetric": -np.inf, "semidefinite": -TOLERANCE, "definite": TOLERANCE}[entry["kind"]]
    )


def true(setting: Mapping[str, Any], kind: str, claim: Mapping[str, Any], values: Values) -> bool:
    """Whether the conclusion of a statement is true of these matrices."""
    if kind == "matrix_invertible":
        return bool(np.linalg.cond(np.asarray(values[claim["matrix"]])) < 1e12)
    sides = ("larger", "smaller") if kind == "matrix_order" else ("left", "right")
    left, right = (value(setting, claim[side], values) for side in sides)
    if kind == "matrix_trace":
        return near(np.trace(left), np.trace(right))
    if kind == "matrix_equal":
        return near(left, right)
    difference = left - right
    least = float(np.linalg.eigvalsh((difference + difference.T) / 2).min())
    return near(difference, difference.T) and least > -TOLERANCE


def near(left: Any, right: Any) -> bool:
    """Equal up to rounding."""
    return bool(np.allclose(left, right, rtol=TOLERANCE, atol=TOLERANCE))
