"""The parameters under converted measurements in space, and what is made of them.

Where signs are shown the elevation is 0 or above; below the horizon everything is the mirror image.
In the other towers it is any, and the numbers that noise keeps are any above 0: what is claimed
there are identities in them.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.algebra.variables import above_zero, from_zero
from gainproof.derive.sensors import converted_space_forms as forms
from gainproof.derive.sensors.circles import bearing_circle, elevation_circle
from gainproof.derive.sensors.converted_forms import Noise
from gainproof.derive.sensors.converted_forms import spread as flat_spread
from gainproof.derive.sensors.converted_names import KEPT, LOSS, SIGMA_A, SIGMA_R, R
from gainproof.derive.sensors.converted_space_forms import Frame, Sight
from gainproof.derive.sensors.converted_space_names import (
    BOTH,
    COS_E,
    ENTRIES,
    KEPT_E,
    LA,
    LE,
    LEVEL,
    LOSS_E,
    MATRICES,
    ONCE,
    SIGMA_E,
    SIN_E,
    TWICE,
    UPWARDS,
    squares,
)

DEVIATIONS = ("range_deviation", "elevation_deviation", "azimuth_deviation")


def sight() -> Sight:
    """Over the named quantities."""
    rising = Noise(R, SIGMA_R**2, LE, 1 - LE)
    return Sight(COS_E, SIN_E, rising, KEPT, LA, 1 - LA)


def frames() -> dict[str, Frame]:
    """What the four conversions state, by the names of `MATRICES`."""
    s = sight()
    made = (
        forms.classical(s, SIGMA_E, SIGMA_A),
        forms.debiased(s),
        forms.unbiased(s, KEPT_E),
        forms.spread(s),
    )
    return dict(zip(MATRICES, made, strict=True))


def space_tower() -> Tower:
    """Covariances ahead, across and up."""
    elements: dict[str, sp.Expr] = {**elevation_circle(), **_squares(), **_upright()}
    for name in MATRICES:
        elements |= _entries(name)
    factors = (1, 1 + BOTH - BOTH**2, 1 / BOTH, BOTH), (1, 1 + KEPT_E - LE, 1 / KEPT_E, KEPT_E)
    for symbols, values in zip((LEVEL, UPWARDS), factors, strict=True):
        for symbol, value in zip(symbols.values(), values, strict=True):
            elements[str(symbol)] = sp.sympify(value)
    own = above_zero("slant_range", *DEVIATIONS, "kept_azimuth", "kept_elevation", "a")
    return Tower("space", own, (), elements)


def signs_tower() -> Tower:
    """Those of the unbiased and the modified conversion once more, the elevation 0 or above."""
    elements: dict[str, sp.Expr] = {**elevation_circle()}
    elements |= {"kept_azimuth": 1 / (1 + LOSS), "kept_elevation": 1 / (1 + LOSS_E)}
    elements |= _squares() | _upright() | _entries("space_unbiased") | _entries("space_modified")
    own = above_zero("slant_range", "range_deviation", "azimuth_loss", "elevation_loss")
    return Tower("signs", (*own, Parameter("a", above=None, start="1")), (), elements)


def _squares() -> dict[str, sp.Expr]:
    found = {"cosine_square": (1 + LA**2) / 2, "sine_square": (1 - LA**2) / 2}
    for symbols, kept in ((ONCE, LE**2), (TWICE, LE**4)):
        found |= {str(s): value for s, value in zip(symbols, squares(kept), strict=True)}
    return found


def _upright() -> dict[str, sp.Expr]:
    s = sight()
    upright = forms.upright(s, flat_spread(s.rising))
    return dict(
        zip((f"upright_{entry}" for entry in ("ahead", "up", "tilt")), upright, strict=True)
    )


def _entries(name: str) -> dict[str, sp.Expr]:
    return {f"{name}_{entry}": getattr(frames()[name], entry) for entry in ENTRIES}


def turned_tower() -> Tower:
    """What the kernels in space are made of."""
    circle = bearing_circle()
    elements: dict[str, sp.Expr] = {
        **elevation_circle(),
        "cos_azimuth": circle["cos_bearing"],
        "sin_azimuth": circle["sin_bearing"],
        "change_azimuth": LA - 1,
        "change_elevation": LE - 1,
    }
    own = above_zero("slant_range", *DEVIATIONS, "kept_azimuth", "kept_elevation", "a")
    turned = from_zero("g", "k")
    return Tower("turned", (*own, *turned), (), elements)
