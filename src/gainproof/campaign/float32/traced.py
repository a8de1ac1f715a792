"""What a block function computes, told by running it on names in the place of numbers."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from types import FunctionType
from typing import Any

import numpy as np

OURS = ("mask_of", "choose", "near_cbrt")
"""Functions of `_bits` that blocks call, which look at the bits of arrays."""


class Traced:
    """An array that knows what was computed for it; `formula` is a digest of that.

    A buffer that is filled again has another formula from then on: what reads a value too late, or
    in the wrong place, computes something else.
    """

    def __init__(self, formula: str) -> None:
        self.formula = formula

    def __array_ufunc__(
        self, function: np.ufunc, method: str, *operands: Any, out: tuple[Traced, ...] = ()
    ) -> Any:
        known = getattr(np, function.__name__, None) is function
        if method != "__call__" or function.nout != 1 or not known:
            return NotImplemented
        return _filled(function.__name__, operands, out[0] if out else Traced(""))

    def __array_function__(
        self, function: Callable[..., Any], _types: Any, given: Any, options: Any
    ) -> Any:
        if function is not np.copyto or options:
            return NotImplemented
        given[0].formula = _formula(given[1])
        return None


def computed(signature: Any, single: bool) -> str:
    """The formulas of a kernel's outputs in float32 or float64.

    Where values are kept between the steps, and how NumPy is called, does not count. TypeError or
    AttributeError where a block does more than to call functions of NumPy with one result, or calls
    ours for the other type.
    """
    block = signature.block
    recorded = {name: _recorder(name, single) for name in OURS}
    names = block.__globals__ | recorded
    traced = FunctionType(block.__code__, names, None, block.__defaults__, block.__closure__)
    given = [Traced(f"input {place}") for place in range(len(signature.inputs))]
    out = [Traced("an output, not filled yet") for _ in signature.outputs]
    traced(given, out, [Traced("a buffer, not filled yet") for _ in range(signature.work)], single)
    return " ".join(each.formula for each in out)


def _filled(name: str, operands: Any, out: Traced) -> Traced:
    """The array to be filled with what a function of this name gives."""
    text = f"{name}({', '.join(map(_formula, operands))})"
    out.formula = hashlib.sha256(text.encode()).hexdigest()
    return out


def _formula(x: Any) -> str:
    return x.formula if isinstance(x, Traced) else repr(float(x))


def _recorder(name: str, single: bool) -> Callable[..., Traced]:
    def of_type(said: bool) -> str:
        if said is not single:
            raise TypeError(f"{name} is called for the other type")
        return name

    if name == "mask_of":
        return lambda condition, said: _filled(of_type(said), [condition], Traced(""))
    if name == "choose":
        return lambda mask, x, y, out: _filled(name, [mask, x, y], out)
    return lambda x, out, said: _filled(of_type(said), [x], out)
