"""`python -m PACKAGE.compile`: kernels of this package compute in C from then on, the same bits."""

from __future__ import annotations

import argparse
import ctypes
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence, Sized
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from gainproof.standalone.in_c._compiled import (
    FLAGS,
    SOURCES,
    best_instructions,
    functions,
    in_c,
    instructions,
    library,
    load,
    same_bits,
)

if TYPE_CHECKING:
    from gainproof.generated._signature import Array, Arrays, Domain, Signature

POINTS = 20_000
"""Of each kernel and type, at which C and NumPy are compared before the library is put in place."""


KEPT = "no library is put in place"


class CompilingError(Exception):
    """No compiler, or none that makes what is as NumPy has it."""


class DifferentError(CompilingError):
    """A result of C is not NumPy's."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Exit status 0: done; 1: a library is not as NumPy; 2: it cannot be made. What was there
    before stays then.
    """
    parser = argparse.ArgumentParser(
        prog=f"python -m {__package__}.compile",
        description=(
            "Compiles the sources in c/ ($CC, cc, gcc or clang), compares the results with NumPy's "
            "at random points of each domain, and puts the libraries beside the sources: from then "
            "on the kernels compute in C, with the same guards, messages and bits. Those that call "
            "functions of math.h, which may round otherwise, stay NumPy's."
        ),
    )
    instead = parser.add_mutually_exclusive_group()
    instead.add_argument("--remove", action="store_true", help="delete the libraries again")
    instead.add_argument("--show", action="store_true", help="only say what computes in C now")
    options = parser.parse_args(arguments)
    modules = sorted(path.stem for path in SOURCES.glob("*.json"))
    if not modules:
        print(f"{parser.prog}: no sources in {SOURCES}; NumPy computes", file=sys.stderr)
        return 2
    for module in modules:
        try:
            if options.show:
                print(f"{module}: {shown(module)}")
            elif options.remove:
                count = _delete(module)
                print(f"{module}: {count} {'library' if count == 1 else 'libraries'} deleted")
            else:
                print(f"{module}: {compiled(module)}", flush=True)
        except (CompilingError, ValueError) as error:
            print(f"{parser.prog}: {module}: {error}", file=sys.stderr)
            return 1 if isinstance(error, DifferentError) else 2
        except OSError as error:
            reason = error.strerror or error
            print(f"{parser.prog}: {module}: cannot write in {SOURCES}: {reason}", file=sys.stderr)
            return 2
    return 0


def shown(module: str) -> str:
    """Which kernels of a module compute in C where the package is imported now, and the set of
    instructions of their loops.
    """
    same = same_bits(module)
    loaded = load(module) if same else None
    best = best_instructions(loaded) if loaded else "none"
    if best == "none":
        return "all NumPy's"
    others = [each.name for each in _kernels(module) if each.name not in same]
    return f"{_counted(same)} in C, {best}{_others(others)}"


def _counted(kernels: Sized) -> str:
    return f"{len(kernels)} kernel{'' if len(kernels) == 1 else 's'}"


def _others(names: Sequence[str]) -> str:
    return f"; NumPy's stay: {', '.join(names)}" if names else ""


def compiled(module: str) -> str:
    """Make the library of a module and put it in its place; what there is to say of it.

    Raises CompilingError, and OSError where the folder cannot be written.
    """
    same = same_bits(module)
    told = _others([each.name for each in _kernels(module) if each.name not in same])
    if not same:
        return f"nothing to compile{told}"
    place = library(module)
    with tempfile.TemporaryDirectory(dir=SOURCES) as folder:
        made = Path(folder) / place.name
        _compile(SOURCES / f"{module}_numpy.c", made)
        compared = differences(module, ctypes.CDLL(str(made)))
        os.replace(made, place)
    _delete(module, place)
    return f"{_counted(same)} in C, {compared:,} results compared with NumPy's: the same bits{told}"


