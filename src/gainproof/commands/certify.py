"""`gainproof certify`: certificates and bounds put before other tools."""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from gainproof.claims import time_limit

if TYPE_CHECKING:
    from gainproof.certify.outcome import Outcome

HELP = "put certificates and error bounds before Coq, Gappa, Singular and python-flint"
DESCRIPTION = """\
Hands the shipped certificates and the printed error bounds to tools that share no code with
gainproof, and prints what they accept: Coq (coqc) and Singular, python-flint for the statements,
Gappa for the bounds. What each checks, what it takes for granted and what is not handed over stands
in docs/certify.md. Tools that are not installed are named and left out.

--jobs shares subjects out to processes, for Coq statements, for Gappa outputs. With --state what a
tool has answered is kept, a line each, and the same command goes on after an interrupt, or with
more --seconds: what ran out of time is asked again, and all that rests on other code, certificates
or tools.

Exit status 0: nothing is rejected; 1: a tool rejects something; 2: bad input, or a tool that is
asked for by --tool is not installed."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("subjects", metavar="NAME", nargs="*", help="default: every subject")
    parser.add_argument(
        "--tool", choices=("coq", "gappa", "singular", "flint"), action="append", help="only this"
    )
    parser.add_argument(
        "--seconds",
        type=time_limit.seconds_of,
        default=600.0,
        metavar="S",
        help="of a tool and subject; of Coq and six statements, of Gappa and an output; 600",
    )
    parser.add_argument(
        "--jobs", type=int, default=1, metavar="N", help="processes; 1 without this"
    )
    parser.add_argument(
        "--state", metavar="FILE", help="answers are kept there, and not asked for again"
    )


def run(options: argparse.Namespace) -> int:
    """0, or 1 where a tool rejects something."""
    from pathlib import Path

    from gainproof.campaign.options import require_jobs
    from gainproof.certify import tools
    from gainproof.certify.carrying_out import carry_out
    from gainproof.certify.subjects import chosen

    require_jobs(options.jobs)
    subjects = list(chosen(options.subjects))
    present, absent = tools.chosen(options.tool or ())
    for line in absent:
        print(line)
    print(f"{'subject':<40}{'tool':<9}{'statements':>10}{'accepted':>10}{'seconds':>9}")

    def say(outcome: Outcome) -> None:
        if outcome.statements:
            print(_row(outcome), flush=True)
            for line in _notes(outcome):
                print(line, flush=True)

    path = Path(options.state) if options.state else None
    outcomes = carry_out(subjects, present, options.seconds, options.jobs, path, say)
    for line in _foot(outcomes):
        print(line)
    return int(any(outcome.rejected for outcome in outcomes))


def _row(outcome: Outcome) -> str:
    """A line of the table, with what was not accepted."""
    cells = (
        f"{outcome.subject:<40}{outcome.tool:<9}{outcome.statements:>10}"
        f"{outcome.accepted:>10}{outcome.seconds:>9.1f}"
    )
    said = f"  rejected: {outcome.rejected}" if outcome.rejected else ""
    return cells + ("  not finished in time" if outcome.unfinished else said)


def _notes(outcome: Outcome) -> Iterator[str]:
    """What the tool found that is neither accepted nor rejected."""
    for note in outcome.notes:
        yield f"    {note}"


def _foot(outcomes: Sequence[Outcome]) -> Iterator[str]:
    """Sums by tool, and what was not handed over."""
    for tool in dict.fromkeys(outcome.tool for outcome in outcomes):
        own = [outcome for outcome in outcomes if outcome.tool == tool]
        accepted, seconds = sum(o.accepted for o in own), sum(o.seconds for o in own)
        yield (
            f"{tool}: {accepted} of {sum(o.statements for o in own)} statements accepted, "
            f"{sum(bool(o.rejected) for o in own)} subjects rejected, {seconds:.0f} s"
        )
        left_out: Counter[str] = Counter()
        for outcome in own:
            left_out.update(outcome.left_out)
        if left_out:
            parts = ", ".join(f"{count} {reason}" for reason, count in left_out.most_common())
            yield f"  not handed over: {parts}"
