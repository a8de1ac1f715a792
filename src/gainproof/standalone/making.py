"""The files of a package from names of the catalogue and files of the user's own."""

from __future__ import annotations

import keyword
import os
import sys
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.files import places
from gainproof.jobs import workers
from gainproof.jobs.session import Session
from gainproof.standalone.files import TARGETS, folder_of, package_files
from gainproof.subjects import bounds_ledger, chosen_kernels, derivations
from gainproof.subjects.derived import derived_from

TAKEN = frozenset(
    {*sys.stdlib_module_names, "gainproof", "jax", "mpmath", "numpy", "pytest", "tests"}
)
"""Names under which nothing else could be imported any more, or that a package itself uses."""


@dataclass(frozen=True)
class Remark:
    """What is to be said of a part: what it leaves out, or what an output may lose. `refused`: so
    much that it is not written unasked; `where`: the inputs at which it is so much.
    """

    text: str
    refused: bool
    where: str


@dataclass(frozen=True)
class Package:
    """Content by file name, what is to be said of it, and the command that makes it."""

    files: Mapping[str, bytes]
    remarks: Sequence[Remark]
    command: str


def fresh(
    subjects: Sequence[str],
    session: Session,
    folder: Path,
    targets: Sequence[str] = (),
    kernels: Sequence[str] = (),
    only: str = "",
) -> Package:
    """The package; no subjects are all of the catalogue, no `kernels` all of them, `targets` what
    there is besides NumPy modules, `only` the one format that is wanted. Raises
    BadInputError, also for a derivation that the checker rejects.
    """
    name = package_name(folder)
    places.require_folder(folder)
    chosen = list(subjects) or derivations.catalogue()
    derivations.require_names([each for each in chosen if not derivations.is_file(each)])
    found = _packaged(chosen, session, {"kernels": list(kernels), "only": only})
    if not subjects:
        chosen = [x for x, each in zip(chosen, found, strict=True) if each["part"]["kernels"]]
        found = [each for each in found if each["part"]["kernels"]]
    chosen_kernels.require_found(chosen, [each["part"] for each in found], kernels)
    derived = [derived_from(each["derived"]) for each in found]
    derivations.require_accepted(chosen, derived, session)
    parts = [_aimed(each["part"], targets) for each in found]
    _require_apart(chosen, parts)
    remarks = [Remark(**each) for part in parts for each in part["remarks"]]
    line = command(subjects, name, targets, chosen_kernels.options(kernels, only))
    if any(remark.refused for remark in remarks):
        line += " --allow-loss"
    files = package_files(parts, name, line, needed_only=bool(kernels or only))
    return Package(files, remarks, line)


def _aimed(part: dict[str, Any], targets: Sequence[str]) -> dict[str, Any]:
    """Without what is only for targets that are not wanted."""
    others = tuple(f"{folder_of(each)}/" for each in TARGETS if each not in targets)
    files = {name: text for name, text in part["files"].items() if not name.startswith(others)}
    return {**part, "files": files}


def package_name(folder: Path) -> str:
    """The name under which a folder is imported. Raises BadInputError for one that cannot be."""
    name = Path(os.path.abspath(folder)).name
    if not name.isidentifier() or keyword.iskeyword(name) or name in TAKEN:
        why = "the name of another package" if name in TAKEN else "no name in Python"
        raise BadInputError(f"--out is to be a package that can be imported; {name!r} is {why}")
    return name


def command(
    subjects: Sequence[str], name: str, targets: Sequence[str] = (), options: str = ""
) -> str:
    """The command that makes the package, wherever its files lie."""
    words = [Path(s).name if derivations.is_file(s) else s for s in subjects]
    aims = [word for target in targets for word in ("--target", target)]
    return " ".join(["gainproof generate", *words]) + " ".join([options, "--out", name, *aims])


def _packaged(
    chosen: Sequence[str], session: Session, wanted: Mapping[str, Any]
) -> list[dict[str, Any]]:
    """Each subject derived, with its part of the package, of which so much is `wanted`."""
    jobs = []
    known = bounds_ledger.usable(places.generated_folder(), session.cache.fresh)
    for subject in chosen:
        if derivations.is_file(subject):
            job = derivations.file_job("package_file", Path(subject), session.cache)
            jobs.append(replace(job, arguments={**job.arguments, **wanted}))
        else:
            arguments = {**derivations.print_job(subject, known).arguments, **wanted}
            jobs.append(workers.Job(subject, "package_one", arguments))
    return session.results("derived and printed", jobs)


def _require_apart(chosen: Sequence[str], parts: Sequence[dict[str, Any]]) -> None:
    """That each module has a name of its own, and none that of the tests."""
    names = [str(part["module"]) for part in parts]
    for subject, name in zip(chosen, names, strict=True):
        if Counter(names)[name] > 1:
            raise BadInputError(f"{subject}: another one makes a module {name} too")
        if name in ("array_api", "compile", "jax", "readme", "tests"):
            raise BadInputError(f"{subject}: a module of a package cannot be called {name}")
