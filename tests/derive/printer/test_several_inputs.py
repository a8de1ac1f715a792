"""Bounds of kernels with two inputs: against brute force, and what is refused."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from graph_kernels import function_of, several_of, two_inputs
from hypothesis import given, settings
from hypothesis import strategies as st
from pair_points import outside_bounds
from positive_graphs import positive_graphs
from samples import samples

from gainproof.derive.printer import box_search, interval
from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, FORMATS, Format
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.interval import Interval
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.step_ranges import PrintingError


def only(kernel: Kernel, form: Format = FLOAT64) -> Fraction:
    return prove(kernel, form).outputs[0].bound


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_known_bounds(form: Format) -> None:
    half, slack = Fraction(1, 2), Fraction(4, 100)
    assert only(two_inputs(lambda _, _x, z: 2 * z), form) == 0
    assert half <= only(two_inputs(lambda _, x, z: x * z), form) <= half + slack
    # two products into a sum: the largest share takes all, and the sum one more
    pair = two_inputs(lambda _, x, z: x * x + z * z * z)
    assert 3 * half - slack <= only(pair, form) <= 3 * half + slack
    # the root weighs p/(p + q) where p is the larger, and not at all where q is
    share = two_inputs(lambda b, x, z: (b.sqrt(x) + z) / (1 + z))
    assert 4 * half - slack <= only(share, form) <= 4 * half + 2 * slack
    # shared errors cancel: r/(r z) has two roundings of its own
    shared = two_inputs(lambda b, x, z: b.sqrt(x + z) / (b.sqrt(x + z) * z))
    assert 2 * half - slack <= only(shared, form) <= 2 * half + slack


@given(positive_graphs(), st.integers(0, 2**32))
@settings(max_examples=samples(5), deadline=None)
def test_random_positive_graphs(kernel: Kernel, seed: int) -> None:
    with suppress(PrintingError):  # refused: an over- or underflow, mostly of float32
        assert not outside_bounds(kernel, 40, seed)


def differences() -> list[Kernel]:
    """Exact differences of each input, irrational constants, branches, named cancellations."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    gap = 4 / b.sqrt("2/3") - x
    size = b.absolute(gap)
    first = {"y": gap * z / (1 + z), "_s": (size + 1) * z / (1 + z), "w": size + z}
    second = {"y": b.select(x, "1/3", z + x, b.select(z, 5, 3 * x, 1 / z)) / (3 + x)}
    named = b.sqrt(x) * z - x
    third = {"y": named / (1 + z), "_s": (b.sqrt(x) * z + x) / (1 + z)}
    return [
        several_of(b.graph(first), "1/16", "64", {"y": "_s"}),
        several_of(b.graph(second), "1/16", "64"),
        several_of(b.graph(third, {"gap": named}), "1/16", "64", {"y": "_s"}, {"gap": "a test"}),
    ]


@pytest.mark.parametrize("which", range(3))
def test_exact_differences_branches_and_named_cancellations(which: int) -> None:
    assert not outside_bounds(differences()[which], 300, which)


def test_a_named_cancellation_carries_its_condition() -> None:
    """sqrt(x) z - x over itself, x from 4 to 8 and z from 4 to 8: most at x = 8, z = 4."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    gap = b.sqrt(x) * z - x
    kernel = several_of(b.graph({"y": gap * 2}, {"gap": gap}), 4, 8, None, {"gap": "a test"})
    (found,) = prove(kernel, FLOAT64).outputs
    exact = (8**0.5 * 4 + 8) / (8**0.5 * 4 - 8)
    assert exact * 0.999 < found.amplification["gap"] < exact * 1.2


def planted(place: int) -> Fraction:
    """The bound of x/(p + h + s), with one term (or at 3 the result) times 3 and divided by 3."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    terms = [b.sqrt(x) * z, 4 / z, b.sqrt(x + 8)]
    if place < 3:
        terms[place] = terms[place] * 3 / 3
    result = x / (terms[0] + terms[1] + terms[2])
    return only(several_of(b.graph({"y": result * 3 / 3 if place == 3 else result}), "1e-3", "1e3"))


def test_a_planted_rounding_raises_the_bound() -> None:
    plain = planted(4)
    assert planted(0) >= plain  # p weighs most where the others weigh nothing: it rules the bound
    assert planted(3) > plain + Fraction(9, 10)
    assert max(planted(0), planted(1), planted(2)) > plain + Fraction(9, 10)


@pytest.mark.parametrize(
    "write",
    [
        lambda b, x, z: b.sqrt(x + z) - b.sqrt(x),
        lambda _, x, z: x - z,
        lambda _, x, z: x * z - 1,
        lambda b, x, z: b.sqrt(x) * (1 - z) + x,
    ],
)
def test_a_subtraction_of_computed_values_is_refused(write: object) -> None:
    with pytest.raises(
        PrintingError, match=r"\(float64\): .*z.*: a subtraction of computed values"
    ):
        prove(two_inputs(write), FLOAT64)  # type: ignore[arg-type]


def test_what_leaves_the_range_in_one_corner_is_refused() -> None:
    """x x z/(x z) is x, but x x z is too large or small where both inputs are."""
    with pytest.raises(PrintingError, match=r"input \(1000000.0, 1000000.0\).*z may overflow"):
        prove(
            two_inputs(lambda _, x, z: (x * x) * (x * x) * (z * z) * z / (x * z), lower=1), FLOAT32
        )
    with pytest.raises(PrintingError, match=r"y, input \(9.*e-07, 9.*e-07\): its true value"):
        prove(two_inputs(lambda _, x, z: (x * x) * (x * x) * (z * z) * z, upper=1), FLOAT32)
    inner = two_inputs(lambda _, x, z: x * z / 10**30 * 10**30)
    assert only(inner) < 3
    with pytest.raises(PrintingError, match=r"y, input \(9.*not below .* epsilon: .*subnormal"):
        prove(inner, FLOAT32)


