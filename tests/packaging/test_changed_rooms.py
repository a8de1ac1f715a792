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


def test_it_is_asked_of_the_commit(tmp_path: Path) -> None:
    """In a house of two commits, and of one, which has no parent."""

    def run(*command: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)

    for name in (".ci/changed.py", "tests/derive/test_a.py", "derive/a.py", "docs/a.md"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(SCRIPT.read_text() if name.startswith(".ci") else "")
    commit = ("git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-qam", "one")
    asked = (sys.executable, ".ci/changed.py")
    run("git", "init", "-q")
    run("git", "add", ".")
    assert run(*commit).returncode == 0
    assert run(*asked).stdout.strip() == ""
    assert run(*asked, "--pages").returncode == 1
    (tmp_path / "derive/a.py").write_text("x = 1\n")
    assert run(*commit).returncode == 0
    assert run(*asked).stdout.split() == ["tests/derive"]
    assert run(*asked, "--pages").returncode == 1
    (tmp_path / "docs/a.md").write_text("A page.\n")
    run(*commit)
    assert run(*asked).stdout.split() == []
    assert run(*asked, "--pages").returncode == 0
