"""Every printed certificate altered in all ways, and offered for something else: always rejected.

    python tests/campaigns/certificates.py [--jobs N] [--state FILE] [--only TEXT] [--sample N]

Every number of every certificate of generated/ is altered and every field deleted, one at a time
(`gainproof.verify.certificate.altered` says how). Each certificate is offered for every other
subject, as a whole and with one part alone expected: its model, claims or programs. And the domain
of each parameter is made smaller, which may leave everything true. What is expected comes from a
derivation made afresh. All of this takes most of a day; with --sample only some of each 500
alterations are tried, drawn with the seed, in an order drawn with it too. The state file is written
after every chunk; a campaign that was interrupted goes on from it as long as checker and
certificates are the same. Status 1 where one was accepted.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import random
import sys
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor, as_completed
from copy import deepcopy
from functools import cache
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from saved_state import save

import gainproof.generated
import gainproof.verify.certificate
from gainproof.deriving import build, plain_subject
from gainproof.rechecking import expected_of, recheck
from gainproof.verify.certificate import check
from gainproof.verify.certificate.alteration import Campaign
from gainproof.verify.certificate.altered import alterations
from gainproof.verify.certificate.plain import plain

HELP = "every printed certificate altered in all ways, and offered for something else"
CERTIFICATES = sorted(Path(gainproof.generated.__file__).parent.glob("*.json"))
CHUNK = 500
OUTCOMES = ("malformed", "refuted", "unexpected")
PARTS = ("model", "claims", "programs")
Data = dict[str, Any]


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--state", type=Path, default=Path("certificates.state.json"))
    parser.add_argument("--only", default="", help="text that a certificate's name must contain")
    parser.add_argument("--sample", type=int, default=CHUNK, help=f"of each {CHUNK} alterations")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    state = load(options.state, f"{digest()} {options.sample} {options.seed}")
    files = [path for path in CERTIFICATES if options.only in path.name]
    counts = {path.name: sum(1 for _ in alterations(plain(read(path)))) for path in files}
    todo = [
        (path, first)
        for path in files
        for first in places(counts[path.name])
        if f"{path.name} {first}" not in state
    ]
    if options.sample < CHUNK:
        random.Random(options.seed).shuffle(todo)
    start = time.monotonic()
    with ProcessPoolExecutor(options.jobs) as pool:
        tasks = [
            pool.submit(chunk, path, first, options.sample, options.seed) for path, first in todo
        ]
        for done, task in enumerate(as_completed(tasks), 1):
            key, tally = task.result()
            state[key] = tally
            save(options.state, state)
            left = (time.monotonic() - start) / done * (len(todo) - done)
            sys.stderr.write(f"\r{done}/{len(todo)} chunks, about {left / 60:.1f} min left ")
            sys.stderr.flush()
    sys.stderr.write("\n")
    sums = [report(name, count, state) for name, count in counts.items()]
    listed = (state[f"{name} {first}"] for name in counts for first in places(counts[name]))
    total = sum(map(tried, listed))
    sys.stdout.write(
        f"tried: {total} of {sum(counts.values())} alterations, accepted {sum(sums)}\n"
    )
    return 1 if sum(sums) + offered(files) else 0


def read(path: Path) -> Data:
    certificate: Data = json.loads(path.read_text(encoding="utf-8"))
    return certificate


def chunk(path: Path, first: int, sample: int, seed: int) -> tuple[str, Data]:
    """A chunk of the alterations of one certificate: how many came to what, those accepted."""
    campaign = _campaign(path)
    chosen = campaign.alterations()[first : first + CHUNK]
    if sample < len(chosen):
        chosen = random.Random(f"{seed} {path.name} {first}").sample(chosen, sample)
    tally = campaign.run(chosen)
    counted = {
        "chosen": len(chosen),
        "deleted": sum(alteration.how == "deleted" for alteration in chosen),
        "malformed": tally.malformed,
        "refuted": tally.refuted,
        "unexpected": tally.unexpected,
        "accepted": [str(alteration) for alteration in tally.accepted],
    }
    return f"{path.name} {first}", counted


@cache
def _campaign(path: Path) -> Campaign:
    """Its certificate is checked once by each process."""
    return Campaign(read(path))


def places(count: int) -> range:
    """The first alteration of each chunk."""
    return range(0, count, CHUNK)


def tried(tally: Data) -> int:
    """How many alterations of a chunk were decided."""
    outcomes: int = sum(tally[word] for word in OUTCOMES)
    return outcomes + len(tally["accepted"])


def report(name: str, count: int, state: Mapping[str, Data]) -> int:
    """Write what came of one certificate; how many alterations were accepted."""
    tallies = [state[f"{name} {first}"] for first in places(count)]
    number, deleted, malformed, refuted, unexpected = (
        sum(tally[word] for tally in tallies) for word in ("chosen", "deleted", *OUTCOMES)
    )
    accepted = [text for tally in tallies for text in tally["accepted"]]
    if sum(map(tried, tallies)) != number:
        raise ValueError(f"{name}: not every alteration was decided")
    sys.stdout.write(
        f"{name}: {number} of {count} alterations ({deleted} fields deleted, "
        f"{number - deleted} numbers): "
        f"{malformed} break the format, {refuted} refuted, {unexpected} true of something else, "
        f"accepted {len(accepted)}\n"
    )
    sys.stdout.writelines(f"  ACCEPTED {text}\n" for text in accepted)
    return len(accepted)


def offered(files: list[Path]) -> int:
    """Offer each certificate for other subjects and on smaller domains; how many were accepted."""
    certificates = {data["subject"]: data for data in map(read, files)}
    expected = {name: expected_of(plain_subject(build(name))) for name in certificates}
    wrong, found = [], Counter[str]()
    for name, certificate in certificates.items():
        if not recheck(certificate, expected[name])["accepted"]:
            raise ValueError(f"{name}: not accepted as it stands")
        for what, words, accepted in (
            *_as_others(name, certificate, expected),
            *_on_smaller_domains(certificate, expected[name]),
        ):
            found[what] += 1
            if accepted:
                wrong.append(f"{name} {words}")
    sys.stdout.writelines(f"{what}: {number}\n" for what, number in found.items())
    sys.stdout.write(f"accepted of all these: {len(wrong)}\n")
    sys.stdout.writelines(f"  ACCEPTED {text}\n" for text in wrong)
    return len(wrong)


def _as_others(
    name: str, certificate: Data, expected: Mapping[str, Data]
) -> Iterator[tuple[str, str, bool]]:
    """What is tried, in words, and whether it was accepted: another subject's, whole or a part."""
    for other, wanted in ((o, w) for o, w in expected.items() if o != name):
        accepted = recheck(certificate, wanted)["accepted"]
        yield "offered for another subject", f"as {other}", accepted
        for part in PARTS:
            if wanted[part] is not None:
                accepted = check(certificate, **{part: wanted[part]}).accepted
                yield "one part of another expected", f"with the {part} of {other}", accepted


