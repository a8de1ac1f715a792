"""What the judge says of equations whose parts were multiplied by a symbol with a unit."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from random import Random
from typing import Any

from claim_campaign.units import METRE, SECOND, equations, is_mixed, is_slow, mixed, true_point
from gainproof.verify.judge.dimensions.claim import claim_readings

SEEN = "mixed and seen by the judge"
LEFT = "left out"


def mixed_units(
    path: Path, models: Sequence[Mapping[str, Any]], only: str = ""
) -> tuple[Counter[str], list[str]]:
    """Counts of one claim file, and what is wrong: mixed formulas that pass, sound ones that do
    not.
    """
    counts: Counter[str] = Counter()
    wrong: list[str] = []
    for subject in equations(path, models):
        if only not in subject.name:
            continue
        point = None if is_slow(subject) else true_point(subject, Random(subject.name))
        if point is None:
            counts[f"{LEFT}: claims"] += 1
            continue
        counts["claims"] += 1
        fault = claim_readings(subject.claim, subject.setting)[1]
        said = is_mixed(subject, point, SECOND)
        if said is not None and said != (fault is not None):
            wrong.append(f"{subject.name} as printed: {fault or 'passes'}")
        for unit in (SECOND, METRE):
            for one in mixed(subject, unit):
                changed = replace(subject, claim=one.claim, setting=one.setting)
                if not is_mixed(changed, point, unit):
                    counts[f"{LEFT}: parts"] += 1
                elif claim_readings(one.claim, one.setting)[1] is not None:
                    counts[SEEN] += 1
                else:
                    wrong.append(f"{subject.name} {one.words}: passes")
    return counts, wrong
