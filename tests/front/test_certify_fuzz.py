"""Certificates with one number altered, before the tools: nothing altered is accepted."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

import pytest

from gainproof.certify import tools
from gainproof.certify.subjects import Subject, chosen

SECONDS = 120.0
SAMPLE = {"flint": 60, "singular": 25, "coq": 4}
"""How many alterations of each kind a tool is given: coqc takes seconds for one."""


def _numbers(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Places of coefficients in a statement's evidence, by their paths."""
    if isinstance(value, dict):
        for key in value:
            yield from _numbers(value[key], (*path, key))
    elif isinstance(value, list):
        if len(value) == 2 and isinstance(value[0], str) and isinstance(value[1], list):
            yield (*path, 0)
        else:
            for place, part in enumerate(value):
                yield from _numbers(part, (*path, place))


def _altered(subject: Subject, name: str, path: tuple[Any, ...], rng: random.Random) -> Subject:
    certificate = json.loads(json.dumps(subject.certificate))
    (statement,) = (s for s in certificate["statements"] if s["id"] == name)
    certificate["statements"] = [statement]
    place = statement["evidence"]
    for step in path[:-1]:
        place = place[step]
    old = Fraction(place[path[-1]])
    place[path[-1]] = str(rng.choice([-old, old * 2, old + 1 or old + 2, old / 3]))
    assert Fraction(place[path[-1]]) != old
    return replace(subject, certificate=certificate)


@pytest.mark.thorough
@pytest.mark.parametrize("kind", ["riccati", "stable", "positive_definite"])
@pytest.mark.parametrize("name", list(SAMPLE))
def test_an_altered_number_of_the_evidence_is_rejected(name: str, kind: str) -> None:
    """Each coefficient stands in an identity that holds with it alone."""
    (tool,) = (tool for tool in tools.TOOLS if tool.name == name)
    if not tool.present():
        pytest.skip(f"{tool.program} is not installed")
    (subject,) = chosen(["random-velocity"])
    rng = random.Random(f"{name} {kind}")
    (statement, *_) = (s for s in subject.certificate["statements"] if s["kind"] == kind)
    places = list(_numbers(statement["evidence"]))
    assert places
    for path in rng.sample(places, min(SAMPLE[name], len(places))):
        outcome = tool.certify(_altered(subject, statement["id"], path, rng), SECONDS)
        assert outcome.rejected, (statement["id"], path)
