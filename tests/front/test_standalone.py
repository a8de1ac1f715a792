"""Packages of their own: complete, tested, and careful with what else lies in their folder."""

from __future__ import annotations

import ast
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from gainproof import cli
from gainproof.bad_input import BadInputError
from gainproof.derive.printer.package import CODE
from gainproof.files import named_files
from gainproof.standalone import making, record, testing
from gainproof.standalone.files import SHIPPED, TARGETS, folder_of
from gainproof.standalone.licence import LICENCE

Capture = pytest.CaptureFixture[str]
SUBJECT, MODULE = "least-squares-mean", "least_squares_mean"
Files = dict[str, bytes]


def contents(folder: Path) -> Files:
    return {p.relative_to(folder).as_posix(): p.read_bytes() for p in folder.rglob("*.*")}


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A package as the command writes it."""
    folder = tmp_path_factory.mktemp("made") / "mean_kernels"
    assert cli.main(["generate", SUBJECT, "--out", str(folder)]) == 0
    return folder


@pytest.fixture
def package(written: Path, tmp_path: Path) -> Path:
    """A copy to do harm to."""
    return Path(shutil.copytree(written, tmp_path / "mean_kernels"))


def again(folder: Path, *options: str, subject: str = SUBJECT) -> int:
    return cli.main(["generate", subject, "--out", str(folder), *options])


def test_a_package_is_complete(written: Path) -> None:
    names = {p.relative_to(written).as_posix() for p in written.rglob("*") if p.is_file()}
    tests = {f"tests/{path.name}" for path in SHIPPED.glob("*.py")}
    tests -= {f"tests/test_{folder_of(target)}.py" for target in TARGETS}
    read = {f"tests/values_{MODULE}.json", f"tests/formulas_{MODULE}.py"}
    module = {f"{MODULE}.py", f"{MODULE}.json", f"{MODULE}.md", *read}
    others = {"__init__.py", "py.typed", "README.md", "LICENSE", record.RECORD}
    assert names == {*CODE, *tests, *module, *others}
    assert len(tests) > 4
    assert set(record.recorded(written)) == names


def test_nothing_in_it_names_a_place_or_imports_gainproof(written: Path) -> None:
    for path in written.rglob("*.py"):
        source = path.read_text(encoding="utf-8")
        assert str(written.parent) not in source
        for node in ast.walk(ast.parse(source)):
            if isinstance(node, ast.Import):
                assert not any("gainproof" in alias.name for alias in node.names)
            if isinstance(node, ast.ImportFrom):
                assert "gainproof" not in (node.module or "")


def test_its_tests_pass_under_another_name_where_gainproof_cannot_be_imported(
    package: Path, tmp_path: Path
) -> None:
    moved = package.rename(tmp_path / "renamed")
    (tmp_path / "gainproof.py").write_text("raise ImportError('not here')\n", encoding="utf-8")
    assert testing.passes(moved)
    assert not list(moved.rglob("__pycache__"))


@pytest.mark.alike
@pytest.mark.parametrize(
    ("name", "old", "new", "failing"),
    [
        (
            f"{MODULE}.py",
            "n0: float = 1.0",
            "n0: float = 1.00000000000001",
            "test_values",
        ),
        ("_guards.py", "raise ValueError(", "raise RuntimeError(", "test_guards"),
        (f"tests/values_{MODULE}.json", '"0.5000', '"0.5001', "test_values"),
        ("_bits.py", "import numpy as np", "import numpy as np\nimport sympy", "test_imports"),
        (f"tests/formulas_{MODULE}.py", "sample_number + 1", "sample_number + 2", "test_formulas"),
    ],
)
def test_each_kind_of_harm_is_noticed(
    package: Path, capsys: Capture, name: str, old: str, new: str, failing: str
) -> None:
    source = (package / name).read_text(encoding="utf-8")
    assert old in source
    (package / name).write_text(source.replace(old, new, 1), encoding="utf-8")
    assert not testing.passes(package / "tests" / f"{failing}.py")
    assert f"{failing}.py" in capsys.readouterr().out
    assert again(package, "--check") == 1
    assert f"{name}: different" in capsys.readouterr().out
    assert again(package) == 0
    assert again(package, "--check") == 0


def test_what_else_lies_there_is_left_alone(package: Path) -> None:
    (package / "notes.md").write_text("mine", encoding="utf-8")
    (package / "tests" / "test_mine.py").write_text("def test_mine(): pass\n", encoding="utf-8")
    assert again(package, "--check") == 0
    assert again(package, subject="least-squares-line") == 0
    assert (package / "notes.md").read_text(encoding="utf-8") == "mine"
    assert (package / "tests" / "test_mine.py").exists()
    assert not (package / f"{MODULE}.py").exists()
    assert not (package / "tests" / f"values_{MODULE}.json").exists()
    assert again(package, "--check", subject="least-squares-line") == 0


def test_left_over_files_are_told(package: Path, capsys: Capture) -> None:
    assert again(package, "--check", subject="least-squares-line") == 1
    text = capsys.readouterr().out
    assert f"{MODULE}.md: stale, no longer part of the package" in text
    assert "`gainproof generate least-squares-line --out mean_kernels` writes them" in text


@pytest.mark.parametrize("name", ["README.md", "tests/__init__.py", f"{MODULE}.py"])
def test_no_file_of_others_is_replaced(tmp_path: Path, capsys: Capture, name: str) -> None:
    folder = tmp_path / "there_already"
    (folder / name).parent.mkdir(parents=True)
    (folder / name).write_text("mine", encoding="utf-8")
    assert again(folder) == 2
    assert "no file that gainproof has written" in capsys.readouterr().err
    assert contents(folder) == {name: b"mine"}


def test_a_file_in_place_of_the_folder_is_told_at_once(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delattr(making, "_packaged")  # nothing is derived in vain
    (tmp_path / "taken").write_text("mine", encoding="utf-8")
    assert again(tmp_path / "taken") == 2
    assert "taken: a folder is wanted, this is none" in capsys.readouterr().err
    assert (tmp_path / "taken").read_text(encoding="utf-8") == "mine"


@pytest.mark.parametrize("spoil", [Path.unlink, lambda path: path.write_text("x\n")])
def test_without_a_record_nothing_is_ours(
    package: Path, capsys: Capture, spoil: Callable[[Path], object]
) -> None:
    spoil(package / record.RECORD)
    before = contents(package)
    assert again(package, subject="least-squares-line") == 2
    assert "left as it is" in capsys.readouterr().err
    assert contents(package) == before


@pytest.mark.parametrize("name", ["../outside.txt", "/outside.txt", "a/../../outside.txt", ""])
def test_a_record_names_nothing_elsewhere(package: Path, capsys: Capture, name: str) -> None:
    (package.parent / "outside.txt").write_text("mine", encoding="utf-8")
    with (package / record.RECORD).open("a", encoding="utf-8") as stream:
        stream.write(f"{name}\n")
    assert again(package) == 2
    assert "lies elsewhere" in capsys.readouterr().err
    assert (package.parent / "outside.txt").exists()


@pytest.mark.parametrize("name", ["tests", f"{MODULE}.py"])
def test_a_link_in_it_is_not_followed(
    package: Path, tmp_path: Path, capsys: Capture, name: str
) -> None:
    """What a link leads to was written, and deleted where it was of a former run."""
    elsewhere = tmp_path / "elsewhere"
    (package / name).rename(elsewhere)
    (package / name).symlink_to(elsewhere)
    read = elsewhere if elsewhere.is_file() else elsewhere / "test_values.py"
    read.write_text("mine", encoding="utf-8")
    assert again(package) == 2
    assert f"{name} in it is a link" in capsys.readouterr().err
    assert read.read_text("utf-8") == "mine"


def test_all_files_are_written_or_none(package: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    before = contents(package)
    files = {name.replace(MODULE, "other"): text + b"\n" for name, text in before.items()}
    files.pop(record.RECORD)
    monkeypatch.setattr(os, "replace", _refuse)
    with pytest.raises(BadInputError, match="cannot be written"):
        record.put(files, package)
    assert contents(package) == before


def _refuse(*_: object) -> None:
    raise PermissionError(13, "Permission denied")


def test_an_interrupt_leaves_no_file_unknown(
    package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After the new files and before the old ones are deleted."""
    write = named_files.write

    def interrupted(files: dict[Path, bytes]) -> list[str]:
        write(files)
        raise KeyboardInterrupt

    with monkeypatch.context() as patched:
        patched.setattr(named_files, "write", interrupted)
        assert again(package, subject="least-squares-line") == 130
    assert (package / f"{MODULE}.py").exists()
    assert again(package, subject="least-squares-line") == 0
    assert not (package / f"{MODULE}.py").exists()


