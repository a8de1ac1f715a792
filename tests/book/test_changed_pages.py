"""Pages are opened in a browser by default where something of them changed."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from browser import PAGES, unchanged

ROOT = Path(__file__).resolve().parents[2]
GIT = shutil.which("git")


def git(root: Path, *words: str) -> None:
    assert GIT is not None
    names = ("-c", "user.name=x", "-c", "user.email=x@example.org", "-c", "commit.gpgsign=false")
    subprocess.run([GIT, "-C", str(root), *names, *words], capture_output=True, check=True)


def commit(root: Path, path: str, text: str) -> None:
    (root / path).parent.mkdir(parents=True, exist_ok=True)
    (root / path).write_text(text)
    git(root, "add", "--all")
    git(root, "commit", "--message", "x")


@pytest.mark.skipif(GIT is None, reason="there is no git to ask")
def test_what_changed_since_the_commit_before_is_seen(tmp_path: Path) -> None:
    assert not unchanged(tmp_path)  # no repository
    git(tmp_path, "init")
    commit(tmp_path, "docs/page.md", "a")
    assert not unchanged(tmp_path)  # no commit before
    commit(tmp_path, "derive/step.py", "a")
    assert unchanged(tmp_path)
    (tmp_path / "docs" / "page.md").write_text("b")
    assert not unchanged(tmp_path)
    commit(tmp_path, "docs/page.md", "c")
    assert not unchanged(tmp_path)
    commit(tmp_path, "derive/step.py", "b")
    assert unchanged(tmp_path)
    (tmp_path / "docs" / "new.md").touch()
    assert not unchanged(tmp_path)


@pytest.mark.parametrize("path", PAGES)
def test_what_is_looked_at_is_there(path: str) -> None:
    """A folder with another name would never be seen to change."""
    assert (ROOT / path).exists()
