"""The page that checks formulas with all that it runs on: the judge under WebAssembly says what the
judge of this Python says, under Node.js and in a browser.
"""

from __future__ import annotations

import json
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from browser import needs_browser, opened, serious_findings
from node import needs_node
from page_judge import judged, served

import gainproof
from gainproof.bad_input import BadInputError
from gainproof.book import check_page, check_runtime
from gainproof.claims import judgements
from gainproof.files import places
from gainproof.verdicts import verdict_snapshot

pytestmark = [pytest.mark.thorough, needs_node]
MOST_SENT = 15e6
"""Bytes, compressed as servers do."""
MOST_READY = 3.0
"""Times that of an empty Pyodide with python-flint."""
PORTIONS = 6
LONG = 600.0
"""Seconds for a task: of a formula that hangs less is asked."""
LAW = r"\beta = \frac{\alpha^2}{2 - \alpha}"


@cache
def fetched() -> dict[str, bytes]:
    """What the page runs on; it is fetched where the cache of the tests does not have it."""
    try:
        return check_runtime.runtime()
    except BadInputError as error:
        pytest.skip(str(error))


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("page")
    check_page.write(fetched(), folder)
    return folder


def asked(formula: str, seconds: float = LONG, **said: Any) -> dict[str, Any]:
    return {"do": "ask", "formula": formula, "said": said, "seconds": seconds, "columns": 80}


def test_no_more_is_sent_than_promised() -> None:
    assert sum(len(zlib.compress(content, 6)) for content in fetched().values()) < MOST_SENT


@pytest.mark.parametrize("portion", range(PORTIONS))
def test_all_claim_files_come_to_the_verdicts_of_check(page: Path, portion: int) -> None:
    files = sorted(places.claim_files(), key=lambda file: file.stat().st_size)[portion::PORTIONS]
    requests = [{"do": "check", "text": judgements.read(file), "seconds": LONG} for file in files]
    found = judged(page, requests)["answers"]
    for file, each in zip(files, found, strict=True):
        assert verdict_snapshot.changes(each["answer"], file) == []
        assert not verdict_snapshot.accidents(each["answer"])


def test_formulas_come_to_what_ask_says(page: Path) -> None:
    formulas: list[tuple[str, dict[str, Any]]] = [
        (LAW, {}),
        (r"\beta = 2(2-\alpha) + 4\sqrt{1-\alpha}", {"model": "random-acceleration"}),
        (r"\alpha_k = \frac{2(2k+1)}{(k+1)(k+2)}", {}),
        (r"P_{11} = \alpha R", {}),
        ("x + 1/x >= 2", {"domain": "x > 0"}),
        ("x + 1/x >= 2", {}),
        (r"\frac{x^2 - y^2}{x - y} = x + y", {}),
        (r"\sin 2x = 2 \sin x \cos x", {}),
        (r"\alpha \to 1 \quad (\Lambda \to \infty)", {}),
    ]
    found = judged(page, [asked(formula, **said) for formula, said in formulas])["answers"]
    for (formula, said), each in zip(formulas, found, strict=True):
        wanted = gainproof.ask(formula, **said)
        answer = each["answer"]
        assert answer["explanation"] == wanted.explain(80)
        plain = json.loads(json.dumps({**wanted.plain(), "seconds": 0}))
        assert {**answer["answer"], "seconds": 0} == plain, formula


def test_a_formula_that_hangs_costs_one_answer(page: Path) -> None:
    slow = "((((9^64)^64)^64)^64)^64 = 1"
    done = judged(page, [asked(slow, 5.0), asked("x^2 >= 0"), asked("x +")])
    first, second, third = (each["answer"] for each in done["answers"])
    assert done["started"] == 2
    assert (first["verdict"], second["verdict"]) == ("undecided", "proved")
    assert "stopped after 5 seconds" in str(first["facts"])
    assert "not read" in third["error"]


def test_it_is_ready_soon_after_python_with_flint(page: Path) -> None:
    script = (page / "static" / "check.worker.js").read_text(encoding="utf-8")
    begin, end = script.index("  const page ="), script.index("  self.postMessage({ ready")
    empty = f'{script[:begin]}  python.pyimport("flint");\n{script[end:]}'
    wheels = [f', "{name}"' for name in ("lark.whl", "latex2mathml.whl", "gainproof.whl")]
    for wheel in wheels:
        assert wheel in empty
        empty = empty.replace(wheel, "")
    (page / "static" / "empty.js").write_text(empty, encoding="utf-8")
    times = []
    for name in ("empty.js", "check.worker.js") * 3:
        done = judged(page, [], f"static/{name}")
        assert done["first"] == {"ready": True}
        times.append(done["ready"])
    bare, whole = min(times[::2]), min(times[1::2])
    assert whole < MOST_READY * bare, (whole, bare)


