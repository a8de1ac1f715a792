"""What proofs on weighted least squares use again and again, each a statement of its own."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.derive.estimation.linear_setting import LINEAR, POSITIVE, SOLVABLE, A, M, V
from gainproof.derive.words.expression import ZERO
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)


@dataclass(frozen=True)
class Facts:
    """V^-1 and M^-1: that they are, are symmetric and positive definite."""

    noise_regular: Statement
    noise_symmetric: Statement
    noise_definite: Statement
    regular: Statement
    symmetric: Statement
    definite: Statement
    covariance_definite: Statement

    @property
    def noise(self) -> list[Statement]:
        """Those on the noise alone, the orders left out."""
        return [self.noise_regular, self.noise_symmetric]

    @property
    def equations(self) -> list[Statement]:
        """All that rewriting uses."""
        return [*self.noise, self.regular, self.symmetric]


def facts() -> Facts:
    """Under V > 0, the last four also with an inverse of A' V^-1 A."""
    noise = prove_invertible("noise-regular", Search(LINEAR, [POSITIVE]), "noise", POSITIVE)
    turned = prove_equal(
        "weight-symmetric",
        Search(LINEAR, [POSITIVE], [noise], rounds=1),
        V.inverse.T,
        V.inverse,
    )
    weight = prove_order(
        "weight-definite",
        Search(LINEAR, [POSITIVE], [noise, turned]),
        V.inverse,
        ZERO,
        [Square(V.inverse, POSITIVE, left_inverse=V)],
        strict=True,
    )
    regular = prove_invertible(
        "information-regular", Search(LINEAR, [SOLVABLE]), "information", SOLVABLE
    )
    definite = prove_order(
        "information-definite",
        Search(LINEAR, [POSITIVE], [turned, weight, regular]),
        M,
        ZERO,
        [Square(A, weight, left_inverse=M.inverse @ A.T @ V.inverse)],
        strict=True,
    )
    symmetric = prove_equal(
        "covariance-symmetric",
        Search(LINEAR, [POSITIVE], [turned, regular], rounds=1),
        M.inverse.T,
        M.inverse,
    )
    covariance = prove_order(
        "covariance-definite",
        Search(LINEAR, [POSITIVE], [turned, regular, symmetric, definite]),
        M.inverse,
        ZERO,
        [Square(M.inverse, definite, left_inverse=M)],
        strict=True,
    )
    return Facts(noise, turned, weight, regular, symmetric, definite, covariance)
