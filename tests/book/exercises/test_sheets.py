"""Sheets of exercises: one line refuted on each, every other step accepted by the checker."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest
from catalogue_subjects import certificate, derived
from judged_derivations.relation import judge_statement
from judged_derivations.surroundings import surroundings
from one_of_each import cases

from gainproof.bad_input import BadInputError
from gainproof.book import site
from gainproof.book.exercises.making_sheets import require_sound
from gainproof.book.exercises.planting import Planted, plant, with_claim
from gainproof.book.exercises.refutation import agree, refuted
from gainproof.book.exercises.sheet_lines import answer, region, seal, sheet_lines
from gainproof.book.exercises.sheet_notebook import key_cells, sheet_cells
from gainproof.book.exercises.sheet_pages import key_file, sheet_pages
from gainproof.book.exercises.tower_values import tower_values
from gainproof.notebook.cells import notebook
from gainproof.pages.lecture_items import items
from gainproof.subjects.derived import Derived
from gainproof.subjects.rechecking import expected_of, recheck

SUBJECTS = ("random-velocity", "least-squares-line", "filter-step")
SEEDS = cases([1, 2, 3], lambda seed: seed == 1)


@pytest.fixture(scope="module")
def subjects() -> list[Derived]:
    return [derived(name) for name in SUBJECTS]


@pytest.fixture(scope="module", params=SEEDS)
def sheets(request: pytest.FixtureRequest, subjects: Sequence[Derived]) -> list[Planted]:
    """Three sheets of one seed."""
    return plant(subjects, 3, request.param)


@pytest.fixture(scope="module")
def reports(sheets: Sequence[Planted]) -> list[dict[str, Any]]:
    """What the checker says of each sheet's certificate."""
    return [recheck(sheet.derived.certificate, expected_of(sheet.derived)) for sheet in sheets]


def test_checker_rejects_the_planted_line_and_proves_the_others(
    sheets: Sequence[Planted], reports: Sequence[dict[str, Any]]
) -> None:
    for sheet, report in zip(sheets, reports, strict=True):
        words = {entry["id"]: entry["status"] for entry in report["statements"]}
        assert words.pop(sheet.id) == "rejected"
        assert set(words.values()) <= {"proved", "cited", "definition"}
        assert len(words) == len(sheet.derived.steps) - 1
        require_sound(sheet, report)


def test_every_other_step_is_as_it_was_derived(sheets: Sequence[Planted]) -> None:
    for sheet in sheets:
        whole = derived(sheet.derived.name)
        changed = [
            new.id for new, old in zip(sheet.derived.steps, whole.steps, strict=True) if new != old
        ]
        assert changed == [sheet.id]
        mended = with_claim(sheet.derived, sheet.id, sheet.before.claim)
        # which is accepted as it stands: `gainproof run` and its tests
        assert mended.certificate == whole.certificate


def test_witnesses_are_rational_points_with_sides_apart(sheets: Sequence[Planted]) -> None:
    for sheet in sheets:
        witness = sheet.witness
        assert all(Fraction(value) is not None for value in witness.point.values())
        left, right = (
            {k: Fraction(v) for k, v in s.items()} for s in (witness.left, witness.right)
        )
        gap = abs(left["midpoint"] - right["midpoint"])
        assert gap > left["radius"] + right["radius"]


def test_judge_refutes_by_its_own_steady_state(subjects: Sequence[Derived]) -> None:
    """The judge solves the model itself and knows nothing of the derivation's tower but names."""
    subject = subjects[0]
    assert subject.name == "random-velocity"
    for seed in range(4):
        (sheet,) = plant([subject], 1, seed)
        tower = certificate(subject.name)["towers"][sheet.step.tower]
        around = surroundings(subject.model, None, tower)
        kind = sheet.step.kind
        spoiled = judge_statement(kind, sheet.step.claim, programs={}, around=around)
        whole = judge_statement(kind, sheet.before.claim, programs={}, around=around)
        assert spoiled.verdict in ("refuted", "conditional"), (seed, sheet.id, spoiled.reason)
        assert whole.verdict == "proved"


def test_nothing_true_is_refuted(subjects: Sequence[Derived]) -> None:
    for subject in subjects:
        for name, written in subject.certificate["towers"].items():
            tower = tower_values(written)
            assert tower is not None
            for step in subject.steps:
                if step.tower == name:
                    assert agree(step.kind, step.claim, tower), step.id


def test_a_tower_that_is_read_wrongly_is_seen(subjects: Sequence[Derived]) -> None:
    written = subjects[0].certificate["towers"]["main"]
    alpha = written["elements"]["alpha"]
    twice = {**alpha, "num": [[str(2 * Fraction(c)), powers] for c, powers in alpha["num"]]}
    tower = tower_values({**written, "elements": {**written["elements"], "alpha": twice}})
    assert tower is not None
    steps = [step for step in subjects[0].steps if step.tower == "main" and step.kind == "equal"]
    assert not all(agree(step.kind, step.claim, tower) for step in steps)


