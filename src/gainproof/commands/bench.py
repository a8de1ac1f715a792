"""`gainproof bench`: how fast and how exact the kernels are."""

from __future__ import annotations

import argparse
from importlib import util

HELP = "measure the kernels: speed against C, lambdify and SciPy, worst error beside the bound"
DESCRIPTION = """\
Measures each kernel in one run: its time as a ratio to a C loop of the same graph, to SymPy's
lambdify and to SciPy's Riccati solver, and its worst measured error beside the proved bound. The
kernel fills given arrays, in the column `fresh` it makes its own as lambdify does.

With --against it prints nanoseconds a point instead: `length`, against the elements of a block, of
which the runtime chooses the marked one (block_length in generated/_guards.py); `size`, against
the number of points, with given arrays, with fresh ones, and with threads."""
MODULE = "gainproof.bench"


def configure(parser: argparse.ArgumentParser) -> None:
    """What is measured, and how."""
    parser.add_argument(
        "subject", metavar="SUBJECT", nargs="*", help="which (see `list`); without it: all, minutes"
    )
    parser.add_argument(
        "--workers", type=_count, default=2, metavar="N", help="threads, where there are (2)"
    )
    parser.add_argument(
        "--constant",
        metavar="PREFIX",
        help="inputs whose names begin so are one number, not an array; C is left out then",
    )
    parser.add_argument(
        "--against", choices=("length", "size"), help="nanoseconds a point in place of the table"
    )


def _count(text: str) -> int:
    """A number of threads."""
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is no number of threads, 1 or more")
    return int(text)


def run(options: argparse.Namespace) -> int:
    """The status of the measurement; 2 where it is not installed."""
    from importlib import import_module

    from gainproof.bad_input import BadInputError

    if util.find_spec(MODULE) is None:
        raise BadInputError(f"the measurements ({MODULE}) are not part of this installation")
    status: int = import_module(MODULE).run(options)
    return status
