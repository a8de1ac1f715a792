"""Portions of subjects and tools carried out, in processes if it is wanted, and kept in a file."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Any

from gainproof.campaign import executors, state
from gainproof.campaign.campaign import Arguments, Campaign, Done, Report
from gainproof.campaign.running import run
from gainproof.certify.outcome import Outcome
from gainproof.certify.portions import certified, joined, outcome, portions
from gainproof.certify.subjects import Subject
from gainproof.certify.tools import Tool

Say = Callable[[Outcome], None]


def carry_out(
    subjects: Sequence[Subject],
    tools: Sequence[Tool],
    seconds: float,
    jobs: int,
    path: Path | None,
    say: Say,
) -> list[Outcome]:
    """What each tool says of each subject, in this order; `say` is told each as soon as all before
    it are there.

    What is finished is kept in the file at `path` and taken from it; what ran out of time is asked
    again. Raises BadInputError for a file that cannot be used.
    """
    pairs = [(subject, tool) for subject in subjects for tool in tools]
    parts = [list(portions(subject, tool)) for subject, tool in pairs]
    blocks = [portion for each in parts for portion in each]
    campaign = Campaign("certify", partial(certified, seconds), blocks, _no_report, _fault)
    done = state.read(path, campaign) if path else {}
    todo = [number for number in range(len(blocks)) if number not in done]
    results: list[Outcome] = []
    with _kept(path, campaign) as keep:

        def note(number: int, each: Done) -> None:
            done[number] = each
            if not each.result["unfinished"]:
                keep(each)
            tell()

        def tell() -> None:
            """All pairs that are whole, up to the first that is not."""
            while len(results) < len(parts):
                start = sum(map(len, parts[: len(results)]))
                wanted = range(start, start + len(parts[len(results)]))
                if any(number not in done for number in wanted):
                    return
                found = [outcome(done[number].result) for number in wanted]
                subject, tool = pairs[len(results)]
                results.append(
                    joined(found) if found else Outcome(subject.name, tool.name, 0, 0, 0.0)
                )
                say(results[-1])

        tell()
        if jobs == 1:
            for number in todo:
                note(number, Done(blocks[number], campaign.work(*blocks[number]), 0.0))
        elif todo:
            with executors.opened("processes", jobs) as executor:
                run(campaign, executor, todo, note)
    return results


@contextmanager
def _kept(path: Path | None, campaign: Campaign) -> Iterator[state.Keep]:
    if path is None:
        yield _forget
    else:
        with state.appended(path, campaign) as keep:
            yield keep


def _forget(_done: Done) -> None:
    """Nothing is kept without a file."""


def _no_report(_done: Sequence[Done]) -> Report:
    """The table is printed as outcomes come."""
    return Report("", True)


def _fault(_arguments: Arguments, result: Any) -> str | None:
    if not isinstance(result, Mapping) or result.keys() != Outcome.__dataclass_fields__.keys():
        return f"what a tool said is wanted, got {str(result)[:80]}"
    counts = [result["statements"], result["accepted"], result["seconds"]]
    if not all(isinstance(each, int | float) and each >= 0 for each in counts):
        return f"statements, accepted and seconds must be numbers from 0, got {counts}"
    return "an answer that is whole is wanted" if result["unfinished"] else None
