"""Headless Chromium for tests, where it and Playwright are; nothing is downloaded."""

from __future__ import annotations

import importlib
import importlib.util
import runpy
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

NAMES = ("chromium", "chromium-browser", "google-chrome")
CHROMIUM = next((found for name in NAMES if (found := shutil.which(name))), None)


def missing() -> str:
    """What there is none of, as words; empty where all is there."""
    if CHROMIUM is None:
        return f"there is no Chromium on the path ({', '.join(NAMES)})"
    wanted = ("playwright", "axe_playwright_python")
    absent = [name for name in wanted if importlib.util.find_spec(name) is None]
    return f"not installed, see the extra `browser`: {', '.join(absent)}" if absent else ""


needs_browser = pytest.mark.skipif(bool(missing()), reason=missing() or "all is there")


CHANGED = runpy.run_path(str(Path(__file__).parents[2] / ".ci" / "changed.py"))
"""What `.ci/run` knows of changes too."""
of_changed_pages = (
    pytest.mark.skipif(False, reason="asked by default too")
    if CHANGED["pages_changed"](CHANGED["changed_files"]())
    else pytest.mark.thorough
)
"""Of tests of pages that take seconds: thorough runs have them always, default ones where something
of pages changed.
"""


@contextmanager
def opened() -> Iterator[Any]:
    """A browser of Playwright, without a window."""
    # imported by name, so that type checkers need not have it
    api: Any = importlib.import_module("playwright.sync_api")
    with api.sync_playwright() as playwright:
        chromium = playwright.chromium.launch(executable_path=CHROMIUM)
        try:
            yield chromium
        finally:
            chromium.close()


def serious_findings(page: Any) -> list[str]:
    """What axe-core finds wrong on a page, of impact serious or critical."""
    axe: Any = importlib.import_module("axe_playwright_python.sync_playwright").Axe()
    # `preload` fetches style sheets, which a page opened from a folder may not; colours are seen as
    # they are shown
    options = {"resultTypes": ["violations"], "preload": False}
    violations = axe.run(page, options=options).response["violations"]
    return [
        f"{found['id']}: {found['nodes'][0]['html']}"
        for found in violations
        if found["impact"] in ("serious", "critical")
    ]
