"""Steps on what the steady state is used for: derivatives, inverses and both ends of the index."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Generator, Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, limit, positive
from gainproof.derive.steady_state import covariance_forms, forms, inverses
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, DEVIATION, INDEX, PREDICTED, ROOT
from gainproof.derive.steady_state.towers import ROOT_S, rational, root_of_16, surd


def derivative_steps(c: Context) -> list[Step]:
    """First derivatives with respect to the index, each without a subtraction and positive."""
    gains = forms.gain_derivatives(c.basis)
    entries = {
        **gains,
        "predictor_position": forms.predictor_gain_derivatives(c.basis)["position"],
        **covariance_forms.predicted_covariance_derivatives(c.basis),
        "updated_22": covariance_forms.updated_covariance_derivatives(c.basis)["updated_22"],
    }
    steps = []
    for name, form in entries.items():
        label, words = name.replace("_", "-"), name.replace("_", " ")
        derivative = sp.Derivative(real(name), INDEX)
        steps += [
            Step(
                f"derivative-{label}",
                f"How {words} changes with the index.",
                equal(derivative, form),
                "Differentiate kappa^2 and rho^2, then gather positive terms.",
            ),
            Step(
                f"increasing-{label}",
                f"So {words} grows with the index.",
                positive(derivative),
                "The derivative has no minus sign.",
                hint={"form": form},
            ),
        ]
    return steps


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
    roots = inverse_roots(c)
    from_alpha, from_beta = roots["alpha_radical"], roots["beta_radical"]
    ratio = rational(c.e)
    root_e = roots["root_of_e"]
    return [
        Step(
            "alpha-radical",
            "The root that the way back from alpha needs.",
            equal(from_alpha**2, 4 * (1 - ALPHA) + ratio * ALPHA**2),
            "Square it; it is positive.",
        ),
        Step(
            "beta-from-alpha",
            "The velocity gain that belongs to a position gain.",
            equal(BETA, inverses.beta_from_alpha(ALPHA, from_alpha)),
            "Solve the gain relation for beta, the smaller root, rationalised.",
        ),
        Step(
            "index-from-alpha",
            "The index that belongs to a position gain.",
            equal(INDEX, inverses.index_from_alpha(ALPHA, from_alpha, roots["root_of_rest"])),
            "Lambda = beta/sqrt(1 - alpha).",
        ),
        Step(
            "beta-radical",
            "The root that the way back from beta needs.",
            equal(from_beta**2, BETA * (8 + ratio * BETA)),
            "Square it; it is positive.",
        ),
        Step(
            "alpha-from-beta",
            "The position gain that belongs to a velocity gain.",
            equal(ALPHA, inverses.alpha_from_beta(BETA, c.e, from_beta)),
            "Solve the gain relation for alpha, the positive root, rationalised.",
        ),
        Step(
            "index-from-beta",
            "1 - alpha from the velocity gain, and with it Lambda = beta/sqrt(1 - alpha).",
            equal(real("rest"), inverses.rest_from_beta(BETA, c.e, from_beta, root_e)),
            "Multiply 1 - alpha by its conjugate; its zeros in beta are where the index ends.",
            tower=inverse_tower(c).name,
        ),
    ]


def end_steps(c: Context) -> list[Step]:
    """Leading behaviour as the index falls to zero and grows without bound."""
    root_e = sp.sqrt(rational(c.e))
    root_2 = sp.sqrt(sp.Integer(2))
    far = sp.radsimp((1 + root_e) / 2)
    n = rational(c.n)
    m11, m12, m22 = map(real, PREDICTED)
    x22 = real("updated_22")
    small = {
        "alpha": (ALPHA / ROOT, root_2),
        "beta": (BETA / INDEX, sp.Integer(1)),
        "predicted-11": (m11 / ROOT, root_2),
        "predicted-12": (m12 / INDEX, sp.Integer(1)),
        "predicted-22": (m22 / ROOT**3, root_2),
        "updated-22": (x22 / ROOT**3, root_2),
    }
    large = {
        "alpha": (real("rest") * INDEX**2, sp.radsimp(4 / (1 + root_e) ** 2)),
        "beta": (BETA, sp.radsimp(2 / (1 + root_e))),
        "predicted-11": (m11 / INDEX**2, sp.expand(far**2)),
        "predicted-12": (m12 / INDEX**2, far),
        "predicted-22": (m22 / INDEX**2, far + 1 - n),
        "updated-22": (x22 / INDEX**2, far - n) if far != n else (x22 / INDEX, sp.Integer(2)),
    }
    words = {"0": "As the index falls to zero", "infinity": "As the index grows without bound"}
    steps = []
    for point, entries in (("0", small), ("infinity", large)):
        for name, (expression, value) in entries.items():
            steps.append(
                Step(
                    f"{'small' if point == '0' else 'large'}-{name}",
                    f"{words[point]}: the leading term of {name.replace('-', ' ')}"
                    + (", through 1 - alpha." if name == "alpha" and point != "0" else "."),
                    limit(expression, point, value),
                    "Put the end values of eta and s.",
                    hint={"ends": c.ends},
                )
            )
    return steps
