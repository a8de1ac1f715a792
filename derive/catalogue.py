"""The catalogue: every subject that can be derived, as a tuple written by hand.

A subject's module is imported when it is derived, so that importing the catalogue costs nothing and
the code of a subject is that of its module and of what this imports.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:  # importing it imports SymPy
    from gainproof.derive.subject import Subject


@dataclass(frozen=True)
class Entry:
    """A subject's name, the module that derives it, and the name of the function there."""

    name: str
    module: str
    function: str = "build"

    def build(self) -> Subject:
        """The subject, derived."""
        subject: Subject = getattr(import_module(self.module), self.function)()
        return subject


_FAMILIES = "gainproof.derive.families"
_LEAST_SQUARES = f"{_FAMILIES}.least_squares"
_SENSORS = "gainproof.derive.sensors"

CATALOGUE: tuple[Entry, ...] = (
    Entry("random-velocity", f"{_FAMILIES}.random_velocity"),
    Entry("random-acceleration", f"{_FAMILIES}.random_acceleration"),
    Entry("continuous-white-acceleration", f"{_FAMILIES}.continuous_white_acceleration"),
    Entry("acceleration-increments", f"{_FAMILIES}.acceleration_increments"),
    Entry("wiener-acceleration", f"{_FAMILIES}.wiener_acceleration"),
    Entry("random-jerk", f"{_FAMILIES}.random_jerk"),
    Entry("continuous-white-jerk", f"{_FAMILIES}.continuous_white_jerk"),
    Entry("least-squares-mean", _LEAST_SQUARES, "mean"),
    Entry("least-squares-line", _LEAST_SQUARES, "line"),
    Entry("least-squares-parabola", _LEAST_SQUARES, "parabola"),
    Entry("position-velocity", f"{_FAMILIES}.position_velocity"),
    Entry(
        "position-velocity-random-acceleration",
        f"{_FAMILIES}.position_velocity_random_acceleration",
    ),
    Entry("position-velocity-random-velocity", f"{_FAMILIES}.position_velocity_random_velocity"),
    Entry("singer", f"{_FAMILIES}.singer"),
    Entry("recursion-two-states", "gainproof.derive.recursion.two_states"),
    Entry("recursion-three-states", "gainproof.derive.recursion.three_states"),
    Entry("alpha-beta", f"{_FAMILIES}.fixed_gain_alpha_beta"),
    Entry("alpha-beta-gamma", f"{_FAMILIES}.fixed_gain_alpha_beta_gamma"),
    Entry("interacting-gains", f"{_FAMILIES}.interacting_gains"),
    Entry("polar-coordinates", f"{_SENSORS}.polar_coordinates"),
    Entry("converted-measurements", f"{_SENSORS}.converted_measurements"),
    Entry("range-doppler", f"{_SENSORS}.range_doppler"),
    Entry("bearings-only", f"{_SENSORS}.bearings_only"),
    Entry("multipath-location", "gainproof.derive.estimation.multipath_location"),
    Entry("filter-step", "gainproof.derive.filter_step.subject"),
    Entry("updated-gains", "gainproof.derive.updated_gains.subject"),
)
