"""The ledger of proved bounds: what is taken from it, what is not, and that nothing gets worse."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from catalogue_subjects import OTHER_SEED

from gainproof import cli
from gainproof.files import places
from gainproof.jobs import code_digest, workers
from gainproof.subjects import bounds_ledger, derivations
from gainproof.subjects.derivations import catalogue
from gainproof.subjects.deriving import build
from gainproof.subjects.generating import BOUNDING, proved

Capture = pytest.CaptureFixture[str]
SUBJECT, MODULE = "least-squares-line", "least_squares_line"


def entries() -> dict[str, Any]:
    """As they are read from the file."""
    made: dict[str, Any] = json.loads(json.dumps(proved(build(SUBJECT).module, {}).entries))
    return made


def ledger(modules: Any) -> bytes:
    return bounds_ledger.text(modules).encode()


def test_what_holds_is_taken_and_is_the_same() -> None:
    module = build(SUBJECT).module
    first = proved(module, {})
    again = proved(module, json.loads(json.dumps(first.entries)))
    assert (first.taken, again.taken) == (0, len(module.kernels))
    assert again.bounds == first.bounds
    assert json.dumps(again.entries) == json.dumps(first.entries)


@pytest.mark.parametrize(
    "name",
    [
        "random-acceleration",
        *(pytest.param(each, marks=pytest.mark.thorough) for each in catalogue()),
    ],
)
def test_committed_bounds_are_those_of_a_fresh_proof(name: str) -> None:
    """Also with another hash seed than theirs."""
    with pytest.MonkeyPatch.context() as changed:
        changed.setitem(workers.REPRODUCIBLE, "PYTHONHASHSEED", OTHER_SEED)
        (part,) = workers.run([derivations.print_job(name, {})])
    assert part["counts"]["taken"] == 0
    # a subject without kernels has no entry
    known = bounds_ledger.committed(places.generated_folder())
    assert part["bounds"] == known.get(part["module"], {})


@pytest.mark.parametrize("commit", ["HEAD", "HEAD^"])
def test_nothing_got_worse_since(commit: str, tmp_path: Path) -> None:
    """Whoever writes the file anew without the old one beside it is found here."""
    root = Path(__file__).resolve().parents[2]
    git = shutil.which("git")
    if git is None or not (root / ".git").exists():
        pytest.skip("no git here to ask what was committed")
    asked = [git, "-C", str(root), "show", f"{commit}:generated/{bounds_ledger.NAME}"]
    shown = subprocess.run(asked, capture_output=True, check=False)
    if shown.returncode:
        pytest.skip(f"{commit} has no ledger")
    (tmp_path / bounds_ledger.NAME).write_bytes(shown.stdout)
    now = (places.generated_folder() / bounds_ledger.NAME).read_bytes()
    assert bounds_ledger.worse(tmp_path, now) == [], bounds_ledger.CURE


def other_code(monkeypatch: pytest.MonkeyPatch, _: Any) -> None:
    def of_modules(*names: str) -> str:
        assert names == BOUNDING
        return "other code"

    monkeypatch.setattr("gainproof.subjects.generating.of_modules", of_modules)


def other_domain(monkeypatch: pytest.MonkeyPatch, _: Any) -> None:
    monkeypatch.setattr(
        "gainproof.subjects.generating.identity", lambda _: "another graph or domain"
    )


def edited(_: pytest.MonkeyPatch, known: Any) -> None:
    """One digit of each kernel, the key kept."""
    for kernel in known.values():
        output = next(iter(kernel["float32"]["outputs"].values()))
        output["bound"] = "0.01"


def without_key(_: pytest.MonkeyPatch, known: Any) -> None:
    for kernel in known.values():
        del kernel["key"]


def nonsense(_: pytest.MonkeyPatch, known: Any) -> None:
    known |= dict.fromkeys(known, "nonsense")


@pytest.mark.parametrize("change", [other_code, other_domain, edited, without_key, nonsense])
def test_what_does_not_hold_is_proved_anew(
    change: Callable[[pytest.MonkeyPatch, Any], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    module, known = build(SUBJECT).module, entries()
    change(monkeypatch, known)
    found = proved(module, known)
    assert found.taken == 0
    monkeypatch.undo()
    assert found.bounds == proved(module, {}).bounds


def test_the_code_that_bounds_rest_on_is_the_prover_s_and_not_the_writer_s() -> None:
    below = {name.rpartition(".")[2] for name in code_digest.modules_below(*BOUNDING)}
    assert {"adjoint", "forward", "boxes", "exact", "lost_digits", "bound_data"} <= below
    assert not {"docstring", "numpy_source", "arithmetic", "layout", "write"} & below


@pytest.mark.parametrize("package", bounds_ledger.PACKAGES)
def test_bounds_of_other_versions_are_not_taken(package: str, tmp_path: Path) -> None:
    content = json.loads(ledger({MODULE: entries()}))
    path = tmp_path / bounds_ledger.NAME
    path.write_text(json.dumps(content))
    assert bounds_ledger.usable(tmp_path) == content["modules"]
    assert bounds_ledger.usable(tmp_path, fresh=True) == {}
    content["versions"][package] += ".1"
    path.write_text(json.dumps(content))
    assert bounds_ledger.usable(tmp_path) == {}
    assert bounds_ledger.committed(tmp_path) == content["modules"]


@pytest.mark.parametrize("text", ["", "[]", "{", '{"modules": 3}', "[" * 100_000, "\x00"])
def test_a_file_that_nobody_can_read_holds_nothing(text: str, tmp_path: Path) -> None:
    (tmp_path / bounds_ledger.NAME).write_text(text)
    assert bounds_ledger.usable(tmp_path) == bounds_ledger.committed(tmp_path) == {}
    assert bounds_ledger.worse(tmp_path, ledger({MODULE: entries()})) == []


@pytest.mark.parametrize("kernels", [None, 3, "gains", ["gains"]])
def test_a_module_that_nobody_can_read_holds_nothing(kernels: object, tmp_path: Path) -> None:
    (tmp_path / bounds_ledger.NAME).write_bytes(ledger({MODULE: kernels}))
    assert bounds_ledger.usable(tmp_path) == bounds_ledger.committed(tmp_path) == {}
    assert bounds_ledger.worse(tmp_path, ledger({MODULE: entries()})) == []


@pytest.mark.parametrize(
    ("field", "value"),
    [
        *(("bound", "1e999999999"), ("bound", "1/0"), ("bound", "-1"), ("bound", "")),
        *(("bound", None), ("bound", []), ("domain", 3), ("domain", [[1.0]]), ("domain", "ab")),
    ],
)
def test_an_output_that_nobody_can_read_is_said(field: str, value: object, tmp_path: Path) -> None:
    before = entries()
    name, entry = one_kernel(before)
    entry["float64"]["outputs"]["predicted_12"][field] = value
    (tmp_path / bounds_ledger.NAME).write_bytes(ledger({MODULE: before}))
    assert bounds_ledger.worse(tmp_path, ledger({MODULE: entries()})) == [
        f"{MODULE}.{name}: what was committed cannot be read"
    ]


def smaller_bound(kernel: Any) -> str:
    output = kernel["float64"]["outputs"]["predicted_12"]
    now, output["bound"] = output["bound"], "0.01"
    return f"its bound grew from 0.01 to {now}"


def narrower_now(kernel: Any) -> str:
    (ends,) = kernel["float64"]["inputs"]
    now, ends[1] = f"{ends[0]!r}..{ends[1]!r}", ends[1] * 2
    return f"its domain shrank from {ends[0]!r}..{ends[1]!r} to {now}"


def domain_of_its_own(kernel: Any) -> str:
    low, high = kernel["float64"]["inputs"][0]
    kernel["float64"]["outputs"]["predicted_12"]["domain"] = [[low / 2, high]]
    return f"its domain shrank from {low / 2!r}..{high!r} to {low!r}..{high!r}"


CHANGES = [smaller_bound, narrower_now, domain_of_its_own]


def one_kernel(found: Any) -> tuple[str, Any]:
    """The name and the entry of the kernel that has this output."""
    return next((name, e) for name, e in found.items() if "predicted_12" in str(e))


@pytest.mark.parametrize("change", CHANGES)
def test_what_got_worse_is_said(
    change: Callable[[Any], str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    now, before = entries(), entries()
    name, entry = one_kernel(before)
    expected = change(entry)
    (tmp_path / bounds_ledger.NAME).write_bytes(ledger({MODULE: before}))
    found = bounds_ledger.worse(tmp_path, ledger({MODULE: now}))
    place = f"{MODULE}.{name}, predicted_12 (float64)"
    assert f"{place}: {expected}" in found
    # the other way round everything got better
    (tmp_path / bounds_ledger.NAME).write_bytes(ledger({MODULE: now}))
    assert bounds_ledger.worse(tmp_path, ledger({MODULE: before})) == []
    (tmp_path / bounds_ledger.NAME).write_bytes(ledger({MODULE: before}))
    monkeypatch.setattr(bounds_ledger, "EXCEPTIONS", {f"{place}: {expected}": "a reason"})
    assert bounds_ledger.worse(tmp_path, ledger({MODULE: now})) == [
        sentence for sentence in found if sentence != f"{place}: {expected}"
    ]


@pytest.mark.parametrize(
    ("field", "less", "more", "said"),
    [
        *(
            ("beside", least, 2.5e-300, "what an underflow adds grew to 2.5e-300")
            for least in (None, 1e-300)
        ),
        *(
            ("amplification", least, {"turn": 3.0}, "its amplification of turn grew to 3")
            for least in (None, {}, {"turn": 2.0})
        ),
    ],
)
def test_what_comes_beside_a_bound_may_only_fall_too(
    field: str, less: object, more: object, said: str, tmp_path: Path
) -> None:
    before, now = entries(), entries()
    for made, value in ((before, less), (now, more)):
        name, entry = one_kernel(made)
        if value is not None:
            entry["float64"]["outputs"]["predicted_12"][field] = value
    path = tmp_path / bounds_ledger.NAME
    path.write_bytes(ledger({MODULE: before}))
    place = f"{MODULE}.{name}, predicted_12 (float64)"
    assert bounds_ledger.worse(tmp_path, ledger({MODULE: now})) == [f"{place}: {said}"]
    path.write_bytes(ledger({MODULE: now}))
    assert bounds_ledger.worse(tmp_path, ledger({MODULE: before})) == []


def test_what_is_gone_is_said(tmp_path: Path) -> None:
    (tmp_path / bounds_ledger.NAME).write_bytes(ledger({MODULE: entries()}))
    now = entries()
    name, entry = one_kernel(now)
    del entry["float32"]["outputs"]["predicted_12"]
    assert bounds_ledger.worse(tmp_path, ledger({MODULE: now})) == [
        f"{MODULE}.{name}, predicted_12 (float32): the output is gone"
    ]
    del now[name]
    (said,) = bounds_ledger.worse(tmp_path, ledger({MODULE: now}))
    assert said == f"{MODULE}.{name}: the kernel is gone"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture) -> Path:
    """What one subject gives to the folder, with a stranger's entry in the ledger."""
    monkeypatch.setattr(places, "generated_folder", lambda: tmp_path)
    (tmp_path / bounds_ledger.NAME).write_bytes(ledger({"stranger": {}}))
    assert cli.main(["generate", SUBJECT]) == 0
    assert sorted(bounds_ledger.committed(tmp_path)) == [MODULE, "stranger"]
    assert cli.main(["generate", SUBJECT, "--check"]) == 0
    capsys.readouterr()
    return tmp_path


