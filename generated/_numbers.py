"""Kernels of single numbers: numbers for numbers, with the bits of the arrays' path and in a
hundredth of its time.

Only what is plainly in order is computed here. Everything else, what is to be refused above all,
goes the way of arrays, which alone has messages.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from struct import Struct
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

import numpy as np

if TYPE_CHECKING:
    from gainproof.generated._signature import Array, Block, Signature

Result = TypeVar("Result", bound=tuple[Any, ...])

ONE = 1
"""How many threads there are where nothing is said. A kernel asks whether it `is` this number: 1.0
equals it, and is refused.
"""
named: Callable[[type[Result], Iterable[Any]], Result] = tuple.__new__
"""A result of this class from its values, which are as many as it has fields."""
INTEGERS = (np.int8, np.int16, np.int32, np.int64, np.uint8, np.uint16, np.uint32, np.uint64)
DOUBLES = frozenset({float, int, np.float64, np.float32, *INTEGERS})
"""What becomes float64, unless all are float32; other types are for arrays to decide."""
PYTHONS = frozenset({float, int})
"""What gives Python floats; with a number of NumPy's among the inputs results are NumPy's too."""
_DOUBLE, _SINGLE = (Struct("<d"), Struct("<q")), (Struct("<f"), Struct("<i"))


def _near_cbrt(x: float, form: tuple[Struct, Struct], added: int) -> float:
    """As `near_cbrt` of an array has it: a third of the bits, and more."""
    number, whole = form
    (bits,) = whole.unpack(number.pack(x))
    (near,) = number.unpack(whole.pack(bits // 3 + added))
    return float(near)


class Double:
    """Functions of float64 numbers, Python's own; those of NumPy's library have its bits, and may
    warn.
    """

    single = False
    of: Callable[[Any], Any] = float
    sqrt: Callable[[float], float] = math.sqrt
    near_cbrt: Callable[[float], float] = lambda x: _near_cbrt(x, _DOUBLE, 3071306327078975046)
    sin: Callable[[float], float] = lambda x: float(np.sin(x))
    cos: Callable[[float], float] = lambda x: float(np.cos(x))
    exp: Callable[[float], float] = lambda x: float(np.exp(x))
    expm1: Callable[[float], float] = lambda x: float(np.expm1(x))
    log1p: Callable[[float], float] = lambda x: float(np.log1p(x))
    atan2: Callable[[float, float], float] = lambda y, x: float(np.arctan2(y, x))
    hypot: Callable[[float, float], float] = lambda x, y: float(np.hypot(x, y))


class Single:
    """Functions of float32 numbers of NumPy, whose operators round as arrays do; a Python float
    beside one of them becomes float32 first.
    """

    single = True
    of: Callable[[Any], Any] = np.float32
    sqrt: Callable[[float], float] = np.sqrt
    near_cbrt: Callable[[float], Any] = lambda x: np.float32(_near_cbrt(x, _SINGLE, 709958653))
    sin: Callable[[float], float] = np.sin
    cos: Callable[[float], float] = np.cos
    exp: Callable[[float], float] = np.exp
    expm1: Callable[[float], float] = np.expm1
    log1p: Callable[[float], float] = np.log1p
    atan2: Callable[[float, float], float] = np.arctan2
    hypot: Callable[[float, float], float] = np.hypot


Form: TypeAlias = type[Double] | type[Single]


def of_numbers(kernel: Signature, given: Sequence[Any]) -> tuple[Any, ...] | None:
    """The outputs where all inputs are numbers inside their domains, else None.

    Python's numbers give Python floats; with a number of NumPy's among them they are float64, and
    float32 where all inputs are. No warning of NumPy escapes.
    """
    kinds = set(map(type, given))
    single = kinds == {np.float32}
    if kernel.numbers is None or not (single or kinds <= DOUBLES):
        return None
    if kernel.only and single != (kernel.only == "float32"):
        return None
    if int in kinds and not all(type(x) is not int or -(2**63) <= x < 2**64 for x in given):
        return None  # no integer of NumPy's
    doubles = list(map(float, given))
    for domain, x in zip(kernel.inputs, doubles, strict=True):
        _, _, double_ends, single_ends, whole, zero, signed = domain
        low, high = single_ends if single else double_ends
        inside = low <= (abs(x) if signed else x) <= high or (zero and x == 0)
        if not inside or (whole and not x.is_integer()):
            return None
    try:
        if single:
            with np.errstate(all="ignore"):
                return tuple(map(np.float32, kernel.numbers(*given, Single)))
        found = kernel.numbers(*doubles)
        return tuple(found if kinds <= PYTHONS else map(np.float64, found))
    except (ArithmeticError, ValueError):
        return None


def filled_by(numbers: Callable[..., Sequence[Any]]) -> Block:
    """A block that computes with arrays what a function computes with numbers."""

    def block(given: Sequence[Array], out: Sequence[Array], _: Any, single: bool) -> None:
        found = numbers(*given, Single if single else Double)
        for result, value in zip(out, found, strict=True):
            result[...] = value

    return block
