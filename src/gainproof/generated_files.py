"""Generated files: made afresh by a worker process, and put in their place."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from gainproof import atomic_file, derivations, workers
from gainproof.bad_input import BadInputError
from gainproof.derive.printer.package import CODE, code_source, shared_files
from gainproof.drift import Difference
from gainproof.workshop import Workshop


def fresh(name_or_file: str | None, shop: Workshop, *, own: bool = True) -> dict[str, bytes]:
    """Content by file name, of everything or of one subject. Raises BadInputError.

    `own`: for the package's own folder, so with the code that one subject's kernels share with
    others; a folder elsewhere has none, kernels there import it from the installed package.
    """
    if name_or_file is None:
        names = derivations.catalogue(shop)
        jobs = [workers.Job(name, "print_one", {"name": name}) for name in names]
        return together(shop.results("printed", jobs))
    if derivations.is_file(name_or_file):
        path = Path(name_or_file)
        depends = [derivations.model_text(path)]
        _require_accepted(path, shop)
        job = workers.Job(name_or_file, "print_file", {"path": str(path.resolve())})
    else:
        derivations.require_names([name_or_file], shop)
        job, depends = workers.Job(name_or_file, "print_one", {"name": name_or_file}), []
    (found,) = shop.results("printed", [job], *depends)
    texts = {name: text for name, text in found["files"].items() if own or not name.startswith("_")}
    if own:
        texts |= {name: code_source(name) for name in CODE}
    return {name: text.encode("utf-8") for name, text in texts.items()}


def _require_accepted(path: Path, shop: Workshop) -> None:
    """Nobody else has checked a user's model: BadInputError unless every step of it is proved."""
    report = derivations.own_report(derivations.derive_file(path, shop), shop)
    if not report["accepted"]:
        raise BadInputError(
            f"{path}: the checker rejects the derivation, no kernel is written: {report['reason']}"
        )


def together(parts: Sequence[Mapping[str, Any]]) -> dict[str, bytes]:
    """The whole folder from what each subject gives to it: {"module", "title", "files"}.

    Raises ValueError for a file of several subjects who do not agree on it.
    """
    files = shared_files({part["module"]: part["title"] for part in parts})
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
