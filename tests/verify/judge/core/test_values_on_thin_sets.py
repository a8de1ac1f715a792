"""Claims that have no value on a thin set of their stated domain are never proved."""

from __future__ import annotations

from collections import Counter

import pytest
from samples import samples
from small_claims import check, judged
from thin_sets import claims

CLOSE = "{ unit = '1', domain = '-1 < X < 1', meaning = 'a number' }"
NEAR = {name: CLOSE.replace("X", name) for name in "xyzvw"}
TREND = r"""about = ['\frac{x (y^2 + 2 z^2)}{y^2 + 2 z^2}', 'x']
trend = 'increasing'
text = 'it rises'"""


@pytest.mark.sampled
def test_none_without_a_value_somewhere_is_proved() -> None:
    for claim in claims(7, samples(8), has_value=False):
        found = claim.judged()
        assert found.verdict != "proved", (claim.fields, claim.symbols)
        if found.verdict == "conditional":
            assert found.witness is not None, claim.fields


@pytest.mark.sampled
def test_most_with_a_value_everywhere_are_proved() -> None:
    verdicts = Counter(claim.judged().verdict for claim in claims(8, samples(5), has_value=True))
    assert set(verdicts) <= {"proved", "held", "undecided"}
    assert verdicts["proved"] >= 0.9 * verdicts.total()


@pytest.mark.parametrize(
    ("kind", "fields", "domain", "point"),
    [
        # an isolated point of three symbols, of four, and a plane of four
        ("identity", r"\frac{x^2 + 2 y^2 + 3 z^2}{x^2 + 2 y^2 + 3 z^2} = 1",
         "x^2 + 2 y^2 + 3 z^2 != 0", {"x": "0", "y": "0", "z": "0"}),
        ("inequality", r"\frac{\partial}{\partial v} \frac{v}{\sqrt{x^2 + y^2 + z^2}} \geq 0",
         "x^2 + y^2 + z^2 != 0", {"v": "0", "x": "0", "y": "0", "z": "0"}),
        ("inequality", r"\frac{1}{(x - z)^2 + (y - w)^2} > 0",
         "w^2 - 2 w y + x^2 - 2 x z + y^2 + z^2 != 0", {"w": "0", "x": "0", "y": "0", "z": "0"}),
        ("monotone", TREND,
         "y^2 + 2 z^2 != 0", {"x": "0", "y": "0", "z": "0"}),
        # the right side holds where the left has no value, or says something else there
        ("equivalence", r"\frac{x}{y} = 0 \Leftrightarrow x = 0", "y != 0", {"x": "0", "y": "0"}),
        ("equivalence", r"\frac{x}{y - z} = 0 \Leftrightarrow x = 0",
         "y - z != 0", {"x": "0", "y": "0", "z": "0"}),
        ("equivalence", r"\frac{1}{x^2 + y^2} > 0 \Leftrightarrow x^2 + y^2 > 0",
         "x^2 + y^2 != 0", {"x": "0", "y": "0"}),
        # a hypothesis that has no value
        ("implication", r"\frac{x}{y} = 0 \Rightarrow x = 0",
         "-1 < y < 0 or 0 < y < 1", {"x": "0", "y": "0"}),
        ("implication", r"\frac{x}{y^2 + z^2} > 0 \Rightarrow x > 0",
         "y^2 + z^2 != 0", {"x": "0", "y": "0", "z": "0"}),
    ],
)  # fmt: skip
def test_where_it_has_none_is_told(
    kind: str, fields: str, domain: str, point: dict[str, str]
) -> None:
    found = judged(kind, fields, NEAR)
    check(found, "conditional")
    assert domain in (found.domain or "")
    assert found.witness is not None
    assert found.witness["point"] == point


@pytest.mark.parametrize(
    ("stated", "wanted"),
    [("xyz", "conditional"), ("x", "conditional"), ("z", "conditional"), ("", "proved")],
)
@pytest.mark.parametrize("names", ["xy", "xyz"])
def test_one_stated_domain_is_enough(stated: str, wanted: str, names: str) -> None:
    """However many symbols there are: a divisor that holds a symbol with a stated domain counts."""
    if stated == "z" and "z" not in names:
        wanted = "proved"
    divisor = " + ".join(f"{name}^2" for name in names)
    symbols = {name: CLOSE.replace("X", name) for name in stated}
    check(judged("identity", rf"\frac{{{divisor}}}{{{divisor}}} = 1", symbols), wanted)
