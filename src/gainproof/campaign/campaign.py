"""What a campaign is."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

Arguments = tuple[Any, ...]
"""Plain data as JSON has it, lists and not tuples within."""


class Done(NamedTuple):
    """A block's arguments, what came of it as plain data, and the seconds of the processor of the
    thread that carried it out, without those of processes that it started.
    """

    arguments: Arguments
    result: Any
    seconds: float


class Report(NamedTuple):
    """What came of the blocks together, in lines, and whether it is as it should be."""

    text: str
    passed: bool


def _none(_arguments: Arguments, _result: Any) -> str | None:
    """Any result may be one."""
    return None


@dataclass(frozen=True)
class Campaign:
    """Work in blocks that need nothing of each other, numbered from 0.

    `work(*blocks[number])` is the result of a block: plain data that depend on its arguments alone,
    so that it is the same in whatever process and order; `work` is a function of a module, which
    other processes import. The arguments say all that the result depends on, by a digest the code
    too: a result that is kept counts as long as there is a block with these arguments.

    `report` is about the blocks that are done, in their order. `fault` says of a result that is
    read again what no block with these arguments can have given; None where it may be a result.
    """

    name: str
    work: Callable[..., Any]
    blocks: Sequence[Arguments]
    report: Callable[[Sequence[Done]], Report]
    fault: Callable[[Arguments, Any], str | None] = _none
