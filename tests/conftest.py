"""One cache for all tests, apart from the user's own; sizes of random samples."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Iterator
from functools import cache

import forked_children
import kept_processes
import one_of_each
import pytest
import samples
from catalogue_subjects import prepare_all
from lecture_judged import lecture_claims

from gainproof.jobs import workers
from gainproof.jobs.cache import FOLDER_VARIABLE
from gainproof.pages import citing
from gainproof.verify.judge.claim import file

AS_ASKED = sys.dont_write_bytecode
COLLECTED = 100_000
"""New objects after which cycles are looked for. What tests derive is kept for others, and there is
much of it: after every 700, as is usual, looking took an eighth of the time.
"""


def pytest_configure(config: pytest.Config) -> None:
    """Thorough runs draw larger samples; the environment is what other processes have too."""
    gc.set_threshold(COLLECTED)
    # each process of each session compiles four hundred test files otherwise: 7 s
    sys.dont_write_bytecode = False
    from hypothesis import HealthCheck, settings

    # how long drawing and an example take depends on what else the processor does
    settings.register_profile("usual", deadline=None, suppress_health_check=[HealthCheck.too_slow])
    settings.load_profile("usual")
    if samples.thorough(config.getoption("-m") or ""):
        os.environ.setdefault(samples.VARIABLE, str(samples.THOROUGH))
        # what names no size of its own
        settings.register_profile(
            "thorough", settings.get_profile("usual"), max_examples=samples.samples(100)
        )
        settings.load_profile("thorough")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Of cases that are `alike` all but a few are thorough; under `-m thorough` whatever draws
    samples is asked again, now with the larger ones.
    """
    for item in one_of_each.beyond_a_few(items):
        item.add_marker(pytest.mark.thorough)
    if samples.thorough(config.getoption("-m") or ""):
        for item in filter(samples.draws, items):
            item.add_marker(pytest.mark.thorough)


def pytest_collection_finish() -> None:
    """The tests themselves and what they import stay to the end: no cycles are looked for there.
    What tests write and import is compiled as it would be without us.
    """
    gc.freeze()
    sys.dont_write_bytecode = AS_ASKED


@pytest.fixture(scope="session", autouse=True)
def shared_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Derivations are made once a session; they depend on the code alone.

    Processes of pytest-xdist share one folder: it lies beside those of their own.
    """
    base = tmp_path_factory.getbasetemp()
    place = base.parent if "PYTEST_XDIST_WORKER" in os.environ else base
    with pytest.MonkeyPatch.context() as changed:
        changed.setenv(FOLDER_VARIABLE, str(place / "shared-cache"))
        # hundreds of interpreters are started, and without bytecode each compiles a hundred files
        changed.delenv("PYTHONDONTWRITEBYTECODE", raising=False)
        # the tests themselves take all processors; what asks for several processes names them
        changed.setattr(workers, "processors", lambda: 1)
        # pages and lists read all claim files, which takes a second; it depends on the text alone
        read_once = cache(file.read_claim_text)
        changed.setattr(file, "read_claim_text", read_once)
        changed.setattr(citing, "read_claim_text", read_once)
        keeper = kept_processes.Keeper()
        changed.setattr(workers, "Process", keeper.process())
        with forked_children.forked():
            yield
            keeper.close()


@pytest.fixture(scope="session")
def all_derived(shared_cache: None) -> None:
    """Every subject with its files is in the shared cache."""
    prepare_all()


@pytest.fixture(scope="session")
def lecture_known(shared_cache: None) -> None:
    """What is judged of the lecture is in the shared cache."""
    lecture_claims()
