"""The whole mutation campaign: `python tests/campaigns/mutation.py [mutants each] [seed]`."""

from __future__ import annotations

import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))

from mutation.campaign import REFUSED, report, run
from mutation.relations import claimed_relations, derived_relations


def main(count: int = 20, seed: int = 1) -> int:
    """Prints the score; 1 if a false mutant was not refused."""
    start = time.perf_counter()
    relations = [*claimed_relations(), *derived_relations()]
    results = run(relations, count, seed)
    seconds = time.perf_counter() - start
    sys.stdout.write(f"relations: {len(relations)}, seconds: {seconds:.0f}\n{report(results)}\n")
    return 0 if all(r.verdict in REFUSED for r in results) else 1


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
