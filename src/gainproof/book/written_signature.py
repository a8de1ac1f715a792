"""Signatures as they are written, for annotations that are text."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any


class _AsWritten(str):
    """Text that is shown without quotation marks; those of default values stay."""

    __slots__ = ()

    def __repr__(self) -> str:
        return str(self)


def written_signature(function: Callable[..., Any], *, returns: bool = True) -> str:
    """Arguments with annotations and defaults in parentheses, and what comes if `returns`."""
    found = inspect.signature(function)
    parameters = [
        each.replace(annotation=_shown(each.annotation)) for each in found.parameters.values()
    ]
    what = _shown(found.return_annotation) if returns else inspect.Signature.empty
    return str(found.replace(parameters=parameters, return_annotation=what))


def _shown(annotation: Any) -> Any:
    return _AsWritten(annotation) if isinstance(annotation, str) else annotation
