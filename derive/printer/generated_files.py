"""Everything that lies in `generated`, as bytes: pure, nothing is written here."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.canonical_json import canonical_json
from gainproof.derive.printer.kernel import Module
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.printer.numpy_results import results_source
from gainproof.derive.printer.numpy_source import printed
from gainproof.derive.printer.package import shared_files


def all_files(
    modules: Sequence[Module], certificates: Mapping[str, Mapping[str, Any]]
) -> dict[str, bytes]:
    """Content by file name: `__init__.py`, code that kernels share, modules, certificates, results.

    `certificates` are by module name. KeyError for a module without one, ValueError for two
    modules of one name, a certificate of no module, or modules that share a file of results and
    differ in them; PrintingError where a bound is not proved.
    """
    names = [module.name for module in modules]
    if len(set(names)) < len(names) or set(certificates) - set(names):
        raise ValueError(f"modules {sorted(names)} and certificates {sorted(certificates)} differ")
    files = shared_files({module.name: module.title for module in modules if module.kernels})
    for module in sorted(modules, key=lambda module: module.name):
        own = module_files(module, certificates[module.name], prove_all(module.kernels))
        for name, text in own.items():
            if files.setdefault(name, text) != text:
                raise ValueError(
                    f"{module.name}: its results differ from those in {module.results}"
                )
    return {name: text.encode("utf-8") for name, text in files.items()}


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
