"""Derived subjects for whoever asks, each from a worker process or the cache."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from gainproof import given_file, workers
from gainproof.bad_input import BadInputError, unknown_name
from gainproof.derived import Derived, derived_from
from gainproof.rechecking import expected_of
from gainproof.workshop import Workshop

MOST_BYTES = 2**20
"""Of a model file."""
CATALOGUE = workers.Job("the catalogue", "catalogue", {})


def catalogue(shop: Workshop) -> list[str]:
    """Names of all subjects, in the order of the catalogue."""
    (found,) = shop.results("", [CATALOGUE])
    return list(found)


def overview(shop: Workshop) -> list[dict[str, Any]]:
    """{"name", "title", "model", "sources", "kernels", "cited"} of every subject."""
    jobs = [workers.Job(name, "outline", {"name": name}) for name in catalogue(shop)]
    return shop.results("", jobs)


def derive(names: Sequence[str], shop: Workshop) -> list[Derived]:
    """The subjects of these names. Raises BadInputError for a name the catalogue does not have."""
    require_names(names, shop)
    jobs = [workers.Job(name, "derive", {"name": name}) for name in names]
    return [derived_from(data) for data in shop.results("derived", jobs)]


def everything_job(name: str, bounds: Mapping[str, Any]) -> workers.Job:
    """All that is to be known of one subject, made in one go; `bounds` as for `print_job`."""
    parts = tuple(workers.Job(name, task, {"name": name}) for task in ("outline", "derive"))
    printing = print_job(name, bounds)
    return workers.Job(name, "everything", printing.arguments, answers=(*parts, printing))


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


def known(name: str, shop: Workshop) -> Derived:
    """A subject of the catalogue, and nobody is told that it was unchanged."""
    (found,) = shop.results("", [workers.Job(name, "derive", {"name": name})])
    return derived_from(found)


def require_names(names: Sequence[str], shop: Workshop) -> None:
    """Raises BadInputError, with the nearest names, for a name the catalogue does not have."""
    known = catalogue(shop)
    for name in names:
        _refuse_claims(name)
        if name not in known:
            raise unknown_name("derivation", name, known)


def derive_file(path: Path, shop: Workshop) -> Derived:
    """The subject of a user's model file, which is executed. Raises BadInputError."""
    text = model_text(path)
    job = workers.Job(str(path), "derive_file", {"path": str(path.resolve())})
    (found,) = shop.results("derived", [job], text)
    return derived_from(found)


def model_text(path: Path) -> bytes:
    """The text of a model file. Raises BadInputError where it cannot be read, and for a claim file,
    which nobody means to have executed.
    """
    _refuse_claims(str(path))
    return given_file.content(path, MOST_BYTES)


def _refuse_claims(name: str) -> None:
    if name.endswith(".toml"):
        raise BadInputError(f"{name}: a claim file holds no derivation: gainproof check {name}")


def one(name_or_file: str, shop: Workshop) -> Derived:
    """A subject by name, or that of a model file: what ends in .py or has a folder before it."""
    if is_file(name_or_file):
        return derive_file(Path(name_or_file), shop)
    (found,) = derive([name_or_file], shop)
    return found


def is_file(name_or_file: str) -> bool:
    """Whether the user means a file."""
    return name_or_file.endswith(".py") or Path(name_or_file).name != name_or_file


def recheck(pairs: Sequence[tuple[Any, Derived]], shop: Workshop) -> list[dict[str, Any]]:
    """Reports on certificates (parsed JSON), each against what its subject is expected to prove."""
    return shop.results("certificate checked", [recheck_job(*pair) for pair in pairs])


def recheck_job(certificate: Any, derived: Derived) -> workers.Job:
    """The check of one certificate (parsed JSON)."""
    arguments = {"certificate": certificate, "expected": expected_of(derived)}
    return workers.Job(derived.name, "recheck", arguments)


def own_report(derived: Derived, shop: Workshop) -> dict[str, Any]:
    """The checker's report on the certificate that the derivation has just written."""
    (report,) = recheck([(derived.certificate, derived)], shop)
    return dict(report)
