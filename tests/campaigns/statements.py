"""Every statement of the derivations over one index before the judge, with progress.

python tests/campaigns/statements.py [NAME ...]
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))

from judged_statements import OF_ONE_INDEX, judged, undecided, unjudged


def main() -> int:
    """Prints each family's count and seconds, and by name what is not decided; 1 if a verdict is
    another than expected.
    """
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
        # these have the checker of certificates alone
        words = [f"{count} statements judged, {seconds:.0f} s"]
        if left := undecided(name):
            words.append(f"of these not proved, as known: {', '.join(left)}")
        if left := unjudged(name):
            words.append(
                f"not judged, of towers with a coupled pair: {len(left)}, {', '.join(left)}"
            )
        sys.stdout.write(f"\r\x1b[K{name}: {'; '.join(words)}\n")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
