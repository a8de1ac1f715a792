"""Random claims that have no value on a thin set of their stated domain: none may be proved.

    python tests/campaigns/thin_sets.py [--claims N] [--seed N] [--executor WHERE] [--state FILE]

Half of the claims have no value somewhere, on sets of every dimension in one to five symbols; the
other half, like them, have one everywhere and should be proved; a third of both holds sines,
exponentials and logarithms. Prints what came of both, by kind
of claim, number of symbols and dimension, and the seconds of the slowest. Status 1 for a claim that
is proved where it has no value.
"""

from __future__ import annotations

import argparse
import signal
import sys
import time
from collections import Counter
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from files_digest import files_digest
from thin_sets import claims
from thin_sets_functions import claims as claims_with_functions

import gainproof.verify.judge
from gainproof.campaign.campaign import Campaign, Done, Report
from gainproof.campaign.carrying_out import carry_out
from gainproof.campaign.options import add_options
from gainproof.claims.time_limit import DEFAULT
from gainproof.verify.judge.verdict import ClaimVerdict

HELP = "random claims that have no value on a thin set of their domain: none may be proved"
AT_ONCE = 50
MADE = {"algebra": claims, "functions": claims_with_functions}
"""Of every three blocks one holds claims with functions."""
WORDS = {False: "without a value somewhere", True: "with one everywhere"}


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--claims", type=int, default=2000, help="of either half")
    parser.add_argument("--seed", type=int, default=1)
    add_options(parser)
    options = parser.parse_args()
    code = digest()
    blocks = [
        (
            "functions" if number % 3 == 2 else "algebra",
            has_value,
            options.seed * 10**6 + number,
            min(AT_ONCE, options.claims - first),
            code,
        )
        for has_value in (False, True)
        for number, first in enumerate(range(0, options.claims, AT_ONCE))
    ]
    return carry_out(Campaign("thin_sets", judge, blocks, report), options)


def judge(kind: str, has_value: bool, seed: int, count: int, _code: str) -> list[dict[str, Any]]:
    """The claims of one block with their verdicts."""
    found = []
    for claim in MADE[kind](seed, count, has_value=has_value):
        start = time.process_time()
        verdict, reason = _in_time(claim.judged)
        found.append(
            {
                "name": claim.name,
                "fields": claim.fields,
                "domains": dict(claim.symbols),
                "verdict": verdict,
                "reason": reason,
                "seconds": time.process_time() - start,
            }
        )
    return found


def _in_time(judged: Callable[[], ClaimVerdict]) -> tuple[str, str | None]:
    """Verdict and reason; a claim has the processor time that users give it, and is undecided after
    that (where the system has such a clock).
    """
    signal.signal(signal.SIGPROF, _stop)
    signal.setitimer(signal.ITIMER_PROF, DEFAULT)
    try:
        found = judged()
    except TimeoutError:
        return "undecided", "out of time"
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
    return found.verdict, found.reason


def _stop(*_: object) -> None:
    raise TimeoutError


def report(done: Sequence[Done]) -> Report:
    """The verdicts of both halves, and every claim that is proved where it has no value."""
    lines: list[str] = []
    wrong: list[str] = []
    for has_value, words in WORDS.items():
        records = [r for each in done if each.arguments[1] == has_value for r in each.result]
        verdicts = Counter(r["verdict"] for r in records)
        told = ", ".join(f"{number} {verdict}" for verdict, number in verdicts.most_common())
        slowest = max((r["seconds"] for r in records), default=0.0)
        lines.append(f"{len(records)} claims {words}: {told or 'none'}; slowest {slowest:.1f} s")
        wanted = "proved" if has_value else "conditional"
        others = Counter(f"{r['verdict']}: {r['name']}" for r in records if r["verdict"] != wanted)
        lines += [f"  {number:5} {name}" for name, number in others.most_common(12)]
        if not has_value:
            wrong = [f"PROVED: {r['fields']}\n  {r['domains']}" for r in records if _false(r)]
    return Report("\n".join([*lines, *wrong]), not wrong)


def _false(record: dict[str, Any]) -> bool:
    return bool(record["verdict"] == "proved")


def digest() -> str:
    """A digest of the judge's code and of what makes the claims."""
    judge_files = sorted(Path(gainproof.verify.judge.__file__).parent.rglob("*.py"))
    here = Path(__file__).resolve()
    support = here.parent.parent / "support"
    made = (support / "thin_sets.py", support / "thin_sets_functions.py")
    return files_digest((*judge_files, here, *made))


if __name__ == "__main__":
    sys.exit(main())
