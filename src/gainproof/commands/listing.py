"""`gainproof list`: what there is."""

from __future__ import annotations

import argparse

HELP = "list derivations with their kernels, and claim files with their claims"
DESCRIPTION = "Lists every derivation with its kernels, and every claim file with its claims."


def configure(parser: argparse.ArgumentParser) -> None:
    """No options."""


def run(_options: argparse.Namespace) -> int:
    """0."""
    from gainproof import citing, page
    from gainproof.workshop import open_workshop

    print(citing.listing(open_workshop(quiet=True), page.width()), end="")
    return 0
