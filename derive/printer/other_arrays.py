"""A module of kernels over arrays of other libraries than NumPy: JAX, or one of the array API
standard. Both have the functions of numbers with choices element by element.

JAX has derivatives besides. XLA takes subnormal numbers for 0: no domain there reaches below the
least normal number.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, ClassVar

from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.bound import Bounds, KernelBound
from gainproof.derive.printer.docstring import described, required_text
from gainproof.derive.printer.emitter import Language
from gainproof.derive.printer.kernel import Kernel, Module, Requirement, least_admitted
from gainproof.derive.printer.layout import WIDTH, listed, row
from gainproof.derive.printer.numpy_results import result_class
from gainproof.derive.printer.numpy_source import (
    DomainLines,
    kernel_domains,
    module_domains,
    named_domain,
)
from gainproof.derive.printer.one_number import (
    FORM,
    Python,
    fitted,
    names,
    required_and_outputs,
)
from gainproof.derive.printer.slopes import Slope, slopes

TAKEN = {
    "array-api": (
        "Arrays of one library of the array API standard are taken, float64 or float32, of any "
        "shapes that broadcast, and numbers beside them, which take their type; integers become "
        "float64."
    ),
    "jax": (
        "Arrays of JAX and NumPy are taken, of any shapes that broadcast, and numbers, which take "
        "their type. Where a value is traced and outside of its domain all outputs are NaN. "
        "Bounds are those of operations that each round: what XLA does otherwise, docs/arrays.md "
        "says."
    ),
}
REFUSED = (
    "ValueError: an input outside its domain, with its place, or shapes that do not broadcast. "
    "TypeError: what is no real number of these types and libraries."
)


@dataclass(frozen=True)
class _Arrays(Python):
    def chosen(self, condition: str, yes: str, no: str) -> str:
        return f"{FORM}.where({condition}, {yes}, {no})"


@dataclass(frozen=True)
class _Jax(_Arrays):
    """XLA makes (a/b)/c a/(b c), which underflows where kernels are scaled so that nothing does,
    and adds up constants, of which a sum in two parts has two: each result is kept from it.
    """

    nested: ClassVar[int] = 0

    def sum_in_two_parts(self, text: str, rest: str) -> str:
        return f"{FORM}.kept({text}) + {rest}"

    def statement(self, name: str, text: str) -> str:
        return super().statement(name, f"{FORM}.kept({text})")


LANGUAGES = {"array-api": _Arrays(), "jax": _Jax()}


def array_api_files(
    module: Module, bounds: Sequence[Bounds], _: Mapping[str, Any]
) -> dict[str, str]:
    """The module for all libraries of the standard, by file name, from bounds already proved."""
    return _files("array-api", module, bounds, [() for _ in module.kernels])


def jax_files(module: Module, bounds: Sequence[Bounds], _: Mapping[str, Any]) -> dict[str, str]:
    """The module for JAX: with domains of normal numbers, and the derivatives that kernels have."""
    normal = [tuple(map(_normal, pair)) for pair in bounds]
    return _files("jax", module, normal, slopes(module.kernels))


def _normal(bound: KernelBound) -> KernelBound:
    least = bound.format.least_normal
    ends = tuple((max(low, least) if low else low, high) for low, high in bound.inputs)
    return replace(bound, inputs=ends)


def _files(
    target: str, module: Module, bounds: Sequence[Bounds], found: Sequence[Sequence[Slope]]
) -> dict[str, str]:
    plain = [replace(kernel, accurate=None) for kernel in module.kernels]
    own = replace(module, kernels=tuple(plain))
    return {f"{module.name}.py": "\n".join(_source(target, own, bounds, found)) + "\n"}


def _source(
    target: str, module: Module, bounds: Sequence[Bounds], found: Sequence[Sequence[Slope]]
) -> Iterator[str]:
    # a domain has ends of both types; where one is left out the other's stand in its place
    both = [pair if len(pair) > 1 else (*pair, *pair) for pair in bounds]
    domains = module_domains(module.kernels, both)
    every = [name for kernel in module.kernels for name in (kernel.result, kernel.name)]
    runtime = "._jax" if target == "jax" else "._arrays"
    shared = ["Domain", "Form", "Kernel", "Real"] + (["Slope"] if any(found) else [])
    yield from (f"# Made by: {module.command} --target {target}", f"# From: {module.derivation}")
    yield f'"""{module.title.removesuffix(".")}."""'
    yield from ("", "from __future__ import annotations", "", "from typing import NamedTuple", "")
    yield from (f"from ._arrays import {', '.join(shared)}", f"from {runtime} import evaluate")
    yield from ("", *listed("__all__ = [", [f'"{name}"' for name in sorted(every)], "]"), "")
    for domain, name in domains.items():
        yield from named_domain(name, domain)
    for kernel, pair, each, beside in zip(module.kernels, bounds, both, found, strict=True):
        yield from ("", "", *result_class(kernel), "", "", *_function(target, kernel, pair))
        yield from ("", "", *_compute(kernel, LANGUAGES[target]), "", "")
        for required in kernel.requirements:
            yield from named_domain(_limit(kernel, required), _required(required, each))
        only = pair[0].format.name if len(pair) == 1 else ""
        own = [domains[domain] for domain in kernel_domains(kernel, each)]
        yield from _kernel(kernel, own, only, [_slope(s, kernel, module) for s in beside])


def _function(target: str, kernel: Kernel, pair: Sequence[KernelBound]) -> Iterator[str]:
    """The public function."""
    given = [each.name for each in kernel.inputs]
    heads = [f"{name}: Real" for name in given]
    yield from listed(f"def {kernel.name}(", heads, f") -> {kernel.result}:")
    *lines, source = described(kernel, pair)
    told = (*lines, *textwrap.wrap(TAKEN[target], WIDTH - 4), "")
    text = (*told, *textwrap.wrap(REFUSED, WIDTH - 4), "", source)
    quotes = 'r"""' if any("\\" in line for line in text) else '"""'
    yield f"    {quotes}{text[0]}"
    yield from (f"    {line}".rstrip() for line in text[1:])
    yield '    """'
    line = f"    return evaluate({_constant(kernel)}, {row('', given)[0]})"
    if len(line) <= WIDTH and len(row("", given)) == 1:
        yield line
    else:
        yield f"    return evaluate(\n        {_constant(kernel)},"
        yield from row("        ", given, ",")
        yield "    )"


