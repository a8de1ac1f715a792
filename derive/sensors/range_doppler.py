"""Range and Doppler: range and range rate between moving points, with their derivatives."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.sensors.range_doppler_graphs import graphs as one_station
from gainproof.derive.sensors.range_doppler_module import kernel_module
from gainproof.derive.sensors.range_doppler_pair_graphs import graphs as two_stations
from gainproof.derive.sensors.range_doppler_pair_towers import pair_towers
from gainproof.derive.sensors.range_doppler_setting import LATEX, SETTING
from gainproof.derive.sensors.range_doppler_steps_course import (
    course_steps,
    doppler_steps,
    doppler_tower,
)
from gainproof.derive.sensors.range_doppler_steps_hessian import hessian_steps
from gainproof.derive.sensors.range_doppler_steps_kernels import component_steps, kernel_steps
from gainproof.derive.sensors.range_doppler_steps_linear import range_steps, rate_steps
from gainproof.derive.sensors.range_doppler_steps_pairs import pair_steps
from gainproof.derive.sensors.range_doppler_steps_stations import station_steps
from gainproof.derive.sensors.range_doppler_steps_value import value_steps
from gainproof.derive.sensors.range_doppler_textbook import textbook
from gainproof.derive.sensors.range_doppler_towers import towers
from gainproof.derive.source import DOPPLER, ELEMENTARY
from gainproof.derive.subject import Program, Subject

NAME = "range-doppler"
TITLE = "Range and Doppler of moving targets from moving stations"
OPENING = (
    "What a station measures of a target's position and velocity, range and range rate, with all "
    "derivatives, in unit vectors and one over the range. What is said of vectors is proved for "
    "every number of dimensions, as an implication: what it takes for granted stands below it, "
    "after if. X >= Y between inner products is the order of numbers."
)


def build() -> Subject:
    """Derive range, range rate, their derivatives and what is left beyond these."""
    single, pairs = one_station(), two_stations()
    made = {**single, **pairs}
    held = {tower.name: tower for tower in towers()}
    steps = (
        *value_steps(),
        *range_steps(),
        *rate_steps(),
        *hessian_steps(),
        *course_steps(),
        *station_steps(),
        *doppler_steps(),
        *component_steps(tuple(held.values())),
        *kernel_steps(single),
        *pair_steps(pairs),
    )
    return Subject(
        name=NAME,
        title=TITLE,
        model=None,
        derivation=Derivation(OPENING, steps, (DOPPLER.key, ELEMENTARY.key), LATEX),
        towers={**held, **{each.name: each for each in (*pair_towers(), doppler_tower())}},
        programs={
            name: Program({entry: entry for entry in symbols_of(graph)}, graph)
            for name, graph in made.items()
        },
        module=kernel_module(NAME, TITLE, made),
        textbook=textbook,
        settings={SETTING.name: SETTING},
    )
