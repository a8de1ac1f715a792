"""State-space models as data: in quantities with units, and scaled to numbers and ratios."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import sympy as sp

from gainproof.derive.expression import graph_of
from gainproof.derive.quantity import MEASUREMENT_DEVIATION, METRE, Quantity, Unit

Rows = list[list[Any]]


class ModelError(ValueError):
    """A model that cannot be used; the message says what was wanted and what came."""


@dataclass(frozen=True)
class Ratio:
    """A parameter left by scaling: `quantity` in the unit that T and the reference give it.

    `name` is the dimensionless number, such as S = sigma_d T/sigma_o for a velocity deviation.
    """

    name: Quantity
    quantity: Quantity


@dataclass(frozen=True)
class Parameter:
    """A dimensionless number that stays free in the transition or in the process noise.

    It is positive, or between 0 and 1 where `below_one` (a decay ratio). Kernels take it from
    `kernel_from` to `kernel_to`, numbers as text.
    """

    quantity: Quantity
    below_one: bool = False
    kernel_from: str = "1/1024"
    kernel_to: str = ""

    @property
    def kernel_range(self) -> tuple[str, str]:
        """The domain of a kernel's input, both ends admitted."""
        return self.kernel_from, self.kernel_to or ("1023/1024" if self.below_one else "1024")


@dataclass(frozen=True)
class Model:
    """x(k+1) = F x(k) + w, z = H x + v with E w w' = Q and E v v' = R.

    Matrices are written over the symbols of `quantities`; `state_units` and `measurement_units` are
    the units of the state and of the measurement. The process noise is one unknown strength times
    a matrix. `deviation` is the length, in metres, that becomes 1: the deviation of the first
    measurement; every further deviation in R has its ratio to it in `ratios`. Free dimensionless
    numbers in F and in the matrix of Q are `parameters`.
    """

    name: str
    title: str
    transition: sp.ImmutableDenseMatrix
    process_noise: sp.ImmutableDenseMatrix
    measurement: sp.ImmutableDenseMatrix
    measurement_noise: sp.ImmutableDenseMatrix
    quantities: tuple[Quantity, ...]
    state_units: tuple[Unit, ...]
    measurement_units: tuple[Unit, ...] = (METRE,)
    deviation: Quantity = MEASUREMENT_DEVIATION
    ratios: tuple[Ratio, ...] = ()
    parameters: tuple[Parameter, ...] = ()

    def __str__(self) -> str:
        """The title and the matrices, a line each."""
        shown = [f"  {label} = {matrix.tolist()}" for label, matrix in self._matrices()]
        return "\n".join([f"{self.name}: {self.title}", *shown])

    def _repr_latex_(self) -> str:
        """The matrices, for a notebook; it takes this form, and the title is `print`'s."""
        rows = [f"{label} = {sp.latex(matrix)}" for label, matrix in self._matrices()]
        body = r" \\ ".join(rows)
        return rf"$$\begin{{gathered}}{body}\end{{gathered}}$$"

    def _matrices(self) -> list[tuple[str, sp.MatrixBase]]:
        return [
            ("F", self.transition),
            ("Q", self.process_noise),
            ("H", self.measurement),
            ("R", self.measurement_noise),
        ]


@dataclass(frozen=True)
class ScaledModel:
    """The model in units T = 1 and sigma_v = 1: `process_noise` is multiplied by q = index squared.

    `noise_ratio` is q in the quantities of the model, normalised so that the noise polynomial of
    the first measurement is 1 at zero frequency; `state_scale` and `measurement_scale` are the
    lengths of one unit of each state and measurement. `measurement_noise` is written over the names
    in `ratios`, which gives each in the quantities of the model; the rest are numbers.
    """

    name: str
    title: str
    transition: sp.ImmutableDenseMatrix
    process_noise: sp.ImmutableDenseMatrix
    measurement: sp.ImmutableDenseMatrix
    measurement_noise: sp.ImmutableDenseMatrix
    noise_ratio: sp.Expr
    state_scale: tuple[sp.Expr, ...]
    measurement_scale: tuple[sp.Expr, ...] = ()
    ratios: Mapping[str, sp.Expr] = field(default_factory=dict)

    def data(self) -> dict[str, Any]:
        """Plain data that crosses the border to the judge and the checker.

        An entry is a number as text or, where a ratio occurs, an expression graph over its name.
        """
        return {
            "name": self.name,
            "title": self.title,
            "transition": _rows(self.transition),
            "process_noise": _rows(self.process_noise),
            "measurement": _rows(self.measurement),
            "measurement_noise": _rows(self.measurement_noise),
        }


def _rows(matrix: sp.ImmutableDenseMatrix) -> Rows:
    return [[_entry(entry) for entry in row] for row in matrix.tolist()]


def _entry(entry: sp.Expr) -> Any:
    return graph_of(entry) if entry.free_symbols else str(sp.Rational(entry))
