"""One cache for all tests of the front door, apart from the user's own."""

from __future__ import annotations

import os
from collections.abc import Iterator

import pytest

from gainproof.cache import FOLDER_VARIABLE


@pytest.fixture(scope="session", autouse=True)
def shared_cache(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Derivations are made once a session; they depend on the code alone."""
    before = os.environ.get(FOLDER_VARIABLE)
    os.environ[FOLDER_VARIABLE] = str(tmp_path_factory.mktemp("cache"))
    yield
    if before is None:
        del os.environ[FOLDER_VARIABLE]
    else:
        os.environ[FOLDER_VARIABLE] = before
