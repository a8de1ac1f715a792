"""Points of a kernel's domain for tests: ends, and seeded ones over all sizes of its inputs."""

from __future__ import annotations

import math
from collections.abc import Iterator
from fractions import Fraction
from random import Random

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.kernel import Input, Kernel

COUNT = 8
"""Seeded points in each format, half of them of ordinary sizes."""
ORDINARY = (1e-3, 1e3)


def points(kernel: Kernel, bound: KernelBound, seed: str) -> Iterator[tuple[float, ...]]:
    """Numbers of the format for all inputs, each point once; the same for the same seed."""
    generator = Random(f"{seed} {kernel.name} {bound.format.name}")
    known = dict.fromkeys(_ends(bound))
    for turn in range(COUNT):
        known |= {
            tuple(
                _drawn(generator, given, ends, bound.format, ordinary=turn % 2 == 0)
                for given, ends in zip(kernel.inputs, bound.inputs, strict=True)
            ): None
        }
    zeros = [0.0 if given.zero else ends[1] for given, ends in _pairs(kernel, bound)]
    if any(given.zero for given in kernel.inputs):
        known |= {tuple(zeros): None}
    yield from known


def _pairs(kernel: Kernel, bound: KernelBound) -> Iterator[tuple[Input, tuple[float, float]]]:
    yield from zip(kernel.inputs, bound.inputs, strict=True)


def _ends(bound: KernelBound) -> Iterator[tuple[float, ...]]:
    """Of one input the ends of its domain and of what is promised; of several two corners."""
    for side in (0, 1):
        yield tuple(ends[side] for ends in bound.inputs)
    if len(bound.inputs) == 1:
        for output in bound.outputs:
            yield (output.lowest,)
            yield (output.highest,)


def _drawn(
    generator: Random, given: Input, ends: tuple[float, float], form: Format, *, ordinary: bool
) -> float:
    """Uniform in the logarithm; next to an end that is excluded as near as to any other number."""
    low, high = max(ends[0], form.least), ends[1]
    if ordinary:
        narrowed = max(low, ORDINARY[0]), min(high, ORDINARY[1])
        low, high = narrowed if narrowed[0] < narrowed[1] else (low, high)
    # log2 of the largest float64 rounds to 1024, whose power is no float
    exponent = generator.uniform(math.log2(low), min(math.log2(high), 1023.999999))
    whole = math.floor(exponent)
    # 2^-1074.. is subnormal: scaled after the power
    size = form.nearest(Fraction(math.ldexp(2.0 ** (exponent - whole), whole)))
    size = min(max(size, low), high)
    size = float(round(size)) if given.integer else size
    return -size if given.signed and generator.random() < 0.5 else size