@pytest.mark.parametrize("change", CHANGES)
def test_generate_writes_nothing_that_is_worse(
    change: Callable[[Any], str], folder: Path, capsys: Capture
) -> None:
    path = folder / bounds_ledger.NAME
    content = json.loads(path.read_bytes())
    expected = change(one_kernel(content["modules"][MODULE])[1])
    path.write_bytes(ledger(content["modules"]))
    before = path.read_bytes()
    assert cli.main(["generate", SUBJECT]) == 1
    text = capsys.readouterr().out
    assert expected in text
    assert "nothing is written" in text
    assert path.read_bytes() == before
    assert cli.main(["generate", SUBJECT, "--check"]) == 1
    assert "bounds.json: different" in capsys.readouterr().out


def test_an_entry_that_was_forged_with_its_key_is_found_by_a_fresh_proof(
    folder: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its key says that this graph was proved by this code: only a proof tells that it was not."""
    seal = bounds_ledger.sealed

    def forged(rests_on: str, entry: Any) -> dict[str, Any]:
        copy = json.loads(json.dumps(entry))
        if "predicted_12" in copy["float64"]["outputs"]:
            smaller_bound(copy)
        return seal(rests_on, copy)

    with monkeypatch.context() as changed:
        changed.setattr(bounds_ledger, "sealed", forged)
        modules = {MODULE: proved(build(SUBJECT).module, {}).entries, "stranger": {}}
    (folder / bounds_ledger.NAME).write_bytes(ledger(modules))
    assert cli.main(["generate", SUBJECT, "--check"]) == 1
    assert f"{MODULE}.py: different" in capsys.readouterr().out
    assert cli.main(["generate", SUBJECT]) == 0
    assert "0.01 * 2^-52" in (folder / f"{MODULE}.py").read_text()
    assert cli.main(["generate", SUBJECT, "--check"]) == 0  # one with the other, and both false
    capsys.readouterr()
    assert cli.main(["generate", SUBJECT, "--check", "--fresh"]) == 1
    text = capsys.readouterr().out
    assert f"{MODULE}.py: different" in text
    assert "its bound grew from 0.01 to " in text


def test_versions_are_no_drift_and_are_written(folder: Path) -> None:
    path = folder / bounds_ledger.NAME
    wanted = path.read_bytes()
    sympy = bounds_ledger.own_versions()["sympy"].encode()
    path.write_bytes(wanted.replace(b'"sympy": "' + sympy, b'"sympy": "0.1'))
    assert path.read_bytes() != wanted
    assert cli.main(["generate", SUBJECT, "--check"]) == 0
    assert cli.main(["generate", SUBJECT]) == 0
    assert json.loads(path.read_bytes())["versions"] == bounds_ledger.own_versions()


def test_entries_of_others_keep_their_keys_unless_proved_with_other_versions(
    folder: Path,
) -> None:
    path = folder / bounds_ledger.NAME
    modules = {**bounds_ledger.committed(folder), "stranger": {"gains": {"key": "a"}}}
    path.write_bytes(ledger(modules))
    assert cli.main(["generate", SUBJECT]) == 0
    assert bounds_ledger.committed(folder) == modules
    older = ledger(modules).replace(b'"python": "', b'"python": "0.')
    path.write_bytes(older)
    assert cli.main(["generate", SUBJECT]) == 0
    assert bounds_ledger.committed(folder) == {**modules, "stranger": {"gains": {}}}
