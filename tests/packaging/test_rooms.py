"""The rooms of the front door build on each other: no circle of imports, also within functions."""

from __future__ import annotations

from collections.abc import Mapping
from graphlib import CycleError, TopologicalSorter

import pytest

from gainproof.files.places import package_folder
from gainproof.jobs.code_digest import imports_of

HOME = package_folder("")
OTHER = ("derive", "generated", "verify")
"""Folders with borders of their own (`test_borders.py`)."""


def _imports() -> dict[str, set[str]]:
    """The modules of the front door that each of them imports, but for those that hand names on."""
    files = {
        ".".join(("gainproof", *path.relative_to(HOME).with_suffix("").parts)): path
        for path in HOME.rglob("*.py")
        if path.relative_to(HOME).parts[0] not in OTHER and path.name != "__init__.py"
    }
    return {name: set(imports_of(path)) & set(files) - {name} for name, path in files.items()}


def _room(name: str) -> str:
    """The folder of a module, or the module itself if it lies in none."""
    return ".".join(name.split(".")[:2])


def _rooms(imports: Mapping[str, set[str]]) -> dict[str, set[str]]:
    found: dict[str, set[str]] = {}
    for name, others in imports.items():
        found.setdefault(_room(name), set()).update(
            {_room(other) for other in others} - {_room(name)}
        )
    return found


def test_no_files_and_no_rooms_import_each_other() -> None:
    imports = _imports()
    assert len(imports) > 300
    for graph in (imports, _rooms(imports)):
        assert len([*TopologicalSorter(graph).static_order()]) == len(graph)


def test_a_circle_of_rooms_without_one_of_files_is_found() -> None:
    imports = {"gainproof.a.x": {"gainproof.b.x"}, "gainproof.b.x": set[str]()}
    imports["gainproof.b.y"] = {"gainproof.a.x"}
    assert len([*TopologicalSorter(imports).static_order()]) == 3
    with pytest.raises(CycleError):
        TopologicalSorter(_rooms(imports)).prepare()
