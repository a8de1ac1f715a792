"""What the page "Check a formula" runs on: Python under WebAssembly and the packages of the judge,
fetched once from the npm and Python registries by their own clients, and the judge itself.
"""

from __future__ import annotations

import hashlib
import io
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from gainproof.bad_input import BadInputError
from gainproof.files import atomic_file, places
from gainproof.jobs import cache, code_digest
from gainproof.subjects.derivations import OUTLINES

ENTRY = "gainproof.answers.in_page"
"""The module that the page asks."""
MOST_SECONDS = 900.0
_BEGINNING = (1980, 1, 1, 0, 0, 0)
"""The time of all files of an archive: the same files are the same bytes."""


class Part(NamedTuple):
    """A package: the file that its registry has, and the digest of that. `client` fetches it into
    the folder named last.
    """

    name: str
    version: str
    licence: str
    file: str
    sha256: str
    client: Sequence[str]


NPM = ("npm", "pack", "--ignore-scripts", "--pack-destination")
PIP = (
    *(sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary=:all:"),
    *("--implementation=cp", "--python-version=3.14", "--abi=cp314"),
    *("--platform=pyemscripten_2026_0_wasm32", "--dest"),
)
PARTS = (
    Part(
        "pyodide",
        "314.0.7",
        "MPL-2.0; Python 3.14 in it PSF-2.0",
        "pyodide-314.0.7.tgz",
        "66b7949e5a0cba2250b586d7e368bf12fb482800748d182c4618254b685ffaa0",
        NPM,
    ),
    Part(
        "python-flint",
        "0.9.0",
        "MIT; FLINT, GMP and MPFR in it LGPL-3.0-or-later",
        "python_flint-0.9.0-cp314-cp314-pyemscripten_2026_0_wasm32.whl",
        "b31f5c00e0e36040ab58d00b3025156e20869b990d776e4bf90f870b1ee11ad3",
        PIP,
    ),
    Part(
        "lark",
        "1.3.1",
        "MIT",
        "lark-1.3.1-py3-none-any.whl",
        "c629b661023a014c37da873b4ff58a817398d12635d3bbb2c5a03be7fe5d1e12",
        PIP,
    ),
    Part(
        "latex2mathml",
        "3.81.1",
        "MIT",
        "latex2mathml-3.81.1-py3-none-any.whl",
        "c337668441b71c819b6733905a8058ba9a9d767bae11a0c5fdacb3aff31361bd",
        PIP,
    ),
)
"""The wheel of python-flint is built for the Python and the binary interface of this Pyodide."""
PYODIDE = (
    *("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm"),
    *("pyodide-lock.json", "python_stdlib.zip"),
)


def runtime() -> dict[str, bytes]:
    """The files by name: those of the registries, from the cache where they are there already, and
    the judge. Raises BadInputError where one cannot be had.
    """
    pyodide, *wheels = ((part, _content(part)) for part in PARTS)
    found = {f"{part.name}.whl": content for part, content in wheels}
    with tarfile.open(fileobj=io.BytesIO(pyodide[1])) as archive:
        for name in PYODIDE:
            file = archive.extractfile(f"package/{name}")
            assert file is not None
            # there are hosts that do not know .mjs for a script
            found[name.replace(".mjs", ".js")] = file.read()
    return found | {"gainproof.whl": judge_archive()}


def judge_archive() -> bytes:
    """The modules that the page needs and the shipped models, as a package is installed."""
    files = {
        f"{name.replace('.', '/')}{'/__init__' if path.stem == '__init__' else ''}.py": path
        for name, path in code_digest.modules_below(ENTRY).items()
    }
    files["gainproof/__init__.py"] = places.package_folder("") / "__init__.py"
    files[f"gainproof/generated/{OUTLINES}"] = places.generated_folder() / OUTLINES
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w") as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(name, _BEGINNING)
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name].read_bytes(), compresslevel=9)
    return made.getvalue()


def _content(part: Part) -> bytes:
    """The file of a part, from the cache or fetched into it. Raises BadInputError."""
    kept = cache.default_folder() / "runtime" / part.file
    if kept.is_file() and _is_tried(part, content := kept.read_bytes()):
        return content
    with tempfile.TemporaryDirectory() as folder:
        wanted = f"{part.name}{'@' if part.client is NPM else '=='}{part.version}"
        why = _failure([*part.client, folder, wanted])
        fetched = Path(folder) / part.file
        if not why:
            why = "" if fetched.is_file() else f"the registry has no {part.file}"
        if not why:
            content = fetched.read_bytes()
            why = "" if _is_tried(part, content) else f"{part.file} has another content than before"
    if why:
        raise BadInputError(
            f"{part.name} {part.version}, which the page runs on, cannot be fetched: {why}\n"
            "Wanted are npm, pip and the network, once; `gainproof ask` and a book without "
            "--runtime do without."
        )
    kept.parent.mkdir(parents=True, exist_ok=True)
    atomic_file.write_bytes(kept, content)
    return content


def _is_tried(part: Part, content: bytes) -> bool:
    return hashlib.sha256(content).hexdigest() == part.sha256


def _failure(command: Sequence[str]) -> str:
    """Why a command failed, in words; empty where it did not."""
    program = shutil.which(command[0])
    if program is None:
        return f"there is no {command[0]} on the path"
    try:
        done = subprocess.run(
            [program, *command[1:]],
            capture_output=True,
            text=True,
            timeout=MOST_SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return f"{command[0]} did not end within {MOST_SECONDS:g} seconds"
    told = [line.strip() for line in done.stderr.splitlines() if line.strip()]
    # pip says "ERROR: ...", npm "npm error ..."
    errors = (
        [line for line in told if "error" in line.lower().split(":")[0]] or told or ["it failed"]
    )
    return errors[0] if done.returncode else ""
