"""`gainproof derive`: a derivation as a page to read."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from contextlib import contextmanager

HELP = "print a derivation, each step checked"
DESCRIPTION = """\
Derives a subject of the catalogue (`gainproof list`) and prints it. Every relation is marked by the
checker, which uses no computer algebra: [proved], [cited] or [definition].

FILE is a Python file that defines MODEL, a gainproof.derive.model.Model; the file is executed."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("subject", metavar="NAME|FILE", help="a subject's name or a model file")
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--steps", action="store_true", help="with every step's sentence and reason")
    form.add_argument("--latex", action="store_true", help="the same as a LaTeX document")
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")


@contextmanager
def _word_of_long_work(text: str) -> Iterator[None]:
    """A line on the terminal, if somebody can be looking on, once the work takes a while."""
    import sys
    from threading import Timer

    from gainproof.progress import EVERY, Progress

    progress = Progress(quiet=not sys.stderr.isatty())
    timer = Timer(EVERY, progress.say, (text,))
    timer.daemon = True
    timer.start()
    try:
        yield
    finally:
        timer.cancel()


def run(options: argparse.Namespace) -> int:
    """0 if the checker accepts every step, else 1."""
    from gainproof import derivations, lecture, lecture_latex, page
    from gainproof.workshop import open_workshop

    shop = open_workshop(fresh=options.fresh, quiet=True)
    with _word_of_long_work(f"deriving {options.subject}"):
        derived = derivations.one(options.subject, shop)
        report = derivations.own_report(derived, shop)
    if options.latex:
        print(lecture_latex.document(derived, report), end="")
    else:
        text = lecture.page(derived, report, with_steps=options.steps, columns=page.width())
        print(text, end="")
    return 0 if report["accepted"] else 1
