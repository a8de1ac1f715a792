"""A user's own model: a Python file that defines MODEL. Importing this module imports SymPy."""

from __future__ import annotations

import runpy
import traceback
from dataclasses import replace
from importlib import metadata
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.derive.model import Model, ModelError
from gainproof.derive.own_model.choice import derive_own_model
from gainproof.derive.subject import Subject

VARIABLE = "MODEL"


def build_model_file(path: str) -> Subject:
    """Execute the file and derive its model. Raises BadInputError, with the line where known."""
    model = read_model(path)
    try:
        subject = derive_own_model(model)
    except ModelError as error:
        raise BadInputError(f"{path}: {error}") from None
    # the catalogue knows nothing of this subject: its commands take the file
    file = Path(path).name
    module = replace(
        subject.module,
        command=f"gainproof generate {file} --out DIR",
        derivation=f"gainproof derive {file}, SymPy {metadata.version('sympy')}",
    )
    return replace(subject, module=module)


def read_model(path: str) -> Model:
    """The model that a file defines under the name MODEL."""
    try:
        names = runpy.run_path(path)
    except (Exception, SystemExit) as error:  # noqa: BLE001 (whatever the user's code raises is bad input)
        raise BadInputError(f"{_place(path, error)}: {type(error).__name__}: {error}") from None
    if VARIABLE not in names:
        raise BadInputError(f"{path}: wanted a variable {VARIABLE}, the file defines none")
    model = names[VARIABLE]
    if not isinstance(model, Model):
        raise BadInputError(
            f"{path}: {VARIABLE} should be a gainproof.derive.model.Model, "
            f"it is {type(model).__name__}"
        )
    return model


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
