"""Every statement of the derivations over one index before the judge, with progress.

python tests/campaigns/statements.py [NAME ...]
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))

from judged_statements import GIVEN_UP, OF_ONE_INDEX, ROOTED_FAMILIES, judged


def main() -> int:
    """Prints each family's count and seconds; 1 if a verdict is another than expected."""
    known = [entry.name for entry in OF_ONE_INDEX]
    parser = argparse.ArgumentParser(description="judge every statement of the derivations")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"default: {', '.join(known)}")
    options = parser.parse_args()
    if unknown := set(options.names) - set(known):
        parser.error(f"no family over one index: {', '.join(sorted(unknown))}")
    failures = 0
    for name in options.names or known:
        start, count = time.perf_counter(), 0
        for statement, wrong in judged(name):
            count += 1
            sys.stdout.write(f"\r\x1b[K{name}: {count} {statement}")
            sys.stdout.flush()
            if wrong:
                failures += 1
                sys.stdout.write(f" {wrong}\n")
        seconds = time.perf_counter() - start
        alone = ["the kernels"] if name in ROOTED_FAMILIES else []
        alone += [statement for family, statement in sorted(GIVEN_UP) if family == name]
        left = f"; the checker alone decides {', '.join(alone)}" if alone else ""
        sys.stdout.write(f"\r\x1b[K{name}: {count} statements, {seconds:.0f} s{left}\n")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
