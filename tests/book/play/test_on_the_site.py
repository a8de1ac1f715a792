"""The play on a derivation's page of the book, as the site writes it."""

from __future__ import annotations

from pathlib import Path

import pytest
from browser import needs_browser, of_changed_pages, opened

from gainproof.book import site
from gainproof.book.derivation_pages import derivation_page
from gainproof.book.play import section
from gainproof.generated import random_velocity
from gainproof.jobs.session import open_session
from gainproof.subjects import derivations

pytestmark = [needs_browser, of_changed_pages]


@pytest.fixture(scope="module")
def page(all_derived: object, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of one derivation in a site that has no other."""
    del all_derived
    session = open_session(quiet=True)
    subject = derivations.known("random-velocity", session)
    made, play = (
        derivation_page(subject, derivations.own_report(subject, session), []),
        section(subject),
    )
    assert play is not None
    folder = tmp_path_factory.mktemp("site") / "book"
    site.write(site.files([made], dict(play.scripts), lambda _: None), folder)
    return folder / made.path


def test_it_runs_from_a_folder(page: Path) -> None:
    told: list[str] = []
    with opened() as browser:
        tab = browser.new_page(viewport={"width": 1000, "height": 800})
        tab.on("console", lambda message: told.append(message.text))
        tab.on("pageerror", lambda error: told.append(str(error)))
        tab.goto(page.as_uri())
        tab.wait_for_selector("section.play[data-ready]")
        tab.fill("#play-tracking_index-number", "2.5")
        tab.wait_for_selector("section.play[data-ready='{\"tracking_index\":2.5}']")
        shown = tab.get_attribute("td[data-output=alpha]", "data-value")
        assert float(shown) == random_velocity.gains(2.5).alpha
        # the style sheet of the play is there: without it there is no grid
        display = "getComputedStyle(document.querySelector('.play-pictures')).display"
        assert tab.evaluate(display) == "grid"
        assert tab.locator("svg[data-panel] path").count() > 10
    assert told == []
