"""The whole mutation campaign on the relations of the derivations.

    python tests/campaigns/mutation.py [--mutants N] [--seed N] [--only TEXT] [--executor WHERE]
                                       [--state FILE]

Each relation is broken, and the mutants that an oracle calls false are judged; who was not refused
is named in the end. A campaign that was interrupted goes on as long as code, mutants and seed are
the same.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from dataclasses import asdict
from functools import cache
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from mutation.campaign import REFUSED, Relation, Result, mutants_of
from mutation.campaign import report as score
from mutation.relations import claimed_relations, derived_relations

from gainproof.campaign.campaign import Campaign, Done, Report
from gainproof.campaign.carrying_out import carry_out
from gainproof.campaign.options import add_options
from gainproof.jobs import code_digest

HELP = "break the relations of the derivations and of the claim files, and judge what comes"


def main() -> int:
    """Prints the score; 1 if a false mutant was not refused."""
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--mutants", type=int, default=20, help="mutants of each relation")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="a part of the relation's name")
    add_options(parser)
    options = parser.parse_args()
    code = code_digest.of_modules(
        *code_digest.modules_in("derive"), *code_digest.modules_in("verify")
    )
    names = [name for name in relations() if options.only in name]
    blocks = [(name, options.mutants, options.seed, code) for name in names]
    return carry_out(Campaign("mutation", broken, blocks, report), options)


@cache
def relations() -> Mapping[str, Relation]:
    """All by name; each process derives them once."""
    everything = [*claimed_relations(), *derived_relations(whole=True)]
    return {relation.name: relation for relation in everything}


def broken(name: str, count: int, seed: int, _code: str) -> list[dict[str, Any]]:
    """The false mutants of a relation, judged."""
    return [asdict(result) for result in mutants_of(relations()[name], count, seed)]


def report(done: Sequence[Done]) -> Report:
    """The score, and a line on each mutant that was not refused."""
    results = [Result(**result) for each in done for result in each.result]
    left = [result for result in results if result.verdict not in REFUSED]
    lines = [f"  {r.verdict}: {r.relation}, {r.name}: {r.reason}" for r in left]
    return Report("\n".join([*lines, f"relations: {len(done)}", score(results)]), not left)


if __name__ == "__main__":
    sys.exit(main())