@pytest.mark.parametrize("name", ["numpy", "jax", "json", "gainproof", "my-kernels", "class", "2d"])
def test_a_package_has_a_name_that_can_be_imported(
    tmp_path: Path, capsys: Capture, name: str
) -> None:
    assert again(tmp_path / name) == 2
    assert f"{name!r} is " in capsys.readouterr().err
    assert not (tmp_path / name).exists()


def test_several_subjects_are_one_package(tmp_path: Path) -> None:
    folder = tmp_path / "fits"
    both = ["least-squares-mean", "least-squares-line"]
    assert cli.main(["generate", *both, "--out", str(folder), "--test"]) == 0
    text = (folder / "README.md").read_text(encoding="utf-8")
    assert "\n    gainproof generate least-squares-mean least-squares-line --out fits\n" in text
    assert "[`least_squares_line`](least_squares_line.md)" in text


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["least-squares-men", "--out", "kernels"], "least-squares-mean"),
        ([SUBJECT, SUBJECT, "--out", "kernels"], f"another one makes a module {MODULE} too"),
        ([SUBJECT, "--test"], "give --out DIR"),
        (["my_model.py"], "give --out DIR"),
        (["my_model.py", "--out", "kernels"], "cannot be read"),
    ],
)
def test_bad_input_writes_nothing(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: Capture,
    arguments: list[str],
    message: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["generate", *arguments]) == 2
    assert message in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_without_pytest_there_is_a_word(
    package: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    monkeypatch.setattr(testing, "find_spec", lambda _: None)
    assert again(package, "--test") == 2
    assert "pip install pytest" in capsys.readouterr().err


def test_the_licence_is_that_of_the_project() -> None:
    assert Path(__file__).resolve().parents[2].joinpath("LICENSE").read_text("utf-8") == LICENCE


def test_the_command_does_not_depend_on_where_a_file_lies(tmp_path: Path) -> None:
    files = [str(tmp_path / "my_model.py"), "random-velocity"]
    assert making.command(files, "x") == "gainproof generate my_model.py random-velocity --out x"


def test_the_readme_says_what_is_true(package: Path) -> None:
    """Its Python is executed; its test command too, by name."""
    text = (package / "README.md").read_text(encoding="utf-8")
    blocks = text.split("```python\n")[1:]
    assert len(blocks) == 2
    code = "".join(block.split("```")[0] for block in blocks)
    ran = subprocess.run(
        [sys.executable, "-c", f"{code}\nprint(report.accepted)"],
        capture_output=True,
        text=True,
        check=False,
        cwd=package.parent,
    )
    assert ran.stdout == "True\n", ran.stderr
