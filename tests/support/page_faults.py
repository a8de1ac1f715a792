"""What is wrong with pages of a site as a browser shows them: in light and dark, on a telephone."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

from browser import serious_findings

COLOURS = ("light", "dark")
DESK, TELEPHONE = 1280, 360
"""Pixels of width."""
_WIDTH = "document.documentElement.scrollWidth"
_PLAYED = "section.play"
KEPT = 3
"""Formulas of a kind that axe-core sees."""
_EMPTY = """kept => {
    const seen = new Map();
    let emptied = 0;
    for (const formula of document.querySelectorAll("math")) {
        const parent = formula.parentElement;
        let behind = formula;
        while (behind.parentElement
                && getComputedStyle(behind).backgroundColor === "rgba(0, 0, 0, 0)")
            behind = behind.parentElement;
        const style = getComputedStyle(formula);
        const kind = [style.color, getComputedStyle(behind).backgroundColor, style.fontSize,
            style.display, style.opacity, parent.tagName, parent.className].join("|");
        const number = (seen.get(kind) ?? 0) + 1;
        seen.set(kind, number);
        const plain = formula.querySelector("[href], [tabindex], [role], [id], [style], [class]");
        if (number > kept && plain === null) {
            formula.replaceChildren();
            emptied += 1;
        }
    }
    return emptied;
}"""


def page_faults(
    browser: Any,
    pages: Sequence[Path],
    findings: Callable[[Any], Sequence[str]] = serious_findings,
) -> Iterator[tuple[Path, list[str]]]:
    """Each page with its faults: `findings` in light and dark (what axe-core calls serious or
    critical, which takes seconds a page), what the console complains of, and a page that is wider
    than a telephone.

    A page of some hundred formulas is ten thousand elements, on which axe-core takes ten seconds:
    of formulas of one kind, which have their colours, size and surroundings in common and hold
    nothing but signs, it sees the first `KEPT`, of the others the outermost element.
    """
    told: list[str] = []
    tab = browser.new_page()
    tab.on("console", lambda message: told.append(f"console: {message.text}"))
    tab.on("pageerror", lambda error: told.append(f"error: {error}"))
    try:
        for path in pages:
            told.clear()
            tab.set_viewport_size({"width": DESK, "height": 800})
            tab.emulate_media(color_scheme=COLOURS[0])
            tab.goto(path.resolve().as_uri())
            if tab.locator(_PLAYED).count():
                tab.wait_for_selector(f"{_PLAYED}[data-ready]")
            wide = [*_on_a_telephone(tab)]
            tab.set_viewport_size({"width": DESK, "height": 800})
            empty_alike(tab)
            yield path, [*told, *_seen(tab, findings), *wide]
    finally:
        tab.close()


def empty_alike(tab: Any) -> int:
    """Take away what later formulas of a kind hold; how many they are."""
    emptied: int = tab.evaluate(_EMPTY, KEPT)
    return emptied


def _seen(tab: Any, findings: Callable[[Any], Sequence[str]]) -> Iterator[str]:
    for colours in COLOURS:
        tab.emulate_media(color_scheme=colours)
        for finding in findings(tab):
            yield f"{colours}: {finding}"


def _on_a_telephone(tab: Any) -> Iterator[str]:
    tab.set_viewport_size({"width": TELEPHONE, "height": 740})
    width = tab.evaluate(_WIDTH)
    if width > TELEPHONE:
        yield f"{width} pixels wide on a telephone of {TELEPHONE}"
