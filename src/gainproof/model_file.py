"""A user's own model: a Python file that defines MODEL. Importing this module imports SymPy."""

from __future__ import annotations

import runpy
import traceback
from dataclasses import replace
from importlib import metadata
from pathlib import Path

from gainproof.bad_input import BadInputError
from gainproof.derive.model import Model, ModelError, scale
from gainproof.derive.steady_state.two_state import derive_two_state
from gainproof.derive.subject import Subject

VARIABLE = "MODEL"
COVERED = {
    "transition": [["1", "1"], ["0", "1"]],
    "measurement": [["1", "0"]],
    "measurement_noise": [["1"]],
}
"""What the method for two states covers; only the process noise is free."""


def build_model_file(path: str) -> Subject:
    """Execute the file and derive its model. Raises BadInputError, with the line where known."""
    model = read_model(path)
    try:
        data = scale(model).data()
        wrong = [name for name, wanted in COVERED.items() if data[name] != wanted]
        if wrong:
            found = "; ".join(f"{name} = {data[name]}" for name in wrong)
            raise BadInputError(
                f"{path}: position and velocity with the position measured are wanted; in units "
                f"T = 1 and sigma_v = 1 that is {COVERED}, here {found}"
            )
        subject = derive_two_state(model, ())
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
