"""Broken claim files: only the own error comes out, each after a bounded number of calls.

Calls and not seconds, since these depend on what else the processor does.
"""

from __future__ import annotations

import cProfile
import random
from pathlib import Path

import pytest
from samples import samples

import gainproof.verify
from gainproof.verify.judge.claim.file import ClaimFile, ClaimFileError, read_claim_text

INPUTS = 30
COUNTED = 6
"""Of so many the calls of one are counted, which takes as long as reading it four times."""
AT_MOST = 2
"""Times the calls that the whole file takes."""
LECTURE = Path(gainproof.verify.__file__).parent / "claims" / "kosuge-slides.toml"
PIECES = ("", "", "'", '"', "'''", "[", "]", "{", "}", "=", "\n", ",", "#", "\\", "id", "1", "true")


def part_of_the_lecture() -> str:
    """Enough of the lecture's file for every kind of table, and short enough to be read often."""
    lines = LECTURE.read_text(encoding="utf-8").split("\n")
    starts = [number for number, line in enumerate(lines) if line == "[[claims]]"]
    return "\n".join(lines[: starts[8]])


def read_or_refuse(text: str) -> ClaimFile | ClaimFileError:
    try:
        return read_claim_text(text, "own.toml")
    except ClaimFileError as error:
        return error


def calls(text: str) -> int:
    """How many it takes to read or refuse a text, those of Python's own functions included."""
    profile = cProfile.Profile()
    profile.runcall(read_or_refuse, text)
    return sum(entry.callcount for entry in profile.getstats())


@pytest.mark.sampled
def test_only_the_own_error() -> None:
    source, inputs = random.Random(7), samples(INPUTS)
    whole = part_of_the_lecture()
    assert isinstance(read_or_refuse(whole), ClaimFile)
    most = AT_MOST * calls(whole)
    refused = 0
    for number in range(inputs):
        text = whole
        for _ in range(source.randrange(1, 3)):
            start = source.randrange(len(text))
            end = start + source.choice((0, 1, 1, 5, 80))
            text = text[:start] + source.choice(PIECES) + text[end:]
        result = read_or_refuse(text)
        if number % COUNTED == 0:
            assert calls(text) < most
        if isinstance(result, ClaimFileError):
            refused += 1
            assert result.problem
            assert str(result).startswith("own.toml")
            assert result.line is None or 1 <= result.line <= text.count("\n") + 1
    assert refused > inputs // 4


def repeated_parts(claims: int, settings: int = 100, tokens: int = 500) -> str:
    symbols = "\n".join(f"'x_{{{n}}}' = {{ unit = '1', meaning = 'x' }}" for n in range(tokens))
    head = 'format = "gainproof claims 1"\n[source]\nkey = "k"\ntitle = "t"\nauthors = ["a"]\n'
    head += 'publication = "p"\n[symbols]\n'
    tables = "".join(
        f"[settings.s{n}]\ntitle = 't'\nkind = 'algebra'\n[settings.s{n}.symbols]\n"
        f"'y' = {{ definition = 'x_{{1}}', meaning = 'y' }}\n"
        for n in range(settings)
    )
    return f"{head}{symbols}\n{tables}" + "".join(
        f"[[claims]]\nid = '{n}'\nplace = 'p'\nkind = 'identity'\nsetting = 's{n % settings}'\n"
        "latex = 'y = x_{1}'\n"
        for n in range(claims)
    )


def test_many_repeated_parts_are_read() -> None:
    result = read_claim_text(repeated_parts(2000), "own.toml")
    assert len(result.claims) == 2000
    assert result.claims[-1].line > 4 * 2000


@pytest.mark.parametrize("part", ["claims", "settings", "tokens"])
def test_twice_the_parts_take_at_most_about_twice_the_calls(part: str) -> None:
    size = {"claims": 40, "settings": 20, "tokens": 40}
    first, second = (
        calls(repeated_parts(**(size | {part: times * size[part]}))) for times in (1, 2)
    )
    assert first < second < 2.1 * first
