"""A digest of the code and versions that results depend on: part of every key of the cache."""

from __future__ import annotations

import hashlib
import platform
from collections.abc import Iterable
from importlib import metadata
from pathlib import Path

from gainproof.places import package_folder
from gainproof.version import VERSION

PACKAGES = ("sympy", "numpy", "mpmath", "python-flint", "lark")


def of_everything() -> str:
    """Digest of the code of derive, verify and the front door, and of all versions."""
    front = Path(__file__).resolve().parent
    parts = [
        of_files(package_folder("derive"), package_folder("derive").rglob("*.py")),
        of_files(package_folder("verify"), package_folder("verify").rglob("*.py")),
        of_files(front, front.glob("*.py")),
        *(f"{name} {version}" for name, version in versions().items()),
    ]
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()


def of_files(folder: Path, paths: Iterable[Path]) -> str:
    """Digest of the source files among the paths, by name and content."""
    digest = hashlib.sha256()
    named = {str(path): path for path in paths if path.suffix == ".py" and path.is_file()}
    for path in (named[name] for name in sorted(named)):
        content = path.read_bytes()
        name = path.relative_to(folder).as_posix()
        digest.update(f"{name} {len(content)}\n".encode() + content)
    return digest.hexdigest()


def versions() -> dict[str, str]:
    """Versions of Python, of gainproof and of the packages that results depend on."""
    found = {"gainproof": VERSION, "python": platform.python_version()}
    for package in PACKAGES:
        try:
            found[package] = metadata.version(package)
        except metadata.PackageNotFoundError:
            found[package] = "absent"
    return found
