"""A module's kernels as the text of a classic script."""

from __future__ import annotations

import json
import textwrap
from collections.abc import Iterator, Sequence
from pathlib import Path

from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.docstring import wanted_text
from gainproof.derive.printer.domain import input_range
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.javascript.body import RUNTIME, body
from gainproof.derive.printer.javascript.page_kernels import PLAYED
from gainproof.derive.printer.kernel import Input, Kernel, Module

RUNTIME_NAME = "_runtime.js"
"""The script that is loaded before those of kernels."""


def scripts(module: Module) -> dict[str, str]:
    """Texts by file name of what a module gives to the play: nothing, or its script and the one
    that all use.
    """
    names = PLAYED.get(module.name)
    if names is None:
        return {}
    return {f"{module.name}.js": script(module, names), RUNTIME_NAME: runtime()}


def runtime() -> str:
    """The text of the script that all others use."""
    return Path(__file__).with_name("runtime.js").read_text(encoding="utf-8")


def script(module: Module, names: Sequence[str]) -> str:
    """The script with the named kernels of a module, in that order.

    It adds `gainproof.kernels["the-module"]`, an object with a function of each kernel: numbers in
    the order of the NumPy kernel's arguments, and an object of its results by name. KeyError for a
    kernel that the module does not have, ValueError for one that requires something of several
    inputs together.
    """
    kernels = {kernel.name: kernel for kernel in module.kernels}
    lines = [
        *(f"// {line}" for line in _opening(module)),
        "(function () {",
        '  "use strict";',
        f"  const {{ {', '.join(RUNTIME)} }} = gainproof.runtime;",
        f"  gainproof.kernels[{json.dumps(module.name.replace('_', '-'))}] = {{",
        *(f"    {line}".rstrip() for name in names for line in _function(kernels[name])),
        "  };",
        "})();",
    ]
    return "\n".join(lines) + "\n"


def _opening(module: Module) -> Iterator[str]:
    yield f"Made by: {module.command}"
    yield f"From: {module.derivation}"
    yield from textwrap.wrap(module.title, 96)


def _function(kernel: Kernel) -> Iterator[str]:
    if kernel.requirements:
        raise ValueError(f"{kernel.name}: what inputs are together is not printed as JavaScript")
    made = body(kernel)
    yield f"// {kernel.summary}"
    yield f"{kernel.name}({', '.join(made.inputs)}) {{"
    for given, name in zip(kernel.inputs, made.inputs, strict=True):
        told = ", ".join(json.dumps(text) for text in (kernel.name, given.name, wanted_text(given)))
        fine = _condition(given, name)
        fine = f"({fine})" if " || " in fine or " && " in fine else fine
        yield f"  if (!{fine}) refuse({told}, {name});"
    yield from (f"  {line}" for line in made.lines)
    results = (
        output.name if output.name == value else f"{output.name}: {value}"
        for output, value in zip(kernel.outputs, made.outputs, strict=True)
    )
    yield f"  return {{ {', '.join(results)} }};"
    yield "},"


def _condition(given: Input, name: str) -> str:
    """Whether an input lies in its domain; comparisons with NaN are false."""
    low, high = (literal(end) for end in input_range(given, FLOAT64))
    text = f"within({name}, {low}, {high})"
    if given.signed:
        text = f"within({name}, -{high}, {high}) && Math.abs({name}) >= {low}"
    if given.integer:
        text = f"{text} && Number.isInteger({name})"
    return f"{name} === 0 || ({text})" if given.zero else text
