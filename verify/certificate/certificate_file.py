"""Reading certificate files: JSON without its ambiguities."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, NoReturn

from gainproof.verify.certificate.rejection import MalformedError

_MAXIMUM_BYTES = 20_000_000


def read_certificate(source: bytes | Path) -> dict[str, Any]:
    """The certificate in a file or in its bytes.

    Raises MalformedError if it is not a JSON record in UTF-8, gives a key twice, holds a number
    that is no integer, or is larger than any certificate; OSError if the file cannot be read.
    """
    content = source if isinstance(source, bytes) else _content(source)
    if len(content) > _MAXIMUM_BYTES:
        raise MalformedError(f"more than {_MAXIMUM_BYTES} bytes")
    try:
        value = json.loads(
            content.decode("utf-8"),
            object_pairs_hook=_unique,
            parse_float=_refuse,
            parse_constant=_refuse,
        )
    except (ValueError, RecursionError) as error:
        raise MalformedError(f"not readable as JSON: {type(error).__name__}") from None
    if not isinstance(value, dict):
        raise MalformedError("a JSON record is wanted")
    return value


def _content(path: Path) -> bytes:
    with path.open("rb") as file:
        return file.read(_MAXIMUM_BYTES + 1)


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    result: dict[str, Any] = {}
    for key, value in pairs:
        if key in result:
            raise MalformedError(f"the key {key[:60]!r} is given twice")
        result[key] = value
    return result


def _refuse(text: str) -> NoReturn:
    raise MalformedError(f"the number {text[:40]} is not an integer")
