"""What the bound refuses, what it reports, and that it rises with every rounding added."""

from __future__ import annotations

from fractions import Fraction

import pytest
from graph_kernels import function_of, kernel_of, simple

from gainproof.derive.printer.bound import KernelBound, prove
from gainproof.derive.printer.formats import FLOAT32, FLOAT64, FORMATS, Format
from gainproof.derive.printer.graph import GraphBuilder
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.step_ranges import PrintingError


def only(kernel: Kernel, form: Format = FLOAT64) -> Fraction:
    return prove(kernel, form).outputs[0].bound


@pytest.mark.parametrize("form", FORMATS, ids=lambda form: form.name)
def test_known_bounds(form: Format) -> None:
    """One rounding is half an epsilon; exact operations cost nothing; shared errors cancel."""
    half, slack = Fraction(1, 2), Fraction(2, 100)
    assert only(simple(lambda _, x: -x), form) == 0
    assert only(simple(lambda _, x: 2 * x), form) == 0
    assert half <= only(simple(lambda b, x: b.sqrt(x)), form) <= half + slack
    assert half <= only(simple(lambda _, x: 1 - x, upper=1), form) <= half + slack
    # sqrt(x)/(1 + sqrt(x)): the root weighs 1/(1 + sqrt(x)), the sum and the quotient 1
    root = simple(lambda b, x: b.sqrt(x) / (1 + b.sqrt(x)))
    assert 3 * half - slack <= only(root, form) <= 3 * half + 2 * slack
    # the rounding of s enters s/s not at all, and s*s twice
    squared = simple(lambda b, x: b.sqrt(x) * b.sqrt(x))
    assert 3 * half - slack <= only(squared, form) <= 3 * half + slack
    quotient = simple(lambda b, x: b.sqrt(x) / b.sqrt(x))
    assert half <= only(quotient, form) <= half + slack


def planted(place: int) -> Fraction:
    """The bound of s/(p + h + s), with one term (or at 3 the result) times 3 and divided by 3."""
    b = GraphBuilder()
    x = b.symbol("x")
    p = b.sqrt(x)
    terms = [p, 4 / p, b.sqrt(x + 8)]
    if place < 3:
        terms[place] = terms[place] * 3 / 3
    result = terms[2] / (terms[0] + terms[1] + terms[2])
    return only(kernel_of(b.graph({"y": result * 3 / 3 if place == 3 else result}), upper=10**300))


def test_a_planted_rounding_raises_the_bound() -> None:
    """Two roundings more raise it where they weigh something at the worst input.

    That is near 0, where h rules the sum; p weighs nothing there, and may only not lower it.
    """
    plain = planted(4)
    assert planted(0) >= plain
    for place in (1, 2, 3):
        assert planted(place) > plain + Fraction(9, 10), place


@pytest.mark.parametrize(
    "write",
    [
        lambda b, x: b.sqrt(x + 1) - b.sqrt(x),
        lambda b, x: x - b.sqrt(x),
        lambda _, x: 1 - x * 3,
        lambda b, x: -b.sqrt(x) + x,
        lambda b, x: b.absolute(1 - x) - x * 3,
        lambda b, x: b.sqrt(x) * (1 - x) + x,
    ],
)
def test_a_subtraction_of_computed_values_is_refused(write: object) -> None:
    with pytest.raises(
        PrintingError, match=r"\(float64\): .*x.*: a subtraction of computed values"
    ):
        prove(simple(write), FLOAT64)  # type: ignore[arg-type]


def named(scale: bool) -> Kernel:
    """sqrt(1 + x) - sqrt(x) for x from 1 to 4, its error over itself or over the sum."""
    b = GraphBuilder()
    x = b.symbol("x")
    first, second = b.sqrt(1 + x), b.sqrt(x)
    gap = first - second
    graph = b.graph({"y": gap * 2, "_s": first + second}, {"gap": gap})
    scales = {"y": "_s"} if scale else {}
    reason = {"gap": "the difference is wanted to the digits of the sum only"}
    return kernel_of(graph, scales, reason, lower=1, upper=4, lower_open=False, upper_open=False)


def test_a_named_cancellation_carries_its_condition() -> None:
    """At x = 4 the operands 2.24 and 2 leave 0.24: errors grow by 4.24/0.24 = 18."""
    relative = prove(named(scale=False), FLOAT64).outputs[0]
    assert 17.9 < relative.amplification["gap"] < 19
    assert 8 < relative.bound < 30
    scaled = prove(named(scale=True), FLOAT64).outputs[0]
    assert 1.9 < scaled.amplification["gap"] < 2.2
    assert scaled.bound < 3


def over_both(factor: int, other: int) -> KernelBound:
    """factor (x sqrt(x) - sqrt(1 + x)) over other (x sqrt(x) + sqrt(1 + x)), x being anything."""
    b = GraphBuilder()
    x = b.symbol("x")
    first, second = x * b.sqrt(x), b.sqrt(1 + x)
    gap = first - second
    graph = b.graph({"y": gap * factor, "_s": (first + second) * other}, {"gap": gap})
    return prove(kernel_of(graph, {"y": "_s"}, {"gap": "it vanishes once"}), FLOAT64)


