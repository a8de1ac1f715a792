"""Generated files: made afresh by a worker process, and put in their place."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from gainproof.derive.printer.package import LIST, shared_files
from gainproof.files import atomic_file, places
from gainproof.jobs.session import Session
from gainproof.subjects import bounds_ledger, derivations
from gainproof.subjects.drift import Difference


def fresh(names: Sequence[str], session: Session) -> dict[str, bytes]:
    """Content by file name for the package's own folder: of everything where no names are given,
    else of these subjects, with the code that their kernels share with others.

    Raises BadInputError.
    """
    derivations.require_names(names)
    chosen = names or derivations.catalogue()
    folder = places.generated_folder()
    known = bounds_ledger.usable(folder, session.cache.fresh)
    parts = session.results("printed", [derivations.print_job(name, known) for name in chosen])
    files = together(parts)
    ledger = bounds_ledger.joined(parts, folder, whole=not names)
    files[bounds_ledger.NAME] = ledger.encode("utf-8")
    if names:
        return {name: content for name, content in files.items() if name != LIST}
    outlines = session.results("", [derivations.outline_job(name) for name in chosen])
    return files | {derivations.OUTLINES: derivations.outlines_file(outlines)}


def together(parts: Sequence[Mapping[str, Any]]) -> dict[str, bytes]:
    """The whole folder from what each subject gives to it: {"module", "title", "files"}.

    Raises ValueError for a file of several subjects who do not agree on it.
    """
    modules = [part for part in parts if f"{part['module']}.py" in part["files"]]
    files = shared_files({part["module"]: part["title"] for part in modules})
    for part in parts:
        for name, text in part["files"].items():
            if files.setdefault(name, text) != text:
                raise ValueError(f"{part['module']}: its {name} differs from that of another")
    return {name: text.encode("utf-8") for name, text in files.items()}


def put(files: Mapping[str, bytes], differences: Iterable[Difference], folder: Path) -> int:
    """Mend the differences: write what is missing or different, delete what is stale. How many."""
    count = 0
    for difference in differences:
        if difference.kind == "stale":
            (folder / difference.name).unlink(missing_ok=True)
        else:
            atomic_file.write_bytes(folder / difference.name, files[difference.name])
        count += 1
    return count
