"""The subjects whose certificates and kernels are shipped: read, not derived."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.bad_input import unknown_name
from gainproof.files import places


@dataclass(frozen=True)
class Subject:
    """`name` as on the command line, the certificate (parsed JSON), the module's source.

    `only`: what is asked about, identifiers of statements or outputs as "kernel.output"; None: all.
    """

    name: str
    certificate: Mapping[str, Any]
    source: str
    only: frozenset[str] | None = None


def chosen(names: Sequence[str]) -> Iterator[Subject]:
    """These subjects, or all. Raises BadInputError for a name that is none, before the first."""
    files = {path.stem.replace("_", "-"): path for path in places.certificates()}
    for name in names:
        if name not in files:
            raise unknown_name("subject", name, files)
    return (
        Subject(name, json.loads(path.read_bytes()), path.with_suffix(".py").read_text("utf-8"))
        for name, path in files.items()
        if not names or name in names
    )
