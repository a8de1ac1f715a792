"""`gainproof certify`: certificates and bounds put before other tools."""

from __future__ import annotations

import argparse

from gainproof.claims import time_limit

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
    from gainproof.certify import table, tools
    from gainproof.certify.carrying_out import carry_out
    from gainproof.certify.outcome import Outcome
    from gainproof.certify.subjects import chosen

    require_jobs(options.jobs)
    subjects = list(chosen(options.subjects))
    present, absent = tools.chosen(options.tool or ())
    for line in absent:
        print(line)
    print(table.head())

    def say(outcome: Outcome) -> None:
        if outcome.statements:
            print(table.row(outcome), flush=True)
            for line in table.notes(outcome):
                print(line, flush=True)

    path = Path(options.state) if options.state else None
    outcomes = carry_out(subjects, present, options.seconds, options.jobs, path, say)
    for line in table.foot(outcomes):
        print(line)
    return int(any(outcome.rejected for outcome in outcomes))
