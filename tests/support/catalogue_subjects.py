"""The subjects of the catalogue, each derived once in a session, whatever tests ask for it."""

from __future__ import annotations

import os
import shutil
import sqlite3
from collections.abc import Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from gainproof.bad_input import BadInputError
from gainproof.derive.catalogue import CATALOGUE
from gainproof.derive.subject import Subject
from gainproof.files import places
from gainproof.jobs import workers
from gainproof.jobs.cache import Cache, default_folder
from gainproof.jobs.session import Session, open_session
from gainproof.jobs.workers import Job
from gainproof.subjects import bounds_ledger, derivations
from gainproof.subjects.derived import Derived

OTHER_SEED = "4242"
PROCESSORS = workers.processors
"""As it is without tests."""
USERS_CACHE = default_folder()
"""As it is without tests: this module is imported before they get a folder of their own."""
ALIKE = frozenset(
    {
        "random-acceleration",  # like random velocity
        "continuous-white-acceleration",
        "wiener-acceleration",  # like increments of acceleration
        "random-jerk",
        "continuous-white-jerk",
        "least-squares-mean",  # like the line
        "least-squares-parabola",
        "position-velocity",  # like that of random velocity
        "position-velocity-random-acceleration",
        "recursion-three-states",  # like two states
        "alpha-beta-gamma",  # like alpha-beta
    }
)
"""Subjects derived in the way of another."""
LONG = frozenset(
    {
        "position-velocity-random-velocity",
        "interacting-gains",
        "bearings-only",
        "multipath-location",
    }
)
"""The only ones of their way that take more than a second: `-m thorough` derives all anew."""
LONGEST_WAIT = 3600.0  # seconds: only for a process that hangs; one that ends lets others go on


@cache
def subject(name: str) -> Subject:
    """The subject of that name, derived in this process; ValueError if the catalogue has none.

    For its towers and matrices: what is plain data comes from `derived`.
    """
    (entry,) = (entry for entry in CATALOGUE if entry.name == name)
    return entry.build()


@cache
def derived(name: str) -> Derived:
    """The subject as plain data, with its certificate; nobody changes it.

    Where tests run in several processes all subjects are derived by the first that asks for one.
    """
    if "PYTEST_XDIST_WORKER" in os.environ:
        prepare_all()
    return derivations.known(name, open_session(quiet=True))


def certificate(name: str) -> Mapping[str, Any]:
    """The certificate of a subject."""
    return derived(name).certificate


@cache
def report(name: str) -> Mapping[str, Any]:
    """The checker's report on the certificate just derived: of whoever asks first in a session, or
    that of `gainproof run` on the same certificate with the same code. Nobody changes it.
    """
    return derivations.own_report(derived(name), with_the_users(open_session(quiet=True)))


def models() -> list[Mapping[str, Any]]:
    """The models of all subjects that have one, in the order of the catalogue, each once."""
    found = {data["name"]: data for entry in CATALOGUE if (data := derived(entry.name).model)}
    return list(found.values())


def prepare_all() -> None:
    """Every subject with its files is in the shared cache, put there by one process only.

    One of most ways of derivation is derived here, with another hash seed than `gainproof run` has:
    that both come to the committed files shows that no order of a set is in them. The others, ALIKE
    and LONG, are what the user's cache holds under the keys of this very code and these versions,
    as it does after `gainproof run`, and are derived here if it does not; so is what the checker
    says of all. What fails is not tried again.
    """
    failure = _preparing()
    if failure is not None:
        raise failure


@cache
def _preparing() -> Exception | None:
    try:
        _prepare()
    except (BadInputError, workers.JobError) as error:
        return error
    return None


def _prepare() -> None:
    session = open_session(quiet=True)
    with _one_process_at_a_time(default_folder() / "deriving.lock"):
        names = derivations.catalogue()
        assert set(names) >= ALIKE | LONG
        here = [name for name in names if name not in ALIKE | LONG]
        derive_with_another_seed(session, here)
        derive_with_another_seed(with_the_users(session), names)
        # whatever the seed was, a certificate is the same: so is what the checker said of it
        take_over("recheck", session.cache)


def with_the_users(session: Session) -> Session:
    """The session, which knows what the user's cache holds too."""
    both = CacheOfTwo(session.cache.folder, users=Cache(USERS_CACHE))
    return Session(both, session.progress, session.code)


def take_over(kind: str, cache: Cache) -> None:
    """What the user's cache holds of one kind of job is in this one too, under the same keys."""
    for path in USERS_CACHE.glob(f"{kind}-*.json"):
        if not (cache.folder / path.name).exists():
            shutil.copy(path, cache.folder)


def derive_with_another_seed(session: Session, names: Sequence[str]) -> None:
    """The subjects with their files are in the cache of the session; what is not is derived."""
    assert workers.REPRODUCIBLE["PYTHONHASHSEED"] != OTHER_SEED
    with pytest.MonkeyPatch.context() as changed:
        changed.setitem(workers.REPRODUCIBLE, "PYTHONHASHSEED", OTHER_SEED)
        changed.setattr(workers, "processors", PROCESSORS)
        bounds = bounds_ledger.usable(places.generated_folder())
        session.ahead([derivations.everything_job(name, bounds) for name in names], _nothing)


def _nothing(_: Job) -> list[Job]:
    return []


@dataclass(frozen=True)
class CacheOfTwo(Cache):
    """A cache that takes over what it lacks and the user's holds. That one is only read."""

    users: Cache | None = None

    def load(self, key: str) -> Any | None:
        found = super().load(key)
        if found is None and self.users is not None:
            found = self.users.load(key)
            if found is not None:
                self.store(key, found)
        return found


@contextmanager
def _one_process_at_a_time(path: Path) -> Iterator[None]:
    """SQLite's lock of a file: it works on every system and ends with the process that has it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    connection = sqlite3.connect(path, timeout=LONGEST_WAIT, isolation_level=None)
    with closing(connection) as lock:
        lock.execute("BEGIN EXCLUSIVE")
        yield
