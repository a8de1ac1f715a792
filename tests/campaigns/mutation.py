"""The whole mutation campaign on the relations of the derivations.

    python tests/campaigns/mutation.py [--mutants N] [--seed N] [--only TEXT] [--state FILE]

Each relation is broken, the mutants that an oracle calls false are judged, and a line says how many
were refused; who was not is named at once. The state file is written after every relation: a
campaign that was interrupted goes on from it as long as code, mutants and seed are the same.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from dataclasses import asdict
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from mutation.campaign import REFUSED, Relation, Result, mutants_of, report
from mutation.relations import claimed_relations, derived_relations
from saved_state import save
from spoken_lines import say, tell

from gainproof import code_digest

HELP = "break the relations of the derivations and of the claim files, and judge what comes"


def main() -> int:
    """Prints the score; 1 if a false mutant was not refused."""
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--mutants", type=int, default=20, help="mutants of each relation")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", default="", help="a part of the relation's name")
    parser.add_argument("--state", type=Path, default=Path("mutation.state.json"))
    options = parser.parse_args()
    state = load(options.state, f"{code_digest.of_everything()} {options.mutants} {options.seed}")
    tell("deriving")
    everything = [*claimed_relations(), *derived_relations(whole=True)]
    relations = [relation for relation in everything if options.only in relation.name]
    start = time.perf_counter()
    for number, relation in enumerate(relations, 1):
        if relation.name not in state["done"]:
            found, seconds = broken(relation, options.mutants, options.seed)
            state["done"][relation.name] = [asdict(result) for result in found]
            save(options.state, state)
            say(f"{number}/{len(relations)} {told(relation.name, found, seconds)}")
    results = [Result(**each) for r in relations for each in state["done"][r.name]]
    seconds = time.perf_counter() - start
    say(f"relations: {len(relations)}, seconds: {seconds:.0f}\n{report(results)}")
    return 0 if all(result.verdict in REFUSED for result in results) else 1


def broken(relation: Relation, count: int, seed: int) -> tuple[list[Result], float]:
    """The false mutants of a relation, judged, and the seconds it took."""
    start = time.perf_counter()
    found = mutants_of(relation, count, seed)
    return found, time.perf_counter() - start


def told(name: str, found: list[Result], seconds: float) -> str:
    """A line on one relation, and one on each mutant that was not refused."""
    left = [result for result in found if result.verdict not in REFUSED]
    head = f"{name}: {len(found) - len(left)} of {len(found)} refused, {seconds:.1f} s"
    return "\n".join([head, *(f"  {r.verdict}: {r.name}: {r.reason}" for r in left)])


def load(path: Path, key: str) -> dict[str, Any]:
    """What was judged by this very code with these mutants and seed; else nothing."""
    if path.exists():
        state: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        if state["key"] == key:
            return state
        tell(f"{path} is of another campaign: starting anew")
    return {"key": key, "done": {}}


if __name__ == "__main__":
    sys.exit(main())
