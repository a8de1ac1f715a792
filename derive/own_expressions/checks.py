"""What is wrong with the names and symbols of expressions, before anything is computed."""

from __future__ import annotations

import keyword
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import fields
from fractions import Fraction
from types import NoneType

import sympy as sp

from gainproof.derive.own_expressions.conditions import asked, relation_of
from gainproof.derive.own_expressions.expressions import (
    Argument,
    Condition,
    ExpressionError,
    ExpressionKernel,
    ExpressionSet,
    Result,
)
from gainproof.derive.own_expressions.kernel_names import require_side_by_side
from gainproof.derive.quantity import Quantity, Unit

NAME = re.compile(r"[a-z][a-z0-9]*(_[a-z0-9]+)*")
DERIVATIVE = re.compile(rf"{NAME.pattern}(_D_{NAME.pattern})*")
"""Of outputs: `range_D_x` is the derivative of `range` by `x`."""
TAKEN = frozenset({"np", "evaluate", "annotations", "iv", "out", "near_cbrt", "choose", "mask_of"})
INPUTS_TAKEN = frozenset({"abs", "accurate", "value", "workers"})
"""Names that a printed module, function or certificate has for something else."""
SHOWN = 80  # characters of what came
EXPONENT = 64
"""Of a power, as in claim files: proofs expand powers."""
PARTS = re.compile(r"(part|over|under|condition)_\d+(_of.*)?")
"""Names of what is no polynomial, see `parts`."""


FIELDS: Mapping[type, Mapping[str, type | tuple[type, ...]]] = {
    ExpressionSet: {"name": str, "title": str},
    ExpressionKernel: {"name": str, "title": str, "source": str},
    Argument: {"quantity": Quantity, "zero": bool, "signed": bool},
    Result: {"quantity": Quantity, "by_terms": bool},
    Condition: {"meaning": str, "single": (str, NoneType), "within": (tuple, list, NoneType)},
    Quantity: {"name": str, "latex": str, "meaning": str, "unit": Unit},
    Unit: dict.fromkeys((field.name for field in fields(Unit)), (int, Fraction)),
}
"""Of what kind fields are; ends of domains and expressions are looked at where they are read."""


def require_written_well(given: ExpressionSet) -> None:
    """Raise ExpressionError for fields of another kind, names that cannot be, and symbols that
    nothing defines.
    """
    _require_kind("EXPRESSIONS", given, ExpressionSet)
    module = given.name.replace("-", "_")
    _require_name("the set", module)
    require_tuple(given.name, "kernels", given.kernels, ExpressionError)
    for number, kernel in enumerate(given.kernels, 1):
        _require_kind(f"{given.name}: kernel {number}", kernel, ExpressionKernel)
    if not given.kernels:
        raise ExpressionError(f"{given.name}: a kernel at least is wanted, there is none")
    names = [kernel.name for kernel in given.kernels]
    _require_different("kernels", names)
    _require_line(given.name, given.title)
    for kernel in given.kernels:
        _require_kernel(kernel)
    require_side_by_side(names)


def require_tuple(place: str, name: str, value: object, error: type[ValueError]) -> None:
    """Raise the error unless it is a tuple or a list: of one element a comma is soon forgotten."""
    if not isinstance(value, tuple | list):
        raise error(
            f"{place}: {name} should be a tuple, it is of type {type(value).__name__}; a tuple of "
            "one element is written with a comma, (x,)"
        )


def _require_kind(place: str, value: object, kind: type | tuple[type, ...]) -> None:
    if not isinstance(value, kind):
        names = " or ".join(k.__name__ for k in (kind if isinstance(kind, tuple) else (kind,)))
        shown = repr(value)
        shown = shown if len(shown) <= SHOWN else f"{shown[:SHOWN]}..."
        raise ExpressionError(f"{place} should be of the type {names}, {shown} came")
    for name, wanted in FIELDS.get(type(value), {}).items():
        _require_kind(f"{place}, {name}", getattr(value, name), wanted)


