"""The module of kernels of a subject, of the catalogue or of an own model."""

from __future__ import annotations

from collections.abc import Iterable

import sympy

from gainproof.derive.printer.kernel import Kernel, Module


def catalogue_module(
    name: str, title: str, kernels: Iterable[Kernel], results: str | None = None
) -> Module:
    """The module of the subject `name`, with what made it; `results` as in `Module`."""
    return Module(
        name=name.replace("-", "_"),
        title=f"{title}.",
        command=f"gainproof generate {name}",
        derivation=f"gainproof derive {name}, SymPy {sympy.__version__}",
        kernels=tuple(kernels),
        results=results,
    )
