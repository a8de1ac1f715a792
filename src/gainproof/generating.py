"""The files of generated/ made afresh. Importing this imports SymPy: worker processes do it."""

from __future__ import annotations

from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.printer.write import all_files
from gainproof.derive.subject import Subject


def catalogue_files() -> dict[str, str]:
    """Text of every file of generated/, by name."""
    return files_of([entry.build() for entry in CATALOGUE])


def files_of(subjects: list[Subject]) -> dict[str, str]:
    """Text of the files that these subjects make, by name."""
    made = all_files(
        tuple(subject.module for subject in subjects),
        {subject.module.name: subject.certificate() for subject in subjects},
    )
    return {name: content.decode("utf-8") for name, content in made.items()}
