"""Kernels over arrays of one library of the array API standard: that library computes.

Every input is looked at before anything is returned, which waits for what a device or a scheduler
still computes.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import reduce
from operator import and_
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from gainproof.generated._inputs import common_shape
from gainproof.generated._signature import Domain

Real: TypeAlias = Any
"""An array, of whichever library, or a number."""
NUMBERS = (int, float, np.integer, np.floating)


class Slope(NamedTuple):
    """What is the derivative of an output by an input: `sign` times an output of another kernel."""

    output: str
    given: str
    kernel: Kernel
    slope: str
    sign: int


@dataclass(frozen=True, eq=False)
class Kernel:
    """`compute(*inputs, form)` returns what the inputs fulfil together, with the domains `required`
    of it, and the outputs. `only`: the one type of inputs and results.
    """

    name: str
    inputs: tuple[Domain, ...]
    required: tuple[Domain, ...]
    result: Any
    compute: Callable[..., Sequence[Any]]
    only: str = ""
    slopes: Callable[[], tuple[Slope, ...]] = tuple


class Form:
    """The functions of a library, for arrays of one type."""

    def __init__(self, library: Any, single: bool, device: Any = None) -> None:
        self.library, self.single = library, single
        self._device = {} if device is None else {"device": device}

    def __getattr__(self, name: str) -> Any:
        return getattr(self.library, name)

    def of(self, x: Any) -> Any:
        """A number as an array without axes."""
        kind = self.library.float32 if self.single else self.library.float64
        return self.library.asarray(x, dtype=kind, **self._device)

    def near_cbrt(self, x: Any) -> Any:
        """A start of a cube root: the standard knows no bits of numbers, and the root will do."""
        return x ** (1 / 3)


def evaluate(kernel: Kernel, given: Sequence[Any]) -> Any:
    """The result of a kernel, arrays of the inputs' common shape, library and device.

    TypeError for what is no array of one library of the standard, of real numbers, or a number;
    ValueError for inputs outside their domain, and for shapes that do not broadcast.
    """
    form, inputs = _arrays(kernel, given)
    shape = shape_of(kernel, inputs)
    whole = [form.broadcast_to(x, shape) for x in inputs]
    with np.errstate(all="ignore"):
        values = kernel.compute(*whole, form)
    count = len(kernel.required)
    if not bool(form.all(admitted(kernel, whole, values, form))):
        raise ValueError(refusal(kernel, inputs, values, form))
    return kernel.result(*(_own(y, whole, form) for y in values[count:]))


def shape_of(kernel: Any, inputs: Sequence[Any]) -> tuple[int, ...]:
    """To which arrays of any library broadcast; ValueError where they do not."""
    return common_shape(kernel, inputs)


def admitted(kernel: Kernel, inputs: Sequence[Any], values: Sequence[Any], form: Form) -> Any:
    """Where the inputs lie in their domains and fulfil what they must together."""
    each = zip((*kernel.inputs, *kernel.required), (*inputs, *values), strict=False)
    return reduce(and_, (_inside(domain, x, form) for domain, x in each))


def refusal(kernel: Kernel, inputs: Sequence[Any], values: Sequence[Any], form: Form) -> str:
    """What is wrong at the first place where something is, in the words of the NumPy kernels."""
    shape = shape_of(kernel, inputs)
    found = []
    for domain, x in zip((*kernel.inputs, *kernel.required), (*inputs, *values), strict=False):
        fine = form.broadcast_to(_inside(domain, x, form), shape)
        if bool(form.all(fine)):
            continue
        wrong = form.where(form.reshape(fine, (-1,)), form.of(0.0), form.of(1.0))
        place = int(form.argmax(wrong))
        index = tuple(int(i) for i in np.unravel_index(place, shape))
        own = index[len(shape) - x.ndim :]
        own = tuple(i if n > 1 else 0 for i, n in zip(own, x.shape, strict=True))
        came = (np.float32 if form.single else np.float64)(float(x[own]))
        where = f" at index {own[0] if len(own) == 1 else own}" if own else ""
        text = f"{kernel.name}: {domain.name} must be {domain.wanted}, got {came!s}{where}"
        found.append((place, text))
    return min(found, key=lambda each: each[0])[1]


def require_type(kernel: Kernel, name: str, kind: str) -> None:
    """TypeError unless a type is one of those that kernels compute with."""
    if kind not in ("float64", "float32"):
        raise TypeError(
            f"{kernel.name}: {name} must be real numbers of type float64 or float32, or integers "
            f"of at most 64 bits, got {kind}"
        )


def require_only(kernel: Kernel, kind: str) -> None:
    """TypeError unless the type of all inputs is the only one that a kernel has."""
    if kernel.only and kind != kernel.only:
        told = ", ".join(f"{domain.name} {kind}" for domain in kernel.inputs)
        raise TypeError(
            f"{kernel.name}: only {kernel.only} is here, and inputs must be of it, got {told}"
        )


def _inside(domain: Domain, x: Any, form: Form) -> Any:
    """Where numbers lie in a domain; comparisons with NaN are false."""
    low, high = domain.single if form.single else domain.double
    size = abs(x) if domain.signed else x
    fine = (size >= low) & (size <= high)
    if domain.zero:
        fine = fine | (x == 0)
    return fine & (x == form.floor(x)) if domain.whole else fine


def _arrays(kernel: Kernel, given: Sequence[Any]) -> tuple[Form, list[Any]]:
    """The library of the inputs, and these as its arrays of one type."""
    libraries = []
    for domain, x in zip(kernel.inputs, given, strict=True):
        if isinstance(x, NUMBERS) and not isinstance(x, bool):
            continue
        library = _library(x)
        if library is None:
            raise TypeError(
                f"{kernel.name}: {domain.name} must be an array of a library of the array API "
                f"standard, or a number beside one, got {type(x).__name__} of "
                f"{type(x).__module__.partition('.')[0]}"
            )
        libraries.append((x, library, domain.name))
    if len({library.__name__ for _, library, _ in libraries}) != 1:
        told = ", ".join(f"{name} {library.__name__}" for _, library, name in libraries)
        raise TypeError(
            f"{kernel.name}: inputs must be arrays of one library, got {told or 'numbers alone'}"
        )
    first, library, _ = libraries[0]
    singles = []
    for x, _, name in libraries:
        if not library.isdtype(x.dtype, "integral"):
            singles.append(x.dtype == library.float32)
            known = singles[-1] or x.dtype == library.float64
            require_type(kernel, name, "float64" if known else str(x.dtype))
    form = Form(library, bool(singles) and all(singles), getattr(first, "device", None))
    kind = library.float32 if form.single else library.float64
    require_only(kernel, "float32" if form.single else "float64")
    numbers = [form.of(x) if isinstance(x, NUMBERS) else x for x in given]
    return form, [x if x.dtype == kind else library.astype(x, kind) for x in numbers]


def _library(x: Any) -> Any:
    """The functions for an array, by itself or by array-api-compat where that is installed; None
    for what is none, and for subclasses of NumPy's, which may hold a mask or a unit.
    """
    if isinstance(x, np.ndarray) and type(x) is not np.ndarray:
        return None
    own = getattr(x, "__array_namespace__", None)
    if own is not None:
        return own()
    try:
        from array_api_compat import array_namespace
    except ImportError:
        return None
    try:
        return array_namespace(x)
    except TypeError:
        return None


def _own(y: Any, whole: Sequence[Any], form: Form) -> Any:
    """An output as an array of its own: of a constant, or where it is an input."""
    if isinstance(y, float):
        return form.broadcast_to(form.of(y), whole[0].shape)
    return form.asarray(y, copy=True) if any(y is x for x in whole) else y
