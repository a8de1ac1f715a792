"""A user's own file, which defines a model or expressions. Importing this imports SymPy."""

from __future__ import annotations

import runpy
import traceback
from collections.abc import Callable, Mapping
from dataclasses import replace
from importlib import metadata
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.derive.model import Model, ModelError
from gainproof.derive.own_expressions.expressions import ExpressionError, ExpressionSet
from gainproof.derive.own_expressions.subject import derive_expressions
from gainproof.derive.own_model.choice import derive_own_model
from gainproof.derive.subject import Subject

KINDS: Mapping[str, tuple[type, Callable[[Any], Subject]]] = {
    "MODEL": (Model, derive_own_model),
    "EXPRESSIONS": (ExpressionSet, derive_expressions),
}
"""What a file may define: the name of the variable, its type, and what derives it."""


def build_own_file(path: str) -> Subject:
    """Execute the file and derive what it defines. Raises BadInputError, with the line where known.

    The file is the user's own code, which whoever names it chose to run.
    """
    variable, value = _defined(path)
    wanted, derive = KINDS[variable]
    if not isinstance(value, wanted):
        raise BadInputError(
            f"{path}: {variable} should be a {wanted.__module__}.{wanted.__name__}, "
            f"it is {type(value).__name__}"
        )
    try:
        subject = derive(value)
    except (ModelError, ExpressionError) as error:
        raise BadInputError(f"{path}: {error}") from None
    # the catalogue knows nothing of this subject: its commands take the file
    file = Path(path).name
    module = replace(
        subject.module,
        command=f"gainproof generate {file} --out DIR",
        derivation=f"gainproof derive {file}, SymPy {metadata.version('sympy')}",
    )
    return replace(subject, module=module)


def _defined(path: str) -> tuple[str, Any]:
    """The variable that a file defines, and its value."""
    try:
        names = runpy.run_path(path)
    except (Exception, SystemExit) as error:  # noqa: BLE001 (whatever the user's code raises is bad input)
        raise BadInputError(f"{_place(path, error)}: {type(error).__name__}: {error}") from None
    found = [variable for variable in KINDS if variable in names]
    if len(found) != 1:
        raise BadInputError(
            f"{path}: wanted a variable {' or '.join(KINDS)}, the file defines "
            f"{'both' if found else 'none'}"
        )
    return found[0], names[found[0]]


def _place(path: str, error: BaseException) -> str:
    """The file, and the last line of it that the error passed through."""
    lines = [
        entry.lineno
        for entry in traceback.extract_tb(error.__traceback__)
        if Path(entry.filename) == Path(path)
    ]
    if isinstance(error, SyntaxError) and error.lineno:
        lines.append(error.lineno)
    return f"{path}, line {lines[-1]}" if lines else path
