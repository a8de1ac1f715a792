"""`gainproof steady`: the steady state of a model in numbers, with proved errors."""

from __future__ import annotations

import argparse

HELP = "gains of your own linear model in numbers, any states and measurements, proved"
DESCRIPTION = """\
The Kalman filter's steady state for a model with any number of states and measurements (up to 20):
gains, predicted and updated covariance, poles, as doubles whose errors are proved. Noises may be
singular or correlated, the motion unstable; where there is no steady state, the mode that is not
seen or not driven is named.

MODEL is a text file (TOML) with F, Q, H, R as formulas and numbers, the keys of a setting of a
claim file; docs/steady.md says what stands in one. It is read as data, nothing of it is executed.
--at gives its symbols values: --at 'T=1,q=1e-22'."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("model", metavar="MODEL", help="a model file, as clock.toml")
    parser.add_argument(
        "--at",
        metavar="NAME=VALUE,...",
        action="append",
        default=[],
        help="values of the symbols, as T=1,q=1e-22; decimals and fractions are taken exactly",
    )
    parser.add_argument(
        "--first",
        metavar="N",
        help="the gains of the first N samples in its place, from the model's `start`",
    )
    parser.add_argument("--json", action="store_true", help="print all as JSON, the errors too")
    parser.add_argument(
        "--certificate",
        metavar="FILE",
        help="write the proof there, for `python -m gainproof.verify.check_enclosure FILE`",
    )


def run(options: argparse.Namespace) -> int:
    """0; 2 for a model that cannot be used or has no steady state."""
    from gainproof.steady.answer import answered

    return answered(options)
