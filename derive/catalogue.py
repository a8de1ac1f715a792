"""The catalogue: every subject that can be derived, as a tuple written by hand."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from gainproof.derive.estimation import multipath_location
from gainproof.derive.families import (
    acceleration_increments,
    continuous_white_acceleration,
    continuous_white_jerk,
    fixed_gain_alpha_beta,
    fixed_gain_alpha_beta_gamma,
    interacting_gains,
    least_squares,
    position_velocity,
    position_velocity_random_acceleration,
    position_velocity_random_velocity,
    random_acceleration,
    random_jerk,
    random_velocity,
    wiener_acceleration,
)
from gainproof.derive.filter_step import subject as filter_step
from gainproof.derive.recursion import three_states, two_states
from gainproof.derive.sensors import converted_measurements, polar_coordinates, range_doppler
from gainproof.derive.subject import Subject
from gainproof.derive.updated_gains import subject as updated_gains


@dataclass(frozen=True)
class Entry:
    """A subject's name, title and how to derive it."""

    name: str
    title: str
    build: Callable[[], Subject]


CATALOGUE: tuple[Entry, ...] = (
    Entry(random_velocity.NAME, random_velocity.TITLE, random_velocity.build),
    Entry(random_acceleration.NAME, random_acceleration.TITLE, random_acceleration.build),
    Entry(
        continuous_white_acceleration.NAME,
        continuous_white_acceleration.TITLE,
        continuous_white_acceleration.build,
    ),
    Entry(
        acceleration_increments.NAME, acceleration_increments.TITLE, acceleration_increments.build
    ),
    Entry(wiener_acceleration.NAME, wiener_acceleration.TITLE, wiener_acceleration.build),
    Entry(random_jerk.NAME, random_jerk.TITLE, random_jerk.build),
    Entry(continuous_white_jerk.NAME, continuous_white_jerk.TITLE, continuous_white_jerk.build),
    *(
        Entry(
            least_squares.NAMES[degree], least_squares.TITLES[degree], least_squares.builder(degree)
        )
        for degree in range(3)
    ),
    Entry(position_velocity.NAME, position_velocity.TITLE, position_velocity.build),
    Entry(
        position_velocity_random_acceleration.NAME,
        position_velocity_random_acceleration.TITLE,
        position_velocity_random_acceleration.build,
    ),
    Entry(
        position_velocity_random_velocity.NAME,
        position_velocity_random_velocity.TITLE,
        position_velocity_random_velocity.build,
    ),
    Entry(two_states.NAME, two_states.TITLE, two_states.build),
    Entry(three_states.NAME, three_states.TITLE, three_states.build),
    Entry(fixed_gain_alpha_beta.NAME, fixed_gain_alpha_beta.TITLE, fixed_gain_alpha_beta.build),
    Entry(
        fixed_gain_alpha_beta_gamma.NAME,
        fixed_gain_alpha_beta_gamma.TITLE,
        fixed_gain_alpha_beta_gamma.build,
    ),
    Entry(interacting_gains.NAME, interacting_gains.TITLE, interacting_gains.build),
    Entry(polar_coordinates.NAME, polar_coordinates.TITLE, polar_coordinates.build),
    Entry(converted_measurements.NAME, converted_measurements.TITLE, converted_measurements.build),
    Entry(range_doppler.NAME, range_doppler.TITLE, range_doppler.build),
    Entry(multipath_location.NAME, multipath_location.TITLE, multipath_location.build),
    Entry(filter_step.NAME, filter_step.TITLE, filter_step.build),
    Entry(updated_gains.NAME, updated_gains.TITLE, updated_gains.build),
)
