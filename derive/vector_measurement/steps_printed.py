"""Steps from the derived steady state to the closed form as the source prints it, (14) to (19).

The source's process noise only: continuous white acceleration.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.relation import definition, equal, positive
from gainproof.derive.vector_measurement.context import Context
from gainproof.derive.vector_measurement.names import CROSS, DELTA, INDEX, MEAN, RATIO, ROOT
from gainproof.derive.vector_measurement.steps_entries import P11, P12, P22, U11, U12, U22

SYMBOLS = {
    "position_ratio": "r",
    "source_a": "A",
    "source_x": "X",
    "source_k": r"\mathrm{k}",
    "source_b": "B",
    "source_c": "C",
    "source_q1": "Q_1",
    "source_q2": "Q_2",
    "source_p1": r"\mathrm{p}_1",
    "source_p2": r"\mathrm{p}_2",
    "source_p3": r"\mathrm{p}_3",
    "source_root": r"\rho",
}
R, A, X, K, B, C, Q1, Q2, P1, P2, P3, RHO = map(real, SYMBOLS)
SQUARE = RATIO**2


def source_elements(tower: Tower) -> dict[str, sp.Expr]:
    """The source's symbols over the derived quantities, by name.

    K is what X^2 + S^2 h^2 turns out to be, B what Q1 = 2 K S^2 P12 asks for: the source leaves B
    undefined.
    """
    difference = DELTA * CROSS
    constant = INDEX**2 * K * (1 + SQUARE / 6)
    shape = _computed(tower, difference**2 + SQUARE * CROSS**2)
    needed = ((MEAN * CROSS * K * SQUARE - constant) / difference**2).subs(K, shape)
    return {
        "position_ratio": 4 / INDEX,
        "source_a": INDEX**2,
        "source_x": difference,
        "source_k": shape,
        "source_b": _computed(tower, needed),
        "source_c": constant,
        "source_q1": B * X**2 + SQUARE * K * X + C,
        "source_q2": B * X**2 - SQUARE * K * X + C,
        "source_p1": B**2,
        "source_p2": 2 * B * C - SQUARE * K**2 * (SQUARE - 4),
        "source_p3": C**2 - 4 * SQUARE * K**3,
        "source_root": P2 + 2 * P1 * X**2,
    }


def _computed(tower: Tower, expression: sp.Expr) -> sp.Expr:
    """An expression of the tower that is a polynomial in Lambda^2 and S, over the latter."""
    found = sp.factor(tower.expression(tower.fraction(expression)))
    return sp.factor(found.subs(ROOT, A ** sp.Rational(1, 4))).subs(A, INDEX**2)


def _in_a(c: Context, name: str) -> sp.Expr:
    """The value of one of the source's symbols as it depends on A and S."""
    return sp.factor(c.tower.expressions[name].subs(INDEX, sp.sqrt(A)))


def _row(*entries: sp.Expr) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix([list(entries)])


def printed_steps(c: Context) -> list[Step]:
    """The source's parameters, its K, X, B, C, and its equations (16) to (19)."""
    return [
        Step(
            "printed-index",
            "How the source writes it. Its r is 4/Lambda, (14), and its A is Lambda^2, (14a). Its "
            "S is ours: (15) prints sigma_a where the words beside it mean sigma_d.",
            equal(_row(R, A), _row(4 / INDEX, (4 / R) ** 2)),
            "r = 4 sigma_o/(sigma_a T^2).",
        ),
        Step(
            "printed-x",
            "X is the difference of the cross covariances, and so the mean of both velocity "
            "variances: (16c), (19c).",
            equal(_row(X, P22, U22), _row(P12 - U12, X + A / 2, X - A / 2)),
            "P12 - U12 = delta h = U22 + A/2.",
        ),
        Step(
            "printed-k",
            "(17g): the number K of the source, here k so that it is no gain.",
            equal(_row(K, K), _row(X**2 + SQUARE * CROSS**2, _in_a(c, "source_k"))),
            "The cross equation times h, or U22 P22 = S^2 (A - h^2).",
        ),
        Step(
            "printed-c",
            "(17h): its number C.",
            definition(C, A * K * (1 + SQUARE / 6)),
            "The name of this quantity.",
        ),
        Step(
            "printed-b",
            "The source never says what B is. (16b) and (19b), added, leave it no choice: it has "
            "to be this polynomial.",
            equal(
                _row(B * X**2 + C, B),
                _row(K * SQUARE * (P12 + U12), _in_a(c, "source_b")),
            ),
            "Q1 + Q2 = 2 (B X^2 + C), and X is not zero: solve for B.",
        ),
        Step(
            "printed-q",
            "(17b), (17c), and with them (16b), (19b), and the gains (18b), (18c).",
            equal(_row(P12, U12), _row(Q1 / (2 * K * SQUARE), Q2 / (2 * K * SQUARE))),
            "Sum and difference of the cross covariances are m h and X.",
        ),
        Step(
            "printed-quadratic",
            "The square of (P12 + U12)^2 = X^2 + 4 h^2 is a quadratic for X^2, with p1 = B^2, "
            "p2 = 2 B C - S^2 k^2 (S^2 - 4) and p3 = C^2 - 4 S^2 k^3: (17d) to (17f).",
            equal(P1 * X**4 + P2 * X**2 + P3, sp.Integer(0)),
            "Insert B X^2 + C = k S^2 (P12 + U12) and S^2 h^2 = k - X^2.",
        ),
        Step(
            "printed-root",
            "Its discriminant is the square of rho = p2 + 2 p1 X^2.",
            equal(
                _row(RHO**2, P2**2 - 4 * P1 * P3),
                _row(P2**2 - 4 * P1 * P3, _discriminant(c)),
            ),
            "Complete the square.",
        ),
        Step(
            "printed-root-sign",
            "rho is positive everywhere, so the root of (17a) has the right sign: X^2 = (-p2 + "
            "rho)/(2 p1) wherever B is not 0.",
            positive(RHO),
            "It is a quotient of polynomials without a minus sign.",
        ),
        Step(
            "printed-other-root",
            "Where B = 0, (17a) is 0/0. Written from the other end the root has no gap: there it "
            "gives X^2 = -p3/p2.",
            equal(X**2 * (P2 + RHO), -2 * P3),
            "The product of the roots of the quadratic is p3/p1.",
        ),
        Step(
            "printed-position",
            "(16a), (18a) and (19a): the position entries, times their denominators.",
            equal(
                _row(SQUARE * Q2 * P11, SQUARE * Q1 * U11),
                _row(
                    2 * K * RATIO**4 * X + Q1 * (A / 2 - X),
                    2 * K * RATIO**4 * X - Q2 * (A / 2 + X),
                ),
            ),
            "P11 U12 = P12 - U12 - U22 P12/S^2 and U11 P12 = P12 - U12 - U12 P22/S^2, from "
            "U R^-1 P = P - U.",
        ),
    ]


def _discriminant(c: Context) -> sp.Expr:
    expressions = c.tower.expressions
    value = P2**2 - 4 * P1 * P3
    for name in ("source_p1", "source_p2", "source_p3", "source_b", "source_c", "source_k"):
        value = value.subs(real(name), expressions[name])
    return sp.factor(sp.expand(value).subs(INDEX, sp.sqrt(A)))
