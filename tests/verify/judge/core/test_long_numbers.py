"""Numbers of millions of digits, which short formulas have: told by a few digits, not written out.

The values are mpmath's, whose exponents have no bound.
"""

from __future__ import annotations

from fractions import Fraction

import flint
import mpmath
import pytest
from small_claims import check, judged

from gainproof.verify.judge.exact.ball_text import enclosure, is_long, separated
from gainproof.verify.judge.exact.statement import Enclosure
from gainproof.verify.judge.exact.work_limits import Undecided

EXPONENTS = (138_000, 139_000, -139_000, 10**7, -(10**7) - 1, 10**12 + 7, -(10**15))


def exponential(exponent: int) -> flint.arb:
    with flint.ctx.workprec(128):
        return flint.arb(exponent).exp()


def encloses(text: Enclosure, exponent: int, sign: int) -> bool:
    with mpmath.workdps(60):
        gap = abs(mpmath.mpf(text.midpoint) - sign * mpmath.exp(exponent))
        return bool(gap <= mpmath.mpf(text.radius) * (1 + mpmath.mpf(10) ** -30))


@pytest.mark.parametrize("exponent", EXPONENTS)
@pytest.mark.parametrize("sign", [1, -1])
def test_the_text_encloses_the_number(exponent: int, sign: int) -> None:
    found = enclosure(sign * exponential(exponent), 12)
    assert encloses(found, exponent, sign)
    assert not encloses(found, exponent + 1, sign)
    assert is_long(found) is (abs(exponent) > 10**6), "digit by digit below 200,000 bits"


@pytest.mark.parametrize("exponent", EXPONENTS)
def test_what_is_apart_is_told_apart(exponent: int) -> None:
    one, more, other = map(exponential, (exponent, exponent + 1, -exponent))
    for a, b in [(one, more), (more, one), (one, -one), (one, other), (-one, flint.arb(5))]:
        shown = separated(a, b)
        assert shown is not None
        left, right = shown
        with mpmath.workdps(60):
            gap = abs(mpmath.mpf(left.midpoint) - mpmath.mpf(right.midpoint))
            assert gap > mpmath.mpf(left.radius) + mpmath.mpf(right.radius)
    assert separated(one, one) is None


def test_what_is_nearly_0_and_what_has_no_end() -> None:
    found = enclosure(exponential(-(10**30)), 12)
    assert (found.midpoint, found.radius) == ("0", f"1e-{10**17}")
    with pytest.raises(Undecided, match="digits"):
        enclosure(exponential(10**30), 12)
    assert separated(exponential(10**30), flint.arb(1)) is None
    assert enclosure(flint.arb(0), 12) == Enclosure("0", "0")
    assert Fraction(enclosure(flint.arb(1) / 3, 12).midpoint) != 0


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"e^{e^{x/60}} < 10^{60}", "x > 0"),
        (r"e^{e^{x/40}} < 10^{60}", "x > 0"),
        (r"e^{-e^{x/20}} > 10^{-60}", "x > 0"),
        (r"x^{x^x} < 10^{60}", "x > 0"),
    ],
)
def test_a_claim_that_fails_far_out_is_refuted(latex: str, domain: str) -> None:
    check(judged("inequality", f"latex = '{latex}'\ndomain = '{domain}'"), "refuted")


def test_roots_and_repairs_above_the_range_of_doubles() -> None:
    found = judged("identity", r"latex = 'x^3 = (10^{60})^{20} + x'")
    check(found, "refuted")
    assert "near 1.00000e+400" in found.reason
