"""Results from the cache, and of jobs that were answered with others."""

from __future__ import annotations

from pathlib import Path

import pytest

from gainproof.jobs import workers
from gainproof.jobs.cache import Cache
from gainproof.jobs.progress import Progress
from gainproof.jobs.session import Session, open_session
from gainproof.jobs.workers import Job
from gainproof.subjects import derivations

SUPPORT = Path(__file__).resolve().parents[1] / "support"
NOW, LATER = (Job("wait", "wait", {"seconds": n}) for n in (0, 1))
SEVERAL = Job("several", "several", {}, answers=(NOW, LATER))
Capture = pytest.CaptureFixture[str]


@pytest.fixture(autouse=True)
def _odd_worker(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "WORKER", "odd_worker")
    monkeypatch.setenv("PYTHONPATH", str(SUPPORT))


def opened(folder: Path, *, fresh: bool = False) -> Session:
    return Session(Cache(folder, fresh), Progress(), lambda *_: "the code", lambda *_: True)


def nothing(_: Job) -> list[Job]:
    return []


def ahead(session: Session) -> None:
    session.ahead([SEVERAL], nothing, {"several": "known ahead:"})


@pytest.mark.parametrize("fresh", [False, True])
def test_what_was_answered_ahead_is_not_asked_again(
    tmp_path: Path, capsys: Capture, *, fresh: bool
) -> None:
    session = opened(tmp_path, fresh=fresh)
    ahead(session)
    assert "known ahead: several (" in capsys.readouterr().err
    assert session.results("waited", [LATER, NOW]) == ["known", 0]
    # it was made in this run, so that it is not called unchanged
    assert not capsys.readouterr().err


def test_what_was_answered_ahead_is_kept_for_other_runs(tmp_path: Path, capsys: Capture) -> None:
    ahead(opened(tmp_path))
    capsys.readouterr()
    later = opened(tmp_path)
    ahead(later)
    assert not capsys.readouterr().err
    assert later.results("waited", [LATER]) == ["known"]
    assert "waited: 1 unchanged" in capsys.readouterr().err
    fresh = opened(tmp_path, fresh=True)
    assert fresh.results("", [LATER]) == [1]


def test_a_job_that_answers_others_is_done_again_if_one_is_lost(tmp_path: Path) -> None:
    ahead(opened(tmp_path))
    first, *_ = tmp_path.glob("wait-*.json")
    first.unlink()
    session = opened(tmp_path)
    ahead(session)
    assert session.answered(LATER) == "known"
    assert session.answered(NOW) == 0


def test_what_was_done_while_the_code_was_edited_is_not_kept(tmp_path: Path) -> None:
    edited = Session(Cache(tmp_path), Progress(), lambda *_: "the code", lambda *_: False)
    assert edited.results("", [NOW]) == opened(tmp_path / "other").results("", [NOW])
    assert opened(tmp_path).answered(NOW) is None


def test_what_follows_from_a_job_is_done_too_known_or_not(tmp_path: Path) -> None:
    notes = [Job(key, "note", {"key": key, "value": n}) for n, key in enumerate("abc")]
    asked: list[str] = []

    def then(job: Job) -> list[Job]:
        asked.append(job.label)
        return notes[1:] if job is notes[0] else []

    opened(tmp_path).ahead(notes[1:2], nothing)
    session = opened(tmp_path)
    session.ahead(notes[:1], then)
    assert asked == ["a", "b", "c"]
    assert [session.answered(note) for note in notes] == [0, 1, 2]
    again = opened(tmp_path)
    again.ahead(notes[:1], then)
    assert asked == ["a", "b", "c"] * 2
    assert not again.done


def test_a_subject_is_the_same_derived_alone_or_with_its_files() -> None:
    session = open_session(quiet=True)
    asked = derivations.everything_job("least-squares-line", {})
    session.ahead([asked], nothing)
    for job in asked.answers:
        assert session.results("", [job]) == workers.run([job])
