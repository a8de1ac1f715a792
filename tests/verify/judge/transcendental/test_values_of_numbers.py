"""Functions of numbers lie between two rationals close together, also where powers share a root."""

from __future__ import annotations

import mpmath
import pytest
from one_of_each import further
from small_claims import check, judged

from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.transcendental.monomials import UNIT
from gainproof.verify.judge.transcendental.variable_ranges import EULER, Ranges


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\lg x < \ln x", "x > 1"),
        (r"\lg x > \ln x", "0 < x < 1"),
        further(r"\log_2 x < x", "x > 0"),
        further(r"\log_2 x \leq x - 1", r"x \geq 2"),
        further(r"10 \log_{10}(1 + x) \leq 4.343 x", r"x \geq 0"),
        (r"2^x \geq x + 1", r"x \geq 1"),
        (r"e^{1/2} x > 1.6487 x", "x > 0"),
        (r"e^{1/2} x + e^{1/3} x^2 > 1.6487 x + 1.3956 x^2", "x > 0"),
    ],
)
def test_true(latex: str, domain: str) -> None:
    check(judged("inequality", f"latex = '{latex}'\ndomain = '{domain}'"), "proved")


@pytest.mark.alike
@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\lg x < \ln x", "x > 0"),
        (r"10 \log_{10}(1 + x) \leq 4.342 x", r"x \geq 0"),
        (r"2^x \geq x + 1", r"x \geq 0"),
        (r"e^1 x > 3 x", "x > 0"),
        (r"e^{1/2} x > 1.6488 x", "x > 0"),
        (r"e^{1/2} x + e^{1/3} x^2 > 1.6487 x + 1.3957 x^2", "x > 0"),
    ],
)
def test_false(latex: str, domain: str) -> None:
    check(judged("inequality", f"latex = '{latex}'\ndomain = '{domain}'"), "refuted")


@pytest.mark.parametrize("divisor", [1, 2, 6])
def test_the_variable_is_the_root_of_what_the_power_is(divisor: int) -> None:
    box = Ranges({}, lambda _: False).power(EULER, UNIT, divisor, positive=True)
    assert box.lower is not None
    assert box.upper is not None
    with mpmath.workdps(40):
        value = mpmath.exp(mpmath.mpf(1) / divisor)
        low, high = (mpmath.mpf(e.numerator) / e.denominator for e in (box.lower, box.upper))
        assert low < value < high < low + mpmath.mpf(10) ** -17


@pytest.mark.parametrize(("name", "at"), [("log", 10), ("atan", 3), ("erf", 1)])
def test_other_functions(name: str, at: int) -> None:
    box = Ranges({}, lambda _: False).value(Expr("call", name, (number(at),)))
    assert box.lower is not None
    assert box.upper is not None
    with mpmath.workdps(40):
        value = getattr(mpmath, name)(at)
        low, high = (mpmath.mpf(e.numerator) / e.denominator for e in (box.lower, box.upper))
        assert low < value < high < low + mpmath.mpf(10) ** -17
