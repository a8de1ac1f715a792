"""`gainproof certify`: certificates and bounds put before other tools."""

from __future__ import annotations

import argparse

HELP = "put certificates and error bounds before Coq, Gappa, Singular and python-flint"
DESCRIPTION = """\
Hands the shipped certificates and the printed error bounds to tools that share no code with
gainproof, and prints what they accept: Coq (coqc) and Singular, python-flint for the statements,
Gappa for the bounds. What each checks, what it takes for granted and what is not handed over stands
in docs/certify.md. Tools that are not installed are named and left out.

Exit status 0: nothing is rejected; 1: a tool rejects something; 2: bad input, or a tool that is
asked for by --tool is not installed."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("subjects", metavar="NAME", nargs="*", help="default: every subject")
    parser.add_argument(
        "--tool", choices=("coq", "gappa", "singular", "flint"), action="append", help="only this"
    )
    parser.add_argument(
        "--seconds", type=float, default=600.0, metavar="S", help="of a tool and subject; 600"
    )


def run(options: argparse.Namespace) -> int:
    """0, or 1 where a tool rejects something."""
    from gainproof.certify import table, tools
    from gainproof.certify.subjects import chosen

    subjects = chosen(options.subjects)
    present, absent = tools.chosen(options.tool or ())
    for line in absent:
        print(line)
    print(table.head())
    outcomes = []
    for subject in subjects:
        for tool in present:
            outcome = tool.certify(subject, options.seconds)
            outcomes.append(outcome)
            if outcome.statements:
                print(table.row(outcome), flush=True)
                for line in table.notes(outcome):
                    print(line)
    for line in table.foot(outcomes):
        print(line)
    return int(any(outcome.rejected for outcome in outcomes))
