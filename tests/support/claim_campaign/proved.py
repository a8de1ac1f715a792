"""The proved claims of claim files, each with a convention and a reading under which it is."""

from __future__ import annotations

import json
import math
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from mutation.tree import to_tree

import gainproof.verify
from claim_campaign.draw import fraction
from claim_campaign.point import NotCovered, Point
from claim_campaign.subject import Subject
from gainproof.verify.judge.claim.file import read_claim_file
from gainproof.verify.judge.claim.record import Claim, OwnModel, Setting
from gainproof.verify.judge.claim_decision import judge_claim
from gainproof.verify.judge.convention import Convention, Unusable, conventions
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.replay import replay, statements_of
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.verdict import Finding
from gainproof.verify.judge.worker import tried_apart

AGAIN = "the same verdict"
CLAIMS = Path(gainproof.verify.__file__).parent / "claims"


@dataclass(frozen=True)
class FirstProof:
    """Task: the first convention and reading under which a claim is proved, as the one finding."""

    claim: Claim
    setting: Setting
    most: float = math.inf

    def run(self, models: Models, solved: Solved) -> Trial:
        """The finding's `reading` is the number of the claim's reading."""
        for convention in usable(self.setting, models, solved):
            for number, one in enumerate(single_readings(self.claim)):
                finding = judge_claim(one, convention.setting, convention.environment)
                if finding.verdict == "proved":
                    kept = Finding("proved", "", reading=str(number))
                    return Trial(self.claim, {convention.name: kept}, (), False, 0.0)
        return Trial(self.claim, {}, (), False, 0.0)


@dataclass(frozen=True)
class UnderConvention:
    """Task: the verdict on a claim under one convention."""

    claim: Claim
    setting: Setting
    convention: str
    most: float = math.inf

    def run(self, models: Models, solved: Solved) -> Trial:
        """The one finding; of its certificate no more than what came of replaying it."""
        for convention in usable(self.setting, models, solved):
            if convention.name == self.convention:
                finding = judge_claim(self.claim, convention.setting, convention.environment)
                kept = {}
                if statements_of(finding.certificate):
                    kept["replayed"] = replay(finding.certificate, finding.verdict) or AGAIN
                bare = replace(finding, certificate=kept)
                return Trial(self.claim, {convention.name: bare}, (), False, 0.0)
        return Trial(self.claim, {}, (), False, 0.0, "no such convention")


def usable(setting: Setting, models: Models, solved: Solved) -> Iterator[Convention]:
    """The conventions of a setting whose model could be solved."""
    try:
        for convention in conventions(setting, models, solved):
            if not isinstance(convention, Unusable):
                yield convention
    except Undecided:
        return


def single_readings(claim: Claim) -> list[Claim]:
    """The claim with each of its readings alone; itself if it has no formula."""
    if claim.formula is None:
        return [claim]
    formula = claim.formula
    return [
        replace(claim, formula=replace(formula, readings=(reading,)))
        for reading in formula.readings
    ]


def claim_paths() -> list[Path]:
    """All claim files of the repository."""
    return sorted(CLAIMS.rglob("*.toml"))


def proved_before(path: Path) -> set[str]:
    """The ids of the claims that the snapshot beside a claim file has as proved; without those on
    matrices of any size, which have no values at points and are broken in tests of their own.
    """
    snapshot = json.loads(path.with_suffix(".verdicts.json").read_text(encoding="utf-8"))
    proved = {claim["id"] for claim in snapshot["claims"] if claim["verdict"] == "proved"}
    source = tomllib.loads(path.read_text(encoding="utf-8"))
    kinds = {name: setting["kind"] for name, setting in source["settings"].items()}
    return {c["id"] for c in source["claims"] if kinds[c["setting"]] != "matrices"} & proved


def names_proved_before() -> list[str]:
    """Names of subjects: key of the file, blank, id of the claim."""
    return [f"{path.stem} {one}" for path in claim_paths() for one in sorted(proved_before(path))]


def subjects(
    names: Iterable[str], models: Sequence[Mapping[str, Any]], seconds: float, processes: int
) -> list[Subject]:
    """The claims of these names that are proved."""
    wanted = set(names)
    found: list[Subject] = []
    solved: Solved = {}
    for path in claim_paths():
        if not any(name.startswith(f"{path.stem} ") for name in wanted):
            continue
        claim_file = read_claim_file(path)
        claims = [c for c in claim_file.claims if f"{path.stem} {c.id}" in wanted]
        tasks = [FirstProof(claim, claim_file.settings[claim.setting]) for claim in claims]
        trials = tried_apart(tasks, models, seconds, processes)
        for claim in claims:
            setting = claim_file.settings[claim.setting]
            for name, finding in trials[claim.id].findings.items():
                one = single_readings(claim)[int(finding.reading or 0)]
                known = {c.name: c for c in usable(setting, models, solved)}
                label = f"{path.stem} {claim.id}"
                found.append(_subject(label, one, setting, known[name], models))
    return found


def own_model(model: OwnModel) -> Mapping[str, Any] | None:
    """A source's own model as data, if all its entries are numbers."""
    try:
        return {
            one.name: [[str(_number(entry)) for entry in row] for row in getattr(model, one.name)]
            for one in fields(model)
        }
    except NotCovered:
        return None


def _number(entry: Graph) -> Fraction:
    return fraction(Point({}).value(to_tree(entry))).limit_denominator(10**9)


def _subject(
    label: str,
    claim: Claim,
    printed: Setting,
    convention: Convention,
    models: Sequence[Mapping[str, Any]],
) -> Subject:
    name = printed.model
    if name == "search":
        name = convention.environment.name.partition(", ")[0].removeprefix("process noise ")
    model = next((m for m in models if name == m["name"]), None)
    if printed.own_model is not None:
        model = own_model(printed.own_model)
    return Subject(
        label, claim, convention.setting, printed, convention.name, convention.chosen, model
    )
