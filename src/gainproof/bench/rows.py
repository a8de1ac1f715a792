"""What is measured of a kernel as plain data: all that tables, pages and files show."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict
from typing import Any

from gainproof.bench.measure import Figures
from gainproof.bench.subjects import Measured
from gainproof.pages.cancellations import Left, left


def row(item: Measured, found: Figures, remaining: Mapping[str, Left]) -> dict[str, Any]:
    """One kernel: its names, domain, cancellations, seconds for a million points, and errors.

    Numbers that are infinite are written as text, since JSON has none.
    """
    module = item.function.__module__.rpartition(".")[2]
    return {
        "subject": item.subject,
        "kernel": item.kernel.name,
        "domain": domain(item),
        "inputs": len(item.kernel.inputs),
        "outputs": len(item.kernel.outputs),
        "cancellations": _cancellations(remaining.get(f"{module}.{item.kernel.name}")),
        "seconds": {name: float(f"{seconds:.4g}") for name, seconds in found.seconds.items()},
        "missing": dict(found.missing),
        "errors": [
            {key: _plain(value) for key, value in asdict(each).items()} for each in found.errors
        ],
    }


def remaining() -> dict[str, Left]:
    """The subtractions that are left, by module and function."""
    return {each.name: each for each in left()}


def domain(item: Measured) -> list[str]:
    """The numbers of each input in double precision, what they must fulfil together, and where all
    outputs have their bounds if that is less.
    """
    signature, bounds = item.signature, item.bound.outputs
    lines = []
    for number, given in enumerate(signature.inputs):
        low, high = given.double
        name = f"|{given.name}|" if given.signed else given.name
        kind = " whole" if given.whole else ""
        zero = "0 or " if given.zero and low > 0 else ""
        lines.append(f"{name}{kind}: {zero}{low:.3g} to {high:.3g}")
        least = max(each.domain[number][0] for each in bounds)
        most = min(each.domain[number][1] for each in bounds)
        if not given.signed and (least > low or most < high):
            lines.append(f"bounds of all outputs: {least:.3g} to {most:.3g}")
    return lines + [required.wanted for required in signature.required]


def _cancellations(found: Left | None) -> list[str]:
    if found is None:
        return []
    named = [f"{name}, condition number {condition}" for name, condition, _ in found.differences]
    if found.by_terms:
        outputs = "1 output" if found.by_terms == 1 else f"{found.by_terms} outputs"
        named.append(f"{outputs} over the sum of terms")
    return named


def _plain(value: Any) -> Any:
    return str(value) if isinstance(value, float) and not math.isfinite(value) else value
