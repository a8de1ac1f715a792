"""Forms of a sensor's textbook formulas against those that were ordered by hand.

The general search is given the differentiated formulas of range and Doppler, with the domains and
requirements of the printed kernels: where it finds none, or its bound is larger than that in the
ledger, the form by hand is a hint that is needed, and stands in `HINTS`.
"""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import sympy as sp

import gainproof.generated
from gainproof.derive.own_expressions.expressions import (
    Argument,
    Condition,
    ExpressionKernel,
    Result,
)
from gainproof.derive.own_expressions.subject import chosen_forms
from gainproof.derive.own_expressions.written_form import as_written
from gainproof.derive.pages.kernel_formulas import PLANE
from gainproof.derive.pages.kernel_page import page_module
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.kernel import Input, Kernel
from gainproof.derive.quantity import ONE, Quantity
from gainproof.derive.sensors.range_doppler import FORMULAS, graphs, of_two_stations
from gainproof.derive.sensors.range_doppler_textbook import textbook

LEDGER = Path(gainproof.generated.__file__).parent / "bounds.json"
SINGLE = {name: graph for name, graph in graphs().items() if not of_two_stations(name)}
MODULE = page_module(FORMULAS, SINGLE, "range-doppler", "a title")
KERNELS = {each.name: each for each in MODULE.kernels}
QUICK = ("slant_range", "range_jacobian", "range_rate", "range_rate_jacobian", "range_hessian")
HINTS = {"range_rate_hessian"}
"""Kernels of which the search finds no form of some output."""


def argument(given: Input) -> Argument:
    """An input of a printed kernel as that of an expression."""
    single = None if given.single is None else (str(given.single[0]), str(given.single[1]))
    quantity = Quantity(given.name, given.name, given.meaning, ONE)
    return Argument(quantity, str(given.lower), str(given.upper), single, signed=given.signed)


def expressions(kernel: Kernel) -> ExpressionKernel:
    formulas = textbook()
    end = PLANE if kernel.name.endswith(PLANE) else ""
    (required,) = kernel.requirements
    distance = formulas[f"slant_range{end}"]["slant_range"]
    condition = Condition(
        distance >= sp.Rational(str(required.least)), required.meaning, str(required.single)
    )
    outputs = (
        Result(Quantity(each.name, each.name, "an output", ONE), formulas[kernel.name][each.name])
        for each in kernel.outputs
    )
    inputs = tuple(map(argument, kernel.inputs))
    return ExpressionKernel(kernel.name, "A title", inputs, tuple(outputs), "", (condition,))


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[] if name in {f"{each}{PLANE}" for each in QUICK} else LONG)
        for LONG in [pytest.mark.thorough]
        for name in KERNELS
    ],
)
def test_formulas_alone_come_to_the_bounds_of_forms_by_hand(name: str) -> None:
    ledger: Any = json.loads(LEDGER.read_text("utf-8"))["modules"]["range_doppler"][name]
    given = expressions(KERNELS[name])
    forms = chosen_forms(given)
    assert (len(forms) < len(given.outputs)) is (name in HINTS)
    if name in HINTS:
        return
    kernel = as_written(given, forms).kernel
    for form in FORMATS:
        for output in prove(kernel, form).outputs:
            stated = Fraction(ledger[form.name]["outputs"][output.name]["bound"])
            assert output.bound <= stated, output.name
