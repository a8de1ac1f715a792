"""Filters of two coordinates in numbers: K2 = I, B = I, T = 1 and a gain of the position."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import Relation, equal

TRANSITION = sp.ImmutableDenseMatrix(4, 4, lambda i, j: int(i == j or j == i + 2))
SEEN = sp.ImmutableDenseMatrix(2, 4, lambda i, j: int(i == j))
UNIT = sp.eye(2).as_immutable()


@dataclass(frozen=True)
class Example:
    """One filter; `tag` begins the names of its gains in the tower `place`."""

    tag: str
    place: str
    position: sp.ImmutableDenseMatrix

    @property
    def gain(self) -> sp.ImmutableDenseMatrix:
        """K, the gain of the position above that of the velocity."""
        return sp.ImmutableDenseMatrix(self.position.col_join(UNIT))

    @property
    def names(self) -> list[list[str]]:
        """The entries of the gain by name."""
        return [[f"{self.tag}_{i}{j}" for j in (1, 2)] for i in (1, 2, 3, 4)]

    @property
    def elements(self) -> dict[str, sp.Expr]:
        """What the names stand for."""
        return {
            name: self.gain[i, j] for i, row in enumerate(self.names) for j, name in enumerate(row)
        }

    @property
    def latex(self) -> dict[str, str]:
        """How the names are printed."""
        return {name: f"k_{{{name[-2:]}}}" for row in self.names for name in row}

    @property
    def loop(self) -> sp.ImmutableDenseMatrix:
        """F (I - K H)."""
        return sp.ImmutableDenseMatrix(TRANSITION * (sp.eye(4) - self.gain * SEEN))

    @property
    def noise(self) -> sp.ImmutableDenseMatrix:
        """What the measurement noise enters the prediction by."""
        return sp.ImmutableDenseMatrix(TRANSITION * self.gain)

    @cached_property
    def covariance(self) -> sp.ImmutableDenseMatrix:
        """The steady covariance of the prediction, from its linear equations."""
        entries = {(i, j): sp.Symbol(f"w{i}{j}") for j in range(4) for i in range(j + 1)}
        found = sp.Matrix(4, 4, lambda i, j: entries[min(i, j), max(i, j)])
        equations = found - self.loop * found * self.loop.T - self.noise * self.noise.T
        return sp.ImmutableDenseMatrix(
            found.subs(sp.solve(list(equations), list(entries.values())))
        )

    @property
    def updated(self) -> sp.ImmutableDenseMatrix:
        """The covariance of the updated position."""
        rest = UNIT - self.position
        return sp.ImmutableDenseMatrix(
            rest * self.covariance[:2, :2] * rest.T + self.position * self.position.T
        )

    def stable(self, sentence: str, reason: str, heading: str = "") -> list[Step]:
        """The filter and that it is stable."""
        relation = Relation("stable", {"model": _model(), "gain": self.names})
        named = sp.ImmutableDenseMatrix([[real(name) for name in row] for row in self.names])
        return [
            Step(
                f"{self.tag}-stable",
                sentence,
                relation,
                reason,
                self.place,
                self._schur_cohn(),
                heading=heading,
            ),
            joined(f"{self.tag}-gain", equal(named, self.gain), self.place),
        ]

    def steady(self, sentence: str, reason: str) -> Step:
        """Its steady covariance."""
        right = sp.MatAdd(
            sp.MatMul(self.loop, self.covariance, self.loop.T.as_immutable()),
            sp.MatMul(self.noise, self.noise.T.as_immutable()),
        )
        relation = equal(self.covariance, right)
        return Step(f"{self.tag}-steady", sentence, relation, reason, self.place)

    def _schur_cohn(self) -> Mapping[str, Any]:
        """The hint of the stability: coefficients, and a_n - a_0 and a_n + a_0 of each degree."""
        z = real("z")
        coefficients = (z * sp.eye(4) - self.loop).det().as_poly(z).all_coeffs()[::-1]
        rest, values = coefficients, []
        while len(rest) > 1:
            low, high = rest[0], rest[-1]
            values += [high - low, high + low]
            rest = [high * rest[k + 1] - low * rest[-k - 2] for k in range(len(rest) - 1)]
        return {"coefficients": coefficients[:-1], "values": values}


def _model() -> dict[str, object]:
    def rows(matrix: sp.MatrixBase) -> list[list[str]]:
        return [[str(entry) for entry in matrix.row(i)] for i in range(matrix.rows)]

    return {
        "name": "two-coordinates",
        "title": "Two coordinates at constant velocity",
        "transition": rows(TRANSITION),
        "process_noise": rows(sp.zeros(4, 4)),
        "measurement": rows(SEEN),
        "measurement_noise": rows(sp.eye(2)),
    }
