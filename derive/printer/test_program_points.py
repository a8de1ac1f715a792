"""What the test programs of all languages hold kernels against: points, and where values lie."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.known_values import DIGITS

WRITTEN = Fraction(100, 10**DIGITS)
"""What a value of so many digits may be off, relative to itself."""


def points(known: Mapping[str, Any], form: Format) -> Iterator[tuple[list[float], list[float]]]:
    """Inputs, and of each output the least and the greatest number of the format within its bound;
    `known` are a kernel's `known_values`.
    """
    for point in known["points"][form.name]:
        ends = [x for output in known["outputs"] for x in _ends(form, output, point)]
        yield point["at"], ends


def _ends(form: Format, output: Mapping[str, Any], point: Mapping[str, Any]) -> tuple[float, float]:
    """Where nothing is promised any number but NaN."""
    text = point["values"].get(output["name"])
    if text is None:
        return -float("inf"), float("inf")
    stated, exact = output[form.name], Fraction(text)
    scale = abs(Fraction(point.get("scales", {}).get(output["name"], exact)))
    allowed = (Fraction(stated["bound"]) * Fraction(form.epsilon) + WRITTEN) * scale
    allowed += WRITTEN * abs(exact) + Fraction(stated["beside"])
    return _beyond(form, exact - allowed, form.at_least), _beyond(
        form, exact + allowed, form.at_most
    )


def _beyond(form: Format, value: Fraction, rounded: Any) -> float:
    largest = Fraction(form.largest)
    return float(rounded(min(max(value, -largest), largest)))
