"""What there is, and what it rests on, as text."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError, unknown_name
from gainproof.files import input_file, places
from gainproof.subjects import derivations
from gainproof.terminal_text import WIDTH, filled
from gainproof.verify.judge.claim.file import (
    MOST_BYTES,
    ClaimFile,
    ClaimFileError,
    read_claim_text,
)

Subject = Mapping[str, Any]


def listing(columns: int = WIDTH) -> str:
    """Derivations with their kernels, works, claim files with their claims, in lines of at most
    `columns`.
    """
    subjects = derivations.outlines()
    parts = ["Derivations (gainproof derive NAME --steps) and their kernels", ""]
    for subject in subjects:
        parts += filled(f"{subject['name']}: {subject['title']}", "  ", "    ", columns=columns)
        modules = sorted({kernel["module"] for kernel in subject["kernels"]})
        parts += [f"      gainproof.generated.{name}" for name in modules]
        parts += filled(
            ", ".join(kernel["name"] for kernel in subject["kernels"]), "      ", columns=columns
        )
    parts += ["", "Works (gainproof cite NAME)", ""]
    for key, record in sorted(_works(subjects).items()):
        parts += filled(f"{key}: {record['text']}", "  ", columns=columns)
    parts += ["", "Claim files (gainproof check FILE)", ""]
    for file in _claim_files():
        parts += filled(
            f"{file.source.key}: {_authors(file)}: {file.source.title}", "  ", columns=columns
        )
        parts.append(f"      {_number_of_claims(file)} in {places.shown(file.path)}")
        parts += filled(", ".join(claim.id for claim in file.claims), "      ", columns=columns)
    return "\n".join(parts) + "\n"


def citation(name: str, columns: int = WIDTH) -> str:
    """What `name` rests on; a name that ends in .toml or has a folder before it is a claim file.
    Lines are of at most `columns`. Raises BadInputError with the nearest names.
    """
    if name.endswith(".toml") or Path(name).name != name:
        return _file_citation(_claim_file(Path(name)), columns)
    subjects = derivations.outlines()
    works, files = _works(subjects), {file.source.key: file for file in _claim_files()}
    resting = {subject["name"]: [subject] for subject in subjects}
    for subject in subjects:
        for kernel in subject["kernels"]:
            full = f"{kernel['module']}.{kernel['name']}"
            resting[full] = [subject]
            resting.setdefault(kernel["name"], []).append(subject)
    if name in resting:
        return "\n".join(_subject_citation(subject, columns) for subject in resting[name])
    found = [_work_citation(works[name], subjects, columns)] if name in works else []
    found += [_file_citation(files[name], columns)] if name in files else []
    if not found:
        raise unknown_name(
            "derivation, kernel, work or claim file", name, [*resting, *works, *files]
        )
    return "\n".join(found)


def _subject_citation(subject: Subject, columns: int) -> str:
    lines = [*filled(f"{subject['name']}: {subject['title']}", columns=columns), ""]
    if not subject["sources"]:
        lines.append("  rests on no published work")
    for source in subject["sources"]:
        lines += filled(source["text"], "  ", columns=columns)
        lines += filled(f"for: {source['rests_on']}", "      ", columns=columns)
    if subject["cited"]:
        lines += ["", "  Used and not proved here:"]
        for theorem in subject["cited"]:
            lines += filled(
                f"{theorem['theorem']} ({theorem['reference']})", "      ", columns=columns
            )
    return "\n".join(lines) + "\n"


def _work_citation(record: Mapping[str, str], subjects: Iterable[Subject], columns: int) -> str:
    users = [d["name"] for d in subjects if any(s["key"] == record["key"] for s in d["sources"])]
    lines = [
        *filled(record["text"], "", columns=columns),
        *filled(f"for: {record['rests_on']}", "  ", columns=columns),
    ]
    return (
        "\n".join([*lines, *filled(f"used by: {', '.join(users)}", "  ", columns=columns)]) + "\n"
    )


def _file_citation(file: ClaimFile, columns: int) -> str:
    source = file.source
    year = f", {source.year}" if source.year else ""
    lines = filled(
        f"{_authors(file)}: {source.title}. {source.publication}{year}.", "", columns=columns
    )
    found = ("doi", source.doi), ("url", source.url), ("repository", source.repository)
    for label, value in (*found, ("commit", source.commit), ("note", source.note)):
        if value:
            lines += filled(f"{label}: {value}", "  ", "    ", columns=columns)
    lines.append(f"  {_number_of_claims(file)} in {places.shown(file.path)}")
    return "\n".join(lines) + "\n"


def _number_of_claims(file: ClaimFile) -> str:
    return f"{len(file.claims)} claim{'s' if len(file.claims) > 1 else ''}"


def _authors(file: ClaimFile) -> str:
    return ", ".join(file.source.authors)


def _works(subjects: Iterable[Subject]) -> dict[str, Mapping[str, str]]:
    return {source["key"]: source for subject in subjects for source in subject["sources"]}


def _claim_files() -> list[ClaimFile]:
    return [_claim_file(path) for path in places.claim_files()]


def _claim_file(path: Path) -> ClaimFile:
    try:
        return read_claim_text(input_file.text(path, MOST_BYTES), str(path))
    except ClaimFileError as error:
        raise BadInputError(str(error)) from None
