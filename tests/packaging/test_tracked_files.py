"""What is committed: files of known kinds, without a path of the machine that made them."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SUFFIXES = frozenset({".css", ".html", ".js", ".json", ".md", ".py", ".toml", ".typed"})
OTHERS = frozenset(
    {".gitignore", "CITATION.cff", "LICENSE", "py.typed", ".ci/release", ".ci/run", ".ci/thorough"}
)
LINKS = frozenset(f"src/gainproof/{name}" for name in ("derive", "generated", "verify"))
HOME = re.compile(rb"/(?:root|home|Users)/[A-Za-z.]")
"""Where users have their folders."""


def problem(name: str, content: bytes) -> str | None:
    """What is wrong with a file: a kind that nobody meant to commit, or a path."""
    if Path(name).suffix not in SUFFIXES and name not in OTHERS:
        return f"{name}: a file of this kind is not committed; a new kind goes into SUFFIXES"
    found = HOME.search(content)
    return f"{name}: a path of one machine: {found[0].decode()}" if found else None


def test_nothing_is_tracked_by_accident() -> None:
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, check=False)
    if listed.returncode:
        pytest.skip("not a clone")
    names = [name for name in listed.stdout.decode().split("\0") if name and name not in LINKS]
    paths = [(name, ROOT / name) for name in names if (ROOT / name).is_file()]
    found = [problem(name, path.read_bytes()) for name, path in paths]
    assert not [each for each in found if each]


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("run.log", b""),
        ("campaign.state", b"{}"),
        ("docs/x.md", b"see /ro" + b"ot/x"),
        ("tests/x.py", b"open('/ho" + b"me/me')"),
    ],
)
def test_what_does_not_belong_is_seen(name: str, content: bytes) -> None:
    assert problem(name, content) is not None
