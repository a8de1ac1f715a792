"""The kernels of a model with its first state measured that have a proved bound, as a module."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.any_two_state.context import MeasuredContext
from gainproof.derive.any_two_state.kernels import SCALE, Made, difference
from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import Derivation
from gainproof.derive.model import Model, ModelError, ScaledModel
from gainproof.derive.pages.derivation import Written
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT32, FLOAT64
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed
from gainproof.derive.printer.step_ranges import PrintingError
from gainproof.derive.subject import Program, Subject

GAINS = ("alpha", "beta", "gamma")
INDEX_RANGE, SINGLE_RANGE = ("1e-20", "1e20"), ("1e-4", "1e4")
WIDTH = 88
"""Of the lines of a docstring."""


@dataclass(frozen=True)
class Printed:
    """The kernels that have a proved bound, their graphs, and the others with the reason."""

    module: Module
    graphs: Mapping[str, Made]
    refused: Mapping[str, str]


@dataclass(frozen=True)
class Wording:
    """What docstrings say: of a kernel, of an output of a kernel, and on the roots."""

    summaries: Mapping[str, str]
    meaning: Callable[[str, str], str]
    equations: tuple[str, ...]


def printed(
    original: Model,
    scaled: ScaledModel,
    graphs: Mapping[str, Callable[[], Made]],
    said: Wording,
    single_ranges: tuple[tuple[str, str], ...] = (SINGLE_RANGE,),
) -> Printed:
    """Every kernel tried: printed where forms and bounds are found, else with its reason.

    single_ranges: of the index in float32, the first that has a bound is taken.
    """
    made: dict[str, Made] = {}
    kernels: list[Kernel] = []
    refused: dict[str, str] = {}
    for name, graph in graphs.items():
        try:
            found = graph()
            choices = [
                _kernel(name, found, said, scaled, _inputs(original, scaled, found, single))
                for single in single_ranges
            ]
            kernel = _proved(choices)
        except (ModelError, PrintingError) as error:
            refused[name] = str(error)
            continue
        made[name] = found
        kernels.append(kernel)
    title = f"{scaled.title}: steady state with the first state measured"
    return Printed(catalogue_module(scaled.name, title, kernels), made, refused)


def require_kernels(found: Printed, model: Model) -> None:
    """Raise ModelError, with every reason, where no kernel has a proved bound."""
    if not found.graphs:
        own = f"model {model.name}: "
        reasons = "; ".join(dict.fromkeys(r.removeprefix(own) for r in found.refused.values()))
        raise ModelError(f"{own}no kernel has a proved bound: {reasons}")


def measured_subject(
    c: MeasuredContext[Any], found: Printed, page: Written, latex: Mapping[str, str]
) -> Subject:
    """The subject of such a model; `latex`: of other symbols than its own."""
    return Subject(
        name=c.original.name,
        title=c.original.title,
        model=c.model,
        derivation=Derivation(page.opening, page.steps, (), {**latex, **c.latex()}),
        towers=page.towers,
        programs={
            kernel.name: Program({entry.name: entry.name for entry in kernel.inputs}, kernel.graph)
            for kernel in found.module.kernels
        },
        module=found.module,
        textbook=dict,
    )


def _proved(choices: list[Kernel]) -> Kernel:
    """The first that has a bound in float32 too. Raises PrintingError."""
    prove(choices[0], FLOAT64)  # whose domain is that of all
    for kernel in choices[:-1]:
        with suppress(PrintingError):
            prove(kernel, FLOAT32)
            return kernel
    prove(choices[-1], FLOAT32)
    return choices[-1]


def _kernel(
    name: str, found: Made, said: Wording, scaled: ScaledModel, inputs: tuple[Input, ...]
) -> Kernel:
    shown = [output for output in found.graph["outputs"] if not output.endswith(SCALE)]
    apart = [output for output in shown if output + SCALE in found.graph["outputs"]]
    return Kernel(
        name=name,
        result="".join(word.capitalize() for word in name.split("_")),
        summary=said.summaries[name],
        equations=said.equations,
        inputs=inputs,
        outputs=tuple(
            Output(
                output,
                f"{said.meaning(name, output)}{_unit(scaled, output)}",
                relative_to=output + SCALE if output in apart else None,
            )
            for output in shown
        ),
        graph=found.graph,
        source=f"derivation {scaled.name}",
        cancellations={
            difference(output): "it is a difference of two sums, no form without it is known"
            for output in sorted(apart)
        },
    )


def _unit(scaled: ScaledModel, output: str) -> str:
    """What an output has to be multiplied with, or is counted in, to be that of the model as it is
    written: nothing where that is 1.
    """
    (seen,) = scaled.measurement_scale
    if output in GAINS:
        factor = sp.cancel(seen / scaled.state_scale[GAINS.index(output)])
        return "" if factor == 1 else f" times {factor}"
    first, second = (scaled.state_scale[int(place) - 1] for place in output.split("_")[1])
    return f" in units of {sp.cancel(first * second)}"


def _inputs(
    original: Model, scaled: ScaledModel, found: Made, single: tuple[str, str]
) -> tuple[Input, ...]:
    index = f"Lambda, with Lambda^2 = {scaled.noise_ratio}"
    used = set(symbols_of(found.graph))
    parameters = tuple(
        closed(entry.quantity.name, entry.quantity.meaning, *entry.kernel_range)
        for entry in original.parameters
        if entry.quantity.name in used
    )
    return (closed("tracking_index", index, *INDEX_RANGE, single), *parameters)


def linear(*terms: tuple[Any, str]) -> str:
    """Coefficients times names ("": a number alone) as a sum, such as "d0 - 2 q"; "0" for none."""
    found = ""
    for weight, name in ((sp.sympify(weight), name) for weight, name in terms):
        if weight == 0:
            continue
        negative = weight.could_extract_minus_sign()
        size = -weight if negative else weight
        plain = size.is_Integer or size.is_Symbol or (not name and not size.is_Add)
        text = name if name and size == 1 else f"{size if plain else f'({size})'} {name}".rstrip()
        found += f" {'-' if negative else '+'} {text}" if found else f"{'-' * negative}{text}"
    return found or "0"
