"""Campaigns: the same result over every executor, what is kept, what goes on, what is refused."""

from __future__ import annotations

import json
from argparse import ArgumentParser, Namespace
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from small_campaign import campaign, carried_out

from gainproof import cli
from gainproof.bad_input import BadInputError
from gainproof.campaign import state
from gainproof.campaign.campaign import Done
from gainproof.campaign.carrying_out import carry_out
from gainproof.campaign.options import add_options
from gainproof.campaign.running import run

Capture = pytest.CaptureFixture[str]


def given(folder: Path, *arguments: str) -> Namespace:
    parser = ArgumentParser()
    add_options(parser)
    words = ["--executor", "threads", "--state", str(folder / "state"), *arguments]
    return parser.parse_args(words)


def test_processes_and_threads_report_the_same(tmp_path: Path, capsys: Capture) -> None:
    told = []
    for where in ("processes", "threads"):
        options = given(tmp_path, "--executor", where, "--jobs", "2")
        options.state = str(tmp_path / where)
        assert carry_out(campaign(9, tmp_path / f"{where} notes", 0.01), options) == 0
        told.append(capsys.readouterr().out)
        assert sorted(carried_out(tmp_path / f"{where} notes")) == list(range(9))
    assert told[0] == told[1]
    assert "sum 204 of 0,1,2,3,4,5,6,7,8\nsquares: 9 of 9 blocks done" in told[0]


def test_what_is_done_is_not_done_again(tmp_path: Path, capsys: Capture) -> None:
    notes = tmp_path / "notes"
    assert carry_out(campaign(9, notes), given(tmp_path, "--blocks", "2-4")) == 0
    assert "sum 29 of 2,3,4\nsquares: 3 of 9 blocks done" in capsys.readouterr().out
    assert carry_out(campaign(9, notes), given(tmp_path)) == 0
    assert sorted(carried_out(notes)) == list(range(9))
    capsys.readouterr()
    assert carry_out(campaign(9, notes), given(tmp_path)) == 0
    assert len(carried_out(notes)) == 9
    shown = capsys.readouterr()
    assert "sum 204 of 0,1,2,3,4,5,6,7,8\n" in shown.out
    assert "0 blocks to do, 9 done" in shown.err
    # with other arguments, as of other code, it begins anew; what both have counts
    assert carry_out(campaign(9, notes, first=4), given(tmp_path)) == 0
    assert sorted(carried_out(notes)) == list(range(13))


def test_a_torn_line_is_one_block_to_do_again(tmp_path: Path) -> None:
    notes, file = tmp_path / "notes", tmp_path / "state"
    carry_out(campaign(5, notes), given(tmp_path, "--jobs", "1"))
    whole = file.read_bytes()
    last = whole.rindex(b"\n", 0, -1) + 1
    for length in range(last, len(whole)):
        file.write_bytes(whole[:length])
        # without its line end the last line may be whole
        assert len(state.read(file, campaign(5, notes))) == 4 + (length == len(whole) - 1)
    file.write_bytes(whole[:-9])
    carry_out(campaign(5, notes), given(tmp_path))
    assert len(carried_out(notes)) == 6
    assert len(state.read(file, campaign(5, notes))) == 5


def line_of(notes: Path, **changed: object) -> dict[str, object]:
    """That of the first block, with other entries; without those that are None."""
    block = [0, str(notes), 0.0]
    line = {"campaign": "squares", "block": block, "result": {"square": 0}, "seconds": 0.5}
    return {key: value for key, value in {**line, **changed}.items() if value is not None}


def test_lines_of_others_count_for_nothing(tmp_path: Path) -> None:
    notes, file = tmp_path / "notes", tmp_path / "state"
    lines = [
        line_of(notes, campaign="cubes", result={}),
        line_of(notes, campaign=None),
        line_of(notes, block=[99, str(notes), 0.0], seconds="long"),
        line_of(notes, block={"a": [0]}),
        line_of(notes, block=None),
        [line_of(notes)],
    ]
    deep = "[" * 100_000
    file.write_text(
        "\n".join(["\x00", "\ud800", "{}", deep, *map(json.dumps, lines)]),
        encoding="utf-8",
        errors="surrogatepass",
    )
    assert not state.read(file, campaign(3, notes))


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"result": None}, "no result"),
        ({"result": None, "seconds": None}, "no result and no seconds"),
        ({"seconds": "1"}, "seconds must be a number from 0, got '1'"),
        ({"seconds": True}, "seconds must be a number from 0, got True"),
        ({"seconds": -1}, "seconds must be a number from 0, got -1"),
        ({"seconds": float("nan")}, "seconds must be a number from 0, got nan"),
        ({"result": {}}, "no square"),
        ({"result": {"square": 1}}, "another result than that of line 2"),
    ],
)
def test_what_cannot_be_a_result_is_named_with_its_line(
    tmp_path: Path, changed: dict[str, object], message: str
) -> None:
    notes, file = tmp_path / "notes", tmp_path / "state"
    lines = [line_of(notes, campaign="cubes"), line_of(notes), line_of(notes)]
    file.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    assert len(state.read(file, campaign(3, notes))) == 1
    lines.append(line_of(notes, **changed))
    file.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    with pytest.raises(BadInputError, match=f"state, line 4: block 0 of squares: {message}"):
        carry_out(campaign(3, notes), given(tmp_path))
    assert not carried_out(notes)


