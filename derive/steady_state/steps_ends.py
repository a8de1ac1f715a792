"""Steps on both ends of the index, and the ranges of the gains between them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import increasing_onto, limit
from gainproof.derive.steady_state import forms
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, INDEX, PREDICTED, ROOT
from gainproof.derive.steady_state.towers import rational

Limits = Mapping[str, tuple[sp.Expr, sp.Expr]]


def end_steps(c: Context) -> list[Step]:
    """Leading behaviour as the index falls to zero and grows without bound, and the ranges."""
    near = "`eta` tends to 4, `s` to `sqrt(2)`" if c.e else "`s` tends to `sqrt(2)`"
    small, large = (_limits(c, "small", "0", _small()), _limits(c, "large", "infinity", _large(c)))
    derivative = forms.gain_derivatives(c.basis)
    largest = 2 / (1 + sp.sqrt(rational(c.e)))
    return [
        replace(
            small[0],
            sentence="A small index: the filter trusts its prediction. Gains and covariances fall "
            "to zero like powers of `p`, the root of the index.",
            reason=f"Here {near} and `sigma` to 1. Insert this in steps @position-gain, "
            "@velocity-gain and "
            "@stable-predicted-11, with `rho = s/p`.",
            heading="Both ends of the index",
            joins=False,
        ),
        *small[1:],
        replace(
            large[0],
            sentence="A large index: the filter trusts the measurement. The position gain tends to "
            "1, the velocity gain to a limit, and the predicted covariance grows like the process "
            "noise.",
            reason=f"Here {_far_text(c.e)}; the same steps.",
            joins=False,
        ),
        *large[1:],
        Step(
            "alpha-range",
            "Between these ends each gain takes every value of its range exactly once.",
            increasing_onto(ALPHA, sp.Integer(0), sp.Integer(1)),
            "By step @increasing-alpha both grow; steps @small-alpha and @large-alpha give the "
            "ends of the ranges.",
            hint={"form": derivative["alpha"], "ends": c.ends},
        ),
        joined(
            "beta-range",
            increasing_onto(BETA, sp.Integer(0), sp.radsimp(largest)),
            hint={"form": derivative["beta"], "ends": c.ends},
        ),
    ]


def _limits(c: Context, word: str, point: str, entries: Limits) -> list[Step]:
    return [
        joined(f"{word}-{name}", limit(expression, point, value), hint={"ends": c.ends})
        for name, (expression, value) in entries.items()
    ]


def _far_text(e: Fraction) -> str:
    """What the roots do as the index grows without bound, in a sentence."""
    if e == 0:
        return "`s/p` and `sigma/Lambda` tend to `1/2`"
    if e == 1:
        return "`eta/Lambda`, `s/p` and `sigma/Lambda` tend to 1"
    return (
        f"`eta/Lambda` tends to `sqrt({e})`, and `s/p` and `sigma/Lambda` tend to "
        f"`(1 + sqrt({e}))/2`"
    )


def _small() -> Limits:
    """Leading terms for a small index."""
    m11, m12, m22 = map(real, PREDICTED)
    root_2 = sp.sqrt(sp.Integer(2))
    return {
        "alpha": (ALPHA / ROOT, root_2),
        "beta": (BETA / INDEX, sp.Integer(1)),
        "predicted-11": (m11 / ROOT, root_2),
        "predicted-12": (m12 / INDEX, sp.Integer(1)),
        "predicted-22": (m22 / ROOT**3, root_2),
        "updated-22": (real("updated_22") / ROOT**3, root_2),
    }


def _large(c: Context) -> Limits:
    """Leading terms for a large index; alpha through 1 - alpha."""
    root_e = sp.sqrt(rational(c.e))
    far, n = sp.radsimp((1 + root_e) / 2), rational(c.n)
    m11, m12, m22 = map(real, PREDICTED)
    x22 = real("updated_22")
    return {
        "alpha": (real("rest") * INDEX**2, sp.radsimp(4 / (1 + root_e) ** 2)),
        "beta": (BETA, sp.radsimp(2 / (1 + root_e))),
        "predicted-11": (m11 / INDEX**2, sp.expand(far**2)),
        "predicted-12": (m12 / INDEX**2, far),
        "predicted-22": (m22 / INDEX**2, far + 1 - n),
        "updated-22": (x22 / INDEX**2, far - n) if far != n else (x22 / INDEX, sp.Integer(2)),
    }
