"""The kernels that are swept: those of one input that is not negative, as their users see them."""

from __future__ import annotations

import ast
import hashlib
import inspect
import pkgutil
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

import gainproof.generated
from gainproof.bad_input import unknown_name
from gainproof.campaign.float32.stated import Stated, stated
from gainproof.campaign.float32.traced import OURS, computed
from gainproof.generated import _bits

MEASURING = ("sweep.py", "tally.py", "c_text.py")
"""Files; how the graph is computed in double precision is not among them: it is the same graph."""


@dataclass(frozen=True)
class Swept:
    """A public kernel; `signature` is that of its module."""

    module: str
    name: str
    function: Callable[..., Any]
    signature: Any

    @property
    def id(self) -> str:
        return f"{self.module}.{self.name}"

    @property
    def whole(self) -> bool:
        """Whether whole numbers alone are taken."""
        return bool(self.signature.inputs[0].whole)

    @property
    def start(self) -> int:
        """The bits of the least input; numbers that are not negative have the order of theirs."""
        return _bits_of(self.signature.inputs[0].single[0])

    @property
    def stop(self) -> int:
        """One more than the bits of the greatest input."""
        return _bits_of(self.signature.inputs[0].single[1]) + 1

    @property
    def stated(self) -> tuple[Stated, ...]:
        """What the docstring promises of each output."""
        return stated(self.function.__doc__)

    def digest(self) -> str:
        """Of what the results rest on: what the kernel computes, the numbers it takes, for which of
        them its bounds are stated, and how errors are measured.

        Not of where values lie between the steps and how NumPy is called; not of the bounds
        themselves, with which errors are compared when they are reported; not of what brings blocks
        to the arithmetic and back (guards, threads, `out`), which is tested by itself; and not of
        NumPy's version: sums, products, quotients and roots are rounded correctly in each, and
        `test_campaign_float32` says so if a kernel takes anything else.
        """
        found = hashlib.sha256(computed(self.signature, single=True).encode())
        for name in OURS:
            if name in self.signature.block.__code__.co_names:
                found.update(source_of(getattr(_bits, name)).encode())
        domain = self.signature.inputs[0]
        ranges = [(each.scale, each.lowest, each.highest) for each in self.stated]
        found.update(repr((domain.single, domain.whole, self.signature.outputs, ranges)).encode())
        found.update(measuring_code())
        return found.hexdigest()[:16]


@cache
def source_of(function: Callable[..., Any]) -> str:
    """Its text: to find it takes some milliseconds."""
    return inspect.getsource(function)


@cache
def measuring_code() -> bytes:
    """The code that says which numbers are taken and what is measured, without its words."""
    return code_of(Path(__file__).parent / name for name in MEASURING)


def code_of(files: Iterable[Path]) -> bytes:
    """The code of files, without their words."""
    return "\n".join(without_words(file.read_text(encoding="utf-8")) for file in files).encode()


def without_words(text: str) -> str:
    """The syntax of a module, without its docstrings and comments."""
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef):
            node.body = [each for each in node.body if not _is_text(each)]
    return ast.dump(tree)


def _is_text(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def swept_kernels() -> Iterator[Swept]:
    """All of them, by module and name."""
    for found in pkgutil.iter_modules(gainproof.generated.__path__):
        if found.name.startswith("_"):
            continue
        module = import_module(f"gainproof.generated.{found.name}")
        for name in module.__all__:
            if not name[0].islower():  # a class of results
                continue
            signature = getattr(module, f"_{name.upper()}")
            if len(signature.inputs) == 1 and not signature.inputs[0].signed:
                yield Swept(found.name, name, getattr(module, name), signature)


def chosen(kernels: Iterable[Swept], names: Sequence[str]) -> list[Swept]:
    """Those of the names, each a module or module.kernel; all without names."""
    every = list(kernels)
    known = {*(kernel.id for kernel in every), *(kernel.module for kernel in every)}
    for name in names:
        if name not in known:
            raise unknown_name("kernel of one input", name, known)
    return [k for k in every if not names or k.id in names or k.module in names]


def _bits_of(value: float) -> int:
    return int(np.float32(value).view(np.int32))
