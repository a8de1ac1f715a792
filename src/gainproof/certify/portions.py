"""What is asked of a tool at a time, so that it can be shared out and kept: plain data.

Of Singular and python-flint that is a subject. Of Coq it is a few of its statements: it stops at
the first that it does not accept, and takes minutes for others. Of Gappa it is the outputs of a
subject that are computed alike, which it is asked about once, and the count of those that it is not
asked about. What is said of the portions of a subject joins.
"""

from __future__ import annotations

import hashlib
import subprocess
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import asdict, replace
from functools import cache
from importlib import metadata
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.campaign.printed_bound import PrintedBound, printed_bounds
from gainproof.certify import bounds, coq
from gainproof.certify.expression import NotExportedError
from gainproof.certify.outcome import Outcome
from gainproof.certify.reading import statements
from gainproof.certify.rounding_bound import steps_of
from gainproof.certify.subjects import Subject, chosen
from gainproof.certify.tools import TOOLS, Tool
from gainproof.files.places import package_folder
from gainproof.jobs.code_digest import of_files

Portion = tuple[str, str, list[str], str]
"""Tool, subject, names of statements or outputs (none: all that there is), and a digest."""
TOGETHER = 6
"""Statements that coqc reads together: its library alone takes half a second."""


def portions(subject: Subject, tool: Tool) -> Iterator[Portion]:
    """Of a subject and tool, in the order of its kernels."""
    known = _digest(subject, tool)
    if tool.name == coq.NAME:
        every = list(dict.fromkeys(each.id for each in statements(subject.certificate)))
        for start in range(0, len(every), TOGETHER):
            yield tool.name, subject.name, every[start : start + TOGETHER], known
        return
    if tool.name != bounds.NAME:
        yield tool.name, subject.name, [], known
        return
    alike: dict[object, list[str]] = {None: [bounds.OTHERS]}
    for printed in printed_bounds(subject.source):
        alike.setdefault(_kind(subject, printed), []).append(printed.name)
    for names in alike.values():
        yield tool.name, subject.name, names, known


def certified(seconds: float, tool: str, subject: str, names: list[str], digest: str) -> Any:
    """What the tool says of a portion, as plain data, in at most so many seconds.

    Raises BadInputError where the digest is not that of what is here.
    """
    (asked,) = (each for each in TOOLS if each.name == tool)
    (found,) = chosen([subject])
    if _digest(found, asked) != digest:
        raise BadInputError(f"{subject}: certificate, code or {tool} changed while it was asked")
    said = asked.certify(replace(found, only=frozenset(names) or None), seconds)
    return {**asdict(said), "left_out": dict(said.left_out), "notes": list(said.notes)}


def outcome(data: Any) -> Outcome:
    """What `certified` gave."""
    return Outcome(**{**data, "notes": tuple(data["notes"])})


def joined(outcomes: Sequence[Outcome]) -> Outcome:
    """Those of the portions of a subject and tool."""
    left_out: Counter[str] = Counter()
    for each in outcomes:
        left_out.update(each.left_out)
    return Outcome(
        outcomes[0].subject,
        outcomes[0].tool,
        sum(each.statements for each in outcomes),
        sum(each.accepted for each in outcomes),
        sum(each.seconds for each in outcomes),
        next((each.rejected for each in outcomes if each.rejected), ""),
        any(each.unfinished for each in outcomes),
        left_out,
        tuple(note for each in outcomes for note in each.notes),
    )


def _kind(subject: Subject, printed: PrintedBound) -> object:
    """Equal for outputs about which Gappa is asked the same."""
    program = subject.certificate["programs"].get(printed.kernel)
    try:
        steps = program and steps_of(program["graph"], printed.output)
    except NotExportedError:
        steps = None
    return (steps, printed.domain, printed.bound) if steps else printed.name


def _digest(subject: Subject, tool: Tool) -> str:
    """Of all that the answer rests on."""
    found = hashlib.sha256(repr((subject.certificate, subject.source)).encode())
    found.update(f"{tool.name} {_version(tool.program)} {_code()}".encode())
    return found.hexdigest()[:16]


@cache
def _version(program: str | None) -> str:
    if program is None:
        return metadata.version("python-flint")
    done = subprocess.run(
        [program, "--version"],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        encoding="utf-8",
        errors="replace",
        check=False,
    )
    return next(iter(f"{done.stdout}{done.stderr}".splitlines()), "")  # below it may be seeds


@cache
def _code() -> str:
    """Digest of this package and of the printer, whose graphs and steps it reads."""
    here, printer = Path(__file__).resolve().parent, package_folder("derive") / "printer"
    return of_files(here, here.glob("*.py")) + of_files(printer, printer.glob("*.py"))
