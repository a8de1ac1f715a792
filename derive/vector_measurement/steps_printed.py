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
from gainproof.derive.vector_measurement.names import CROSS, DELTA, INDEX, MEAN, RATIO, ROOT, row
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


def printed_steps(c: Context) -> list[Step]:
    """The source's parameters, its K, X, B, C, and its equations (16) to (19)."""
    return [*_parameters(c), *_cross_entries(), *_quadratic(c), *_position_entries()]


def _parameters(c: Context) -> list[Step]:
    return [
        Step(
            "printed-index",
            "The source's parameters are `r = 4 sigma_o/(sigma_a T^2)`, (14), `A`, (14a), and `S`, "
            "(15). Its (15) prints `sigma_a` where the words beside it mean `sigma_d`; read so, "
            "its `S` is ours.",
            equal(row(R, A), row(4 / INDEX, (4 / R) ** 2)),
            "Insert `Lambda = sigma_a T^2/sigma_o` (step @index).",
            heading="The steady state as the source writes it, (14) to (19)",
        ),
        Step(
            "printed-x",
            "Its `X` is the difference of the cross covariances. That gives the variances of the "
            "velocity, (16c) and (19c), and with `K22 = U22/S^2` the gain (18d).",
            equal(row(X, P22, U22), row(P12 - U12, X + A / 2, X - A / 2)),
            "`P12 - U12 = delta h` by step @sum-of-cross, and step @velocity-from-cross.",
        ),
        Step(
            "printed-k",
            "Its number `K` of (17g) is called `k` here, for it is no gain.",
            equal(row(K, K), row(X**2 + SQUARE * CROSS**2, _in_a(c, "source_k"))),
            "The update (step @filter) is `U R^-1 P = P - U`; its entry 22 is "
            "`h^2 + U22 P22/S^2 = A`. Insert step @printed-x.",
        ),
        Step(
            "printed-c",
            "Its number `C` of (17h).",
            definition(C, A * K * (1 + SQUARE / 6)),
            "Its name.",
        ),
        Step(
            "printed-b",
            "Its number `B` appears in (17b) to (17e), but nowhere does the source say what it is. "
            "(16b) and (19b), added, leave `B` no choice: it has to be this polynomial.",
            equal(
                row(B * X**2 + C, B),
                row(K * SQUARE * (P12 + U12), _in_a(c, "source_b")),
            ),
            "By (17b) and (17c) the sum of both numerators is `2 (B X^2 + C)`; `X` is not zero, so "
            "the first line can be solved for `B`. With this `B` all the rest comes out.",
        ),
    ]


def _cross_entries() -> list[Step]:
    return [
        Step(
            "printed-q",
            "Its numerators are `Q1 = B X^2 + S^2 k X + C`, (17b), and `Q2 = B X^2 - S^2 k X + C`, "
            "(17c). With them the cross covariances (16b) and (19b), and so the gains (18b) and "
            "(18c).",
            equal(row(P12, U12), row(Q1 / (2 * K * SQUARE), Q2 / (2 * K * SQUARE))),
            "Half of sum and difference: steps @printed-b and @printed-x. The gains are "
            "`K12 = U12/S^2` and `K21 = U12` (step @gain).",
        )
    ]


def _quadratic(c: Context) -> list[Step]:
    return [
        Step(
            "printed-quadratic",
            "`X^2` is a root of a quadratic with the coefficients `p1 = B^2`, (17d), "
            "`p2 = 2 B C - S^2 k^2 (S^2 - 4)`, (17e), and `p3 = C^2 - 4 S^2 k^3`, (17f).",
            equal(P1 * X**4 + P2 * X**2 + P3, sp.Integer(0)),
            "`(P12 + U12)^2 = X^2 + 4 h^2`; insert `B X^2 + C = S^2 k (P12 + U12)` (step "
            "@printed-b) and `S^2 h^2 = k - X^2` (step @printed-k).",
        ),
        Step(
            "printed-root",
            "The discriminant of (17a) is a square: that of `rho = p2 + 2 p1 X^2`.",
            equal(
                row(RHO**2, P2**2 - 4 * P1 * P3),
                row(P2**2 - 4 * P1 * P3, _discriminant(c)),
            ),
            "Complete the square in step @printed-quadratic; insert the coefficients.",
        ),
        Step(
            "printed-root-sign",
            "`rho` is positive everywhere, so (17a) takes the right root: "
            "`X^2 = (-p2 + rho)/(2 p1)` wherever `B` is not 0.",
            positive(RHO),
            "`rho` is a quotient of polynomials without a minus sign.",
        ),
        Step(
            "printed-other-root",
            "Where `B = 0`, (17a) is 0/0. Written from the other end the root has no gap: there it "
            "gives `X^2 = -p3/p2`.",
            equal(X**2 * (P2 + RHO), -2 * P3),
            "The product of the roots of the quadratic is `p3/p1`.",
        ),
    ]


def _position_entries() -> list[Step]:
    return [
        Step(
            "printed-position",
            "Last the position: (16a), and (18a), which is (19a) too; each times its denominator. "
            "With this every equation of the source's steady state is derived.",
            equal(
                row(SQUARE * Q2 * P11, SQUARE * Q1 * U11),
                row(
                    2 * K * RATIO**4 * X + Q1 * (A / 2 - X),
                    2 * K * RATIO**4 * X - Q2 * (A / 2 + X),
                ),
            ),
            "The cross entries of `U R^-1 P = P - U` (step @filter) are "
            "`P11 U12 = P12 - U12 - U22 P12/S^2` and `U11 P12 = P12 - U12 - U12 P22/S^2`; insert "
            "steps @printed-q and @printed-x.",
        ),
    ]


def _discriminant(c: Context) -> sp.Expr:
    expressions = c.tower.expressions
    value = P2**2 - 4 * P1 * P3
    for name in ("source_p1", "source_p2", "source_p3", "source_b", "source_c", "source_k"):
        value = value.subs(real(name), expressions[name])
    return sp.factor(sp.expand(value).subs(INDEX, sp.sqrt(A)))