def _on_smaller_domains(
    certificate: Data, wanted: Mapping[str, Any]
) -> Iterator[tuple[str, str, bool]]:
    """The same for each domain made smaller, by the domain alone and by all that is expected."""
    for words, weaker in weakened(certificate):
        true = "left true" if check(weaker).accepted else "not left true"
        accepted = check(weaker, domain=wanted["domain"]).accepted
        yield f"domain made smaller, {true}", words, accepted or recheck(weaker, wanted)["accepted"]


def weakened(certificate: Data) -> Iterator[tuple[str, Data]]:
    """The certificate with the domain of one parameter made smaller in several ways."""
    for tower, entry in certificate["towers"].items():
        for number, parameter in enumerate(entry["parameters"]):
            for end, bound in _smaller_ends(parameter):
                smaller = {"symbol": parameter["symbol"], end: bound}
                weaker = deepcopy(certificate)
                weaker["towers"][tower]["parameters"][number] = smaller
                yield f"{tower}, {smaller}", weaker


def _smaller_ends(parameter: Mapping[str, str]) -> list[tuple[str, str]]:
    """Lower ends within a parameter's domain."""
    if "any" in parameter:
        return [("above", "0")]
    bound = int(parameter["from" if "from" in parameter else "above"])
    above = [f"{bound * 10**6 + 1}/{10**6}", bound + 1] if "above" in parameter else [bound]
    return [*(("above", str(value)) for value in above), ("from", str(bound + 1))]


def digest() -> str:
    """A digest of the checker's code and of the certificates."""
    found = hashlib.sha256()
    checker = Path(gainproof.verify.certificate.__file__).parent
    for file in (*sorted(checker.rglob("*.py")), *CERTIFICATES):
        found.update(file.name.encode() + b"\0" + file.read_bytes() + b"\0")
    return found.hexdigest()


def load(path: Path, key: str) -> dict[str, Any]:
    """What was found by this very checker of these certificates; nothing where one changed."""
    if path.exists():
        state: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
        if state["key"] == key:
            return state
        sys.stderr.write(f"{path} is about another checker or certificates: starting anew\n")
    return {"key": key}


if __name__ == "__main__":
    sys.exit(main())
