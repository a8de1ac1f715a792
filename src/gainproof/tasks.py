"""What worker processes do: functions of plain data, by name; what is heavy is imported inside.

Each gets the `Desk` of its process first.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from gainproof import code_digest
from gainproof.desk import Desk

if TYPE_CHECKING:  # importing it imports SymPy
    from gainproof.derive.subject import Subject

Plain = dict[str, Any]


def outline(desk: Desk, name: str) -> Plain:
    """One subject with its model, kernels and sources, without its certificate."""
    from gainproof.deriving import overview_of

    return overview_of(_subject(desk, name))


def derive(desk: Desk, name: str) -> Plain:
    """Derive one subject of the catalogue: `Derived` as plain data. SymPy is imported here."""
    from gainproof.deriving import plain_subject

    return desk.kept(("derived", name), lambda: plain_subject(_subject(desk, name)).plain())


def everything(desk: Desk, name: str, bounds: Plain) -> list[Plain]:
    """What the tasks on one subject of the catalogue answer, which share most of the work: its
    outline, itself derived, its files.
    """
    return [outline(desk, name), derive(desk, name), print_one(desk, name, bounds)]


def derive_file(_: Desk, path: str, cache: str | None = None, fresh: bool = False) -> Plain:
    """Derive what a user's file defines: `Derived` as plain data. The file is executed; what comes
    of what it defines is kept in the folder `cache`, and taken from there unless `fresh`.
    """
    from gainproof.deriving import plain_subject

    return _of_own_file("derive_file", path, cache, fresh, lambda own: plain_subject(own).plain())


def print_one(desk: Desk, name: str, bounds: Plain) -> Plain:
    """The files of one subject of the catalogue, with its bounds, of which those known ones are
    taken that still hold: {"module", "title", "files", "bounds", "counts"}.
    """
    from gainproof.generating import printed

    return printed(_subject(desk, name), derive(desk, name)["certificate"], bounds)


def package_one(desk: Desk, name: str, bounds: Plain) -> Plain:
    """One subject of the catalogue for a package of its own: {"derived", "part"}, of which the
    first is what `derive` answers, the second like what `print_one` does.
    """
    from gainproof.generating import packaged

    derived, subject = derive(desk, name), _subject(desk, name)
    return {"derived": derived, "part": packaged(subject, derived["certificate"], bounds)}


def package_file(_: Desk, path: str, cache: str | None = None, fresh: bool = False) -> Plain:
    """The same of what a user's file defines, kept like what `derive_file` answers."""
    from gainproof.deriving import plain_subject
    from gainproof.generating import packaged

    def both(subject: Subject) -> Plain:
        derived = plain_subject(subject).plain()
        part = packaged(subject, derived["certificate"], {}, own=True)
        return {"derived": derived, "part": part}

    return _of_own_file("package_file", path, cache, fresh, both)


def picture(_: Desk, module: str, kernel: Plain, graph: Plain) -> Plain:
    """Values and errors of a kernel at points of its domain, for pictures. No SymPy."""
    from gainproof.book.sampled_kernel import sampled

    return sampled(module, kernel, graph)


def recheck(_: Desk, certificate: Any, expected: Plain) -> Plain:
    """Check a certificate against what it is expected to prove. No SymPy in this process."""
    from gainproof.rechecking import recheck as decide

    return decide(certificate, expected)


def recheck_proofs(_: Desk, judgement: Plain) -> Plain:
    """Check the proofs on matrices of every size of a judged claim file once more."""
    from gainproof.claim_proofs import recheck as decide

    return decide(judgement)


def judge(
    desk: Desk,
    path: str,
    text: str,
    models: list[Plain],
    seconds: float,
    processes: int,
    only: str | None = None,
    keep_going: bool = False,
    cache: str | None = None,
    fresh: bool = False,
) -> Plain:
    """Judge a claim file of this text, or only one claim of it, given the catalogue's models;
    `path` is for messages. What is judged is kept in the folder `cache`, claim by claim, and taken
    from there unless `fresh`. With `keep_going` one with errors is judged as far as it can be.
    """
    from gainproof.cache import Cache
    from gainproof.judging import KeptTrials, judge_text
    from gainproof.verify.judge.worker import Workers

    # children that judge stay for the next file: what they keep they keep by its whole content
    key = ("workers", json.dumps(models, sort_keys=True), seconds, processes, cache, fresh)
    known = None if cache is None else KeptTrials(Cache(Path(cache), fresh))
    judges = desk.opened(key, lambda: Workers(models, seconds, processes, known))
    return judge_text(path, text, models, judges, desk.tell, only, keep_going=keep_going)


