"""Figures: files that come out the same, what is said where Matplotlib is missing, the data."""

from __future__ import annotations

import csv
import io
import json
import os
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest

from gainproof import cli
from gainproof.figures import catalogue
from gainproof.figures.catalogue import CATALOGUE
from gainproof.figures.entry import Entry
from gainproof.plots.table import Column, Table, Words, decades

Capture = pytest.CaptureFixture[str]
IDS = [entry.file for entry in CATALOGUE]
FIGURE_2 = "suzuki-figure-2"


DRAW_ALL = """
import sys
from gainproof import cli
folder, *names = sys.argv[1:]
commands = [["figure", *name.split("/"), "--out", folder] for name in names]
sys.exit(any([cli.main(command) for command in commands]))
"""
SOME = ("lecture/alpha-beta-turn",)
"""Curves with seeded noise and notes; maps are among all."""


def drawn(folder: Path, names: list[str], seed: str) -> dict[str, bytes]:
    """The files of these figures, drawn in a process of their own."""
    command = [sys.executable, "-c", DRAW_ALL, str(folder), *names]
    environment = {**os.environ, "PYTHONHASHSEED": seed}
    subprocess.run(command, check=True, capture_output=True, env=environment)
    return files_in(folder)


def files_in(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in sorted(folder.iterdir())}


@pytest.mark.parametrize(
    "names",
    [
        SOME,
        pytest.param(
            [f"{entry.source}/{entry.name}" for entry in CATALOGUE], marks=pytest.mark.thorough
        ),
    ],
    ids=["some", "all"],
)
def test_figures_come_out_the_same_and_without_a_date(tmp_path: Path, names: list[str]) -> None:
    """In whatever order they are drawn, with whatever hashes, here or in a process of their own."""
    pytest.importorskip("matplotlib")
    for name in names:
        assert cli.main(["figure", *name.split("/"), "--out", str(tmp_path / "1")]) == 0
    first = files_in(tmp_path / "1")
    second = drawn(tmp_path / "2", [*names[::-1]], "2")
    files = [catalogue.find(*name.split("/")).file for name in names]
    assert set(first) == {f"{file}.{ending}" for file in files for ending in ("csv", "svg", "png")}
    assert {name for name in first | second if first.get(name) != second.get(name)} == set()
    for file in files:
        svg = first[f"{file}.svg"].decode()
        assert "<dc:date>" not in svg
        assert ET.fromstring(svg).tag.endswith("svg")
        png = first[f"{file}.png"]
        assert png.startswith(b"\x89PNG")
        assert b"Software" not in png


ALIKE = ("patent-figure-9", "patent-comparison", "doppler-monte-carlo", "doppler-detection")
"""Tables of runs like another one, or of runs by the thousand that another test looks at."""


@pytest.mark.alike
@pytest.mark.parametrize(
    "entry",
    [
        pytest.param(entry, marks=[pytest.mark.thorough] if entry.file in ALIKE else [])
        for entry in CATALOGUE
    ],
    ids=IDS,
)
def test_the_csv_holds_the_numbers_to_the_last_bit(entry: Entry) -> None:
    table = entry.table()
    lines = table.csv().splitlines(keepends=True)
    notes = [line for line in lines if line.startswith("#")]
    assert lines[: len(notes)] == notes == [f"# {note}\n" for note in table.notes]
    rows = list(csv.DictReader(io.StringIO("".join(lines[len(notes) :]))))
    for column in table.columns:
        if isinstance(column, Words):
            assert [row[column.name] for row in rows] == list(column.values)
            continue
        read = [float(row[column.name] or "nan") for row in rows]
        assert np.array_equal(read, column.values, equal_nan=True)


def test_without_matplotlib_the_numbers_are_written_and_the_picture_says_what_is_missing(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    command = ["figure", "suzuki", "2", "--out", str(tmp_path)]
    assert cli.main(command) == 2
    assert "pip install 'gainproof[figures]'" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
    assert cli.main([*command, "--csv"]) == 0
    assert [path.name for path in tmp_path.iterdir()] == [f"{FIGURE_2}.csv"]


def test_json_holds_the_same_numbers(
    tmp_path: Path, capsys: Capture, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["figure", "suzuki", "2", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["figure"] == FIGURE_2
    (entry,) = (entry for entry in CATALOGUE if entry.file == FIGURE_2)
    assert data["columns"]["S"]["values"] == entry.table()["S"].tolist()
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["suzki", "1"], "nearest: suzuki"),
        (["suzki"], "nearest: suzuki"),
        (["lecture", "kalman-tur"], "nearest: kalman-turn"),
        (["lecture", "--csv"], "which figure of lecture? mean-and-line, gains"),
        (["suzuki", "4"], "known: 1, 2, 3, digits"),
        (["suzuki", "digit"], "nearest: digits"),
        (["suzuki", "1", "--json", "--out", "x"], "writes no file"),
        (["suzuki", "1", "--csv", "--out", __file__], "cannot be written"),
    ],
)
def test_bad_input_has_status_2(arguments: list[str], message: str, capsys: Capture) -> None:
    assert cli.main(["figure", *arguments]) == 2
    assert message in capsys.readouterr().err


def test_what_is_no_number_is_an_empty_cell_and_null() -> None:
    column = Column("x", "a number", np.array([1.5, np.nan, np.inf]))
    table = Table("t", (column,))
    assert table.csv() == "x\n1.5\n\ninf\n"
    assert table.plain()["columns"]["x"]["values"] == [1.5, None, "inf"]


def test_whole_powers_of_ten_are_exact() -> None:
    assert decades(-6, 6, 1).tolist() == [float(f"1e{power}") for power in range(-6, 7)]
    assert decades(0, 2, 4)[[0, 4, 8]].tolist() == [1.0, 10.0, 100.0]


def test_words_notes_and_numbers_stand_in_one_csv() -> None:
    words = Words("name", "a word", ("a, b", 'c "d"'))
    column = Column("x", "a number", np.array([1.5, np.nan]))
    table = Table("t", (words, column), {}, ("first", "second"))
    assert table.csv() == '# first\n# second\nname,x\n"a, b",1.5\n"c ""d""",\n'
    assert table.plain()["notes"] == ["first", "second"]
    assert table.plain()["columns"]["name"]["values"] == ["a, b", 'c "d"']
    assert table.words("name") == ("a, b", 'c "d"')
    for absent in (lambda: table["name"], lambda: table.words("x")):
        with pytest.raises(KeyError):
            absent()


def test_without_a_name_the_figures_of_a_source_are_listed(capsys: Capture) -> None:
    assert cli.main(["figure", "lecture"]) == 0
    lines = capsys.readouterr().out.splitlines()
    own = [entry for entry in CATALOGUE if entry.source == "lecture"]
    assert [line.split()[0] for line in lines] == [entry.name for entry in own]
    assert all(line.endswith(entry.shows) for line, entry in zip(lines, own, strict=True))
    assert cli.main(["figure", "lecture", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == {entry.name: entry.shows for entry in own}
