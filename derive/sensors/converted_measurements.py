"""Converted measurements: polar ones made Cartesian, what that does to their noise."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.sensors.algebraic import algebraic
from gainproof.derive.sensors.converted_correlated_definite import correlated_definite_steps
from gainproof.derive.sensors.converted_correlated_graphs import (
    correlated_kernel_steps,
)
from gainproof.derive.sensors.converted_correlated_graphs import graphs as correlated_graphs
from gainproof.derive.sensors.converted_correlated_steps import correlated_steps
from gainproof.derive.sensors.converted_correlated_tower import LATEX as CORRELATED
from gainproof.derive.sensors.converted_correlated_tower import (
    correlated_tower,
    turned_correlated_tower,
)
from gainproof.derive.sensors.converted_graphs import graphs
from gainproof.derive.sensors.converted_module import kernel_module
from gainproof.derive.sensors.converted_names import LATEX
from gainproof.derive.sensors.converted_space_correlated import LATEX as BOTH_CORRELATED
from gainproof.derive.sensors.converted_space_correlated import (
    space_correlated_steps,
    space_correlated_tower,
)
from gainproof.derive.sensors.converted_space_graphs import graphs as space_graphs
from gainproof.derive.sensors.converted_space_kernels import space_kernel_steps
from gainproof.derive.sensors.converted_space_names import LATEX as IN_SPACE
from gainproof.derive.sensors.converted_space_steps import space_steps
from gainproof.derive.sensors.converted_space_steps_conversions import space_conversion_steps
from gainproof.derive.sensors.converted_space_steps_growth import space_growth_steps
from gainproof.derive.sensors.converted_space_steps_signs import space_sign_steps
from gainproof.derive.sensors.converted_space_towers import signs_tower, space_tower, turned_tower
from gainproof.derive.sensors.converted_steps_conversions import conversion_steps
from gainproof.derive.sensors.converted_steps_kernels import kernel_steps
from gainproof.derive.sensors.converted_steps_noise import (
    measurement_steps,
    truth_steps,
    turn_steps,
)
from gainproof.derive.sensors.converted_steps_range import range_steps
from gainproof.derive.sensors.converted_steps_table import table_steps
from gainproof.derive.sensors.converted_towers import main_tower, plane_tower
from gainproof.derive.source import (
    DEBIASED,
    ELEMENTARY,
    MODIFIED,
    PROBABILITY,
    TRACKER_LIBRARY,
    UNBIASED,
)
from gainproof.derive.subject import Program, Subject

NAME = "converted-measurements"
TITLE = "Converted measurements: range and angles made Cartesian, with their noise"
OPENING = (
    "A polar measurement made Cartesian is biased, and its noise depends on where the target is. "
    "Four conversions are in use. What is each exact for, and what is its covariance?"
)


def build() -> Subject:
    """Derive the moments, the four conversions, what they are exact for, and their growth."""
    made = graphs() | space_graphs() | correlated_graphs()
    plain = {name: algebraic(graph) for name, graph in made.items()}
    steps = (
        *turn_steps(),
        *truth_steps(),
        *measurement_steps(),
        *conversion_steps(),
        *table_steps(),
        *range_steps(),
        *correlated_steps(),
        *space_steps(),
        *space_sign_steps(),
        *space_conversion_steps(),
        *space_growth_steps(),
        *space_correlated_steps(),
        *correlated_definite_steps(),
        *kernel_steps(plain),
        *space_kernel_steps(plain),
        *correlated_kernel_steps(plain),
    )
    sources = (DEBIASED, UNBIASED, MODIFIED, TRACKER_LIBRARY, PROBABILITY, ELEMENTARY)
    towers = (
        main_tower(),
        correlated_tower(),
        space_tower(),
        signs_tower(),
        plane_tower(),
        turned_tower(),
        space_correlated_tower(),
        turned_correlated_tower(),
    )
    return Subject(
        name=NAME,
        title=TITLE,
        model=None,
        derivation=Derivation(
            OPENING,
            steps,
            tuple(each.key for each in sources),
            LATEX | CORRELATED | IN_SPACE | BOTH_CORRELATED,
        ),
        towers={tower.name: tower for tower in towers},
        programs={
            name: Program({entry: entry for entry in symbols_of(graph)}, graph)
            for name, graph in plain.items()
        },
        module=kernel_module(NAME, TITLE, made),
        textbook=dict,
    )
