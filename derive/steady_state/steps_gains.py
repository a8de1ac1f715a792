"""Steps that solve the spectral factorisation for the gains."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, increasing_onto, positive
from gainproof.derive.steady_state.context import Context
from gainproof.derive.steady_state.names import ALPHA, BETA, DEVIATION, INDEX, ROOT
from gainproof.derive.steady_state.spectrum import index_equation
from gainproof.derive.steady_state.towers import KAPPA, RHO, ROOT_S, rational, root_of_16


def eta_text(e: Fraction) -> str:
    """The root of 16 + e Lambda^2 in a sentence."""
    return "eta" if e else "4"


def gain_steps(c: Context) -> list[Step]:
    """Spectral factorisation solved for the gains."""
    return [*_compared(c), *_solved(c), *_by_ratios(c), *_both_gains(c)]


def _row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([entries])


def _compared(c: Context) -> list[Step]:
    """The factorisation at three places: its highest power, z = 1 and z = -1."""
    high, ratio = root_of_16(c.e), rational(c.e)
    steps = [
        Step(
            "variance",
            "The highest power of `z` in the factorisation ties the variance of the innovations "
            "to the position gain.",
            equal(DEVIATION**2, c.spectrum.variance),
            "In step @factorisation `z^2` has the coefficient 1 on the left and "
            "`sigma^2 (1 - alpha)` on the right.",
            heading="The gains",
        ),
        Step("rest", "", equal(1 - ALPHA, real("rest")), "", shown=False),
        Step(
            "velocity-gain",
            "At `z = 1` the factorisation ties the velocity gain to the index.",
            equal(DEVIATION * BETA, INDEX),
            "There `v = 0`, `noise(0) = 1` and `c(1) = beta`, so `Lambda^2 = sigma^2 beta^2`. We "
            "look for poles inside the unit circle; then `c(1)` is positive.",
        ),
    ]
    sentence = "At `z = -1` it leaves an equation for `sigma` alone"
    reason = (
        f"There `v = 4`, `16 + Lambda^2 noise(4) = {eta_text(c.e)}^2` and "
        "`c(-1) = 4 - 2 alpha - beta`, positive like `c(1)`. The positive roots of both sides are "
        f"`{eta_text(c.e)} = sigma (4 - 2 alpha - beta)`; steps @variance and @velocity-gain give "
        "`alpha = 1 - 1/sigma^2` and `beta = Lambda/sigma`."
    )
    equation = equal(index_equation(c.spectrum), high)
    if c.e == 0:
        return [*steps, Step("other-end", f"{sentence}.", equation, reason)]
    return [
        *steps,
        Step(
            "eta",
            f"{sentence}; `eta` is the positive root of its left side there.",
            equal(high**2, 16 + ratio * INDEX**2),
            reason,
        ),
        joined("other-end", equation),
    ]


def _solved(c: Context) -> list[Step]:
    """The quadratic for sigma solved."""
    high, ratio = root_of_16(c.e), rational(c.e)
    eta = eta_text(c.e)
    sum_of_roots = f"(Lambda + {eta})/2"
    return [
        Step(
            "parameter",
            "Two roots are needed: `p`, the square root of the index, and `s`, that of a sum of "
            "positive terms. What holds for all positive `p` holds for all positive `Lambda`.",
            equal(INDEX, ROOT**2),
            "Their names; every positive index is the square of one positive `p`.",
        ),
        joined("root-s", equal(ROOT_S**2, ((1 + ratio) * INDEX + 2 * high) / 4)),
        Step(
            "parameter-range",
            "",
            increasing_onto(INDEX, sp.Integer(0), "infinity", variable="p"),
            "",
            hint={"form": 2 * ROOT, "ends": c.ends},
            shown=False,
        ),
        Step(
            "deviation",
            "So `sigma` is known: it is the larger root of its quadratic, and `1/sigma` the "
            "smaller.",
            equal(DEVIATION, (ROOT**2 + high + 2 * ROOT * ROOT_S) / 4),
            f"By step @other-end the roots `sigma` and `1/sigma` have the sum `{sum_of_roots}` and "
            "the product 1. The square of the sum, less 4, is the square of their difference: "
            "`p^2 s^2`. The larger root is the one that makes `alpha = 1 - 1/sigma^2` positive.",
        ),
        Step(
            "position-gain",
            "The position gain follows.",
            equal(ALPHA, ROOT * ROOT_S / DEVIATION),
            "By step @variance `alpha = (sigma - 1/sigma)/sigma`, and `sigma - 1/sigma = p s`.",
        ),
    ]


def _by_ratios(c: Context) -> list[Step]:
    """The gains over kappa and rho."""
    high, ratio = root_of_16(c.e), rational(c.e)
    total = sp.Rational(1, 2) + KAPPA + RHO
    kappa = [(KAPPA**2, 4 / INDEX**2 + ratio / 4)] if c.e else []
    squares = [*kappa, (RHO**2, KAPPA + (1 + ratio) / 4)]
    both = "Both follow" if c.e else "`rho` follows"
    eta = eta_text(c.e)
    return [
        Step(
            "kappa-and-rho",
            "Two quantities carry all that follows: `kappa` for short, and `rho`, the ratio of the "
            "gains.",
            equal(_row(KAPPA, RHO), _row(high / (2 * INDEX), ALPHA / BETA)),
            "Their names. With steps @position-gain and @velocity-gain `rho = s/p`.",
        ),
        Step(
            "roots-in-the-index",
            f"{both} from the index as the square root of a sum of positive terms.",
            equal(_row(*(left for left, _ in squares)), _row(*(right for _, right in squares))),
            (f"Divide `{eta}^2` (step @eta) by `4 Lambda^2`, " if c.e else "Divide ")
            + "`s^2` (step @root-s) by `Lambda`.",
        ),
        Step(
            "stable-gains",
            "With them the result: the deviation of the innovations and both gains. No two "
            "computed numbers are subtracted, so no digit cancels in a computer.",
            equal(
                _row(DEVIATION, BETA, ALPHA),
                _row(INDEX * total / 2, 2 / total, 2 * RHO / total),
            ),
            "Take `Lambda` out of `sigma` (step @deviation); then `beta = Lambda/sigma` and "
            "`alpha = rho beta`.",
        ),
    ]


def _both_gains(c: Context) -> list[Step]:
    """What ties the two gains to each other and to the index."""
    return [
        Step(
            "noise-ratio",
            "The two gains give back the index.",
            equal(INDEX**2, BETA**2 / (1 - ALPHA)),
            "Square step @velocity-gain and insert step @variance.",
        ),
        Step("alpha-below-one", "", positive(1 - ALPHA), "", shown=False),
        Step(
            "gain-relation",
            "Free of the index, the two gains lie on one curve.",
            equal(c.spectrum.relation, sp.Integer(0)),
            f"Square `{eta_text(c.e)} = sigma (4 - 2 alpha - beta)` (step @other-end); insert "
            "steps @variance and @noise-ratio.",
        ),
        Step(
            "predictor-gain",
            "A filter that goes from prediction to prediction uses the gain `F K`. Its second "
            "entry is `beta`, its first, which we write `(FK)1`, the sum of both gains.",
            equal(
                c.model.transition * sp.ImmutableDenseMatrix([[ALPHA], [BETA]]),
                sp.ImmutableDenseMatrix([[real("predictor_position")], [BETA]]),
            ),
            "Multiply out.",
        ),
    ]
