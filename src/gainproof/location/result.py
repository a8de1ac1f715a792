"""What a location gives back."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.selection import Selection


@dataclass(frozen=True)
class Convergence:
    """How an iteration ended: in words, its iterations and halved steps, the length of its last
    step in deviations, the cost (sum of squares of white residuals) and its degrees of freedom, and
    the ratio of the least to the largest singular value of the scaled model at its end.
    """

    ended: str
    iterations: int
    halvings: int
    step: float
    cost: float
    degrees_of_freedom: int
    ratio: float


@dataclass(frozen=True)
class Bias:
    """A range's bias and its deviation in m; station "all" for a common one."""

    station: str
    value: float
    deviation: float


@dataclass(frozen=True, eq=False)
class Place:
    """A place with its velocity (None where none is estimated), and the cost there."""

    position: Reals
    velocity: Reals | None
    cost: float


@dataclass(frozen=True, eq=False)
class Location:
    """The estimate of one method.

    position (d,) in m, velocity (d,) in m/s or None; covariance (k, k) of position, velocity and
    then the biases in their order; selection of the ranges taken as clean, where the method
    chooses; rank: the scaled rank of the model, that of all unknowns of position and velocity.
    others: places that explain the observations as well; warnings: sentences. `first` is the bias
    detection that a selection rests on.
    """

    method: str
    position: Reals
    velocity: Reals | None
    covariance: Reals
    biases: tuple[Bias, ...]
    selection: Selection | None
    convergence: Convergence
    rank: int
    others: tuple[Place, ...]
    warnings: tuple[str, ...]
    first: Location | None = None
