"""`--seconds N`: the processor time that the judge has for one claim."""

from __future__ import annotations

import argparse

DEFAULT = 60.0
MOST = 86400.0


def configure(parser: argparse.ArgumentParser) -> None:
    """Add the option; its value is `options.seconds`."""
    parser.add_argument(
        "--seconds",
        metavar="N",
        type=seconds_of,
        default=DEFAULT,
        help="processor time for one claim, which is undecided after that; that the machine is "
        f"busy takes none of it (default: {DEFAULT:g})",
    )


def seconds_of(text: str) -> float:
    """Of an option. Raises argparse.ArgumentTypeError."""
    try:
        seconds = float(text)
    except ValueError:
        seconds = 0.0
    if not 0 < seconds <= MOST:
        raise argparse.ArgumentTypeError(f"wanted: more than 0 seconds, at most a day, got {text}")
    return seconds
