"""How stations and target lie and move, in words: explanations, on which nothing is decided."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.measurement import seen
from gainproof.location.problem import Problem
from gainproof.location.stations import Stations

FLAT = 1e-9
"""Stations this share of their spread beside a line or plane are taken to lie on it, in words."""

RADIAL = 1e-6


def shape_words(given: Stations, position: Reals) -> str:
    """How stations and target lie, in words."""
    apart = given.positions - given.centre
    _, sizes, axes = np.linalg.svd(apart, full_matrices=True)
    spread = given.spread
    flat = int((sizes > FLAT * max(spread, 1e-300)).sum()) if spread > 0 else 0
    d = given.dimension
    if flat == 0:
        return "there is one station" if len(given.names) == 1 else "all stations are in one place"
    if flat == d:
        return ""
    where = "on a line" if flat == 1 else "in a plane"
    off = float(np.linalg.norm(axes[flat:] @ (position - given.centre)))
    on = off <= 1e-6 * max(spread, float(np.linalg.norm(position - given.centre)))
    return f"the stations lie {where}" + (" and the target on it" if on else "")


def motion_words(asked: Problem, unknowns: Reals) -> str:
    """Whether range rates tell anything of position there, in words."""
    if not asked.velocity:
        return ""
    found = seen(asked.stations, *asked.split(unknowns[None, :]))
    if not found.speed.any():
        return "nothing moves, so that range rates say nothing of the position"
    if np.linalg.norm(found.turn, axis=2).max() <= RADIAL * (found.speed / found.distance).max():
        return "all motion is along the lines of sight, so that range rates say nothing of position"
    return ""


def listed(words: Sequence[str]) -> str:
    """a, b and c."""
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
