"""Points at which kernels of signed inputs are measured, and what they promise."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import flint
import numpy as np
from numpy.typing import NDArray

EPSILON = {"float64": 2.0**-52, "float32": 2.0**-23}
BITS = 400
TINY = flint.arb(2) ** -400
PROMISE = re.compile(
    r"(Relative error|Error over the sum of its terms taken positive) at most ([.\d]+) \* 2\^-52 "
    r"\(float64\), ([.\d]+) \* 2\^-23 \(float32\), proved for every input"
    r"(?:, and ([^,]*) beside it where a product underflows)?(?=, provided|\.)"
)


@dataclass(frozen=True)
class Promise:
    """Of one output: bound in epsilon and absolute error beside it, by format; `by_terms`: over the
    sum of its terms taken positive.
    """

    bound: Mapping[str, float]
    beside: Mapping[str, float]
    by_terms: bool


def promises(function: Callable[..., Any]) -> dict[str, Promise]:
    """What a kernel's docstring says of its outputs."""
    text = re.sub(r"\s+", " ", str(function.__doc__)).partition("Numbers and arrays")[0]
    outputs, found = signature(function).outputs, {}
    for name, following in zip(outputs, (*outputs[1:], "$"), strict=True):
        part = text[text.rindex(f" {name}: ") :]
        part = part[: part.rindex(f" {following}: ")] if following != "$" else part
        ((kind, double, single, beside),) = PROMISE.findall(part)
        sizes = {kind: float(size) for size, kind in re.findall(r"(\S+) \((float\d+)\)", beside)}
        found[name] = Promise(
            {"float64": float(double), "float32": float(single)},
            {dtype: sizes.get(dtype, 0.0) for dtype in EPSILON},
            kind != "Relative error",
        )
    return found


def signature(function: Callable[..., Any]) -> Any:
    """The domains and outputs of a kernel."""
    return getattr(sys.modules[function.__module__], f"_{function.__name__.upper()}")


def points(function: Callable[..., Any], dtype: str, count: int, seed: int) -> NDArray[Any]:
    """Points of a kernel's domain, a row for each input.

    Some log-uniform over the whole domain, some ordinary (metres, radians), some at the ends, some
    with zeros, some near quarter turns; those that are refused for being together are left out.
    """
    generator = np.random.default_rng(seed)
    rows = []
    for domain in signature(function).inputs:
        low, high = domain.single if dtype == "float32" else domain.double
        least = low or high / 1e50  # from 0 on: far enough down
        wide = np.exp(generator.uniform(np.log(least), np.log(high), count))
        usual = generator.uniform(0.1, min(high, 1e4), count)
        quarter = np.minimum(high, generator.integers(1, 5, count) * (np.pi / 2))
        near = quarter * (1 + generator.integers(-3, 4, count) * EPSILON[dtype])
        ends = generator.choice([low, high], count)
        chosen = generator.choice(5, count, p=[0.3, 0.4, 0.1, 0.1, 0.1])
        zero = np.zeros(count) if domain.zero else ends
        row = np.choose(chosen, [wide, usual, near, ends, zero]).astype(dtype)
        kind = np.dtype(dtype).type
        row = np.where(row == 0, row, np.clip(row, kind(low), kind(high)))
        if domain.signed:
            row *= generator.choice([-1, 1], count).astype(dtype)
        rows.append(row + 0)  # no zero with a sign
    return allowed(function, np.stack(rows))


def allowed(function: Callable[..., Any], given: NDArray[Any]) -> NDArray[Any]:
    """Those points at which a kernel does not refuse its inputs for what they are together."""
    for required in signature(function).required:
        least = required.single if given.dtype == np.float32 else required.double
        apart = np.empty(given.shape[1])
        work = [np.empty_like(apart) for _ in range(required.work)]
        required.block(list(given.astype(np.float64)), [apart], work, False)
        given = given[:, apart > 1.001 * least]
    return given


def misses(
    function: Callable[..., Any],
    given: NDArray[Any],
    truth: Callable[..., Mapping[str, flint.arb]],
    terms: Callable[..., Mapping[str, flint.arb]] | None = None,
) -> list[str]:
    """Where the kernel's error is above what it promises, in words; `terms` gives the sums of terms
    by which outputs are measured that cancel.
    """
    dtype, said, found = given.dtype.name, promises(function), []
    result = function(*given)
    assert set(said) == set(result._fields), "every output has its promise"
    for at in range(given.shape[1]):
        place = [float(value) for value in given[:, at]]
        true = truth(*place)
        scales = terms(*place) if terms else {}
        for name, promise in said.items():
            value = float(getattr(result, name)[at])
            with flint.ctx.workprec(BITS):
                scale = abs(scales[name] if promise.by_terms else true[name])
                room = scale * promise.bound[dtype] * EPSILON[dtype] + promise.beside[dtype]
                error = abs(flint.arb(value) - true[name])
                # a derivative that is 0 comes from differences as a ball around 0
                within = error <= room or (value == 0 and error <= TINY)
            if not within:
                text = f"{value}, {true[name].str(20)}"
                found.append(f"{function.__name__}.{name} at {place}: {text}")
    return found
