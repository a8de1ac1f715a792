"""A file of sixty claims, drawn from those of the repository, judged with the clock running.

    python tests/campaigns/sixty_claims.py [--claims N] [--seed N] [--processes N] [--out FILE]

The claims keep their settings and symbols; ids and settings get new names, so that nothing that was
kept of the originals serves. Prints the seconds of every claim, the slowest first, and of the whole
run: reading, judging, repairs. `--out` keeps the file.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import time
import tomllib
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from random import Random
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from claim_campaign.proved import claim_paths

from gainproof.derive.catalogue import CATALOGUE
from gainproof.verify.judge.claim.file import FORMAT, read_claim_text
from gainproof.verify.judge.judge import judge_file

HELP = "a file of sixty claims, drawn from those of the repository, judged with the clock running"
WITHOUT_WORK = ("remark", "definition")
SOURCE = {"key": "drawn", "title": "claims drawn", "authors": ["various"], "publication": "here"}


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--claims", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--out", type=Path)
    options = parser.parse_args()
    text = drawn(options.claims, Random(options.seed))
    if options.out is not None:
        options.out.write_text(text, encoding="utf-8")
    every = [data for entry in CATALOGUE if (data := entry.build().model_data)]
    models = list({data["name"]: data for data in every}.values())
    start = time.monotonic()
    claim_file = read_claim_text(text)
    read = time.monotonic() - start
    verdicts = judge_file(
        claim_file, models, progress=tell, seconds=60.0, processes=options.processes
    )
    spent = time.monotonic() - start
    sys.stderr.write("\n")
    slowest = sorted(verdicts, key=lambda verdict: -verdict.seconds)
    lines = [f"{v.seconds:8.2f} s  {v.verdict:12} {v.id}" for v in slowest]
    counts = Counter(verdict.verdict for verdict in verdicts)
    lines.append(", ".join(f"{number} {verdict}" for verdict, number in counts.most_common()))
    total = f"{len(verdicts)} claims: {spent:.1f} s with {options.processes} processes"
    lines.append(f"{total}, {read:.2f} s of them reading")
    sys.stdout.write("\n".join(lines) + "\n")
    return 0


def tell(done: int, total: int) -> None:
    """How many claims are judged; more than there are when repairs are looked for."""
    sys.stderr.write(f"\r{min(done, total)}/{total} claims " + "and repairs " * (done > total))
    sys.stderr.flush()


def drawn(count: int, random: Random) -> str:
    """The text of a claim file with `count` claims of the repository."""
    everything = []
    for path in claim_paths():
        content = tomllib.loads(path.read_text(encoding="utf-8"))
        everything += [(c, content) for c in content["claims"] if c["kind"] not in WITHOUT_WORK]
    settings: dict[tuple[str, str], str] = {}
    tables, claims = [], []
    for number, (claim, content) in enumerate(random.sample(everything, count), start=1):
        key = (content["source"]["key"], claim["setting"])
        if key not in settings:
            settings[key] = f"s{len(settings) + 1}"
            tables.append(_setting(settings[key], content, claim["setting"]))
        renamed = {**claim, "id": f"{number}-{key[0]}-{claim['id']}"[:80], "setting": settings[key]}
        claims.append("[[claims]]\n" + _fields(renamed))
    head = f"format = {_value(FORMAT)}\n[source]\n{_fields(SOURCE)}"
    return "\n".join([head, *tables, *claims])


def _setting(name: str, content: Mapping[str, Any], old: str) -> str:
    """A setting with the symbols of its file among its own."""
    fields = dict(content["settings"][old])
    symbols = {**content.get("symbols", {}), **fields.pop("symbols", {})}
    return f"[settings.{name}]\n{_fields(fields)}[settings.{name}.symbols]\n{_fields(symbols)}"


def _fields(table: Mapping[str, Any]) -> str:
    return "".join(f"{_value(key)} = {_value(value)}\n" for key, value in table.items())


def _value(value: Any) -> str:
    if isinstance(value, Mapping):
        inner = ", ".join(f"{_value(key)} = {_value(entry)}" for key, entry in value.items())
        return "{ " + inner + " }"
    if isinstance(value, list):
        return "[" + ", ".join(map(_value, value)) + "]"
    return json.dumps(value)  # texts, numbers and flags are written alike in JSON and TOML


if __name__ == "__main__":
    sys.exit(main())
