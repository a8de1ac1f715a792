"""Trends, derivatives and limits along the deviations and the interval, with position and velocity
measured: each true one beside a false neighbour.
"""

from __future__ import annotations

import itertools
from typing import Any

import pytest
from claim_texts import HEAD
from one_of_each import cases, further

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.judge import judge_setting
from gainproof.verify.judge.verdict import ClaimVerdict

NOISES = {
    "continuous white acceleration": "[['a^2 T^4/3', 'a^2 T^3/2'], ['a^2 T^3/2', 'a^2 T^2']]",
    "random acceleration": "[['a^2 T^4/4', 'a^2 T^3/2'], ['a^2 T^3/2', 'a^2 T^2']]",
    "random velocity": "[['0', '0'], ['0', 'a^2 T^2']]",
}
SETTING = r"""
[symbols]
'T' = { quantity = "sampling_interval", meaning = "interval" }
'a' = { unit = "m s^-2", domain = 'a > 0', meaning = "deviation of the acceleration" }
'd' = { unit = "m s^-1", domain = 'd > 0', meaning = "deviation of a measured velocity" }
'o' = { quantity = "measurement_noise_deviation", meaning = "of a measured position" }
'S' = { quantity = "velocity_deviation_ratio", meaning = "ratio" }
'P' = { quantity = "predicted_covariance.1.1", meaning = "variance" }
'U' = { quantity = "updated_covariance.2.2", meaning = "variance" }
'K' = { quantity = "gain_matrix.1.2", meaning = "gain" }
'M' = { quantity = "gain_matrix.1.1", meaning = "gain" }
'G' = { definition = 'P/o^2', meaning = "ratio of variances" }
'r' = { definition = '\frac{4 o}{a T^2}', meaning = "4 over the index" }
'A' = { definition = '(4/r)^2', meaning = "its square" }
'Z' = { quantity = "exact_velocity_covariance.1.1", meaning = "limit" }
'N' = { quantity = "no_velocity_covariance.1.1", meaning = "limit" }
[settings.s]
title = "both measured"
kind = "steady_state"
transition = [["1", "T"], ["0", "1"]]
process_noise = NOISE
measurement = [["1", "0"], ["0", "1"]]
measurement_noise = [['o^2', "0"], ["0", 'd^2']]
"""
WHITE = "continuous white acceleration"
WAYS = ("increasing", "decreasing")


@pytest.fixture(scope="module")
def solved() -> dict[Any, Any]:
    """What was solved for one claim serves the next."""
    return {}


def only(
    solved: dict[Any, Any], kind: str, fields: str, name: str = WHITE, more: str = ""
) -> ClaimVerdict:
    said = fields if fields.startswith("about") else f"latex = '{fields}'"
    text = f"[[claims]]\nid = 'c'\nplace = 'p'\nsetting = 's'\nkind = '{kind}'\n{said}\n"
    file = read_claim_text(HEAD + SETTING.replace("NOISE", NOISES[name]) + more + text)
    return judge_setting(file.settings["s"], file.claims, [], solved)[0]


def trend(what: str, along: str, way: str, held: str = "") -> str:
    more = f"\nheld = {held}" if held else ""
    return f"about = ['{what}', '{along}']\ntrend = '{way}'\ntext = 't'{more}"


def check(found: ClaimVerdict, wanted: str) -> None:
    assert found.verdict == wanted, found.reason
    if wanted == "refuted":
        assert found.witness is not None


@pytest.mark.alike
@pytest.mark.parametrize(
    "name", [WHITE, *(pytest.param(n, marks=pytest.mark.thorough) for n in NOISES if n != WHITE)]
)
@pytest.mark.parametrize(
    ("what", "along", "way"),
    [
        ("G", "r", "decreasing"),
        further("G", "A", "increasing"),
        ("P", "a", "increasing"),
        ("P", "d", "increasing"),
        ("P", "o", "increasing"),
        further("G", "o", "decreasing"),
        ("P", "T", "increasing"),
        ("M", "o", "decreasing"),
        ("U", "a", "increasing"),
    ],
)
def test_trends(what: str, along: str, way: str, name: str, solved: dict[Any, Any]) -> None:
    (other,) = set(WAYS) - {way}
    check(only(solved, "monotone", trend(what, along, way), name), "proved")
    check(only(solved, "monotone", trend(what, along, other), name), "refuted")


