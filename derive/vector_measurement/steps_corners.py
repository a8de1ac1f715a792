"""Steps on the corners of the domain: leading terms where both parameters tend together."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import limit
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.corners import (
    GAMMA,
    T,
    W,
    X,
    fixed_index_ends,
    narrow_ends,
)
from gainproof.derive.vector_measurement.ends import root_of_e
from gainproof.derive.vector_measurement.names import PREDICTED, ROOT, UPDATED
from gainproof.derive.vector_measurement.steps_limits import stable_forms
from gainproof.derive.vector_measurement.steps_ties import tie_steps
from gainproof.derive.vector_measurement.towers import rational

Terms = Mapping[str, tuple[sp.Expr, sp.Expr]]
"""By entry: the power of p that it is divided by, and the limit."""

P11, P12, P22 = PREDICTED
U11, U12, U22 = UPDATED


def corner_steps(c: Context) -> list[Step]:
    """Leading terms of the covariances in the three corners."""
    fixed, narrow = fixed_index_ends(c.noise), narrow_ends(c.noise)
    return [
        *tie_steps(c, "fixed_velocity_index"),
        *tie_steps(c, "narrow"),
        *_steps(
            c,
            "small-velocity-index",
            ("fixed_velocity_index", "0", fixed),
            _small(c),
            "Where both parameters tend together, the steady state changes its shape in three "
            "ways. First let `Lambda` and `S` fall to zero with `t = Lambda/S` held. For short "
            "`p` is the root of `Lambda`, and `gamma = sqrt(4 + t^2)`. Then the position is "
            "carried by the measured velocity.",
            "The corners of the domain",
        ),
        *_steps(
            c,
            "small-narrow",
            ("narrow", "0", narrow),
            _narrow(),
            "Second let the index fall faster, with `x = S/sqrt(Lambda)` held; from here on this "
            "is `x`. The larger it is, the less the velocity is measured and the more estimated.",
        ),
        *_steps(
            c,
            "large-velocity-index",
            ("fixed_velocity_index", "infinity", fixed),
            _large(c),
            "Third let `Lambda` and `S` grow without bound with `t` held. Each measurement is then "
            "worth more than all before.",
        ),
    ]


def _small(c: Context) -> Terms:
    """Lambda -> 0, t held: the filter knows the velocity within one interval."""
    half = (GAMMA + T) / 2
    share = GAMMA / (2 * T**2) if c.noise.interval else 1 / (half * T**2)
    level = W if c.noise.determinant else sp.Integer(1)
    return {
        P11: (ROOT**2, level / T),
        U11: (ROOT**2, level / T),
        P12: (ROOT**4, share * half),
        U12: (ROOT**4, share / half),
        P22: (ROOT**4, half / T),
        U22: (ROOT**4, 1 / (half * T)),
    }


def _narrow() -> Terms:
    """Lambda -> 0, x held: from the velocity measured to the velocity estimated."""
    outer = sp.sqrt(1 + 2 * X**2)
    whole = 1 + X**2
    return {
        P11: (ROOT, X * outer / whole),
        U11: (ROOT, X * outer / whole),
        P12: (ROOT**2, X**2 / whole),
        U12: (ROOT**2, X**2 / whole),
        P22: (ROOT**3, X * outer / whole),
        U22: (ROOT**3, X * outer / whole),
    }


def _large(c: Context) -> Terms:
    """Lambda -> infinity, t held: each measurement is worth more than all before."""
    noise = c.noise
    e, area = rational(noise.e), ROOT**4
    if not noise.interval:
        share = 1 / (1 + T**2)
        rate, cross, updated = (area, share), share, share
    elif not e:
        cross, updated = sp.Rational(1, 2), sp.Integer(2)
        share, rate = sp.Integer(0), (ROOT**2, 4 / GAMMA)
    else:
        high = root_of_e(noise)[0] * GAMMA / 2
        whole = W * high + e * T**2 / 4
        cross = high * (W + high) / (2 * whole)
        updated = 2 * high / ((W + high) * whole)
        share = cross - sp.Rational(1, 2)
        rate = (area, share)
    return {
        P11: (area, share + rational(noise.first)),
        U11: (sp.Integer(1), sp.Integer(1)),
        P12: (area, cross),
        U12: (sp.Integer(1), updated),
        P22: (area, share + 1),
        U22: rate,
    }


def _steps(
    c: Context,
    label: str,
    place: tuple[str, str, Mapping[str, Any]],
    terms: Terms,
    sentence: str,
    heading: str = "",
) -> list[Step]:
    tower, point, ends = place
    steps = []
    for name, (power, value) in terms.items():
        expression = real(name) / power
        hint: dict[str, Any] = {"ends": ends}
        if not _shows(c, label, name):
            hint["limit_form"] = stable_forms(c)[name] / power
        relation = limit(expression, point, value, "p")
        steps.append(joined(f"{label}-{name.replace('_', '-')}", relation, tower, hint))
    first, *others = steps
    return [
        replace(
            first,
            sentence=sentence,
            reason=f"Insert `Lambda = p^2` and {_held(label)} in step @result and take the leading "
            "power of `p` in every root and every sum.",
            heading=heading,
            joins=False,
        ),
        *others,
    ]


def _held(label: str) -> str:
    return "`S = p x`" if label == "small-narrow" else "`S = p^2/t`"


def _shows(c: Context, label: str, name: str) -> bool:
    """Whether the short form of the tower, which subtracts, shows its leading term."""
    if name in PREDICTED or label == "small-narrow":
        return True
    if label == "small-velocity-index":
        return name == U11 or (name == U22 and not c.noise.interval)
    return name == U22 and (not c.noise.interval or c.noise.e != 0)
