"""What a session of tests takes over from the user's cache, and what it derives anew."""

from __future__ import annotations

from pathlib import Path

import catalogue_subjects
import pytest
from catalogue_subjects import ALIKE, LONG, CacheOfTwo

from gainproof.derive.catalogue import CATALOGUE
from gainproof.jobs import workers
from gainproof.jobs.cache import Cache, default_folder, key_of
from gainproof.jobs.session import Session
from gainproof.subjects import derivations

KEY = key_of("derive", "this code", "random-velocity")


@pytest.fixture
def caches(tmp_path: Path) -> tuple[CacheOfTwo, Cache]:
    users = Cache(tmp_path / "users")
    return CacheOfTwo(tmp_path / "own", users=users), users


def test_what_the_user_has_under_the_key_is_taken_over(caches: tuple[CacheOfTwo, Cache]) -> None:
    own, users = caches
    assert own.load(KEY) is None
    users.store(KEY, {"gain": "1"})
    assert own.load(KEY) == {"gain": "1"}
    assert Cache(own.folder).load(KEY) == {"gain": "1"}


def test_of_other_code_nothing_is(caches: tuple[CacheOfTwo, Cache]) -> None:
    own, users = caches
    users.store(key_of("derive", "other code", "random-velocity"), {"gain": "1"})
    assert own.load(KEY) is None


def test_damaged_entries_are_not(caches: tuple[CacheOfTwo, Cache]) -> None:
    own, users = caches
    users.store(KEY, {"gain": "1"})
    (path,) = users.folder.glob("*.json")
    path.write_bytes(path.read_bytes().replace(b'"1"', b'"2"'))
    assert own.load(KEY) is None


def test_the_users_cache_is_only_read(caches: tuple[CacheOfTwo, Cache]) -> None:
    own, users = caches
    own.store(KEY, {"gain": "2"})
    assert users.load(KEY) is None
    users.store(KEY, {"gain": "1"})
    assert own.load(KEY) == {"gain": "2"}
    assert users.load(KEY) == {"gain": "1"}


def test_tests_have_a_folder_of_their_own() -> None:
    assert default_folder() != catalogue_subjects.USERS_CACHE


def test_a_subject_of_each_way_is_derived_anew(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Even if the user has it; of those alike, and that take long, what the user has is taken."""
    users = Cache(tmp_path / "users")
    names = [entry.name for entry in CATALOGUE]
    asked: list[str] = []

    def note(session: Session, chosen: list[str]) -> None:
        asked.append(f"{type(session.cache).__name__} {len(chosen)}")
        if type(session.cache) is Cache:
            assert not (ALIKE | LONG) & set(chosen)

    monkeypatch.setattr(catalogue_subjects, "USERS_CACHE", users.folder)
    monkeypatch.setattr(catalogue_subjects, "derive_with_another_seed", note)
    monkeypatch.setattr(derivations, "catalogue", lambda: names)
    catalogue_subjects._prepare()
    here = len(names) - len(ALIKE | LONG)
    assert asked == [f"Cache {here}", f"CacheOfTwo {len(names)}"]
    assert workers.REPRODUCIBLE["PYTHONHASHSEED"] != catalogue_subjects.OTHER_SEED
