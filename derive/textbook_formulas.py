"""Formulas of kernels as textbooks print them, as the text of a module that tests evaluate.

They are none of what the kernels are printed from: evaluated in intervals, at as many digits as
they lose, they give the same values.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import sympy as sp
from sympy.printing.str import StrPrinter

from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.subject import Subject


def formulas_source(subject: Subject) -> str:
    """The text of a function for each kernel whose formulas are known, empty if there is none."""
    known = subject.textbook()
    kernels = [kernel for kernel in subject.module.kernels if kernel.name in known]
    if not kernels:
        return ""
    lines = [
        f'"""Formulas of {subject.module.name} as they are written, over intervals of mpmath."""',
        "# ruff: noqa: E501",
        "",
        "from __future__ import annotations",
        "",
        "from typing import Any",
        "",
        "from mpmath import iv",
    ]
    for kernel in kernels:
        lines += ["", "", *_function(kernel, known[kernel.name])]
    return "\n".join(lines) + "\n"


def _function(kernel: Kernel, formulas: Mapping[str, sp.Expr]) -> Iterator[str]:
    inputs = ", ".join(f"{given.name}: Any" for given in kernel.inputs)
    head = f"def {kernel.name}({inputs}) -> dict[str, Any]:"
    yield from [head] if len(head) <= 100 else _head(kernel)
    printer = _Intervals()
    yield "    return {"
    for output in kernel.outputs:
        if output.name in formulas:
            yield f'        "{output.name}": iv.convert({printer.doprint(formulas[output.name])}),'
    yield "    }"


def _head(kernel: Kernel) -> Iterator[str]:
    yield f"def {kernel.name}("
    yield from (f"    {given.name}: Any," for given in kernel.inputs)
    yield ") -> dict[str, Any]:"


class _Intervals(StrPrinter):  # type: ignore[misc]
    """SymPy's text with the functions of mpmath's intervals, and no quotient of two integers."""

    def _print_Rational(self, value: sp.Rational) -> str:
        return f"(iv.mpf({value.p})/{value.q})"

    def _print_Pow(self, value: sp.Pow, rational: bool = False) -> str:
        base, exponent = value.base, value.exp
        if exponent.is_Integer or not exponent.is_Rational:
            return str(super()._print_Pow(value, rational=rational))
        if exponent < 0:
            return f"(1/{self._print_Pow(sp.Pow(base, -exponent, evaluate=False))})"
        text, order = self._print(base), int(exponent.q)
        while order % 2 == 0:
            text, order = f"iv.sqrt({text})", order // 2
        text = text if order == 1 else f"iv.exp(iv.log({text})/{order})"
        return text if exponent.p == 1 else f"{text}**{exponent.p}"

    def _print_Pi(self, _: sp.Expr) -> str:
        return "iv.pi"

    def _print_Abs(self, value: sp.Expr) -> str:
        return f"abs({self._print(value.args[0])})"

    def _print_Function(self, value: sp.Function) -> str:
        return f"iv.{super()._print_Function(value)}"

    def _print_atan(self, value: sp.Function) -> str:
        return f"iv.atan2({self._print(value.args[0])}, iv.mpf(1))"  # intervals have no atan

    def _print_ExpBase(self, value: sp.Expr) -> str:
        return f"iv.exp({self._print(value.args[0])})"
