"""`gainproof derive` says what it does when that takes a while and somebody is looking on."""

from __future__ import annotations

import sys
import time

import pytest

from gainproof.commands.derive import _word_of_long_work
from gainproof.jobs import progress


def worked(monkeypatch: pytest.MonkeyPatch, *, terminal: bool, at_once: bool) -> None:
    """A tenth of a second of work, with a line after a hundredth of one or after a minute."""
    monkeypatch.setattr(progress, "EVERY", 60.0 if at_once else 0.01)
    monkeypatch.setattr(sys.stderr, "isatty", lambda: terminal, raising=False)
    with _word_of_long_work("deriving a model"):
        time.sleep(0.1)


@pytest.mark.parametrize(
    ("terminal", "at_once", "told"),
    [(True, False, True), (True, True, False), (False, False, False)],
)
def test_a_line_for_long_work_on_a_terminal(
    *,
    terminal: bool,
    at_once: bool,
    told: bool,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    worked(monkeypatch, terminal=terminal, at_once=at_once)
    found = capsys.readouterr().err
    assert ("deriving a model" in found) == told


def test_a_failure_passes_through() -> None:
    with pytest.raises(ValueError, match="no"), _word_of_long_work("deriving"):
        raise ValueError("no")
