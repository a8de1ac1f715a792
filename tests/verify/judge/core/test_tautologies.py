"""What follows from the file's own definitions is marked, and nothing that needs the filter."""

from __future__ import annotations

import pytest
from claim_texts import judged

from gainproof.verdicts.verdict_reason import ANY_FILTER, reasons

SETTING = """
[settings.s]
title = 's'
{}
[settings.s.symbols]
'a' = {{ quantity = "filter_gain.1", meaning = "gain" }}
'b' = {{ quantity = "filter_gain.2", meaning = "gain" }}
'T' = {{ quantity = "sampling_interval", meaning = "interval" }}
'x' = {{ unit = '1', meaning = "a number" }}
'k' = {{ definition = 'a + 2 b', meaning = "a name" }}
'z' = {{ definition = '0 x', meaning = "a letter that is 0" }}
"""
KINDS = {
    "steady": "kind = 'steady_state'\nmodel = 'random-velocity'",
    "searched": "kind = 'steady_state'\nmodel = 'search'",
    "free": "kind = 'fixed_gain'\nstates = 2",
    "memory": "kind = 'growing_memory'\ndegree = 1",
}


@pytest.mark.parametrize("setting", KINDS.values(), ids=list(KINDS))
@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("identity", "a = a"),
        ("identity", "b - a = -(a - b)"),
        ("identity", "k - a = 2 b"),
        ("identity", "z b = 0"),
        ("identity", "x z = z"),
        ("identity", r"k^2 - a^2 = 4 a b + 4 b^2 = 4 b (a + b)"),
        ("inequality", "a^2 + b^2 >= 2 a b"),
    ],
)
def test_whatever_the_filter_is(setting: str, kind: str, latex: str) -> None:
    (found,) = judged(SETTING.format(setting), (kind, latex.replace(">=", r"\geq")))
    assert found.verdict == "proved", found.reason
    assert found.any_filter
    told = found.to_json()
    assert told["any_filter"] is True
    assert ANY_FILTER in reasons(told)


@pytest.mark.parametrize(
    ("setting", "kind", "latex"),
    [
        ("steady", "identity", "b (2 - a) = a^2"),
        ("steady", "identity", r"k = a + \frac{2 a^2}{2 - a}"),
        ("steady", "inequality", "a > 0"),
        ("steady", "inequality", "a^2 < a"),
        ("steady", "identity", r"\frac{\partial b}{\partial x} = 0"),
        ("memory", "inequality", r"b \leq a"),
    ],
)
def test_what_needs_the_filter(setting: str, kind: str, latex: str) -> None:
    (found,) = judged(SETTING.format(KINDS[setting]), (kind, latex))
    assert found.verdict == "proved", found.reason
    assert not found.any_filter
    assert ANY_FILTER not in reasons(found.to_json())


def test_without_a_model_all_follows_from_definitions_and_nothing_is_said() -> None:
    setting = "[settings.s]\ntitle = 's'\nkind = 'algebra'\n[settings.s.symbols]\n"
    (found,) = judged(setting + "'x' = { unit = '1', meaning = 'x' }\n", ("identity", "x = x"))
    assert (found.verdict, found.any_filter) == ("proved", False)
