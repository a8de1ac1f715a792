"""`gainproof cite`: the works that something rests on."""

from __future__ import annotations

import argparse

HELP = "name the works that a derivation, a kernel or a claim file rests on"
DESCRIPTION = """\
NAME is a derivation, a kernel (`gains`, or `random_velocity.gains`), a work (`gainproof list` shows
its key), the key of a claim file of gainproof, or a claim file of your own."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("name", metavar="NAME", help="what to find the sources of, or a FILE.toml")


def run(options: argparse.Namespace) -> int:
    """0, or 2 for a name that nothing has."""
    from gainproof import terminal_text
    from gainproof.pages import citing

    print(citing.citation(options.name, terminal_text.width()), end="")
    return 0
