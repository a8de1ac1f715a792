"""A sample of the campaign over dimensions, and its oracle seen to work."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from random import Random

import pytest
from claim_campaign import mixed_units
from claim_campaign.proved import claim_paths
from claim_campaign.units import SECOND, equations, is_mixed, mixed, true_point
from one_of_each import cases

PATHS = {path.stem: path for path in claim_paths()}


@pytest.mark.parametrize("name", cases(sorted(PATHS), lambda name: name == "allenlu-notes"))
def test_what_is_false_in_other_units_is_seen(name: str) -> None:
    counts, wrong = mixed_units.mixed_units(PATHS[name], ())
    assert not wrong
    # sources whose formulas hold in all units, as those without units do, have nothing to be seen
    assert counts[mixed_units.SEEN] > 0 or name != "allenlu-notes"


def test_a_judge_that_sees_nothing_fails(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(mixed_units, "claim_readings", lambda *_: ((), None))
    assert mixed_units.mixed_units(PATHS["allenlu-notes"], ())[1]


OWN = """
format = "gainproof claims 1"
[source]
key = "test"
title = "made for this test"
authors = ["nobody"]
publication = "nowhere"
[settings.s]
title = "s"
kind = "algebra"
[settings.s.symbols]
'x' = { unit = "m", meaning = "length" }
'T' = { unit = "s", meaning = "time" }
'v' = { definition = 'x/T', meaning = "velocity" }
[[claims]]
id = "c"
place = "p"
kind = "identity"
setting = "s"
latex = 'v T + x = x + v T'
"""


def test_the_oracle_tells_what_is_mixed(tmp_path: Path) -> None:
    """One of two terms; not a definition that stands on both sides, which are equal whatever it
    is.
    """
    path = tmp_path / "test.toml"
    path.write_text(OWN, "utf-8")
    (subject,) = equations(path, ())
    point = true_point(subject, Random(1))
    assert point is not None
    assert is_mixed(subject, point, SECOND) is False
    found = {}
    for one in mixed(subject, SECOND):
        changed = replace(subject, claim=one.claim, setting=one.setting)
        found[one.words] = is_mixed(changed, point, SECOND)
    assert (
        found.pop("definition of v: ('div', ('symbol', 'x'), ('symbol', 'T')) multiplied") is False
    )
    assert found["left: ('symbol', 'x') multiplied"] is True
    assert len([w for w, said in found.items() if said]) == 10
