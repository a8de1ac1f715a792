"""A kernel at points of its domain: what it returns, and by how much that is off.

The truth is the kernel's own graph in balls of python-flint at rising precision: the pictures show
rounding, as the formulas are proved elsewhere.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from importlib import import_module
from typing import Any

import numpy as np

from gainproof.bench.accuracy import ball_outputs, terms
from gainproof.bench.arguments import sample

POINTS = 72


def sampled(module: str, kernel: Mapping[str, Any], graph: Mapping[str, Any]) -> dict[str, Any]:
    """{"input", "inputs", "x", "values", "errors"}: the name of the first input and how many there
    are; its values in order; by output the kernel's values and their errors in units in the last
    place of what its bound is relative to. Points are random and the same each time; an output
    whose true value is no normal number has None there. Raises ArithmeticError where the balls do
    not tell the true value: a picture without those points would look as if all were well.
    """
    home = import_module(f"gainproof.generated.{module}")
    signature = getattr(home, f"_{kernel['name'].upper()}")
    names = [domain.name for domain in signature.inputs]
    columns = sample(signature, POINTS)
    order = np.argsort(columns[0], kind="stable")
    columns = [np.ascontiguousarray(column[order]) for column in columns]
    returned = getattr(home, kernel["name"])(*columns)
    values: dict[str, list[float]] = {}
    errors: dict[str, list[float | None]] = {each["name"]: [] for each in kernel["outputs"]}
    for each in kernel["outputs"]:
        values[each["name"]] = [float(value) for value in getattr(returned, each["name"])]
    for place, point in enumerate(zip(*(column.tolist() for column in columns), strict=True)):
        at = dict(zip(names, point, strict=True))
        exact = ball_outputs(graph, at)
        sizes = terms(graph, at) if any(each["by_terms"] for each in kernel["outputs"]) else {}
        for each in kernel["outputs"]:
            name = each["name"]
            if not exact[name].is_finite():
                raise ArithmeticError(f"{module}.{kernel['name']}: {name} is not known at {at}")
            scale = sizes[name] if each["by_terms"] else exact[each["relative_to"] or name]
            errors[name].append(_units(values[name][place], exact[name], scale))
    return {
        "input": names[0],
        "inputs": len(names),
        "x": columns[0].tolist(),
        "values": values,
        "errors": errors,
    }


def _units(value: float, exact: Any, scale: Any) -> float | None:
    """|value - exact| in units in the last place of the scale."""
    size = abs(float(scale.mid()))
    if not math.isfinite(size) or size < 2.0**-1021:
        return None
    found = float((abs(exact - value) / math.ulp(size)).upper())
    return found if math.isfinite(found) else None
