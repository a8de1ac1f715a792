"""Claim files made to do harm, in the folder `hostile`: the first line of each says what must come
of it, a message or a verdict, and none may take longer than its limit or leave a process behind.
"""

from __future__ import annotations

import multiprocessing
import os
import time
from pathlib import Path

import pytest
from one_of_each import cases

from gainproof.bad_input import BadInputError
from gainproof.claims import judgements
from gainproof.verify.judge.claim.file import ClaimFileError, read_claim_file, read_claim_text
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.repair.task import OVERTIME, SECONDS

FILES = sorted((Path(__file__).parent / "hostile").glob("*.toml"))
LIMIT = 1.0
"""Seconds for a claim here."""
SHORT = 0.2
"""For one that is stopped whatever the limit is."""
SPARE = 300.0
"""Seconds for starting processes, of which a busy machine may take many; what hangs takes more."""
OWNED = Path("owned")


def expected(path: Path) -> tuple[str, str]:
    kind, _, words = path.read_text(encoding="utf-8").partition("\n")[0][2:].partition(":")
    return kind, words.strip()


def answer(path: Path, limit: float) -> tuple[str, str]:
    """`error` with the message, or a verdict with its reason."""
    try:
        claim_file = read_claim_file(path)
    except ClaimFileError as error:
        return "error", str(error)
    (verdict,) = judge_file(claim_file, [], seconds=limit, processes=2)
    return verdict.verdict, verdict.reason


@pytest.mark.parametrize(
    "path", cases(FILES, lambda path: path in FILES[::2]), ids=lambda path: path.stem
)
def test_what_comes_of_it(path: Path) -> None:
    kind, words = expected(path)
    start = time.monotonic()
    found, said = answer(path, SHORT if "stopped" in words else LIMIT)
    # where only points are left to be tried, the machine's speed decides whether they are
    assert found == kind or (kind, found) == ("undecided", "held"), said
    assert words in said
    # nothing of the file may steer a terminal
    assert all(character.isprintable() or character == "\n" for character in said)
    assert time.monotonic() - start < LIMIT + SECONDS + OVERTIME + SPARE
    assert not multiprocessing.active_children()
    assert not OWNED.exists()


def test_one_of_each_kind_of_harm() -> None:
    kinds = [expected(path)[0] for path in FILES]
    assert kinds.count("error") >= 20
    assert kinds.count("undecided") >= 6


def test_a_hostile_claim_costs_no_other() -> None:
    hostile = Path(FILES[0].parent / "number-of-a-tower-of-powers.toml").read_text("utf-8")
    good = hostile[hostile.index("[[claims]]") :].replace('"c1"', '"c2"')
    start = good.index("latex = ")
    end = good.index("\n", start)
    text = hostile + good[:start] + "latex = '(x + 1)^2 = x^2 + 2x + 1'" + good[end:]
    verdicts = judge_file(read_claim_text(text), [], seconds=SHORT, processes=1)
    assert [verdict.verdict for verdict in verdicts] == ["undecided", "proved"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
def test_what_is_no_regular_file(tmp_path: Path) -> None:
    pipe, loop, link = tmp_path / "pipe.toml", tmp_path / "loop.toml", tmp_path / "link.toml"
    os.mkfifo(pipe)
    loop.symlink_to(loop)
    link.symlink_to(pipe)
    zero = tmp_path / "zero.toml"
    zero.symlink_to("/dev/zero")
    for path in (pipe, loop, link, zero, tmp_path, Path("/dev/zero"), Path("/dev/stdin")):
        with pytest.raises(ClaimFileError, match="cannot be read"):
            read_claim_file(path)
        with pytest.raises(BadInputError, match=r"regular file|cannot be read"):
            judgements.read(path)


def test_a_file_of_any_size_is_refused_unread(tmp_path: Path) -> None:
    path = tmp_path / "large.toml"
    with path.open("wb") as stream:
        stream.truncate(1 << 40)  # a hole: nothing is written
    start = time.monotonic()
    with pytest.raises(ClaimFileError, match="more than 1048576 bytes"):
        read_claim_file(path)
    assert time.monotonic() - start < SPARE
