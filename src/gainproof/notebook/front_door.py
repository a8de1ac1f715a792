"""What `import gainproof` offers: derivations and judged claim files that show themselves."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any, TypeVar

from gainproof.bad_input import unknown_name
from gainproof.claims import judgements
from gainproof.claims.source_words import claim_words
from gainproof.claims.time_limit import DEFAULT
from gainproof.formulas.prose import plain_prose
from gainproof.jobs.session import open_session
from gainproof.notebook.judged_file import JudgedFile
from gainproof.notebook.markup import (
    derived_html,
    derived_latex,
    html_escaped,
    relation,
    step_latex,
)
from gainproof.pages import lecture
from gainproof.subjects import derivations, rechecking
from gainproof.subjects.derived import Derived, DerivedStep
from gainproof.terminal_text import WIDTH
from gainproof.verify.certificate import check_statement

Result = TypeVar("Result")


@dataclass(frozen=True, repr=False)
class Step:
    """A step of a derivation with the names' LaTeX and the checker's word."""

    step: DerivedStep
    symbols: Mapping[str, str]
    mark: str

    def __repr__(self) -> str:
        return f"<step {self.step.id}: {self.mark}>"

    def __str__(self) -> str:
        return f"{self.step}\n    [{self.mark}]"

    def _repr_latex_(self) -> str:
        return step_latex(self.step, self.symbols)

    def _repr_html_(self) -> str:
        said = html_escaped(plain_prose(self.step.sentence))
        shown = "".join(
            f"<p>{html_escaped(line) if words else f'$${html_escaped(line)}$$'}</p>"
            for words, line in relation(self.step, self.symbols)
        )
        return f"<p>{said}</p>{shown}<p><em>[{html_escaped(self.mark)}]</em></p>"


@dataclass(frozen=True, repr=False)
class Marks:
    """The checker's word on statements, by id: proved, cited, definition or rejected; and why one
    was rejected.
    """

    words: Mapping[str, str]
    reasons: Mapping[str, str]

    @property
    def accepted(self) -> bool:
        """Whether none was rejected, and there is one."""
        return bool(self.words) and "rejected" not in self.words.values()

    def __repr__(self) -> str:
        lines = [
            f"{id_}: {word}{f' ({self.reasons[id_]})' if self.reasons.get(id_) else ''}"
            for id_, word in self.words.items()
        ]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        lines = (html_escaped(line) for line in repr(self).split("\n"))
        return "".join(f"<div>[{line}]</div>" for line in lines)


@dataclass(frozen=True, repr=False)
class Derivation:
    """A subject derived, and what the checker says of its certificate.

    `derived` is the subject as data, `report` the checker's report: accepted, reason, statements.
    """

    derived: Derived
    report: Mapping[str, Any]

    @property
    def accepted(self) -> bool:
        """Whether the certificate proves what the derivation is expected to prove."""
        return bool(self.report["accepted"])

    def step(self, id: str) -> Step:  # noqa: A002 (what a step's name is called everywhere)
        """A step by its id. Raises BadInputError, with the nearest, for an id that there is not."""
        steps = {step.id: step for step in self.derived.steps}
        if id not in steps:
            raise unknown_name("step", id, steps)
        return Step(steps[id], self.derived.symbols, lecture.marks_of(self.report)[id])

    def check(self, *ids: str) -> Marks:
        """Ask the checker anew: about these steps, or about all and the certificate as a whole.

        The checker decides in exact fractions, without computer algebra. Raises BadInputError for
        an id that there is not.
        """
        if not ids:
            report = rechecking.recheck(
                self.derived.certificate, rechecking.expected_of(self.derived)
            )
            statements = report["statements"]
            return Marks(
                {entry["id"]: entry["status"] for entry in statements},
                {entry["id"]: entry["reason"] for entry in statements},
            )
        for id_ in ids:
            self.step(id_)
        found = [check_statement(self.derived.certificate, id_) for id_ in ids]
        return Marks({each.id: each.status for each in found}, {e.id: e.reason for e in found})

    def __repr__(self) -> str:
        marks = lecture.marks_of(self.report)
        tally = lecture.count(marks[step.id] for step in self.derived.steps)
        return f"<derivation {self.derived.name}: {len(self.derived.steps)} steps: {tally}>"

    def __str__(self) -> str:
        return lecture.page(self.derived, self.report, columns=WIDTH)

    def _repr_html_(self) -> str:
        return derived_html(self.derived, lecture.marks_of(self.report))

    def _repr_latex_(self) -> str:
        return derived_latex(self.derived)


def derivation(name_or_file: str, *, fresh: bool = False) -> Derivation:
    """See `gainproof.derivation`."""

    def work() -> Derivation:
        session = open_session(fresh=fresh, quiet=True)
        derived = derivations.one(name_or_file, session)
        return Derivation(derived, derivations.own_report(derived, session))

    return _beside_a_loop(work)


def check(file: str, *, seconds: float = DEFAULT, fresh: bool = False) -> JudgedFile:
    """See `gainproof.check`."""

    def work() -> JudgedFile:
        path = judgements.find(file)
        session = open_session(fresh=fresh, quiet=True)
        (judged,) = judgements.judge([path], session, seconds)
        return JudgedFile(judged, claim_words(judgements.read(path)))

    return _beside_a_loop(work)


def _beside_a_loop(work: Callable[[], Result]) -> Result:
    """What comes of the work. In a notebook a loop of asyncio runs already, and the processes that
    derive and judge are waited for by another one, which needs a thread of its own then.
    """
    try:
        asyncio.get_running_loop()
    except RuntimeError:
        return work()
    with ThreadPoolExecutor(max_workers=1) as threads:
        return threads.submit(work).result()
