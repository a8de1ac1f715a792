"""Formulas of the kernels' docstrings, read by SymPy and not by what printed them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
import sympy as sp
from sympy.parsing.sympy_parser import (
    implicit_multiplication,
    parse_expr,
    standard_transformations,
)

Values = dict[str, sp.Expr]
END = re.compile(r"[,;:>]|\. | likewise| times| \(Duan|$")
"""Where a formula of these texts ends."""
DIGITS = 40


class Text:
    """The equations of a kernel; formulas are read by what stands before them."""

    def __init__(self, lines: tuple[str, ...]) -> None:
        self.text = " ".join(lines)
        self.read: set[int] = set()

    def formula(self, start: str) -> str:
        """What follows `start`, which stands in the text once."""
        assert self.text.count(start) == 1, start
        at = self.text.index(start) + len(start)
        self.read |= {at - len(start) + i for i, each in enumerate(start) if each == "="}
        end = END.search(self.text, at)
        assert end is not None
        return self.text[at : end.start()]

    def everything_is_read(self) -> bool:
        """Every equals sign was before a formula."""
        return self.read == {i for i, each in enumerate(self.text) if each == "="}


def expression(formula: str, names: Mapping[str, Any]) -> sp.Expr:
    """A formula of a docstring as SymPy reads it."""
    code = re.sub(r"\b(cos|sin) (\w)", r"\1(\2)", formula).replace("^", "**")
    code = code.replace("alpha'(Lambda)", "alpha_slope").replace("beta'(Lambda)", "beta_slope")
    known = {name: sp.Symbol(name) for name in names}
    found = parse_expr(code, known, (*standard_transformations, implicit_multiplication))
    assert found.free_symbols <= set(known.values()), formula
    return found


def value(formula: str, names: Values) -> sp.Expr:
    """Its value."""
    return expression(formula, names).evalf(DIGITS, subs=names)


def near(kernel: Any, wanted: Mapping[str, sp.Expr]) -> None:
    for name, each in wanted.items():
        got = float(getattr(kernel, name))
        assert got == pytest.approx(float(each), rel=1e-11, abs=0), name


def drawn(seed: int, low: float, high: float, size: int) -> list[float]:
    return [float(x) for x in 10 ** np.random.default_rng(seed).uniform(low, high, size)]


def exact(**given: float) -> Values:
    return {name: sp.Float(each, DIGITS) for name, each in given.items()}