@dataclass(frozen=True)
class Shown:
    """The page in a browser, and another server, of which nothing may be asked."""

    tab: Any
    address: str
    elsewhere: str

    def ready(self) -> None:
        self.tab.locator("#told", has_text="Ready.").wait_for(timeout=240_000)

    def judged(self) -> str:
        self.tab.press("#check", "Enter")
        self.tab.locator("#told", has_text="Judged in").wait_for(timeout=240_000)
        return str(self.tab.text_content("#verdict"))

    def open(self, link: str = "") -> None:
        self.tab.goto("about:blank")
        self.tab.goto(self.address + link)
        self.tab.wait_for_selector("#ask:not([hidden])")


@pytest.fixture
def shown(page: Path) -> Iterator[Shown]:
    faults: list[str] = []
    with served(page) as (address, _), served(page) as (elsewhere, others), opened() as browser:
        tab = browser.new_page()
        tab.on("pageerror", lambda error: faults.append(str(error)))
        tab.on("dialog", lambda dialog: faults.append(dialog.message))
        found = Shown(tab, address, elsewhere)
        found.open()
        yield found
        assert faults == []
        assert others == []


@needs_browser
def test_a_formula_is_corrected_judged_and_carried_by_its_link(shown: Shown) -> None:
    tab = shown.tab
    tab.fill("#formula", "K = a^2/(2 - a)")
    shown.ready()
    assert tab.locator("#set math").count() == 1
    for name, meaning in (("K", "filter_gain.2"), ("a", "filter_gain.1")):
        tab.get_by_label(f"What {name} is", exact=True).fill(meaning)
        tab.keyboard.press("Tab")
    tab.locator("#symbols", has_text="component 1 of K").wait_for()
    verdict = shown.judged()
    assert verdict.startswith("proved for process noise random-velocity")
    tab.click("text=Proof or witness in full")
    assert "method:" in tab.inner_text("#explanation")
    link = tab.get_attribute("#link", "href")
    shown.open(link)
    assert tab.input_value("#formula") == "K = a^2/(2 - a)"
    assert tab.get_by_label("What K is", exact=True).input_value() == "filter_gain.2"
    assert tab.text_content("#verdict") == ""
    assert shown.judged() == verdict


@needs_browser
def test_options_are_heard_and_errors_are_text(shown: Shown) -> None:
    tab = shown.tab
    tab.fill("#formula", "a/c >= b/c")
    tab.click("text=Filter, domain, hypotheses, conventions")
    tab.fill("#domain", "c > 0")
    tab.fill("#given", "a >= b")
    assert shown.judged().startswith("proved")
    assert "domain: c > 0; given: a" in tab.text_content("#facts")
    # no verdict stands beside another question
    tab.fill("#given", "a >= <img src=x onerror=alert(1)>")
    assert tab.text_content("#verdict") == ""
    tab.locator("#problem", has_text="given: not read").wait_for()
    assert "<img" in tab.text_content("#problem")
    assert tab.locator("main img").count() == 0


@needs_browser
def test_what_hangs_is_stopped_by_the_button_or_by_its_time(shown: Shown) -> None:
    tab = shown.tab
    tab.fill("#formula", "((((9^64)^64)^64)^64)^64 = 1")
    shown.ready()
    tab.press("#check", "Enter")
    tab.locator("#told", has_text="Judging").wait_for()
    tab.press("#stop", "Enter")
    tab.locator("#told", has_text="Stopped").wait_for()
    assert tab.is_enabled("#check")
    tab.evaluate("document.getElementById('seconds').value = 2")
    assert shown.judged().startswith("undecided")
    assert "stopped after 2 seconds" in tab.text_content("#facts")
    tab.fill("#formula", "x^2 >= 1")
    assert shown.judged().startswith("conditional")
    assert "at x = 0 the left side is 0" in tab.text_content("#facts")


@needs_browser
def test_what_runs_in_the_page_reaches_no_other_place(shown: Shown) -> None:
    shown.tab.fill("#formula", "x = 1")
    shown.ready()
    program = "to => fetch(to, { mode: 'no-cors' }).then(() => 'sent', () => 'refused')"
    (worker,) = shown.tab.workers
    for runner in (shown.tab, worker):
        assert runner.evaluate(program, shown.elsewhere) == "refused"
        assert runner.evaluate(program, shown.address) == "sent"


@needs_browser
def test_it_is_seen_and_heard_by_all(shown: Shown) -> None:
    tab = shown.tab
    tab.fill("#formula", "beta = 2(2 - alpha) + 4 sqrt(1 - alpha)")
    assert shown.judged().startswith("refuted")
    assert tab.locator("[role=status] #verdict").count() == 1
    for part in tab.query_selector_all("details"):
        part.evaluate("part => { part.open = true; }")
    for width in (1440, 390):
        for colours in ("light", "dark"):
            tab.set_viewport_size({"width": width, "height": 844})
            tab.emulate_media(color_scheme=colours)
            assert serious_findings(tab) == []
            assert tab.evaluate("document.documentElement.scrollWidth") <= width
