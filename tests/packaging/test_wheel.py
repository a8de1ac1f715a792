"""What a wheel contains, built from a checkout without links, directly and by way of the sdist."""

from __future__ import annotations

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path, PurePosixPath

import pytest

ROOT = Path(__file__).resolve().parents[2]
FOLDERS = {
    "src/gainproof": "gainproof",
    "derive": "gainproof/derive",
    "generated": "gainproof/generated",
    "verify": "gainproof/verify",
}
PAGES = ("docs", "gainproof/docs")
"""Of this folder the pages that lie in it are packed, for `gainproof book`."""
LINKS = ("derive", "generated", "verify")


def copy_without_links(target: Path) -> Path:
    """The tree as git makes it without support for links: a small text file in place of each."""
    target.mkdir()
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, target / name)
    for folder in FOLDERS:
        shutil.copytree(
            ROOT / folder,
            target / folder,
            ignore=lambda path, names: {
                name for name in names if name == "__pycache__" or (Path(path) / name).is_symlink()
            },
        )
    shutil.copytree(ROOT / PAGES[0], target / PAGES[0])
    for name in LINKS:
        (target / "src" / "gainproof" / name).write_text(f"../../{name}")
    return target


def expected_files(tree: Path) -> set[str]:
    """Path in the wheel of every file that has to be there: all but the stand-ins for links."""
    folder, package = PAGES
    found = {f"{package}/{path.name}" for path in (tree / folder).glob("*.md")}
    assert found
    for folder, package in FOLDERS.items():
        for path in (tree / folder).rglob("*"):
            inner = path.relative_to(tree / folder)
            stand_in = folder == "src/gainproof" and inner.as_posix() in LINKS
            if path.is_file() and not stand_in:
                found.add((PurePosixPath(package) / inner.as_posix()).as_posix())
    return found


def build(tree: Path, out: Path, *options: str) -> Path:
    command = [
        sys.executable,
        "-m",
        "build",
        "--no-isolation",
        "--outdir",
        str(out),
        *options,
        str(tree),
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    (wheel,) = out.glob("*.whl")
    return wheel


def wheel_files(wheel: Path) -> set[str]:
    with zipfile.ZipFile(wheel) as archive:
        return set(archive.namelist())


@pytest.fixture(scope="module")
def tree(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return copy_without_links(tmp_path_factory.mktemp("checkout") / "gainproof")


@pytest.fixture(scope="module")
def wheel(tree: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    wanted = expected_files(tree)  # before the build adds its own folders
    built = build(tree, tmp_path_factory.mktemp("direct"), "--wheel")
    packed = {name for name in wheel_files(built) if ".dist-info/" not in name}
    assert packed == wanted
    return built


def test_wheel_from_a_tree_without_links_is_complete(wheel: Path) -> None:
    names = wheel_files(wheel)
    assert "gainproof/py.typed" in names
    assert any(name.startswith("gainproof/derive/") for name in names)


@pytest.mark.thorough
def test_wheel_by_way_of_the_sdist_is_the_same(tree: Path, wheel: Path, tmp_path: Path) -> None:
    assert wheel_files(build(tree, tmp_path)) == wheel_files(wheel)


def test_site_packages_gains_only_gainproof(wheel: Path, tmp_path: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path)
    gained = sorted(path.name for path in tmp_path.iterdir())
    assert [name for name in gained if not name.endswith(".dist-info")] == ["gainproof"]
    assert len(gained) == 2


def test_bare_names_cannot_be_imported_from_the_wheel(wheel: Path, tmp_path: Path) -> None:
    """In a folder of its own and with the wheel alone on the path: only gainproof.* is there."""
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(tmp_path / "site")
    script = (
        "import sys, importlib.util as u\n"
        f"sys.path[:] = [{str(tmp_path / 'site')!r}] + [p for p in sys.path if 'lib' in p]\n"
        "import gainproof.derive, gainproof.verify\n"
        f"assert gainproof.derive.__file__.startswith({str(tmp_path)!r})\n"
        "print([n for n in ('derive', 'generated', 'verify') if u.find_spec(n)])\n"
    )
    command = [sys.executable, "-I", "-c", script]
    done = subprocess.run(command, capture_output=True, text=True, check=True, cwd=tmp_path)
    assert done.stdout.strip() == "[]"


def test_a_file_left_out_would_be_noticed(tree: Path, wheel: Path) -> None:
    stray = tree / "verify" / "claims" / "stray.unknown"
    stray.parent.mkdir(exist_ok=True)
    stray.touch()
    try:
        assert "gainproof/verify/claims/stray.unknown" in expected_files(tree) - wheel_files(wheel)
    finally:
        stray.unlink()
