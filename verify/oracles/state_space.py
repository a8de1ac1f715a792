"""State-space models as numbers, and what an oracle returns for one.

A model comes as the plain data that crosses the project's borders (rows of number texts), the
process noise given for tracking index 1 and multiplied by the index squared. Everything is kept
as exact fractions, a float index included, so that every oracle starts from the same numbers.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.verify.oracles.matrices import Matrix, matrix, scale

Index = int | float | str | Fraction


class NotConverged(ArithmeticError):
    """An oracle was used where it cannot work; the message says how far it came."""


def exact(value: Any) -> Fraction:
    """A number as a fraction, without rounding: int, float, Fraction or text such as "1/3".

    Raises ValueError for NaN, infinity and other text.
    """
    if isinstance(value, float) and not math.isfinite(value):
        raise ValueError(f"an oracle needs finite numbers, got {value!r}")
    return Fraction(value)


@dataclass(frozen=True)
class StateSpace:
    """x' = F x + w, z = H x + v, with var w = Q and var v = R, all entries exact.

    ``transition`` n x n, ``process_noise`` n x n, ``measurement`` m x n, ``measurement_noise``
    m x m. Raises ValueError when shapes do not fit or a variance is not symmetric.
    """

    transition: Matrix
    process_noise: Matrix
    measurement: Matrix
    measurement_noise: Matrix

    def __post_init__(self) -> None:
        n, m = len(self.transition), len(self.measurement)
        shapes = {
            "transition": (n, n),
            "process_noise": (n, n),
            "measurement": (m, n),
            "measurement_noise": (m, m),
        }
        for name, (rows, columns) in shapes.items():
            value: Matrix = getattr(self, name)
            if (len(value), len(value[0])) != (rows, columns):
                raise ValueError(
                    f"{name} must be {rows}x{columns}, got {len(value)}x{len(value[0])}"
                )
        for name in ("process_noise", "measurement_noise"):
            value = getattr(self, name)
            if value != tuple(zip(*value, strict=True)):
                raise ValueError(f"{name} must be symmetric, got {value}")

    @property
    def size(self) -> int:
        """Number of states."""
        return len(self.transition)

    def with_process_noise(self, factor: Fraction) -> StateSpace:
        """The same model with its process noise multiplied by ``factor``."""
        return StateSpace(
            self.transition,
            scale(factor, self.process_noise),
            self.measurement,
            self.measurement_noise,
        )


def state_space(data: Mapping[str, Any], tracking_index: Index = 1) -> StateSpace:
    """The model of ``data`` with process noise ``tracking_index**2`` times the given one.

    ``data`` has the fields transition, process_noise, measurement, measurement_noise, each a
    list of rows of numbers or number texts. The index must be positive and finite.
    """
    index = exact(tracking_index)
    if index <= 0:
        raise ValueError(f"the tracking index must be positive, got {tracking_index!r}")
    model = StateSpace(
        matrix(data["transition"], exact),
        matrix(data["process_noise"], exact),
        matrix(data["measurement"], exact),
        matrix(data["measurement_noise"], exact),
    )
    return model.with_process_noise(index * index)


@dataclass(frozen=True)
class SteadyState:
    """What an oracle returns: the four quantities of the steady state, in its own numbers.

    ``predicted`` M and ``updated`` X are n x n covariances, ``gain`` K = M H' (H M H' + R)^-1 is
    n x m, ``innovation`` H M H' + R is m x m.
    """

    predicted: Matrix
    updated: Matrix
    gain: Matrix
    innovation: Matrix

    def entries(self) -> dict[str, Any]:
        """Every number under a name such as ``predicted[0,1]``."""
        named: dict[str, Sequence[Sequence[Any]]] = {
            "predicted": self.predicted,
            "updated": self.updated,
            "gain": self.gain,
            "innovation": self.innovation,
        }
        return {
            f"{name}[{i},{j}]": entry
            for name, rows in named.items()
            for i, row in enumerate(rows)
            for j, entry in enumerate(row)
        }
