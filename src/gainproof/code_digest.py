"""A digest of the code and versions that results depend on: the key of the cache."""

from __future__ import annotations

import hashlib
import platform
from importlib import metadata
from pathlib import Path

from gainproof.version import VERSION

PACKAGES = ("sympy", "numpy", "mpmath", "python-flint", "lark")
SUFFIXES = frozenset({".py", ".lark"})


def of_folders(*folders: Path) -> str:
    """Digest of every source file under the folders, by path and content."""
    digest = hashlib.sha256()
    for folder in folders:
        for path in sorted(p for p in folder.rglob("*") if p.suffix in SUFFIXES and p.is_file()):
            content = path.read_bytes()
            name = f"{folder.name}/{path.relative_to(folder).as_posix()}"
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
