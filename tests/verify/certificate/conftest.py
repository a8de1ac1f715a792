"""Toy certificates for the tests of the checker."""

from __future__ import annotations

from copy import deepcopy
from typing import Any

import pytest
from tests.verify.certificate.toy_families import growing_memory, random_acceleration
from tests.verify.certificate.two_parameter_toy import certificate as walk_certificate

_ORIGINALS = {
    "acceleration": random_acceleration(),
    "memory": growing_memory(),
    "walk": walk_certificate(),
}


@pytest.fixture
def acceleration() -> dict[str, Any]:
    """The random-acceleration certificate, to be altered at will."""
    return deepcopy(_ORIGINALS["acceleration"])


@pytest.fixture
def memory() -> dict[str, Any]:
    """The growing-memory certificate, to be altered at will."""
    return deepcopy(_ORIGINALS["memory"])


@pytest.fixture
def walk() -> dict[str, Any]:
    """The certificate with two parameters, to be altered at will."""
    return deepcopy(_ORIGINALS["walk"])
