"""A user's own file, which defines a model or expressions. Importing this imports SymPy.

The file is executed whenever it is asked for: what it imports, opens, asks of the system or of its
environment nobody can list. What is kept is what comes of the value that it defines.
"""

from __future__ import annotations

import json
import runpy
import sys
import sysconfig
import traceback
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from importlib import metadata
from pathlib import Path
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.derive.definition_key import definition_text
from gainproof.derive.model import Model, ModelError
from gainproof.derive.own_expressions.expressions import ExpressionError, ExpressionSet
from gainproof.derive.own_expressions.subject import derive_expressions
from gainproof.derive.own_model.choice import derive_own_model
from gainproof.derive.subject import Subject
from gainproof.files.places import package_folder
from gainproof.jobs import code_digest
from gainproof.jobs.cache import Cache, key_of
from gainproof.jobs.tasks import code_of, is_as_read
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.generating import packaged

KINDS: Mapping[str, tuple[type, Callable[[Any], Subject]]] = {
    "MODEL": (Model, derive_own_model),
    "EXPRESSIONS": (ExpressionSet, derive_expressions),
}
"""What a file may define: the name of the variable, its type, and what derives it."""


INSTALLED = ("stdlib", "platstdlib", "purelib", "platlib")
"""Folders of Python and of packages, whose modules are the same for all files."""


def derive_file(path: str, cache: str | None = None, fresh: bool = False) -> dict[str, Any]:
    """Derive what a user's file defines: `Derived` as plain data. The file is executed; what comes
    of what it defines is kept in the folder `cache`, and taken from there unless `fresh`.
    """
    return kept_by_value("derive_file", path, cache, fresh, lambda own: plain_subject(own).plain())


def package_file(
    path: str,
    kernels: Sequence[str] = (),
    only: str = "",
    cache: str | None = None,
    fresh: bool = False,
) -> dict[str, Any]:
    """What `generating.package_one` gives, of what a user's file defines; kept as the answers of
    `derive_file` are.
    """

    def both(subject: Subject) -> dict[str, Any]:
        derived = plain_subject(subject).plain()
        part = packaged(subject, derived["certificate"], {}, kernels, only, own=True)
        return {"derived": derived, "part": part}

    return kept_by_value("package_file", path, cache, fresh, both, (*kernels, only))


def kept_by_value(
    task: str,
    path: str,
    cache: str | None,
    fresh: bool,
    make: Callable[[Subject], dict[str, Any]],
    asked: Sequence[str] = (),
) -> dict[str, Any]:
    """What is made of what a file defines: known by the file's name, the value and the code, and
    by what is `asked` of it.
    """
    variable, value = defined(path)
    try:
        content = definition_text(value)
    except TypeError:
        content = None  # it holds code of the user's
    if cache is None or content is None:
        return make(built(path, variable, value))
    kept = Cache(Path(cache), fresh)
    versions = json.dumps(code_digest.versions())
    key = key_of(task, Path(path).name, code_of(task, {}), versions, variable, content, *asked)
    found: dict[str, Any] | None = kept.load(key)
    if found is None:
        found = make(built(path, variable, value))
        if is_as_read(task, {}):
            kept.store(key, found)
    return found


def defined(path: str) -> tuple[str, Any]:
    """Execute the file: which of the `KINDS` it defines, and the value. Raises BadInputError, with
    the line where known.

    The file is the user's own code, which whoever names it chose to run.
    """
    with _modules_beside(path):
        variable, value = _defined(path)
    wanted, _ = KINDS[variable]
    if not isinstance(value, wanted):
        raise BadInputError(
            f"{path}: {variable} should be a {wanted.__module__}.{wanted.__name__}, "
            f"it is {type(value).__name__}"
        )
    return variable, value


def built(path: str, variable: str, value: Any) -> Subject:
    """What is derived of what a file defines. Raises BadInputError."""
    _, derive = KINDS[variable]
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


@contextmanager
def _modules_beside(path: str) -> Iterator[None]:
    """Modules are found beside the file too, after all others. Those outside of what is installed
    are forgotten at the end: the next file may mean another one by the same name.
    """
    folder = str(Path(path).parent)
    before, writes = set(sys.modules), sys.dont_write_bytecode
    sys.path.append(folder)
    # a compiled copy would stand for a module that is edited within the same second
    sys.dont_write_bytecode = True
    try:
        yield
    finally:
        sys.dont_write_bytecode = writes
        if folder in sys.path:
            sys.path.remove(folder)
        for name in set(sys.modules) - before:
            if not _is_installed(sys.modules[name]):
                del sys.modules[name]


def _is_installed(module: object) -> bool:
    """Whether a module comes with Python, a package or gainproof."""
    file = getattr(module, "__file__", None)
    # a package without a file of its own lies in folders
    places = [file] if file else [*getattr(module, "__path__", ())]
    ours = (package_folder(name) for name in ("", "derive", "verify", "generated"))
    homes = (*(Path(sysconfig.get_path(name)) for name in INSTALLED), *ours)
    return all(any(Path(place).is_relative_to(home) for home in homes) for place in places)


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
