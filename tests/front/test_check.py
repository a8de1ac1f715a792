"""`check` and `explain` on the lecture and small claim files: verdicts, statuses, bad input."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from gainproof import cli
from gainproof.claims.source_words import claims_said
from gainproof.files import places
from gainproof.jobs.cache import default_folder

Capture = pytest.CaptureFixture[str]

HEAD = r"""
format = "gainproof claims 1"

[source]
key = "own-paper"
title = "Notes on a filter"
authors = ["A. Reader"]
publication = "unpublished"

[settings.steady]
title = "alpha-beta filter"
kind = "steady_state"
model = "random-velocity"
gain = "filter"

[settings.steady.symbols]
'\alpha' = { quantity = "filter_gain.1", meaning = "position gain" }
'\beta' = { quantity = "filter_gain.2", meaning = "velocity gain" }
'\Lambda' = { quantity = "tracking_index", meaning = "tracking index" }
"""

FIELDS = {
    "id",
    "place",
    "kind",
    "latex",
    "verdict",
    "domain",
    "evidence",
    "repair",
    "repairs",
    "truth",
    "convention",
    "reading",
    "undefined",
    "any_filter",
    "reason",
    "accident",
    "seconds",
}


def claim(name: str, latex: str, kind: str = "identity") -> str:
    lines = ["", "[[claims]]", f'id = "{name}"', 'place = "page 1"', f'kind = "{kind}"']
    return "\n".join([*lines, 'setting = "steady"', f"latex = '{latex}'", ""])


# True, so that no point refutes it, and with more radicals than any method takes.
HARD = "{} = {}".format(
    " + ".join(rf"\sqrt{{{n} + \alpha}}\sqrt{{{n} + \beta}}" for n in range(2, 10)),
    " + ".join(rf"\sqrt{{({n} + \alpha)({n} + \beta)}}" for n in range(2, 10)),
)


@pytest.fixture
def file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    # its path from here is the same in every test, so that the file is judged once for all
    monkeypatch.chdir(tmp_path)
    path = tmp_path / "own-paper.toml"
    text = claim("1", r"\alpha^2 + \alpha\beta = 2\beta") + claim("2", r"\alpha^2 = 2\beta")
    path.write_text(HEAD + text)
    return path


def as_json(capsys: Capture) -> Any:
    return json.loads(capsys.readouterr().out)


def test_a_true_and_a_false_claim_are_settled(file: Path, capsys: Capture) -> None:
    assert cli.main(["check", str(file)]) == 0
    text = capsys.readouterr().out
    assert "2 claims: 1 proved, 1 refuted" in text


def test_json_has_the_documented_fields(file: Path, capsys: Capture) -> None:
    assert cli.main(["check", str(file), "--json"]) == 0
    data = as_json(capsys)
    assert set(data) == {"source", "claims"}
    assert data["source"]["key"] == "own-paper"
    for entry in data["claims"]:
        assert set(entry) == FIELDS
        assert set(entry["evidence"]) == {"method", "certificate", "witness"}
    true, false = data["claims"]
    assert true["verdict"] == "proved"
    assert true["evidence"]["certificate"]
    assert false["verdict"] == "refuted"
    assert false["evidence"]["witness"]


@pytest.mark.parametrize(("second", "status"), [(r"\alpha^2 = 2\beta", 0), (HARD, 1)])
def test_without_a_file_json_is_a_list_of_all(
    second: str, status: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    """All of a small house; which files the house has itself is shown below."""
    for place, latex in (("b", r"\alpha^2 + \alpha\beta = 2\beta"), ("outside/a", second)):
        path = tmp_path / f"{place}.toml"
        path.parent.mkdir(exist_ok=True)
        path.write_text(HEAD.replace("own-paper", path.stem) + claim("1", latex))
    monkeypatch.setattr(places, "claims_folder", lambda: tmp_path)
    assert cli.main(["check", "--json"]) == status
    data = as_json(capsys)
    assert [judgement["source"]["key"] for judgement in data] == ["b", "a"]
    verdicts = [entry["verdict"] for judgement in data for entry in judgement["claims"]]
    assert verdicts[0] == "proved"
    assert (verdicts[1] in {"held", "undecided"}) == bool(status)


def test_own_claim_files_are_those_of_the_sources_and_those_from_outside() -> None:
    files = places.claim_files()
    assert "kosuge-slides" in [path.stem for path in files]
    assert "outside" in {path.parent.name for path in files}
    assert len({path.stem for path in files}) == len(files)


@pytest.mark.usefixtures("lecture_known")
def test_the_lecture_is_settled_and_the_noise_of_each_row_found(capsys: Capture) -> None:
    assert cli.main(["check", "kosuge-slides", "--json"]) == 0
    claims = {entry["id"]: entry for entry in as_json(capsys)["claims"]}
    assert not [name for name, entry in claims.items() if entry["verdict"] in {"held", "undecided"}]
    assert "random-velocity" in claims["table-ab-RV"]["convention"]
    assert "random-acceleration" in claims["table-ab-RA"]["convention"]


def test_a_claim_that_cannot_be_decided_has_status_1(tmp_path: Path, capsys: Capture) -> None:
    path = tmp_path / "open.toml"
    path.write_text(HEAD + claim("hard", HARD))
    assert cli.main(["check", str(path), "--json"]) == 1
    (entry,) = as_json(capsys)["claims"]
    assert entry["verdict"] in {"held", "undecided"}
    assert entry["reason"]


@pytest.mark.alike
@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        (HEAD + claim("1", r"\alpha = \bata"), ["line 2", r"\bata", r"\beta"]),
        (HEAD + claim("1", r"\alpha = \beta +"), ["line 2", "column"]),
        (HEAD.replace('model = "random-velocity"\n', ""), ["settings.steady"]),
        (HEAD.replace("gainproof claims 1", "gainproof claims 9"), ["format"]),
        ("format = ", ["not TOML"]),
        (HEAD + claim("1", r"\alpha = __import__('os').system('true')"), ["line 2", "column"]),
    ],
)
def test_bad_claim_files_have_status_2_and_a_place(
    text: str, wanted: list[str], tmp_path: Path, capsys: Capture
) -> None:
    path = tmp_path / "bad.toml"
    path.write_text(text)
    assert cli.main(["check", str(path)]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert str(path) in captured.err
    assert all(part in captured.err for part in wanted), captured.err


def test_a_model_that_nobody_knows_gets_the_nearest(tmp_path: Path, capsys: Capture) -> None:
    path = tmp_path / "model.toml"
    path.write_text(HEAD.replace("random-velocity", "random-velocty") + claim("1", r"\alpha = 1"))
    status = cli.main(["check", str(path)])
    captured = capsys.readouterr()
    assert status in {1, 2}
    assert "random-velocty" in captured.out + captured.err


@pytest.mark.parametrize(
    ("content", "message"),
    [(b"#" * (2**20 + 1), "more than 1048576 bytes"), (b'title = "\xff"', "cannot be read")],
)
def test_files_of_another_kind_have_status_2(
    content: bytes, message: str, tmp_path: Path, capsys: Capture
) -> None:
    path = tmp_path / "bad.toml"
    path.write_bytes(content)
    assert cli.main(["check", str(path)]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("paper.tex", "gainproof check --draft paper.tex --out paper.toml"),
        ("none.toml", "none.toml: cannot be read: No such file"),
        ("none.tml", "none.tml: cannot be read: No such file"),
        ("q", "no claim file is called 'q'; `gainproof list` shows"),
    ],
)
def test_files_that_are_none(name: str, message: str, capsys: Capture) -> None:
    assert cli.main(["check", name]) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize("seconds", ["x", "0", "nan", "-1", "1e9"])
def test_seconds_that_are_none(seconds: str, capsys: Capture) -> None:
    with pytest.raises(SystemExit) as end:
        cli.main(["check", "--seconds", seconds])
    assert end.value.code == 2
    assert "more than 0 seconds" in capsys.readouterr().err


@pytest.mark.skipif(not Path("/dev/zero").exists(), reason="needs a file without end")
def test_a_file_without_end_is_refused() -> None:
    assert cli.main(["check", "/dev/zero"]) == 2


def test_explain_shows_proof_and_witness(file: Path, capsys: Capture) -> None:
    """In a file that was never judged whole."""
    file.write_text(file.read_text().replace("Notes on a filter", "Notes to be explained"))
    assert cli.main(["explain", str(file), "1"]) == 0
    text = capsys.readouterr().out
    assert text.startswith("1: proved\n")
    assert "Shown about the setting before" in text
    assert cli.main(["explain", str(file), "2"]) == 0
    text = capsys.readouterr().out
    assert text.startswith("2: refuted\n")
    assert "\nCounterexample\n  at " in text


def test_explain_an_unknown_claim_names_the_nearest(capsys: Capture) -> None:
    assert cli.main(["explain", "kosuge-slides", "table-ab-RW"]) == 2
    assert "nearest: table-ab-RV" in capsys.readouterr().err


def test_a_damaged_cache_entry_is_judged_again(
    file: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Capture
) -> None:
    """`refuted` turned into `proved` inside the cache is not believed."""
    cache = tmp_path / "cache"
    ignored = shutil.ignore_patterns("trial-*", "*.lock*")
    shutil.copytree(default_folder(), cache, ignore=ignored)
    monkeypatch.setenv("GAINPROOF_CACHE", str(cache))
    cli.main(["check", str(file), "--json"])
    first = as_json(capsys)
    kept = list(cache.glob("trial-*.json"))
    assert kept
    for path in kept:
        path.write_bytes(path.read_bytes().replace(b"refuted", b"proved"))
    assert cli.main(["check", str(file), "--json"]) == 0
    again = as_json(capsys)
    verdicts = [[c["verdict"] for c in data["claims"]] for data in (first, again)]
    assert verdicts == [["proved", "refuted"]] * 2


def test_files_of_the_other_kind_are_told_where_they_belong(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    model, claims = tmp_path / "model.py", tmp_path / "claims.toml"
    model.write_text("import sympy\n", encoding="utf-8")
    claims.write_text("raise SystemExit('executed')\n", encoding="utf-8")
    assert cli.main(["check", str(model)]) == 2
    assert f"gainproof derive {model}" in capsys.readouterr().err
    assert cli.main(["derive", str(claims)]) == 2
    assert f"gainproof check {claims}" in capsys.readouterr().err
    assert cli.main(["generate", str(claims), "--out", str(tmp_path / "made")]) == 2
    assert f"gainproof check {claims}" in capsys.readouterr().err


def test_a_logarithm_without_a_base_is_said_to_be_natural(tmp_path: Path, capsys: Capture) -> None:
    path = tmp_path / "own.toml"
    path.write_text(HEAD + claim("1", r"\log \Lambda^2 = 2 \log \Lambda"), encoding="utf-8")
    cli.main(["check", str(path)])
    assert "\\log without a base is read as the natural logarithm" in capsys.readouterr().out
    said = HEAD.replace("[settings.steady]", "logarithm = 10\n\n[settings.steady]", 1)
    for text in (
        said + claim("1", r"\log \Lambda^2 = 2 \log \Lambda"),
        HEAD + claim("1", r"\log_{2} \Lambda^2 = 2 \log _2 \Lambda"),
        HEAD + claim("1", r"\ln \Lambda^2 = 2 \ln \Lambda"),
    ):
        path.write_text(text, encoding="utf-8")
        cli.main(["check", str(path)])
        assert "natural logarithm" not in capsys.readouterr().out


BROKEN = r"""format = "gainproof claims 1"
[source]
key = "notes"
title = "Notes"
authors = ["A"]
publication = "none"
[settings.s]
title = "numbers"
kind = "algebra"
[settings.s.symbols]
'x' = { unit = "mm", meaning = "an angle" }
'y' = { unit = "1", meaning = "a number" }
[[claims]]
id = "good"
place = "1"
kind = "identity"
setting = "s"
latex = 'y + y = 2y'
[[claims]]
id = "rests"
place = "2"
kind = "identity"
setting = "s"
latex = 'x + x = 2x'
[[claims]]
id = "bad"
place = "3"
kind = "identity"
setting = "s"
latex = 'y + z = y'
"""


@pytest.fixture
def broken(tmp_path: Path) -> Path:
    path = tmp_path / "notes.toml"
    path.write_text(BROKEN, encoding="utf-8")
    return path


def test_all_errors_are_told_in_one_run(broken: Path, capsys: Capture) -> None:
    assert cli.main(["check", str(broken)]) == 2
    shown = capsys.readouterr()
    assert not shown.out
    assert "line 11: settings.s.symbols.x.unit: 'mm' is no unit: write m" in shown.err
    assert "line 30, column 14: claims.bad.latex: the symbol z is not declared" in shown.err
    assert shown.err.count("claims.") == 1


def test_errors_as_data(broken: Path, capsys: Capture) -> None:
    assert cli.main(["check", str(broken), "--json"]) == 2
    shown = capsys.readouterr()
    assert not shown.err
    first, second = json.loads(shown.out)["errors"]
    assert (first["line"], first["column"], first["where"]) == (
        11,
        None,
        "settings.s.symbols.x.unit",
    )
    assert (second["line"], second["column"], second["token"]) == (30, 14, "z")
    assert second["message"] == "the symbol z is not declared"
    assert second["text"].endswith("^")
    assert first["file"] == second["file"]
    assert first["file"].endswith("notes.toml")


def test_a_file_that_is_missing_as_data(tmp_path: Path, capsys: Capture) -> None:
    assert cli.main(["check", str(tmp_path / "none.toml"), "--json"]) == 2
    (error,) = json.loads(capsys.readouterr().out)["errors"]
    assert "cannot be read" in error["message"]
    assert error["line"] is None


def test_what_can_be_read_is_judged(broken: Path, capsys: Capture) -> None:
    assert cli.main(["check", str(broken), "--keep-going"]) == 2
    shown = capsys.readouterr()
    assert "good  proved" in shown.out
    assert "not judged, for errors: rests, bad" in shown.out
    assert shown.err.count("line ") == 2
    assert cli.main(["check", str(broken), "--keep-going", "--json"]) == 2
    judged = json.loads(capsys.readouterr().out)
    assert [(claim["id"], claim["verdict"]) for claim in judged["claims"]] == [("good", "proved")]
    assert judged["not_judged"] == ["rests", "bad"]
    assert len(judged["errors"]) == 2


def test_a_file_without_errors_is_the_same_with_keep_going(broken: Path, capsys: Capture) -> None:
    broken.write_text(BROKEN.replace('"mm"', '"m"').replace("y + z", "y + 0"), encoding="utf-8")
    assert cli.main(["check", str(broken), "--keep-going", "--json"]) == 0
    judged = json.loads(capsys.readouterr().out)
    assert (judged["errors"], judged["not_judged"]) == ([], [])
    assert [claim["verdict"] for claim in judged["claims"]] == ["proved"] * 3


def test_no_errata_of_a_file_with_errors(broken: Path, capsys: Capture) -> None:
    assert cli.main(["check", str(broken), "--keep-going", "--errata"]) == 2
    assert "made of files without errors" in capsys.readouterr().err


def test_a_file_of_formulas_alone_is_checked_explained_and_has_errata(
    tmp_path: Path, capsys: Capture
) -> None:
    path, sheet = tmp_path / "gains.toml", tmp_path / "sheet.md"
    path.write_text(
        'format = "gainproof claims 1"\nsymbols = "usual"\n'
        "claims = ['beta = 2(2 - alpha) + 4 sqrt(1 - alpha)', '\\alpha < 1']\n"
        '[source]\ntitle = "Notes"\n[settings.s]\ntitle = "s"\nkind = "steady_state"\n'
        'model = "random-acceleration"\n',
        encoding="utf-8",
    )
    assert cli.main(["check", str(path), "--errata", str(sheet)]) == 0
    shown = capsys.readouterr().out
    assert "1  refuted" in shown
    assert "2  proved" in shown
    assert "sign of a term" in sheet.read_text(encoding="utf-8")
    said = claims_said(path.read_text(encoding="utf-8"))
    meanings = ((r"\beta", "gain of the velocity"), (r"\alpha", "gain of the position"))
    assert said["1"].symbols == meanings
    assert said["2"].origin == "printed"
    assert cli.main(["explain", str(path), "2"]) == 0
    assert "2: proved" in capsys.readouterr().out
