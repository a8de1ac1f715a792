"""`gainproof list`: what there is."""

from __future__ import annotations

import argparse

HELP = "list derivations with their kernels, and claim files with their claims"
DESCRIPTION = """\
Lists every derivation with its kernels, and every claim file with its claims.

With --cancellations: the kernels in which subtractions of computed values are left, and why. All
numbers are dimensionless. Exit status 0."""


def configure(parser: argparse.ArgumentParser) -> None:
    """What to list."""
    parser.add_argument(
        "--cancellations",
        action="store_true",
        help="the subtractions of computed values that are left in kernels, and why",
    )


def run(options: argparse.Namespace) -> int:
    """0."""
    from gainproof import terminal_text
    from gainproof.pages import cancellations, citing

    if options.cancellations:
        print(cancellations.page(terminal_text.width()), end="")
        return 0
    print(citing.listing(terminal_text.width()), end="")
    return 0