def test_the_first_of_two_lines_counts_and_files_can_be_joined(tmp_path: Path) -> None:
    notes = tmp_path / "notes"
    for name, blocks in (("one", "0-2"), ("other", "2-4")):
        options = given(tmp_path, "--blocks", blocks)
        options.state = str(tmp_path / name)
        carry_out(campaign(5, notes), options)
    both = (tmp_path / "one").read_bytes() + (tmp_path / "other").read_bytes()
    (tmp_path / "state").write_bytes(both)
    assert sorted(state.read(tmp_path / "state", campaign(5, notes))) == [0, 1, 2, 3, 4]


def test_status_1_where_the_report_is_not_as_it_should_be(tmp_path: Path) -> None:
    assert carry_out(campaign(12, tmp_path / "notes", first=14), given(tmp_path)) == 1


def test_an_error_names_its_block_and_keeps_what_was_done(tmp_path: Path) -> None:
    notes = tmp_path / "notes"
    with pytest.raises(ValueError, match="thirteen") as error:
        carry_out(campaign(4, notes, first=10), given(tmp_path, "--jobs", "1"))
    assert error.value.__notes__ == [f"in block 3 of squares: (13, '{notes}', 0.0)"]
    assert sorted(state.read(tmp_path / "state", campaign(4, notes, first=10))) == [0, 1, 2]


def test_an_interrupt_begins_nothing_more(tmp_path: Path) -> None:
    notes = tmp_path / "notes"
    found: list[int] = []

    def interrupted(number: int, _done: Done) -> None:
        found.append(number)
        if len(found) == 2:
            raise KeyboardInterrupt

    small = campaign(200, notes, 0.01)
    with ThreadPoolExecutor(1) as pool, pytest.raises(KeyboardInterrupt):
        run(small, pool, range(50, 200), interrupted)
    assert len(carried_out(notes)) <= 5


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--blocks", "3-9"], "from 0 to 8, got '3-9'"),
        (["--blocks", "4-3"], "got '4-3'"),
        (["--blocks", "-1"], "got '-1'"),
        (["--blocks", "all"], "got 'all'"),
        (["--jobs", "0"], "--jobs is a number from 1 to 1024, got 0"),
        (["--jobs", "99999999999999"], "--jobs is a number from 1 to 1024, got 9999"),
        (["--executor", "prozesses"], "no executor is called 'prozesses'; wanted: processes"),
        (["--state", "/"], "/: a regular file is wanted"),
        (["--state", "/dev/zero"], "/dev/zero: a regular file is wanted"),
        (["--state", "/proc/none/state"], "/proc/none/state: cannot be written"),
    ],
)
def test_what_cannot_be_used_is_refused(tmp_path: Path, arguments: list[str], message: str) -> None:
    words = [f"{arguments[0]}={arguments[1]}"]
    with pytest.raises(BadInputError, match=message):
        carry_out(campaign(9, tmp_path / "notes"), given(tmp_path, *words))
    assert not carried_out(tmp_path / "notes")


def test_a_campaign_without_blocks_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BadInputError, match="squares: nothing is chosen"):
        carry_out(campaign(0, tmp_path / "notes"), given(tmp_path))


def test_the_command_lists_and_refuses(capsys: Capture) -> None:
    assert cli.main(["campaign"]) == 0
    assert capsys.readouterr().out.startswith("float32: every float32 input")
    assert cli.main(["campaign", "float23"]) == 2
    assert "no campaign is called 'float23'; nearest: float32" in capsys.readouterr().err
    assert cli.main(["campaign", "float32", "random_velocity.gain"]) == 2
    assert "nearest: random_velocity.gains" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words", ["float32 {0} --jobs 2 {1}", "--jobs 2 float32 --blocks 0-0 {0} {1}"]
)
def test_names_may_follow_options(words: str, capsys: Capture) -> None:
    kernels = ("random_velocity.gains", "random_velocity.gain")  # the second is none
    assert cli.main(["campaign", *words.format(*kernels).split()]) == 2
    assert "nearest: random_velocity.gains" in capsys.readouterr().err


def test_what_is_no_name_is_refused_after_options(capsys: Capture) -> None:
    for words in ("campaign float32 --jobs 2 --job 3 --wrong", "list --cancellations wrong"):
        with pytest.raises(SystemExit) as error:
            cli.main(words.split())
        assert error.value.code == 2
        assert "unrecognized arguments: " in capsys.readouterr().err
