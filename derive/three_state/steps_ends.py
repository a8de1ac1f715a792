"""Steps on both ends of the index, and the ranges of the gains between them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import increasing_onto, limit
from gainproof.derive.three_state import covariance_entries
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import ALPHA, BETA, GAMMA, INDEX, NU, PREDICTED, REST, XI
from gainproof.derive.three_state.surds import plain_number

Limits = Mapping[str, tuple[sp.Expr, sp.Expr]]

# What each entry grows like for a small index: the power of Lambda times 3, and the factor.
_SMALL = {
    "alpha": (1, 2),
    "beta": (2, 2),
    "gamma": (3, 1),
    "predicted_11": (1, 2),
    "predicted_12": (2, 2),
    "predicted_13": (3, 1),
    "predicted_22": (3, 3),
    "predicted_23": (4, 2),
    "predicted_33": (5, 2),
    "updated_22": (3, 3),
    "updated_23": (4, 2),
    "updated_33": (5, 2),
}


def end_steps(c: Context) -> list[Step]:
    """Leading behaviour as the index falls to zero and grows without bound, and the ranges."""
    where = "" if c.running == "tracking_index" else " As `p` tends to an end, so does the index."
    small = _limits(c, "small", "0", _small())
    large = _limits(c, "large", "infinity", _large(c))
    top = c.constants.least + c.constants.c
    ranges = {
        "alpha-range": increasing_onto(ALPHA, sp.Integer(0), sp.Integer(1), c.running),
        "beta-range": increasing_onto(
            BETA, sp.Integer(0), plain_number(2 * c.constants.least / top), c.running
        ),
        "gamma-range": increasing_onto(GAMMA, sp.Integer(0), plain_number(4 / top), c.running),
    }
    first, *others = (
        joined(name, relation, hint={"ends": c.ends}) for name, relation in ranges.items()
    )
    return [
        replace(
            small[0],
            sentence="A small index: the filter trusts its prediction. Gains and covariances fall "
            f"to zero like powers of the cube root of the index.{where}",
            reason="Here `delta` is like `8/Lambda`, and by step @three-equations "
            "`xi^3` is like `8 delta`: `xi^3 Lambda` tends to 64. Insert this in steps @gains, "
            "@predicted-covariance and @predicted-33.",
            heading="Both ends of the index",
            joins=False,
        ),
        *small[1:],
        replace(
            large[0],
            sentence="A large index: the filter trusts the measurement. The position gain tends to "
            "1, the others to limits, and the predicted covariance grows like the process noise.",
            reason="Here `xi` tends to its bound of step @parameter; the same steps.",
            joins=False,
        ),
        *large[1:],
        replace(
            first,
            sentence="Between these ends each gain takes every value of its range exactly once.",
            reason="By step @increasing-alpha they grow; steps @small-alpha and @large-alpha give "
            "the ends of the ranges.",
            joins=False,
        ),
        *others,
    ]


def _limits(c: Context, word: str, point: str, entries: Limits) -> list[Step]:
    return [
        joined(
            f"{word}-{name.replace('_', '-')}",
            limit(expression, point, value, c.running),
            hint={"ends": c.ends},
        )
        for name, (expression, value) in entries.items()
    ]


def _small() -> Limits:
    """Leading terms for a small index, cubed where the power is not whole."""
    found: dict[str, tuple[sp.Expr, sp.Expr]] = {}
    for name, (power, factor) in _SMALL.items():
        if power % 3:
            found[name] = real(name) ** 3 / INDEX**power, sp.Integer(factor**3)
        else:
            found[name] = real(name) / INDEX ** (power // 3), sp.Integer(factor)
    return {"xi": (XI**3 * INDEX, sp.Integer(64)), **found}


def entries_over_square(c: Context) -> dict[str, sp.Expr]:
    """The limits of the covariances' entries over the square of a large index."""
    k = c.constants
    known = {
        XI: k.least,
        real("eta"): k.b + k.c,
        NU: 2 * (k.least + k.c),
        real("tau"): k.least * (k.b + k.c) - k.c,
        INDEX: sp.Integer(1),
    }
    entries = {
        **covariance_entries.predicted(c.model.process_noise),
        **covariance_entries.updated(c.model.process_noise, c.numbers[0]),
    }
    names = (*PREDICTED, "updated_22", "updated_23", "updated_33")
    return {name: sp.expand(entries[name].subs(known)) for name in names}


def _large(c: Context) -> Limits:
    """Leading terms for a large index; alpha through 1 - alpha."""
    k = c.constants
    top = k.least + k.c
    found: dict[str, tuple[sp.Expr, sp.Expr]] = {
        "alpha": (REST * INDEX**2, plain_number(16 / top**2)),
        "beta": (BETA, plain_number(2 * k.least / top)),
        "gamma": (GAMMA, plain_number(4 / top)),
    }
    for name, value in entries_over_square(c).items():
        if c.tower.is_zero(value):
            found[name] = real(name) / INDEX, _linear(c, name)
        else:
            found[name] = real(name) / INDEX**2, plain_number(value)
    return found


def _linear(c: Context, name: str) -> sp.Expr:
    """The limit of an entry over the index, where it grows no faster than that."""
    value = c.tower.expression(c.tower.fraction(real(name) / INDEX))
    return sp.limit(value, sp.Symbol("p", real=True), sp.oo)
