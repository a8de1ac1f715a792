"""Every number altered, every field deleted: rejected."""

from __future__ import annotations

import random
from copy import deepcopy
from typing import Any

import pytest
from samples import samples
from tests.verify.certificate.toy_changes import statement

from gainproof.verify.certificate import check
from gainproof.verify.certificate.alteration_campaign import Campaign
from gainproof.verify.certificate.alterations import Alteration, replaced
from gainproof.verify.certificate.document import read_document
from gainproof.verify.certificate.plain_data import plain
from gainproof.verify.certificate.rejection import Meter

Data = dict[str, Any]


def test_all_of_the_small_certificate(memory: Data) -> None:
    told: list[tuple[int, int]] = []
    campaign = Campaign(memory)
    tally = campaign.run(progress=lambda done, total: told.append((done, total)))
    assert tally.accepted == ()
    assert tally.total == len(campaign.alterations()) == len(told)
    assert told[-1] == (tally.total, tally.total)
    assert tally.refuted > 200
    # Left true, but not what was expected: k from 2 on; the branch not taken of the kernel, twice;
    # five statements that no other needs.
    assert tally.unexpected == 8


@pytest.mark.sampled
def test_sample_of_the_large_certificate(acceleration: Data) -> None:
    campaign, size = Campaign(acceleration), samples(250)
    chosen = random.Random(1).sample(campaign.alterations(), size)
    tally = campaign.run(chosen)
    assert tally.accepted == ()
    assert tally.malformed + tally.refuted + tally.unexpected == size


@pytest.mark.sampled
def test_shortcuts_agree_with_the_full_check(acceleration: Data) -> None:
    campaign = Campaign(acceleration)
    for alteration in random.Random(2).sample(campaign.alterations(), samples(30)):
        altered: Any = replaced(acceleration, alteration.path, alteration.new)
        assert check(altered).accepted == (
            campaign.outcome(alteration) in ("accepted", "unexpected")
        )


def test_every_part_is_altered(memory: Data) -> None:
    """Each leaf number at least twice, each field and entry deleted once."""
    found = Campaign(memory).alterations()
    deleted = {a.path for a in found if a.how == "deleted"}
    for path in (
        ("towers",),
        ("towers", "samples", "parameters", 0, "from"),
        ("statements", 3, "evidence"),
        ("programs", "root", "graph", "nodes", 3, 2),
        ("statements", 0, "claim", "summand", "nodes", 0),
    ):
        assert path in deleted
    numbers = [a for a in found if a.path == ("programs", "root", "graph", "nodes", 3, 2)]
    assert {a.how for a in numbers} == {"deleted", "plus one", "sign", "denominator"}
    assert len(found) == len({(a.path, a.how, str(a.new)) for a in found})


def test_deciding_twice_gives_the_same(acceleration: Data, memory: Data) -> None:
    """Deciding leaves the data alone, or the campaign would reject for a wrong reason."""
    for certificate in (acceleration, memory):
        value = plain(certificate)
        document = read_document(value, Meter())
        for _ in range(2):
            for entry in document.statements:
                assert document.decide(entry) in ("proved", "cited", "definition")
        assert value == certificate


def test_original_is_left_alone(memory: Data) -> None:
    before = deepcopy(memory)
    Campaign(memory).run(Campaign(memory).alterations()[:200])
    assert memory == before


def test_an_idle_number_would_be_found(memory: Data) -> None:
    """A number that nothing depends on: the reference of a citation."""
    memory["statements"].append(
        {
            "id": "1995",
            "kind": "cited",
            "tower": "branch",
            "evidence": {},
            "claim": {"theorem": "A theorem.", "reference": "1995"},
        }
    )
    campaign = Campaign(memory)
    alteration = Alteration(("statements", 7, "claim", "reference"), "plus one", "1996")
    assert alteration in campaign.alterations()
    assert check(replaced(memory, alteration.path, "1996")).accepted  # type: ignore[arg-type]
    assert campaign.outcome(alteration) == "unexpected"


def test_a_rejected_certificate_has_no_campaign(memory: Data) -> None:
    statement(memory, "line")["claim"]["free"] = ["f"]
    with pytest.raises(ValueError, match="not accepted as it stands: line"):
        Campaign(memory)
