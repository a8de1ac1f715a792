"""Arguments at which kernels are timed."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from gainproof.bench.compiler import Arrays
from gainproof.generated._signature import Domain, Required, Signature

Arguments = Sequence[NDArray[np.float64] | float]
TRIES = 20
"""How often arguments that do not fit together are drawn again."""


def sample(signature: Signature, size: int) -> Arrays:
    """As many arguments inside the domain: parameters from 1e-6 to 1e6, gains, sample numbers;
    states and gains of either sign up to 1e3. What inputs must fulfil together they do.
    """
    generator = np.random.default_rng(20)
    given = [_arguments(domain, size, generator) for domain in signature.inputs]
    for required in signature.required:
        for _ in range(TRIES):
            missed = _missing(required, given)
            for column, domain in zip(given, signature.inputs, strict=True):
                column[missed] = _arguments(domain, missed.size, generator)
    return given


def with_constants(
    signature: Signature, given: Arrays, prefix: str | None, numbers: int = 1
) -> Arguments:
    """The arguments, those whose names begin with the prefix one number each.

    Of several `numbers` each stands with each of the others: these are rows, fewer by as many.
    """
    few = [prefix is not None and domain.name.startswith(prefix) for domain in signature.inputs]
    if prefix is None or numbers == 1:
        return [float(x[0]) if fixed else x for x, fixed in zip(given, few, strict=True)]
    rows = given[0].size // numbers
    return [x[:numbers] if fixed else x[:rows, None] for x, fixed in zip(given, few, strict=True)]


def fitting(signature: Signature, given: Arrays) -> Arrays:
    """Those arguments that fulfil together what they must."""
    for required in signature.required:
        missed = _missing(required, given)
        given = [np.delete(column, missed) for column in given]
    return given


def _missing(required: Required, given: Arrays) -> NDArray[np.intp]:
    """The places where inputs together are not what they must be."""
    value = np.empty_like(given[0])
    work = [np.empty_like(value) for _ in range(required.work)]
    single = value.dtype == np.float32
    with np.errstate(all="ignore"):
        required.block(given, [value], work, bool(single))
    return np.flatnonzero(~(value >= (required.single if single else required.double)))


def _arguments(domain: Domain, size: int, generator: np.random.Generator) -> NDArray[np.float64]:
    low, high = domain.double
    if domain.signed:
        exponents = generator.uniform(-6, min(3.0, math.log10(high)), size)
        return np.asarray(generator.choice([-1.0, 1.0], size) * 10.0**exponents, np.float64)
    if domain.whole:
        return np.asarray(generator.integers(int(max(low, 3)), 10**6, size), np.float64)
    if high > 10:
        least, most = max(low, 1e-6), min(high, 1e6)
        drawn = 10.0 ** generator.uniform(math.log10(least), math.log10(most), size)
        return np.asarray(np.clip(drawn, least, most), np.float64)
    return generator.uniform(low + 0.001 * (high - low), high - 0.001 * (high - low), size)
