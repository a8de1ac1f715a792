"""What a kernel is: inputs with domains, outputs with scales, one expression graph, its source."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from gainproof.derive.printer.graph import Graph

Limit = int | Fraction | str | Graph
"""A number of a domain: rational, its text, or a graph without symbols and one output "value"."""


@dataclass(frozen=True)
class Input:
    """A real argument of a kernel.

    `meaning` is a phrase for the docstring; every argument is dimensionless. The domain reaches
    from `lower` to `upper` (None: every finite float), an open end excluded. `integer`: only whole
    numbers. `single`: lower and upper in float32, where they are others.

    A kernel with several inputs has its bounds on the whole product of their domains, which are
    closed and positive: `closed` makes such an input. `zero`: 0 is admitted beside them.
    """

    name: str
    meaning: str
    lower: Limit = "0"
    upper: Limit | None = None
    lower_open: bool = True
    upper_open: bool = True
    integer: bool = False
    single: tuple[Limit, Limit] | None = None
    zero: bool = False


def closed(
    name: str,
    meaning: str,
    lower: Limit,
    upper: Limit,
    single: tuple[Limit, Limit] | None = None,
    zero: bool = False,
) -> Input:
    """An input of a kernel with several: from `lower` to `upper`, both admitted, `zero`: and 0."""
    return Input(name, meaning, lower, upper, False, False, single=single, zero=zero)


@dataclass(frozen=True)
class Output:
    """One field of a kernel's result, dimensionless.

    The error bound is relative to the true value itself, or to the true value of the graph's output
    `relative_to` (which need not be an `Output`), e.g. the modulus of a pole whose real part may
    vanish.
    """

    name: str
    meaning: str
    relative_to: str | None = None


@dataclass(frozen=True)
class Kernel:
    """A function of NumPy arrays that is printed from its graph.

    `name`: the public function. `result`: the class of its result, a NamedTuple. `summary`: one
    line. `equations`: lines of plain text. `source`: what it rests on. `cancellations`: the
    subtractions of computed values that are meant, by the name (in the graph's "names") of the
    difference, each with its reason; any other subtraction of computed values is refused.
    """

    name: str
    result: str
    summary: str
    equations: tuple[str, ...]
    inputs: tuple[Input, ...]
    outputs: tuple[Output, ...]
    graph: Graph
    source: str
    cancellations: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Module:
    """One file of `generated`, made by `command`; `derivation`: its origin and SymPy version.

    `results`: the file beside it that holds the classes of its results, where several modules
    have the same; None if they stand in the module.
    """

    name: str
    title: str
    command: str
    derivation: str
    kernels: tuple[Kernel, ...]
    results: str | None = None
