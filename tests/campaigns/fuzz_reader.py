"""Very many random inputs for the reader of formulas and of claim files, for the judge, and for the
command line: nothing but their own errors may come out.

    python tests/campaigns/fuzz_reader.py [--inputs N] [--files N] [--judged N] [--commands N]
        [--executor WHERE] [--state FILE]

Prints how many were read, the crashes, the worst time and the worst growth of memory of one input.
A campaign that was interrupted goes on, and one with more inputs adds to what is done, as long as
the reader is the same. Status 1 for a crash.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from dataclasses import asdict
from functools import reduce
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from files_digest import files_digest
from fuzz_tally import Tally
from input_fuzz import fuzz_commands, fuzz_judged, fuzz_tables
from reader_campaign import CLAIMS, fuzz_files, fuzz_formulas, fuzz_made

import gainproof.verify.judge
from gainproof.campaign.campaign import Campaign, Done, Report
from gainproof.campaign.carrying_out import carry_out
from gainproof.campaign.options import add_options

HELP = "very many random inputs for reader, judge and command line: only their own errors come out"
KINDS = {
    "made": (fuzz_made, 5000),
    "formulas": (fuzz_formulas, 5000),
    "files": (fuzz_files, 100),
    "tables": (fuzz_tables, 100),
    "judged": (fuzz_judged, 20),
    "commands": (fuzz_commands, 100),
}
"""Function and inputs of one chunk."""
SHOWN = 200


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument(
        "--inputs",
        type=int,
        default=1_000_000,
        help="formulas, half of them made, half of the repository's broken",
    )
    parser.add_argument(
        "--files", type=int, default=20_000, help="claim files, as many with broken tables"
    )
    parser.add_argument("--judged", type=int, default=1000, help="claim files that are judged")
    parser.add_argument("--commands", type=int, default=20_000, help="command lines with files")
    add_options(parser)
    options = parser.parse_args()
    half = options.inputs // 2
    wanted = {
        "made": half,
        "formulas": options.inputs - half,
        "files": options.files,
        "tables": options.files,
        "judged": options.judged,
        "commands": options.commands,
    }
    code = digest()
    blocks = [
        (kind, seed, code)
        for kind, number in wanted.items()
        for seed in range(-(-number // KINDS[kind][1]))
    ]
    return carry_out(Campaign("fuzz_reader", chunk, blocks, report), options)


def chunk(kind: str, seed: int, _code: str) -> dict[str, Any]:
    """What came of the inputs of one chunk."""
    function, count = KINDS[kind]
    return asdict(function(seed, count))


def report(done: Sequence[Done]) -> Report:
    """What came of the inputs of each kind."""
    tallies = {
        kind: reduce(
            Tally.joined, (Tally(**each.result) for each in done if each.arguments[0] == kind)
        )
        for kind in dict.fromkeys(each.arguments[0] for each in done)
    }
    text = "\n".join(shown(kind, tally) for kind, tally in tallies.items())
    return Report(text, not any(tally.crashes for tally in tallies.values()))


def shown(kind: str, tally: Tally) -> str:
    """What came of the inputs of one kind."""
    lines = [
        f"{kind}: {tally.inputs} inputs, {tally.read} read, crashes {len(tally.crashes)}",
        f"  worst time of one: {tally.seconds * 1000:.0f} ms: {tally.slowest[:SHOWN]!r}",
        f"  worst growth of memory: {tally.kilobytes} kB: {tally.largest[:SHOWN]!r}",
        *(f"  CRASH {what}: {text[:SHOWN]!r}" for text, what in tally.crashes[:20]),
    ]
    return "\n".join(lines)


def digest() -> str:
    """A digest of the code and of the claim files that inputs are made of."""
    judge = Path(gainproof.verify.judge.__file__).parent
    front = Path(gainproof.__file__).parent
    code = (path for folder in (judge, front) for path in folder.rglob("*.py"))
    return files_digest((*sorted({*code}), *sorted(CLAIMS.rglob("*.toml"))))


if __name__ == "__main__":
    sys.exit(main())
