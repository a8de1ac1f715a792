"""Steps on the poles of filters with matrix gains, and on filters that do not interact."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.fixed_gain.interacting_setting import (
    ALPHA,
    BETA,
    COLUMNS,
    COORDINATE,
    E1,
    E2,
    K1,
    K2,
    NAME,
    PENCIL,
    PHI,
    SETTING,
    STEADY,
    SYMMETRIC,
    UNIT,
    W11,
    W21,
    W22,
    X11,
    B,
    F,
    J,
    K,
    T,
    Z,
)
from gainproof.derive.fixed_gain.interacting_steps_filter import meaning
from gainproof.derive.relation import cited
from gainproof.derive.source import MATRICES
from gainproof.derive.words.expression import Expression, unit
from gainproof.derive.words.hypotheses import equation
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Statement, prove_equal

U = COORDINATE.T
ROWS = (equation(U @ K1, ALPHA * U), equation(T * (U @ K2), BETA * U))
"""u' is a left eigenvector of both gains: a coordinate, where these are diagonal."""


def loop_steps() -> list[Step]:
    """The determinant of z J - F as one of size d."""
    whole = Z * J - F
    return [
        prove_equal("null-columns", Search(SETTING), whole @ COLUMNS, E2 @ PENCIL).step(
            "The poles of the filter are the `z` for which `z J - F` is singular. With the `d` "
            "columns `U` of the state, and a matrix `L` of size `d`,",
            "Multiply out; powers of `z` commute with everything.",
            heading="The closed loop",
        ),
        meaning("columns"),
        meaning("pencil"),
        prove_equal("upper-columns", Search(SETTING), E1.T @ COLUMNS, T * UNIT).step(
            "", joins=True
        ),
        prove_equal(
            "determinant-factors",
            Search(SETTING),
            whole @ (COLUMNS @ E1.T - E2 @ E2.T / T),
            E1 @ E2.T + E2 @ PENCIL @ E1.T - ((Z - 1) / T) * (E2 @ E2.T),
        ).step(
            "The determinants of both sides of the next equation, whose matrices have a zero "
            "block each, are `det(z J - F) (-1)^d` and `(-1)^d det L`. So the characteristic "
            "polynomial is `det(z J - F) = det L`: for one coordinate `z^2 + (alpha + beta - 2) z "
            "+ 1 - alpha`.",
            "Multiply out, the determinants being cited.",
        ),
        Step(
            "block-determinants",
            "",
            cited(
                "The determinant of a product is the product of determinants; that of a block "
                "matrix with square blocks and one zero block is that of its blocks, up to the "
                "sign of the exchange.",
                MATRICES.text(),
            ),
            "",
            NAME,
            joins=True,
        ),
    ]


def _row(name: str, left: Expression, right: Expression) -> Statement:
    return prove_equal(name, Search(SETTING, ROWS), left, right)


def separate_steps() -> list[Step]:
    """Coordinates that do not interact are alpha-beta filters, each with its own stability."""
    one = ALPHA + BETA
    return [
        _row(
            "position-row",
            U @ E1.T @ F,
            (1 - one) * (U @ E1.T) + T * (U @ E2.T),
        ).step(
            "Let `u'` be a row with `u' K1 = alpha u'` and `T u' K2 = beta u'`: if both gains are "
            "diagonal, each coordinate's row of the unit matrix with its own `alpha` and `beta`. "
            "Along it the filter is an alpha-beta filter that knows nothing of the others:",
            "Insert both; these are the rows of the closed loop and of the noise of an alpha-beta "
            "filter.",
            heading="Filters without interaction",
        ),
        _row("velocity-row", U @ E2.T @ F, U @ E2.T - (BETA / T) * (U @ E1.T)).step("", joins=True),
        _row("position-noise-row", U @ E1.T @ PHI @ K, one * U).step("", joins=True),
        _row("velocity-noise-row", U @ E2.T @ PHI @ K, (BETA / T) * U).step("", joins=True),
        _row("axis-poles", U @ PENCIL, (Z**2 + (one - 2) * Z + 1 - ALPHA) * U).step(
            "Its poles are those of that filter. If both gains are diagonal, `det L` is the "
            "product of these polynomials, and the filter is stable exactly if each coordinate is "
            "in the triangle `0 < alpha`, `0 < beta < 4 - 2 alpha` (the derivation alpha-beta "
            "proves it).",
            "Insert both in `L`.",
        ),
        *_axis_variances(),
    ]


def _axis_variances() -> list[Step]:
    """The steady variances along a coordinate are the alpha-beta filter's, whatever B is."""
    u = COORDINATE
    cross = U @ W21 @ u
    position, noise = U @ W11 @ u, U @ B @ u
    given = [SYMMETRIC, STEADY, *ROWS]
    second = prove_equal(
        "axis-cross",
        Search(
            SETTING,
            given,
            multiples=[(T * (U @ E2.T / BETA), STEADY, E2 @ u)],
            numbers=[cross],
        ),
        2 * cross,
        (BETA / T) * (position + noise),
    )
    third = prove_equal(
        "axis-velocity",
        Search(
            SETTING,
            given,
            [second],
            multiples=[(U @ E2.T, STEADY, E1 @ u)],
            numbers=[cross],
        ),
        T**2 * (U @ W22 @ u),
        BETA * ((1 - ALPHA / 2) * position - (ALPHA / 2) * noise),
    )
    first = prove_equal(
        "axis-position",
        Search(
            SETTING,
            given,
            [second, third],
            taken=[(2 * (U @ E1.T), STEADY, E1 @ u)],
            numbers=[cross],
        ),
        (ALPHA * (4 - 2 * ALPHA - BETA)) * position,
        (2 * ALPHA**2 + 2 * BETA + ALPHA * BETA) * noise,
    )
    updated = prove_equal(
        "axis-updated",
        Search(SETTING, given, [first], taken=[((1 - ALPHA) ** 2, first, unit("1"))]),
        (ALPHA * (4 - 2 * ALPHA - BETA)) * (U @ X11 @ u),
        (2 * ALPHA**2 + 2 * BETA - 3 * ALPHA * BETA) * noise,
    )
    return [
        second.step(
            "The variances along it too are those of the alpha-beta filter with the measurement "
            "variance `u' B u`, also when the noise is correlated with that of other coordinates:",
            "The equation of the covariance between `u' E2'` or `u' E1'` and its transpose; a "
            "matrix of one row and one column is its own transpose.",
        ),
        third.step("", joins=True),
        first.step("", joins=True),
        updated.step(
            "And that of the updated position, whose covariance is `X11` (step @updated-floor):",
            "Insert both rows.",
        ),
    ]
