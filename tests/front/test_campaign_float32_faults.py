"""Results of the float32 sweep that no block can have given are refused, with file and line."""

from __future__ import annotations

import json
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from gainproof import cli
from gainproof.campaign import float32
from gainproof.campaign.campaign import Campaign
from gainproof.campaign.float32.fault import count_of
from gainproof.campaign.float32.kernels import Swept, swept_kernels
from gainproof.campaign.float32.sweep import block

KERNELS = {kernel.id: kernel for kernel in swept_kernels()}
NAME = "least_squares_mean.predicted_covariance"
KERNEL = KERNELS[NAME]
FIRST = range(KERNEL.start, KERNEL.stop, float32.BLOCK)[-1]
PIECE = (FIRST, KERNEL.stop - FIRST)
"""Of the last block the first input, as bits, and how many there are."""
NAN = float("nan")


@cache
def campaign() -> Campaign:
    """Of the one kernel. Not made when the file is imported: digests of all kernels take long."""
    return float32.campaign([NAME])


def result(**changed: Any) -> dict[str, Any]:
    """A result of the last block, with other entries of its one output."""
    inputs = count_of(KERNEL, *PIECE)
    at = float(np.int32(FIRST).view(np.float32))
    tally = {"worst": 0.5, "at": at, "ulp": 0.75, "outside": 0, "undocumented": 0}
    return {"inputs": inputs, "outputs": {"predicted_11": {**tally, **changed}}}


def test_the_piece_is_that_of_the_last_block() -> None:
    assert campaign().blocks[-1][2:] == PIECE


def fault(found: Any) -> str | None:
    return campaign().fault(campaign().blocks[-1], found)


def test_what_blocks_give_is_taken() -> None:
    assert fault(result()) is None
    everything = count_of(KERNEL, *PIECE)
    assert fault(result(worst=0.0, ulp=0.0, at=None, outside=everything)) is None
    assert fault(result(worst=float("inf"), ulp=float("inf"))) is None
    for name in (NAME, "random_velocity.closed_loop_poles", "alpha_beta.minimum_variance_by_gain"):
        kernel = KERNELS[name]
        one = float32.campaign([name])
        for first in (kernel.start, kernel.stop - 3000):
            arguments = (name, kernel.digest(), first, 3000)
            found = json.loads(json.dumps(block(*arguments)))
            assert one.fault(arguments, found) is None


@pytest.mark.parametrize(
    ("found", "message"),
    [
        ({}, "a result is inputs and outputs, got {}"),
        ([], "a result is inputs and outputs"),
        ({"inputs": 1, "outputs": {}}, "inputs must be "),
        ({**result(), "inputs": 1.5}, "inputs must be "),
        ({**result(), "outputs": {}}, "outputs must be predicted_11, got {}"),
        ({**result(), "outputs": {"predicted_11": {}}}, "predicted_11: a tally is worst, ulp, at"),
        (result(more=1), "a tally is"),
        (result(outside=-1), "outside"),
        (result(outside=True), "outside"),
        (result(outside=1, undocumented=2), "2 undocumented"),
        (result(outside=10**9), "1000000000 outside"),
        (result(worst=-1.0), "errors of -1.0"),
        (result(worst=NAN), "errors of nan"),
        (result(ulp=NAN), "in the last place nan"),
        (result(worst="0.5"), "errors of '0.5'"),
        (result(worst=0.8), "errors of 0.8, in the last place 0.75"),
        (result(ulp=1.1), "in the last place 1.1"),
        (result(at=None), "no input of the block is None"),
        (result(at=1.0), "no input of the block is 1.0"),
        (result(at=1.1e15), "no input of the block is"),
        (result(at=-1.0), "no input of the block is -1.0"),
        (result(at=NAN), "no input of the block is nan"),
        (result(at=1e300), "no input of the block is 1e"),
        (result(outside=count_of(KERNEL, *PIECE)), "of no input"),
    ],
)
def test_what_no_block_gives_is_refused(found: Any, message: str) -> None:
    assert message in str(fault(found))


def test_the_command_names_file_and_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "state"
    line = {"campaign": "float32", "block": campaign().blocks[-1], "result": {}, "seconds": 1.0}
    file.write_text("\n" + json.dumps(line) + "\n", encoding="utf-8")
    assert cli.main(["campaign", "float32", NAME, "--state", str(file)]) == 2
    number = len(campaign().blocks) - 1
    assert f"state, line 2: block {number} of float32: a result is" in capsys.readouterr().err


def kernels_and_pieces() -> Iterator[tuple[Swept, int, int]]:
    for kernel in KERNELS.values():
        if kernel.whole:
            for bits in (kernel.start, 0x3F800000, 0x4AFFFF00, 0x4B000000, kernel.stop - 5000):
                yield kernel, max(bits, kernel.start), 5000


def test_whole_numbers_are_counted() -> None:
    for kernel, first, count in kernels_and_pieces():
        x = np.arange(first, first + count, dtype=np.int32).view(np.float32)
        assert count_of(kernel, first, count) == np.count_nonzero(x == np.floor(x))
    one = next(kernel for kernel in KERNELS.values() if not kernel.whole)
    assert count_of(one, 5, 7) == 7
