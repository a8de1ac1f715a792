"""The kernels of the recursion of three states, as expression graphs."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.recursion import triple_forms as forms
from gainproof.derive.recursion.triple_names import ENTRIES, FACTORS, GAINS
from gainproof.derive.recursion.triple_noise import TripleNoise

MEASURED = "measurement_variance"


def graphs(noises: tuple[TripleNoise, ...]) -> dict[str, Graph]:
    """The graph of each kernel by its name."""
    found = {
        "covariance": covariance_graph(),
        "gains": gains_graph(),
        "update": update_graph(),
    }
    return {**found, **{f"predict_{noise.name}": predict_graph(noise) for noise in noises}}


def _given(builder: GraphBuilder) -> forms.Triple:
    return forms.Triple(*(builder.symbol(name) for name in FACTORS))


def covariance_graph() -> Graph:
    """Entries from factors."""
    builder = GraphBuilder()
    entries = forms.covariance(_given(builder))
    return builder.graph({f"covariance_{ij}": x for ij, x in zip(ENTRIES, entries, strict=True)})


def gains_graph() -> Graph:
    """Gains and innovation's variance."""
    builder = GraphBuilder()
    new = forms.updated(_given(builder), builder.symbol(MEASURED))
    gains = (new.position_gain, new.velocity_gain, new.acceleration_gain)
    outputs = dict(zip(GAINS, gains, strict=True))
    return builder.graph({**outputs, "innovation_variance": new.innovation})


def update_graph() -> Graph:
    """Factors after a measurement."""
    builder = GraphBuilder()
    return builder.graph(_factors(forms.updated(_given(builder), builder.symbol(MEASURED)).factors))


def predict_graph(noise: TripleNoise) -> Graph:
    """Factors after an interval."""
    builder = GraphBuilder()
    given = _given(builder)
    interval, strength = builder.symbol("interval"), builder.symbol("strength")
    return builder.graph(_factors(forms.predicted(noise, given, interval, strength)))


def _factors(f: forms.Triple) -> dict[str, Node]:
    return dict(zip(FACTORS, (f.first, f.second, f.third, f.a, f.b, f.c), strict=True))