def test_a_difference_over_the_sum_of_its_terms_settles_in_few_boxes() -> None:
    """Two roundings of the larger term and one of the difference, over all floats; scaled, too."""
    for factor in (1, 2**20):
        found = over_both(factor, factor)
        (output,) = found.outputs
        assert Fraction(3, 2) <= output.bound <= Fraction(3, 2) + Fraction(3, 100)
        assert 1 <= output.amplification["gap"] < 1 + 1e-6
        assert found.boxes < 2000
    assert Fraction(3, 4) <= over_both(2, 4).outputs[0].bound < 3  # half the ratio


def test_what_cannot_use_a_named_cancellation() -> None:
    b = GraphBuilder()
    x = b.symbol("x")
    gap = b.sqrt(1 + x) - b.sqrt(x)
    kernel = kernel_of(b.graph({"y": 1 / gap}, {"gap": gap}), {}, {"gap": "a test"}, upper=4)
    with pytest.raises(PrintingError, match="div of a named cancellation"):
        prove(kernel, FLOAT64)


def test_avoidable_over_and_underflow_is_refused() -> None:
    """sqrt(x x) is x, but x x leaves the range; sqrt(16/x + x) needs its terms scaled."""
    with pytest.raises(PrintingError, match=r"x\*\*2 may be subnormal or 0"):
        prove(simple(lambda b, x: b.sqrt(x * x)), FLOAT64)
    with pytest.raises(PrintingError, match=r"x\*\*2 may overflow"):
        prove(simple(lambda b, x: b.sqrt(x * x), lower=1), FLOAT64)
    with pytest.raises(PrintingError, match=r"16/x may overflow"):
        prove(simple(lambda b, x: b.sqrt(16 / x + x)), FLOAT64)
    scaled = simple(lambda b, x: 2**30 * b.sqrt(Fraction(16, 4**30) / x + x / 4**30))
    assert only(scaled) < Fraction(110, 100)


def test_nan_is_refused() -> None:
    """x x/(x x) is 1, but 0/0 and infinity/infinity far out."""
    b = GraphBuilder()
    x = b.symbol("x")
    with pytest.raises(PrintingError, match="NaN"):
        prove(kernel_of(b.graph({"y": (x * x) / (x * x) * (x * x)})), FLOAT64)


def test_domains_end_at_the_last_normal_value() -> None:
    """x x is normal from 2^-511 on, and to the root of the largest number."""
    found = prove(simple(lambda _, x: x * x), FLOAT64).outputs[0]
    assert found.lowest == 2.0**-511
    below = FLOAT64.before(found.lowest)
    assert below * below < FLOAT64.least_normal
    assert found.highest**2 <= FLOAT64.largest
    assert FLOAT64.ordinal(2.0**512) - FLOAT64.ordinal(found.highest) < 100
    root = prove(simple(lambda b, x: b.sqrt(x)), FLOAT32).outputs[0]
    assert (root.lowest, root.highest) == (FLOAT32.least, FLOAT32.largest)


def test_select_compares_exact_things_only() -> None:
    with pytest.raises(PrintingError, match="select compares exact things only"):
        prove(simple(lambda b, x: b.select(b.sqrt(x), 1, x, 2 * x)), FLOAT64)
    assert only(simple(lambda b, x: b.select(x, "1/3", x, 2 * x))) == 0


def test_a_domain_may_begin_at_0() -> None:
    """At 0 the value 0 is no normal number: outside the range, but no error."""
    kernel = simple(lambda b, x: b.sqrt(x) * 3, lower_open=False)
    found = prove(kernel, FLOAT64)
    assert (found.lowest, found.outputs[0].lowest) == (0, FLOAT64.least)
    assert float(function_of(kernel)(0.0)[0]) == 0
    shifted = prove(simple(lambda b, x: b.sqrt(x) + 1, lower_open=False), FLOAT64)
    assert shifted.outputs[0].lowest == 0
    assert shifted.outputs[0].bound < Fraction(102, 100)


def test_an_untaken_branch_may_do_anything() -> None:
    kernel = simple(lambda b, x: b.select(x, 1, 1 / (2 + x), 1 / b.sqrt(x)))
    assert only(kernel) < Fraction(155, 100)


def test_an_unknown_scale_is_named() -> None:
    b = GraphBuilder()
    kernel = kernel_of(b.graph({"y": b.symbol("x")}), {"y": "missing"})
    with pytest.raises(PrintingError, match="no output 'missing'"):
        prove(kernel, FLOAT64)


def test_the_proof_is_the_same_every_time() -> None:
    kernel = simple(lambda b, x: b.sqrt(x) / (3 + x * b.sqrt(7 + x)), upper=10**9)
    found: list[KernelBound] = [prove(kernel, FLOAT64) for _ in range(2)]
    assert found[0] == found[1]


def test_a_scaling_rounds_where_its_result_may_be_subnormal() -> None:
    """x^3/4: next to the least normal number the quarter of a product that came out too small is
    rounded once more; away from there a quarter is exact. (The first x of float32 for which x^3/4
    is normal lies further from the end than two roundings reach.)
    """
    half, slack = Fraction(1, 2), Fraction(2, 100)
    assert only(simple(lambda _, x: x * x * x / 4, upper=1000)) >= 3 * half
    away = simple(lambda _, x: x * x * x / 4, lower=1, upper=1000)
    assert 2 * half <= only(away) <= 2 * half + slack
