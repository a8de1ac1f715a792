"""The toy certificates are accepted as they stand."""

from __future__ import annotations

from typing import Any

from tests.verify.certificate.toy_writer import expectations

from gainproof.verify.certificate import check


def test_acceleration_is_accepted(acceleration: dict[str, Any]) -> None:
    report = check(acceleration, **expectations(acceleration))
    assert report.accepted, report.reason
    assert report.count("proved") == 16
    assert report.count("cited") == 1
    assert report.count("definition") == 4


def test_memory_is_accepted(memory: dict[str, Any]) -> None:
    report = check(memory, **expectations(memory))
    assert report.accepted, report.reason
    assert report.count("proved") == len(memory["statements"])
