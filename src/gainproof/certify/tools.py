"""The tools, and which of them are here."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from gainproof.bad_input import BadInputError
from gainproof.certify import bounds, coq, external, polynomials, singular
from gainproof.certify.outcome import Outcome
from gainproof.certify.subjects import Subject


@dataclass(frozen=True)
class Tool:
    """A name, the program it needs (none: a library of Python), and what it says of a subject.

    The number is the most seconds that it may take.
    """

    name: str
    program: str | None
    certify: Callable[[Subject, float], Outcome]

    def present(self) -> bool:
        return self.program is None or external.found(self.program)


TOOLS = (
    Tool(polynomials.NAME, None, polynomials.certify),
    Tool(singular.NAME, singular.PROGRAM, singular.certify),
    Tool(coq.NAME, coq.PROGRAM, coq.certify),
    Tool(bounds.NAME, bounds.PROGRAM, bounds.certify),
)


def chosen(names: Sequence[str]) -> tuple[list[Tool], list[str]]:
    """The tools of these names, or all that are here; and a line on each that is not.

    Raises BadInputError for one that is asked for and not here.
    """
    here = [tool for tool in TOOLS if tool.present()]
    for tool in TOOLS:
        if tool.name in names and tool not in here:
            raise BadInputError(f"{tool.name} is asked for, and {tool.program} is not installed")
    absent = [f"{t.name}: {t.program} is not installed" for t in TOOLS if t not in here]
    return [t for t in here if not names or t.name in names], [] if names else absent
