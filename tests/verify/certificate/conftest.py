"""Toy certificates for the tests of the checker."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import pytest
from tests.verify.certificate.toy_families import growing_memory, random_acceleration

_ORIGINALS = {"acceleration": random_acceleration(), "memory": growing_memory()}


@pytest.fixture
def acceleration() -> dict[str, Any]:
    """The random-acceleration certificate, to be altered at will."""
    return deepcopy(_ORIGINALS["acceleration"])


@pytest.fixture
def memory() -> dict[str, Any]:
    """The growing-memory certificate, to be altered at will."""
    return deepcopy(_ORIGINALS["memory"])
