"""The columns of stations and of observations."""

from __future__ import annotations

from gainproof.tables.kind import FREQUENCIES, LENGTHS, PURE, SPEEDS, Kind

STATION_COLUMNS = {
    "station": Kind(None, needed=True),
    "x": Kind(LENGTHS, needed=True),
    "y": Kind(LENGTHS, needed=True),
    "z": Kind(LENGTHS),
    "vx": Kind(SPEEDS),
    "vy": Kind(SPEEDS),
    "vz": Kind(SPEEDS),
}
OBSERVATION_COLUMNS = {
    "station": Kind(None, needed=True),
    "range": Kind(LENGTHS, above_zero=True, blank=True),
    "sigma_range": Kind(LENGTHS, above_zero=True, deviation=True, blank=True),
    "range_rate": Kind(SPEEDS, blank=True),
    "sigma_range_rate": Kind(SPEEDS, above_zero=True, deviation=True, blank=True),
    "doppler": Kind(FREQUENCIES, blank=True),
    "sigma_doppler": Kind(FREQUENCIES, above_zero=True, blank=True),
    "carrier": Kind(FREQUENCIES, above_zero=True, blank=True),
    "correlation": Kind(PURE, blank=True),
}
