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
from gainproof.derive.printer.library import functions_of

DEFAULT = ("random-acceleration", "filter-step")
"""What takes least time; starts of cube roots and requirements are in a kernel by hand."""
SUBJECTS = [
    pytest.param(entry, marks=() if entry.name in DEFAULT else pytest.mark.thorough, id=entry.name)
    for entry in CATALOGUE
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
    """Columns of arguments of the type, each in its domain and together as they must be."""
    columns = [column.astype(kind) for column in sample(signature, size)]
    kept = np.ones(size, bool)
    for domain, column in zip(signature.inputs, columns, strict=True):
        low, high = domain.single if kind is np.float32 else domain.double
        magnitude = np.abs(column) if domain.signed else column
        kept &= ((magnitude >= low) & (magnitude <= high)) | (domain.zero & (column == 0))
    return fitting(signature, [column[kept] for column in columns])


@pytest.mark.parametrize("entry", SUBJECTS)
def test_the_bits_are_those_of_numpy(
    entry: Any, tmp_path: Path, request: pytest.FixtureRequest
) -> None:
    module = entry.build().module
    loaded = library(module, [domains_only(module, each) for each in module.kernels], tmp_path)
    size = 1_000_000 if request.config.getoption("-m") == "thorough" else 5_000
    for kernel in module.kernels:
        found = shipped(module, kernel)
        for kind in (np.float64, np.float32):
            given = drawn(found.signature, size, kind)
            assert given[0].size > size / 2
            code, first, outputs = call_arrays(loaded, module, kernel, given)
            assert (code, first) == (0, -1), kernel.name
            mine = found.function(*given)
            for output, ours, theirs in zip(kernel.outputs, mine, outputs, strict=True):
                end = kernel.program.outputs[output.name]
                if functions_of(kernel.program, [end]):
                    continue
                same = ours.view(np.uint8) == theirs.view(np.uint8)
                assert same.all(), (kernel.name, output.name, kind)
