"""What the printed kernels of the closed-loop poles are called and say of themselves."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Output, closed
from gainproof.derive.vector_measurement import poles
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.derivative_kernels import SCALE, difference
from gainproof.derive.vector_measurement.names import in_words
from gainproof.derive.vector_measurement.pole_kernels import (
    MEAN,
    MODULUS,
    NEGATIVE,
    POLES,
    POSITIVE,
    REAL,
    SQUARE,
)
from gainproof.derive.vector_measurement.process_noise import Noise

SUMMARIES = {
    POLES: "Closed-loop poles: half their sum, their modulus, a quarter of the discriminant.",
    REAL: "The values of 1/S^2 between which the closed-loop poles are complex.",
}
MEANINGS = {
    MEAN: "half the sum of the poles, the real part of each where they are complex",
    MODULUS: "the geometric mean of their moduli, the modulus of each where they are complex",
    SQUARE: "the square of half their difference, negative where they are complex",
    POSITIVE: "the 1/S^2 from which on both poles are real and positive",
    NEGATIVE: "the 1/S^2 up to which both poles are real and negative, for no S where it is not "
    "positive",
}
REASONS = {
    MEAN: "the real part of complex poles vanishes on a curve",
    SQUARE: "the poles meet on a curve",
}


def is_of_poles(kernel: str) -> bool:
    """Whether a kernel is one of these."""
    return kernel in SUMMARIES


def pole_kernel(c: Context, name: str, graph: Graph) -> Kernel:
    """One kernel."""
    outputs = graph["outputs"]
    shown = [output for output in outputs if not output.endswith(SCALE)]
    changing = [output for output in shown if output + SCALE in outputs]
    return Kernel(
        name=name,
        result="".join(word.capitalize() for word in name.split("_")),
        summary=SUMMARIES[name],
        equations=_equations(c.noise, name),
        inputs=_inputs(c, name),
        outputs=tuple(
            Output(output, MEANINGS[output], relative_to=_scale(output, outputs))
            for output in shown
        ),
        graph=graph,
        source=f"derivation {c.model.name}",
        cancellations={difference(output): REASONS[output] for output in sorted(changing)},
    )


def _scale(output: str, outputs: Mapping[str, int]) -> str | None:
    """What an output's error is measured by, where it is not the output itself."""
    if output == NEGATIVE:
        return POSITIVE
    return output + SCALE if output + SCALE in outputs else None


def _inputs(c: Context, name: str) -> tuple[Input, ...]:
    (ratio,) = c.model.ratios.values()
    meaning = f"Lambda, with Lambda^2 = {in_words(c.model.noise_ratio)}"
    if name == REAL:
        return (closed("tracking_index", meaning, "1e-12", "1e12", ("1e-8", "1e8")),)
    single = ("1e-6", "1e6")
    return (
        closed("tracking_index", meaning, "1e-12", "1e12", single),
        closed("velocity_ratio", f"S = {in_words(ratio)}", "1e-12", "1e12", single),
    )


def _equations(noise: Noise, name: str) -> tuple[str, ...]:
    centre, spread = poles.centre(noise), poles.spread(noise)
    root = f"sqrt(1 + {_times(spread, 'Lambda^2')})" if spread else "1"
    own = f"{centre} + " if centre else ""
    if name == REAL:
        lines = (f"positive_from = {own}2 r/Lambda, r = {root}",)
        if noise.e == 1:
            return lines
        return (
            f"{lines[0]},",
            f"negative_up_to = {centre} - 2 r/Lambda = product of both/positive_from",
        )
    slope = poles.slope(noise)
    first = f"4/Lambda^2 + 1/S^2 - {slope}" if slope else "4/Lambda^2 + 1/S^2"
    middle = f"(1/S^2 - {centre})^2" if centre else "1/S^4"
    last = f" - {4 * spread}" if spread else ""
    return (
        "z = half_sum -+ sqrt(quarter_discriminant), product of both modulus^2 = 1/sigma^2,",
        f"half_sum = Lambda^2/(2 m sigma) ({first}),",
        f"quarter_discriminant = (Lambda^2/(2 delta sigma))^2 ({middle}{last} - 4/Lambda^2),",
        "sigma, m and delta as in gains. Near the curve where the poles meet their difference is",
        "the square root of a difference: the poles themselves have half the digits there.",
    )


def _times(number: Fraction, text: str) -> str:
    return f"{text}/{1 / number}"
