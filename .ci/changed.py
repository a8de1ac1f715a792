"""What differs from the parent commit: the test folders of these rooms, one a line, for thorough
runs; with --pages nothing, and exit status 0 if a page of the book may look different, else 1.

Python's own library alone: it runs before anything is installed. Where git cannot tell, as in a
clone of one commit, no folder is said to differ, and pages are.
"""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterable
from pathlib import Path, PurePosixPath

HOUSE = Path(__file__).resolve().parents[1]
PAGES = (
    *("src/gainproof/book/", "src/gainproof/pages/", "src/gainproof/plots/", "docs/"),
    *("derive/printer/javascript/", "tests/book/"),
    *(f"tests/support/{name}.py" for name in ("browser", "page_faults", "play_page")),
)
"""Where what is seen in a browser is written, made and tested; `generated/*.js` besides."""
FRONT = "src/gainproof/"


def folders_of_tests(changed: Iterable[str], house: Path = HOUSE) -> list[str]:
    """The folders of tests that mirror the changed files, each the nearest that there is."""
    found = set()
    for name in changed:
        path = PurePosixPath(name)
        if path.suffix not in (".py", ".js", ".html", ".toml", ".json"):
            continue
        if name.startswith(FRONT):
            path = PurePosixPath(name.removeprefix(FRONT))
            mirrored = PurePosixPath("tests") / path.parent
            top = "tests/front"
        elif path.parts[0] == "tests":
            mirrored, top = path.parent, ""
        else:
            mirrored, top = PurePosixPath("tests") / path.parent, ""
        for folder in (mirrored, *mirrored.parents):
            if len(folder.parts) < 2:
                found |= {top} - {""}
                break
            if any((house / folder).rglob("test_*.py")):
                found.add(str(folder))
                break
    # a folder says its inner ones too
    return sorted(f for f in found if not any(str(p) in found for p in PurePosixPath(f).parents))


def pages_changed(changed: Iterable[str] | None) -> bool:
    """Whether a page of the book may look different; `changed` is None where nobody can tell."""
    return changed is None or any(
        name.startswith(PAGES) or (name.startswith("generated/") and name.endswith(".js"))
        for name in changed
    )


def changed_files(house: Path = HOUSE) -> list[str] | None:
    """The files of the tree that differ from the parent commit, new ones too; None where git cannot
    tell.
    """
    found: list[str] = []
    for words in (("diff", "--name-only", "HEAD^"), ("ls-files", "--others", "--exclude-standard")):
        try:
            asked = subprocess.run(
                ["git", *words], cwd=house, capture_output=True, text=True, check=True
            )
        except (OSError, subprocess.CalledProcessError):
            return None
        found += asked.stdout.splitlines()
    return found


def main() -> int:
    """The command."""
    changed = changed_files()
    if sys.argv[1:] == ["--pages"]:
        return 0 if pages_changed(changed) else 1
    print("\n".join(folders_of_tests(changed or ())))
    return 0


if __name__ == "__main__":
    sys.exit(main())
