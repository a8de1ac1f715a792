"""The cache: an entry that is not whole, or not the one asked for, is absent."""

from __future__ import annotations

import json
import os
import time
from pathlib import Path

import pytest

from gainproof.jobs.cache import FOLDER_VARIABLE, KEPT_DAYS, Cache, default_folder, key_of
from gainproof.jobs.progress import Progress
from gainproof.jobs.session import Session
from gainproof.jobs.workers import Job

VALUE = {"verdict": "proved", "text": "α", "numbers": [1, 2.5, None]}
KEY = key_of("judge", "claims", b"code")


@pytest.fixture
def cache(tmp_path: Path) -> Cache:
    cache = Cache(tmp_path / "cache")
    cache.store(KEY, VALUE)
    return cache


def entry(cache: Cache) -> Path:
    (path,) = cache.folder.glob("*.json")
    return path


def test_what_is_stored_is_found(cache: Cache) -> None:
    assert cache.load(KEY) == VALUE


def test_nothing_is_found_under_another_key(cache: Cache) -> None:
    assert cache.load(key_of("judge", "claims", b"other code")) is None


def test_fresh_finds_nothing_and_still_stores(cache: Cache) -> None:
    fresh = Cache(cache.folder, fresh=True)
    assert fresh.load(KEY) is None
    fresh.store(KEY, {"verdict": "refuted"})
    assert cache.load(KEY) == {"verdict": "refuted"}


def test_every_altered_byte_is_noticed(cache: Cache) -> None:
    path = entry(cache)
    content = path.read_bytes()
    for i in range(len(content)):
        path.write_bytes(content[:i] + bytes([content[i] ^ 1]) + content[i + 1 :])
        assert cache.load(KEY) is None, f"byte {i}"


def test_every_truncation_is_noticed(cache: Cache) -> None:
    path = entry(cache)
    content = path.read_bytes()
    for i in range(len(content)):
        path.write_bytes(content[:i])
        assert cache.load(KEY) is None, f"{i} bytes"


def test_an_entry_under_a_wrong_name_is_ignored(cache: Cache) -> None:
    """A verdict copied to the key of another claim is not believed."""
    other = key_of("judge", "other claims", b"code")
    entry(cache).rename(cache.folder / f"{other}.json")
    assert cache.load(other) is None


def test_a_checksum_made_for_other_content_is_ignored(cache: Cache) -> None:
    path = entry(cache)
    header = path.read_bytes().partition(b"\n")[0]
    path.write_bytes(header + b"\n" + json.dumps({"verdict": "proved", "text": "x"}).encode())
    assert cache.load(KEY) is None


def test_a_folder_that_cannot_be_made_is_no_error(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    cache = Cache(tmp_path / "file" / "cache")
    cache.store(KEY, VALUE)
    assert cache.load(KEY) is None


def test_old_entries_are_dropped(cache: Cache) -> None:
    path = entry(cache)
    old = time.time() - (KEPT_DAYS + 1) * 86400
    os.utime(path, (old, old))
    new = key_of("judge", "new")
    cache.store(new, VALUE)
    cache.drop_old()
    assert not path.exists()
    assert cache.load(new) == VALUE


def test_a_folder_that_is_not_there_has_nothing_old(tmp_path: Path) -> None:
    Cache(tmp_path / "nothing").drop_old()


def test_results_that_are_kept_make_room(cache: Cache) -> None:
    path = entry(cache)
    old = time.time() - (KEPT_DAYS + 1) * 86400
    os.utime(path, (old, old))
    session = Session(cache, Progress(quiet=True))
    session.results(
        "",
        [
            Job(
                "a proof",
                "recheck_proofs",
                {"judgement": {"source": {"key": "none"}, "claims": []}},
            )
        ],
    )
    assert not path.exists()


def test_keys_do_not_run_together() -> None:
    assert key_of("x", "ab", "c") != key_of("x", "a", "bc")
    assert key_of("x", "ab") != key_of("x", "a", "b")


def test_the_folder_can_be_chosen(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv(FOLDER_VARIABLE, str(tmp_path))
    assert default_folder() == tmp_path