def _require_kernel(kernel: ExpressionKernel) -> None:
    _require_name("a kernel", kernel.name)
    for text in (kernel.title, kernel.source):
        _require_line(kernel.name, text)
    for name, kind in (("inputs", Argument), ("outputs", Result), ("conditions", Condition)):
        require_tuple(kernel.name, name, getattr(kernel, name), ExpressionError)
        for number, each in enumerate(getattr(kernel, name), 1):
            _require_kind(f"{kernel.name}: {name}, number {number}", each, kind)
    for each in kernel.inputs:
        single = each.single
        if single is not None and not (isinstance(single, tuple | list) and len(single) == 2):
            raise ExpressionError(
                f"{kernel.name}: {each.quantity.name}: single should be two ends of a domain as "
                f"texts, {single!r} came"
            )
    for what, quantities in (
        ("inputs", [each.quantity for each in kernel.inputs]),
        ("outputs", [each.quantity for each in kernel.outputs]),
    ):
        if not quantities:
            raise ExpressionError(f"{kernel.name}: {what} are wanted, there are none")
        names = [quantity.name for quantity in quantities]
        for quantity in quantities:
            pattern = NAME if what == "inputs" else DERIVATIVE
            _require_name(f"{kernel.name}: one of the {what}", quantity.name, pattern)
            if what == "inputs" and quantity.name in INPUTS_TAKEN:
                raise ExpressionError(
                    f"{kernel.name}: an input cannot be called {quantity.name}, which a function "
                    "or its certificate has for something else"
                )
            _require_line(f"{kernel.name}: {quantity.name}", quantity.meaning)
        _require_different(f"{kernel.name}: {what}", names)
    known = {each.quantity.symbol for each in kernel.inputs}
    used: set[sp.Basic] = set()
    for place, expression in _expressions(kernel):
        for symbol in sorted(expression.free_symbols - known, key=str):
            raise ExpressionError(
                f"{place}: the symbol {symbol} is of no input's quantity; wanted: one of "
                f"{', '.join(sorted(map(str, known)))}, as Quantity(...).symbol"
            )
        if expression.has(sp.Float):
            raise ExpressionError(
                f"{place}: exact numbers are wanted, {expression} holds a float; write a quotient "
                "of whole numbers (sp.Rational)"
            )
        for power in expression.atoms(sp.Pow):
            if power.exp.is_Rational and abs(power.exp.p) > EXPONENT:
                raise ExpressionError(
                    f"{place}: exponents of at most {EXPONENT} are wanted, {power} came"
                )
        used |= expression.free_symbols if isinstance(expression, sp.Expr) else set()
    for symbol in sorted(known - used, key=str):
        raise ExpressionError(f"{kernel.name}: the input {symbol} occurs in no output")


def _expressions(kernel: ExpressionKernel) -> Iterator[tuple[str, sp.Basic]]:
    """What symbols are looked for in, with its place."""
    for number, each in enumerate(kernel.conditions, 1):
        place = f"{kernel.name}: condition {number}"
        _require_line(place, each.meaning)
        if each.within is not None and len(each.within) != 2:
            raise ExpressionError(f"{place}: within should be two texts, {each.within!r} came")
        for text in (*((each.single,) if each.single else ()), *(each.within or ())):
            require_number(place, text)
        try:
            asked((each,))
        except ExpressionError as error:
            raise ExpressionError(f"{place}: {error}") from None
        yield place, relation_of(each)
    for output in kernel.outputs:
        place = f"{kernel.name}: {output.quantity.name}"
        yield place, _expression(place, output)


def require_number(place: str, text: object) -> Fraction:
    """The number that a text says; ExpressionError for what is none."""
    try:
        # an exponent of more digits is of no format, and its power of ten fills the memory
        if isinstance(text, str) and len(text.lower().partition("e")[2].strip("+-0 ")) <= 4:
            return Fraction(text)
    except (ValueError, ZeroDivisionError):
        pass
    raise ExpressionError(f"{place}: an end of a domain is a number as text, {text!r} came")


def _expression(place: str, output: Result) -> sp.Expr:
    try:
        found = sp.sympify(output.expression, strict=True)
    except sp.SympifyError:
        found = None
    if found is None or not isinstance(found, sp.Expr) or found.is_Matrix:
        raise ExpressionError(f"{place}: an expression is wanted, {output.expression!r} came")
    return found


def _require_name(what: str, name: str, pattern: re.Pattern[str] = NAME) -> None:
    fits = pattern.fullmatch(name) and not keyword.iskeyword(name) and not PARTS.fullmatch(name)
    if not fits or name in TAKEN or len(name) > 50:
        raise ExpressionError(
            f"{what}: a name in small letters, digits and single underscores that is not taken is "
            f"wanted, {name!r} came"
        )


def _require_line(place: str, text: str) -> None:
    if not text.strip() or "\n" in text or '"' in text or "\\" in text:
        raise ExpressionError(f"{place}: a line of text without quotes is wanted, {text!r} came")


def _require_different(what: str, names: Sequence[str] | Iterable[str]) -> None:
    listed = list(names)
    for name in listed:
        if listed.count(name) > 1:
            raise ExpressionError(f"{what}: two are called {name}")
