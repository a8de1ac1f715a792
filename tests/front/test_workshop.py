"""Results from the cache, and of jobs that were answered with others."""

from __future__ import annotations

from pathlib import Path

import pytest

from gainproof import derivations, workers
from gainproof.cache import Cache
from gainproof.progress import Progress
from gainproof.workers import Job
from gainproof.workshop import Workshop, open_workshop

SUPPORT = Path(__file__).resolve().parents[1] / "support"
SEVERAL = Job("several", "several", {})
NOW, LATER = (Job("wait", "wait", {"seconds": n}) for n in (0, 1))
Capture = pytest.CaptureFixture[str]


@pytest.fixture(autouse=True)
def _odd_worker(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "WORKER", "odd_worker")
    monkeypatch.setenv("PYTHONPATH", str(SUPPORT))


def workshop(folder: Path, *, fresh: bool = False) -> Workshop:
    return Workshop(Cache(folder, fresh), Progress(), "the code")


@pytest.mark.parametrize("fresh", [False, True])
def test_what_was_answered_ahead_is_not_asked_again(
    tmp_path: Path, capsys: Capture, *, fresh: bool
) -> None:
    shop = workshop(tmp_path, fresh=fresh)
    shop.ahead(SEVERAL)
    assert "several at once" in capsys.readouterr().err
    assert shop.results("waited", [LATER, NOW]) == ["known", 0]
    # it was made in this run, so that it is not called unchanged
    assert not capsys.readouterr().err


def test_what_was_answered_ahead_is_kept_for_other_runs(tmp_path: Path, capsys: Capture) -> None:
    workshop(tmp_path).ahead(SEVERAL)
    capsys.readouterr()
    later = workshop(tmp_path)
    later.ahead(SEVERAL)
    assert not capsys.readouterr().err
    assert later.results("waited", [LATER]) == ["known"]
    assert "waited: 1 unchanged" in capsys.readouterr().err
    fresh = workshop(tmp_path, fresh=True)
    assert fresh.results("", [LATER]) == [1]


def test_a_subject_is_the_same_derived_alone_or_among_all() -> None:
    shop = open_workshop(quiet=True)
    derivations.ahead(shop)
    job = Job("alone", "derive", {"name": "least-squares-line"})
    assert shop.results("", [job]) == workers.run([job])
