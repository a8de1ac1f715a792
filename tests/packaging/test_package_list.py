"""The package list of pyproject.toml against the tree."""

from __future__ import annotations

import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = {
    "gainproof": ROOT / "src" / "gainproof",
    "gainproof.derive": ROOT / "derive",
    "gainproof.generated": ROOT / "generated",
    "gainproof.verify": ROOT / "verify",
}

PAGES = {"gainproof.docs": ROOT / "docs"}
"""Of these only the pages that lie in them are packed, and no code."""


def python_folders(name: str, folder: Path) -> dict[str, Path]:
    """Every folder with Python files under `folder`, by its import name, links not followed."""
    found = {}
    for path in sorted([folder, *(p for p in folder.rglob("*") if p.is_dir())]):
        inner = path.relative_to(folder).parts
        if any((folder / Path(*inner[: i + 1])).is_symlink() for i in range(len(inner))):
            continue
        if any(path.glob("*.py")):
            found[".".join([name, *inner])] = path
    return found


def every_python_folder() -> dict[str, Path]:
    return {
        k: v for name, folder in FOLDERS.items() for k, v in python_folders(name, folder).items()
    }


def settings() -> dict[str, object]:
    with (ROOT / "pyproject.toml").open("rb") as stream:
        table: dict[str, object] = tomllib.load(stream)["tool"]["setuptools"]
    return table


def test_list_is_complete() -> None:
    listed = settings()["packages"]
    wanted = sorted([*every_python_folder(), *PAGES])
    assert listed == wanted, "write this list under [tool.setuptools] packages in pyproject.toml"


def test_every_package_has_an_init_file() -> None:
    bare = [
        name for name, path in every_python_folder().items() if not (path / "__init__.py").exists()
    ]
    assert not bare, f"packages without __init__.py: {bare}"


def test_folders_of_the_build_are_those_of_the_tree() -> None:
    mapped = settings()["package-dir"]
    assert mapped == {
        name: path.relative_to(ROOT).as_posix() for name, path in {**FOLDERS, **PAGES}.items()
    }


def test_a_missing_package_is_noticed(tmp_path: Path) -> None:
    (tmp_path / "new_room").mkdir()
    (tmp_path / "new_room" / "__init__.py").touch()
    (tmp_path / "data_only").mkdir()
    (tmp_path / "data_only" / "x.toml").touch()
    assert list(python_folders("gainproof.derive", tmp_path)) == ["gainproof.derive.new_room"]
