"""The loop of a filter with fixed gains and measured position, in units of the sampling interval.

Two states have the gains alpha and beta, three alpha, beta and gamma; of the target, position and
its derivatives are the state, as in the lecture (gamma over T^2 is the gain of the acceleration).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp

from gainproof.derive.expression import real

GAIN_NAMES = ("alpha", "beta", "gamma")
WORDS = ("position", "velocity", "acceleration")


@dataclass(frozen=True)
class Loop:
    """F, K, H and what is made of them for `size` states."""

    size: int

    @property
    def gain_names(self) -> tuple[str, ...]:
        """alpha, beta and, of three states, gamma."""
        return GAIN_NAMES[: self.size]

    @property
    def gains(self) -> tuple[sp.Symbol, ...]:
        """Their symbols."""
        return tuple(real(name) for name in self.gain_names)

    @property
    def transition(self) -> sp.ImmutableDenseMatrix:
        """F over one interval: a Taylor shift."""
        return shift(self.size, sp.Integer(1))

    @property
    def row(self) -> sp.ImmutableDenseMatrix:
        """H: the position is measured."""
        return sp.ImmutableDenseMatrix([[1] + [0] * (self.size - 1)])

    @property
    def column(self) -> sp.ImmutableDenseMatrix:
        """K."""
        return sp.ImmutableDenseMatrix(self.gains)

    @property
    def rest(self) -> sp.ImmutableDenseMatrix:
        """I - K H."""
        return sp.ImmutableDenseMatrix(sp.eye(self.size) - self.column * self.row)

    @property
    def closed(self) -> sp.ImmutableDenseMatrix:
        """F (I - K H), which carries the error of the prediction on."""
        return sp.ImmutableDenseMatrix(self.transition * self.rest)

    @property
    def smoothed(self) -> sp.ImmutableDenseMatrix:
        """(I - K H) F, which carries the smoothed state on."""
        return sp.ImmutableDenseMatrix(self.rest * self.transition)

    def polynomial(self, z: sp.Expr) -> sp.Expr:
        """c(z) = det(z I - F (I - K H))."""
        return sp.expand((z * sp.eye(self.size) - self.closed).det(method="berkowitz"))

    @property
    def model(self) -> dict[str, object]:
        """The plain model of certificates; no process noise moves the target."""
        zeros = [["0"] * self.size for _ in range(self.size)]
        return {
            "name": f"fixed_gains_{self.size}_states",
            "title": f"{', '.join(WORDS[: self.size])}, position measured",
            "transition": [[str(x) for x in line] for line in self.transition.tolist()],
            "process_noise": zeros,
            "measurement": [[str(x) for x in line] for line in self.row.tolist()],
            "measurement_noise": [["1"]],
        }


def shift(size: int, step: sp.Expr) -> sp.ImmutableDenseMatrix:
    """F over an interval: what moves by its derivatives."""
    return sp.ImmutableDenseMatrix(
        size, size, lambda i, j: step ** (j - i) / sp.factorial(j - i) if j >= i else 0
    )


def pairs(size: int) -> list[str]:
    """11, 12, ... of the upper triangle, row by row."""
    return [f"{i}{j}" for i in range(1, size + 1) for j in range(i, size + 1)]


def symmetric(prefix: str, size: int) -> sp.ImmutableDenseMatrix:
    """The symmetric matrix of named entries."""
    return sp.ImmutableDenseMatrix(
        size, size, lambda i, j: real(f"{prefix}_{min(i, j) + 1}{max(i, j) + 1}")
    )


def rows(prefix: str, size: int) -> list[list[str]]:
    """The names of its entries."""
    return [[entry.name for entry in line] for line in symmetric(prefix, size).tolist()]


def listed(matrix: sp.MatrixBase) -> tuple[sp.Expr, ...]:
    """The entries of the upper triangle, row by row."""
    return tuple(matrix[i, j] for i in range(matrix.rows) for j in range(i, matrix.cols))


def row(*entries: sp.Expr | int) -> sp.ImmutableDenseMatrix:
    """A matrix of one row."""
    return sp.ImmutableDenseMatrix([list(entries)])


def product(*factors: sp.MatrixBase | sp.Expr) -> sp.MatMul:
    """A product that is left for the checker to multiply out."""
    return sp.MatMul(*factors, evaluate=False)


def total(*terms: sp.MatrixBase | sp.MatrixExpr) -> sp.MatAdd:
    """A sum that is left for the checker."""
    return sp.MatAdd(*terms, evaluate=False)


def lyapunov(loop: Loop, noise: sp.MatrixBase) -> sp.ImmutableDenseMatrix:
    """P with P = A P A' + noise, A = F (I - K H), over the gains."""
    size = loop.size
    unknown = symmetric("p", size)
    names = list(listed(unknown))
    residual = loop.closed * unknown * loop.closed.T + noise - unknown
    solved = sp.solve(listed(residual), names, dict=True)
    return unknown.subs(solved[0]).applyfunc(tidy)


def tidy(value: sp.Expr) -> sp.Expr:
    """Factors, 2 alpha + beta - 4 below the line turned into what is positive inside."""
    top, below = sp.fraction(sp.factor(value))
    parts = []
    for factor in sp.Mul.make_args(below):
        turned = bool(factor.as_coeff_Add()[0] < 0)
        parts.append(-factor if turned else factor)
        top = -top if turned else top
    return sp.factor(top) / sp.Mul(*parts)


def lyapunov_map(loop: Loop) -> sp.ImmutableDenseMatrix:
    """P - A P A' as a matrix that acts on the entries of the upper triangle of P."""
    unknown = symmetric("p", loop.size)
    image = listed(unknown - loop.closed * unknown * loop.closed.T)
    names: Sequence[sp.Symbol] = listed(unknown)
    return sp.ImmutableDenseMatrix([[sp.expand(x).coeff(name) for name in names] for x in image])
