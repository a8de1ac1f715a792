"""`gainproof derive`: a derivation as a page to read."""

from __future__ import annotations

import argparse
from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gainproof.subjects.derived import Derived

HELP = "print a derivation, each step checked"
DESCRIPTION = """\
Derives a subject of the catalogue (`gainproof list`) and prints it. Every relation is marked by the
checker, which uses no computer algebra: [proved], [cited] or [definition].

--notebook writes F.ipynb: sentences and formulas, and cells that have each step checked anew,
evaluate the kernels and draw one of them; it needs the extra: pip install 'gainproof[notebook]'.

FILE is a Python file that defines MODEL, a gainproof.derive.model.Model; the file is executed."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("subject", metavar="NAME|FILE", help="a subject's name or a model file")
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--steps", action="store_true", help="with every step's sentence and reason")
    form.add_argument("--latex", action="store_true", help="the same as a LaTeX document")
    form.add_argument(
        "--notebook", metavar="F.ipynb", help="the same as a notebook that has each step checked"
    )
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")


@contextmanager
def _word_of_long_work(text: str) -> Iterator[None]:
    """A line on the terminal, if somebody can be looking on, once the work takes a while."""
    import sys
    from threading import Timer

    from gainproof.jobs.progress import EVERY, Progress

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
    from gainproof import terminal_text
    from gainproof.jobs.session import open_session
    from gainproof.pages import lecture, lecture_latex
    from gainproof.subjects import derivations

    if options.notebook is not None:
        _require_notebook(options.notebook)
    session = open_session(fresh=options.fresh, quiet=True)
    with _word_of_long_work(f"deriving {options.subject}"):
        derived = derivations.one(options.subject, session)
        report = derivations.own_report(derived, session)
    if options.notebook is not None:
        _write_notebook(options.notebook, options.subject, derived)
    elif options.latex:
        print(lecture_latex.document(derived, report), end="")
    else:
        text = lecture.page(
            derived, report, with_steps=options.steps, columns=terminal_text.width()
        )
        print(text, end="")
    return 0 if report["accepted"] else 1


def _require_notebook(name: str) -> None:
    """Before anything is derived: a name that notebooks have, and what writes them."""
    from gainproof.bad_input import BadInputError
    from gainproof.notebook.cells import require_nbformat

    if not name.endswith(".ipynb"):
        raise BadInputError(f"--notebook: a file that ends in .ipynb is wanted, got {name}")
    require_nbformat()


def _write_notebook(name: str, subject: str, derived: Derived) -> None:
    from pathlib import Path

    from gainproof.bad_input import BadInputError
    from gainproof.files import atomic_file, places
    from gainproof.notebook.cells import notebook
    from gainproof.notebook.derivation_notebook import derivation_cells

    text = notebook(derivation_cells(derived, subject))
    try:
        atomic_file.write_text(Path(name), text)
    except OSError as error:
        why = error.strerror or error
        raise BadInputError(f"{places.shown(Path(name))}: cannot be written: {why}") from None
    print(f"notebook: {places.shown(Path(name))}")
