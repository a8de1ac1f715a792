"""Whatever the checker accepts of a mutated certificate is true at sampled points."""

from __future__ import annotations

import random
from copy import deepcopy
from typing import Any

import pytest
from one_of_each import cases
from tests.verify.certificate.mutation import mutate
from tests.verify.certificate.numeric_kinds import seems_true

from gainproof.verify.certificate import check

Data = dict[str, Any]


def mutated(certificate: Data, seed: int) -> Data:
    """One statement, its tower or its program mutated up to three times; that statement alone."""
    generator = random.Random(seed)
    altered = deepcopy(certificate)
    entry = generator.choice(altered["statements"])
    altered["statements"] = [entry]
    part = generator.choice(
        (
            entry,
            entry,
            entry["claim"],
            entry["claim"],
            altered["programs"],
            altered["towers"][entry["tower"]],
        )
    )
    for _ in range(generator.choice((1, 1, 2, 3))):
        if part:
            mutate(part, certificate, generator)
    return altered


def accepted_and_true(certificate: Data, seeds: range) -> tuple[int, list[int]]:
    """How many altered statements were accepted, and the seeds of those that are false."""
    accepted, false = 0, []
    for seed in seeds:
        altered = mutated(certificate, seed)
        report = check(altered)
        assert all(not r.reason.startswith("malformed") for r in report.statements), seed
        if any(result.status == "proved" for result in report.statements):
            accepted += 1
            if not seems_true(altered, altered["statements"][0], seed):
                false.append(seed)
    return accepted, false


@pytest.mark.parametrize("start", cases(range(0, 600, 100), lambda start: start == 0))
def test_accepted_is_true(acceleration: Data, memory: Data, walk: Data, start: int) -> None:
    for certificate in (acceleration, memory, walk):
        accepted, false = accepted_and_true(certificate, range(start, start + 100))
        assert false == []
        assert accepted > 5


def test_a_false_statement_would_be_noticed(acceleration: Data) -> None:
    """The numerical judge refutes claims altered without their evidence."""
    refuted = 0
    for seed in range(200):
        altered = mutated(acceleration, seed)
        entry = altered["statements"][0]
        if entry["kind"] in ("equal", "positive", "limit", "riccati", "program"):
            try:
                refuted += not seems_true(altered, entry, seed, points=1)
            except (LookupError, TypeError, ValueError, AttributeError, RecursionError):
                continue  # not even a statement any more
    assert refuted > 10


def test_every_statement_of_the_certificates_is_true(
    acceleration: Data, memory: Data, walk: Data
) -> None:
    """So that the numerical judge calls nothing false that holds."""
    for certificate in (acceleration, memory, walk):
        for number, entry in enumerate(certificate["statements"]):
            assert seems_true(certificate, entry, number), entry["id"]