def differences(module: str, loaded: ctypes.CDLL) -> int:
    """How many results were compared, each with every set of instructions that this processor has.
    Raises DifferentError for the first that is not the same.
    """
    compared, same = 0, same_bits(module)
    versions = instructions(loaded)
    if not versions:
        raise CompilingError(f"this processor has no AVX2, without which NumPy is faster; {KEPT}")
    for kernel in _kernels(module):
        if kernel.name not in same:
            continue
        count = len(kernel.inputs) + len(kernel.outputs)
        for single in (False, True):
            loops = [functions(loaded, same[kernel.name], count, each) for each in versions]
            loops = [found for found in loops if found[single] is not None]
            if not loops:
                continue
            given = points(kernel, single)
            work = [np.empty_like(given[0]) for _ in range(kernel.work)]
            mine = [np.empty_like(given[0]) for _ in kernel.outputs]
            with np.errstate(all="ignore"):
                kernel.block(given, mine, work, single)
            for found in loops:
                theirs = [np.full_like(y, np.nan) for y in mine]
                if not in_c(kernel.block, *found).whole(given, theirs, True, 1):
                    raise DifferentError(f"{kernel.name} refuses in C what NumPy takes; {KEPT}")
                _compare(kernel, given, mine, theirs)
            compared += sum(y.size for y in mine)
    return compared


def _compare(kernel: Signature, given: Arrays, mine: Arrays, theirs: Arrays) -> None:
    for name, x, y in zip(kernel.outputs, mine, theirs, strict=True):
        wrong = np.flatnonzero(x.view(np.uint8) != y.view(np.uint8))
        if wrong.size:
            at = int(wrong[0]) // x.itemsize
            where = ", ".join(str(each[at]) for each in given)
            raise DifferentError(
                f"{kernel.name}({where}) in {x.dtype}: {name} is {y[at]} in C and {x[at]} in "
                f"NumPy: the compiler does not round as the sources ask; {KEPT}"
            )


def points(kernel: Signature, single: bool) -> list[Array]:
    """Random arguments all over the domain, next to its ends too; what inputs must fulfil together
    they do, so that there may be fewer than `POINTS`.
    """
    generator = np.random.default_rng(1)
    given = [_drawn(domain, single, generator) for domain in kernel.inputs]
    for required in kernel.required:
        value = np.empty_like(given[0])
        work = [np.empty_like(value) for _ in range(required.work)]
        with np.errstate(all="ignore"):
            required.block(given, [value], work, single)
        fine = value >= (required.single if single else required.double)
        given = [np.ascontiguousarray(x[fine]) for x in given]
    return given


def _drawn(domain: Domain, single: bool, generator: np.random.Generator) -> Array:
    low, high = domain.single if single else domain.double
    kind = np.float32 if single else np.float64
    # of each binade as many, from below and, for ends such as 1, from above
    exponents = generator.uniform(np.log2(max(low, 2.0**-1074)), np.log2(high), POINTS)
    drawn = np.exp2(exponents)
    if high - low < high / 2 or high <= 2:
        drawn[::2] = high - (high - low) * np.exp2(generator.uniform(-53, 0, drawn[::2].size))
    numbers: Array = np.clip(drawn, low, high).astype(kind)
    numbers[:2] = low, high
    numbers = np.clip(numbers, kind(low), kind(high))
    if domain.whole:
        numbers = np.floor(numbers)
    if domain.signed:
        numbers *= generator.choice([kind(-1), kind(1)], POINTS)
    return numbers


def _kernels(module: str) -> list[Signature]:
    """All kernels of a module, not those in double-words."""
    found = vars(import_module(f".{module}", __package__))
    names: list[str] = [name for name in found["__all__"] if name.islower()]
    return [found[f"_{name.upper()}"] for name in names]


def _compile(source: Path, made: Path) -> None:
    own = shlex.split(os.environ.get("CC", ""))
    command = next(([n] for n in ("cc", "gcc", "clang") if shutil.which(n)), None)
    if own:
        command = own if shutil.which(own[0]) else None
    if command is None:
        found = f"; $CC is {' '.join(own)}" if own else ""
        raise CompilingError(f"needs a C compiler: $CC, else cc, gcc or clang{found}")
    run = [*command, *FLAGS, "-o", str(made), str(source), "-lm"]
    done = subprocess.run(run, capture_output=True, text=True, check=False)
    if done.returncode:
        raise CompilingError(f"{' '.join(run)} fails:\n{done.stdout}{done.stderr}".rstrip())


def _delete(module: str, but: Path | None = None) -> int:
    """Delete the libraries of a module, those of former sources too. How many there were."""
    found = [path for path in SOURCES.glob(f"{module}.*.so") if path != but]
    for path in found:
        path.unlink()
    return len(found)


if __name__ == "__main__":
    sys.exit(main())
