"""The kernels of a step, as expression graphs."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.derive.filter_step import forms
from gainproof.derive.filter_step.names import (
    BY_AXIS,
    GAINS,
    POSITION_GAINS,
    STATES,
    VELOCITY_GAINS,
)
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node

KERNELS = ("step_two_states", "step_three_states", "step_interacting")


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    made = (step_graph(2), step_graph(3), interacting_graph())
    return dict(zip(KERNELS, made, strict=True))


def inputs(kernel: str) -> tuple[str, ...]:
    """The arguments of a kernel, in order."""
    if kernel == "step_interacting":
        axes = BY_AXIS["position"], BY_AXIS["velocity"], BY_AXIS["observed"]
        return (*axes[0], *axes[1], "interval", *axes[2], *POSITION_GAINS, *VELOCITY_GAINS)
    size = KERNELS.index(kernel) + 2
    return (*STATES[:size], "interval", "observed", *GAINS[:size])


def step_graph(size: int) -> Graph:
    """One coordinate with two or three states."""
    builder = GraphBuilder()
    state, gains = (_symbols(builder, names[:size]) for names in (STATES, GAINS))
    interval, observed = _symbols(builder, ("interval", "observed"))
    found = forms.stepped(state, interval, observed, gains)
    return builder.graph(
        {f"updated_{name}": value for name, value in zip(STATES, found, strict=False)}
    )


def interacting_graph() -> Graph:
    """Three coordinates, two states each, full gain matrices."""
    builder = GraphBuilder()
    axes = {word: _symbols(builder, names) for word, names in BY_AXIS.items()}
    first, second = (_rows(_symbols(builder, names)) for names in (POSITION_GAINS, VELOCITY_GAINS))
    given = forms.Interacting(axes["position"], axes["velocity"], axes["observed"], first, second)
    position, velocity = forms.interacting(given, builder.symbol("interval"))
    names = (*BY_AXIS["position"], *BY_AXIS["velocity"])
    return builder.graph(
        {f"updated_{n}": value for n, value in zip(names, (*position, *velocity), strict=True)}
    )


def _symbols(builder: GraphBuilder, names: Sequence[str]) -> list[Node]:
    return [builder.symbol(name) for name in names]


def _rows(entries: Sequence[Node]) -> list[Sequence[Node]]:
    return [entries[start : start + 3] for start in (0, 3, 6)]
