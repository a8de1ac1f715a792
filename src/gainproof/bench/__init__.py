"""How fast and how exact the kernels are, measured in one run as ratios."""

from __future__ import annotations

import argparse


def run(options: argparse.Namespace) -> int:
    """Measure every kernel and print the table; status 0."""
    from gainproof.bench.table import print_table

    print_table(options)
    return 0
