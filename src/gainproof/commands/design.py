"""`gainproof design`: gains from noises, and the named fixed-gain filters side by side."""

from __future__ import annotations

import argparse

HELP = "gains in metres and seconds from noises; the named filters side by side"
DESCRIPTION = """\
From the noises of target and sensor, --interval, --deviation and one of the noise options: gains
per second, covariances in metres and seconds, and lines of Python and C to paste, of the Kalman
filter in its steady state. Its deviations hold for a target that moves as the noise says; behind
one that keeps an acceleration it lags, by what --acceleration (--jerk) shows. A greatest
acceleration is no deviation: half of it to all of it is usual.

Otherwise the named alpha-beta filters (RV random velocity, RA random acceleration, MV minimum
variance, NP-S minimum smoothed variance), with --states 3 alpha-beta-gamma filters (RA, RJ random
jerk, MV), for one choice of the user: gains, variance of the predicted and the smoothed position
over that of the measurement, lag, poles, settling. A filter that does not exist there is named with
the reason.

The lag is e_fin, the steady error of the predicted position, over a_c T^2 behind a constant
acceleration a_c; of three states over j T^3 behind a constant jerk j. The tracking index is that of
the noise whose steady state a filter is: sigma T/sigma_v for velocity increments, sigma T^2/sigma_v
for accelerations, sigma T^3/sigma_v for jerks; MV and NP-S have none and are shown at the lag
of a filter that does. --gains shows any gains beside the named filters of the same lag, and says
which filters they belong to within the digits given.

With --interval and --acceleration (--jerk) lags come in metres, with --deviation errors."""
NOISES = {
    "velocity-noise": ("M/S", "deviation of the velocity's step at each sample"),
    "acceleration-noise": ("M/S^2", "deviation of the acceleration; --states 3: of its step"),
    "acceleration-density": ("M^2/S^3", "spectral density of a continuous white acceleration"),
    "jerk-noise": ("M/S^3", "deviation of the jerk, three states"),
    "jerk-density": ("M^2/S^5", "spectral density of a continuous white jerk, three states"),
}


def configure(parser: argparse.ArgumentParser) -> None:
    choice = parser.add_mutually_exclusive_group(required=True)
    choice.add_argument("--lag", metavar="L", help="e_fin over a_c T^2, of three states over j T^3")
    choice.add_argument("--tracking-index", metavar="I", help="of each filter's own process noise")
    choice.add_argument("--alpha", metavar="A", help="gain of the position")
    choice.add_argument("--gains", nargs="+", metavar="GAIN", help="alpha and beta, or gamma too")
    for name, (unit, text) in NOISES.items():
        choice.add_argument(f"--{name}", metavar=unit, help=text)
    parser.add_argument("--states", choices=("2", "3"), help="two states (default) or three")
    parser.add_argument("--interval", metavar="T", help="sampling interval, s")
    parser.add_argument(
        "--acceleration", metavar="A_C", help="of the target, for its lag: m/s^2, two states"
    )
    parser.add_argument(
        "--jerk", metavar="J", help="of the target, for its lag: m/s^3, three states"
    )
    parser.add_argument("--deviation", metavar="SIGMA_V", help="of the measured position, m")
    parser.add_argument("--json", action="store_true", help="print the numbers as JSON")
    parser.add_argument(
        "--plot",
        metavar="FILE",
        help="draw variance against lag (.svg or .png, its numbers beside it as .csv; or .csv)",
    )


def run(options: argparse.Namespace) -> int:
    """0; 1 where none of the filters exists; 2 for a choice that is no number or not stable."""
    from gainproof.design.answer import answered

    return answered(options)
