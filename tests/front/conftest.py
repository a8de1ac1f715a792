"""One cache for all tests of the front door, apart from the user's own."""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path

import pytest

from gainproof import derivations, workers
from gainproof.cache import FOLDER_VARIABLE, default_folder
from gainproof.workshop import open_workshop

LONGEST_WAIT = 3600.0  # seconds: only for a process that hangs; one that ends lets others go on


@pytest.fixture(scope="session", autouse=True)
def shared_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Derivations are made once a session; they depend on the code alone.

    Processes of pytest-xdist share one folder: it lies beside those of their own.
    """
    base = tmp_path_factory.getbasetemp()
    place = base.parent if "PYTEST_XDIST_WORKER" in os.environ else base
    before = os.environ.get(FOLDER_VARIABLE)
    os.environ[FOLDER_VARIABLE] = str(place / "shared-cache")
    yield
    if before is None:
        del os.environ[FOLDER_VARIABLE]
    else:
        os.environ[FOLDER_VARIABLE] = before


OTHER_SEED = "4242"


@pytest.fixture(scope="session")
def all_derived(shared_cache: None) -> None:
    """Every subject with its files is in the shared cache, made in one go by one process only.

    Made with another hash seed than `gainproof run` has: that both come to the committed files
    shows that no order of a set is in them.
    """
    shop = open_workshop(quiet=True)
    assert workers.REPRODUCIBLE["PYTHONHASHSEED"] != OTHER_SEED
    with pytest.MonkeyPatch.context() as changed:
        changed.setitem(workers.REPRODUCIBLE, "PYTHONHASHSEED", OTHER_SEED)
        with _one_process_at_a_time(default_folder() / "deriving.lock"):
            jobs = [derivations.everything_job(name) for name in derivations.catalogue(shop)]
            shop.ahead(jobs, lambda _: [])


@contextmanager
def _one_process_at_a_time(path: Path) -> Iterator[None]:
    """SQLite's lock of a file: it works on every system and ends with the process that has it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    connection = sqlite3.connect(path, timeout=LONGEST_WAIT, isolation_level=None)
    with closing(connection) as lock:
        lock.execute("BEGIN EXCLUSIVE")
        yield
