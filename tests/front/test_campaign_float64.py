"""The campaign of float64 inputs: a few of its points, its reference, errors it must not miss."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from graph_kernels import simple

from gainproof.bad_input import BadInputError
from gainproof.bench.compiler import compiler
from gainproof.campaign import float64
from gainproof.campaign.campaign import Done
from gainproof.campaign.float64.block import drawn, graph
from gainproof.campaign.float64.c_text import c_text, rounded_constants
from gainproof.campaign.float64.compiled import Compared, Measure, measure_of
from gainproof.campaign.float64.kernels import DEFAULT, sampled
from gainproof.campaign.float64.report import doubt, fault, report

pytestmark = pytest.mark.skipif(compiler() is None, reason="no C compiler")
NOISE_AT_4 = {"random_velocity": 1, "random_acceleration": 0, "continuous_white_acceleration": 3}
UNIT = 2.0**-52


@pytest.mark.parametrize(
    "name",
    [DEFAULT[1], *(pytest.param(n, marks=pytest.mark.thorough) for n in (DEFAULT[0], DEFAULT[2]))],
)
def test_some_points(name: str) -> None:
    campaign = float64.campaign([name], 4000)
    assert [block[4:] for block in campaign.blocks] == [(4000, 0, 4000)] * 2
    done = [Done(block, campaign.work(*block), 0.0) for block in campaign.blocks]
    assert not any(campaign.fault(each.arguments, each.result) for each in done)
    found = campaign.report(done)
    assert found.passed
    assert "whole domain" in found.text
    assert "2^-24 to 2^24" in found.text
    worst = [each.result["outputs"]["beta"] for each in done]
    assert all(0.8 < each["worst"] < 2.68 for each in worst)
    assert all(each["worst"] <= each["ulp"] <= 2 * each["worst"] for each in worst)


@pytest.mark.parametrize("name", DEFAULT)
def test_the_reference_is_right(name: str) -> None:
    """Against the equations of the gains, which cancel, in 1,500 digits: given as results, what is
    right to 53 digits must be half a unit off, and no more."""
    (kernel,) = sampled([name])
    made = Compared(measure_of(graph(name)), ("alpha", "beta"), kernel.ends)
    generator = random.Random(name)
    x = [2.0 ** generator.uniform(-1000, 1000) for _ in range(60)]
    x += [2.0 ** generator.uniform(-20, 20) for _ in range(60)]
    with mpmath.workdps(1500):
        right = [_gains(mpmath.mpf(each), NOISE_AT_4[name.partition(".")[0]]) for each in x]
        alpha, beta = (np.array([float(each[k]) for each in right]) for k in (0, 1))
    made.add(np.array(x), [alpha, beta])
    for tally in made.tallies().values():
        assert 0.4 < tally["ulp"] < 0.5 + doubt(2.7, 3)
        assert tally["outside"] == 0


def _gains(index: Any, of_noise: int) -> tuple[Any, Any]:
    """From z = 1 and z = -1 in the spectrum; the ratio of noise(4) to noise(0) is 1, 0 or 1/3."""
    e = mpmath.mpf(1) / of_noise if of_noise else mpmath.mpf(0)
    m = (index + mpmath.sqrt(16 + e * index**2)) / 2
    sigma = (m + mpmath.sqrt(m**2 - 4)) / 2
    return 1 - 1 / sigma**2, index / sigma


@cache
def _measure() -> Measure:
    """Of a kernel whose output is its input, compiled once for all tests of a process."""
    return measure_of(simple(lambda _builder, x: x))


def _tally(results: list[float], x: list[float], ends: tuple[float, float] = (1.0, 8.0)) -> Any:
    made = Compared(_measure(), ("y",), (ends,))
    for one, other in zip(x, results, strict=True):
        made.add(np.array([one]), [np.array([other])])
    return made.tallies()["y"]


def test_errors_are_in_units_of_the_bound_and_in_the_last_place() -> None:
    found = _tally([1.0, 3.0 * (1 + UNIT), 4.0 - UNIT], [1.0, 3.0, 4.0])
    assert found == {"worst": 4 / 3, "at": 3.0, "ulp": 2.0, "outside": 0, "undocumented": 0}


@pytest.mark.parametrize("wrong", [float("nan"), float("inf"), -2.0, 0.0, 2 + 6 * UNIT])
def test_a_wrong_result_is_above_its_bound(wrong: float) -> None:
    found = _tally([1.0, wrong, 4.0], [1.0, 2.0, 4.0])
    assert found["at"] == 2.0
    assert found["worst"] >= 3.0
    assert found["ulp"] >= 3.0
    assert not _passes(found)
    assert _passes(_tally([1.0, 2.0, 4.0], [1.0, 2.0, 4.0]))


def test_what_the_reference_leaves_in_doubt_is_above_the_bound() -> None:
    close = _tally([1.0, 2.0], [1.0, 2.0]) | {"worst": 1.95}
    assert not _passes(close)
    assert _passes(close | {"worst": 1.94})


@pytest.mark.parametrize("wrong", [float("nan"), 1.0, -1e-300, 1e308])
def test_what_is_not_documented_outside_the_range_is_counted(wrong: float) -> None:
    found = _tally([0.0, wrong, 1.0], [0.5, 16.0, 1.0])
    assert (found["outside"], found["undocumented"], found["worst"]) == (2, 1, 0)
    assert not _passes(found)
    fine = [0.0, -5e-324, 2.0**-1022, float("inf"), -float("inf")]
    assert _passes(_tally(fine, [16.0] * 5))


def _passes(tally: Any) -> bool:
    """Whether a block of random acceleration with this of each output is reported as right."""
    (kernel,) = sampled([DEFAULT[1]])
    promised = tuple(replace(each, bound=Fraction(195, 100)) for each in kernel.promised)
    found = replace(kernel, promised=promised)
    name, place = DEFAULT[1], (1, 9)
    fine = {**tally, "worst": 0.5, "undocumented": 0}
    result = {"inputs": 4, "outputs": {"alpha": fine, "beta": tally}}
    done = [Done((name, "0", *place, 4, 0, 4), result, 0.0)]
    return report({name: found}, {name: 0}, {place: "here"}, done).passed


def test_points_are_one_of_each_part_and_both_ends() -> None:
    low, high = 10**12, 10**12 + 7 * 10**9
    bits = [
        x.view(np.int64) for k in range(7) for x in drawn(low, high, 70_000, k * 10_000, 10_000)
    ]
    parts = (np.concatenate(bits) - low) // ((high - low + 1) // 70_000)
    assert parts[:-1].tolist() == list(range(69_999))
    assert (bits[0][0], bits[-1][-1]) == (low, high)
    again = next(iter(drawn(low, high, 70_000, 20_000, 10_000)))
    assert (again.view(np.int64) == bits[2]).all()
    with pytest.raises(BadInputError, match="4 points are wanted of 3 numbers"):
        next(iter(drawn(1, 3, 4, 0, 4)))


def test_kernels_that_cannot_be_compared_are_refused() -> None:
    for name, words in (
        ("least_squares_mean.gains", "any positive numbers"),
        ("random_acceleration.closed_loop_poles", "relative to the true values"),
        ("acceleration_increments.gains", "near_cbrt has no counterpart"),
    ):
        with pytest.raises(BadInputError, match=words):
            c_text(graph(sampled([name])[0].swept.id))
    third = simple(lambda builder, x: builder.number("1/3") - x)
    with pytest.raises(BadInputError, match="differences beside rounded constants"):
        rounded_constants(third)
    assert rounded_constants(simple(lambda builder, x: builder.number("1/3") * x)) == 1


def test_a_kernel_of_another_digest_is_refused() -> None:
    campaign = float64.campaign([DEFAULT[0]], 10)
    name, _digest, *rest = campaign.blocks[0]
    with pytest.raises(BadInputError, match="install the same gainproof"):
        campaign.work(name, "0" * 16, *rest)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"inputs": 3}, "a result of 4 inputs"),
        ({"outputs": {"alpha": {}}}, "outputs must be alpha, beta"),
        ({"outputs": {"alpha": {"worst": 1}, "beta": {}}}, "alpha: at, outside"),
    ],
)
def test_what_no_block_has_given_is_found(change: Any, words: str) -> None:
    (kernel,) = sampled([DEFAULT[0]])
    arguments = (DEFAULT[0], "0", 1, 9, 4, 0, 4)
    tally = _tally([1.0], [1.0])
    result = {"inputs": 4, "outputs": {"alpha": tally, "beta": tally}}
    assert fault({DEFAULT[0]: kernel}, arguments, result) is None
    assert words in str(fault({DEFAULT[0]: kernel}, arguments, result | change))


def test_the_record_is_of_the_kernels_as_they_are() -> None:
    """`tests/campaigns/float64.md`: of each kernel and range all points, within 3 units."""
    text = (Path(__file__).parents[1] / "campaigns" / "float64.md").read_text("utf-8")
    digest = ""
    said = []
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if len(cells) == 9 and cells[2] in ("alpha", "beta"):
            digest = cells[0] or digest
            assert float(cells[4]) < float(cells[3])
            assert float(cells[5]) <= 3
            assert cells[8] == "0"
            said.append((digest, cells[1], cells[2]))
    wanted = [
        (f"{kernel.swept.id} `{kernel.digest()}`, {place}", points, output)
        for kernel in sampled(())
        for place in ("whole domain", "2^-24 to 2^24")
        for points, output in ((str(float64.POINTS), "alpha"), ("", "beta"))
    ]
    assert said == wanted
