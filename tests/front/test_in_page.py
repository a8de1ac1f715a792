"""The judge as a page asks it: one process that can end no task, and says what it does."""

from __future__ import annotations

import json
from typing import Any

import pytest
from one_of_each import further

import gainproof
from gainproof.answers.in_page import InPage

LAW = r"\beta = \frac{\alpha^2}{2 - \alpha}"


class Page:
    """A page that hears what the judge tells it."""

    def __init__(self) -> None:
        self.told: list[dict[str, Any]] = []
        self.judge = InPage(lambda text: self.told.append(json.loads(text)))

    def asks(self, formula: str, do: str = "ask", **said: Any) -> dict[str, Any]:
        request = {"do": do, "formula": formula, "said": said, "seconds": 20, "columns": 80}
        return self.sends(request)

    def sends(self, request: dict[str, Any]) -> dict[str, Any]:
        answer: dict[str, Any] = json.loads(self.judge.answered(json.dumps(request)))
        return answer

    @property
    def begun(self) -> list[str]:
        return [each["begins"] for each in self.told if "begins" in each]


@pytest.mark.parametrize(
    ("formula", "said"),
    [
        (LAW, {}),
        ("beta = 2(2 - alpha) + 4 sqrt(1 - alpha)", {"model": "random-acceleration"}),
        ("x + 1/x >= 2", {"domain": "x > 0", "symbols": {"x": "m/m"}}),
        further("a/c >= b/c", {"given": ["a >= b", "c > 0"]}),
        further(r"\gamma = \frac{\beta^2}{2 \alpha}", {"conventions": {"third_gain": "1"}}),
        further(r"\alpha_k = \frac{2(2k+1)}{(k+1)(k+2)}", {}),
    ],
)
def test_it_answers_as_ask_does(formula: str, said: dict[str, Any]) -> None:
    """Judged in processes of their own the formulas come to the same."""
    found = Page().asks(formula, **said)["answer"]
    wanted = gainproof.ask(formula, **said).plain()
    assert {k: v for k, v in found.items() if k != "seconds"} == json.loads(
        json.dumps({k: v for k, v in wanted.items() if k != "seconds"})
    )


def test_it_says_how_a_formula_is_understood_and_judges_nothing() -> None:
    page = Page()
    found = page.asks("y = a^2/2", "understand", symbols={"a": "m > 0"})
    assert {each["name"]: each["means"] for each in found["symbols"]} == {
        "y": "real number (guessed)",
        "a": "number in m, a > 0",
    }
    assert found["filters"] == ["none: about real numbers (guessed)"]
    element, attributes, (row,) = found["set"]
    assert (element, attributes, row[0]) == ("math", {"display": "inline"}, "mrow")
    assert ["mfrac", {}] in [part[:2] for part in row[2]]
    assert not page.told


@pytest.mark.parametrize(
    ("formula", "said", "wanted"),
    [
        (r"\alpha + =", {}, "not read"),
        ("x = y", {"symbols": {"z": "1"}}, "symbol: the formula has no z"),
        ("x = y", {"model": "no"}, "no model is called 'no'"),
        ("x = y", {"given": ["x >"]}, "given: not read"),
        ("x" * 5000, {}, "5000 characters"),
    ],
)
def test_what_cannot_be_read_is_told_in_words_of_the_page(
    formula: str, said: dict[str, Any], wanted: str
) -> None:
    found = Page().asks(formula, **said)
    assert wanted in found["error"]
    assert "--" not in found["error"]


def test_each_task_is_told_as_it_begins_and_ends() -> None:
    page = Page()
    page.asks("x^2 >= 1")
    assert [next(iter(each)) for each in page.told] == ["begins", "ends"] * len(page.begun)
    assert page.begun == [each["ends"] for each in page.told if "ends" in each]
    assert all(0 < each["seconds"] <= 20 for each in page.told if "begins" in each)


def test_what_is_known_from_before_is_not_done_again() -> None:
    first, second = Page(), Page()
    answer = first.asks("x^2 >= 1")
    texts = {each["ends"]: each["text"] for each in first.told if "ends" in each}
    second.sends({"do": "understand", "formula": "x = y", "said": {}, "texts": texts})
    assert second.asks("x^2 >= 1")["headline"] == answer["headline"]
    assert first.begun
    assert not second.begun


@pytest.mark.parametrize(
    ("why", "reason"),
    [("late", "stopped after 20 seconds"), ("it fell over", "it fell over")],
)
def test_a_task_that_was_ended_is_undecided_and_costs_no_other(why: str, reason: str) -> None:
    page = Page()
    page.asks("x^2 >= 1")
    (lost, *_), page = page.begun, Page()
    request = {"do": "ask", "formula": "x^2 >= 1", "said": {}, "seconds": 20, "columns": 80}
    found = page.sends({**request, "lost": {lost: why}})
    assert found["verdict"] == "undecided"
    assert reason in str(found["facts"])
    assert lost not in page.begun
    assert page.asks("x^2 >= 0")["verdict"] == "proved"
    # nobody lost it this time
    assert page.asks("x^2 >= 1")["verdict"] == "conditional"


def test_what_a_task_raises_costs_its_claim(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: Any) -> Any:
        raise ZeroDivisionError("by nothing")

    monkeypatch.setattr("gainproof.verify.judge.task.try_claim", fails)
    page = Page()
    found = page.asks("x^2 >= 0")
    assert found["verdict"] == "undecided"
    assert "ZeroDivisionError: by nothing" in str(found["facts"])


def test_a_repair_is_set_and_told_once() -> None:
    found = Page().asks("beta = 2(2 - alpha) + 4 sqrt(1 - alpha)")
    assert [each["set"][0] for each in found["repairs"]] == ["math"]
    assert "sign of a term" in found["repairs"][0]["words"]
    assert "nearest true" not in str(found["facts"])
    assert "Nearest true formula" in found["explanation"]


def test_a_claim_file_is_judged_as_check_does() -> None:
    text = Page().asks("x^2 >= 1", "understand")["file"]
    judged = Page().sends({"do": "check", "text": text, "seconds": 20})
    assert [claim["verdict"] for claim in judged["claims"]] == ["conditional"]
    assert "format" in Page().sends({"do": "check", "text": "x = 1", "seconds": 20})["error"]
