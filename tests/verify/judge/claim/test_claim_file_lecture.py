"""The claim file of the lecture: what growing memories, steady states and free gains cover."""

from __future__ import annotations

from pathlib import Path

import pytest

import gainproof.verify
from gainproof.verify.judge.claim.file import ClaimFile, read_claim_file
from gainproof.verify.judge.reader.latex_printer import reading_to_latex
from gainproof.verify.judge.reader.reader import read_formula


@pytest.fixture(scope="module")
def lecture() -> ClaimFile:
    folder = Path(gainproof.verify.__file__).parent / "claims"
    return read_claim_file(folder / "kosuge-slides.toml")


def test_every_claim_has_its_line_and_place(lecture: ClaimFile) -> None:
    lines = [claim.line for claim in lecture.claims]
    assert lines == sorted(set(lines))
    assert all(claim.place for claim in lecture.claims)


def test_remarks_say_why(lecture: ClaimFile) -> None:
    remarks = [claim for claim in lecture.claims if claim.kind == "remark"]
    assert remarks
    assert all(claim.text and claim.note for claim in remarks)


def test_rows_of_the_tables_are_searched(lecture: ClaimFile) -> None:
    """A claim about one steady state names its model in its text, and is no row of a table."""
    steady = [setting for setting in lecture.settings.values() if setting.kind == "steady_state"]
    rows = [setting for setting in steady if setting.name != "kalman_steady"]
    assert [setting.name for setting in rows] == [
        "random_velocity",
        "random_acceleration",
        "random_acceleration_3",
        "random_jerk",
    ]
    assert all(setting.model == "search" and setting.gain == "filter" for setting in rows)


def test_degrees_of_the_fits(lecture: ClaimFile) -> None:
    degrees = {
        setting.name: setting.degree
        for setting in lecture.settings.values()
        if setting.kind == "growing_memory"
    }
    assert degrees == {"mean": 0, "line": 1, "parabola": 2}


def test_domains_printed_with_the_gains(lecture: ClaimFile) -> None:
    found = {claim.id: claim for claim in lecture.claims}
    for name, first in (("line-alpha", "1"), ("table-abg-parabola-gamma", "2")):
        formula = found[name].formula
        assert formula is not None
        (condition,) = formula.readings[0].conditions
        assert condition.operator == "<="
        assert condition.left["nodes"] == [["number", first]]


def test_everything_printed_reads_back(lecture: ClaimFile) -> None:
    for claim in lecture.claims:
        symbols = lecture.settings[claim.setting].symbols
        for reading in claim.formula.readings if claim.formula else ():
            (again,) = read_formula(reading_to_latex(reading), symbols).readings
            assert again.relations == reading.relations
            assert again.conditions == reading.conditions
