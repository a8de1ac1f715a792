"""What a statement rests upon, found without recursion: a chain of premises may be as long as the
certificate, and Python's stack is not.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Protocol

from gainproof.verify.certificate.plain import Plain
from gainproof.verify.certificate.words.setting import Setting


class Statement(Protocol):
    """A statement of a certificate: its id, kind, claim and evidence."""

    @property
    def id(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def claim(self) -> Plain: ...
    @property
    def evidence(self) -> Plain: ...


def undecided(setting: Setting, statement: Statement, earlier: Sequence[Statement]) -> list[int]:
    """The numbers, ascending, of the earlier statements that this one rests upon, also through
    others, and that are still to be decided.
    """
    numbers = {other.id: number for number, other in enumerate(earlier)}
    waiting, found = [statement], set[int]()
    while waiting:
        current = waiting.pop()
        end = numbers.get(current.id, len(earlier))
        for identifier in _named(current.evidence):
            number = numbers.get(identifier, end)
            if number < end and number not in found:
                known = setting.decided.get(identifier)
                if known is None or known[0] is not earlier[number]:
                    found.add(number)
                    waiting.append(earlier[number])
    return sorted(found)


def _named(evidence: Plain) -> Iterator[str]:
    """The ids in all that reads ["statement", id] or ["inverse", id, side]."""
    waiting = [evidence]
    while waiting:
        value = waiting.pop()
        if isinstance(value, dict):
            waiting += value.values()
        elif isinstance(value, list):
            if value[:1] in (["statement"], ["inverse"]):
                yield from (part for part in value[1:2] if isinstance(part, str))
            waiting += value
