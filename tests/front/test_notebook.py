"""Notebooks: written the same each time, run from top to bottom, every line checked in them; and
what shows itself in one.
"""

from __future__ import annotations

import ast
import asyncio
import importlib
import importlib.util
import json
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from catalogue_subjects import derived
from lecture_judged import LECTURE

import gainproof
from gainproof.bad_input import BadInputError
from gainproof.book.exercises.planting import plant
from gainproof.cli import main
from gainproof.derive.catalogue import CATALOGUE
from gainproof.jobs.session import open_session
from gainproof.notebook import cells
from gainproof.notebook.derivation_notebook import derivation_cells
from gainproof.notebook.front_door import Derivation
from gainproof.notebook.judged_file import JudgedFile
from gainproof.pages.lecture_items import items
from gainproof.pages.lecture_latex import document
from gainproof.subjects.derivations import own_report
from gainproof.subjects.rechecking import expected_of, recheck
from gainproof.verify.judge.verdict import ClaimVerdict

SHORT = "least-squares-line"
OTHERS = [
    pytest.param(entry.name, marks=() if entry.name == SHORT else pytest.mark.thorough)
    for entry in CATALOGUE
]
HEAVY = ("sympy", "numpy", "flint", "lark", "nbformat", "matplotlib")


def shown(name: str) -> Derivation:
    subject = derived(name)
    return Derivation(subject, recheck(subject.certificate, expected_of(subject)))


def values(written: Sequence[cells.Cell]) -> dict[str, str]:
    """What Python shows of the last expression of each cell of code, by the cell's text."""
    names: dict[str, Any] = {}
    found = {}
    for cell in written:
        if cell.kind == "code":
            *first, last = ast.parse(cell.text).body
            # our own cells, as a user's Python would execute them
            exec(compile(ast.Module(first, []), "cell", "exec"), names)  # noqa: S102
            if isinstance(last, ast.Expr):
                value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)  # noqa: S307
                found[cell.text] = repr(value)
            else:
                exec(compile(ast.Module([last], []), "cell", "exec"), names)  # noqa: S102
    return found


def run(text: str) -> Any:
    """The notebook after all its cells were executed. Raises CellExecutionError."""
    nbclient = pytest.importorskip("nbclient")

    # without types
    book = importlib.import_module("nbformat").reads(text, as_version=4)
    nbclient.NotebookClient(book, timeout=900, kernel_name="python3").execute()
    return book


def test_every_line_is_accepted_where_the_cells_are_executed() -> None:
    subject = derived(SHORT)
    shown = values(derivation_cells(subject, SHORT))
    asked = [value for cell, value in shown.items() if cell.startswith("derivation.check(")]
    assert len(asked) == len(items(subject.steps))
    words = [line.rsplit(": ", 1)[1] for value in asked for line in value.split("\n")]
    assert len(words) == sum(step.shown for step in subject.steps)
    assert set(words) <= {"proved", "cited", "definition"}


@pytest.mark.thorough
@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_notebook_runs_and_every_line_is_accepted(name: str) -> None:
    subject = derived(name)
    book = run(cells.notebook(derivation_cells(subject, name)))
    asked = [cell for cell in book.cells if cell.source.startswith("derivation.check(")]
    assert len(asked) == len(items(subject.steps))
    words = [
        line.rsplit(": ", 1)[1]
        for cell in asked
        for line in cell.outputs[0]["data"]["text/plain"].split("\n")
    ]
    assert len(words) == sum(step.shown for step in subject.steps)
    assert set(words) <= {"proved", "cited", "definition"}


@pytest.mark.thorough
def test_a_cell_that_fails_is_seen() -> None:
    exceptions = pytest.importorskip("nbclient.exceptions")
    subject = derived(SHORT)
    written = derivation_cells(subject, SHORT)
    wrong = [*written, cells.Cell("code", "assert derivation.check('no-such-step')")]
    with pytest.raises(exceptions.CellExecutionError, match="no-such-step"):
        run(cells.notebook([written[1], wrong[-1]]))


def test_the_same_bytes_and_nothing_of_the_day(tmp_path: Path) -> None:
    derived(SHORT)
    file = tmp_path / "line.ipynb"
    assert main(["derive", SHORT, "--notebook", str(file)]) == 0
    first = file.read_bytes()
    assert main(["derive", SHORT, "--notebook", str(file)]) == 0
    assert file.read_bytes() == first
    book = json.loads(first)
    assert [cell["id"] for cell in book["cells"][:2]] == ["cell-1", "cell-2"]
    assert all(not cell.get("outputs") for cell in book["cells"])