def _of_own_file(
    task: str, path: str, cache: str | None, fresh: bool, make: Callable[[Subject], Plain]
) -> Plain:
    """What is made of what a file defines, by the file's name, the value and the code."""
    from gainproof import own_file
    from gainproof.cache import Cache, key_of
    from gainproof.derive.definition_text import definition_text

    variable, value = own_file.defined(path)
    try:
        content = definition_text(value)
    except TypeError:
        content = None  # it holds code of the user's
    if cache is None or content is None:
        return make(own_file.built(path, variable, value))
    kept = Cache(Path(cache), fresh)
    versions = json.dumps(code_digest.versions())
    key = key_of(task, Path(path).name, code_of(task, {}), versions, variable, content)
    found: Plain | None = kept.load(key)
    if found is None:
        found = make(own_file.built(path, variable, value))
        if is_as_read(task, {}):
            kept.store(key, found)
    return found


def _subject(desk: Desk, name: str) -> Subject:
    """A subject of the catalogue, derived once in a process."""
    from gainproof.deriving import build

    return desk.kept(("subject", name), lambda: build(name))


TASKS: Mapping[str, Callable[..., Any]] = {
    "outline": outline,
    "derive": derive,
    "everything": everything,
    "derive_file": derive_file,
    "print_one": print_one,
    "package_one": package_one,
    "package_file": package_file,
    "picture": picture,
    "recheck": recheck,
    "recheck_proofs": recheck_proofs,
    "judge": judge,
}
DERIVING = frozenset(
    {
        *("outline", "derive", "everything", "derive_file"),
        *("print_one", "package_one", "package_file"),
    }
)
"""Tasks that import SymPy. The others are never done in a process in which one of these was."""

_CODE: Mapping[str, tuple[str, ...]] = {
    "outline": ("gainproof.deriving",),
    "derive": ("gainproof.deriving",),
    "derive_file": ("gainproof.deriving", "gainproof.own_file"),
    "print_one": ("gainproof.deriving", "gainproof.generating"),
    "package_one": ("gainproof.deriving", "gainproof.generating"),
    "package_file": ("gainproof.deriving", "gainproof.generating", "gainproof.own_file"),
    "picture": ("gainproof.book.sampled_kernel",),
    "recheck": ("gainproof.rechecking",),
    "recheck_proofs": ("gainproof.claim_proofs",),
    "judge": ("gainproof.judging",),
}
"""The modules that a task calls."""


def code_of(task: str, arguments: Mapping[str, Any]) -> str:
    """A digest of the code on which the answer of a task depends: of `modules_of`, and of the text
    of the tasks themselves, which together import everything.
    """
    here = Path(__file__)
    own = code_digest.of_files(here.parent, [here])
    return f"{own} {code_digest.of_modules(*modules_of(task, arguments))}"


def is_as_read(task: str, arguments: Mapping[str, Any]) -> bool:
    """Whether that code is what it was when its digest was taken."""
    return code_digest.is_as_read(*modules_of(task, arguments))


def modules_of(task: str, arguments: Mapping[str, Any]) -> tuple[str, ...]:
    """What a task calls, its subject, and all that a user's file may import of ours."""
    from gainproof.derive.catalogue import CATALOGUE

    modules = ("gainproof.desk", *_CODE[task])
    modules += tuple(entry.module for entry in CATALOGUE if entry.name == arguments.get("name"))
    if task == "picture":
        modules += (f"gainproof.generated.{arguments['module']}",)
    if "gainproof.own_file" in modules:
        modules += tuple(code_digest.modules_in("derive"))
    return modules
