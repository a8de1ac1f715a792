"""One kernel measured: the seconds of its calls and of all that it is compared with, its errors."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from gainproof.bench import rivals
from gainproof.bench.arguments import Arguments, sample, with_constants
from gainproof.bench.compiler import Arrays, compiled, compiler, library
from gainproof.bench.errors import OutputError, worst_errors
from gainproof.bench.memory import touched
from gainproof.bench.one_number import seconds_of_numbers
from gainproof.bench.solver import solver_seconds
from gainproof.bench.subjects import Measured
from gainproof.bench.timing import best_times
from gainproof.derive.printer.c_language.loop import c_loop
from gainproof.derive.printer.c_language.module import c_function, c_loops
from gainproof.derive.printer.library_functions import functions_of
from gainproof.generated._blocks import BLOCK, Parts, cut, rows
from gainproof.generated._runtime import evaluate, with_arrays
from gainproof.standalone.in_c._compiled import FLAGS, best_instructions, functions, in_c

SIZE = 1_000_000
THOUSAND, REPEATED = 1000, 100
"""Points of a shorter call, and how often it is repeated at a time."""
SECONDS = 1.0
"""How long one call is repeated at most."""
COMPILED = ("C", "C function")
IN_C = ("in C", "in C shared", "thousand in C")
THREADED = ("shared", "in C shared", "JAX")
"""Calls that threads share: the time that passes, of all others that of the one thread."""

Calls = dict[str, Callable[[], object]]
Evaluate = Callable[[Arguments, tuple[Any, ...], int], object]


@dataclass(frozen=True)
class Options:
    """How is measured: threads, inputs of one number or a few, and whether numexpr, Numba and JAX
    are asked too.
    """

    workers: int = 2
    constant: str | None = None
    numbers: int = 1
    every_rival: bool = False


@dataclass(frozen=True)
class Figures:
    """Best seconds for a million points by call, why others are missing, and the errors.

    kernel: fills given arrays; shared: the same with threads; fresh: makes its own arrays, as
    lambdify does; passes: the bare NumPy calls on one block that stays in the cache, without guards
    and memory traffic, which no NumPy kernel of this graph can beat in one thread; memory: the
    arrays read and filled once; C: a bare loop of the graph; C function: the one that is shipped,
    which looks at all inputs first as the kernel does; in C, in C shared: the kernel of a package
    that is compiled, without and with threads; thousand, thousand in C: a thousand points a call,
    of the kernel and of a compiled one; lambdify, numexpr, Numba, JAX: the textbook
    form; SciPy: its Riccati solver, a call a point; one number, formula: the kernel and the plain
    Python formula of its graph, a call a point.
    """

    seconds: Mapping[str, float]
    missing: Mapping[str, str]
    errors: tuple[OutputError, ...]

    def ratio(self, one: str, other: str) -> float | None:
        """One's time over the other's; None where one of them is missing."""
        if one not in self.seconds or other not in self.seconds:
            return None
        return self.seconds[one] / self.seconds[other]

    @property
    def outside(self) -> list[str]:
        """The outputs of which an error was greater than is proved."""
        return [each.name for each in self.errors if each.outside]


def figures(item: Measured, folder: Path, options: Options) -> Figures:
    """Measure one kernel; `folder` is for what is compiled."""
    columns = sample(item.signature, SIZE)
    given = with_constants(item.signature, columns, options.constant, options.numbers)
    shape = np.broadcast_shapes(*map(np.shape, given))
    outputs = tuple(np.empty(shape) for _ in item.kernel.outputs)
    calls: Calls = {
        "kernel": lambda: item.function(*given, out=outputs),
        "shared": lambda: item.function(*given, out=outputs, workers=options.workers),
        "fresh": lambda: item.function(*given),
        "passes": bare_passes(item, given),
        "memory": touched(given, outputs),
    }
    missing: dict[str, str] = {}
    kernel_in_c: Evaluate | None = None
    if options.constant is not None:
        missing |= dict.fromkeys(COMPILED, "arrays only: beside numbers it would be told too slow")
    elif compiler() is None:
        missing |= dict.fromkeys(COMPILED, "no compiler")
    else:
        calls |= _c_calls(item, columns, folder)
    if compiler() is None:
        missing |= dict.fromkeys(IN_C, "no compiler")
    elif functions_of(item.kernel.program, item.kernel.program.outputs.values()):
        missing |= dict.fromkeys(IN_C, "calls functions of math.h, which may round otherwise")
    else:
        computed = kernel_in_c = _in_c(item, folder)
        calls |= {
            "in C": lambda: computed(given, outputs, 1),
            "in C shared": lambda: computed(given, outputs, options.workers),
        }
    with np.errstate(all="ignore"):  # textbook forms cancel, divide by zero and overflow
        if item.textbook is not None:
            _add_rivals(calls, missing, item, given, folder, options.every_rival)
        seconds = best_times(calls, seconds=SECONDS, threaded=THREADED)
    seconds |= _seconds_of_a_thousand(item, columns, kernel_in_c)
    for name, a_call in seconds_of_numbers(item, columns, folder).items():
        seconds[name] = a_call * SIZE
    if item.model is not None:
        a_point = solver_seconds(item.model, [each.name for each in item.kernel.inputs])
        if a_point is not None:
            seconds["SciPy"] = a_point * SIZE
    return Figures(seconds, missing, worst_errors(item))


def _c_calls(item: Measured, columns: Arrays, folder: Path) -> Calls:
    # a library of its own for each kernel: the loader knows libraries by their path
    place = folder / item.subject
    loop = compiled(c_loop(item.kernel), item.kernel.name, place)
    function = compiled(*c_function(item.kernel, item.bound), place, guarded=True)
    targets = [np.empty(SIZE) for _ in item.kernel.outputs]
    return {"C": lambda: loop(columns, targets), "C function": lambda: function(columns, targets)}


def _in_c(item: Measured, folder: Path) -> Evaluate:
    """The kernel as in a package after `python -m PACKAGE.compile`."""
    source, name = c_loops(item.kernel, item.bound)
    loops = library(source, name, folder / item.subject / "in_c", FLAGS)
    count = len(item.kernel.inputs) + len(item.kernel.outputs)
    found = functions(loops, name, count, best_instructions(loops))
    compiled = in_c(item.signature.block, *found)
    return partial(evaluate, item.signature, compiled=compiled)


def _seconds_of_a_thousand(
    item: Measured, columns: Arrays, kernel_in_c: Evaluate | None
) -> dict[str, float]:
    """Seconds for a million points where a call has a thousand of them."""
    given = [column[:THOUSAND] for column in columns]
    outputs = tuple(np.empty(THOUSAND) for _ in item.kernel.outputs)

    def repeated(call: Callable[[], object]) -> Callable[[], object]:
        return lambda: deque((call() for _ in range(REPEATED)), maxlen=0)

    calls = {"thousand": repeated(lambda: item.function(*given, out=outputs))}
    if kernel_in_c is not None:
        calls["thousand in C"] = repeated(lambda: kernel_in_c(given, outputs, 1))
    times = best_times(calls, seconds=SECONDS)
    return {name: taken * SIZE / (REPEATED * THOUSAND) for name, taken in times.items()}


def _add_rivals(
    calls: Calls,
    missing: dict[str, str],
    item: Measured,
    given: Arguments,
    folder: Path,
    every: bool,
) -> None:
    plain = rivals.lambdified(item)
    calls["lambdify"] = lambda: plain(*given)
    if not every:
        return
    made: dict[str, Callable[[], Callable[[], object]]] = {
        "numexpr": lambda: rivals.with_numexpr(item, given),
        "Numba": lambda: rivals.with_numba(item, given, folder),
        "JAX": lambda: rivals.with_jax(item, given),
    }
    for name, make in made.items():
        try:
            calls[name] = make()
        except rivals.UnfitError as error:
            missing[name] = str(error)


def bare_passes(item: Measured, given: Arguments) -> Callable[[], object]:
    """The block function of a kernel, run on one block as often as a million points need."""
    inputs = [np.asarray(each) for each in given]
    blocks = cut(inputs, np.broadcast_shapes(*(x.shape for x in inputs)), BLOCK)
    parts, length = Parts(blocks).all(*blocks.spans[0]), blocks.length
    given_back = len(item.kernel.outputs)
    buffers = rows(given_back + item.signature.work, length, np.dtype(np.float64))
    outputs, work = buffers[:given_back], buffers[given_back:]
    block = with_arrays(item.signature.block, outputs[0].dtype)

    def call() -> None:
        for _ in range(SIZE // length):
            block(parts, outputs, work, False)

    return call
