"""The printed module of a three-state model: its kernels, and why one is not printed."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from dataclasses import dataclass

import sympy

from gainproof.derive.any_three_state.context import Context
from gainproof.derive.any_three_state.kernels import made
from gainproof.derive.any_two_state.kernels import SCALE, Made, difference
from gainproof.derive.model import ModelError
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.printer.value import PrintingError

SUMMARIES = {
    "gains": "Steady-state filter gain.",
    "predicted_covariance": "Predicted covariance in the units of the scaled model.",
    "updated_covariance": "Updated covariance in the units of the scaled model.",
    "gain_derivatives": "First derivatives of the filter gain with respect to the tracking index.",
}
GAINS = {
    "alpha": "gain of the measured state",
    "beta": "gain of the second state",
    "gamma": "gain of the third state",
}
STATES = ("first", "second", "third")
INDEX_RANGE, SINGLE_RANGE = ("1e-20", "1e20"), ("1e-4", "1e4")
NARROW_RANGE = ("1/100", "100")
"""Of float32, where the wide one over- or underflows."""
WIDTH = 88


@dataclass(frozen=True)
class Printed:
    """The kernels that have a proved bound, their graphs, and the others with the reason."""

    module: Module
    graphs: Mapping[str, Made]
    refused: Mapping[str, str]


def printed(c: Context) -> Printed:
    """Every kernel tried: printed where forms and bounds are found, else with its reason."""
    graphs: dict[str, Made] = {}
    kernels: list[Kernel] = []
    refused: dict[str, str] = {}
    for name in SUMMARIES:
        try:
            found = made(c.shape, getattr(c.quantities, name))
            kernel = _proved(c, name, found)
        except (ModelError, PrintingError) as error:
            refused[name] = str(error)
            continue
        graphs[name] = found
        kernels.append(kernel)
    module = Module(
        name=c.model.name.replace("-", "_"),
        title=f"{c.model.title}: steady state with the first state measured.",
        command=f"gainproof generate {c.model.name}",
        derivation=f"gainproof derive {c.model.name}, SymPy {sympy.__version__}",
        kernels=tuple(kernels),
    )
    return Printed(module, graphs, refused)


def _proved(c: Context, name: str, found: Made) -> Kernel:
    """The kernel on the widest range of float32 that has a bound. Raises PrintingError."""
    kernel = _kernel(c, name, found, SINGLE_RANGE)
    prove(kernel, FLOAT64)
    try:
        prove(kernel, FLOAT32)
    except PrintingError:
        kernel = _kernel(c, name, found, NARROW_RANGE)
        prove(kernel, FLOAT32)
    return kernel


def _kernel(c: Context, name: str, found: Made, single: tuple[str, str]) -> Kernel:
    shown = [output for output in found.graph["outputs"] if not output.endswith(SCALE)]
    apart = [output for output in shown if output + SCALE in found.graph["outputs"]]
    return Kernel(
        name=name,
        result="".join(word.capitalize() for word in name.split("_")),
        summary=SUMMARIES[name],
        equations=_equations(c),
        inputs=_inputs(c, found, single),
        outputs=tuple(
            Output(
                output,
                _meaning(name, output),
                relative_to=output + SCALE if output in apart else None,
            )
            for output in shown
        ),
        graph=found.graph,
        source=f"derivation {c.model.name}",
        cancellations={
            difference(output): f"no form without it is known; {output}{SCALE} is the sum of both "
            "positive parts, whose difference the output is"
            for output in sorted(apart)
        },
    )


def _meaning(kernel: str, output: str) -> str:
    if output in GAINS:
        return ("derivative of the " if kernel == "gain_derivatives" else "") + GAINS[output]
    kind, place = output.split("_")
    first, second = (STATES[int(digit) - 1] for digit in place)
    if first == second:
        return f"variance of the {kind} {first} state"
    return f"covariance of the {kind} {first} and {second} states"


def _equations(c: Context) -> tuple[str, ...]:
    """What the outputs are, over the roots; lines of the docstring's width."""
    f, n = c.shape.still, c.shape.shaken
    numbers = [f"A{k} = {f[k]} + q ({n[k]})" for k in range(4)]
    weights, own = c.shape.closed_loop
    texts = [
        "d0^2 = A0, d1^2 = A1 + 2 d0 d2, d2^2 = A2 + 2 d3 d1, d3^2 = A3, q = Lambda^2,",
        f"{', '.join(numbers)};",
        "N = d0 + d1 + d2 + d3, sigma = N/8, alpha = 1 - 1/sigma^2,",
        *(
            f"{name} = ({' + '.join(f'({w}) d{i}' for i, w in enumerate(weights.row(k)))})/N"
            f" - ({own[k]}),"
            for k, name in ((1, "beta"), (2, "gamma"))
        ),
        (
            "predicted_1j = sigma^2 (alpha, beta, gamma), updated_1j = (alpha, beta, gamma), the "
            "rest from predicted = F updated F' + q Q0."
        ),
        (
            "All of it is computed from sums, products, quotients and roots of positive terms but "
            "where an output is said to be a difference."
        ),
    ]
    return tuple(line for text in texts for line in textwrap.wrap(text, WIDTH))


def _inputs(c: Context, found: Made, single: tuple[str, str]) -> tuple[Input, ...]:
    index = f"Lambda, with Lambda^2 = {c.model.noise_ratio}"
    used = {str(node[1]) for node in found.graph["nodes"] if node[0] == "symbol"}
    parameters = tuple(
        closed(entry.quantity.name, entry.quantity.meaning, *entry.kernel_range)
        for entry in c.original.parameters
        if entry.quantity.name in used
    )
    return (closed("tracking_index", index, *INDEX_RANGE, single), *parameters)
