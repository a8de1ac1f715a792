"""The kernels of the recursion of three states, as expression graphs."""

from __future__ import annotations

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.recursion import three_state_forms as forms
from gainproof.derive.recursion.three_state_names import ENTRIES, FACTORS, GAINS, Q, R, S, T
from gainproof.derive.recursion.three_state_noise import TripleNoise
from gainproof.derive.recursion.three_state_start import started

MEASURED = "measurement_variance"


def graphs(noises: tuple[TripleNoise, ...]) -> dict[str, Graph]:
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
    return found


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


def start_graph(noise: TripleNoise) -> Graph:
    """Factors after the first three positions."""
    builder = GraphBuilder()
    names = {S: "first_interval", T: "interval", Q: "strength", R: MEASURED}
    given = {symbol: builder.symbol(name) for symbol, name in names.items()}
    return builder.graph(_factors(started(noise, given)))


def predict_graph(noise: TripleNoise) -> Graph:
    """Factors after an interval."""
    builder = GraphBuilder()
    given = _given(builder)
    interval, strength = builder.symbol("interval"), builder.symbol("strength")
    return builder.graph(_factors(forms.predicted(noise, given, interval, strength)))


def _factors(f: forms.Triple) -> dict[str, Node]:
    return dict(zip(FACTORS, (f.first, f.second, f.third, f.a, f.b, f.c), strict=True))
