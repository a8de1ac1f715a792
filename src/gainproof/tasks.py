"""What worker processes do: functions of plain data, by name; what is heavy is imported inside.

Each gets the `Desk` of its process first.
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from gainproof.desk import Desk

if TYPE_CHECKING:  # importing it imports SymPy
    from gainproof.derive.subject import Subject

Plain = dict[str, Any]


def catalogue(_: Desk) -> list[str]:
    """Names of all subjects, in the order of the catalogue."""
    from gainproof.deriving import catalogue_names

    return catalogue_names()


def overview(desk: Desk) -> list[Plain]:
    """Every subject with its kernels and sources, without certificates."""
    from gainproof.deriving import catalogue_names, overview_of

    return [overview_of(_subject(desk, name)) for name in catalogue_names()]


def derive(desk: Desk, name: str) -> Plain:
    """Derive one subject of the catalogue: `Derived` as plain data. SymPy is imported here."""
    from gainproof.deriving import plain_subject

    return plain_subject(_subject(desk, name)).plain()


def everything(desk: Desk) -> list[Plain]:
    """What the tasks on the whole catalogue and on each of its subjects answer, which shares most
    of the work: {"task", "arguments", "result"} of each.
    """
    asked: list[tuple[str, Plain, str]] = [("catalogue", {}, ""), ("overview", {}, "")]
    asked += [("derive", {"name": name}, f"derived {name}") for name in catalogue(desk)]
    asked.append(("print_all", {}, "printed all files"))
    found = []
    for task, arguments, work in asked:
        start = time.perf_counter()
        result = TASKS[task](desk, **arguments)
        found.append({"task": task, "arguments": arguments, "result": result})
        if work:
            desk.tell(f"{work} ({time.perf_counter() - start:.1f} s)")
    return found


def derive_file(_: Desk, path: str) -> Plain:
    """Derive the model of a user's file: `Derived` as plain data. The file is executed."""
    from gainproof.deriving import plain_subject
    from gainproof.model_file import build_model_file

    return plain_subject(build_model_file(path)).plain()


def print_all(desk: Desk) -> dict[str, str]:
    """Every file of generated/ by name."""
    from gainproof.deriving import catalogue_names
    from gainproof.generating import files_of

    return files_of([_subject(desk, name) for name in catalogue_names()])


def print_one(desk: Desk, name: str) -> dict[str, str]:
    """The files of one subject of the catalogue."""
    from gainproof.generating import files_of_one

    return files_of_one(_subject(desk, name))


def print_file(_: Desk, path: str) -> dict[str, str]:
    """The files of the model of a user's file, which is executed."""
    from gainproof.generating import files_of_one
    from gainproof.model_file import build_model_file

    return files_of_one(build_model_file(path))


def recheck(_: Desk, certificate: Any, expected: Plain) -> Plain:
    """Check a certificate against what it is expected to prove. No SymPy in this process."""
    from gainproof.rechecking import recheck as decide

    return decide(certificate, expected)


def judge(
    desk: Desk,
    path: str,
    text: str,
    models: list[Plain],
    seconds: float,
    processes: int,
    only: str | None = None,
) -> Plain:
    """Judge a claim file of this text, or only one claim of it, given the catalogue's models;
    `path` is for messages.
    """
    from gainproof.judging import judge_text
    from gainproof.verify.judge.worker import Workers

    # children that judge stay for the next file: what they keep they keep by its whole content
    key = ("workers", json.dumps(models, sort_keys=True), seconds, processes)
    judges = desk.opened(key, lambda: Workers(models, seconds, processes))
    return judge_text(path, text, models, judges, desk.tell, only)


def _subject(desk: Desk, name: str) -> Subject:
    """A subject of the catalogue, derived once in a process."""
    from gainproof.deriving import build

    return desk.kept(("subject", name), lambda: build(name))


TASKS: Mapping[str, Callable[..., Any]] = {
    "catalogue": catalogue,
    "overview": overview,
    "derive": derive,
    "everything": everything,
    "derive_file": derive_file,
    "print_all": print_all,
    "print_one": print_one,
    "print_file": print_file,
    "recheck": recheck,
    "judge": judge,
}
