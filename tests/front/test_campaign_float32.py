"""The sweep of float32 inputs: a seeded thousandth of them, and errors that it must not miss."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from printed_kernels import printed_kernels

from gainproof.bad_input import BadInputError
from gainproof.bench.compiler import compiler
from gainproof.campaign import float32
from gainproof.campaign.campaign import Done
from gainproof.campaign.float32.kernels import Swept, swept_kernels
from gainproof.campaign.float32.reference import Compared
from gainproof.campaign.float32.report import report
from gainproof.campaign.float32.sweep import block
from gainproof.campaign.float32.tally import joined, tally

KERNELS = {kernel.id: kernel for kernel in swept_kernels()}
PIECES = 16
ONE_OF_EACH_KIND = (
    "random_velocity.gains",
    "random_velocity.closed_loop_poles",  # errors over a modulus that is no output
    "least_squares_mean.gains",  # whole numbers
    "acceleration_increments.gains",  # a root by Newton's steps
)
OUTPUT = Compared("y", 0, 0, 2.0, 1.0, 8.0)
needs_compiler = pytest.mark.skipif(compiler() is None, reason="no C compiler")


def thousandth(kernel: Swept) -> Any:
    """Seeded pieces of the inputs, a thousandth of them, both ends among them."""
    size = (kernel.stop - kernel.start) // (1000 * PIECES)
    inner = random.Random(kernel.id).sample(range(kernel.start, kernel.stop - size), PIECES - 2)
    places = [kernel.start, *inner, kernel.stop - size]
    results = [block(kernel.id, kernel.digest(), first, size) for first in places]
    return report([Done((kernel.id, kernel.digest()), result, 0.0) for result in results])


@needs_compiler
@pytest.mark.parametrize("name", ONE_OF_EACH_KIND)
def test_a_thousandth_of_the_inputs(name: str) -> None:
    found = thousandth(KERNELS[name])
    assert found.passed, found.text


@needs_compiler
@pytest.mark.thorough
@pytest.mark.parametrize("module", sorted({kernel.module for kernel in KERNELS.values()}))
def test_a_thousandth_of_the_inputs_of_all(module: str) -> None:
    for kernel in KERNELS.values():
        if kernel.module == module:
            found = thousandth(kernel)
            assert found.passed, found.text


def test_the_kernels_are_those_of_one_input() -> None:
    """As another reader of the printed modules has them."""
    assert list(KERNELS) == [kernel.id for kernel in printed_kernels()]


def test_the_digest_is_of_arithmetic_and_bounds() -> None:
    """Other words in the docstring change nothing; another bound or another step does."""
    kernel = KERNELS["random_velocity.gains"]
    text = str(kernel.function.__doc__)

    def described(words: str) -> str:
        def function() -> None: ...

        function.__doc__ = words
        return replace(kernel, function=function).digest()

    assert described(text) == described(text + " More.") == kernel.digest()
    assert text.count("* 2^-23 (float32)") == len(kernel.signature.outputs)
    assert described(text.replace("* 2^-23 (float32)", "* 2^-22 (float32)")) != kernel.digest()
    other = KERNELS["random_velocity.predictor_gains"].signature.block
    changed = replace(kernel, signature=kernel.signature._replace(block=other))
    assert changed.digest() != kernel.digest()


def test_the_blocks_are_all_inputs() -> None:
    """Every float32 number above 0, once; gains first."""
    campaign = float32.campaign(["random_velocity"])
    assert campaign.blocks[0][0] == "random_velocity.gains"
    bits = [b[2:] for b in campaign.blocks if b[0] == "random_velocity.gains"]
    assert bits[0][0] == 1
    assert all(first + count == bits[i + 1][0] for i, (first, count) in enumerate(bits[:-1]))
    largest = int(np.finfo(np.float32).max.view(np.int32))
    assert sum(bits[-1]) - 1 == largest
    assert sum(count for _, count in bits) == 2**31 - 2**23 - 1


@needs_compiler
def test_another_kernel_than_the_one_of_the_digest_is_refused() -> None:
    kernel = KERNELS["least_squares_mean.gains"]
    with pytest.raises(BadInputError, match="install the same gainproof"):
        block(kernel.id, "0" * 16, kernel.start, 10)


def measured(results: list[float], true: list[float], output: Compared = OUTPUT) -> Any:
    """The tally of results for the inputs 0.5, 1, 2, 4, ..."""
    x = np.ldexp(np.float32(0.5), np.arange(len(results)))
    expected = np.array(true)
    return tally(output, x, np.array(results, np.float32), expected, expected)


def test_errors_are_in_units_of_the_bound_and_in_the_last_place() -> None:
    unit = 2.0**-23
    found = measured([0.0, 1.0, 1.5 * (1 + unit), -1.5], [1e-46, 1.0, 1.5, -1.5])
    assert found["worst"] == pytest.approx(1.0, abs=0.4)
    assert found["at"] == 2.0
    # the result is one number away from the true one
    assert found["ulp"] == round(1.5 * (1 + unit) / unit) - 1.5 / unit
    assert (found["above"], found["outside"], found["undocumented"]) == (0, 1, 0)


@pytest.mark.parametrize("wrong", [1 + 3 * 2.0**-23, float("nan"), float("inf"), -1.0])
def test_a_wrong_result_is_above_its_bound(wrong: float) -> None:
    found = measured([0.0, 1.0, wrong, 1.0], [0.0, 1.0, 1.0, 1.0])
    assert found["above"] == 1
    assert found["at"] == 2.0
    assert found["worst"] > 2


@pytest.mark.parametrize("wrong", [float("nan"), 1.0, -1e-30, 3e38])
def test_what_is_not_documented_outside_the_range_is_counted(wrong: float) -> None:
    narrow = replace(OUTPUT, highest=1.0)
    found = measured([0.0, 1.0, wrong], [0.0, 1.0, 1.0], narrow)
    assert (found["outside"], found["undocumented"], found["above"]) == (2, 1, 0)
    for fine in (0.0, -1e-45, 2.0**-126, float("inf"), -float("inf")):
        assert not measured([0.0, 1.0, fine], [0.0, 1.0, 1.0], narrow)["undocumented"]


def test_parts_join_to_the_whole() -> None:
    one = measured([0.0, 1.0, 1.0, 1.0], [0.0, 1.0, 1.0, 1.0])
    other = measured([0.0, float("nan"), 1.0, 1 + 2.0**-22], [0.0, 1.0, 1.0, 1.0])
    both = joined([one, other, one])
    assert (both["above"], both["outside"]) == (1, 3)
    assert both["worst"] == both["ulp"] == float("inf")
    assert both["at"] == 1.0
    failing = report(
        [Done(("k", "0"), {"inputs": 4, "outputs": {"y": part}}, 0.0) for part in (one, both)]
    )
    assert not failing.passed
    assert "1 kernels, 8 inputs, above or undocumented: 1" in failing.text
