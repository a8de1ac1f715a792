"""What is measured: every shipped kernel with its graph, textbook form and proved bounds."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from typing import Any

import sympy as sp

from gainproof.bad_input import unknown_name
from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.printer.bound import KernelBound, prove
from gainproof.derive.printer.bound_data import bounds_from
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.kernel import Kernel
from gainproof.files import places
from gainproof.subjects import bounds_ledger


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


def subject_names(chosen: Sequence[str] = ()) -> list[str]:
    """All subjects of the catalogue or the chosen, in its order. Raises BadInputError for a subject
    that is none.
    """
    names = [entry.name for entry in CATALOGUE]
    for name in chosen:
        if name not in names:
            raise unknown_name("subject", name, names)
    return [name for name in names if not chosen or name in chosen]


def measured_kernels(
    chosen: Sequence[str] = (), but: Collection[tuple[str, str]] = ()
) -> Iterator[Measured]:
    """Every kernel of the catalogue or of the chosen subjects, in its order, but for those named by
    subject and kernel. Raises BadInputError for a subject that is none.
    """
    names = subject_names(chosen)
    known = bounds_ledger.usable(places.generated_folder())
    for entry in CATALOGUE:
        if entry.name not in names:
            continue
        subject = entry.build()
        if not subject.module.kernels:
            continue
        module = import_module(f"gainproof.generated.{subject.module.name}")
        textbook = subject.textbook()
        entries = known.get(subject.module.name, {})
        for kernel in subject.module.kernels:
            if (subject.name, kernel.name) in but:
                continue
            yield Measured(
                subject.name,
                kernel,
                getattr(module, kernel.name),
                getattr(module, f"_{kernel.name.upper()}"),
                _bound(kernel, entries.get(kernel.name)),
                textbook.get(kernel.name),
                subject.model_data,
            )


def _bound(kernel: Kernel, entry: Any) -> KernelBound:
    """The bound of the ledger, as docstrings have it, or proved now where it has none."""
    return bounds_from(kernel, entry)[0] if entry else prove(kernel, FLOAT64)
