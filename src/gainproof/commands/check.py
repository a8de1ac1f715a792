"""`gainproof check`: verdicts on the claims of a source."""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.claims import time_limit

HELP = "judge the claims of a claim file, or begin one"
DESCRIPTION = """\
Judges every claim of FILE, or of all claim files that belong to gainproof. What is judged is kept
claim by claim, so that a run that is broken off goes on where it was. Exit status 0 if every claim
is settled, whatever the verdict; 1 if one is held or undecided, or an accident such as a killed
process kept it from being judged; 2 for a file with errors, which are told all at once."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "file", metavar="FILE", nargs="?", help="a claim file, or the key of one of gainproof"
    )
    parser.add_argument(
        "--json", action="store_true", help="one object, or a list without FILE; errors too"
    )
    parser.add_argument(
        "--errata",
        metavar="SHEET",
        nargs="?",
        const="",
        help="errata sheet instead of the table, in Markdown; or written to SHEET (.md or .tex)",
    )
    parser.add_argument(
        "--keep-going",
        action="store_true",
        help="judge what a file with errors has beside them; the exit status is 2 all the same",
    )
    parser.add_argument(
        "--certificates",
        metavar="FOLDER",
        help="write what can be decided by one file without gainproof, and how much that is",
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
    """0 if every claim is settled, else 1; 2 if a file has errors; 0 for a file that was begun."""
    from gainproof.bad_input import BadInputError

    if any(each is not None for each in (options.new, options.draft, options.out)):
        print(_begun(options), end="")
        return 0
    try:
        return _check(options)
    except BadInputError as error:
        if not options.json:
            raise
        print(_errors_as_json(options.file, error), end="")
        return 2


def _check(options: argparse.Namespace) -> int:
    import sys

    from gainproof.bad_input import BadInputError, harmless, listed
    from gainproof.claims import judgements
    from gainproof.claims.source_words import claim_words, claims_said
    from gainproof.errata import errata_sheet
    from gainproof.files import places
    from gainproof.jobs.session import open_session
    from gainproof.verdicts import verdict_snapshot

    if options.keep_going and options.errata is not None:
        raise BadInputError("an errata sheet is made of files without errors: not --keep-going")
    _say_what_is_not_limited()
    sheet = errata_sheet.target(options.errata) if options.errata else None
    files = (
        [judgements.find(options.file)] if options.file is not None else list(places.claim_files())
    )
    session = open_session(fresh=options.fresh, only_terminal=True)
    judged = judgements.judge(files, session, options.seconds, keep_going=options.keep_going)
    texts = [judgements.read(file) for file in files]
    if sheet is not None:
        errata_sheet.write(judged, [claims_said(text) for text in texts], sheet)
    if options.errata == "" and not options.json:
        print(errata_sheet.sheet(judged, [claims_said(text) for text in texts]), end="")
    else:
        named = [{claim["id"] for claim in judgement["claims"]} for judgement in judged]
        words = [claim_words(text, ids) for text, ids in zip(texts, named, strict=True)]
        print(_shown(options, judged, words), end="")
    if sheet is not None and not options.json:
        print(f"\nerrata: {places.shown(sheet)}")
    if options.certificates is not None:
        from pathlib import Path

        from gainproof.claims import certificate_files

        told = certificate_files.write_folder(Path(options.certificates), judged)
        sys.stdout.flush()
        print(f"gainproof: {told}", file=sys.stderr)
    _say_accidents(judged)
    errors = [error for judgement in judged for error in judgement.get("errors", ())]
    if errors and not options.json:
        sys.stdout.flush()
        print(f"gainproof: {harmless(listed(errors))}", file=sys.stderr)
    if errors:
        return 2
    return 1 if any(verdict_snapshot.unsettled(judgement) for judgement in judged) else 0


def _say_accidents(judged: Sequence[Mapping[str, Any]]) -> None:
    import sys

    from gainproof.verdicts import verdict_snapshot

    for judgement in judged:
        found = verdict_snapshot.accidents(judgement)
        if found:
            key, why = judgement["source"]["key"], next(iter(found.values()))
            sys.stdout.flush()
            told = f"not judged, by accident: {', '.join(found)} ({why}); check again"
            print(f"gainproof: {key}: {told}", file=sys.stderr)


def _errors_as_json(name: str | None, error: Exception) -> str:
    """{"errors": [...]}; of input that is no claim file one error with the file as it was named."""
    import json

    from gainproof.verify.judge.claim.errors import ClaimFileError

    only = ClaimFileError(name or "", "", str(error)).to_json()
    only |= {"file": name, "message": str(error), "text": str(error)}
    errors = getattr(error, "errors", ()) or [only]
    return json.dumps({"errors": list(errors)}, indent=2) + "\n"


def _say_what_is_not_limited() -> None:
    import sys

    from gainproof.verify.judge.process_limits import LIMITED, UNLIMITED_NOTE

    if not LIMITED:
        print(f"gainproof: {UNLIMITED_NOTE}", file=sys.stderr)


def _begun(options: argparse.Namespace) -> str:
    """What to say, or the draft itself, after a claim file was begun."""
    from gainproof.bad_input import BadInputError
    from gainproof.claims import new_file

    if options.file is not None or options.json or options.errata is not None:
        raise BadInputError("--new and --draft begin a claim file; they do not judge one")
    if options.new is not None and (options.draft is not None or options.out is not None):
        raise BadInputError("--new writes a template; a draft is --draft PAPER.tex --out NEW.toml")
    if options.new is not None:
        return new_file.begin(options.new)
    if options.draft is None:
        raise BadInputError("--out says where to write a draft: --draft PAPER.tex is missing")
    return new_file.begin_from(options.draft, options.out)


def _shown(
    options: argparse.Namespace,
    judged: Sequence[Mapping[str, Any]],
    words: Sequence[Mapping[str, str]],
) -> str:
    """What goes to standard output: data or the table."""
    import json

    from gainproof import terminal_text
    from gainproof.verdicts import verdict_text

    if options.json:
        return json.dumps(judged[0] if options.file is not None else judged, indent=2) + "\n"
    columns = terminal_text.width()
    return "\n".join(
        verdict_text.overview(judgement, columns, said)
        for judgement, said in zip(judged, words, strict=True)
    )
