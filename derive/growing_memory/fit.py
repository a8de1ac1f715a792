"""A polynomial fitted to samples 0..k by least squares, as a filter at the newest sample.

The state holds the fitted value and its derivatives at sample k in units T = 1. Sample k - j is
seen through the row (1, -j, j^2/2, ...).
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.expression import real

K, J = real("k"), real("j")
GAIN_NAMES = ("alpha", "beta", "gamma")


@dataclass(frozen=True)
class Fit:
    """Everything about one degree in closed form in k.

    power_sums: sum of j^m for j = 0..k. information: sum of the rows' squares; covariance: its
    inverse; gain: its first column; predicted: F covariance(k - 1) F'.
    """

    degree: int
    transition: sp.ImmutableDenseMatrix
    measurement: sp.ImmutableDenseMatrix
    power_sums: tuple[sp.Expr, ...]
    information: sp.ImmutableDenseMatrix
    covariance: sp.ImmutableDenseMatrix
    predicted: sp.ImmutableDenseMatrix

    @property
    def size(self) -> int:
        """Number of states."""
        return self.degree + 1

    @property
    def gain(self) -> sp.ImmutableDenseMatrix:
        """Weights of the newest innovation."""
        return sp.ImmutableDenseMatrix(self.covariance[:, 0])


def fit(degree: int) -> Fit:
    """Solve the normal equations symbolically in k."""
    size = degree + 1
    transition = sp.ImmutableDenseMatrix(
        size,
        size,
        lambda i, j: sp.Rational(1, sp.factorial(j - i)) if j >= i else sp.Integer(0),
    )
    measurement = sp.ImmutableDenseMatrix(1, size, lambda _, j: int(j == 0))
    sums = tuple(sp.factor(sp.summation(J**m, (J, 0, K))) for m in range(2 * degree + 1))
    information = sp.ImmutableDenseMatrix(
        size,
        size,
        lambda a, b: sp.factor((-1) ** (a + b) * sums[a + b] / (sp.factorial(a) * sp.factorial(b))),
    )
    covariance = sp.ImmutableDenseMatrix(information.inv().applyfunc(sp.factor))
    earlier = covariance.subs(K, K - 1)
    predicted = sp.ImmutableDenseMatrix((transition * earlier * transition.T).applyfunc(sp.factor))
    return Fit(degree, transition, measurement, sums, information, covariance, predicted)


def entry_names(prefix: str, size: int) -> list[list[str]]:
    """Names of the entries of a symmetric matrix."""
    return [
        [f"{prefix}_{min(i, j)}{max(i, j)}" for j in range(1, size + 1)] for i in range(1, size + 1)
    ]


def _elements(f: Fit, predicted: bool) -> dict[str, sp.Expr]:
    elements: dict[str, sp.Expr] = {}
    matrices = [("information", f.information), ("updated", f.covariance)]
    if predicted:
        matrices.append(("predicted", f.predicted))
    for prefix, matrix in matrices:
        names = entry_names(prefix, f.size)
        for i in range(f.size):
            for j in range(i, f.size):
                elements[names[i][j]] = matrix[i, j]
    elements |= dict(zip(GAIN_NAMES, f.gain, strict=False))
    return elements


def batch_tower(f: Fit) -> Tower:
    """k >= degree: as many samples as unknowns."""
    return Tower(
        "main", (Parameter("k", above=None, start=str(f.degree)),), (), _elements(f, False)
    )


def recursion_tower(f: Fit) -> Tower:
    """k >= degree + 1: a fit exists one sample earlier."""
    return Tower(
        "later", (Parameter("k", above=None, start=str(f.degree + 1)),), (), _elements(f, True)
    )
