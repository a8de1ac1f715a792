"""Polar coordinates: range, elevation, bearing from north; their derivatives, noise and rates."""

from __future__ import annotations

from gainproof.derive.derivation import Derivation
from gainproof.derive.printer.graph import symbols_of
from gainproof.derive.sensors.algebraic import algebraic
from gainproof.derive.sensors.polar_graphs import graphs
from gainproof.derive.sensors.polar_module import kernel_module
from gainproof.derive.sensors.polar_names import LATEX
from gainproof.derive.sensors.polar_steps_course import course_steps
from gainproof.derive.sensors.polar_steps_jacobian import inverse_steps, jacobian_steps
from gainproof.derive.sensors.polar_steps_kernels import definition_steps, kernel_steps
from gainproof.derive.sensors.polar_steps_map import bearing_steps, elevation_steps, map_steps
from gainproof.derive.sensors.polar_steps_noise import covariance_steps, mean_steps
from gainproof.derive.sensors.polar_towers import course_tower, main_tower, plane_tower
from gainproof.derive.source import ELEMENTARY, LECTURE, PROBABILITY
from gainproof.derive.subject import Program, Subject

NAME = "polar-coordinates"
TITLE = "Polar coordinates: range, elevation and bearing from north"
OPENING = (
    "Sensors measure range and angles, filters run in Cartesian coordinates. The map between "
    "them, its derivatives, what it makes of the noise, and how range and angles of a target on a "
    "straight course change."
)


def build() -> Subject:
    """Derive the map, its inverse, their derivatives, noise, bias and rates."""
    made = graphs()
    plain = {name: algebraic(graph) for name, graph in made.items()}
    steps = (
        *elevation_steps(),
        *bearing_steps(),
        *map_steps(),
        *jacobian_steps(),
        *inverse_steps(),
        *covariance_steps(),
        *mean_steps(),
        *course_steps(),
        *definition_steps(),
        *kernel_steps(plain),
    )
    return Subject(
        name=NAME,
        title=TITLE,
        model=None,
        derivation=Derivation(
            OPENING, steps, (LECTURE.key, PROBABILITY.key, ELEMENTARY.key), LATEX
        ),
        towers={tower.name: tower for tower in (main_tower(), course_tower(), plane_tower())},
        programs={
            name: Program({entry: entry for entry in symbols_of(graph)}, graph)
            for name, graph in plain.items()
        },
        module=kernel_module(NAME, TITLE, made),
        textbook=dict,
    )
