"""Kernels of the catalogue in C: the same bits as NumPy's, but where a library rounds."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from c_library import call_arrays, library

from gainproof.bench.arguments import fitting, sample
from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.printer.bound import KernelBound, OutputBound
from gainproof.derive.printer.formats import FORMATS
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.printer.library_functions import functions_of

DEFAULT = ("random-acceleration", "filter-step")
"""What takes least time; starts of cube roots and requirements are in a kernel by hand."""
SUBJECTS = [
    *(pytest.param(e, 5_000, id=e.name) for e in CATALOGUE if e.name in DEFAULT),
    *(
        pytest.param(e, 1_000_000, marks=pytest.mark.thorough, id=f"{e.name}-1e6")
        for e in CATALOGUE
    ),
]


@dataclass(frozen=True)
class Shipped:
    """A kernel as it is shipped."""

    function: Any
    signature: Any


def shipped(module: Module, kernel: Kernel) -> Shipped:
    place = import_module(f"gainproof.generated.{module.name}")
    signature = getattr(place, f"_{kernel.name.upper()}")
    return Shipped(getattr(place, kernel.name), signature)


def domains_only(module: Module, kernel: Kernel) -> tuple[KernelBound, KernelBound]:
    """The domains as shipped; bounds, which nothing computes with, are not proved again."""
    signature = shipped(module, kernel).signature
    double, single = (
        KernelBound(
            form,
            ends := tuple(getattr(domain, kind) for domain in signature.inputs),
            tuple(OutputBound(each.name, Fraction(0), ends, {}) for each in kernel.outputs),
            0,
        )
        for form, kind in zip(FORMATS, ("double", "single"), strict=True)
    )
    return double, single


def drawn(signature: Any, size: int, kind: type[Any]) -> Any:
    """Columns of `size` arguments of the type, each in its domain and together as they must be.

    Domains of float32 are narrower than those that are drawn from: more are drawn until enough
    are in them.
    """
    for times in (1, 2, 4, 8, 16):
        given = fitting(signature, _within(signature, times * size, kind))
        if given[0].size >= size:
            return [np.ascontiguousarray(column[:size]) for column in given]
    raise AssertionError(f"{given[0].size} of {size} arguments of {signature.name}")


def _within(signature: Any, size: int, kind: type[Any]) -> Any:
    """Of as many arguments those in their domains, one by one: what inputs together must fulfil
    is left to `fitting`."""
    columns = [column.astype(kind) for column in sample(signature, size)]
    if len(columns) == 1 and not (signature.inputs[0].whole or signature.inputs[0].signed):
        columns[0][::2] = _everywhere(signature.inputs[0], columns[0][::2].size, kind)
    for place, domain in enumerate(signature.inputs):
        column = columns[place]
        low, high = domain.single if kind is np.float32 else domain.double
        magnitude = np.abs(column) if domain.signed else column
        kept = ((magnitude >= low) & (magnitude <= high)) | (domain.zero & (column == 0))
        columns[place] = column[kept]
    length = min(column.size for column in columns)
    return [column[:length] for column in columns]


def _everywhere(domain: Any, size: int, kind: type[Any]) -> Any:
    """Positive numbers of a whole domain, as many of each power of 2: next to its ends results
    underflow, which C and NumPy have to do alike."""
    whole = np.int32 if kind is np.float32 else np.int64
    ends = domain.single if kind is np.float32 else domain.double
    low, high = np.array(ends, kind).view(whole).tolist()
    return np.random.default_rng(7).integers(low, high + 1, size, whole).view(kind)


@pytest.mark.parametrize(("entry", "size"), SUBJECTS)
def test_the_bits_are_those_of_numpy(entry: Any, size: int, tmp_path: Path) -> None:
    module = entry.build().module
    if not module.kernels:
        pytest.skip("a page without kernels")
    loaded = library(module, [domains_only(module, each) for each in module.kernels], tmp_path)
    compared = 0
    for kernel in module.kernels:
        found = shipped(module, kernel)
        for kind in (np.float64, np.float32):
            given = drawn(found.signature, size, kind)
            code, first, outputs = call_arrays(loaded, module, kernel, given)
            assert (code, first) == (0, -1), kernel.name
            mine = found.function(*given)
            for output, ours, theirs in zip(kernel.outputs, mine, outputs, strict=True):
                end = kernel.program.outputs[output.name]
                if functions_of(kernel.program, [end]):
                    continue
                same = ours.view(np.uint8) == theirs.view(np.uint8)
                assert same.all(), (kernel.name, output.name, kind)
                compared += ours.size
    kernels = len(module.kernels)
    print(  # noqa: T201  the record of a thorough run
        f"{entry.name}: {kernels} kernels, {size} points each, {compared} numbers the same"
    )
