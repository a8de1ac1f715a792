"""Steps on the second derivatives at both ends of the index."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import limit
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import INDEX, ROOT
from gainproof.derive.steady_state.steps_curvature import label, second
from gainproof.derive.steady_state.towers import rational


def curvature_end_steps(c: Context) -> list[Step]:
    """Leading behaviour of the second derivatives at both ends of the index."""
    root_e, n = sp.sqrt(rational(c.e)), rational(c.n)
    far = sp.radsimp((1 + root_e) / 2)
    root_2 = sp.sqrt(sp.Integer(2))
    small = {
        "alpha": (second("alpha") * ROOT**3, -root_2 / 4),
        "beta": (second("beta") * ROOT, -3 * root_2 / 8),
        "predicted_11": (second("predicted_11") * ROOT**3, -root_2 / 4),
        "predicted_12": (second("predicted_12") * ROOT, 3 * root_2 / 8),
        "predicted_22": (second("predicted_22") * ROOT, 3 * root_2 / 4),
        "updated_22": (second("updated_22") * ROOT, 3 * root_2 / 4),
    }
    large = {
        "alpha": (second("alpha") * INDEX**4, sp.radsimp(-24 / (1 + root_e) ** 2)),
        "beta": _far_beta(c.e),
        "predicted_11": (second("predicted_11"), sp.expand(2 * far**2)),
        "predicted_12": (second("predicted_12"), 2 * far),
        "predicted_22": (second("predicted_22"), sp.expand(2 * (far + 1 - n))),
        "updated_22": (second("updated_22"), sp.expand(2 * (far - n)))
        if far != n
        else (second("updated_22") * INDEX**3, sp.Integer(32)),
    }
    first, *others = _limits(c, "small-second", "0", small)
    start, *rest = _limits(c, "large-second", "infinity", large)
    return [
        replace(
            first,
            sentence="The second derivatives grow beyond all bounds near a vanishing index, like "
            "negative powers of `p`.",
            reason="Insert the same leading terms in steps @second-derivative-alpha, "
            "@second-derivative-predicted-12 and @second-derivative-predicted-11. Those of "
            "`alpha`, `M11`, `M22` and `X22` come from the terms in step @small-alpha, those of "
            "`beta` and `M12` from the terms after them.",
            joins=False,
        ),
        *others,
        replace(
            start,
            sentence="With a large index those of the gains vanish, and the predicted covariance "
            "bends like the process noise.",
            reason="The same steps.",
            joins=False,
        ),
        *rest,
    ]


def _far_beta(number: Fraction) -> tuple[sp.Expr, sp.Expr]:
    """beta approaches its limit like 1/Lambda^2, for e = 0 like 1/Lambda."""
    if number == 0:
        return second("beta") * INDEX**3, sp.Integer(-16)
    root = sp.sqrt(rational(number))
    return second("beta") * INDEX**4, sp.radsimp(-48 * (2 + root) / (root * (1 + root) ** 3))


def _limits(
    c: Context, word: str, point: str, entries: Mapping[str, tuple[sp.Expr, sp.Expr]]
) -> list[Step]:
    return [
        joined(label(word, name), limit(expression, point, value), hint={"ends": c.ends})
        for name, (expression, value) in entries.items()
    ]
