"""A module of kernels as the text of a typed NumPy module."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain

from gainproof.derive.printer import one_number
from gainproof.derive.printer.arithmetic import Arithmetic, literal
from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.docstring import docstring, wanted_text
from gainproof.derive.printer.double_word.domain import accurate_domain
from gainproof.derive.printer.double_word.refinement import start_is_near
from gainproof.derive.printer.double_word.source import lines as double_word_lines
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.printer.layout import WIDTH, call, listed, row
from gainproof.derive.printer.numpy_results import NAMED, imported_results, result_class
from gainproof.derive.printer.requirements import Printed, requirements

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


def printed(module: Module, bounds: Sequence[Sequence[KernelBound]], only: str = "") -> str:
    """The text of one generated module from bounds already proved, one pair a kernel; `only`: the
    one format that is taken and described.
    """
    for kernel, (first, *_) in zip(module.kernels, bounds, strict=True):
        start_is_near(kernel, first)
    names = [kernel.name for kernel in module.kernels]
    results = [kernel.result for kernel in module.kernels]
    domains = module_domains(module.kernels, bounds)
    arithmetics = [Arithmetic(kernel, names) for kernel in module.kernels]
    needed = [requirements(kernel, names) for kernel in module.kernels]
    numpys: set[str] = set().union(*(each.numpys for each in arithmetics))
    numpys |= set().union(*(each.numpys for each in chain(*needed)))
    accurate = any(kernel.accurate for kernel in module.kernels)
    chooses = any(arithmetic.chooses for arithmetic in arithmetics)
    nears = any(arithmetic.nears for arithmetic in arithmetics)
    bits = (["choose", "mask_of"] if chooses else []) + (["near_cbrt"] if nears else [])
    requires = "Required, " if any(needed) else ""
    numpys |= {"errstate" for kernel in module.kernels if one_number.calls_functions(kernel)}
    ones = ["Double"] if only == "float32" else ["ONE", "Double"]
    ones += ["filled_by"] if accurate else []
    ones += [] if only == "float32" else ["named"]
    lines = [
        f"# Made by: {_one_line(module.command)}",
        f"# From: {_one_line(module.derivation)}",
        f'"""{module.title}."""' if not module.title.endswith(".") else f'"""{module.title}"""',
        "",
        "from __future__ import annotations",
        "",
        "from typing import TYPE_CHECKING",
        "",
        *(["import numpy as np"] if "np" in numpys else []),
        *_imported(sorted(numpys - {"np"})),
        "",
        *([f"from gainproof.generated._bits import {', '.join(bits)}"] if bits else ()),
        f"from gainproof.generated._numbers import {', '.join(ones)}",
        "from gainproof.generated._runtime import evaluate",
        f"from gainproof.generated._signature import Domain, {requires}Signature",
        *(imported_results(module.results, results) if module.results else ()),
        "",
        "if TYPE_CHECKING:",
        *([] if module.results else ["    from typing import NamedTuple", ""]),
        *(["    from gainproof.generated._double_word import Part"] if accurate else []),
        "    from gainproof.generated._numbers import Form",
        "    from gainproof.generated._signature import ArrayLike, Arrays, Real",
        *([] if module.results else NAMED),
        "",
        *_all(results + names),
        "",
        *(line for domain, name in domains.items() for line in named_domain(name, domain)),
    ]
    for kernel, arithmetic, required, pair in zip(
        module.kernels, arithmetics, needed, bounds, strict=True
    ):
        if not module.results:
            lines += ["", "", *result_class(kernel)]
        own = [domains[domain] for domain in kernel_domains(kernel, pair)]
        shown = [bound for bound in pair if only in ("", bound.format.name)]
        lines += ["", "", *_kernel(kernel, arithmetic, required, shown, own, only)]
        if kernel.accurate:
            lines += ["", "", *_accurate(kernel, domains[accurate_domain(kernel.accurate)])]
    return "\n".join(lines) + "\n"


def _one_line(text: str) -> str:
    if "\n" in text:
        raise ValueError(f"a header is one line, got {text!r}")
    return text


def _imported(numpys: Sequence[str]) -> list[str]:
    line = f"from numpy import {', '.join(numpys)}"
    if len(line) > WIDTH:
        return ["from numpy import (", *(f"    {name}," for name in numpys), ")"]
    return [line] if numpys else []


def _all(names: Sequence[str]) -> list[str]:
    return listed("__all__ = [", [f'"{name}"' for name in sorted(names)], "]")


def _kernel(
    kernel: Kernel,
    arithmetic: Arithmetic,
    required: Sequence[Printed],
    bounds: Sequence[KernelBound],
    domains: Sequence[str],
    only: str,
) -> Iterator[str]:
    block, signature = f"_{kernel.name}_block", f"_{kernel.name.upper()}"
    yield from _function(kernel, bounds, signature, only)
    yield from ("", "", *one_number.function(kernel), "", "")
    yield from arithmetic.head(block)
    yield from (f"    {line}" for line in arithmetic.lines)
    for each in required:
        yield from ("", "", *each.function)
    yield from ("", "")
    yield f"{signature} = Signature("
    yield f'    "{kernel.name}",'
    yield from row("    ", domains, ",")
    yield from row("    ", [f'"{output.name}"' for output in kernel.outputs], ",")
    yield f"    {arithmetic.work},"
    yield f"    {block},"
    if required:
        yield "    ("
        for each in required:
            yield from (f"        {line}" for line in each.entry)
        yield "    ),"
    yield from (f'    only="{only}",',) if only else ()
    yield f"    numbers={one_number.function_name(kernel)},"
    yield ")"


def _accurate(kernel: Kernel, domain: str) -> Iterator[str]:
    """The block in double-words and its signature."""
    function, signature = f"_{kernel.name}_in_double_words", _accurate_signature(kernel)
    yield f"def {function}(given: Part, form: Form = Double) -> tuple[Part, ...]:"
    yield from (f"    {line}".rstrip() for line in double_word_lines(kernel))
    yield from ("", "")
    yield f"{signature} = Signature("
    yield f'    "{kernel.name}",'
    yield from row("    ", [domain], ",")
    yield from row("    ", [f'"{output.name}"' for output in kernel.outputs], ",")
    yield "    0,"
    yield f"    filled_by({function}),"
    yield f"    numbers={function},"
    yield ")"


def _accurate_signature(kernel: Kernel) -> str:
    return f"_ACCURATE_{kernel.name.upper()}"


def _function(
    kernel: Kernel, bounds: Sequence[KernelBound], signature: str, only: str
) -> Iterator[str]:
    inputs = [f"{given.name}: ArrayLike" for given in kernel.inputs]
    count = len(kernel.outputs)
    several = ", ".join(["Real"] * count) if count > 1 else "Real,"
    kind = f"tuple[{'Real' if count == 1 else several}]"
    options = ["*", f"out: {kind} | None = None", "workers: int = 1"]
    options += ["accurate: bool = False"] if kernel.accurate else []
    head = f"def {kernel.name}({', '.join(inputs + options)}) -> {kernel.result}:"
    if len(head) <= WIDTH:
        yield head
    else:
        middle = f"    {', '.join(inputs + options)}"
        yield f"def {kernel.name}("
        if len(middle) <= WIDTH:
            yield middle
        else:
            whole = (f"    {line}," for line in inputs + options)
            yield from (x if len(x) <= WIDTH else x.replace("] |", "]\n    |") for x in whole)
        yield f") -> {kernel.result}:"
    text = docstring(kernel, bounds)
    quoted = f'r"""{text}' if "\\" in text else f'"""{text}'
    yield from (f"    {line}".rstrip() for line in (quoted + "\n").splitlines())
    yield '    """'
    if only != "float32":
        yield from (f"    {line}" for line in one_number.call(kernel, bounds[0]))
    if kernel.accurate:
        yield f"    kernel = {_accurate_signature(kernel)} if accurate else {signature}"
        signature = "kernel"
    yield from call(kernel.result, signature, [each.name for each in kernel.inputs])
