"""The domains of a NumPy module: each is a constant that all kernels of the same domain share."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.docstring import wanted_text
from gainproof.derive.printer.double_word.domain import accurate_domain
from gainproof.derive.printer.kernel import Kernel

DomainLines = tuple[str, ...]
"""The lines of a domain without indentation."""


def kernel_domains(kernel: Kernel, bounds: Sequence[KernelBound]) -> list[DomainLines]:
    """The domain of each input, with the ends of every format that has a bound."""
    found = []
    for place, given in enumerate(kernel.inputs):
        lines = [f'"{given.name}",', f'"{wanted_text(given)}",']
        for bound in bounds:
            least, most = (literal(end) for end in bound.inputs[place])
            lines.append(f"({least}, {most}),")
        lines += ["whole=True,"] if given.integer else []
        lines += ["zero=True,"] if given.zero else []
        lines += ["signed=True,"] if given.signed else []
        found.append(tuple(lines))
    return found


def module_domains(
    kernels: Sequence[Kernel], bounds: Sequence[Sequence[KernelBound]]
) -> dict[DomainLines, str]:
    """Every domain of a module with its name, in the order of their first use."""
    names: dict[DomainLines, str] = {}
    for kernel, pair in zip(kernels, bounds, strict=True):
        for given, domain in zip(kernel.inputs, kernel_domains(kernel, pair), strict=True):
            name = f"_{given.name.upper()}_DOMAIN"
            taken = sum(other.startswith(name) for other in names.values())
            names.setdefault(domain, f"{name}_{taken + 1}" if taken else name)
        if kernel.accurate:
            domain = accurate_domain(kernel.accurate)
            names.setdefault(domain, f"_ACCURATE_{kernel.accurate.name.upper()}_DOMAIN")
    return names


def named_domain(name: str, domain: DomainLines) -> Iterator[str]:
    """The constant that holds a domain."""
    yield f"{name} = Domain("
    yield from (f"    {line}" for line in domain)
    yield ")"
