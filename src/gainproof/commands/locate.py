"""`gainproof locate`: position and velocity from ranges and range rates."""

from __future__ import annotations

import argparse

HELP = "locate a target from ranges and range rates, some ranges biased by multipath"
DESCRIPTION = """\
Position and velocity of a target, with their accuracy, from ranges and range rates (Doppler) that
stations observed, in two or three dimensions. Multipath makes single ranges too long: the default
method, unknown-reduction, first gives every range a bias of its own, tests each bias, and estimates
again with biases only where the test found one.

OBSERVATIONS and STATIONS are CSV files whose first line names columns with units, as range [km]:
station, range, range_rate, sigma_range, sigma_range_rate, correlation; and station, x, y, z, vx,
vy, vz (without z: in the plane; without velocities: standing still). An empty cell is no
observation. For range_rate, doppler and sigma_doppler in Hz, kHz or MHz will do, with a carrier: a
column, or --carrier. The shift is of one way and below 0 where the target goes away.

Methods: unknown-reduction, bias-detection, doppler-only, range-doppler (no bias), common-bias,
range-only. What the observations cannot tell is named before anything is estimated; another place
that explains them as well, as a mirror image, comes as a warning."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("observations", metavar="OBSERVATIONS", nargs="?", help="a CSV file")
    parser.add_argument("stations", metavar="STATIONS", nargs="?", help="a CSV file")
    parser.add_argument("--method", metavar="NAME", help="default: unknown-reduction")
    parser.add_argument(
        "--false-alarm",
        metavar="P",
        help="how often a clean range may be called biased; default: 0.05",
    )
    parser.add_argument(
        "--covariance",
        metavar="FILE",
        help="covariance of all ranges, then all range rates, in m and m/s: CSV without header",
    )
    parser.add_argument(
        "--carrier", metavar="F", help='of the column doppler, as "9.4 GHz"; or a column carrier'
    )
    parser.add_argument(
        "--near", metavar="X,Y", help="m; of places that explain the observations, the closest"
    )
    parser.add_argument("--json", action="store_true", help="print the numbers as JSON")
    parser.add_argument("--plot", metavar="FILE", help="draw it (.svg or .png; needs Matplotlib)")
    parser.add_argument("--example", metavar="DIR", help="write example files there, nothing else")


def run(options: argparse.Namespace) -> int:
    """0; 1 where there is no estimate; 2 for files that cannot be used."""
    from gainproof.location.answer import answered

    return answered(options)
