"""The error bounds that kernels print, put before Gappa piece by piece of their domains."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from time import perf_counter

from gainproof.campaign.printed_bound import PrintedBound, other_bounds, printed_bounds
from gainproof.certify import gappa
from gainproof.certify.cover import Cover
from gainproof.certify.expression import NotExportedError
from gainproof.certify.outcome import Outcome
from gainproof.certify.rounding_bound import covered, steps_of
from gainproof.certify.subjects import Subject
from gainproof.jobs.progress import Progress

NAME, PROGRAM = "gappa", gappa.PROGRAM
OTHERS = "other bounds"
"""Among the outputs of a subject: those bounds that Gappa is not asked about, to be counted."""


def certify(subject: Subject, limit: float) -> Outcome:
    """Accepted is an output of which Gappa shows the printed bound on the whole printed domain.

    Rejected is one whose roundings weigh more somewhere; where Gappa finds no weights, a note says
    so, and the output is neither.
    """
    start, statements, accepted = perf_counter(), 0, 0
    left_out: Counter[str] = Counter()
    if subject.only is None or OTHERS in subject.only:
        left_out += other_bounds(subject.source)
    rejected, unfinished, notes = "", False, []
    progress, known = Progress(), dict[object, Cover]()
    for printed in printed_bounds(subject.source):
        what = printed.name
        if subject.only is not None and what not in subject.only:
            continue

        def say(pieces: int, what: str = what) -> None:
            progress.say_sometimes(f"{subject.name} {what}: {pieces} pieces")

        begun = perf_counter()
        try:
            found = _found(subject, printed, known, limit - (begun - start), say)
        except NotExportedError as reason:
            left_out[str(reason)] += 1
            continue
        except gappa.OutOfTimeError:
            unfinished = True
            break
        statements += 1
        said = f"{what}: {_words(printed, found)}"
        accepted += found.failed is None
        if found.failed is not None and found.failed[2] is not None:
            rejected = rejected or said
        notes.append(f"{said}, {perf_counter() - begun:.1f} s")
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


def _found(
    subject: Subject,
    printed: PrintedBound,
    known: dict[object, Cover],
    limit: float,
    say: Callable[[int], None],
) -> Cover:
    """What Gappa makes of an output; of those computed alike it is asked once."""
    program = subject.certificate["programs"].get(printed.kernel)
    if program is None:
        raise NotExportedError("kernels of several programs")
    graph, domain, bound = program["graph"], printed.domain, printed.bound
    alike = (steps_of(graph, printed.output), domain, bound)
    if alike not in known:
        known[alike] = covered(graph, printed.output, domain, bound, limit, say)
    return known[alike]


def _words(printed: PrintedBound, found: Cover) -> str:
    bound = f"printed {float(printed.bound):.2f}"
    if found.failed is None:
        return f"{bound}, Gappa {float(found.largest) / 2:.3f} times 2^-52, {found.pieces} pieces"
    low, high, sums = found.failed
    shown = "nothing" if sums is None else f"{float(sums[0]) / 2:.3f} to {float(sums[1]) / 2:.3f}"
    return f"{bound}, Gappa {shown} times 2^-52 from {float(low)} to {float(high)}"
