"""What `.ci/run` tests thoroughly: the rooms of what differs from the parent commit."""

from __future__ import annotations

import runpy
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / ".ci" / "changed.py"
FOUND = runpy.run_path(str(SCRIPT))


@pytest.mark.parametrize(
    ("changed", "folder"),
    [
        ("verify/judge/cells/forms.py", "tests/verify/judge/cells"),
        ("verify/judge/exact/box.py", "tests/verify/judge"),  # a room without tests of its own
        ("verify/claims/outside/suzuki.toml", "tests/verify"),
        ("derive/catalogue.py", "tests/derive"),
        ("derive/printer/c_language/module.py", "tests/derive/printer"),
        ("generated/bounds.json", "tests/generated"),
        ("src/gainproof/jobs/workers.py", "tests/front"),
        ("src/gainproof/cli.py", "tests/front"),
        ("src/gainproof/book/play/fragment.py", "tests/book/play"),
        ("tests/front/test_cli.py", "tests/front"),
        ("tests/verify/judge/hostile/deep.toml", "tests/verify/judge"),
    ],
)
def test_a_file_has_the_nearest_folder_of_tests(changed: str, folder: str) -> None:
    assert FOUND["folders_of_tests"]([changed]) == [folder]


def test_what_lies_within_another_folder_is_not_said_twice() -> None:
    changed = ["verify/judge/cells/forms.py", "verify/judge/exact/box.py", "derive/catalogue.py"]
    assert FOUND["folders_of_tests"](changed) == ["tests/derive", "tests/verify/judge"]


@pytest.mark.parametrize("changed", ["README.md", "tests/support/samples.py", ".ci/run"])
def test_other_files_have_none(changed: str) -> None:
    assert FOUND["folders_of_tests"]([changed]) == []


def test_pages_are_what_a_reader_sees() -> None:
    for name in ("docs/design.md", "generated/_runtime.js", "src/gainproof/book/static/site.js"):
        assert FOUND["pages_changed"](["README.md", name])
    assert not FOUND["pages_changed"](["generated/bounds.json", "verify/judge/judge.py"])


@pytest.mark.parametrize("path", FOUND["PAGES"])
def test_where_pages_are_made_is_there(path: str) -> None:
    """A folder with another name would never be seen to change."""
    assert (SCRIPT.parents[1] / path).exists()


def test_it_is_asked_of_commits_and_of_the_tree(tmp_path: Path) -> None:
    """Without a repository or a parent nobody can tell: no room differs, and pages are tested."""

    def run(*command: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)

    def commit(name: str, text: str) -> None:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
        run("git", "add", ".")
        names = ("-c", "user.name=a", "-c", "user.email=a@b", "-c", "commit.gpgsign=false")
        assert run("git", *names, "commit", "-qm", "one").returncode == 0

    def folders() -> list[str]:
        return run(sys.executable, ".ci/changed.py").stdout.split()

    def pages() -> bool:
        return run(sys.executable, ".ci/changed.py", "--pages").returncode == 0

    (tmp_path / ".ci").mkdir()
    (tmp_path / ".ci" / "changed.py").write_text(SCRIPT.read_text())
    assert (folders(), pages()) == ([], True)
    run("git", "init", "-q")
    commit("tests/derive/test_a.py", "")
    assert (folders(), pages()) == ([], True)
    commit("derive/a.py", "x = 1\n")
    assert (folders(), pages()) == (["tests/derive"], False)
    commit("docs/a.md", "A page.\n")
    assert (folders(), pages()) == ([], True)
    commit("README.md", "Words.\n")
    assert (folders(), pages()) == ([], False)
    (tmp_path / "docs" / "a.md").write_text("Another.\n")
    assert pages()
    commit("docs/a.md", "Another.\n")
    commit("README.md", "More words.\n")
    (tmp_path / "docs" / "new.md").touch()
    assert pages()
