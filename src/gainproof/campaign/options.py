"""The options of campaigns on a command line, the same for each; imports nothing heavy."""

from __future__ import annotations

import argparse

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
