"""The kernels of the recursion of two states, as expression graphs."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.recursion import forms
from gainproof.derive.recursion.names import ENTRIES, FACTORS, GAINS
from gainproof.derive.recursion.noise import Noise

MEASURED = "measurement_variance"


def graphs(noises: tuple[Noise, ...]) -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    found = {
        "covariance": covariance_graph(),
        "gains": gains_graph(),
        "update": update_graph(),
    }
    for noise in noises:
        found[f"start_{noise.name}"] = start_graph(noise)
    for noise in noises:
        found[f"predict_{noise.name}"] = predict_graph(noise)
    for noise in noises:
        found[f"step_{noise.name}"] = step_graph(noise)
    return {**found, "hand_over": hand_over_graph()}


def _given(builder: GraphBuilder) -> forms.Factors:
    return forms.factors(*(builder.symbol(name) for name in FACTORS))


def covariance_graph() -> Graph:
    """Entries from factors."""
    builder = GraphBuilder()
    entries = forms.covariance(_given(builder))
    return builder.graph({f"covariance_{ij}": x for ij, x in zip(ENTRIES, entries, strict=True)})


def gains_graph() -> Graph:
    """Gain and innovation's variance."""
    builder = GraphBuilder()
    new = forms.updated(_given(builder), builder.symbol(MEASURED))
    return builder.graph(_gains(new))


def _gains(new: forms.Updated) -> dict[str, Node]:
    position, velocity = GAINS
    return {
        position: new.position_gain,
        velocity: new.velocity_gain,
        "innovation_variance": new.innovation,
    }


def update_graph() -> Graph:
    """Factors after a measurement."""
    builder = GraphBuilder()
    new = forms.updated(_given(builder), builder.symbol(MEASURED))
    return builder.graph(_factors(new))


def _factors(new: forms.Updated | forms.Factors) -> dict[str, Node]:
    return dict(zip(FACTORS, (new.position, new.shear, new.velocity), strict=True))


def _predicted(builder: GraphBuilder, noise: Noise) -> forms.Factors:
    given = _given(builder)
    return forms.predicted(noise, given, builder.symbol("interval"), builder.symbol("strength"))


def start_graph(noise: Noise) -> Graph:
    """Factors after the first two positions."""
    builder = GraphBuilder()
    given = (builder.symbol(name) for name in ("interval", "strength", MEASURED))
    return builder.graph(_factors(forms.started(noise, *given)))


def predict_graph(noise: Noise) -> Graph:
    """Factors after an interval."""
    builder = GraphBuilder()
    return builder.graph(_factors(_predicted(builder, noise)))


def step_graph(noise: Noise) -> Graph:
    """An interval, then a measurement."""
    builder = GraphBuilder()
    new = forms.updated(_predicted(builder, noise), builder.symbol(MEASURED))
    return builder.graph({**_factors(new), **_gains(new)})


def hand_over_graph() -> Graph:
    """The largest k at which the gain of a fitted line is not below alpha, as a real number."""
    builder = GraphBuilder()
    alpha = builder.symbol("alpha")
    rest = 1 - alpha
    root = builder.sqrt(rest * 16 + alpha * alpha)
    last = ((1 + rest * 3) + root) / (alpha * 2)
    return builder.graph({"last_sample": last}, {"root": root})
