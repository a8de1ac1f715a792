"""The textbook form of a kernel by other means: SymPy's lambdify, numexpr, Numba and JAX.

All in double precision, subexpressions shared where the tool does not do so itself, one thread but
for JAX, which takes what it takes. Each call answers with its outputs, so that a test can compare.
"""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import sympy as sp
from sympy.printing.numpy import NumPyPrinter
from sympy.printing.pycode import PythonCodePrinter

from gainproof.bench.arguments import Arguments
from gainproof.bench.subjects import Measured

OPERATIONS = 600
"""Of an expression for numexpr, which takes the text of the whole and 255 temporaries at most."""


class UnfitError(Exception):
    """Why a tool cannot be asked for a kernel."""


def lambdified(item: Measured) -> Callable[..., Any]:
    """SymPy's own printer on the textbook form, with common subexpressions shared."""
    function: Callable[..., Any] = sp.lambdify(
        _symbols(item), _expressions(item), modules="numpy", cse=True
    )
    return function


def with_numexpr(item: Measured, given: Arguments) -> Callable[[], list[Any]]:
    """An evaluation for each output: numexpr knows no common subexpressions of several."""
    numexpr = _module("numexpr")
    numexpr.set_num_threads(1)
    names = [str(symbol) for symbol in _symbols(item)]
    texts = list[str]()
    for expression in _expressions(item):
        if sp.count_ops(expression) > OPERATIONS:
            raise UnfitError(f"an output of more than {OPERATIONS} operations")
        if expression.has(sp.Piecewise, sp.Max, sp.Min):
            raise UnfitError("an output by cases")
        texts.append(_Plain().doprint(expression))
    columns = dict(zip(names, given, strict=True))
    outputs = [np.empty(np.broadcast_shapes(*map(np.shape, given))) for _ in texts]

    def call() -> list[Any]:
        for text, output in zip(texts, outputs, strict=True):
            numexpr.evaluate(text, local_dict=columns, global_dict={}, out=output)
        return outputs

    try:
        call()
    except (ValueError, KeyError, TypeError, NotImplementedError, RuntimeError) as error:
        raise UnfitError(f"refused: {type(error).__name__}") from None
    return call


def with_numba(item: Measured, given: Arguments, folder: Path) -> Callable[[], list[Any]]:
    """A loop over the points, written out as Python and compiled; divisions as NumPy's."""
    numba = _module("numba")
    source = folder / f"numba_{item.subject}_{item.kernel.name}.py".replace("-", "_")
    source.write_text("\n".join(_loop(item)) + "\n", encoding="utf-8")
    specification = importlib.util.spec_from_file_location(source.stem, source)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    loop = numba.njit(error_model="numpy")(module.loop)
    columns = [each.ravel() for each in np.broadcast_arrays(*given)]
    outputs = [np.empty(columns[0].size) for _ in _expressions(item)]

    def call() -> list[Any]:
        loop(*columns, *outputs)
        return outputs

    try:
        call()
    except numba.core.errors.NumbaError as error:
        raise UnfitError(f"refused: {type(error).__name__}") from None
    return call


def with_jax(item: Measured, given: Arguments) -> Callable[[], list[Any]]:
    """The function that lambdify prints for JAX, compiled as a whole."""
    jax = _module("jax")
    jax.config.update("jax_enable_x64", True)
    plain = sp.lambdify(_symbols(item), _expressions(item), modules="jax", cse=True)
    function = jax.jit(plain)
    columns = [jax.numpy.asarray(each) for each in given]

    def call() -> list[Any]:
        found: list[Any] = jax.block_until_ready(function(*columns))
        return found

    try:
        call()
    except (TypeError, ValueError, AttributeError, NameError) as error:
        raise UnfitError(f"refused: {type(error).__name__}") from None
    return call


class _Plain(NumPyPrinter):  # type: ignore[misc]
    """NumPy's functions by bare names, as numexpr has them."""

    def _module_format(self, fqn: str, register: bool = True) -> str:
        del register
        return {"atan2": "arctan2"}.get(fqn.split(".")[-1], fqn.split(".")[-1])

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:
        # an exponent 1/2 as a root, all others as powers of decimal numbers
        if expr.exp.is_Rational and not expr.exp.is_Integer and abs(expr.exp) != sp.Rational(1, 2):
            return f"({self._print(expr.base)})**({float(expr.exp)!r})"
        return str(super()._print_Pow(expr, rational=rational))


def _loop(item: Measured) -> Iterator[str]:
    """The lines of a Python function over columns and outputs."""
    printer = PythonCodePrinter({"fully_qualified_modules": True})
    names = [str(symbol) for symbol in _symbols(item)]
    shared, last = sp.cse(_expressions(item), symbols=sp.numbered_symbols("shared_"))
    outputs = [f"output_{number}" for number in range(len(last))]
    lines = [f"{name} = column_{number}[i]" for number, name in enumerate(names)]
    lines += [f"{name} = {printer.doprint(value)}" for name, value in shared]
    lines += [
        f"{name}[i] = {printer.doprint(value)}" for name, value in zip(outputs, last, strict=True)
    ]
    if any("Not supported" in line for line in lines):
        raise UnfitError("a function that Python's math does not have")
    columns = [f"column_{number}" for number in range(len(names))]
    yield "import math"
    yield f"def loop({', '.join([*columns, *outputs])}):"
    yield f"    for i in range({outputs[0]}.size):"
    yield from (f"        {line}" for line in lines)


def _module(name: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError:
        raise UnfitError("not installed") from None


def _symbols(item: Measured) -> Sequence[sp.Symbol]:
    """The arguments of the textbook form, in the kernel's order."""
    assert item.textbook is not None
    free = {symbol for value in item.textbook.values() for symbol in value.free_symbols}
    if len(item.kernel.inputs) == 1:
        return list(free)
    named = {str(symbol): symbol for symbol in free}
    return [named[given.name] for given in item.kernel.inputs]


def _expressions(item: Measured) -> list[sp.Expr]:
    assert item.textbook is not None
    return list(item.textbook.values())
