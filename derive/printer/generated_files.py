"""The files of one module in `generated`: pure, nothing is written here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.canonical_json import canonical_json
from gainproof.derive.printer.kernel import Module
from gainproof.derive.printer.numpy_results import results_source
from gainproof.derive.printer.numpy_source import printed


def module_files(
    module: Module,
    certificate: Mapping[str, Any],
    bounds: Sequence[Sequence[KernelBound]],
    only: str = "",
) -> dict[str, str]:
    """Texts by file name of one module from bounds already proved: itself, its certificate, and its
    results where these are a file of their own; without kernels the certificate alone. `only`: the
    one format that is wanted.
    """
    files = {f"{module.name}.json": canonical_json(certificate)}
    if module.kernels:
        files[f"{module.name}.py"] = printed(module, bounds, only)
    return files | ({f"{module.results}.py": results_source(module)} if module.results else {})
