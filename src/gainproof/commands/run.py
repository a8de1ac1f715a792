"""`gainproof run`: everything derived, compared, checked and judged."""

from __future__ import annotations

import argparse

HELP = "derive, check and judge all that is shipped, and compare it with its files"
DESCRIPTION = """\
Derives every subject, compares generated/ byte for byte, checks every certificate again, judges
every claim file against its snapshot of verdicts, and writes report/report.txt and report.json.
What was found before of the same input by the same code is taken from a cache, and counted apart;
with --fresh nothing is, which is the verification. Exit status 1 on drift, on a rejected
certificate, on a verdict that changed or that an accident such as a killed process kept from being
found; 2 where all is well and the report cannot be written."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--accept", action="store_true", help="renew the snapshots of verdicts")
    parser.add_argument(
        "--fresh", action="store_true", help="take nothing of what was found before"
    )
    parser.add_argument("--report", metavar="DIR", default="report", help="default: report")


def run(options: argparse.Namespace) -> int:
    """0 if all is as it should be, else 1; 2 where only the report is missing."""
    import sys
    from pathlib import Path

    from gainproof.bad_input import BadInputError
    from gainproof.files import places
    from gainproof.jobs.session import open_session
    from gainproof.verification import report
    from gainproof.verification.findings import find

    folder = Path(options.report)
    try:
        places.require_writable(folder)
    except BadInputError as error:
        print(f"gainproof: {error}; the summary will be printed", file=sys.stderr)
    session = open_session(fresh=options.fresh)
    findings = find(session, accept=options.accept)
    print("gainproof run: what is shipped, derived, compared, checked and judged")
    print(report.summary(findings), end="")
    seconds = f"{session.progress.elapsed():.1f} s"
    try:
        report.write(findings, folder)
    except BadInputError as error:
        print(f"{'report:':<18}none: {error} ({seconds})")
        return 2 if findings.good else 1
    print(f"{'report:':<18}{places.shown(folder)}/report.txt, report.json ({seconds})")
    return 0 if findings.good else 1
