"""Statements on matrices of every size: how many, how long the checker takes, what it rejects.

    python tests/campaigns/matrix_statements.py [--sample N] [--seed N] [--only TEXT]

For each certificate that has some: the statements proved for every size, by setting; seconds of the
processor for the whole certificate; and corrupted certificates. Every hypothesis of every statement
is left out, one at a time; every order is turned round, every equation doubled on one side; and of
all ways to alter one number or delete one field of the certificate a sample is tried (0: all, which
takes an hour). Status 1 where one was accepted.
"""

from __future__ import annotations

import argparse
import json
import random
import sys
import time
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from altered_statements import altered_claims

from gainproof.files import places
from gainproof.verify.certificate import check
from gainproof.verify.certificate.alteration_campaign import Campaign
from gainproof.verify.certificate.document import read_document, read_statement
from gainproof.verify.certificate.plain_data import plain
from gainproof.verify.certificate.rejection import MalformedError, Meter, RejectedError

HELP = "statements on matrices of every size: number, seconds, corrupted certificates rejected"
Data = dict[str, Any]


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--sample", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", default="", help="text that a certificate's name must contain")
    options = parser.parse_args()
    accepted = 0
    for path in places.certificates():
        certificate: Data = json.loads(path.read_text(encoding="utf-8"))
        if options.only in path.name and any(map(is_matrix, certificate["statements"])):
            accepted += report(path.name, certificate, options.sample, options.seed)
    return 1 if accepted else 0


def is_matrix(statement: Mapping[str, Any]) -> bool:
    """Whether it is on matrices of sizes without values."""
    return str(statement["kind"]).startswith("matrix_")


def report(name: str, certificate: Data, sample: int, seed: int) -> int:
    """Write what there is and what came of it; how many corrupted certificates were accepted."""
    start = time.process_time()
    found = check(certificate)
    seconds = time.process_time() - start
    kinds = {entry["id"]: entry for entry in certificate["statements"] if is_matrix(entry)}
    proved = Counter(
        kinds[result.id]["tower"]
        for result in found.statements
        if result.id in kinds and result.status == "proved"
    )
    by_setting = ", ".join(f"{place} {count}" for place, count in proved.items())
    sys.stdout.write(
        f"{name}: {proved.total()} statements proved for every size ({by_setting}), "
        f"{len(kinds) - proved.total()} not; the checker takes {seconds:.2f} s\n"
    )
    wrong = claims(certificate)
    sys.stdout.write(
        f"  claims altered: {wrong['rejected']} rejected, {wrong['accepted']} accepted\n"
    )
    campaign = Campaign(certificate)
    chosen = campaign.alterations()
    if sample:
        chosen = random.Random(seed).sample(chosen, min(sample, len(chosen)))
    tally = campaign.run(chosen)
    sys.stdout.write(
        f"  numbers and fields altered, {tally.total}: {tally.malformed} break the format, "
        f"{tally.refuted} refuted, {tally.unexpected} true of something else, accepted "
        f"{len(tally.accepted)}\n"
    )
    return wrong["accepted"] + len(tally.accepted) + len(kinds) - proved.total()


def claims(certificate: Data) -> Counter[str]:
    """What becomes of every statement without one of its hypotheses, and of its contrary."""
    document = read_document(plain(certificate), Meter())
    counts = Counter(rejected=0, accepted=0)
    for statement in filter(is_matrix, certificate["statements"]):
        for altered in altered_claims(statement):
            try:
                document.decide(read_statement(plain(altered), document.towers, "altered"))
            except (RejectedError, MalformedError):
                counts["rejected"] += 1
            else:
                counts["accepted"] += 1
                sys.stdout.write(f"  ACCEPTED {statement['id']}: {altered['claim']}\n")
    return counts


if __name__ == "__main__":
    sys.exit(main())