def test_another_name_is_refused(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["derive", SHORT, "--notebook", str(tmp_path / "line.txt")]) == 2
    assert ".ipynb is wanted" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_what_is_missing_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cells, "find_spec", lambda _: None)
    with pytest.raises(BadInputError, match=r"gainproof\[notebook\]"):
        cells.notebook([])


def test_importing_gainproof_imports_nothing_heavy() -> None:
    program = f"import sys, gainproof; print([n for n in {HEAVY} if n in sys.modules])"
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"
    names = {"BadInputError", "Judge", "__version__", "ask", "check", "derivation", "steady_state"}
    assert set(gainproof.__all__) == names


def test_where_a_loop_runs_already() -> None:
    """As in every notebook: deriving waits for processes by a loop of its own."""

    async def asked() -> Derivation:
        return gainproof.derivation(SHORT, fresh=True)

    assert asyncio.run(asked()).accepted


@pytest.mark.usefixtures("lecture_known")
def test_a_claim_file_is_judged() -> None:
    found = gainproof.check(LECTURE)
    assert len(found) == len(list(found))
    assert "proved" in str(found)
    first = next(iter(found))
    assert found[first.claim["id"]] == first
    assert str(first).startswith(f"{first.claim['id']}: {first.verdict}")


def test_a_derivation_shows_itself() -> None:
    found = shown(SHORT)
    assert repr(found) == (
        "<derivation least-squares-line: 23 steps: 21 proved, 1 cited, 1 definition>"
    )
    assert "[proved]" in str(found)
    html = found._repr_html_()
    assert html.count("<em>[") == len(items(found.derived.steps))
    assert "\\frac" in found._repr_latex_()
    assert repr(found.derived) == "<derivation least-squares-line: 23 steps>"
    step = found.step("gain")
    assert repr(step) == "<step gain: proved>"
    assert step._repr_latex_().startswith("$$")
    assert "[proved]" in step._repr_html_()
    assert str(step.step).startswith(step.step.sentence[:10])
    with pytest.raises(BadInputError, match="gain"):
        found.step("gian")


def test_an_error_is_not_called_proved() -> None:
    (sheet,) = plant([derived(SHORT)], 1, 1)
    report = recheck(sheet.derived.certificate, expected_of(sheet.derived))
    spoiled = Derivation(sheet.derived, report)
    assert not spoiled.accepted
    marks = spoiled.check(sheet.id)
    assert marks.words == {sheet.id: "rejected"}
    assert not marks.accepted
    assert "rejected (" in repr(marks)
    assert not spoiled.check().accepted
    assert shown(SHORT).check().accepted


def test_a_model_shows_itself() -> None:
    from gainproof.derive.families.kinematic import position_velocity_model
    from gainproof.derive.families.random_velocity import STRENGTH

    noise = sp.ImmutableDenseMatrix([[0, 0], [0, STRENGTH.symbol**2]])
    model = position_velocity_model("walk", "Velocity random walk", noise, STRENGTH)
    assert str(model).startswith("walk: Velocity random walk\n")
    assert "Q = [[" in str(model)
    assert "\\begin{gathered}F = " in model._repr_latex_()


def test_verdicts_show_themselves() -> None:
    verdict = ClaimVerdict(
        *("1", "here", "identity", "a < b", "refuted", None, None, {}, None, None, None),
        undefined=(),
        reason="at $a = 1$ <b>",
        seconds=0.0,
    )
    assert str(verdict) == "1: refuted (at $a = 1$ <b>)"
    judged = JudgedFile({"source": {"key": "k", "title": "<i>"}, "claims": [verdict.to_json()]}, {})
    assert repr(judged) == "<claims of k: 1 claim: 1 refuted>"
    assert judged["1"].verdict == "refuted"
    assert "&lt;i&gt;" in judged._repr_html_()
    assert "<code>a &lt; b</code>" in judged._repr_html_()
    assert "$" not in judged._repr_html_()
    with pytest.raises(BadInputError):
        judged["2"]


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no pdflatex to compile with")
@pytest.mark.parametrize("name", OTHERS)
def test_latex_compiles(name: str, tmp_path: Path) -> None:
    subject = derived(name)
    report = own_report(subject, open_session(quiet=True))
    (tmp_path / "page.tex").write_text(document(subject, report), encoding="utf-8")
    done = subprocess.run(
        ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "page.tex"],
        cwd=tmp_path,
        capture_output=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, done.stdout.decode(errors="replace")[-2000:]
    assert (tmp_path / "page.pdf").stat().st_size > 10_000


def test_the_library_that_writes_notebooks_is_there() -> None:
    """The extra of the tests holds it: none of the above is skipped for want of it."""
    assert importlib.util.find_spec("nbformat") is not None