@pytest.mark.parametrize(
    ("along", "way"),
    cases(itertools.product("raT", WAYS), lambda case: case in (("r", WAYS[0]), ("T", WAYS[1]))),
)
def test_what_rises_and_falls(along: str, way: str, solved: dict[Any, Any]) -> None:
    """The gain of the position for a measured velocity does both."""
    check(only(solved, "monotone", trend("K", along, way)), "refuted")


@pytest.mark.parametrize(
    ("what", "along", "held", "wanted"),
    [
        ("P", "o", "['r', 'S']", "proved"),
        ("G", "o", "['r', 'S']", "refuted"),
        ("G", "T", "['S']", "proved"),
        ("G", "T", "['r']", "proved"),
        further("G", "T", "['r', 'S']", "refuted"),
        # what stays fixes nothing, too much, or is one and the same
        ("G", "T", "['P']", "undecided"),
        ("G", "T", "['r', 'S', 'a']", "undecided"),
        ("G", "T", "['r', 'A']", "undecided"),
    ],
)
def test_what_stays(what: str, along: str, held: str, wanted: str, solved: dict[Any, Any]) -> None:
    check(only(solved, "monotone", trend(what, along, "increasing", held)), wanted)


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [
        (r"\frac{\partial r}{\partial T} = -\frac{2 r}{T}", "proved"),
        (r"\frac{\partial r}{\partial T} = -\frac{r}{T}", "refuted"),
        (r"\frac{\partial S}{\partial T} = \frac{S}{T}", "proved"),
        further(r"\frac{\partial a}{\partial T} = 0", "proved"),
        (r"\frac{\partial d}{\partial a} = 0", "proved"),
        (r"\frac{\partial r}{\partial a} = -\frac{r}{a}", "proved"),
        further(
            (
                r"T \frac{\partial G}{\partial T} = "
                r"2 a \frac{\partial G}{\partial a} + d \frac{\partial G}{\partial d}"
            ),
            "proved",
        ),
        further(
            (
                r"T \frac{\partial G}{\partial T} = "
                r"a \frac{\partial G}{\partial a} + d \frac{\partial G}{\partial d}"
            ),
            "refuted",
        ),
        (
            (
                r"o \frac{\partial P}{\partial o} = "
                r"2 P - a \frac{\partial P}{\partial a} - d \frac{\partial P}{\partial d}"
            ),
            "proved",
        ),
    ],
)
def test_derivatives(latex: str, wanted: str, solved: dict[Any, Any]) -> None:
    check(only(solved, "identity", latex), wanted)


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [
        (r"\lim_{a \to 0} G = 0", "proved"),
        (r"\lim_{a \to 0} G = 1", "refuted"),
        (r"\lim_{a \to \infty} M = 1", "proved"),
        (r"\lim_{d \to 0} G = \frac{Z}{o^2}", "proved"),
        (r"\lim_{d \to \infty} P = N", "proved"),
        (r"\lim_{d \to \infty} P = Z", "refuted"),
        further(r"\lim_{r \to \infty} G = 0", "proved"),
        further(r"\lim_{A \to 0} G = 0", "proved"),
        (r"\lim_{A \to 0} G = 1", "refuted"),
        further(r"\lim_{T \to 0} G = 0", "proved"),
        (r"\lim_{T \to 0} M = 1", "refuted"),
        further(r"\lim_{T \to \infty} M = 1", "proved"),
        (r"\lim_{o \to 0} M = 1", "proved"),
        further(r"\lim_{o \to 0} P = 0", "refuted"),
        further(r"\lim_{o \to \infty} P = \infty", "proved"),
        (r"\lim_{o \to \infty} G = 0", "proved"),
    ],
)
def test_limits(latex: str, wanted: str, solved: dict[Any, Any]) -> None:
    check(only(solved, "limit", latex), wanted)


@pytest.mark.parametrize("noise", ["variance", "ratio"])
def test_the_index_moves_whatever_the_noise_is_called(noise: str, solved: dict[Any, Any]) -> None:
    """Once proved: a chart whose coordinates were called otherwise was thought to have none."""
    found = only(
        solved, "identity", r"\frac{\partial G}{\partial T} = 0", more=f"noise = '{noise}'\n"
    )
    check(found, "refuted")
    found = only(solved, "monotone", trend("M", "T", "decreasing"), more=f"noise = '{noise}'\n")
    check(found, "refuted")
