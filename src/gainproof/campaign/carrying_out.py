"""A campaign as a command carries it out: what is not done yet is done and kept, then reported."""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.campaign import executors, state
from gainproof.campaign.campaign import Campaign, Done
from gainproof.campaign.options import require_jobs
from gainproof.campaign.running import run
from gainproof.jobs.progress import Progress


def carry_out(campaign: Campaign, options: argparse.Namespace) -> int:
    """Run what is not done, print the report; 0, or 1 where it is not as it should be.

    Raises BadInputError for options that do not fit, and a state file that cannot be used.
    """
    require_jobs(options.jobs)
    if not campaign.blocks:
        raise BadInputError(f"{campaign.name}: nothing is chosen")
    wanted = _numbers(options.blocks, len(campaign.blocks))
    path = Path(options.state or f"{campaign.name}.state.jsonl")
    done = _all_done(campaign, wanted, path, options)
    ordered = [done[number] for number in sorted(done)]
    report = campaign.report(ordered)
    hours = sum(each.seconds for each in ordered) / 3600
    print(report.text)
    print(
        f"{campaign.name}: {len(done)} of {len(campaign.blocks)} blocks done, "
        f"{hours:.2f} hours of a processor"
    )
    return 0 if report.passed else 1


def _all_done(
    campaign: Campaign, wanted: range, path: Path, options: argparse.Namespace
) -> dict[int, Done]:
    """All blocks that were done and those that now are, by number."""
    done = state.read(path, campaign)
    todo = [number for number in wanted if number not in done]
    progress = Progress()
    progress.say(f"{campaign.name}: {len(todo)} blocks to do, {len(done)} done")
    if not todo:
        return done
    before = len(done)
    with (
        state.appended(path, campaign) as keep,
        executors.opened(options.executor, options.jobs) as executor,
    ):

        def note(number: int, each: Done) -> None:
            keep(each)
            done[number] = each
            count = len(done) - before
            left = progress.elapsed() / count * (len(todo) - count)
            words = f"{count} of {len(todo)} blocks, about {_time(left)} left"
            (progress.say_sometimes if count < len(todo) else progress.say)(words)

        run(campaign, executor, todo, note)
    return done


def _numbers(given: str | None, count: int) -> range:
    if given is None:
        return range(count)
    match = re.fullmatch(r"(\d+)(?:-(\d+))?", given)
    first, last = (int(match[1]), int(match[2] or match[1])) if match else (1, 0)
    if not first <= last < count:
        raise BadInputError(f"--blocks is A-B or A, from 0 to {count - 1}, got {given!r}")
    return range(first, last + 1)


def _time(seconds: float) -> str:
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"
