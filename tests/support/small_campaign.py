"""A campaign of small blocks, each noted in a file where it is carried out."""

from __future__ import annotations

import os
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from gainproof.campaign.campaign import Arguments, Campaign, Done, Report


def square(number: int, notes: str, seconds: float) -> dict[str, int]:
    """Its square, after some seconds; a line with the process in the file `notes` before."""
    with Path(notes).open("a", encoding="utf-8") as file:
        file.write(f"{number} {os.getpid()}\n")
    time.sleep(seconds)
    if number == 13:
        raise ValueError("thirteen")
    return {"square": number * number}


def campaign(count: int, notes: Path, seconds: float = 0.0, first: int = 0) -> Campaign:
    """The squares of numbers from `first` on; their sum is reported."""
    blocks = [(number, str(notes), seconds) for number in range(first, first + count)]
    return Campaign("squares", square, blocks, report, fault)


def fault(_arguments: Arguments, result: Any) -> str | None:
    """What is no square."""
    return None if result.keys() == {"square"} else "no square"


def report(done: Sequence[Done]) -> Report:
    """The sum, and the numbers in the order in which they are reported; more than 999 is wrong."""
    total = sum(each.result["square"] for each in done)
    order = ",".join(str(each.arguments[0]) for each in done)
    return Report(f"sum {total} of {order}", total <= 999)


def carried_out(notes: Path) -> list[int]:
    """The blocks that were begun, in order."""
    if not notes.exists():
        return []
    return [int(line.split()[0]) for line in notes.read_text(encoding="utf-8").splitlines()]


def process_of(number: int, notes: Path) -> int | None:
    """The process that began a block first."""
    for line in notes.read_text(encoding="utf-8").splitlines() if notes.exists() else ():
        block, process = map(int, line.split())
        if block == number:
            return process
    return None
