"""Tracks of many targets from the detections of a scanning radar.

`scans` checks detections, `Settings` holds what a tracker is told, `followed` makes tracks of them:
conversion to coordinates, gates, assignment, filters over arrays of tracks, beginning and end. The
assignment needs SciPy (the extra `tracking`).
"""

from gainproof.tracking.conversion import CONVERSIONS, converted
from gainproof.tracking.gains import FILTERS
from gainproof.tracking.measured import Measured, Polar
from gainproof.tracking.scans import DetectionError, Scans, scans
from gainproof.tracking.settings import Settings
from gainproof.tracking.tracker import Followed, followed

__all__ = [
    "CONVERSIONS",
    "FILTERS",
    "DetectionError",
    "Followed",
    "Measured",
    "Polar",
    "Scans",
    "Settings",
    "converted",
    "followed",
    "scans",
]
