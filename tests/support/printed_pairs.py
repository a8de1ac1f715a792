"""The printed kernels of several inputs as their users see them, with the graphs they state.

A kernel's graph is read from the certificate beside it, whose checker has proved it to be what the
family's statements say; here it is only evaluated.
"""

from __future__ import annotations

import importlib
import json
import pkgutil
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import flint
import numpy as np
from graph_kernels import balls
from kernel_errors import Table, Worst, log_uniform
from numpy.typing import NDArray
from printed_kernels import DTYPES, EPSILON

import gainproof.generated

Box = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class Stated:
    """What a docstring says of one output: its bound in epsilon by format, and its scale."""

    bound: Mapping[str, Fraction]
    scale: str


@dataclass(frozen=True)
class PrintedPair:
    """One function of several arguments; `domain` by format, as the guard has it; `zeros`: which
    arguments may be 0 besides.
    """

    family: str
    name: str
    function: Callable[..., Any]
    arguments: tuple[str, ...]
    domain: Mapping[str, Box]
    outputs: Mapping[str, Stated]
    graph: Any
    zeros: tuple[bool, ...] = ()

    @property
    def id(self) -> str:
        return f"{self.family}.{self.name}"


@cache
def printed_pairs() -> tuple[PrintedPair, ...]:
    """Every public kernel of several inputs of every generated module."""
    found: list[PrintedPair] = []
    for folder in gainproof.generated.__path__:
        for module in pkgutil.iter_modules([folder]):
            if not module.name.startswith("_"):
                found += pairs_of(module.name, Path(folder))
    return tuple(found)


def pairs_of(family: str, folder: Path) -> Iterator[PrintedPair]:
    """The kernels of several inputs of one module, none of which has a sign."""
    loaded = importlib.import_module(f"gainproof.generated.{family}")
    programs: dict[str, Any] = {}
    for name in loaded.__all__:
        if not name[0].islower():  # a class of results
            continue
        signature = getattr(loaded, f"_{name.upper()}")
        if len(signature.inputs) < 2 or any(domain.signed for domain in signature.inputs):
            continue
        if not programs:  # megabytes, read once and only where there are pairs
            text = (folder / f"{family}.json").read_text(encoding="utf-8")
            programs = json.loads(text)["programs"]
        yield pair_of(family, getattr(loaded, name), signature, programs[name]["graph"])


def pair_of(family: str, function: Any, signature: Any, graph: Any) -> PrintedPair:
    """A function with its signature and its docstring's statements."""
    text = re.sub(r"\s+", " ", function.__doc__)
    return PrintedPair(
        family,
        signature.name,
        function,
        tuple(domain.name for domain in signature.inputs),
        {
            "float64": tuple(domain.double for domain in signature.inputs),
            "float32": tuple(domain.single for domain in signature.inputs),
        },
        {output: stated(text, output) for output in signature.outputs},
        graph,
        tuple(domain.zero for domain in signature.inputs),
    )


def stated(text: str, output: str) -> Stated:
    """The statement about an output, from a docstring on one line; LookupError if there is none."""
    found = re.search(
        rf" {output}: [^:]*?(?:Relative error|Error over (the sum of its terms' sizes|\w+)) "
        r"at most ([.\d]+) \* 2\^-52 "
        r"\(float64\), ([.\d]+) \* 2\^-23 \(float32\), proved for every input",
        text,
    )
    if found is None:
        raise LookupError(f"no bound for every input is stated for {output}: {text[:60]}...")
    scale, double, single = found.groups()
    bounds = {"float64": Fraction(double), "float32": Fraction(single)}
    return Stated(bounds, f"{output}_scale" if scale and " " in scale else scale or output)


def pair_groups(kernels: Sequence[PrintedPair]) -> dict[tuple[str, str], list[PrintedPair]]:
    """The kernels by family and arguments."""
    found: dict[tuple[str, str], list[PrintedPair]] = {}
    for kernel in kernels:
        found.setdefault((kernel.family, ",".join(kernel.arguments)), []).append(kernel)
    return found


def points_in(kernel: PrintedPair, dtype: str, span: str, count: int, seed: int) -> NDArray[Any]:
    """Points of a kernel, a row for each argument.

    `span`: "domain" and "near" (what it has of 1e-6..1e6) log-uniform in all arguments, "grid" the
    half decades of 1e-6..1e6, of more than two arguments places of it drawn. What lies outside the
    domain is left out, its corners are put in, and of arguments that may be 0 some are.
    """
    box, generator = kernel.domain[dtype], np.random.default_rng(seed)
    if span == "grid" and len(box) > 2:
        halves = [_half_decades(*ends) for ends in box]
        points = 10.0 ** np.stack([generator.choice(each, 2 * count) for each in halves])
    elif span == "grid":
        rows = np.meshgrid(*[10.0 ** np.arange(-6, 6.25, 0.5)] * len(box), indexing="ij")
        points = np.stack([row.ravel() for row in rows])
    else:
        near = [(max(low, 1e-6), min(high, 1e6)) for low, high in box]
        ends = box if span == "domain" else near
        points = np.stack(
            [np.array(log_uniform(*end, count, 7 * seed + at)) for at, end in enumerate(ends)]
        )
    corners = np.stack([row.ravel() for row in np.meshgrid(*box, indexing="ij")])
    points = np.concatenate([points, corners], axis=1).astype(dtype)
    inside = [(row >= low) & (row <= high) for row, (low, high) in zip(points, box, strict=True)]
    points = points[:, np.logical_and.reduce(inside)]
    points[(generator.random(points.shape) < 0.2) & np.array(kernel.zeros)[:, None]] = 0
    return points


def _half_decades(low: float, high: float) -> NDArray[Any]:
    """The exponents of the half decades of 1e-6..1e6 in a domain."""
    exponents = np.arange(-6, 6.25, 0.5)
    places = 10.0**exponents
    return exponents[(places >= low) & (places <= high)]


def measure_pairs(kernels: Sequence[PrintedPair], dtype: str, points_of: Any) -> Table:
    """The worst error of every output at the points that `points_of` gives for a kernel."""
    found: Table = {}
    for kernel in kernels:
        points = points_of(kernel)
        columns = kernel.function(*points)
        for at in range(points.shape[1]):
            place = tuple(points[:, at].tolist())
            exact = balls(kernel.graph, dict(zip(kernel.arguments, place, strict=True)))
            for (output, said), column in zip(kernel.outputs.items(), columns, strict=True):
                value = flint.arb(float(column[at]))
                if exact[output] == value:
                    error = flint.arb(0)  # 0 is exactly 0
                else:
                    error = abs((value - exact[output]) / exact[said.scale])
                size = float(error.upper()) / float(EPSILON[dtype])
                key = kernel.name, output
                worst = Worst(size if size == size else np.inf, place, 1)
                found[key] = found.get(key, Worst()).joined(worst)
    return found


def broken_pairs(kernels: Sequence[PrintedPair], dtype: str, table: Table) -> list[str]:
    """What was measured above its stated bound, in words."""
    assert dtype in DTYPES
    said = {
        (kernel.name, output): bound
        for kernel in kernels
        for output, bound in kernel.outputs.items()
    }
    return [
        f"{name}.{output} ({dtype}) at {worst.at}: {worst.error:.2f} epsilon"
        for (name, output), worst in table.items()
        if not worst.error <= said[name, output].bound[dtype]
    ]
