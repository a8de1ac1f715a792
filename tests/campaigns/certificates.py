"""Every printed certificate altered in all ways, and offered for something else: always rejected.

    python tests/campaigns/certificates.py [--only TEXT] [--sample N] [--seed N]
                                           [--executor WHERE] [--state FILE]

Every number of every certificate of generated/ is altered and every field deleted, one at a time
(`gainproof.verify.certificate.alterations` says how). Each certificate is offered for every other
subject, as a whole and with one part alone expected: its model, claims or programs. And the domain
of each parameter is made smaller, which may leave everything true. What is expected comes from a
derivation made afresh. All of this takes most of a day; with --sample only some of each 500
alterations are tried, drawn with the seed, in an order drawn with it too. A campaign that was
interrupted goes on as long as checker and certificates are the same. Status 1 where one was
accepted.
"""

from __future__ import annotations

import argparse
import json
import random
import sys
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from copy import deepcopy
from functools import cache, partial
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "support"))

from files_digest import files_digest

import gainproof.verify.certificate
from gainproof.campaign.campaign import Campaign, Done, Report
from gainproof.campaign.carrying_out import carry_out
from gainproof.campaign.options import add_options
from gainproof.files import places
from gainproof.subjects.deriving import build, plain_subject
from gainproof.subjects.rechecking import expected_of, recheck
from gainproof.verify.certificate import check
from gainproof.verify.certificate.alteration_campaign import Campaign as Altered
from gainproof.verify.certificate.alterations import alterations
from gainproof.verify.certificate.plain_data import plain

HELP = "every printed certificate altered in all ways, and offered for something else"
CERTIFICATES = places.certificates()
CHUNK = 500
OUTCOMES = ("malformed", "refuted", "unexpected")
PARTS = ("model", "claims", "programs")
Data = dict[str, Any]


def main() -> int:
    parser = argparse.ArgumentParser(description=HELP)
    parser.add_argument("--only", default="", help="text that a certificate's name must contain")
    parser.add_argument("--sample", type=int, default=CHUNK, help=f"of each {CHUNK} alterations")
    parser.add_argument("--seed", type=int, default=1)
    add_options(parser)
    options = parser.parse_args()
    files = {path.name: path for path in CERTIFICATES if options.only in path.name}
    counts = {name: sum(1 for _ in alterations(plain(read(p)))) for name, p in files.items()}
    code = digest()
    blocks = [
        (name, first, options.sample, options.seed, code)
        for name, count in counts.items()
        for first in range(0, count, CHUNK)
    ]
    if options.sample < CHUNK:
        random.Random(options.seed).shuffle(blocks)
    campaign = Campaign("certificates", chunk, blocks, partial(report, counts))
    status = carry_out(campaign, options)
    return 1 if offered(list(files.values())) else status


def read(path: Path) -> Data:
    certificate: Data = json.loads(path.read_text(encoding="utf-8"))
    return certificate


def chunk(name: str, first: int, sample: int, seed: int, _code: str) -> Data:
    """A chunk of the alterations of one certificate: how many came to what, those accepted."""
    (path,) = (path for path in CERTIFICATES if path.name == name)
    altered = _altered(path)
    chosen = altered.alterations()[first : first + CHUNK]
    if sample < len(chosen):
        chosen = random.Random(f"{seed} {name} {first}").sample(chosen, sample)
    tally = altered.run(chosen)
    return {
        "chosen": len(chosen),
        "deleted": sum(alteration.how == "deleted" for alteration in chosen),
        "malformed": tally.malformed,
        "refuted": tally.refuted,
        "unexpected": tally.unexpected,
        "accepted": [str(alteration) for alteration in tally.accepted],
    }


@cache
def _altered(path: Path) -> Altered:
    """Its certificate is checked once by each process."""
    return Altered(read(path))


def report(counts: Mapping[str, int], done: Sequence[Done]) -> Report:
    """What came of each certificate; an alteration that was accepted is wrong."""
    lines, total, accepted = [], 0, 0
    for name, count in counts.items():
        tallies = [each.result for each in done if each.arguments[0] == name]
        number, deleted, malformed, refuted, unexpected = (
            sum(tally[word] for tally in tallies) for word in ("chosen", "deleted", *OUTCOMES)
        )
        wrong = [text for tally in tallies for text in tally["accepted"]]
        if malformed + refuted + unexpected + len(wrong) != number:
            raise ValueError(f"{name}: not every alteration was decided")
        lines.append(
            f"{name}: {number} of {count} alterations ({deleted} fields deleted, "
            f"{number - deleted} numbers): {malformed} break the format, {refuted} refuted, "
            f"{unexpected} true of something else, accepted {len(wrong)}"
        )
        lines += [f"  ACCEPTED {text}" for text in wrong]
        total, accepted = total + number, accepted + len(wrong)
    lines.append(f"tried: {total} of {sum(counts.values())} alterations, accepted {accepted}")
    return Report("\n".join(lines), not accepted)


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
    checker = Path(gainproof.verify.certificate.__file__).parent
    return files_digest((*sorted(checker.rglob("*.py")), *CERTIFICATES))


if __name__ == "__main__":
    sys.exit(main())
