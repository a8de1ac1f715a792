"""The comparison in C, compiled on this machine."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gainproof.bad_input import BadInputError
from gainproof.bench.compiler import FLAGS, compiler
from gainproof.campaign.float64.c_text import c_text
from gainproof.derive.printer.kernel import Kernel

Doubles = NDArray[np.float64]
Measure = Callable[..., object]
Tally = dict[str, Any]
EPSILON = 2.0**-52
EDGE = 2.0**-40
"""What rounding may make of a true value next to the ends of the normal numbers, relative."""
EDGES = np.array([2.0**-1022 * (1 + EDGE), (2 - EPSILON) * 2.0**1023 * (1 - EDGE)])


class Compared:
    """What is measured of some inputs after others, with the outputs' names and ends of bounds."""

    def __init__(
        self, measure: Measure, names: Sequence[str], ends: Sequence[tuple[float, float]]
    ) -> None:
        self.measure, self.names = measure, names
        self.ends = np.array(ends)
        self.found = np.tile([-1.0, 0.0, 0.0], (len(names), 1))
        self.counts = np.zeros((len(names), 2), np.int64)

    def add(self, x: Doubles, results: Sequence[Doubles]) -> None:
        """Inputs, and the results of each output."""
        held = [np.ascontiguousarray(each, np.float64) for each in (x, *results)]
        pointers = (ctypes.c_void_p * len(results))(*(each.ctypes.data for each in held[1:]))
        arrays = (self.ends, EDGES, self.found, self.counts)
        self.measure(
            ctypes.c_size_t(x.size),
            ctypes.c_void_p(held[0].ctypes.data),
            pointers,
            *(ctypes.c_void_p(each.ctypes.data) for each in arrays),
        )

    def tallies(self) -> dict[str, Tally]:
        """Of each output: the worst error in units of 2^-52 of the true value, an input where it
        is, the worst in units in the last place; inputs without a bound, and those of them whose
        result is neither 0, subnormal nor infinite.
        """
        found: dict[str, Tally] = {}
        rows = zip(self.names, self.found.tolist(), self.counts.tolist(), strict=True)
        for name, (worst, at, ulp), (outside, undocumented) in rows:
            found[name] = {
                "worst": max(worst, 0.0) / EPSILON,
                "at": None if worst < 0 else at,
                "ulp": ulp,
                "outside": outside,
                "undocumented": undocumented,
            }
        return found


def measure_of(kernel: Kernel) -> Measure:
    """The function `measure` of `c_text` for a kernel.

    Raises BadInputError where there is no compiler, or its long double is no longer than double.
    """
    command = compiler()
    if command is None:
        raise BadInputError("the float64 campaign needs a C compiler: cc, gcc or clang")
    with TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        text, library = Path(folder) / "measure.c", Path(folder) / "measure.so"
        text.write_text(c_text(kernel), encoding="utf-8")
        done = subprocess.run(
            [command, *FLAGS, str(text), "-o", str(library), "-lm"],
            capture_output=True,
            text=True,
            check=False,
        )
        if done.returncode:
            raise BadInputError(f"{command} does not compile {kernel.name}: {done.stderr}")
        found = ctypes.CDLL(str(library)).measure
    found.restype = None
    return found
