"""What a tool said of a subject."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Outcome:
    """Of one subject and one tool.

    `statements` were handed over, `accepted` of them accepted; `rejected` is the first that was
    not, with the reason; `unfinished` says that time ran out before an answer. `left_out`: how many
    statements were not handed over, by reason. `notes`: what the tool found, a line each.
    """

    subject: str
    tool: str
    statements: int
    accepted: int
    seconds: float
    rejected: str = ""
    unfinished: bool = False
    left_out: Mapping[str, int] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
