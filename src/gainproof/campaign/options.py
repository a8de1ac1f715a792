"""The options of campaigns on a command line, the same for each; imports nothing heavy."""

from __future__ import annotations

import argparse

from gainproof.bad_input import BadInputError

MOST_JOBS = 1024
EXECUTORS = "processes, threads, or the address of a Dask scheduler, tcp://host:port"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Where a campaign runs, what it keeps, which of its blocks."""
    parser.add_argument("--executor", metavar="WHERE", default="processes", help=EXECUTORS)
    parser.add_argument(
        "--jobs", metavar="N", type=int, help="processes or threads; default: one a processor"
    )
    parser.add_argument(
        "--state", metavar="FILE", help="what is done is kept there; default: NAME.state.jsonl"
    )
    parser.add_argument("--blocks", metavar="A-B", help="these alone; the first is 0")


def require_jobs(jobs: int | None) -> None:
    """Raises BadInputError for a number of processes or threads that no machine has."""
    if jobs is not None and not 1 <= jobs <= MOST_JOBS:
        raise BadInputError(f"--jobs is a number from 1 to {MOST_JOBS}, got {jobs}")
