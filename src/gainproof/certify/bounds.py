"""The bounds that kernels print, beside those that Gappa finds."""

from __future__ import annotations

from collections import Counter
from fractions import Fraction
from time import perf_counter

from gainproof.certify import gappa
from gainproof.certify.expression import NotExportedError
from gainproof.certify.outcome import Outcome
from gainproof.certify.printed_bound import PrintedBound, printed_bounds
from gainproof.certify.subjects import Subject

NAME, PROGRAM = "gappa", gappa.PROGRAM
SHARED = 2
"""Gappa counts twice an error that both operands of a step have, once where they cancel: its bound
may be larger than the printed one, and one of more than this ratio is taken for a rejection."""


def certify(subject: Subject, limit: float) -> Outcome:
    """Accepted is an output whose printed bound is no less than Gappa's."""
    start, statements, accepted = perf_counter(), 0, 0
    left_out: Counter[str] = Counter()
    rejected, unfinished, notes = "", False, []
    for printed in printed_bounds(subject.source):
        what = f"{printed.kernel}.{printed.output}"
        try:
            found = _found(subject, printed, limit - (perf_counter() - start))
        except NotExportedError as reason:
            left_out[str(reason)] += 1
            continue
        except gappa.OutOfTimeError:
            unfinished = True
            break
        statements += 1
        shown = "none" if found is None else f"{float(found):.2f}"
        said = f"{what}: printed {float(printed.bound):.2f}, Gappa {shown} times 2^-52"
        if found is not None and found <= printed.bound:
            accepted += 1
        elif found is None or found > SHARED * printed.bound:
            rejected = rejected or said
        else:
            notes.append(said)
    return Outcome(
        subject.name,
        NAME,
        statements,
        accepted,
        perf_counter() - start,
        rejected,
        unfinished,
        left_out,
        tuple(notes),
    )


def _found(subject: Subject, printed: PrintedBound, limit: float) -> Fraction | None:
    program = subject.certificate["programs"].get(printed.kernel)
    if program is None:
        raise NotExportedError("kernels of several programs")
    return gappa.largest_error(program["graph"], printed.output, printed.domain, limit)
