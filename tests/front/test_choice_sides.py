"""Programs proved on several sides: without any one of them a certificate is refused."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

import pytest
from one_of_each import cases

import gainproof.generated
from gainproof.files import places
from gainproof.subjects.choice_sides import missing_sides

GENERATED = Path(gainproof.generated.__file__).parent
CERTIFICATES = [path.stem for path in places.certificates()]
WITH_SIDES = {
    "continuous_white_acceleration": 6,
    "position_velocity": 2,
    "position_velocity_random_acceleration": 2,
    "random_acceleration": 2,
    "random_velocity": 4,
    "range_doppler": 22,
}
"""How many statements are one of several sides, read from the statements' towers by hand."""


def shipped(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((GENERATED / f"{name}.json").read_text("utf-8"))
    return found


def sides(certificate: dict[str, Any]) -> list[str]:
    """The statements on outputs of which there is more than one."""
    programs = [s for s in certificate["statements"] if s["kind"] == "program"]
    count = Counter((s["claim"]["program"], o) for s in programs for o in s["claim"]["outputs"])
    return [
        s["id"]
        for s in programs
        if any(count[s["claim"]["program"], o] > 1 for o in s["claim"]["outputs"])
    ]


@pytest.mark.parametrize(
    "name", cases(CERTIFICATES, lambda name: name in WITH_SIDES or name == "alpha_beta")
)
def test_shipped_certificates_have_all_sides(name: str) -> None:
    certificate = shipped(name)
    assert missing_sides(certificate) == ""
    assert len(sides(certificate)) == WITH_SIDES.get(name, 0)


@pytest.mark.parametrize("name", WITH_SIDES)
def test_without_any_one_of_them_it_is_refused(name: str) -> None:
    certificate = shipped(name)
    for removed in sides(certificate):
        rest = [s for s in certificate["statements"] if s["id"] != removed]
        assert missing_sides({**certificate, "statements": rest}), removed
