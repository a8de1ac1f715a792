"""What the printed kernels of derivatives are called and say of themselves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Output, closed
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.derivative_kernels import (
    BY_INDEX,
    BY_RATIO,
    SCALE,
    difference,
)
from gainproof.derive.vector_measurement.names import in_words
from gainproof.derive.vector_measurement.process_noise import Noise

LATIN = {BY_INDEX: "Lambda", BY_RATIO: "S"}
HELD = {BY_INDEX: "S", BY_RATIO: "Lambda"}
GROUPS = {
    "gains": "the filter gain",
    "predicted_covariance": "the predicted covariance",
    "updated_covariance": "the updated covariance",
}
OF_GAINS = {
    BY_INDEX: ("As K = U R^-1: dK11 = dU11, dK21 = dU12, dK12 = dU12/S^2, dK22 = dU22/S^2.",),
    BY_RATIO: (
        "As K = U R^-1: dK11 = dU11, dK21 = dU12, dK12 = dU12/S^2 - 2 K12/S, and dK22 =",
        "dU22/S^2 - 2 K22/S, which is negative and has a form without a subtraction.",
    ),
}
REASON = (
    "what it is the derivative of grows in one part of the domain and falls in another, so that it "
    "vanishes between"
)
NARROW = frozenset(
    {f"gains{BY_RATIO}", f"updated_covariance{BY_RATIO}", f"predicted_covariance{BY_INDEX}"}
)
"""Without noise in the position: what is no normal number of float32 a decade earlier."""


def is_derivative(kernel: str) -> bool:
    """Whether a kernel's name is that of a kernel of derivatives."""
    return kernel.endswith((BY_INDEX, BY_RATIO))


def derivative_kernel(
    c: Context, name: str, graph: Graph, base: Sequence[str], meanings: Mapping[str, str]
) -> Kernel:
    """One kernel; `base` are the equations of what is differentiated, `meanings` its outputs'."""
    by = BY_INDEX if name.endswith(BY_INDEX) else BY_RATIO
    group, variable = name.removesuffix(by), by.removeprefix("_by_")
    shown = [output for output in graph["outputs"] if not output.endswith(SCALE)]
    changing = [output for output in shown if output + SCALE in graph["outputs"]]
    return Kernel(
        name=name,
        result="".join(word.capitalize() for word in name.split("_")),
        summary=f"First derivatives of {GROUPS[group]} by {variable}.",
        equations=(*_equations(group, by, changing), *base),
        inputs=inputs(c, name),
        outputs=tuple(
            Output(
                output,
                f"derivative by {LATIN[by]} of the {meanings[output]}",
                relative_to=output + SCALE if output in changing else None,
            )
            for output in shown
        ),
        graph=graph,
        source=f"derivation {c.model.name}",
        cancellations={difference(output): REASON for output in sorted(changing)},
    )


def inputs(c: Context, kernel: str) -> tuple[Input, Input]:
    """Both parameters; in float32 where everything is a normal number, by whole decades."""
    (ratio,) = c.model.ratios.values()
    decades = _decades(c.noise, kernel)
    ends = f"1e-{decades}", f"1e{decades}"
    index = f"Lambda, with Lambda^2 = {in_words(c.model.noise_ratio)}"
    return (
        closed("tracking_index", index, "1e-30", "1e30", ends),
        closed("velocity_ratio", f"S = {in_words(ratio)}", "1e-30", "1e30", ends),
    )


def _decades(noise: Noise, kernel: str) -> int:
    if not noise.interval:
        return 4 if kernel in NARROW else 5
    return 6 if kernel == f"predicted_covariance{BY_INDEX}" else 5


def _equations(group: str, by: str, changing: Sequence[str]) -> tuple[str, ...]:
    symbol = LATIN[by]
    lines = [
        f"d/d{symbol} with {HELD[by]} held of what follows. A change of the noise moves the",
        "covariance by a sum over the closed loop, which is a mean over z = 1 and z = -1: a",
        f"variance's derivative is {symbol}/delta times squares over Lambda w and over eta, a",
        "covariance's has products in place of the squares.",
    ]
    if group == "gains":
        lines += OF_GAINS[by]
    terms = "is the difference of two positive terms"
    lines += [f"The output {output} {terms}." for output in changing]
    return (*lines, "The entries themselves:")
