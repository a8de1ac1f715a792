"""How fast and how exact the kernels are, measured in one run as ratios."""

from __future__ import annotations

import argparse


def run(options: argparse.Namespace) -> int:
    """Measure every kernel and print a table; status 0."""
    if options.against is None:
        from gainproof.bench.table import print_table

        print_table(options)
    else:
        from gainproof.bench.against import print_against

        print_against(options)
    return 0
