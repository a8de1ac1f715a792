"""What a kernel is: inputs with domains, outputs with scales, one expression graph, its source."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property

from gainproof.derive.printer.constant import constant
from gainproof.derive.printer.formats import FLOAT32, Format
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.program import Program, program

Limit = int | Fraction | str | Graph
"""A number of a domain: rational, its text, or a graph without symbols and one output "value"."""


@dataclass(frozen=True)
class Input:
    """A real argument of a kernel.

    `meaning` is a phrase for the docstring; every argument is dimensionless. The domain reaches
    from `lower` to `upper` (None: every finite float), an open end excluded. `integer`: only whole
    numbers. `single`: lower and upper in float32, where they are others.

    A kernel with several inputs has its bounds on the whole product of their domains, which are
    closed and positive: `closed` makes such an input. `zero`: 0 is admitted beside them. `signed`:
    the domain is that of the magnitude (see `signed`).
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
    signed: bool = False


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


def signed(
    name: str,
    meaning: str,
    lower: Limit,
    upper: Limit,
    single: tuple[Limit, Limit] | None = None,
) -> Input:
    """An input of either sign: 0, or a magnitude from `lower` to `upper`, both admitted; from 0 on
    subnormal numbers too.
    """
    return Input(name, meaning, lower, upper, False, False, single=single, zero=True, signed=True)


@dataclass(frozen=True)
class Requirement:
    """What several inputs must fulfil together: the graph's output `name`, `meaning` in words, is
    at least `least`; in float32 at least `single`. Of a `least` 0 it is above 0. One below 0 bounds
    the magnitude of what is never positive.
    """

    name: str
    meaning: str
    least: Limit
    single: Limit


def least_admitted(required: Requirement, form: Format) -> float:
    """The least number of a format that a requirement admits; for what is above 0 the least normal
    one.
    """
    limit = required.single if form is FLOAT32 else required.least
    return constant(limit).nearest(form) or form.least_normal


@dataclass(frozen=True)
class Output:
    """One field of a kernel's result, dimensionless.

    The error bound is relative to the true value itself, or to the true value of the graph's output
    `relative_to` (which need not be an `Output`), e.g. the modulus of a pole whose real part may
    vanish. `by_terms`: it is relative to the value of the output's own formula with every term of
    its sums taken positive, which a kernel of signed inputs must say where terms may cancel.
    `scale_meaning`: `relative_to` in words, where no equation of the kernel says what it is. NAME's
    own scale, NAME_scale, is always the sum of its terms' sizes. `accepted`: who asks for the
    kernel knows that digits of the value can be lost.
    """

    name: str
    meaning: str
    relative_to: str | None = None
    by_terms: bool = False
    scale_meaning: str = ""
    accepted: bool = False


@dataclass(frozen=True)
class Refinement:
    """How `accurate_graph` comes to a root x = f(x), its symbol `root`: from the symbol `near`.

    That is factor * over/under, two outputs of the kernel in float64; the graph's output `image`
    is f(near), `slope` the logarithmic slope of f there, between 0 and 1/4.
    """

    near: str
    root: str
    image: str
    slope: str
    over: str
    under: str
    factor: int


@dataclass(frozen=True)
class Kernel:
    """A function of NumPy arrays that is printed from its graph.

    `name`: the public function. `result`: the class of its result, a NamedTuple. `summary`: one
    line. `equations`: lines of plain text. `source`: what it rests on. `cancellations`: the
    subtractions of computed values that are meant, by the name (in the graph's "names") of the
    difference, each with its reason; any other subtraction of computed values is refused.
    `requirements`: what the inputs must fulfil together, of kernels with signed inputs.
    `accurate`: the domain in which its one input is taken with `accurate=True`, in double-words;
    `accurate_graph`: what is computed then, if it is another graph of the same outputs;
    `refinement`: how it comes to a root. `search`: times as many boxes as kernels of several inputs
    have for their bounds. `stepwise`: bounds step by step, as of kernels with signed inputs, and no
    boxes.
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
    requirements: tuple[Requirement, ...] = ()
    accurate: Input | None = None
    accurate_graph: Graph | None = None
    refinement: Refinement | None = None
    search: int = 1
    stepwise: bool = False

    @cached_property
    def program(self) -> Program:
        """The steps of the graph; ValueError names a node that the printer does not know."""
        return program(self.graph)

    @cached_property
    def accurate_program(self) -> Program:
        """The steps that are computed in double-words."""
        return self.program if self.accurate_graph is None else program(self.accurate_graph)


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


def explained(kernel: Kernel) -> frozenset[str]:
    """The names that a kernel's docstring explains: inputs, outputs, and those of its equations."""
    words = re.findall(r"\w+", " ".join(kernel.equations))
    inputs, outputs = (each.name for each in kernel.inputs), (each.name for each in kernel.outputs)
    return frozenset({*inputs, *outputs, *words})
