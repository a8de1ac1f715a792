"""Every proved claim of the repository broken and rewritten, and judged again.

    python tests/campaigns/claims.py [--mutants N] [--seed N] [--seconds S] [--state FILE]

Each claim that the snapshots of verdicts have as proved is changed in N ways, a fifth of them near
misses, each false by an evaluator that shares nothing with the judge; the judge must accept none,
under the convention under which the original is proved; and the originals must be true by that
evaluator. Each is written in other ways too, which should still be proved. The state file is
written after every few claims; a campaign that was interrupted goes on from it as long as judge and
claims are the same. Status 1 for a false accept.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import sys
import time
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from claim_campaign.proved import claim_paths, names_proved_before, subjects
from claim_campaign.run import accepted, processors, report, run
from saved_state import save

import gainproof.verify.judge
from gainproof.derive.catalogue import CATALOGUE

HELP = "every proved claim of the repository broken and rewritten, and judged again"
AT_ONCE = 8
LOST = {"not proved again within the time": 1}
NOTHING: dict[str, Any] = {"mutants": [], "rewrites": [], "left out": LOST, "doubt": False}
"""Of a claim that is not proved any more."""


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--mutants", type=int, default=10, help="of each claim")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=20.0, help="for one judgement")
    parser.add_argument("--state", type=Path, default=Path("claims.state.json"))
    parser.add_argument("--only", default="", help="text that the name of a claim must contain")
    options = parser.parse_args()
    every = [data for entry in CATALOGUE if (data := entry.build().model_data)]
    models = list({data["name"]: data for data in every}.values())
    state = load(options.state, f"{digest()} {options.mutants} {options.seed}")
    names = [name for name in names_proved_before() if options.only in name]
    todo = [name for name in names if name not in state["records"]]
    start = time.monotonic()
    for first in range(0, len(todo), AT_ONCE):
        some = todo[first : first + AT_ONCE]
        chosen = subjects(some, models, options.seconds, processors())
        found = run(chosen, models, options.mutants, options.seed, options.seconds)
        state["records"].update(dict.fromkeys(some, NOTHING) | found)
        save(options.state, state)
        done = first + len(some)
        left = (time.monotonic() - start) / done * (len(todo) - done)
        sys.stderr.write(f"\r{done}/{len(todo)} claims, about {left / 60:.1f} min left ")
        sys.stderr.flush()
    sys.stderr.write("\n")
    sys.stdout.write(report(state["records"]) + "\n")
    return 1 if accepted(state["records"]) else 0


def digest() -> str:
    """A digest of the judge's code and of all claim files."""
    found = hashlib.sha256()
    judge = Path(gainproof.verify.judge.__file__).parent
    for file in (*sorted(judge.rglob("*.py")), *claim_paths()):
        found.update(file.name.encode() + b"\0" + file.read_bytes() + b"\0")
    return found.hexdigest()


def load(path: Path, key: str) -> dict[str, Any]:
    """What was found by this very judge on these claims; nothing where something changed."""
    if path.exists():
        state: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        if state["key"] == key:
            return state
        sys.stderr.write(f"{path} is about another judge, claims or options: starting anew\n")
    return {"key": key, "records": {}}


if __name__ == "__main__":
    sys.exit(main())
