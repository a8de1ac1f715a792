"""`gainproof check`: verdicts on the claims of a source."""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.commands import time_limit

HELP = "judge the claims of a claim file, or begin one"
DESCRIPTION = """\
Judges every claim of FILE, or of all claim files that belong to gainproof. Exit status 0 if every
claim is settled, whatever the verdict; 1 if one is held or undecided; 2 for a file that is bad."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file", metavar="FILE", nargs="?", help="a claim file, or the key of one of gainproof"
    )
    parser.add_argument("--json", action="store_true", help="one object, or a list without FILE")
    parser.add_argument(
        "--errata",
        metavar="SHEET",
        nargs="?",
        const="",
        help="errata sheet instead of the table, in Markdown; or written to SHEET (.md or .tex)",
    )
    time_limit.configure(parser)
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")
    begin = parser.add_argument_group("to begin a claim file, instead of judging one")
    begin.add_argument("--new", metavar="NEW.toml", help="write a commented template")
    begin.add_argument(
        "--draft", metavar="PAPER.tex", help="draft one from the displayed equations of a paper"
    )
    begin.add_argument(
        "--out", metavar="NEW.toml", help="where to write the draft; else it is printed"
    )


def run(options: argparse.Namespace) -> int:
    """0 if every claim is settled, else 1; 0 for a claim file that was begun."""
    if any(each is not None for each in (options.new, options.draft, options.out)):
        print(_begun(options), end="")
        return 0
    from gainproof import errata, judgements, places, verdicts
    from gainproof.claim_words import claim_words
    from gainproof.workshop import open_workshop

    _say_what_is_not_limited()
    sheet = errata.target(options.errata) if options.errata else None
    files = (
        [judgements.find(options.file)] if options.file is not None else list(places.claim_files())
    )
    shop = open_workshop(fresh=options.fresh, only_terminal=True)
    judged = judgements.judge(files, shop, options.seconds)
    words = [claim_words(judgements.read(file)) for file in files]
    if sheet is not None:
        errata.write(judged, words, sheet)
    print(_shown(options, judged, words), end="")
    if sheet is not None and not options.json:
        print(f"\nerrata: {places.shown(sheet)}")
    return 1 if any(verdicts.unsettled(judgement) for judgement in judged) else 0


def _say_what_is_not_limited() -> None:
    import sys

    from gainproof.verify.judge.process_limits import LIMITED, UNLIMITED_NOTE

    if not LIMITED:
        print(f"gainproof: {UNLIMITED_NOTE}", file=sys.stderr)


def _begun(options: argparse.Namespace) -> str:
    """What to say, or the draft itself, after a claim file was begun."""
    from gainproof import beginning
    from gainproof.bad_input import BadInputError

    if options.file is not None or options.json or options.errata is not None:
        raise BadInputError("--new and --draft begin a claim file; they do not judge one")
    if options.new is not None and (options.draft is not None or options.out is not None):
        raise BadInputError("--new writes a template; a draft is --draft PAPER.tex --out NEW.toml")
    if options.new is not None:
        return beginning.begin(options.new)
    if options.draft is None:
        raise BadInputError("--out says where to write a draft: --draft PAPER.tex is missing")
    return beginning.begin_from(options.draft, options.out)


def _shown(
    options: argparse.Namespace,
    judged: Sequence[Mapping[str, Any]],
    words: Sequence[Mapping[str, str]],
) -> str:
    """What goes to standard output: data, the sheet, or the table."""
    import json

    from gainproof import errata, page, verdict_text

    if options.json:
        return json.dumps(judged[0] if options.file is not None else judged, indent=2) + "\n"
    if options.errata == "":
        return errata.sheet(judged, words)
    columns = page.width()
    return "\n".join(
        verdict_text.overview(judgement, columns, said)
        for judgement, said in zip(judged, words, strict=True)
    )
