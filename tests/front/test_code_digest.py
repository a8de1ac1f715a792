"""The digest of a stage covers what its modules import, and nothing else."""

from __future__ import annotations

import ast
import shutil
from pathlib import Path

import pytest
from one_of_each import cases

from gainproof.derive.catalogue import CATALOGUE
from gainproof.files import places
from gainproof.jobs import code_digest, tasks
from gainproof.jobs.code_digest import imports_of, modules_below, of_modules

HOUSE = sorted(
    path
    for folder in (
        places.package_folder("derive"),
        places.package_folder("verify"),
        places.package_folder(""),
    )
    for path in folder.rglob("*.py")
)


@pytest.mark.parametrize("part", cases(range(4), lambda part: part == 0))
def test_imports_are_those_of_the_syntax_tree(part: int) -> None:
    """An import that the text search misses would leave a stale result in the cache."""
    for path in HOUSE[part::4]:
        assert _imports_by_syntax(path) <= set(imports_of(path)), path


@pytest.mark.parametrize(
    "text",
    [
        "from gainproof.verify.judge import (\n    task,  # a (b)\n    trial,\n)",
        "from gainproof.verify.judge import (  # noqa: (x)\n    trial as tried,\n)",
        "from gainproof.verify.judge import task, \\\n    trial",
        "from \\\n    gainproof.verify.judge import trial",
        "from  gainproof.verify.judge\timport(trial)",
        "import os, gainproof.verify.judge.trial as tried",
        "import gainproof.verify.judge.task, gainproof.verify.judge.trial",
        "import os; from gainproof.verify.judge import trial; import sys",
        "if True: from gainproof.verify.judge import trial",
        "if TYPE_CHECKING:\n    import os\nelse:\n    from gainproof.verify.judge import trial",
    ],
)
def test_an_import_is_read_however_it_is_written(text: str, tmp_path: Path) -> None:
    path = tmp_path / "module.py"
    path.write_text(text)
    assert "gainproof.verify.judge.trial" in imports_of(path)


def test_a_module_that_is_imported_within_a_function_belongs_to_it() -> None:
    assert "gainproof.derive.catalogue" in modules_below("gainproof.jobs.tasks")


def test_the_face_of_the_package_is_no_part_of_a_result() -> None:
    """An edit of what `import gainproof` offers would have every bound proved anew."""
    assert "gainproof" not in modules_below("gainproof.subjects.generating")


def test_the_judge_does_not_depend_on_derivations_nor_a_derivation_on_the_judge() -> None:
    assert not [name for name in modules_below("gainproof.claims.judging") if ".derive." in name]
    assert not [
        name for name in modules_below("gainproof.derive.families.random_jerk") if ".verify" in name
    ]


def test_a_module_that_is_missing_is_an_error() -> None:
    with pytest.raises(LookupError, match="nowhere"):
        of_modules("gainproof.derive.nowhere")


def test_the_text_of_the_tasks_belongs_to_their_keys(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    copy = tmp_path / "tasks.py"
    shutil.copy(tasks.__file__, copy)
    monkeypatch.setattr(tasks, "__file__", str(copy))
    before = tasks.code_of("recheck", {})
    copy.write_text(copy.read_text() + "\n# changed\n")
    assert tasks.code_of("recheck", {}) != before


@pytest.mark.parametrize("task", ["outline", "derive", "print_one", "package_one", "picture"])
def test_the_subject_of_a_task_belongs_to_its_key(task: str) -> None:
    """No text of an import names it: without it the old derivation is taken after an edit."""
    field, home = ("module", "generated") if task == "picture" else ("name", "derive.families")
    one, other = (
        tasks.modules_of(task, {field: name if field == "module" else name.replace("_", "-")})
        for name in ("random_jerk", "random_velocity")
    )
    assert f"gainproof.{home}.random_jerk" in set(one) - set(other)
    assert f"gainproof.{home}.random_velocity" in set(other) - set(one)


@pytest.mark.parametrize("task", ["derive_file", "package_file"])
def test_what_a_file_of_a_user_may_import_belongs_to_its_key(task: str) -> None:
    named = tasks.modules_of(task, {})
    for module in ("families.random_jerk", "own_model.choice", "printer.adjoint"):
        assert f"gainproof.derive.{module}" in named


@pytest.mark.parametrize("changed", ["verify/certificate/__init__.py", "subjects/choice_sides.py"])
def test_a_change_below_changes_the_digest(
    changed: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Also one of a file far below, and none of a file that is not imported."""
    shutil.copytree(places.package_folder(""), tmp_path, dirs_exist_ok=True, symlinks=True)
    for name in ("derive", "verify"):
        (tmp_path / name).unlink(missing_ok=True)
    shutil.copytree(places.package_folder("verify"), tmp_path / "verify")
    monkeypatch.setattr(code_digest, "package_folder", lambda name: tmp_path / name)
    before = _digest_anew()
    (tmp_path / "cli.py").write_text("# not imported\n")
    assert _digest_anew() == before
    assert code_digest.is_as_read("gainproof.subjects.rechecking")
    (tmp_path / changed).write_text((tmp_path / changed).read_text() + "\n# changed\n")
    assert not code_digest.is_as_read("gainproof.subjects.rechecking")
    assert _digest_anew() != before
    _forget()


def _digest_anew() -> str:
    _forget()
    return of_modules("gainproof.subjects.rechecking")


def _forget() -> None:
    """What was read of files that are changed now."""
    for each in ("of_modules", "imports_of", "_file", "_content", "_data_beside", "_stamp"):
        getattr(code_digest, each).cache_clear()


def _imports_by_syntax(path: Path) -> set[str]:
    """What a file imports of ours, but for checkers of types, by Python's own grammar."""
    found = set()
    tree = ast.parse(path.read_text(encoding="utf-8"))
    typing = [node for node in tree.body if isinstance(node, ast.If) and _is_for_types(node)]
    apart = {id(inner) for block in typing for inner in ast.walk(block)}
    for node in ast.walk(tree):
        if id(node) in apart:
            continue
        if isinstance(node, ast.ImportFrom):
            names = [node.module or "", *(f"{node.module}.{alias.name}" for alias in node.names)]
        elif isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        else:
            continue
        found |= {name for name in names if name.split(".")[0] == "gainproof" and _exists(name)}
    return found


def _exists(name: str) -> bool:
    parts = name.split(".")[1:]
    if parts and parts[0] in ("derive", "verify", "generated"):
        place = places.package_folder(parts[0]).joinpath(*parts[1:])
    else:
        place = Path(code_digest.__file__).parent.joinpath(*parts)
    return place.with_suffix(".py").is_file() or (place / "__init__.py").is_file()


def _is_for_types(node: ast.If) -> bool:
    return isinstance(node.test, ast.Name) and node.test.id == "TYPE_CHECKING"


SUBJECTS = [entry.name for entry in CATALOGUE]


@pytest.mark.alike
@pytest.mark.parametrize("name", SUBJECTS)
def test_each_page_that_is_read_belongs_to_the_key(
    name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A page that is read and not in the key would leave a stale derivation in the cache."""
    (entry,) = (each for each in CATALOGUE if each.name == name)
    read: set[Path] = set()
    plain = Path.read_text

    def noted(path: Path, encoding: str | None = None) -> str:
        read.add(path)
        return plain(path, encoding)

    monkeypatch.setattr(Path, "read_text", noted)
    entry.build()
    pages = {path.stem for path in read if path.suffix == ".md"}
    known = code_digest.pages_of(*tasks.modules_of("print_one", {"name": name}))
    assert pages <= known
    assert "interacting-gains" not in known or name == "interacting-gains"
