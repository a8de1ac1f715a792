"""`gainproof check`: verdicts on the claims of a source."""

from __future__ import annotations

import argparse

HELP = "judge the claims of a claim file"
DESCRIPTION = """\
Judges every claim of FILE, or of all claim files that belong to gainproof. Exit status 0 if every
claim is settled, whatever the verdict; 1 if one is held or undecided; 2 for a file that is bad."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file", metavar="FILE", nargs="?", help="a claim file, or the key of one of gainproof"
    )
    parser.add_argument("--json", action="store_true", help="one object, or a list without FILE")
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")


def run(options: argparse.Namespace) -> int:
    """0 if every claim is settled, else 1."""
    import json

    from gainproof import judgements, places, verdict_text, verdicts
    from gainproof.workshop import open_workshop

    files = [judgements.find(options.file)] if options.file else list(places.claim_files())
    judged = judgements.judge(files, open_workshop(fresh=options.fresh))
    if options.json:
        print(json.dumps(judged[0] if options.file else judged, indent=2))
    else:
        print("\n".join(verdict_text.overview(judgement) for judgement in judged), end="")
    return 1 if any(verdicts.unsettled(judgement) for judgement in judged) else 0
