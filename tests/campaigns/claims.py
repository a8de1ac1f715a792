"""Every proved claim of the repository broken and rewritten, and judged again.

    python tests/campaigns/claims.py [--mutants N] [--seed N] [--seconds S] [--only TEXT]
                                     [--executor WHERE] [--state FILE]

Each claim that the snapshots of verdicts have as proved is changed in N ways, a fifth of them near
misses, each false by an evaluator that shares nothing with the judge; the judge must accept none,
under the convention under which the original is proved; and the originals must be true by that
evaluator. The certificate of each verdict on a mutant is replayed and must come to that verdict.
Each is written in other ways too, which should still be proved. A campaign that was interrupted
goes on as long as judge and claims are the same. Status 1 for a false accept, or for a verdict that
comes out otherwise.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from claim_campaign.proved import claim_paths, names_proved_before, subjects
from claim_campaign.run import accepted, run
from claim_campaign.run import report as score
from files_digest import files_digest

import gainproof.verify.judge
from gainproof.campaign.campaign import Campaign, Done, Report
from gainproof.campaign.carrying_out import carry_out
from gainproof.campaign.options import add_options
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
    parser.add_argument("--only", default="", help="text that the name of a claim must contain")
    add_options(parser)
    options = parser.parse_args()
    names = [name for name in names_proved_before() if options.only in name]
    code = digest()
    blocks = [
        (names[first : first + AT_ONCE], options.mutants, options.seed, options.seconds, code)
        for first in range(0, len(names), AT_ONCE)
    ]
    return carry_out(Campaign("claims", broken, blocks, report), options)


def broken(names: list[str], count: int, seed: int, seconds: float, _code: str) -> dict[str, Any]:
    """What came of the mutants and rewritings of some claims, by name."""
    chosen = subjects(names, models(), seconds, 1)
    found = run(chosen, models(), count, seed, seconds, 1)
    return dict.fromkeys(names, NOTHING) | found


@cache
def models() -> Sequence[Mapping[str, Any]]:
    """Those of the catalogue, each once; each process derives them once."""
    every = [data for entry in CATALOGUE if (data := entry.build().model_data)]
    return list({data["name"]: data for data in every}.values())


def report(done: Sequence[Done]) -> Report:
    """The score; a false accept is wrong."""
    records = {name: record for each in done for name, record in each.result.items()}
    return Report(score(records), not accepted(records))


def digest() -> str:
    """A digest of the judge's code and of all claim files."""
    judge = Path(gainproof.verify.judge.__file__).parent
    return files_digest((*sorted(judge.rglob("*.py")), *claim_paths()))


if __name__ == "__main__":
    sys.exit(main())
