"""Random samples are small by default and large in thorough runs, which have every one of them."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
import samples
from hypothesis import given, settings
from hypothesis import strategies as st

TESTS = Path(__file__).parents[1]
FILES = sorted(set(TESTS.rglob("test_*.py")) - {Path(__file__)})


def test_sizes_are_multiplied(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv(samples.VARIABLE, raising=False)
    assert samples.samples(20) == 20
    monkeypatch.setenv(samples.VARIABLE, "5")
    assert samples.samples(20) == 100
    monkeypatch.setenv(samples.VARIABLE, "0")
    with pytest.raises(ValueError, match="a whole number, at least 1, got 0"):
        samples.samples(20)


@pytest.mark.parametrize(
    ("expression", "asked"),
    [("thorough", True), ("thorough or slow", True), ("not thorough", False), ("slow", False)],
)
def test_thorough_runs_are_told_by_what_is_asked(expression: str, asked: bool) -> None:
    assert samples.thorough(expression) is asked


@pytest.mark.sampled
def test_what_is_marked_draws(request: pytest.FixtureRequest) -> None:
    assert samples.draws(request.node)


@settings(max_examples=samples.samples(1))
@given(st.none())
def test_what_hypothesis_asks_draws(request: pytest.FixtureRequest, nothing: None) -> None:
    assert samples.draws(request.node)


def test_nothing_else_draws(request: pytest.FixtureRequest) -> None:
    assert not samples.draws(request.node)


def problems(text: str) -> Iterator[int]:
    """Lines with a size that no thorough run makes larger, and of tests that no such run has."""
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, ast.keyword):
            if node.arg == "max_examples" and not _is_size(node.value):
                yield node.value.lineno
        elif isinstance(node, ast.FunctionDef) and node.name.startswith("test_"):
            marks = " ".join(ast.unparse(mark) for mark in node.decorator_list)
            drawn = any(_is_size(inner) for part in node.body for inner in ast.walk(part))
            if drawn and "sampled" not in marks and "given" not in marks:
                yield node.lineno


def _is_size(node: ast.AST) -> bool:
    """A call of `samples`: the project has functions of its own whose names end so."""
    return (
        isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "samples"
    )


def test_every_sample_has_a_size_for_thorough_runs() -> None:
    found = [
        f"{path.name}:{line}"
        for path in FILES
        for text in [path.read_text(encoding="utf-8")]
        if "samples" in text or "max_examples" in text
        for line in problems(text)
    ]
    assert not found, "write the size as samples(20): tests/support/samples.py"


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("@settings(deadline=None, max_examples=20)\n@given(x)\ndef test_it(x): ...", [1]),
        ("@settings(max_examples=samples(20))\n@given(x)\ndef test_it(x): ...", []),
        ("def test_it():\n    draw(samples(20))", [1]),
        ("@pytest.mark.sampled\ndef test_it():\n    draw(samples(20))", []),
    ],
)
def test_a_fixed_size_would_be_noticed(text: str, line: list[int]) -> None:
    assert list(problems(text)) == line
