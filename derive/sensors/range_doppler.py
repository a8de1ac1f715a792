"""Range and Doppler: range and range rate between moving points, with their derivatives.

The derivation is the page `range-doppler` of `derive/pages`; here is what it does not say.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.kernel_formulas import PLANE
from gainproof.derive.pages.kernel_page import page_graphs, page_module
from gainproof.derive.printer.graph import Graph
from gainproof.derive.sensors.range_doppler_components import component_steps, kernel_steps
from gainproof.derive.sensors.range_doppler_names import SPACE_AXES, places, velocities
from gainproof.derive.sensors.range_doppler_pairs import pair_steps, pair_towers
from gainproof.derive.sensors.range_doppler_textbook import textbook
from gainproof.derive.sensors.range_doppler_towers import towers
from gainproof.derive.source import DOPPLER, ELEMENTARY
from gainproof.derive.subject import Subject, page_subject

NAME = "range-doppler"
FORMULAS = Path(__file__).with_name("range_doppler_kernels.md")
PAIRS = ("bistatic_range_doppler", "range_doppler_difference")
"""The kernels of two stations."""
NAMED = (
    "(other_)?((place|velocity|turning)_[xyz]|range_rate)|(baseline|drift|reach)_[xyz]"
    "|range_(rate_)?difference(_D_[xyz])?"
)
"""What proofs put names for."""
LATEX = {"q": "f_+", "new_rate": "g_+", "new_unit": "u_+", "new_turning": "h_+"}


def graphs() -> dict[str, Graph]:
    """The graph of each kernel by its name, those of two stations last."""
    found = page_graphs(FORMULAS, _inputs, NAMED)
    return {name: found[name] for name in sorted(found, key=of_two_stations)}


def of_two_stations(kernel: str) -> bool:
    """Whether a kernel has a second station."""
    return kernel.removesuffix(PLANE) in PAIRS


def _inputs(kernel: str) -> dict[str, str]:
    who = {"target": "target", "station": "station"}
    if of_two_stations(kernel):
        who |= {"station": "first_station", "other_station": "second_station"}
    found = {
        name: argument
        for called, whose in who.items()
        for vector in (places, velocities)
        for name, argument in zip(
            vector(called, SPACE_AXES), vector(whose, SPACE_AXES), strict=True
        )
    }
    return {**found, "carrier_frequency": "carrier_frequency"}


def build() -> Subject:
    """Derive range, range rate, their derivatives and what is left beyond these."""
    made, held = graphs(), towers()
    single, pairs = (
        {name: graph for name, graph in made.items() if of_two_stations(name) is two}
        for two in (False, True)
    )
    given = Given(
        towers=(*held, *pair_towers()),
        steps={
            "one-station": [*component_steps(held), *kernel_steps(single)],
            "two-stations": pair_steps(pairs),
        },
    )
    page = written(NAME, given)
    module = page_module(FORMULAS, made, NAME, page.title)
    subject = page_subject(NAME, page, module, made, (DOPPLER.key, ELEMENTARY.key), LATEX)
    return replace(subject, textbook=textbook)
