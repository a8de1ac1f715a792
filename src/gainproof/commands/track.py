"""`gainproof track`: tracks of many targets from a radar's detections."""

from __future__ import annotations

import argparse

HELP = "follow targets through the scans of a radar: alpha-beta and Kalman filters"
DESCRIPTION = """\
Tracks of many targets from the ranges and bearings that a scanning radar detected, each detection
with its track or "unassigned": coordinates, gates, assignment by least squared distance, filters,
tracks begun, confirmed and dropped.

DETECTIONS is a CSV file whose first line names columns with units, as range [km]: time, range,
bearing (from north, clockwise), sigma_range, sigma_bearing. Rows stand in the order of time; those
of one time are a scan; a row without range and bearing is a scan in which nothing was detected.

Filters: kalman (default); with gains of the steady state at the tracking index of a nominal range
(fixed), followed to first order from there (first-order-constant) or from update to update
(first-order-recursive), of each measurement (exact), of the line of sight and across it
(line-of-sight). Needs SciPy (the extra `tracking`)."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("detections", metavar="DETECTIONS", nargs="?", help="a CSV file")
    parser.add_argument("--filter", metavar="NAME", help="default: kalman")
    parser.add_argument(
        "--conversion",
        metavar="NAME",
        help="modified-unbiased (default), unbiased, debiased or classical",
    )
    parser.add_argument(
        "--acceleration", metavar="SIGMA", help="deviation of accelerations, m/s^2; default: 0.98"
    )
    parser.add_argument(
        "--gate", metavar="P", help="probability that a target's detection is in it; default: 0.999"
    )
    parser.add_argument("--max-speed", metavar="V", help="of targets, m/s; default: 400")
    parser.add_argument(
        "--confirm", metavar="M/N", help="a track needs M detections in N scans; default: 3/4"
    )
    parser.add_argument(
        "--drop", metavar="N", help="a track ends after N scans without a detection; default: 5"
    )
    parser.add_argument(
        "--nominal-range", metavar="R", help="of the fixed gains, m; default: the median range"
    )
    parser.add_argument("--sigma-range", metavar="M", help="m, for files without such a column")
    parser.add_argument("--sigma-bearing", metavar="DEG", help="degrees, likewise")
    parser.add_argument("--out", metavar="FILE", help="write every detection with its track (CSV)")
    parser.add_argument("--json", action="store_true", help="print the tracks as JSON")
    parser.add_argument("--plot", metavar="FILE", help="draw it (.svg or .png; needs Matplotlib)")
    parser.add_argument("--example", metavar="DIR", help="write an example file there, no more")


def run(options: argparse.Namespace) -> int:
    """0; 1 where there is no track; 2 for files or options that cannot be used."""
    from gainproof.tracking.answer import answered

    return answered(options)
