"""Steps on what the steady state is used for: derivatives, and the way back from a gain."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, equal, positive
from gainproof.derive.steady_state import covariance_forms, forms, inverses
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, DEVIATION, INDEX, ROOT
from gainproof.derive.steady_state.towers import ROOT_S, rational, root_of_16, surd


def derivative_steps(c: Context) -> list[Step]:
    """First derivatives with respect to the index, each without a subtraction and positive."""
    gains = {
        **forms.gain_derivatives(c.basis),
        "predictor_position": forms.predictor_gain_derivatives(c.basis)["position"],
    }
    covariances = {
        **covariance_forms.predicted_covariance_derivatives(c.basis),
        "updated_22": covariance_forms.updated_covariance_derivatives(c.basis)["updated_22"],
    }
    first, *others = _derivatives(gains)
    start, *rest = _derivatives(covariances)
    rising, *more = (
        (
            f"increasing-{name.replace('_', '-')}",
            positive(sp.Derivative(real(name), INDEX)),
            {"form": form},
        )
        for name, form in {**gains, **covariances}.items()
    )
    return [
        Step(
            first[0],
            "The gains change with the index like this.",
            first[1],
            "Differentiate step @stable-gains, with the derivatives of `kappa` and `rho` from step "
            "@roots-in-the-index, and gather positive terms.",
            heading="How the steady state changes with the index",
        ),
        *(_unless_predictor(joined(*entry)) for entry in others),
        Step(
            start[0],
            "And the covariances. `X11` and `X12` are the gains.",
            start[1],
            "Differentiate step @stable-predicted-11 in the same way.",
        ),
        *(joined(*entry) for entry in rest),
        Step(
            rising[0],
            "All of them grow with the index.",
            rising[1],
            f"No minus sign is left in steps @{first[0]} and @{start[0]}.",
            hint=rising[2],
        ),
        *(_unless_predictor(joined(name, relation, hint=hint)) for name, relation, hint in more),
    ]


def _unless_predictor(step: Step) -> Step:
    """The first entry of the predictor gain is a sum of the gains: proved, and not shown again."""
    return replace(step, shown=False) if step.id.endswith("predictor-position") else step


def _derivatives(entries: Mapping[str, sp.Expr]) -> Iterator[tuple[str, Relation]]:
    for name, form in entries.items():
        relation = equal(sp.Derivative(real(name), INDEX), form)
        yield f"derivative-{name.replace('_', '-')}", relation


def inverse_tower(c: Context) -> Tower:
    """The main tower, with sqrt(e) as a further generator where it is irrational."""
    names = surd(c.e)[1] if c.e else {}
    if not names:
        return c.tower
    roots = tuple(Generator(name, sp.Integer(number)) for name, number in names.items())
    return Tower(
        "with_root_of_e", c.tower.parameters, (*roots, *c.tower.generators), c.tower.expressions
    )


def inverse_roots(c: Context) -> dict[str, sp.Expr]:
    """Tower values of the radicals in `inverses`."""
    ratio = rational(c.e)
    from_beta = (2 * ROOT * ROOT_S + INDEX) / DEVIATION
    return {
        "alpha_radical": (ratio * INDEX + root_of_16(c.e)) / (2 * DEVIATION),
        "beta_radical": from_beta,
        "scaled_beta_radical": inverses.SCALE * from_beta,
        "root_of_rest": 1 / DEVIATION,
        "root_of_e": surd(c.e)[0] if c.e else sp.Integer(0),
    }


def inverse_steps(c: Context) -> list[Step]:
    """From one gain to the other and back to the index."""
    values = inverse_roots(c)
    from_alpha, from_beta = values["alpha_radical"], values["beta_radical"]
    ratio = rational(c.e)
    share = "" if c.e in (0, 1) else f"({c.e}) "
    inside = "4 (1 - alpha)" + (f" + {share}alpha^2" if c.e else "")
    outside = f"(eta + {share}Lambda)/(2 sigma)" if c.e else "2/sigma"
    return [
        Step(
            "alpha-radical",
            "The way back from `alpha` needs one square root, that of the right side here. It is "
            f"`{outside}`.",
            equal(from_alpha**2, 4 * (1 - ALPHA) + ratio * ALPHA**2),
            "Square and insert steps @variance and @position-gain; the root is positive.",
            heading="From a gain back to the index",
        ),
        Step(
            "beta-from-alpha",
            "The velocity gain and the index that belong to a position gain. Below the line stands "
            f"`{outside} = sqrt({inside})`: these are functions of `alpha` alone.",
            equal(BETA, inverses.beta_from_alpha(ALPHA, from_alpha)),
            "Step @gain-relation is a quadratic in `beta`; its smaller root is written with a sum "
            "below the line instead of a difference above. Then `Lambda = sigma beta`, with "
            "`sigma = 1/sqrt(1 - alpha)`.",
        ),
        joined(
            "index-from-alpha",
            equal(INDEX, inverses.index_from_alpha(ALPHA, from_alpha, values["root_of_rest"])),
        ),
        Step(
            "beta-radical",
            "And the way back from `beta` the root of the right side here, which is "
            "`(Lambda + 2 p s)/sigma`.",
            equal(from_beta**2, BETA * (8 + ratio * BETA)),
            "Square and insert steps @velocity-gain, @root-s and @deviation; the root is positive.",
        ),
        Step(
            "alpha-from-beta",
            "The position gain that belongs to a velocity gain, and `1 - alpha`, with which "
            "`Lambda = beta/sqrt(1 - alpha)`. Below the line stands the root of step "
            "@beta-radical, a function of `beta` alone.",
            equal(ALPHA, inverses.alpha_from_beta(BETA, c.e, from_beta)),
            "Step @gain-relation is a quadratic in `alpha` too. Its positive root is a difference, "
            "which both formulas avoid; the second vanishes where `beta` reaches its limit (step "
            "@beta-range).",
        ),
        joined(
            "index-from-beta",
            equal(
                real("rest"),
                inverses.rest_from_beta(BETA, c.e, from_beta, values["root_of_e"]),
            ),
            inverse_tower(c).name,
        ),
    ]
