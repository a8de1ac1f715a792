"""The kernels that are swept: those of one input that is not negative, as their users see them."""

from __future__ import annotations

import hashlib
import inspect
import pkgutil
import re
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

import gainproof.generated
from gainproof.bad_input import unknown_name
from gainproof.places import package_folder


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
        return _bits(self.signature.inputs[0].single[0])

    @property
    def stop(self) -> int:
        """One more than the bits of the greatest input."""
        return _bits(self.signature.inputs[0].single[1]) + 1

    def digest(self) -> str:
        """Of what the results rest on: the kernel's arithmetic and domain, the bounds that it
        states, how bits are chosen, and what is measured. How its graph is computed in double
        precision is not counted: it is the same graph.
        """
        found = hashlib.sha256(inspect.getsource(self.signature.block).encode())
        found.update(repr(self.signature.inputs).encode())
        text = " ".join(str(self.function.__doc__).split())
        found.update("".join(re.findall(r" at most .*? \(float32\)\.", text)).encode())
        here = Path(__file__).parent
        for path in (
            package_folder("generated") / "_bits.py",
            here / "sweep.py",
            here / "tally.py",
        ):
            found.update(path.read_bytes())
        return found.hexdigest()[:16]


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


def _bits(value: float) -> int:
    return int(np.float32(value).view(np.int32))
