"""`gainproof generate`: kernels and certificates written."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from gainproof.jobs.session import Session
    from gainproof.standalone.making import Remark
    from gainproof.subjects.drift import Difference

HELP = "write kernels and certificates, or a package of your own with its tests"
DESCRIPTION = """\
Derives afresh and writes the kernels (NumPy modules) with their certificates (JSON) into the
package's own folder: all of them, or those of the subjects named.

With --out DIR they become a package that imports nothing of gainproof: modules, the code that they
share, certificates, a page in Markdown each, tests, licence. DIR is the package, its last part the
name. FILE is a Python file of your own that defines MODEL, a gainproof.derive.model.Model, or
EXPRESSIONS, a gainproof.derive.own_expressions.expressions.ExpressionSet; the file is executed.
Other files in DIR are left alone, and nothing is written that would replace one.
--target puts other languages besides, each into a folder of its name in DIR: c has a C99 header,
source and test program of each module, in which the package computes once `python -m
PACKAGE.compile` was run; octave a package of functions for MATLAB and Octave with a test script;
rust a crate without the standard library (no_std) with its tests; fpcore expressions as FPCore.
--kernel puts only the kernels named into the package, with --format only in one format, in every
target, with the tests of these.

Where the error of an output is proved relative to something larger than its value, the command says
how many digits can be lost and in which part of the domain, as docstring and page do. A kernel of
expressions of your own that can lose half of its digits or more is not written, unless --allow-loss
is given, and the command says what else helps; those of a MODEL are, since their outputs vanish
whatever their form.

With --check nothing is written. Exit status 0: written, or as derived; 1: with --check a file is
missing, different or left over, with --test a test fails, without --allow-loss half of an output's
digits can be lost and nothing is written, or a proved bound is larger or a domain smaller than in
generated/bounds.json and nothing is written; 2: bad input, nothing is written."""


def configure(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("subjects", metavar="NAME|FILE", nargs="*", help="default: everything")
    parser.add_argument("--out", metavar="DIR", help="write a package of its own into this folder")
    parser.add_argument(
        "--target",
        choices=("numpy", "c", "fpcore", "octave", "rust"),
        action="append",
        default=[],
        help="write this besides NumPy modules; may be repeated",
    )
    parser.add_argument(
        "--kernel",
        metavar="NAME",
        action="append",
        default=[],
        help="only this kernel; may be repeated",
    )
    parser.add_argument("--format", choices=("float32", "float64"), help="only this format")
    parser.add_argument("--check", action="store_true", help="compare, write nothing")
    parser.add_argument("--test", action="store_true", help="run the tests of the package too")
    parser.add_argument(
        "--allow-loss", action="store_true", help="write kernels that can lose half of their digits"
    )
    parser.add_argument("--fresh", action="store_true", help="take nothing from the cache")


def run(options: argparse.Namespace) -> int:
    """0; 1 on a difference with --check, on a bound that grew, on a test that fails with --test, on
    digits lost without --allow-loss.
    """
    from gainproof.bad_input import BadInputError
    from gainproof.jobs.session import open_session
    from gainproof.subjects import derivations

    session = open_session(fresh=options.fresh, only_terminal=options.out is not None)
    if options.out is not None:
        return _package(options, session)
    if options.test:
        raise BadInputError("--test runs the tests of a package: give --out DIR")
    if set(options.target) - {"numpy"}:
        raise BadInputError("--target puts files into a package: give --out DIR")
    if options.kernel or options.format:
        raise BadInputError("--kernel and --format choose what a package has: give --out DIR")
    if any(map(derivations.is_file, options.subjects)):
        raise BadInputError("kernels of your own need a place: give --out DIR")
    return _own_folder(options, session)


def _own_folder(options: argparse.Namespace, session: Session) -> int:
    from gainproof.files import places
    from gainproof.subjects import bounds_ledger, derivations, drift, generated_files

    folder = places.generated_folder()
    derivations.require_names(options.subjects)
    chosen = options.subjects or derivations.catalogue()
    known = bounds_ledger.usable(folder, session.cache.fresh)
    # derived and printed in one go: each alone derives anew
    jobs = [derivations.everything_job(name, known) for name in chosen]
    session.ahead(jobs, lambda _: (), {"everything": "derived and printed"})
    derivations.require_accepted(chosen, derivations.derive(chosen, session), session)
    files = generated_files.fresh(options.subjects, session)
    only = bool(options.subjects)
    differences = drift.compare(files, folder, only=only, exactly=not options.check)
    worse = bounds_ledger.worse(folder, files[bounds_ledger.NAME])
    for sentence in worse:
        print(sentence)
    if options.check:
        return _checked(len(files), differences, drift.CURE)
    if worse:
        print(f"nothing is written: {bounds_ledger.CURE}")
        return 1
    written = generated_files.put(files, differences, folder)
    return _said(written, len(files), folder)


def _package(options: argparse.Namespace, session: Session) -> int:
    from gainproof.standalone import making, record, testing
    from gainproof.standalone.files import TARGETS

    if options.test:
        testing.require_pytest()
    folder = Path(options.out)
    targets = [target for target in TARGETS if target in options.target]
    kernels, only = list(dict.fromkeys(options.kernel)), options.format or ""
    made = making.fresh(options.subjects, session, folder, targets, kernels, only)
    files = made.files
    if options.check:
        cure = f"`{made.command}` writes them"
        status = _checked(len(files) + 1, record.differences(files, folder), cure)
    elif _refused(made.remarks, options.allow_loss):
        return 1
    else:
        status = _said(record.put(files, folder), len(files) + 1, folder)
    return int(not testing.passes(folder)) if options.test and status == 0 else status


def _refused(remarks: Sequence[Remark], allowed: bool) -> bool:
    """Whether nothing may be written, after what each output can lose was said."""
    from gainproof.terminal_text import filled

    for remark in remarks:
        print("\n".join(filled(remark.text, "", "  ")))
    refused = [remark.where for remark in remarks if remark.refused]
    if allowed or not refused:
        return False
    outputs = "1 output" if len(refused) == 1 else f"{len(refused)} outputs"
    print(f"nothing is written: half of the digits or more can be lost of {outputs}. What helps:")
    for text in (
        f"narrower domains of the inputs, without this part: {'; '.join(refused)}",
        'a form whose terms do not cancel: docs/stable-forms.md, "What you can do"',
        "by_terms=True of a Result, where an error that is small beside its terms will do",
        "--allow-loss, which writes the kernels as they are",
    ):
        print("\n".join(filled(text, "- ", "  ")))
    return True


def _checked(count: int, differences: Sequence[Difference], cure: str) -> int:
    for difference in differences:
        print(difference.text())
    if differences:
        print(f"{len(differences)} files are not as derived; {cure}")
        return 1
    print(f"{count} files are as derived")
    return 0


def _said(written: int, count: int, folder: Path) -> int:
    from gainproof.files import places

    print(f"{written} of {count} files written to {places.shown(folder)}, the rest unchanged")
    return 0
