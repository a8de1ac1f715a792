"""Broken claim files: only the own error comes out, each in bounded time."""

from __future__ import annotations

import random
import time
from pathlib import Path

import pytest
from samples import samples

import gainproof.verify
from gainproof.verify.judge.claim.file import ClaimFile, ClaimFileError, read_claim_text

INPUTS = 60
SECONDS_EACH = 10.0
LECTURE = Path(gainproof.verify.__file__).parent / "claims" / "kosuge-slides.toml"
PIECES = ("", "", "'", '"', "'''", "[", "]", "{", "}", "=", "\n", ",", "#", "\\", "id", "1", "true")


def part_of_the_lecture() -> str:
    """Enough of the lecture's file for every kind of table, and short enough to be read often."""
    lines = LECTURE.read_text(encoding="utf-8").split("\n")
    starts = [number for number, line in enumerate(lines) if line == "[[claims]]"]
    return "\n".join(lines[: starts[8]])


def read_or_refuse(text: str) -> ClaimFile | ClaimFileError:
    start = time.perf_counter()
    result: ClaimFile | ClaimFileError
    try:
        result = read_claim_text(text, "own.toml")
    except ClaimFileError as error:
        result = error
    assert time.perf_counter() - start < SECONDS_EACH
    return result


@pytest.mark.sampled
def test_only_the_own_error() -> None:
    source, inputs = random.Random(7), samples(INPUTS)
    whole = part_of_the_lecture()
    assert isinstance(read_or_refuse(whole), ClaimFile)
    refused = 0
    for _ in range(inputs):
        text = whole
        for _ in range(source.randrange(1, 3)):
            start = source.randrange(len(text))
            end = start + source.choice((0, 1, 1, 5, 80))
            text = text[:start] + source.choice(PIECES) + text[end:]
        result = read_or_refuse(text)
        if isinstance(result, ClaimFileError):
            refused += 1
            assert result.problem
            assert str(result).startswith("own.toml")
            assert result.line is None or 1 <= result.line <= text.count("\n") + 1
    assert refused > inputs // 4


def test_repeated_parts_in_bounded_time() -> None:
    tokens = "\n".join(f"'x_{{{n}}}' = {{ unit = '1', meaning = 'x' }}" for n in range(500))
    head = 'format = "gainproof claims 1"\n[source]\nkey = "k"\ntitle = "t"\nauthors = ["a"]\n'
    head += 'publication = "p"\n[symbols]\n'
    settings = "".join(
        f"[settings.s{n}]\ntitle = 't'\nkind = 'algebra'\n[settings.s{n}.symbols]\n"
        f"'y' = {{ definition = 'x_{{1}}', meaning = 'y' }}\n"
        for n in range(100)
    )
    claims = "".join(
        f"[[claims]]\nid = '{n}'\nplace = 'p'\nkind = 'identity'\nsetting = 's{n % 100}'\n"
        "latex = 'y = x_{1}'\n"
        for n in range(2000)
    )
    result = read_or_refuse(head + tokens + "\n" + settings + claims)
    assert isinstance(result, ClaimFile)
    assert len(result.claims) == 2000
    assert result.claims[-1].line > 4 * 2000
