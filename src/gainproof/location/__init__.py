"""Position and velocity of a target from ranges and range rates, with ranges that multipath biases.

`stations` and `observations` check what is given, `locate` estimates by one of `METHODS`: an
iterated Taylor series over the whole covariance of the noise. `range_doppler_jacobians` gives
ranges and range rates of many targets from many stations with their derivatives. NumPy is all that
is imported.
"""

from gainproof.location.errors import (
    DivergedError,
    LocationError,
    OnStationError,
    TooFewError,
    UnobservableError,
)
from gainproof.location.estimate import locate
from gainproof.location.jacobians import Jacobians, range_doppler_jacobians
from gainproof.location.methods import METHODS
from gainproof.location.noise import diagonal
from gainproof.location.result import Location
from gainproof.location.stations import observations, stations

__all__ = [
    "METHODS",
    "DivergedError",
    "Jacobians",
    "Location",
    "LocationError",
    "OnStationError",
    "TooFewError",
    "UnobservableError",
    "diagonal",
    "locate",
    "observations",
    "range_doppler_jacobians",
    "stations",
]
