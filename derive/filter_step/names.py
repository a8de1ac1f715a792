"""The quantities of a step: their names, how they are printed."""

from __future__ import annotations

from gainproof.derive.filter_step.forms import AXES

STATES = ("position", "velocity", "acceleration")
GAINS = ("alpha", "beta", "gamma")
PLACES = ("11", "12", "13", "21", "22", "23", "31", "32", "33")
POSITION_GAINS = tuple(f"position_gain_{ij}" for ij in PLACES)
VELOCITY_GAINS = tuple(f"velocity_gain_{ij}" for ij in PLACES)
BY_AXIS = {word: tuple(f"{axis}_{word}" for axis in AXES) for word in (*STATES[:2], "observed")}

SIGNED = (
    *STATES,
    "observed",
    *GAINS,
    *(name for names in BY_AXIS.values() for name in names),
    *POSITION_GAINS,
    *VELOCITY_GAINS,
)
"""What may have either sign."""


def root_of(name: str) -> str:
    """The positive number u with u - 1/u = the quantity."""
    return f"root_of_{name}"


_LATEX = {"position": "x", "velocity": "v", "acceleration": "a", "observed": "z"}
_OF_AXIS = {"position": "{}", "velocity": "v_{}", "observed": "{}_o"}
LATEX = {
    "t": "t",
    **_LATEX,
    **{gain: f"\\{gain}" for gain in GAINS},
    **{f"{axis}_{word}": text.format(axis) for axis in AXES for word, text in _OF_AXIS.items()},
    **{f"position_gain_{ij}": f"K_{{1,{ij}}}" for ij in PLACES},
    **{f"velocity_gain_{ij}": f"K_{{2,{ij}}}" for ij in PLACES},
    **{root_of(name): f"u_{{{number}}}" for number, name in enumerate(SIGNED, start=1)},
}


def gain_row(axis: str) -> tuple[str, ...]:
    """The entries of K1, then those of K2, that correct one coordinate."""
    start = 3 * AXES.index(axis)
    return (*POSITION_GAINS[start : start + 3], *VELOCITY_GAINS[start : start + 3])
