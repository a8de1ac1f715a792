"""The files of generated/ made afresh. Importing this imports SymPy: worker processes do it."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.derive.printer.write import all_files
from gainproof.derive.subject import Subject


def files_of_one(subject: Subject) -> dict[str, str]:
    """Text of the kernels of one subject and of its certificate, by name.

    What all modules share is left out: kernels import it from the installed package.
    """
    return {name: text for name, text in files_of([subject]).items() if not name.startswith("_")}


def files_of(subjects: Sequence[Subject]) -> dict[str, str]:
    """Text of a whole folder with the kernels and certificates of these subjects."""
    made = all_files(
        tuple(subject.module for subject in subjects),
        {subject.module.name: subject.certificate() for subject in subjects},
    )
    return {name: content.decode("utf-8") for name, content in made.items()}
