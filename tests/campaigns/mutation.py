"""The whole mutation campaign on the relations of the derivations.

python tests/campaigns/mutation.py [--mutants N] [--seed N]
"""

from __future__ import annotations

import argparse
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "support"))

from mutation.campaign import REFUSED, report, run
from mutation.relations import claimed_relations, derived_relations


def main() -> int:
    """Prints the score; 1 if a false mutant was not refused."""
    parser = argparse.ArgumentParser(description="break the relations of the derivations")
    parser.add_argument("--mutants", type=int, default=20, help="mutants of each relation")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    start = time.perf_counter()
    relations = [*claimed_relations(), *derived_relations()]
    results = run(relations, options.mutants, options.seed)
    seconds = time.perf_counter() - start
    sys.stdout.write(f"relations: {len(relations)}, seconds: {seconds:.0f}\n{report(results)}\n")
    return 0 if all(r.verdict in REFUSED for r in results) else 1


if __name__ == "__main__":
    sys.exit(main())
