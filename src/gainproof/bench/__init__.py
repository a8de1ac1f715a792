"""How fast and how exact the kernels are, measured in one run as ratios.

- `measure.figures`: the seconds and errors of one kernel; `rows`: the same as plain data.
- `results`: the rows of a run in a file, from which it is continued.
- `columns`, `table`, `page`, `plots`: what is shown of them.
"""

from __future__ import annotations

import argparse

from gainproof.bad_input import BadInputError


def run(options: argparse.Namespace) -> int:
    """Measure and print; 0, or 1 where a kernel is outside its proved bound."""
    if options.against is None:
        from gainproof.bench.running import run_table

        return run_table(options)
    if options.html or options.json or options.resume or options.numbers > 1:
        raise BadInputError(
            "--against prints a table of its own: leave --html, --json, --resume, --numbers"
        )
    from gainproof.bench.against import print_against

    print_against(options)
    return 0
