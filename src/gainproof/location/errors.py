"""What stops a location: each error with what a caller may want beside its message."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gainproof.location.result import Convergence


@dataclass(frozen=True)
class Direction:
    """One direction that is not observed: its parts of position and velocity, in m and m/s, and the
    range biases that go with it, in m; words say it.
    """

    position: tuple[float, ...]
    velocity: tuple[float, ...]
    biases: tuple[tuple[str, float], ...]
    words: str


class LocationError(ValueError):
    """There is no estimate; the message says why."""


class TooFewError(LocationError):
    """Fewer observations than unknowns: `need` and `have`, counted before solving."""

    def __init__(self, message: str, need: int, have: int) -> None:
        super().__init__(message)
        self.need, self.have = need, have


class UnobservableError(LocationError):
    """The observations leave some directions of position and velocity free: `directions`."""

    def __init__(self, message: str, directions: tuple[Direction, ...]) -> None:
        super().__init__(message)
        self.directions = directions


class OnStationError(LocationError):
    """The target comes to lie on a station, where a range has no derivative: `station`."""

    def __init__(self, message: str, station: str) -> None:
        super().__init__(message)
        self.station = station


class DivergedError(LocationError):
    """The iteration did not settle: `report` says how far it came."""

    def __init__(self, message: str, report: Convergence) -> None:
        super().__init__(message)
        self.report = report
