"""What is measured: every shipped kernel with its graph, textbook form and proved bounds."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import sympy as sp

from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.printer.bound import KernelBound, prove
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.signed_inputs import has_signs


@dataclass(frozen=True)
class Measured:
    """One kernel: the shipped function, what it was printed from, and what to compare it with."""

    subject: str
    kernel: Kernel
    function: Callable[..., Any]
    signature: Any
    bound: KernelBound
    textbook: Mapping[str, sp.Expr] | None
    model: Mapping[str, Any] | None


def measured_kernels() -> Iterator[Measured]:
    """Every kernel of the catalogue, in its order, but for those whose inputs have signs."""
    for entry in CATALOGUE:
        subject = entry.build()
        module = import_module(f"gainproof.generated.{subject.module.name}")
        textbook = subject.textbook()
        for kernel in subject.module.kernels:
            if has_signs(kernel):
                continue
            yield Measured(
                subject.name,
                kernel,
                getattr(module, kernel.name),
                getattr(module, f"_{kernel.name.upper()}"),
                prove(kernel, FLOAT64),
                textbook.get(kernel.name),
                subject.model_data,
            )
