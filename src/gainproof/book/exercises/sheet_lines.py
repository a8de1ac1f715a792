"""The lines of a sheet as they are shown, and the region in which a mark counts half."""

from __future__ import annotations

import re
from dataclasses import dataclass
from hashlib import sha256

from markupsafe import Markup

from gainproof.book.derivation_pages import address, formulas_of, writer_of
from gainproof.book.exercises.planting import Planted, parts
from gainproof.book.exercises.sealed import Sealed, sealed
from gainproof.book.prose_html import prose
from gainproof.pages.lecture_items import items, numbers
from gainproof.subjects.derived import Derived
from gainproof.verdicts.witness_text import of_relation

RULE = (
    "Mark one line and check it. The first mark counts: 1 point for the wrong line, half a point "
    "for another line of its part or for the line just before or after it, nothing for others. "
    "After that you may go on looking, without points."
)
HONESTY = (
    "Lines of this sheet were decided by the same checker as the derivation itself: all are "
    "proved, cited or definitions but one, which has an exact counterexample. Mind two things. The "
    "derivation without the error is in the book too, and the sheet knows its answer: it does not "
    "stand there to be read, but it is no secret from whoever writes a program."
)
_LINK = re.compile(r'href="#step-([^"]+)"')


@dataclass(frozen=True)
class Line:
    """One numbered line of a sheet, and the title of the part that it opens, if it does."""

    number: int
    heading: str
    sentence: Markup
    formulas: tuple[Markup, ...]
    reason: Markup


def sheet_lines(planted: Planted, root: str) -> list[Line]:
    """The lines, the wrong one among them. `root`: the way from the sheet to the site's folder."""
    derived = planted.derived
    found = items(derived.steps)
    known = numbers(found)
    chosen = [item for item in found if planted.first <= item.number <= planted.last]
    here = {step.id: item.first.id for item in chosen for step in item.steps}
    writer = writer_of(derived.symbols)

    def led(text: Markup) -> Markup:
        """References to steps that the sheet does not have lead to the derivation."""
        whole = f"{root}{address(derived.name)}"
        return Markup(
            _LINK.sub(
                lambda match: (
                    f'href="#line-{known[match[1]]}"'
                    if match[1] in here
                    else f'href="{whole}#step-{match[1]}"'
                ),
                str(text),
            )
        )

    return [
        Line(
            item.number,
            item.first.heading,
            led(prose(item.first.sentence, derived.symbols, known)),
            tuple(f for step in item.steps for f in formulas_of(step, writer)),
            led(prose(item.first.reason, derived.symbols, known)),
        )
        for item in chosen
    ]


def region(derived: Derived, line: int, first: int, last: int) -> list[int]:
    """The lines of the same part, and those just before and after, as far as they are shown."""
    ((start, end),) = (p for p in parts(items(derived.steps)) if p[0] <= line <= p[1])
    near = {*range(start, end + 1), line - 1, line + 1}
    return sorted(n for n in near if first <= n <= last)


def seal(planted: Planted) -> Sealed:
    """The answer of a sheet, sealed."""
    text = f"gainproof {planted.seed} {planted.number} {planted.derived.name}"
    salt = sha256(text.encode()).hexdigest()[:16]
    near = region(planted.derived, planted.line, planted.first, planted.last)
    return sealed(salt, planted.line, near, answer(planted))


def answer(planted: Planted) -> str:
    """What the wrong line is, and the point at which it is false."""
    error = f"Line {planted.line} is wrong ({planted.slip}; step {planted.id})."
    return f"{error} {of_relation(planted.witness.plain(), planted.derived.symbols)}"
