"""Steps on the covariance of the prediction under measurement noise, in blocks."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.fixed_gain.interacting_setting import (
    E1,
    E2,
    ERROR,
    F11,
    K1,
    K2,
    NAME,
    NOISE,
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
    K,
    T,
    W,
    noisy,
)
from gainproof.derive.fixed_gain.interacting_steps_filter import meaning, said
from gainproof.derive.relation import cited
from gainproof.derive.source import MATRICES
from gainproof.derive.words.expression import ZERO, Expression
from gainproof.derive.words.hypotheses import invertible, semidefinite
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)

K2_INVERTIBLE = invertible("K2")


def k2_inverse() -> Statement:
    """K2 has the inverse that is written K2^-1."""
    return prove_invertible(
        "velocity-gain-inverse", Search(SETTING, [K2_INVERTIBLE]), "K2", K2_INVERTIBLE
    )


def _block(name: str, left: Expression, right: Expression) -> Statement:
    one, other = {"11": (E1, E1), "21": (E2, E1), "22": (E2, E2)}[name[-2:]]
    search = Search(SETTING, [SYMMETRIC, STEADY], multiples=[(one.T, STEADY, other)])
    return prove_equal(name, search, left, right)


def covariance_steps() -> list[Step]:
    """From the recursion of errors to the covariance equation of the lecture and its blocks."""
    outer = ERROR @ ERROR.T
    mixed = F @ ERROR @ NOISE.T @ K.T @ PHI.T
    past = F @ ERROR - PHI @ K @ NOISE
    k2 = k2_inverse()
    rest = F11
    gain = K1 + T * K2
    noise = semidefinite("B")
    return [
        prove_equal(
            "outer-product",
            Search(SETTING),
            past @ past.T,
            F @ outer @ F.T + PHI @ K @ (NOISE @ NOISE.T) @ K.T @ PHI.T - mixed - mixed.T,
        ).step(
            "For a target that moves as predicted the product of the next error with its own "
            "transpose is",
            "Multiply out `F e - Phi K v`.",
            heading="Variance under measurement noise",
        ),
        said(
            "covariance",
            "The noise has mean zero and covariance `B` and is independent of what came before; "
            "so the mean of `e v'` is zero, and the covariance of the error goes on as",
            "W(k + 1) = F W(k) F' + Phi K B K' Phi'",
            "The mean is linear: take it of step @outer-product, term by term.",
        ),
        Step(
            "convergence",
            "The lecture's criterion: all eigenvalues of `F = Phi (J - K H)` are smaller than 1 "
            "in modulus. Then the covariance forgets its start and tends to the only solution of "
            "`W = F W F' + Phi K B K' Phi'`, which is symmetric and positive semidefinite.",
            cited(
                "If all eigenvalues of F are smaller than 1 in modulus, then X = F X F' + G has "
                "exactly one solution, the limit of X(k + 1) = F X(k) F' + G from every start; it "
                "is positive semidefinite if G is.",
                MATRICES.text(),
            ),
            "If they are not and the noise excites what does not decay, no start leads to a "
            "limit: the criterion is the stability of the filter.",
            NAME,
        ),
        prove_equal(
            "four-blocks",
            Search(SETTING),
            W,
            E1 @ W11 @ E1.T + E1 @ (E1.T @ W @ E2) @ E2.T + E2 @ W21 @ E1.T + E2 @ W22 @ E2.T,
        ).step(
            "A matrix is known by its four blocks, and of a symmetric one the upper right is the "
            "transpose of the lower left:",
            "`E1 E1' + E2 E2' = J` on both sides.",
        ),
        meaning("W11"),
        meaning("W21"),
        meaning("W22"),
        _block(
            "steady-11",
            W11,
            rest @ W11 @ rest.T
            + T * (rest @ W21.T)
            + T * (W21 @ rest.T)
            + T**2 * W22
            + gain @ B @ gain.T,
        ).step(
            "In blocks the equation of the steady covariance is three equations of size `d` for "
            "every `d`, the fourth being a transpose:",
            "Multiply by `E1'` or `E2'` on the left and `E1` or `E2` on the right.",
        ),
        meaning("F11"),
        _block(
            "steady-21",
            W21,
            -(K2 @ W11 @ rest.T) - T * (K2 @ W21.T) + W21 @ rest.T + T * W22 + K2 @ B @ gain.T,
        ).step("", joins=True),
        _block(
            "steady-22",
            K2 @ (W11 + B) @ K2.T,
            K2 @ W21.T + W21 @ K2.T,
        ).step("", joins=True),
        k2.step(
            "If `K2` can be inverted, the last one gives the innovations' covariance from the "
            "lower left block alone:",
            "That is what being invertible means; and multiply step @steady-22 by `K2^-1` and its "
            "transpose.",
        ),
        prove_equal(
            "innovation-from-cross",
            Search(
                SETTING,
                [SYMMETRIC, STEADY],
                [k2],
                multiples=[(K2.inverse @ E2.T, STEADY, E2 @ K2.inverse.T)],
            ),
            W11 + B,
            K2.inverse @ W21 + W21.T @ K2.inverse.T,
        ).step("", joins=True),
        prove_order(
            "noise-floor",
            Search(SETTING, [STEADY, semidefinite("W")]),
            W,
            PHI @ K @ B @ K.T @ PHI.T,
            [Square(F.T, semidefinite("W"))],
        ).step(
            "In the order of symmetric matrices (`X >= Y` if `X - Y` is positive semidefinite) no "
            "steady covariance is below what the last measurement alone brings in:",
            "The difference is `F W F'`; of the updated position, whose covariance is `X11`, `(I "
            "- K1) W11 (I - K1)'`.",
        ),
        prove_order(
            "position-floor",
            Search(SETTING, [STEADY, semidefinite("W")], taken=[(E1.T, STEADY, E1)]),
            W11,
            gain @ B @ gain.T,
            [Square(F.T @ E1, semidefinite("W"))],
        ).step("", joins=True),
        prove_order(
            "updated-floor",
            Search(SETTING, [semidefinite("W")]),
            X11,
            K1 @ B @ K1.T,
            [Square(E1 @ (UNIT - K1).T, semidefinite("W"))],
        ).step("", joins=True),
        meaning("X11"),
        prove_order(
            "next-definite",
            Search(SETTING, [semidefinite("W"), noise]),
            noisy(K, W),
            ZERO,
            [Square(F.T, semidefinite("W")), Square(K.T @ PHI.T, noise)],
        ).step(
            "And a covariance goes on as a covariance:",
            "It is a sum of squares `X' D X` with `D = W` and `D = B`.",
        ),
    ]
