"""Which subjects have a play: their inputs, and the printed scripts that these move."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Slider:
    """An input: a kernel's argument, its label, the slider's ends and where it begins.

    The number field beside the slider takes whatever the kernel takes.
    """

    argument: str
    label: str
    least: float
    most: float
    begins: float
    logarithmic: bool


@dataclass(frozen=True)
class Subject:
    """`kind` is one of `play.families.js`; `scripts` are files of `generated`, in order; `swept`
    names the input over which curves go, if there is one.
    """

    name: str
    kind: str
    sliders: tuple[Slider, ...]
    scripts: tuple[str, ...]
    swept: str = ""


INDEX = Slider("tracking_index", "Tracking index Λ", 1e-3, 1e3, 1.0, True)
RATIO = Slider("velocity_ratio", "Velocity ratio S", 1e-2, 1e2, 1.0, True)
ALPHA = Slider("alpha", "Gain α", 0.005, 2.1, 0.5, False)
BETA = Slider("beta", "Gain β", 0.005, 4.2, 0.2, False)
GAMMA = Slider("gamma", "Gain γ", 0.005, 2.0, 0.05, False)


def _script(name: str) -> str:
    return f"{name.replace('-', '_')}.js"


def _steady(name: str, kind: str, fixed: str) -> Subject:
    return Subject(name, kind, (INDEX,), (_script(name), _script(fixed)), INDEX.argument)


def _both(name: str) -> Subject:
    return Subject(name, "both-measured", (INDEX, RATIO), (_script(name),), INDEX.argument)


SUBJECTS = (
    _steady("random-velocity", "two-states", "alpha-beta"),
    _steady("random-acceleration", "two-states", "alpha-beta"),
    _steady("continuous-white-acceleration", "two-states", "alpha-beta"),
    _steady("acceleration-increments", "three-states", "alpha-beta-gamma"),
    _steady("wiener-acceleration", "three-states", "alpha-beta-gamma"),
    _steady("random-jerk", "three-states", "alpha-beta-gamma"),
    _steady("continuous-white-jerk", "three-states", "alpha-beta-gamma"),
    _both("position-velocity"),
    _both("position-velocity-random-acceleration"),
    _both("position-velocity-random-velocity"),
    Subject("alpha-beta", "two-gains", (ALPHA, BETA), (_script("alpha-beta"),)),
    Subject(
        "alpha-beta-gamma", "three-gains", (ALPHA, BETA, GAMMA), (_script("alpha-beta-gamma"),)
    ),
)


def subject_of(name: str) -> Subject | None:
    """The play of a derivation; None where there is none."""
    return next((subject for subject in SUBJECTS if subject.name == name), None)
