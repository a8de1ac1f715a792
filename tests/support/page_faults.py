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


def page_faults(
    browser: Any,
    pages: Sequence[Path],
    findings: Callable[[Any], Sequence[str]] = serious_findings,
) -> Iterator[tuple[Path, list[str]]]:
    """Each page with its faults: `findings` in light and dark (what axe-core calls serious or
    critical, which takes seconds a page), what the console complains of, and a page that is wider
    than a telephone.
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
            found = [*_seen(tab, findings), *_on_a_telephone(tab)]
            yield path, [*told, *found]
    finally:
        tab.close()


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