def _compute(kernel: Kernel, language: Language) -> Iterator[str]:
    """The function of arrays of one shape and type."""
    made = required_and_outputs(kernel, language)
    lines = [part for line in made.lines for part in fitted(line)] + row("return ", made.outputs)
    form = FORM if any(f"{FORM}." in line for line in lines) else f"_{FORM}"
    heads = [*(f"{name}: Real" for name in names(kernel).values()), f"{form}: Form"]
    yield from listed(f"def _{kernel.name}(", heads, ") -> tuple[Real, ...]:")
    yield from (f"    {line}" for line in lines)


def _kernel(
    kernel: Kernel, domains: Sequence[str], only: str, beside: Sequence[Sequence[str]]
) -> Iterator[str]:
    yield f"{_constant(kernel)} = Kernel("
    yield f'    "{kernel.name}",'
    yield from row("    ", domains, ",")
    required = [_limit(kernel, each) for each in kernel.requirements]
    yield from row("    ", required, ",") if required else ("    (),",)
    yield from (f"    {kernel.result},", f"    _{kernel.name},")
    yield from (f'    only="{only}",',) if only else ()
    if beside:
        yield "    slopes=lambda: ("
        for each in beside:
            yield from listed("        Slope(", each, "),")
        yield "    ),"
    yield ")"


def _required(each: Requirement, pair: Sequence[KernelBound]) -> DomainLines:
    """What inputs must be together, as the domain of what is computed of them."""
    ends = (f'({literal(least_admitted(each, bound.format))}, float("inf")),' for bound in pair)
    return (f'"{each.meaning}",', f'"{required_text(each)}",', *ends)


def _limit(kernel: Kernel, required: Requirement) -> str:
    return f"{_constant(kernel)}_{required.name.upper()}"


def _slope(each: Slope, kernel: Kernel, module: Module) -> list[str]:
    other = module.kernels[each.kernel]
    names = kernel.outputs[each.output].name, kernel.inputs[each.given].name
    slope = other.outputs[each.slope].name
    return [*(f'"{name}"' for name in names), _constant(other), f'"{slope}"', str(each.sign)]


def _constant(kernel: Kernel) -> str:
    return f"_{kernel.name.upper()}"
