"""Domains without a point, and models that are none, are refused where they are stated."""

from __future__ import annotations

import pytest

from gainproof.verify.judge.claim.file import ClaimFileError, read_claim_text
from gainproof.verify.judge.claim.models import positive_semidefinite

TEXT = r"""format = "gainproof claims 1"

[source]
key = "someone-2001"
title = "Gains of a Filter"
authors = ["A. Someone"]
publication = "Journal of Filters"

[symbols]
'x' = { unit = "1", domain = 'x > 0', meaning = "a number" }
'y' = { unit = "1", meaning = "another" }
'n' = { unit = "1", integer = true, meaning = "a whole number" }

[settings.own]
title = "a model of the source"
kind = "steady_state"
transition = [["1", "1"], ["0", "1"]]
process_noise = [["1/4", "1/2"], ["1/2", "1"]]
measurement = [["1", "0"]]
measurement_noise = [["1"]]

[[claims]]
id = "1"
place = "p. 1"
kind = "identity"
setting = "own"
latex = 'x = y'
domain = 'y < 1'
"""
NOISE = '[["1/4", "1/2"], ["1/2", "1"]]'


def with_domain(domain: str, latex: str = "x = y") -> str:
    return TEXT.replace("y < 1", domain).replace("x = y", latex)


@pytest.mark.parametrize(
    "domain",
    [
        "y < 1",
        "y < x",
        "0 < n, n < 2",
        "x < y, y < 2, x > 1",
        "x \\le 1, x \\ge 1",
        "y \\le x, x \\le y, y = x",
        "x + y > 0, x + y < 1",
    ],
)
def test_domains_with_points_are_read(domain: str) -> None:
    assert read_claim_text(with_domain(domain)).claims


@pytest.mark.parametrize(
    ("domain", "named"),
    [
        ("x < 0", "x > 0 and x < 0"),
        ("x < y, y < x", "x < y and y < x"),
        ("y > 2, y < 1", "y > 2 and y < 1"),
        ("y > 2 and y < x and x < 1", "y > 2 and y < x and x < 1"),
        ("0 < n, n < 1", "0 < n and n < 1"),
        ("y = x, y \\ne x", "y = x and y \\ne x"),
        ("y \\le x, y \\ge x, x \\ne y", "y \\ge x and x \\ne y"),
        ("y < y", "y < y"),
        ("2 < 1", "2 < 1"),
        ("x = -1", "x > 0 and x = -1"),
        ("y < \\frac{1}{3}, 3y > 1, y > 0.5", "y > "),
    ],
)
def test_domains_without_points(domain: str, named: str) -> None:
    with pytest.raises(ClaimFileError) as caught:
        read_claim_text(with_domain(domain), "own.toml")
    assert caught.value.where == "claims.1.domain"
    assert caught.value.line == TEXT.split("\n").index("domain = 'y < 1'") + 1
    assert named in caught.value.problem


def test_a_printed_condition_counts() -> None:
    text = with_domain("y < 1", "x = y \\quad (y > 2)")
    with pytest.raises(ClaimFileError, match="the domain is empty"):
        read_claim_text(text)


def test_symbols_whose_domains_contradict_one_another() -> None:
    text = TEXT.replace("'y' = { unit", "'y' = { domain = 'x < 0', unit")
    with pytest.raises(ClaimFileError, match=r"settings\.own: the domains of its symbols"):
        read_claim_text(text)


@pytest.mark.parametrize(
    ("old", "new", "field", "problem"),
    [
        (NOISE, '[["1/4", "1/2"], ["1/2", "1/2"]]', "process_noise", "positive semidefinite"),
        (NOISE, '[["0", "1/2"], ["1/2", "1"]]', "process_noise", "positive semidefinite"),
        (NOISE, '[["1/4", "1/2"], ["1/3", "1"]]', "process_noise", "symmetric"),
        (NOISE, '[["1/4"]]', "process_noise", "wanted 2 by 2, but it is 1 by 1"),
        ('[["1"]]', '[["-1"]]', "measurement_noise", "positive semidefinite"),
        ('[["1"]]', '[["1", "1"]]', "measurement_noise", "wanted 1 by 1"),
        ('[["1", "0"]]', '[["1"]]', "measurement", "wanted 1 by 2"),
        ('[["1", "1"], ["0", "1"]]', '[["1", "1"]]', "transition", "wanted 1 by 1"),
        ('[["1", "0"]]', '[["1", "q"]]', "measurement", "q"),
    ],
)
def test_models_refused(old: str, new: str, field: str, problem: str) -> None:
    with pytest.raises(ClaimFileError) as caught:
        read_claim_text(TEXT.replace(old, new))
    assert caught.value.where == f"settings.own.{field}"
    assert problem in caught.value.problem
    line = caught.value.line
    assert line is not None
    assert TEXT.split("\n")[line - 1].startswith(field)


def test_symbols_in_a_noise_are_left_to_the_judge() -> None:
    assert read_claim_text(TEXT.replace(NOISE, '[["-x", "0"], ["0", "1"]]')).settings


@pytest.mark.parametrize(
    ("rows", "answer"),
    [
        ([[0]], True),
        ([[1, 1], [1, 1]], True),
        ([[2, 1, 0], [1, 2, 1], [0, 1, 2]], True),
        ([[1, 2, 0], [2, 1, 0], [0, 0, 1]], False),
        ([[0, 0], [0, -1]], False),
    ],
)
def test_positive_semidefinite(rows: list[list[int]], answer: bool) -> None:
    from fractions import Fraction

    assert positive_semidefinite([[Fraction(n) for n in row] for row in rows]) is answer


def test_models_of_the_catalogue_by_name() -> None:
    models = ["random-velocity", "random-acceleration"]
    start = TEXT.index("transition =")
    end = TEXT.index("[[claims]]")
    named = TEXT[:start] + 'model = "random-velocty"\n\n' + TEXT[end:]
    assert read_claim_text(named).settings["own"].model == "random-velocty"
    with pytest.raises(ClaimFileError, match=r"line 17: .*the nearest is random-velocity"):
        read_claim_text(named, "own.toml", models)
    strange = named.replace("random-velocty", "zzz")
    with pytest.raises(ClaimFileError, match="known are random-velocity, random-acceleration"):
        read_claim_text(strange, "own.toml", models)
