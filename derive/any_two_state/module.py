"""The printed module of a two-state model: its kernels, and why one is not printed."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from dataclasses import dataclass

import sympy

from gainproof.derive.any_two_state import forms
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.kernels import KERNELS, SCALE, Made, difference, made
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
    "gain_second_derivatives": "Second derivatives of the filter gain by the tracking index.",
}
ORDERS = {
    "gain_derivatives": "derivative of the ",
    "gain_second_derivatives": "second derivative of the ",
}
MEANINGS = {
    "alpha": "gain of the measured state",
    "beta": "gain of the second state",
    "predicted_11": "variance of the predicted first state",
    "predicted_12": "covariance of both predicted states",
    "predicted_22": "variance of the predicted second state",
    "updated_11": "variance of the updated first state",
    "updated_12": "covariance of both updated states",
    "updated_22": "variance of the updated second state",
}
INDEX_RANGE, SINGLE_RANGE = ("1e-20", "1e20"), ("1e-4", "1e4")
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
    for name, parts in KERNELS.items():
        try:
            found = made(c.shape, parts)
            kernel = _kernel(c, name, found)
            for form in (FLOAT64, FLOAT32):
                prove(kernel, form)
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


def _kernel(c: Context, name: str, found: Made) -> Kernel:
    shown = [output for output in found.graph["outputs"] if not output.endswith(SCALE)]
    apart = [output for output in shown if output + SCALE in found.graph["outputs"]]
    return Kernel(
        name=name,
        result="".join(word.capitalize() for word in name.split("_")),
        summary=SUMMARIES[name],
        equations=_equations(c),
        inputs=_inputs(c, found),
        outputs=tuple(
            Output(
                output,
                ORDERS.get(name, "") + MEANINGS[output],
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


def _equations(c: Context) -> tuple[str, ...]:
    """What the outputs are, over the roots; lines of the docstring's width."""
    f0, f1, f2 = c.shape.open_loop
    n0, n1 = c.shape.noise_ends
    f11, f12, f21, f22 = (c.shape.entry(i, j) for i in (1, 2) for j in (1, 2))
    texts = [
        (
            "d0^2 = f0^2 + q n0, d2^2 = f2^2 + q n1, d1^2 = f1^2 - 2 f0 f2 + q (n0 + n1) + 2 d0 d2,"
            " sigma = (d0 + d1 + d2)/4, q = Lambda^2;"
        ),
        f"f0 = {f0}, f1 = {f1}, f2 = {f2}, n0 = {n0}, n1 = {n1};",
        "alpha = 1 - 1/sigma^2,",
    ]
    if forms.below_beta(c.basis) is None:
        texts.append(
            f"({f12}) sigma beta = ({f22}) sigma + (d0 - d2)/2 + (1 - alpha) ({f11}) sigma;"
        )
    else:
        first, second = forms.couplings(c.basis)
        weights = " + ".join(f"({w}) d{i}" for i, w in enumerate(c.basis.far_weights) if w != 0)
        texts.append(
            f"beta (sigma W/4 - ({f12 * f21})) = ({first}) alpha + ({second}) q, W = {weights};"
        )
    texts += [
        (
            "predicted_11 = sigma^2 - 1, predicted_12 = beta sigma^2, updated_11 = alpha, "
            "updated_12 = beta, predicted_22 = updated_22 + beta^2 sigma^2."
        ),
        (
            "All of it is computed from sums, products, quotients and roots of positive terms"
            " but where an output is said to be a difference."
        ),
    ]
    return tuple(line for text in texts for line in textwrap.wrap(text, WIDTH))


def _inputs(c: Context, found: Made) -> tuple[Input, ...]:
    index = f"Lambda, with Lambda^2 = {c.model.noise_ratio}"
    used = {str(node[1]) for node in found.graph["nodes"] if node[0] == "symbol"}
    parameters = tuple(
        closed(entry.quantity.name, entry.quantity.meaning, *entry.kernel_range)
        for entry in c.original.parameters
        if entry.quantity.name in used
    )
    return (closed("tracking_index", index, *INDEX_RANGE, SINGLE_RANGE), *parameters)
