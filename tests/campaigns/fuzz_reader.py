"""Very many random inputs for the reader of formulas and of claim files: nothing but their own
errors may come out.

    python tests/campaigns/fuzz_reader.py [--inputs N] [--files N] [--jobs N] [--state FILE]

Prints how many were read, the crashes, the worst time and the worst growth of memory of one input.
The state file is written after every few chunks; a campaign that was interrupted goes on from it,
and one with more inputs adds to it, as long as the reader is the same. Status 1 for a crash.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import sys
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from dataclasses import asdict
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from fuzz_tally import Tally
from reader_campaign import CLAIMS, fuzz_files, fuzz_formulas, fuzz_made
from saved_state import save

import gainproof.verify.judge

HELP = "very many random inputs for the reader: nothing but its own errors may come out"
KINDS = {"made": (fuzz_made, 5000), "formulas": (fuzz_formulas, 5000), "files": (fuzz_files, 100)}
"""Function and inputs of one chunk."""
SHOWN = 200


def chunk(kind: str, seed: int) -> tuple[str, int, Tally]:
    """One chunk in a process of a pool."""
    function, count = KINDS[kind]
    return kind, seed, function(seed, count)


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument(
        "--inputs",
        type=int,
        default=1_000_000,
        help="formulas, half of them made, half of the repository's broken",
    )
    parser.add_argument("--files", type=int, default=20_000, help="claim files")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--state", type=Path, default=Path("fuzz_reader.state.json"))
    options = parser.parse_args()
    state = load(options.state)
    half = options.inputs // 2
    wanted = {"made": half, "formulas": options.inputs - half, "files": options.files}
    todo = [
        (kind, seed)
        for kind, number in wanted.items()
        for seed in range(-(-number // KINDS[kind][1]))
        if seed not in state["done"][kind]
    ]
    start = time.monotonic()
    with ProcessPoolExecutor(options.jobs) as pool:
        for count, (kind, seed, tally) in enumerate(finished(pool, todo, options.jobs), 1):
            before = state["tally"].get(kind)
            joined = tally if before is None else Tally(**before).joined(tally)
            state["tally"][kind] = asdict(joined)
            state["done"][kind].append(seed)
            if count % 10 == 0 or count == len(todo):
                save(options.state, state)
            left = (time.monotonic() - start) / count * (len(todo) - count)
            sys.stderr.write(f"\r{count}/{len(todo)} chunks, about {left / 60:.1f} min left ")
            sys.stderr.flush()
    sys.stderr.write("\n")
    tallies = {kind: Tally(**tally) for kind, tally in state["tally"].items()}
    for kind, tally in tallies.items():
        sys.stdout.write(report(kind, tally))
    return 1 if any(tally.crashes for tally in tallies.values()) else 0


def report(kind: str, tally: Tally) -> str:
    """What came of the inputs of one kind."""
    lines = [
        f"{kind}: {tally.inputs} inputs, {tally.read} read, crashes {len(tally.crashes)}",
        f"  worst time of one: {tally.seconds * 1000:.0f} ms: {tally.slowest[:SHOWN]!r}",
        f"  worst growth of memory: {tally.kilobytes} kB: {tally.largest[:SHOWN]!r}",
        *(f"  CRASH {what}: {text[:SHOWN]!r}" for text, what in tally.crashes[:20]),
    ]
    return "\n".join(lines) + "\n"


def finished(
    pool: ProcessPoolExecutor, todo: list[tuple[str, int]], jobs: int
) -> Iterator[tuple[str, int, Tally]]:
    """Results as they come, with few chunks in hand so that an interrupt is quick."""
    for start in range(0, len(todo), 4 * jobs):
        pending = [pool.submit(chunk, *one) for one in todo[start : start + 4 * jobs]]
        for future in as_completed(pending):
            yield future.result()


def digest() -> str:
    """A digest of the judge's code and of the claim files that inputs are made of."""
    found = hashlib.sha256()
    judge = Path(gainproof.verify.judge.__file__).parent
    for file in (*sorted(judge.rglob("*.py")), *sorted(CLAIMS.rglob("*.toml"))):
        found.update(file.name.encode() + b"\0" + file.read_bytes() + b"\0")
    return found.hexdigest()


def load(path: Path) -> dict[str, Any]:
    """What was found of this very reader; nothing when it has changed since."""
    reader = digest()
    if path.exists():
        state: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        if state["reader"] == reader:
            return state
        sys.stderr.write(f"{path} is about another reader: starting anew\n")
    return {"reader": reader, "done": {kind: [] for kind in KINDS}, "tally": {}}


if __name__ == "__main__":
    sys.exit(main())
