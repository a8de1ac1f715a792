"""Which kernels of a subject are wanted, in which format: what `generate` is asked for."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.bad_input import BadInputError, unknown_name


def options(kernels: Sequence[str], only: str) -> str:
    """The options of the command that ask for them, with a space before each."""
    found = [f" --kernel {name}" for name in kernels]
    return "".join([*found, *([f" --format {only}"] if only else [])])


def require_found(
    subjects: Sequence[str], parts: Sequence[Mapping[str, Any]], kernels: Sequence[str]
) -> None:
    """Raises BadInputError for a kernel that no subject has, and for a subject without any.

    `parts` are those of the subjects: their "kernels" by name, and what is "left_out".
    """
    known = [name for part in parts for name in part["kernels"]]
    for name in kernels:
        if name not in known:
            error = unknown_name("kernel", name, known)
            said = " ".join([str(error), *(part["left_out"] for part in parts)]).strip()
            raise BadInputError(said)
    for subject, part in zip(subjects, parts, strict=True):
        if kernels and not set(kernels) & set(part["kernels"]):
            raise BadInputError(
                f"{subject}: has none of the kernels asked for; it has {', '.join(part['kernels'])}"
            )
