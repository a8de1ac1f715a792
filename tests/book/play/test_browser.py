"""The play in headless Chromium: moved as a reader moves it, its numbers read back."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from browser import needs_browser, of_changed_pages, opened, serious_findings
from one_of_each import cases
from play_page import write_page

from gainproof.book.play.subjects import SUBJECTS, subject_of

pytestmark = [needs_browser, of_changed_pages]

KERNELS = {
    "gains": "",
    "predictor_gains": "predictor_",
    "predicted_covariance": "",
    "updated_covariance": "",
}
"""Kernels whose outputs are in the table, and what their names there begin with."""


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    with opened() as browser:
        yield browser


@pytest.fixture
def visit(chromium: Any, tmp_path: Path) -> Iterator[Callable[..., Any]]:
    """Opens the page of a subject; whatever the console then complains of fails the test."""
    told: list[str] = []
    pages = []

    def open_page(name: str, width: int = 1000, colours: str = "light") -> Any:
        page = chromium.new_page(viewport={"width": width, "height": 800})
        pages.append(page)
        page.on("console", lambda message: told.append(message.text))
        page.on("pageerror", lambda error: told.append(str(error)))
        page.goto(write_page(name, tmp_path, colours).as_uri())
        page.wait_for_selector("section.play[data-ready]", timeout=10_000)
        return page

    yield open_page
    for page in pages:
        page.close()
    assert told == []


def values(page: Any) -> dict[str, float]:
    """The inputs as the fields hold them."""
    script = """() => Object.fromEntries([...document.querySelectorAll(".play-input")].map((box) =>
        [box.dataset.input, box.querySelector("input[type=number]").value]))"""
    return {name: float(text) for name, text in page.evaluate(script).items()}


def settled(page: Any) -> dict[str, float]:
    """The inputs once all is drawn for them."""
    inputs = values(page)
    script = """(wanted) => {
        const shown = JSON.parse(document.querySelector("section.play").dataset.ready);
        return Object.entries(wanted).every(([name, value]) => shown[name] === value);
    }"""
    page.wait_for_function(script, arg=inputs, timeout=10_000)
    return inputs


def numbers(page: Any) -> dict[str, float]:
    script = """() => Object.fromEntries(
        [...document.querySelectorAll("td[data-value]")].map((cell) =>
          [cell.dataset.output, cell.dataset.value]))"""
    return {name: float(text) for name, text in page.evaluate(script).items()}


def drag(page: Any, argument: str, share: float) -> None:
    """Presses on a slider's bar."""
    box = page.locator(f"#play-{argument}").bounding_box()
    page.mouse.click(box["x"] + share * box["width"], box["y"] + box["height"] / 2)


def expected(name: str, inputs: dict[str, float]) -> dict[str, float]:
    """What the NumPy kernels say, by the names of the table."""
    module = importlib.import_module(f"gainproof.generated.{name.replace('-', '_')}")
    found: dict[str, float] = {}
    for kernel, prefix in KERNELS.items():
        if hasattr(module, kernel):
            result = getattr(module, kernel)(*inputs.values())
            found |= {f"{prefix}{field}": float(getattr(result, field)) for field in result._fields}
    return found


STEADY = [subject.name for subject in SUBJECTS if subject.swept]
ONE_OF_EACH = {"random-acceleration", "random-jerk", "position-velocity"}


@pytest.mark.parametrize("name", cases(STEADY, ONE_OF_EACH.__contains__))
def test_a_moved_slider_shows_the_numbers_of_the_kernels(
    visit: Callable[..., Any], name: str
) -> None:
    page = visit(name)
    subject = subject_of(name)
    assert subject is not None
    begun = settled(page)
    for slider in subject.sliders:
        drag(page, slider.argument, 0.7)
    inputs = settled(page)
    assert all(inputs[argument] != value for argument, value in begun.items())
    wanted, shown = expected(name, inputs), numbers(page)
    both = wanted.keys() & shown.keys()
    gains = [key for key in wanted if key in ("alpha", "beta", "gamma") or key.startswith("gain_")]
    assert {*gains, "predicted_11", "updated_11"} <= both
    # the same doubles: they are printed in full
    assert {key: shown[key] for key in both} == {key: wanted[key] for key in both}
    assert page.locator("circle.point").count() >= 2
    assert page.locator("path.cross").count() == len([key for key in shown if "_real" in key])


def test_keys_move_a_slider(visit: Callable[..., Any]) -> None:
    page = visit("random-acceleration")
    page.focus("#play-tracking_index")
    page.keyboard.press("ArrowRight")
    (index,) = settled(page).values()
    assert index == 1.023  # 10^0.01 to four digits
    assert page.get_attribute("#play-tracking_index", "aria-valuetext") == "1.023"
    told = page.inner_text(".play-changing")
    assert (
        told == f"gain α {numbers(page)['alpha']:.6g}, gain β {numbers(page)['beta']:.6g}; stable"
    )


def test_typed_numbers_go_beyond_the_slider(visit: Callable[..., Any]) -> None:
    page = visit("random-velocity")
    page.fill("#play-tracking_index-number", "1e-5")
    inputs = settled(page)
    assert numbers(page)["alpha"] == expected("random-velocity", inputs)["alpha"]
    assert page.input_value("#play-tracking_index") == "-3"


def test_a_number_outside_the_domain_is_refused(visit: Callable[..., Any]) -> None:
    page = visit("random-velocity")
    for text, came in (("-1", "-1.0"), ("", "nan")):
        page.fill("#play-tracking_index-number", text)
        wanted = f"gains: tracking_index must be a number above 0 and finite, got {came}"
        page.wait_for_function(
            "(wanted) => document.querySelector('.play-refusal').textContent === wanted",
            arg=f"Not shown: {wanted}",
        )
    page.fill("#play-tracking_index-number", "2")
    settled(page)
    assert page.inner_text(".play-refusal") == ""


def test_gains_that_are_not_stable(visit: Callable[..., Any]) -> None:
    page = visit("alpha-beta-gamma")
    page.fill("#play-alpha-number", "0.1")
    page.fill("#play-gamma-number", "0.5")
    settled(page)
    assert page.inner_text(".play-changing").endswith("; not stable")
    assert page.inner_text("td[data-output=variance]") == "none: not stable"
    assert numbers(page)["radius"] > 1
    assert page.locator("path.cross.wrong").count() == 3


@pytest.mark.parametrize(("width", "colours"), [(360, "light"), (1000, "dark")])
def test_no_serious_finding_and_nothing_too_wide(
    visit: Callable[..., Any], width: int, colours: str
) -> None:
    page = visit("position-velocity", width, colours)
    assert serious_findings(page) == []
    assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_findings_are_found(visit: Callable[..., Any]) -> None:
    page = visit("alpha-beta")
    page.evaluate("document.querySelector('.play-input label').remove()")
    page.evaluate("document.querySelector('#play-alpha').removeAttribute('aria-label')")
    assert any(found.startswith("label:") for found in serious_findings(page))
