"""The measure of a kernel's results in C, compiled on this machine."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from gainproof.bad_input import BadInputError
from gainproof.bench.compiler import FLAGS, compiler
from gainproof.campaign.float32.c_text import c_text
from gainproof.campaign.float32.kernels import Swept
from gainproof.campaign.float32.reference import Compared, reference
from gainproof.campaign.float32.tally import EPSILON, LARGE, SMALL, Singles, Tally
from gainproof.derive.printer.kernel import Kernel

Measure = Callable[..., object]


class Compiled:
    """What is measured of some inputs after others."""

    def __init__(self, measure: Measure, outputs: Sequence[Compared]) -> None:
        self.measure, self.outputs = measure, outputs
        count = len(outputs)
        self.rows = np.array([(each.value, each.scale) for each in self.outputs], np.uintp)
        self.ends = np.array([(each.lowest, each.highest) for each in self.outputs])
        self.edges = np.array([SMALL, LARGE])
        self.found = np.tile([-1.0, 0.0, 0.0], (count, 1))
        self.counts = np.zeros((count, 2), np.int64)

    def add(self, x: Singles, results: Sequence[Singles]) -> None:
        """Inputs in their order, and the results of each output."""
        held = [np.ascontiguousarray(each, np.float32) for each in (x, *results)]
        pointers = (ctypes.c_void_p * len(results))(*(each.ctypes.data for each in held[1:]))
        arrays = (self.rows, self.ends, self.edges, self.found, self.counts)
        self.measure(
            ctypes.c_size_t(x.size),
            ctypes.c_void_p(held[0].ctypes.data),
            ctypes.c_size_t(len(results)),
            pointers,
            *(ctypes.c_void_p(each.ctypes.data) for each in arrays),
        )

    def tallies(self) -> dict[str, Tally]:
        """Of each output."""
        found: dict[str, Tally] = {}
        for output, (worst, at, ulp), (outside, other) in zip(
            self.outputs, self.found.tolist(), self.counts.tolist(), strict=True
        ):
            found[output.name] = {
                "worst": max(worst, 0.0) / EPSILON,
                "at": None if worst < 0 else at,
                "ulp": ulp / EPSILON,
                "outside": outside,
                "undocumented": other,
            }
        return found


@cache
def measure(swept: Swept) -> Measure:
    """That of a swept kernel."""
    return measure_of(reference(swept).kernel)


def measure_of(kernel: Kernel) -> Measure:
    """The function `measure` of `c_text` for a kernel, compiled.

    Raises BadInputError where the compiler refuses it.
    """
    command = compiler()
    if command is None:
        raise FileNotFoundError("no C compiler: cc, gcc or clang is wanted")
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
