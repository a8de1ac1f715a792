"""Claims of radar practice: powers with their units, decibels by a logarithm without a base."""

from __future__ import annotations

import pytest

from gainproof.verify.judge.claim.file import ClaimFileError, read_claim_text
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.verdict import ClaimVerdict

FILE = r"""
format = "gainproof claims 1"
[source]
key = "radar"
title = "Radar equation"
authors = ["A. Reader"]
publication = "unpublished"
SOURCE
[symbols]
'P_t' = { unit = "W", domain = 'P_t > 0', meaning = "power sent" }
'G' = { unit = "1", domain = 'G > 0', meaning = "gain" }
'\lambda' = { unit = "m", domain = '\lambda > 0', meaning = "wavelength" }
'\sigma' = { unit = "m^2", domain = '\sigma > 0', meaning = "cross section" }
'R' = { unit = "m", domain = 'R > 0', meaning = "range" }
'k' = { unit = "J/K", domain = 'k > 0', meaning = "Boltzmann's constant" }
'T' = { unit = "K", domain = 'T > 0', meaning = "temperature of the noise" }
'B' = { unit = "BANDWIDTH", domain = 'B > 0', meaning = "bandwidth" }
'P_r' = { definition = '\frac{P_t G^2 \lambda^2 \sigma}{(4\pi)^3 R^4}', meaning = "power received" }
'q' = { definition = '\frac{P_r}{k T B}', meaning = "signal over noise" }
'L' = { definition = '10 \log q', meaning = "the same in decibels" }
[settings.any]
title = "numbers"
kind = "algebra"
[[claims]]
id = "1"
place = "(1)"
kind = "identity"
setting = "any"
latex = 'CLAIM'
"""


def verdict(claim: str, source: str = "logarithm = 10", bandwidth: str = "Hz") -> ClaimVerdict:
    """On one claim of that file."""
    parts = {"CLAIM": claim, "SOURCE": source, "BANDWIDTH": bandwidth}
    text = FILE
    for name, part in parts.items():
        text = text.replace(name, part)
    (found,) = judge_file(read_claim_text(text), [])
    return found


IN_DECIBELS = (
    r"L = 10 \log \frac{P_t}{k T B} + 20 \log G + 20 \log \frac{\lambda}{R}"
    r" + 10 \log \frac{\sigma}{R^2} - 30 \log (4\pi)"
)


@pytest.mark.parametrize(
    "claim",
    [
        r"R = \left( \frac{P_t G^2 \lambda^2 \sigma}{(4\pi)^3 k T B q} \right)^{1/4}",
        IN_DECIBELS,
        r"q = 10^{L/10}",
    ],
)
def test_true_ones_are_proved(claim: str) -> None:
    found = verdict(claim)
    assert found.verdict == "proved", found.reason


@pytest.mark.parametrize("source", ["", "logarithm = 2"])
def test_decibels_need_the_logarithm_that_is_meant(source: str) -> None:
    assert verdict(r"q = 10^{L/10}", source).verdict == "refuted"
    assert verdict(IN_DECIBELS, source).verdict == "proved"


def test_a_power_without_its_bandwidth_has_the_wrong_dimension() -> None:
    found = verdict(r"q = \frac{P_t G^2 \lambda^2 \sigma}{(4\pi)^3 R^4 k T}")
    assert (found.verdict, found.method) == ("refuted", "dimensions")
    assert found.reason == "dimensions: the sides have dimensions 1 and s^-1"
    assert found.repair is not None
    assert r"R^{4} k T B}" in found.repair["latex"]


def test_a_definition_that_mixes_dimensions_is_named() -> None:
    found = verdict(r"q = 10^{L/10}", bandwidth="s")
    assert (found.verdict, found.method) == ("refuted", "dimensions")


@pytest.mark.parametrize("base", ["1", "1001", "'10'", "true", "2.5"])
def test_a_base_that_is_none(base: str) -> None:
    with pytest.raises(ClaimFileError, match=r"source\.logarithm"):
        verdict("q = q", f"logarithm = {base}")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("latex = 'CLAIM'", "plain = 'log(100 G) = 2 + log(G)'"),
        ("latex = 'CLAIM'", r"latex = 'G > 9'" + "\n" + r"domain = '\log G > 1'"),
        ("domain = 'G > 0'", r"domain = '\log G > 1'"),
    ],
)
def test_the_base_is_meant_in_every_field(old: str, new: str) -> None:
    text = FILE.replace("BANDWIDTH", "Hz").replace('kind = "identity"', 'kind = "KIND"')
    text = text.replace(old, new).replace("CLAIM", "G > 9")
    text = text.replace("KIND", "identity" if "plain" in new else "inequality")
    told = [
        judge_file(read_claim_text(text.replace("SOURCE", source)), [])[0].verdict
        for source in ("logarithm = 10", "")
    ]
    assert told[0] == "proved"
    assert told[1] != "proved"