def test_a_mutant_that_is_true_is_not_refuted() -> None:
    tower = tower_values(
        {"parameters": [{"symbol": "p", "above": "0"}], "generators": [], "elements": {}}
    )
    assert tower is not None
    twice = {"nodes": [["symbol", "p"], ["add", 0, 0]], "outputs": {"value": 1}}
    also = {"nodes": [["number", "2"], ["symbol", "p"], ["mul", 0, 1]], "outputs": {"value": 2}}
    square = {"nodes": [["symbol", "p"], ["pow", 0, "2"]], "outputs": {"value": 1}}
    same = {"left": twice, "right": also, "free": []}
    other = {"left": twice, "right": square, "free": []}
    assert refuted("equal", same, tower, same) is None
    # at p = 2 both sides are 4: another point shows it
    found = refuted("equal", other, tower, other)
    assert found is not None
    assert found.point == {"p": "1"}


def test_a_spoiled_second_line_is_seen(sheets: Sequence[Planted]) -> None:
    sheet = next(sheet for sheet in sheets if sheet.derived.name == "random-velocity")
    other = next(
        step for step in sheet.derived.steps if step.kind == "positive" and step.id != sheet.id
    )
    spoiled = with_claim(sheet.derived, other.id, {"expression": _number("-1")})
    report = recheck(spoiled.certificate, expected_of(spoiled))
    with pytest.raises(ArithmeticError, match="1 rejected"):
        require_sound(replace(sheet, derived=spoiled), report)


def test_a_sheet_whose_line_is_accepted_is_refused(sheets: Sequence[Planted]) -> None:
    sheet = sheets[0]
    whole = derived(sheet.derived.name)
    report = recheck(whole.certificate, expected_of(whole))
    with pytest.raises(ArithmeticError, match="is proved"):
        require_sound(replace(sheet, derived=whole), report)


def test_same_seed_same_sheets(subjects: Sequence[Derived]) -> None:
    backwards = plant(subjects[::-1], 3, 2)
    assert key_file(plant(subjects, 3, 2)) == key_file(backwards)
    assert key_file(plant(subjects, 3, 2)) != key_file(plant(subjects, 3, 1))


def test_nothing_to_plant_in(subjects: Sequence[Derived]) -> None:
    with pytest.raises(BadInputError, match="none of the derivations"):
        plant([replace(subjects[0], steps=())], 1, 1)


def test_pages_do_not_show_the_answer(
    sheets: Sequence[Planted], reports: Sequence[dict[str, Any]]
) -> None:
    chosen = sheets[:3]
    made = site.files(sheet_pages(chosen, reports[:3]), {"exercises.js": ""}, lambda _: None)
    for sheet in chosen:
        text = made[f"exercises/sheet-{sheet.number}.html"].decode()
        assert f'id="line-{sheet.line}"' in text
        assert "rejected" not in text
        assert answer(sheet) not in text
        assert f"({sheet.slip};" not in text
        assert "answers.html#" not in text
        assert sheet.slip in made["answers.html"].decode()
        assert made["static/search-index.js"].decode().count(sheet.derived.title) == 0
    assert [entry["line"] for entry in json.loads(key_file(chosen))] == [s.line for s in chosen]


def test_marks(sheets: Sequence[Planted]) -> None:
    for sheet in sheets:
        sealed = seal(sheet)
        near = region(sheet.derived, sheet.line, sheet.first, sheet.last)
        shown = [line.number for line in sheet_lines(sheet, "../")]
        points = {number: sealed.points(number) for number in shown}
        assert points[sheet.line] == 2
        assert {n for n, half in points.items() if half == 1} == set(near) - {sheet.line}
        assert sealed.answer(sheet.line).startswith(f"Line {sheet.line} is wrong")
        assert {sheet.line - 1, sheet.line + 1} & set(shown) <= set(near)
        with pytest.raises(ValueError, match="not the wrong one"):
            sealed.answer(sheet.line + 1)


def test_sheets_as_notebooks(sheets: Sequence[Planted]) -> None:
    for sheet in sheets:
        cells = sheet_cells(sheet)
        text = "\n".join(cell.text for cell in cells)
        assert answer(sheet) not in text
        assert f"({sheet.slip};" not in text
        known: dict[str, Any] = {}
        exec(cells[-2].text, known)  # noqa: S102 (the notebook's own code, as it would be run)
        assert known["sheet"] == seal(sheet)
        exec(cells[-1].text, known)  # noqa: S102
        assert known["sheet"].told(None) == "No line is marked."
        assert "is wrong" in known["sheet"].told(sheet.line)
        assert "holds" in known["sheet"].told(sheet.line - 1)
        shown = [cell for cell in cells if f"**{sheet.line}.** " in cell.text]
        assert len(shown) == 1
    assert notebook(sheet_cells(sheets[0])) == notebook(sheet_cells(sheets[0]))
    assert "is wrong" in notebook(key_cells(sheets))


def test_sheets_are_whole_parts(sheets: Sequence[Planted]) -> None:
    for sheet in sheets:
        lines = items(sheet.derived.steps)
        opened = {line.number for line in lines if line.first.heading}
        assert sheet.first in opened
        assert sheet.first <= sheet.line <= sheet.last
        assert sheet.last == len(lines) or sheet.last + 1 in opened


def _number(text: str) -> dict[str, object]:
    return {"nodes": [["number", text]], "outputs": {"value": 0}}
