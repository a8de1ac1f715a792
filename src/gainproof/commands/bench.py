"""`gainproof bench`: how fast and how exact the kernels are."""

from __future__ import annotations

import argparse
from importlib import util

HELP = "measure the kernels: speed against C, lambdify and SciPy, worst error beside the bound"
DESCRIPTION = """\
Measures each kernel in one run: its time as a ratio to a C loop of the same graph, to SymPy's
lambdify and to SciPy's Riccati solver, and its worst measured error beside the proved bound."""
MODULE = "gainproof.bench"


def configure(parser: argparse.ArgumentParser) -> None:
    """One optional argument."""
    parser.add_argument(
        "subject", metavar="SUBJECT", nargs="*", help="which (see `list`); without it: all, minutes"
    )


def run(options: argparse.Namespace) -> int:
    """The status of the measurement; 2 where it is not installed."""
    from importlib import import_module

    from gainproof.bad_input import BadInputError

    if util.find_spec(MODULE) is None:
        raise BadInputError(f"the measurements ({MODULE}) are not part of this installation")
    status: int = import_module(MODULE).run(options)
    return status
