"""Claims broken and rewritten, judged in child processes; what came of it, and the score."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from random import Random
from typing import Any

from claim_campaign.broken import mutants
from claim_campaign.falsehood import is_false
from claim_campaign.point import NotCovered
from claim_campaign.proved import AGAIN, UnderConvention
from claim_campaign.rewritten import rewrites
from claim_campaign.subject import Subject
from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.convention_choice import choose
from gainproof.verify.judge.task import Task, TrialTask
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.worker import tried_apart

REFUSED = ("refuted", "conditional", "undefined")
Record = dict[str, Any]
"""Of one claim: `mutants` and `rewrites` as lists of records, `left out` counted by reason, `doubt`
if the evaluator finds the claim itself false.
"""


def run(
    subjects: Sequence[Subject],
    models: Sequence[Mapping[str, Any]],
    count: int,
    seed: int,
    seconds: float,
    processes: int,
) -> dict[str, Record]:
    """Breaks each claim in `count` ways that are false by the evaluator, rewrites it, and judges
    all that; by the subject's name.
    """
    records: dict[str, Record] = {}
    tasks: list[Task] = []
    places: dict[str, tuple[str, str, Record]] = {}

    def ask(subject: Subject, what: str, entry: Record, task: Task) -> None:
        places[task.claim.id] = (subject.name, what, entry)
        tasks.append(task)

    for subject in subjects:
        doubt = _is_doubted(subject, seed)
        blank = {"mutants": [], "rewrites": [], "left out": Counter(), "doubt": doubt}
        records[subject.name] = blank
        for entry, claim in _false(subject, count, seed, records[subject.name]["left out"]):
            one = _with_id(claim, len(tasks))
            task = UnderConvention(one, subject.printed, subject.convention)
            ask(subject, "mutants", entry, task)
        for name, claim, setting in rewrites(subject):
            ask(
                subject, "rewrites", {"name": name}, TrialTask(_with_id(claim, len(tasks)), setting)
            )
    for identifier, trial in tried_apart(tasks, models, seconds, processes).items():
        name, what, entry = places[identifier]
        records[name][what].append(entry | _said(trial, what))
    return records


def _is_doubted(subject: Subject, seed: int) -> bool:
    try:
        return is_false(subject, Random(f"{seed} {subject.name}")) is True
    except NotCovered:
        return False


def _with_id(claim: Claim, number: int) -> Claim:
    return replace(claim, id=str(number))


def _false(
    subject: Subject, count: int, seed: int, left_out: Counter[str]
) -> Iterator[tuple[Record, Claim]]:
    random = Random(f"{seed} {subject.name}")
    found = 0
    for mutant in mutants(subject, count, random):
        try:
            false = is_false(mutant.subject, random)
        except NotCovered as reason:
            left_out[f"not covered: {reason}"] += 1
            continue
        if not false:
            left_out["no point to compare" if false is None else "still true"] += 1
            continue
        yield {"name": mutant.words, "near": mutant.near}, mutant.claim
        found += 1
        if found == count:
            return


def _said(trial: Trial, what: str) -> Record:
    if what == "rewrites":
        (verdict,) = choose([trial])
        return {"verdict": verdict.verdict, "reason": verdict.reason}
    if not trial.findings:
        return {"verdict": "undecided", "reason": trial.failure or "", "units": False}
    (finding,) = trial.findings.values()
    by_units = finding.method == "dimensions"
    again = finding.certificate.get("replayed")
    said = {"verdict": finding.verdict, "reason": finding.reason, "units": by_units}
    return said if again is None else said | {"replayed": again}


def report(records: Mapping[str, Record]) -> str:
    """The score, every false accept and every rewriting that is not proved by name."""
    broken = [(name, m) for name, record in records.items() for m in record["mutants"]]
    other = [(name, r) for name, record in records.items() for r in record["rewrites"]]
    refused = [m for _, m in broken if m["verdict"] in REFUSED]
    accepted = [(name, m) for name, m in broken if m["verdict"] == "proved"]
    open_ones = [(name, m) for name, m in broken if m["verdict"] not in (*REFUSED, "proved")]
    again = [(name, m) for name, m in broken if "replayed" in m]
    elsewhere = [(name, m) for name, m in again if m["replayed"] != AGAIN]
    proved = [r for _, r in other if r["verdict"] == "proved"]
    left_out: Counter[str] = Counter()
    for record in records.values():
        left_out.update(record["left out"])
    near = sum(m["near"] for _, m in broken)
    units = sum(m["units"] for m in refused)
    doubted = [name for name, record in records.items() if record["doubt"]]
    none = [name for name, record in records.items() if not record["mutants"]]
    lines = [
        f"claims: {len(records)}",
        f"claims that the evaluator finds false: {len(doubted)}",
        f"false mutants: {len(broken)}, of them near misses {near}",
        f"refused: {len(refused)}, of them {units} by their units alone",
        f"false accepts: {len(accepted)}",
        f"neither: {len(open_ones)}",
        f"replayed from their certificates: {len(again)}, to another verdict {len(elsewhere)}",
        f"rewritten: {len(other)}, still proved {len(proved)}",
        *(f"left out, {reason}: {number}" for reason, number in sorted(left_out.items())),
        *(f"no mutant of {name}" for name in none),
    ]
    lines += [f"  FALSE {name}" for name in doubted]
    lines += [f"  ACCEPTED {name}: {m['name']}" for name, m in accepted]
    lines += [f"  REPLAYED {name}: {m['name']}: {m['replayed']}" for name, m in elsewhere]
    lines += [f"  {m['verdict']} {name}: {m['name']}: {m['reason'][:120]}" for name, m in open_ones]
    lines += [
        f"  rewritten, {r['verdict']} {name}: {r['name']}: {r['reason'][:160]}"
        for name, r in other
        if r["verdict"] != "proved"
    ]
    return "\n".join(lines)


def accepted(records: Mapping[str, Record]) -> int:
    """How many false mutants were proved, verdicts came out otherwise when replayed, and claims are
    false.
    """
    broken = [m for record in records.values() for m in record["mutants"]]
    wrong: int = sum(m["verdict"] == "proved" for m in broken)
    wrong += sum(m.get("replayed", AGAIN) != AGAIN for m in broken)
    return wrong + sum(bool(record["doubt"]) for record in records.values())
