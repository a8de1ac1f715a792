"""Steps that solve the three equations and read the gains from them."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, increasing_onto, positive
from gainproof.derive.three_state import shown_signs
from gainproof.derive.three_state.context import Context
from gainproof.derive.three_state.names import (
    ALPHA,
    BETA,
    DELTA,
    DEVIATION,
    ETA,
    GAMMA,
    INDEX,
    NU,
    REST,
    XI,
    S,
    Z,
    gain_vector,
)
from gainproof.derive.three_state.steps_spectrum import D_OF_S
from gainproof.derive.three_state.towers import scale_of_parameter


def gain_steps(c: Context) -> list[Step]:
    """The parameter, the gains, and what ties them to each other and to the index."""
    return [*_parameter(c), *_gains(c), *_ties(c)]


def _row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([entries])


def _parameter(c: Context) -> list[Step]:
    a1, a2, e = c.numbers
    k, wide = c.constants, scale_of_parameter(c.spectrum)
    named = [
        joined(f"number-{entry.symbol}", equal(real(entry.symbol) ** 2, entry.radicand))
        for entry in k.generators
        if not entry.symbol.startswith("root_")
    ]
    return [
        Step(
            "parameter",
            "Forwards, `xi` from the index, these equations need roots of a polynomial of higher "
            "degree. Backwards they are solved at "
            f"once: choose `xi`, and the others follow. Write `xi` over a positive parameter `p`; "
            f"it lies above its value for an infinite index"
            f"{', in which `b` is a number' if named else ''}.",
            equal(XI, k.least + 4 / wide),
            "What holds for every positive `p` holds for every such `xi`. The bound is `xi` of "
            "`d` for `1/Lambda = 0`, where `d(s)` has the factor `1 + s`.",
        ),
        *named,
        Step(
            "eta-and-delta",
            "Then `eta`, `delta` and the index follow in this order.",
            equal(ETA, (XI**2 - a1) / 2),
            "Solve the equations of step @three-equations for `eta`, `delta` and `Lambda`.",
        ),
        joined("delta-of-xi", equal(DELTA, (ETA**2 - a2) / (2 * XI))),
        joined(
            "index-of-xi",
            equal(INDEX**2, 64 / (DELTA**2 - e)) if e else equal(INDEX, 8 / DELTA),
        ),
        Step(
            "positive-coefficients",
            f"All three are positive{', and so is what `Lambda^2` is made of' if e else ''}.",
            positive(XI),
            "Over `p` no minus sign is left in them.",
        ),
        joined("positive-eta", positive(ETA)),
        joined("positive-delta", positive(DELTA)),
        *(
            [joined("above-e", positive(DELTA**2 - e), hint=shown_signs.value(c, DELTA**2 - e))]
            if e
            else []
        ),
        Step(
            "parameter-range",
            "Every positive index belongs to exactly one `p`.",
            increasing_onto(INDEX, sp.Integer(0), "infinity", variable="p"),
            "The index increases with `p` and takes every positive value: its derivative is a "
            "quotient of sums without a minus sign.",
            hint={"ends": c.ends},
        ),
    ]


def _gains(c: Context) -> list[Step]:
    coefficients = [c.spectrum.closed_loop.coeff(Z, n) for n in range(4)]
    in_s = sp.Add(
        *(a * (1 + S) ** n * (1 - S) ** (3 - n) for n, a in enumerate(coefficients)),
        evaluate=False,
    )
    return [
        Step(
            "nu",
            "For short, `nu` is the sum of the coefficients of `d`.",
            equal(NU, 1 + XI + ETA + DELTA),
            "Its name; `nu = d(1)`.",
            heading="The gains",
        ),
        Step(
            "closed-loop-in-s",
            "The closed loop belongs to `d`: `sigma (1 - s)^3 c(z) = Lambda d(s)`.",
            equal(DEVIATION * in_s, INDEX * D_OF_S, free=("s",)),
            "By steps @factorisation and @line-factorisation both sides have the same product "
            "with their mirror images; both have their roots in the left half plane, as the poles "
            "are to lie inside the circle; and both are positive at `s = 0`.",
        ),
        Step(
            "deviation",
            "At `s = 1` it gives the deviation of the innovations.",
            equal(DEVIATION, INDEX * NU / 8),
            "There only the highest power of `z` is left on the left side: `8 sigma = Lambda nu`.",
        ),
        Step(
            "gains",
            "The result: the three gains. Only positive numbers are added, multiplied and divided, "
            "so no digit cancels in a computer.",
            equal(_row(ALPHA, BETA, GAMMA), _row(2 * (1 + ETA) / NU, 4 * XI / NU, 8 / NU)),
            "Compare the powers of `s` in step @closed-loop-in-s and insert step @deviation: "
            "`sigma gamma = Lambda`, `2 sigma beta = Lambda xi`, "
            "`sigma (4 alpha - gamma) = Lambda eta`.",
        ),
    ]


def _ties(c: Context) -> list[Step]:
    a1, a2, _ = c.numbers
    first = sp.expand(4 * BETA**2 - (a1 - 2) * GAMMA**2 - 8 * ALPHA * GAMMA)
    second = sp.expand((4 * ALPHA - GAMMA) ** 2 - a2 * GAMMA**2 - 8 * BETA * (4 - 2 * ALPHA - BETA))
    return [
        Step(
            "variance",
            "The innovation variance belongs to the position gain alone.",
            equal(DEVIATION**2, 1 / (1 - ALPHA)),
            "In step @factorisation the highest power of `z` has the coefficient -1 on the left "
            "and `-sigma^2 (1 - alpha)` on the right.",
        ),
        Step("rest", "", equal(1 - ALPHA, REST), "", shown=False),
        Step("alpha-below-one", "", positive(1 - ALPHA), "", shown=False),
        Step(
            "noise-ratio",
            "The gains give back the index.",
            equal(INDEX**2, GAMMA**2 / (1 - ALPHA)),
            "`sigma gamma = Lambda` (steps @deviation and @gains), squared, with step @variance.",
        ),
        Step(
            "ratios",
            "And they give back `xi`, `eta` and `delta`.",
            equal(
                _row(XI, ETA, DELTA),
                _row(
                    2 * BETA / GAMMA,
                    4 * ALPHA / GAMMA - 1,
                    2 * (4 - 2 * ALPHA - BETA) / GAMMA,
                ),
            ),
            "Divide the gains of step @gains by each other; `delta = nu - 1 - xi - eta`.",
        ),
        Step(
            "gain-relation",
            "Free of the index, the three gains lie on one curve, which two equations describe.",
            equal(first, sp.Integer(0)),
            "Insert step @ratios in the last two equations of step @three-equations and multiply "
            "by `gamma^2`.",
        ),
        joined("second-gain-relation", equal(second, sp.Integer(0))),
        Step(
            "predictor-gain",
            "A filter that goes from prediction to prediction uses the gain `F K`, whose first two "
            "entries we write `(FK)1` and `(FK)2`; the third is `gamma`.",
            equal(
                c.model.transition * gain_vector(),
                sp.ImmutableDenseMatrix(
                    [[real("predictor_position")], [real("predictor_velocity")], [GAMMA]]
                ),
            ),
            "Multiply out.",
        ),
    ]
