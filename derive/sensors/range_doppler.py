"""Range and Doppler: range and range rate between moving points, with their derivatives.

The derivation is the page `range-doppler` of `derive/pages`; here is what it does not say.
"""

from __future__ import annotations

from typing import Any

from gainproof.derive.derivation import Derivation
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.sensors.range_doppler_components import component_steps, kernel_steps
from gainproof.derive.sensors.range_doppler_graphs import graphs as one_station
from gainproof.derive.sensors.range_doppler_module import kernel_module
from gainproof.derive.sensors.range_doppler_pair_graphs import graphs as two_stations
from gainproof.derive.sensors.range_doppler_pairs import pair_steps, pair_towers
from gainproof.derive.sensors.range_doppler_textbook import textbook
from gainproof.derive.sensors.range_doppler_towers import towers
from gainproof.derive.source import DOPPLER, ELEMENTARY
from gainproof.derive.subject import Program, Subject

NAME = "range-doppler"
LATEX = {"q": "f_+", "new_rate": "g_+", "new_unit": "u_+", "new_turning": "h_+"}
LENGTH, VECTOR = ("unit", "1"), ("unit", "d")
HINTS: dict[str, dict[str, Any]] = {
    "parts-of-velocity": {"numbers": ["r' w"]},
    "turning-size": {"numbers": ["r' w"], "squares": [("g I_1", LENGTH, {"weight": "1/f^2"})]},
    "rate-size": {"numbers": ["r' w"], "squares": [("h", VECTOR, {"weight": "f^2"})]},
    "range-convex": {
        "numbers": ["r' a"],
        "squares": [("u_new - u", VECTOR, {"weight": "f_new/2"})],
    },
    "range-remainder": {
        "numbers": ["r' a"],
        "squares": [("(f_new - f) I_1", LENGTH, {"weight": "1/(2 f)"})],
    },
    "range-remainder-across": {"numbers": ["r' a"]},
    "range-change": {
        "numbers": ["r' a"],
        "squares": [("I_1", "range-convex", {"weight": "2 f"})],
    },
    "rate-remainder": {"numbers": ["a' w"]},
    "inner-product-size": {"numbers": ["r' a"], "squares": [("P a", VECTOR)]},
    "hessian-semidefinite": {"squares": [("P", VECTOR, {"weight": "1/f"})]},
    "hessian-largest": {"squares": [("u'", LENGTH, {"weight": "1/f"})]},
    "bend-along": {"numbers": ["r' w"]},
    "course": {"heavy": ["a"], "numbers": ["r' w"]},
    "range-acceleration": {"numbers": ["r' w"]},
    "acceleration-across": {"numbers": ["r' w"]},
    "acceleration-positive": {"numbers": ["r' w"], "squares": [("h", VECTOR, {"weight": "f"})]},
    "bistatic-least": {"squares": [("u + u_2", VECTOR, {"weight": "f f_2"})]},
    "difference-most": {"squares": [("u - u_2", VECTOR, {"weight": "f f_2"})]},
    "range-difference": {"numbers": ["r' r_2"]},
}
"""What proofs use besides their conditions: see `pages.matrices`; inner products are numbers."""


def build() -> Subject:
    """Derive range, range rate, their derivatives and what is left beyond these."""
    single, pairs, held = one_station(), two_stations(), towers()
    given = Given(
        towers=(*held, *pair_towers()),
        hints=HINTS,
        steps={
            "one-station": [*component_steps(held), *kernel_steps(single)],
            "two-stations": pair_steps(pairs),
        },
    )
    page = written(NAME, given)
    made = {**single, **pairs}
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(
            page.opening, page.steps, (DOPPLER.key, ELEMENTARY.key), {**page.latex, **LATEX}
        ),
        towers=page.towers,
        programs={
            name: Program({entry: entry for entry in symbols_of(graph)}, graph)
            for name, graph in made.items()
        },
        module=kernel_module(NAME, page.title, made),
        textbook=textbook,
        settings=page.settings,
    )
