"""Digests of the code and the versions that a result depends on: part of every key of the cache.

What a module imports, directly or through others, is read off its text: nothing is imported for
it, so that a stage that is known costs no import of what it would need.
"""

from __future__ import annotations

import hashlib
import platform
import re
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from importlib import metadata
from pathlib import Path

from gainproof.files.places import package_folder
from gainproof.version import VERSION

PACKAGES = ("sympy", "numpy", "mpmath", "python-flint", "lark")
_NAME = "gainproof"
_IMPORT = re.compile(
    rf"(?:^|[;:])[ \t]*(?:from\s+({_NAME}[\w.]*)\s+import\b\s*(\([^)]*\)|[^\n;]*)"
    r"|import\s([^\n;]*))",
    re.MULTILINE,
)
_COMMENT = re.compile(r"#[^\n]*|\\\n")
"""Also a line's end that is none."""
_FOR_TYPES = re.compile(r"^if TYPE_CHECKING:.*\n(?:(?:[ \t]+.*)?\n)+", re.MULTILINE)
_PAGES = f"{_NAME}.derive.pages"
_FOLDERS = ("derive", "verify", "generated")


@cache
def of_modules(*names: str) -> str:
    """Digest of the files of modules and of all modules of ours that these import, also within
    functions, with the files of data beside them. Of pages (.md) those count that are named in a
    file that counts: an edit of one page makes anew what is derived from it and nothing else.

    `gainproof` itself does not count, which hands names on, and its folders do with their own text
    alone: what their functions import when somebody calls them is no part of a module below.

    Raises LookupError for a module that does not exist.
    """
    digest = hashlib.sha256()
    for name, path in _files_of(*names):
        content = _content(path)
        digest.update(f"{name} {path.name} {len(content)}\n".encode() + content)
    return digest.hexdigest()


def pages_of(*names: str) -> set[str]:
    """The names of the pages among these files. Raises LookupError for a missing module."""
    return {path.stem for _, path in _files_of(*names) if path.suffix == ".md"}


def _files_of(*names: str) -> list[tuple[str, Path]]:
    """The files that count, each with the module that it is or lies beside."""
    files = sorted(modules_below(*names).items())
    every = [(name, each) for name, path in files for each in (path, *_data_beside(path))]
    unnamed = _unnamed_pages([path for _, path in files], [path for _, path in every])
    return [(name, path) for name, path in every if path not in unnamed]


def is_as_read(*names: str) -> bool:
    """Whether the files of modules and of all that these import are as they were when they were
    read for a digest. Of what is edited while a process works nobody can say what it ran.
    """
    try:
        return all(_stamp(path) == _stamp_now(path) for path in modules_below(*names).values())
    except OSError:
        return False


def modules_in(folder: str) -> Iterator[str]:
    """The full names of all modules in a folder of ours, such as derive."""
    home = package_folder(folder)
    for path in home.rglob("*.py"):
        inner = path.relative_to(home).with_suffix("").as_posix().replace("/", ".")
        yield f"{_NAME}.{folder}.{inner}".removesuffix(".__init__")


def modules_below(*names: str) -> Mapping[str, Path]:
    """The files of modules and of all that they import, by full name. Raises LookupError."""
    found: dict[str, Path] = {}
    waiting = list(names)
    while waiting:
        name = waiting.pop()
        if name in found or name == _NAME:
            continue
        path = _file(name)
        if path is None:
            raise LookupError(f"no module {name}")
        found[name] = path
        parts = name.split(".")
        waiting += [".".join(parts[:end]) for end in range(2, len(parts))]
        waiting += imports_of(path)
    return found


@cache
def imports_of(path: Path) -> tuple[str, ...]:
    """The modules of ours that a file imports, wherever in it but for checkers of types alone."""
    found: set[str] = set()
    text = _FOR_TYPES.sub("", _COMMENT.sub(" ", _content(path).decode("utf-8")))
    for home, names, whole in _IMPORT.findall(text):
        words = [
            word.split()[0] for word in (names or whole).strip("()").split(",") if word.strip()
        ]
        found |= {home, *(f"{home}.{word}" for word in words)} if home else set(words)
    ours = (name for name in found if name.split(".")[0] == _NAME)
    return tuple(sorted(name for name in ours if _file(name) is not None))


def of_files(folder: Path, paths: Iterable[Path]) -> str:
    """Digest of the source files among the paths, by name and content."""
    digest = hashlib.sha256()
    named = {str(path): path for path in paths if path.suffix == ".py" and path.is_file()}
    for path in (named[name] for name in sorted(named)):
        content = path.read_bytes()
        name = path.relative_to(folder).as_posix()
        digest.update(f"{name} {len(content)}\n".encode() + content)
    return digest.hexdigest()


@cache
def versions() -> Mapping[str, str]:
    """Versions of Python, of gainproof and of the packages that results depend on."""
    found = {"gainproof": VERSION, "python": platform.python_version()}
    for package in PACKAGES:
        try:
            found[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            found[package] = "absent"
    return found


@cache
def _file(name: str) -> Path | None:
    """The file of a module or package of ours; None if there is none."""
    parts = name.split(".")[1:]
    if parts and parts[0] in _FOLDERS:
        place = package_folder(parts[0]).joinpath(*parts[1:])
    else:
        place = package_folder("").joinpath(*parts)
    for path in (place.with_name(f"{place.name}.py"), place / "__init__.py"):
        if path.is_file():
            return path
    return None


@cache
def _content(path: Path) -> bytes:
    _stamp(path)
    return path.read_bytes()


@cache
def _stamp(path: Path) -> tuple[int, int]:
    """That of the file when it was first read."""
    return _stamp_now(path)


def _stamp_now(path: Path) -> tuple[int, int]:
    found = path.stat()
    return found.st_mtime_ns, found.st_size


def _unnamed_pages(files: Iterable[Path], data: Iterable[Path]) -> set[Path]:
    """The pages among the data whose names stand in none of the files, nor on a page that does."""
    unnamed = {path for path in data if path.suffix == ".md"}
    waiting = list(files)
    while waiting and unnamed:
        named = _pages_named(waiting.pop())
        found = {page for page in unnamed if page.stem in named}
        unnamed -= found
        waiting += found
    return unnamed


@cache
def _pages_named(path: Path) -> frozenset[str]:
    """What a file may name pages by: texts in quotation marks in Python that imports what reads
    pages, parts on pages.
    """
    if path.suffix == ".py" and not any(_PAGES in name for name in imports_of(path)):
        return frozenset()
    text = _content(path).decode("utf-8")
    pattern = r"^include ([\w-]+)" if path.suffix == ".md" else r"""["']([\w-]+)(?:\.md)?["']"""
    return frozenset(re.findall(pattern, text, re.MULTILINE))


@cache
def _data_beside(path: Path) -> tuple[Path, ...]:
    """What lies in the folder of a package and is no Python, such as a script that is copied."""
    if path.name != "__init__.py":
        return ()
    return tuple(
        each
        for each in sorted(path.parent.iterdir())
        if each.is_file() and each.suffix not in (".py", ".pyc")
    )
