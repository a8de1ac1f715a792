"""`gainproof design --plot`: curves, the choice on each of them, files that come out the same."""

from __future__ import annotations

import csv
import itertools
import json
from pathlib import Path

import pytest

from gainproof import cli
from gainproof.design.curves import curves
from gainproof.design.drawing import draw
from gainproof.design.sheet import Sheet, row_of, sheet

Capture = pytest.CaptureFixture[str]


def answer(capsys: Capture, *arguments: str, status: int = 0) -> str:
    """What is printed."""
    assert cli.main(["design", *arguments]) == status
    return capsys.readouterr().out


def data(capsys: Capture, *arguments: str, status: int = 0) -> dict[str, dict[str, object]]:
    """The filters of the JSON by name; the first of a name."""
    found = json.loads(answer(capsys, *arguments, "--json", status=status))
    return {each["name"]: each for each in reversed(found["filters"])}


def test_the_plot_marks_the_choice_on_each_curve(capsys: Capture, tmp_path: Path) -> None:
    """Its CSV: a row at each chosen lag, with the variance of the table; the curves fall."""
    path = tmp_path / "plots" / "picture.csv"
    arguments = ("--states", "3", "--tracking-index", "0.1", "--plot", str(path))
    found = data(capsys, *arguments)
    rows = list(csv.DictReader(path.read_text().splitlines()))
    for name in ("RA", "RJ", "MV"):
        (row,) = (row for row in rows if row[f"chosen_{name}"])
        assert float(row["lag"]) == found[name]["lag"]
        assert float(row[f"chosen_{name}"]) == found[name]["predicted_variance"]
        assert float(row[name]) == pytest.approx(float(row[f"chosen_{name}"]), rel=1e-12)
        curve = [float(row[name]) for row in rows if row[name]]
        assert len(curve) > 200
        assert all(a > b for a, b in itertools.pairwise(curve))


@pytest.mark.parametrize(
    "arguments",
    [
        ("--lag", "1e30"),
        ("--lag", "1e29"),
        ("--lag", "0.2500001"),
        ("--gains", "1.9", "0.05", "0.01"),
    ],
)
def test_curves_end_where_filters_do(
    capsys: Capture, tmp_path: Path, arguments: tuple[str, ...]
) -> None:
    """A choice next to an end of the domain, or one that no named filter is near to."""
    path = tmp_path / "x.csv"
    answer(capsys, *arguments, "--plot", str(path))
    rows = list(csv.DictReader(path.read_text().splitlines()))
    assert all(float(row["lag"]) <= 1e30 for row in rows)
    assert {row["MV"] != "" for row in rows} == {True}


def test_a_picture_and_its_numbers_come_out_the_same(capsys: Capture, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    made = []
    for folder in ("a", "b"):
        path = tmp_path / folder / "x.svg"
        answer(capsys, "--gains", "0.4571", "0.5", "--plot", str(path))
        assert sorted(each.name for each in path.parent.iterdir()) == ["x.csv", "x.svg"]
        made.append([path.read_bytes(), path.with_suffix(".csv").read_bytes()])
    assert made[0] == made[1]
    assert b"chosen_given" in made[0][1]


def test_gains_of_ones_own_are_inside_the_axes() -> None:
    """alpha = 1.99 and beta = 0.01 have a variance far above every curve."""
    pytest.importorskip("matplotlib")
    from matplotlib.figure import Figure

    given = row_of("given", "gains given", (1.99, 0.01))
    made = Sheet(2, "gains", (1.99, 0.01), (given, *sheet(2, "lag", 100.0).rows))
    paper = Figure()
    draw(curves(made), paper, 2)
    (axes,) = paper.axes
    bottom, top = axes.get_ylim()
    left, right = axes.get_xlim()
    assert bottom < given.predicted < top
    assert left < given.lag < right


def test_no_folder_of_figures_has_a_nul_byte(capsys: Capture) -> None:
    assert cli.main(["figure", "suzuki", "2", "--out", "a\0b"]) == 2
    assert "--out takes the name of a folder, got 'a\\x00b'" in capsys.readouterr().err
