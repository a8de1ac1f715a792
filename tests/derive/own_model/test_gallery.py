"""The gallery of docs/models: file to derived, checked, generated, imported and tested module."""

from __future__ import annotations

import importlib.util
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

import flint
import pytest
import sympy as sp
from graph_kernels import balls
from one_of_each import cases

from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.subject import Subject
from gainproof.subjects.deriving import plain_subject
from gainproof.subjects.generating import printed
from gainproof.subjects.own_file import built, defined
from gainproof.subjects.rechecking import expected_of, recheck
from gainproof.verify.oracles.distance import relative_error
from gainproof.verify.oracles.enclosure import enclose
from gainproof.verify.oracles.state_space import SteadyState, state_space

FOLDER = Path(__file__).resolve().parents[3] / "docs" / "models"
MODELS = sorted(path.stem for path in FOLDER.glob("*.py"))
ONE_OF_EACH = {"correlated_velocity"}
"""A free number; without one there is the README's, three states of the general method are in
`test_odd_three_states`, and the catalogue's own method is that of its families.
"""
CASES = cases(MODELS, lambda name: name in ONE_OF_EACH)
INDICES = (0.0078125, 0.3, 1.0, 2.7, 900.0)
PARAMETERS = (0.0625, 0.5, 0.9)
DIGITS = 60
GAINS = ("alpha", "beta", "gamma")
STEP = Fraction(1, 10**10)
"""Of differences, relative: their error is its square, and 10^-DIGITS over its square."""


@dataclass(frozen=True)
class Made:
    """A subject with its certificate's report and its files."""

    subject: Subject
    report: Mapping[str, Any]
    files: Mapping[str, str]


@cache
def made(name: str) -> Made:
    subject = built(str(FOLDER / f"{name}.py"), *defined(str(FOLDER / f"{name}.py")))
    derived = plain_subject(subject)
    report = recheck(derived.certificate, expected_of(derived))
    return Made(subject, report, printed(subject, derived.certificate, {})["files"])


def imported(name: str, folder: Path) -> ModuleType:
    for file, text in made(name).files.items():
        (folder / file).write_text(text, encoding="utf-8")
    module = made(name).subject.module.name
    spec = importlib.util.spec_from_file_location(module, folder / f"{module}.py")
    assert spec is not None
    assert spec.loader is not None
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


def points(kernel: Kernel) -> Iterator[dict[str, float]]:
    """Each index with a parameter beside it, the parameters in turn."""
    others = [entry.name for entry in kernel.inputs if entry.name != "tracking_index"]
    for number, index in enumerate(INDICES):
        values = (PARAMETERS[(number + place) % 3] for place in range(len(others)))
        yield {"tracking_index": index, **dict(zip(others, values, strict=True))}


def truth(
    subject: Subject, point: Mapping[str, float], shift: Fraction = Fraction(0)
) -> SteadyState:
    """The steady state from the model's matrices alone, the index times 1 + shift."""
    assert subject.model is not None
    known = {
        sp.Symbol(name, real=True): sp.Rational(*value.as_integer_ratio())
        for name, value in point.items()
    }
    data = {
        name: [[str(entry.subs(known)) for entry in row] for row in matrix.tolist()]
        for name, matrix in (
            ("transition", subject.model.transition),
            ("process_noise", subject.model.process_noise),
            ("measurement", subject.model.measurement),
            ("measurement_noise", subject.model.measurement_noise),
        )
    }
    index = Fraction(point["tracking_index"]) * (1 + shift)
    return enclose(state_space(data, index), DIGITS)


def named(state: SteadyState) -> dict[str, flint.arb]:
    """The entries by the names of the kernels' outputs."""
    size = len(state.gain)
    places = {f"{i + 1}{j + 1}": (i, j) for i in range(size) for j in range(i, size)}
    found = dict(zip(GAINS, (row[0] for row in state.gain), strict=False))
    for word, matrix in (("predicted", state.predicted), ("updated", state.updated)):
        found |= {f"{word}_{key}": matrix[i][j] for key, (i, j) in places.items()}
    return found


def slopes(subject: Subject, point: Mapping[str, float], degree: int) -> dict[str, flint.arb]:
    """First or second derivatives by the index, from differences."""
    places = {1: (STEP, -STEP), 2: (STEP, Fraction(0), -STEP)}[degree]
    weights = {1: (1, -1), 2: (1, -2, 1)}[degree]
    values = [named(truth(subject, point, place)) for place in places]
    width = (STEP * Fraction(point["tracking_index"])) ** degree * (2 if degree == 1 else 1)
    with flint.ctx.workprec(600):
        over = flint.arb(width.denominator) / flint.arb(width.numerator)
        return {
            name: sum((w * v[name] for w, v in zip(weights, values, strict=True)), flint.arb(0))
            * over
            for name in GAINS
            if name in values[0]
        }


DEGREES = {"gain_derivatives": 1, "gain_second_derivatives": 2}
COMPARED = {"gains", "predicted_covariance", "updated_covariance", *DEGREES}


def wanted(subject: Subject, kernel: str, point: Mapping[str, float]) -> dict[str, flint.arb]:
    """What a kernel should give."""
    if kernel in DEGREES:
        return slopes(subject, point, DEGREES[kernel])
    return named(truth(subject, point))


@pytest.mark.parametrize("name", CASES)
def test_every_statement_is_proved_cited_or_a_definition(name: str) -> None:
    report = made(name).report
    assert report["accepted"], report["reason"]
    found = {entry["status"] for entry in report["statements"]}
    assert found == {"proved", "cited", "definition"}
    kinds = {entry["id"]: entry["status"] for entry in report["statements"]}
    assert kinds["riccati"] == kinds["stable"] == "proved"


def bound_of(text: str, output: str) -> float:
    """What a docstring on one line says of an output in float64."""
    found = re.search(rf" {output}: [^:]*?(?:error|over [\w' ]+) at most ([.\d]+) \* 2\^-52", text)
    assert found is not None, f"no bound of {output}: {text}"
    return float(found[1])


@pytest.mark.parametrize("name", CASES)
def test_kernels_are_as_true_as_they_say(name: str, tmp_path: Path) -> None:
    """The printed bound holds against the oracle, which knows the matrices only."""
    subject = made(name).subject
    module = imported(name, tmp_path)
    for kernel in subject.module.kernels:
        if kernel.name not in COMPARED:
            continue
        text = " ".join((getattr(module, kernel.name).__doc__ or "").split())
        for point in points(kernel):
            computed = getattr(module, kernel.name)(*point.values())._asdict()
            true = wanted(subject, kernel.name, point)
            for output in kernel.outputs:
                scale = true[output.name]
                if output.relative_to is not None:
                    scale = balls(kernel.graph, point)[output.relative_to]
                error = relative_error(float(computed[output.name]), true[output.name], scale)
                assert error <= bound_of(text, output.name) * 2.0**-52, (kernel.name, output, point)


def test_the_gallery_holds_eight_kinds_of_model() -> None:
    assert MODELS == [
        "correlated_acceleration",
        "correlated_velocity",
        "drifting_platform",
        "half_intervals",
        "heaving_buoy",
        "held_pointer",
        "tank_level",
        "towed_sled",
    ]


def test_the_page_names_each_file_and_says_that_it_is_executed() -> None:
    page = (FOLDER.parent / "own-models.md").read_text(encoding="utf-8")
    assert [name for name in MODELS if f"`{name}.py`" not in page] == []
    assert "It is Python that its owner chose to run" in page
