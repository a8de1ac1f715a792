"""Points of two inputs at which kernels are compared with enclosures."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from graph_kernels import KINDS, function_of, worst_error

from gainproof.derive.printer.bound import KernelBound, prove
from gainproof.derive.printer.formats import FORMATS, Format
from gainproof.derive.printer.kernel import Kernel

Pair = Mapping[str, float]


def pairs(bound: KernelBound, form: Format, count: int, seed: int) -> list[Pair]:
    """Corners of the domain and their neighbours, random pairs, and pairs on diagonals."""
    generator = np.random.default_rng(seed)
    ends = [[form.ordinal(end) for end in side] for side in bound.inputs]
    spread = generator.random((count, 2))
    spread[count // 2 :, 1] = spread[count // 2 :, 0]  # where both are of one size
    places = [
        tuple(
            first + int((last - first) * part)
            for (first, last), part in zip(ends, row, strict=True)
        )
        for row in spread
    ]
    corners = [(x, z) for x in (*ends[0], ends[0][0] + 1) for z in (*ends[1], ends[1][1] - 1)]
    return [{"x": form.from_ordinal(x), "z": form.from_ordinal(z)} for x, z in [*corners, *places]]


def outside_bounds(kernel: Kernel, count: int, seed: int) -> list[str]:
    """What the printed kernel was measured to do beyond its proved bounds, in words."""
    function = function_of(kernel)
    found = []
    for form in FORMATS:
        proved = prove(kernel, form)
        points = pairs(proved, form, count, seed)
        computed = function(*columns(points, form))
        for row, bound in enumerate(proved.outputs):
            worst, place = worst_error(kernel, computed, row, points)
            if not worst <= float(bound.bound) * form.epsilon:
                found.append(f"{bound.name} ({form.name}) at {place}: {worst / form.epsilon}")
    return found


def columns(points: Sequence[Pair], form: Format) -> list[np.ndarray]:
    """The arguments of a kernel of x and z."""
    return [np.array([point[name] for point in points], KINDS[form.name]) for name in ("x", "z")]
