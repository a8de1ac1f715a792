"""What worker processes do: functions of plain data, by name; what is heavy is imported inside."""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from typing import Any

Plain = dict[str, Any]


def catalogue() -> list[str]:
    """Names of all subjects, in the order of the catalogue."""
    from gainproof.deriving import catalogue_names

    return catalogue_names()


def overview() -> list[Plain]:
    """Every subject with its kernels and sources, without certificates."""
    from gainproof.deriving import overview as describe

    return describe()


def derive(name: str) -> Plain:
    """Derive one subject of the catalogue: `Derived` as plain data. SymPy is imported here."""
    from gainproof.deriving import derive_subject

    return derive_subject(name).plain()


def derive_file(path: str) -> Plain:
    """Derive the model of a user's file: `Derived` as plain data. The file is executed."""
    from gainproof.deriving import plain_subject
    from gainproof.model_file import build_model_file

    return plain_subject(build_model_file(path)).plain()


def print_all() -> dict[str, str]:
    """Every file of generated/ by name."""
    from gainproof.generating import catalogue_files

    return catalogue_files()


def print_one(name: str) -> dict[str, str]:
    """The files of one subject of the catalogue."""
    from gainproof.deriving import build
    from gainproof.generating import files_of_one

    return files_of_one(build(name))


def print_file(path: str) -> dict[str, str]:
    """The files of the model of a user's file, which is executed."""
    from gainproof.generating import files_of_one
    from gainproof.model_file import build_model_file

    return files_of_one(build_model_file(path))


def recheck(certificate: Any, expected: Plain) -> Plain:
    """Check a certificate against what it is expected to prove. No SymPy in this process."""
    from gainproof.rechecking import recheck as decide

    return decide(certificate, expected)


def judge(path: str, text: str, models: list[Plain], seconds: float, processes: int) -> Plain:
    """Judge a claim file of this text, given the catalogue's models; `path` is for messages."""
    from gainproof.judging import judge_text
    from gainproof.workers import PROGRESS

    def tell(words: str) -> None:
        sys.stderr.write(f"{PROGRESS}{words}\n")
        sys.stderr.flush()

    return judge_text(path, text, models, seconds, processes, tell)


TASKS: Mapping[str, Callable[..., Any]] = {
    "catalogue": catalogue,
    "overview": overview,
    "derive": derive,
    "derive_file": derive_file,
    "print_all": print_all,
    "print_one": print_one,
    "print_file": print_file,
    "recheck": recheck,
    "judge": judge,
}
