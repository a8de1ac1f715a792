"""What a derived subject gives to the page that shows it."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest
from play_page import derived

from gainproof.book.play import section
from gainproof.book.play.subjects import SUBJECTS
from gainproof.derive.printer.javascript.page_kernels import PLAYED


def test_a_subject_without_a_play() -> None:
    assert section(derived("least-squares-mean")) is None


@pytest.mark.parametrize("name", [subject.name for subject in SUBJECTS])
def test_a_fragment_is_whole(name: str) -> None:
    play = section(derived(name))
    assert play is not None
    root = ET.fromstring(play.html)
    assert (root.tag, root.get("data-subject")) == ("section", name)
    identifiers = [part.get("id") for part in root.iter() if part.get("id")]
    assert len(set(identifiers)) == len(identifiers)
    labelled = {part.get("for") for part in root.iter("label")}
    for part in root.iter("input"):
        assert part.get("id") in labelled or part.get("aria-label")
    for part in root.iter():
        assert set(part.get("aria-labelledby", "").split()) <= set(identifiers)
        assert not any(key.startswith("on") for key in part.attrib)
        assert "style" not in part.attrib


def test_scripts_come_in_order() -> None:
    play = section(derived("random-jerk"))
    assert play is not None
    names = [name for name, _ in play.scripts]
    kernels = ["kernels.js", "random_jerk.js", "alpha_beta_gamma.js"]
    own = [f"play.{name}.js" for name in ("filter", "families", "drawing", "panels")]
    assert names == [*kernels, *own, "play.js"]
    for _, text in play.scripts:
        assert '"use strict";' in text
        assert "import " not in text
        assert "fetch(" not in text


def test_all_printed_modules_are_played_with() -> None:
    used = {script.removesuffix(".js") for subject in SUBJECTS for script in subject.scripts}
    assert used == set(PLAYED)
