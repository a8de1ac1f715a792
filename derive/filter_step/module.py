"""The printed module of filter steps: what each kernel is called and says of itself."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.filter_step.kernels import inputs
from gainproof.derive.filter_step.names import GAINS, MEANINGS, POSITION_GAINS, VELOCITY_GAINS
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed, signed

SIZE = ("0", "1e40", ("0", "1e8"))
"""Magnitudes of positions, velocities and accelerations."""
TIME = ("1e-10", "1e10", ("1e-3", "1e4"))
GAIN = ("0", "1e4", ("0", "1e4"))
VELOCITY_GAIN = ("0", "1e14", ("0", "1e7"))

SUMMARIES = {
    "step_two_states": "Prediction and update of tracks with position and velocity.",
    "step_three_states": "Prediction and update of tracks with position, velocity, acceleration.",
    "step_interacting": "Prediction and update of tracks in three coordinates that interact.",
}
EQUATIONS = {
    "step_two_states": (
        "updated_position = p + alpha r, updated_velocity = velocity + beta r/t,",
        "p = position + t velocity, r = observed - p",
    ),
    "step_three_states": (
        "updated_position = p + alpha r, updated_velocity = w + beta r/t,",
        "updated_acceleration = acceleration + gamma r/t^2,",
        "p = position + t velocity + t^2 acceleration/2, w = velocity + t acceleration,",
        "r = observed - p",
    ),
    "step_interacting": (
        "updated positions = p + K1 r, updated velocities = velocities + K2 r,",
        "p = positions + t velocities, r = observed - p",
    ),
}


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of filter steps."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in made.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(_input(entry) for entry in inputs(kernel)),
        outputs=tuple(Output(entry, MEANINGS[entry], by_terms=True) for entry in graph["outputs"]),
        graph=graph,
        source=f"derivation {name}",
    )


def _input(entry: str) -> Input:
    meaning = MEANINGS[entry]
    if entry == "interval":
        return closed(entry, meaning, *TIME)
    if entry in VELOCITY_GAINS:
        return signed(entry, meaning, *VELOCITY_GAIN)
    if entry in (*POSITION_GAINS, *GAINS):
        return signed(entry, meaning, *GAIN)
    return signed(entry, meaning, *SIZE)
