"""Derived subjects for whoever asks, each from a worker process or the cache."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError, unknown_name
from gainproof.derive.catalogue import CATALOGUE
from gainproof.files import input_file, places
from gainproof.files.json_lines import in_lines
from gainproof.jobs import workers
from gainproof.jobs.cache import Cache
from gainproof.jobs.session import Session
from gainproof.subjects.derived import Derived, derived_from
from gainproof.subjects.drift import CURE
from gainproof.subjects.rechecking import expected_of

MOST_BYTES = 2**20
"""Of a model file."""
OUTLINES = "catalogue.json"
"""The shipped file on all subjects, beside the kernels."""
_LISTS = {
    "sources": ("key", "text", "rests_on"),
    "kernels": ("name", "summary", "module", "programs"),
    "cited": (),
}
"""Of an outline: lists of records, and what each record has."""


def catalogue() -> list[str]:
    """Names of all subjects, in the order of the catalogue."""
    return [entry.name for entry in CATALOGUE]


def outlines() -> list[dict[str, Any]]:
    """{"name", "title", "model", "sources", "kernels", "cited"} of every subject, as shipped: data
    that `gainproof run` compares with what is derived.

    Raises BadInputError where the file is missing or damaged.
    """
    path = places.generated_folder() / OUTLINES
    try:
        found = json.loads(path.read_text(encoding="utf-8"))["subjects"]
        if [entry["name"] for entry in found] == catalogue() and all(map(_is_outline, found)):
            return list(found)
    except (OSError, ValueError, KeyError, TypeError, RecursionError):
        pass
    raise BadInputError(f"{places.shown(path)}: missing or damaged; {CURE}")


def _is_outline(entry: Any) -> bool:
    """Whether a subject of the shipped file has what is asked of it. KeyError or TypeError for much
    that has not.
    """
    model = entry["model"]
    return (
        isinstance(entry["title"], str)
        and (model is None or isinstance(model["name"], str))
        and all(
            isinstance(entry[name], list) and all({*wanted} <= {*record} for record in entry[name])
            for name, wanted in _LISTS.items()
        )
    )


def outlines_file(subjects: Sequence[dict[str, Any]]) -> bytes:
    """The text of the shipped file, a line for each entry of a subject."""
    return (in_lines({"subjects": list(subjects)}, 3) + "\n").encode("utf-8")


def derive(names: Sequence[str], session: Session) -> list[Derived]:
    """The subjects of these names. Raises BadInputError for a name the catalogue does not have."""
    require_names(names)
    jobs = [workers.Job(name, "derive", {"name": name}) for name in names]
    return [derived_from(data) for data in session.results("derived", jobs)]


def everything_job(name: str, bounds: Mapping[str, Any]) -> workers.Job:
    """All that is to be known of one subject, made in one go; `bounds` as for `print_job`."""
    deriving = workers.Job(name, "derive", {"name": name})
    printing = print_job(name, bounds)
    answers = (outline_job(name), deriving, printing)
    return workers.Job(name, "everything", printing.arguments, answers=answers)


def outline_job(name: str) -> workers.Job:
    """One subject without its certificate."""
    return workers.Job(name, "outline", {"name": name})


def print_job(name: str, bounds: Mapping[str, Any]) -> workers.Job:
    """The files of one subject; `bounds` are entries of the ledger by module, which may be taken.

    What a subject's own entries say is part of the job, so that a result that was made with others
    is not found for it.
    """
    arguments = {"name": name, "bounds": bounds.get(module_of(name), {})}
    return workers.Job(name, "print_one", arguments)


def module_of(name: str) -> str:
    """The module that holds a subject's kernels."""
    return name.replace("-", "_")


def known(name: str, session: Session) -> Derived:
    """A subject of the catalogue, and nobody is told that it was unchanged."""
    (found,) = session.results("", [workers.Job(name, "derive", {"name": name})])
    return derived_from(found)


def require_names(names: Sequence[str]) -> None:
    """Raises BadInputError, with the nearest names, for a name the catalogue does not have."""
    known = catalogue()
    for name in names:
        _refuse_claims(name)
        if name not in known:
            raise unknown_name("derivation", name, known)


def derive_file(path: Path, session: Session) -> Derived:
    """The subject of a user's model file, which is executed. Raises BadInputError."""
    (found,) = session.results("derived", [file_job("derive_file", path, session.cache)])
    return derived_from(found)


def file_job(task: str, path: Path, cache: Cache) -> workers.Job:
    """A task on a model file, which is executed: what comes of it is kept by what it defines.

    Raises BadInputError where it cannot be read, and for a claim file, which nobody means to have
    executed.
    """
    _refuse_claims(str(path))
    input_file.content(path, MOST_BYTES)
    also = {"cache": str(cache.folder.absolute()), "fresh": cache.fresh}
    return workers.Job(str(path), task, {"path": str(path.resolve())}, also, kept=False)


def _refuse_claims(name: str) -> None:
    if name.endswith(".toml"):
        raise BadInputError(f"{name}: a claim file holds no derivation: gainproof check {name}")


def one(name_or_file: str, session: Session) -> Derived:
    """A subject by name, or that of a model file: what ends in .py or has a folder before it."""
    if is_file(name_or_file):
        return derive_file(Path(name_or_file), session)
    (found,) = derive([name_or_file], session)
    return found


def is_file(name_or_file: str) -> bool:
    """Whether the user means a file."""
    return name_or_file.endswith(".py") or Path(name_or_file).name != name_or_file


def recheck(pairs: Sequence[tuple[Any, Derived]], session: Session) -> list[dict[str, Any]]:
    """Reports on certificates (parsed JSON), each against what its subject is expected to prove."""
    return session.results("certificate checked", [recheck_job(*pair) for pair in pairs])


def recheck_job(certificate: Any, derived: Derived) -> workers.Job:
    """The check of one certificate (parsed JSON)."""
    arguments = {"certificate": certificate, "expected": expected_of(derived)}
    return workers.Job(derived.name, "recheck", arguments)


def own_report(derived: Derived, session: Session) -> dict[str, Any]:
    """The checker's report on the certificate that the derivation has just written."""
    (report,) = recheck([(derived.certificate, derived)], session)
    return dict(report)


def require_accepted(chosen: Sequence[str], derived: Sequence[Derived], session: Session) -> None:
    """Raises BadInputError, with the name as it was chosen and the checker's reason, for the first
    derivation whose certificate the checker does not accept.
    """
    pairs = [(each.certificate, each) for each in derived]
    for name, report in zip(chosen, recheck(pairs, session), strict=True):
        if not report["accepted"]:
            said = "the checker rejects the derivation, nothing is written"
            if report["given_up"]:
                said = (
                    "the derivation is too long for the checker, nothing is written; write the "
                    "numbers of the model with fewer digits"
                )
            raise BadInputError(f"{name}: {said}: {report['reason']}")
