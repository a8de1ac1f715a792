"""Toy certificates for the tests of the checker."""

from __future__ import annotations

import importlib.util
import sys
from copy import deepcopy
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest


def _load(name: str) -> ModuleType:
    """A support file beside this one; test folders are not on the import path."""
    known = f"certificate_{name}"
    if known not in sys.modules:
        spec = importlib.util.spec_from_file_location(
            known, Path(__file__).with_name(f"{name}.py"))
        assert spec is not None
        assert spec.loader is not None
        module = importlib.util.module_from_spec(spec)
        sys.modules[known] = module
        spec.loader.exec_module(module)
    return sys.modules[known]


_load("toy_writer")
_FAMILIES = _load("toy_families")
_ORIGINALS = {"acceleration": _FAMILIES.random_acceleration(),
              "memory": _FAMILIES.growing_memory()}


@pytest.fixture
def acceleration() -> dict[str, Any]:
    """The random-acceleration certificate, to be altered at will."""
    return deepcopy(_ORIGINALS["acceleration"])


@pytest.fixture
def memory() -> dict[str, Any]:
    """The growing-memory certificate, to be altered at will."""
    return deepcopy(_ORIGINALS["memory"])
