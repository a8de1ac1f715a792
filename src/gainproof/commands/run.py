"""`gainproof run`: everything derived, compared, checked and judged."""

from __future__ import annotations

import argparse

HELP = "derive all, compare kernels, check certificates, judge claim files, write report/"
DESCRIPTION = """\
Derives every subject afresh, compares generated/ byte for byte, checks every certificate again,
judges every claim file against its snapshot of verdicts, and writes report/report.txt and
report.json. Exit status 1 on drift, on a rejected certificate or on a verdict that changed."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--accept", action="store_true", help="renew the snapshots of verdicts")
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")
    parser.add_argument("--report", metavar="DIR", default="report", help="default: report")


def run(options: argparse.Namespace) -> int:
    """0 if all is as it should be, else 1."""
    from pathlib import Path

    from gainproof import places, report
    from gainproof.everything import find
    from gainproof.workshop import open_workshop

    shop = open_workshop(fresh=options.fresh)
    findings = find(shop, accept=options.accept)
    folder = Path(options.report)
    report.write(findings, folder)
    print(report.summary(findings), end="")
    seconds = f"{shop.progress.elapsed():.1f} s"
    print(f"{'report:':<18}{places.shown(folder)}/report.txt, report.json ({seconds})")
    return 0 if findings.good else 1
