"""Proved bounds on the rounding error of a kernel, and the domain on which each output has them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

import numpy as np

from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.lost_digits_text import Loss
from gainproof.derive.printer.one_input import OneInput
from gainproof.derive.printer.proof import Settled
from gainproof.derive.printer.several_inputs import SeveralInputs
from gainproof.derive.printer.signed_inputs import by_reference, has_signs
from gainproof.derive.printer.step_ranges import Box, PrintingError
from gainproof.derive.printer.zero_inputs import ZeroCase, zero_cases

DIGITS = 100  # printed bounds are rounded up to hundredths of the format's epsilon


@dataclass(frozen=True)
class OutputBound:
    """What is proved of one output in one format.

    `bound`: the error over the scale is at most `bound` * epsilon, epsilon = 2^-52 or 2^-23, for
    every input of the format in `domain`. Of one input this is the largest interval where the true
    value of the scale is a normal number (and 64 epsilon below the largest); of several it is the
    whole domain of the kernel, where the true value is proved to be normal. `amplification`: for
    each named cancellation the factor by which errors of its operands' sizes may enter this output.
    `beside`: what an underflow on the way may add to the error. `loss`: what the bound says of the
    value where it is relative to something larger, once that was asked (see `lost_digits`).
    """

    name: str
    bound: Fraction
    domain: Box
    amplification: Mapping[str, float]
    beside: float = 0.0
    loss: Loss | None = None

    @property
    def lowest(self) -> float:
        """The least number of the first input."""
        return self.domain[0][0]

    @property
    def highest(self) -> float:
        """The greatest number of the first input."""
        return self.domain[0][1]


@dataclass(frozen=True)
class KernelBound:
    """The bounds of all outputs in one format.

    `inputs`: least and greatest number of each input's domain; `boxes`: how many prove the bounds.
    """

    format: Format
    inputs: Box
    outputs: tuple[OutputBound, ...]
    boxes: int

    @property
    def lowest(self) -> float:
        """The least number of the first input's domain."""
        return self.inputs[0][0]

    @property
    def highest(self) -> float:
        """The greatest number of the first input's domain."""
        return self.inputs[0][1]


Bounds = tuple[KernelBound, ...]
"""Of one kernel in every format."""


def prove(kernel: Kernel, form: Format) -> KernelBound:
    """Bounds every output of a kernel in one format.

    Of several inputs the whole product of their domains is proved to be inside every output's.
    PrintingError, naming the node, for a subtraction of computed values that is not named, an
    over- or underflow inside an output's domain, a possible NaN, or a bound that does not settle.
    Kernels with signed inputs or functions of a library have the bounds of `reference`.
    NotImplementedError for other negative inputs.
    """
    kind = OneInput if len(kernel.inputs) == 1 else SeveralInputs
    try:
        with np.errstate(all="ignore"):
            if has_signs(kernel):
                return _printed(kernel, form, by_reference(kernel, form))
            found = kind(kernel, form).run()
            for case in zero_cases(kernel):
                found = _both(found, case, SeveralInputs(case.kernel, form, case.of(found.bounds)))
            return _printed(kernel, form, found)
    except (PrintingError, OverflowError) as error:
        raise PrintingError(f"{kernel.name} ({form.name}): {error}") from error


def _both(found: Settled, case: ZeroCase, proof: SeveralInputs) -> Settled:
    """The larger bounds of both; an output that is exact where inputs are 0 keeps its own."""
    other = proof.run()
    factors = {
        name: case.greater(sizes, other.factors.get(name)) for name, sizes in found.factors.items()
    }
    bounds = case.greater(found.bounds, other.bounds)
    return replace(found, bounds=bounds, factors=factors, boxes=found.boxes + other.boxes)


def _printed(kernel: Kernel, form: Format, found: Settled) -> KernelBound:
    """The bounds in hundredths of epsilon, rounded up."""
    outputs = []
    for row, output in enumerate(kernel.outputs):
        exact = Fraction(float(found.bounds[row])) / Fraction(form.epsilon)
        bound = Fraction(math.ceil(exact * DIGITS), DIGITS)
        factors = {name: float(found.factors[name][row]) for name in kernel.cancellations}
        beside = found.beside[row] if found.beside else 0.0
        outputs.append(OutputBound(output.name, bound, found.domains[row], factors, beside))
    return KernelBound(form, found.inputs, tuple(outputs), found.boxes)