def test_a_value_just_below_the_normal_numbers_is_refused() -> None:
    """It would be held well enough: the promise is a normal number, and relative digits."""
    kernel = two_inputs(lambda _, x, z: x * z, lower="1e-19", upper="1e18")
    with pytest.raises(PrintingError, match=r"between 1e-38 and 1e-38, may be no normal number"):
        prove(kernel, FLOAT32)
    assert only(two_inputs(lambda _, x, z: x * z, lower="1.1e-19", upper="1e18"), FLOAT32) < 1


def test_a_bound_may_fail_inside_only() -> None:
    """4 - x vanishes at x = 4, far from any corner: its square has no normal value there."""
    with pytest.raises(PrintingError, match=r"output y, input \(4.0, .*no normal number"):
        prove(two_inputs(lambda _, x, z: (4 - x) * (4 - x) * z), FLOAT64)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"lower_open": True}, "a domain with both ends is wanted"),
        ({"upper": None}, "a domain with both ends is wanted"),
        ({"lower": "0"}, "positive normal numbers"),
        ({"lower": "-1"}, "positive normal numbers"),
        ({"lower": "8", "upper": "8"}, "positive normal numbers"),
        ({"name": "w"}, "the graph has inputs"),
    ],
)
def test_domains_that_cannot_be(change: dict[str, object], message: str) -> None:
    kernel = two_inputs(lambda _, x, z: x * z)
    x, z = kernel.inputs
    with pytest.raises(PrintingError, match=message):
        prove(replace(kernel, inputs=(x, replace(z, **change))), FLOAT64)  # type: ignore[arg-type]


def test_each_format_has_its_domain() -> None:
    """Ends that no format holds mean the numbers nearest to them."""
    kernel = two_inputs(lambda _, x, z: x * z, lower="1e-30", upper="1e30", single=("1e-7", "1e7"))
    assert prove(kernel, FLOAT64).inputs == ((1e-30, 1e30),) * 2
    ends = float(np.float32(1e-7)), 1e7
    assert prove(kernel, FLOAT32).inputs == (ends, ends)
    assert prove(kernel, FLOAT32).outputs[0].domain == (ends, ends)
    assert function_of(kernel)(1e-30, 1e30)[0] == 1
    with pytest.raises(ValueError, match=r"z must be .* at most 1e30, in float32 .* got 2e\+30"):
        function_of(kernel)(1.0, 2e30)


def test_less_work_gives_a_larger_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    """The first boxes alone give a bound, and every bisection one that is not larger."""
    kernel = two_inputs(lambda b, x, z: (b.sqrt(x + z) + x) / (b.sqrt(x + z) * z + x * 3))
    found = []
    for work in (0, 1_000, 240_000):
        monkeypatch.setattr(box_search, "WORK", work)
        found.append(only(kernel))
    assert found[0] > found[1] >= found[2]
    assert found[0] < 2 * found[2]


def test_an_exact_output_leaves_the_bisection_of_others_alone() -> None:
    """Its bounds are 0, and 0/0 must not hide what is to be bisected."""
    b = GraphBuilder()
    x, z = b.symbol("x"), b.symbol("z")
    s = b.sqrt(x + z)
    y = x * s / (x * s + z * z) + s / (s + x * z)
    alone, both = (
        prove(several_of(b.graph(outputs), "1e-6", "1e6"), FLOAT64)
        for outputs in ({"y": y}, {"exact": 2 * z, "y": y})
    )
    assert both.outputs[0].bound == 0
    assert both.outputs[1].bound == alone.outputs[0].bound
    assert both.boxes == alone.boxes > 100


def test_the_proof_is_the_same_every_time() -> None:
    kernel = two_inputs(lambda b, x, z: b.sqrt(x * z) / (3 + x * b.sqrt(7 + z)))
    assert prove(kernel, FLOAT64) == prove(kernel, FLOAT64)


def sharp() -> Kernel:
    """A bound that errors come close to; shares of both inputs matter."""
    return two_inputs(lambda _, x, z: x * x + z, lower=1, upper=1024)


def test_the_comparison_can_fail(monkeypatch: pytest.MonkeyPatch) -> None:
    """A prover that errs in one place is found out by measuring."""
    kernel = sharp()
    assert not outside_bounds(kernel, 500, 1)
    share = interval.share
    monkeypatch.setattr(interval, "share", lambda x: tuple(end / 8 for end in share(x)))
    assert outside_bounds(kernel, 500, 1)
    monkeypatch.setattr(interval, "share", share)
    monkeypatch.setattr("gainproof.derive.printer.ratio.extremes", first_corner)
    assert outside_bounds(ratio_at_stake(), 500, 1)


def ratio_at_stake() -> Kernel:
    """x z weighs all at the far corner of every box and hardly anything at the near one."""
    return two_inputs(lambda _, x, z: 1 + x * 3 * "1/3" * z * 3 * "1/3", lower="1/256", upper=256)


def first_corner(size: Interval, _slope: Interval, _width: object = None) -> Interval:
    """What a mistaken order of corners would take for the range."""
    return size[0][1], size[1][1]
