"""The committed files of generated/ are those of a fresh derivation, whatever the hash seed."""

from __future__ import annotations

import ast
import shutil
from pathlib import Path

import pytest
from catalogue_subjects import derive_with_another_seed

from gainproof import cli
from gainproof.derive.printer.package import CODE
from gainproof.files import places
from gainproof.jobs.cache import FOLDER_VARIABLE
from gainproof.jobs.session import open_session
from gainproof.subjects import bounds_ledger, derivations, drift, generated_files

Capture = pytest.CaptureFixture[str]


@pytest.mark.usefixtures("all_derived")
def test_every_byte_is_as_derived(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    """One subject of each kind with another hash seed, the others too unless `gainproof run`, the
    README's first command, has just derived them with the usual one.
    """
    committed, made = places.generated_folder(), tmp_path / "made"
    made.mkdir()
    shutil.copy(committed / bounds_ledger.NAME, made)
    monkeypatch.setattr(places, "generated_folder", lambda: made)
    one = ["generate", "random-velocity", "--check"]
    assert cli.main(one) == 1
    assert "missing" in capsys.readouterr().out
    assert cli.main(["generate"]) == 0
    assert cli.main(one) == 0
    fresh = {name: (made / name).read_bytes() for name in drift.files_in(made)}
    found = [difference.text() for difference in drift.compare(fresh, committed)]
    assert not found, f"{found}; {drift.CURE}"
    path = made / "random_velocity.py"
    path.write_bytes(path.read_bytes().replace(b"0.5", b"0.6", 1))
    assert cli.main(one) == 1
    text = capsys.readouterr().out
    assert "random_velocity.py: different, first in line" in text
    assert "`gainproof generate`" in text


@pytest.mark.thorough
def test_every_byte_is_as_derived_with_another_hash_seed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path))
    session = open_session(quiet=True)
    derive_with_another_seed(session, derivations.catalogue())
    fresh = generated_files.fresh((), session)
    found = [difference.text() for difference in drift.compare(fresh, places.generated_folder())]
    assert not found, f"{found}; {drift.CURE}"


def test_one_subject_brings_the_code_that_it_shares_and_leaves_the_others(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(places, "generated_folder", lambda: tmp_path)
    (tmp_path / "another.py").touch()
    assert cli.main(["generate", "least-squares-mean"]) == 0
    (tmp_path / "another.py").unlink()
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == sorted(
        [*CODE, "bounds.json", "least_squares_mean.json", "least_squares_mean.py"]
    )
    (tmp_path / CODE[0]).write_text("", encoding="utf-8")
    assert cli.main(["generate", "least-squares-mean", "--check"]) == 1
    assert cli.main(["generate", "least-squares-mean"]) == 0
    assert cli.main(["generate", "least-squares-mean", "--check"]) == 0


def test_what_the_checker_rejects_is_not_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    report = {"accepted": False, "given_up": False, "reason": "kernel-gains: another value"}
    monkeypatch.setattr(places, "generated_folder", lambda: tmp_path)
    monkeypatch.setattr(derivations, "recheck", lambda pairs, _session: [report for _ in pairs])
    for options in ([], ["--check"]):
        assert cli.main(["generate", "least-squares-mean", *options]) == 2
        said = capsys.readouterr().err
        assert "least-squares-mean: the checker rejects the derivation, nothing is written" in said
        assert "kernel-gains: another value" in said
    assert not list(tmp_path.iterdir())


def test_subjects_agree_on_the_files_that_they_share() -> None:
    parts = [{"module": m, "title": m, "files": {"_shared.py": "x", m: m}} for m in ("a", "b")]
    files = generated_files.together(parts)
    assert sorted(files) == sorted(["__init__.py", *CODE, "_shared.py", "a", "b"])
    other = {"module": "c", "title": "c", "files": {"_shared.py": "y"}}
    with pytest.raises(ValueError, match=r"c: its _shared\.py differs"):
        generated_files.together([*parts, other])


def test_every_kernel_module_names_its_command_and_derivation() -> None:
    for path in places.generated_folder().glob("[!_]*.py"):
        first, second = path.read_text(encoding="utf-8").splitlines()[:2]
        name = path.stem.replace("_", "-")
        assert first == f"# Made by: gainproof generate {name}"
        assert second.startswith(f"# From: gainproof derive {name}, SymPy 1.14.0")


def test_listed_kernels_are_those_of_the_modules(capsys: Capture) -> None:
    cli.main(["list"])
    listed = capsys.readouterr().out
    for path in places.generated_folder().glob("[!_]*.py"):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        (names,) = [
            ast.literal_eval(node.value)
            for node in tree.body
            if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "__all__"
        ]
        assert f"gainproof.generated.{path.stem}\n" in listed
        assert all(name in listed for name in names if name[0].islower())
