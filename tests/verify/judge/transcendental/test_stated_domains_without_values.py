"""Stated domains that hold points without a value: conditional where the rest is true, with such a
point, and never proved; and what is said where no domain is stated.
"""

from __future__ import annotations

import mpmath
import pytest
from one_of_each import further
from small_claims import check, judged

from gainproof.verify.judge.replay import replay

ALL = r"-\pi < \theta \leq \pi"
QUARTER = r"0 \leq \theta \leq \pi/2"
DIFFERENCE = r"\frac{\cos\theta + \sin\theta}{\cos 2\theta} = \frac{1}{\cos\theta - \sin\theta}"
TRUE_ELSEWHERE = [
    ("identity", r"\tan\theta \cos\theta = \sin\theta", ALL, "1/2"),
    ("identity", r"\frac{1}{\cos\theta} = \sec\theta", ALL, "1/2"),
    ("identity", r"1 + \tan^2\theta = \frac{1}{\cos^2\theta}", ALL, "1/2"),
    ("inequality", r"\frac{1}{\cos^2\theta} \geq 1", ALL, "1/2"),
    ("identity", r"\cot\theta \sin\theta = \cos\theta", r"-\pi < \theta < \pi", "0"),
    ("identity", r"\frac{\sin\theta}{1 + \cos\theta} = \tan\frac{\theta}{2}", ALL, "1"),
    ("identity", r"\frac{1}{\cos\theta} = \sec\theta", r"0 \leq \theta < 2", "1/2"),
    ("identity", r"\frac{1}{\cos\theta} = \sec\theta", r"\theta > 2", "3/2"),
    ("identity", r"\tan 2\theta = \frac{2\tan\theta}{1 - \tan^2\theta}", QUARTER, "1/4"),
    ("identity", r"\tan 2\theta = \frac{2\tan\theta}{1 - \tan^2\theta}",
     r"0 < \theta < \pi/3", "1/4"),
    ("identity", DIFFERENCE, QUARTER, "1/4"),
]  # fmt: skip


@pytest.mark.parametrize(("kind", "latex", "domain", "turns"), TRUE_ELSEWHERE)
def test_an_angle_without_a_value_is_told(kind: str, latex: str, domain: str, turns: str) -> None:
    found = judged(kind, f"latex = '{latex}'\ndomain = '{domain}'")
    check(found, "conditional")
    assert found.witness is not None
    assert found.witness["point"] in ({r"\theta/pi": turns}, {r"\theta": turns})
    assert turns == "0" or r"\theta/pi" in found.witness["point"]
    assert found.witness["note"] == "a side has no value"
    assert found.domain is not None
    assert "where every part has a value" in found.domain
    assert found.certificate is not None
    assert replay(found.certificate, "conditional") is None


@pytest.mark.parametrize(("kind", "latex", "domain", "turns"), TRUE_ELSEWHERE)
def test_without_a_stated_domain_the_same_is_proved(
    kind: str, latex: str, domain: str, turns: str
) -> None:
    del domain, turns
    check(judged(kind, latex), "proved")


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\frac{1}{\cos\theta} = \sec\theta", r"0 \leq \theta < \pi/2"),
        (r"\frac{1}{\cos\theta} = \sec\theta", r"0 \leq \theta < 1"),
        (r"\tan 2\theta = \frac{2\tan\theta}{1 - \tan^2\theta}", r"0 < \theta < \pi/5"),
        (r"\frac{\sin\theta}{1 + \cos\theta} = \tan\frac{\theta}{2}", r"-\pi < \theta < \pi"),
    ],
)
def test_where_every_angle_has_a_value_it_is_proved(latex: str, domain: str) -> None:
    check(judged("identity", f"latex = '{latex}'\ndomain = '{domain}'"), "proved")


def test_of_no_stated_domain_an_angle_without_a_value_is_no_counterexample() -> None:
    found = judged("inequality", r"\frac{1}{\cos^2\theta} + e^{\theta} > \theta")
    assert found.verdict in ("held", "proved"), found.reason


@pytest.mark.parametrize(
    "latex",
    [
        r"\frac{1}{\cos\theta} = \sec\theta + 1",
        r"\tan\theta \cos\theta = \cos\theta",
        r"x \tan\theta = 2 x \frac{\sin\theta}{\cos\theta}",
    ],
)
def test_what_is_false_elsewhere_stays_refuted(latex: str) -> None:
    check(judged("identity", f"latex = '{latex}'\ndomain = '{ALL}'"), "refuted")


def test_other_symbols_do_not_matter_where_a_divisor_is_zero_whatever_they_are() -> None:
    latex = r"x \tan\theta = x \frac{\sin\theta}{\cos\theta}"
    check(judged("identity", f"latex = '{latex}'\ndomain = '{ALL}'"), "conditional")
    more = f"{ALL}, x > 0"
    check(judged("identity", f"latex = '{latex}'\ndomain = '{more}'"), "conditional")


@pytest.mark.parametrize(
    ("kind", "latex", "domain", "point"),
    [
        ("identity", r"e^{\ln x} = x", r"x \geq 0", "0"),
        ("identity", r"\ln x^2 = 2 \ln x", r"x \geq 0", "0"),
        ("inequality", r"\ln x \leq x - 1", "x > -1", "-1/2"),
        ("identity", r"\frac{1}{\ln x} = \frac{2}{\ln x^2}", "x > 0", "1"),
        ("identity", r"\frac{x}{e^x - 1} = \frac{x e^{-x}}{1 - e^{-x}}", r"x \geq 0", "0"),
        ("identity", r"\frac{\sinh x}{\tanh x} = \cosh x", r"x \geq 0", "0"),
        ("identity", r"e^{\sqrt{x}} e^{\sqrt{x}} = e^{2\sqrt{x}}", r"x \geq -1", "-1"),
    ],
)
def test_true_wherever_it_has_a_value(kind: str, latex: str, domain: str, point: str) -> None:
    found = judged(kind, f"latex = '{latex}'\ndomain = '{domain}'")
    check(found, "conditional")
    assert found.witness is not None
    assert found.witness["point"] == {"x": point}


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\ln x \leq x - 2", "x > -1"),
        (r"\ln x^2 \geq 3 \ln x", r"x \geq 0"),
    ],
)
def test_false_where_it_has_a_value(latex: str, domain: str) -> None:
    check(judged("inequality", f"latex = '{latex}'\ndomain = '{domain}'"), "refuted")


@pytest.mark.parametrize(
    ("kind", "latex", "domain"),
    [
        ("identity", r"\ln(x y) = \ln x + \ln y", "x > 0, y > 0, where every part has a value"),
        ("identity", r"\ln x^2 = 2 \ln x", "x > 0, where every part has a value"),
        ("identity", r"e^{\ln x} = x", "x > 0"),
        ("identity", r"\ln(x - 3) + \ln(4 - x) = \ln((x-3)(4-x))",
         "3 < x < 4, where every part has a value"),
        ("identity", r"\ln(x^2 - 1) = \ln(x - 1) + \ln(x + 1)",
         "x > 1, where every part has a value"),
        ("identity", r"\frac{d}{dx} \ln x = \frac{1}{x}", "x > 0"),
        ("identity", r"\frac{d}{dx} \ln(1 - 2 x) = -\frac{2}{1 - 2 x}", "x < 1/2"),
        ("inequality", r"\ln x \leq x - 1", "x > 0"),
        ("inequality", r"\ln(1 + x) \leq x", "x > -1"),
        ("identity", r"x^y = e^{y \ln x}", "x > 0"),
    ],
)  # fmt: skip
def test_of_no_stated_domain_logarithms_say_where(kind: str, latex: str, domain: str) -> None:
    found = judged(kind, latex)
    check(found, "proved")
    assert found.domain == domain


@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("identity", r"\ln(x y) = \ln x - \ln y"),
        ("inequality", r"\ln(x + y) > \ln x"),
        ("identity", r"\frac{d}{dx} \ln(1 - x) = \frac{1}{1 - x}"),
        ("identity", r"\ln x^3 = 2 \ln x"),
    ],
)
def test_what_is_false_of_logarithms_is_refuted(kind: str, latex: str) -> None:
    check(judged(kind, latex), "refuted")


@pytest.mark.parametrize("latex", [r"\ln(x + y) = \ln(y + x)", r"\ln(x y) = \ln(y x)"])
def test_a_stated_symbol_has_a_value_at_every_point(latex: str) -> None:
    """With y = -1 there is none for x = 1/2."""
    assert judged("identity", f"latex = '{latex}'\ndomain = 'x > 0'").verdict != "proved"


@pytest.mark.parametrize(
    "latex",
    [
        r"\ln x + \ln(-x) = 5",
        r"\ln x + \ln(-x) = \ln x + \ln(-x)",
        r"\ln(x - 3) + \ln(2 - x) = \ln((x-3)(2-x))",
        r"\ln(-x^2) = 2 \ln x",
        r"\ln(-x^2 - y^2) = 0",
        r"\ln(x y) + \ln(-x y) = 1",
    ],
)
def test_what_has_a_value_nowhere_is_not_proved(latex: str) -> None:
    assert judged("identity", latex).verdict in ("undecided", "held", "refuted")


def test_a_strict_one_fails_where_both_sides_are_equal() -> None:
    for claim in ("text = 'below'", "domain = 'x > -1'"):
        found = judged("inequality", "latex = '\\ln x < x - 1'\n" + claim)
        check(found, "conditional")
        assert found.domain == "for 0 < x < 1 or x > 1"


@pytest.mark.parametrize(
    ("latex", "domain", "point"),
    [
        (r"\frac{1}{\theta} = \frac{\theta}{\theta^2}", ALL, {r"\theta": "0"}),
        (
            r"\frac{\sin\theta}{\theta - \pi} = \frac{\sin\theta}{\theta - \pi}",
            ALL,
            {r"\theta/pi": "1"},
        ),
        (r"\frac{e^x - 1}{e^x - 1} = 1", r"x \geq -1", {"x": "0"}),
    ],
)
def test_other_points_of_a_domain(latex: str, domain: str, point: dict[str, str]) -> None:
    found = judged("identity", f"latex = '{latex}'\ndomain = '{domain}'")
    check(found, "conditional")
    assert found.witness is not None
    assert {k.replace("/pi", ""): v for k, v in found.witness["point"].items()} == {
        k.replace("/pi", ""): v for k, v in point.items()
    }


@pytest.mark.parametrize(
    "latex",
    [
        r"\ln(x y) = \ln(y x)",
        r"\frac{d}{dx} \ln(x^2) = \frac{2}{x}",
        r"\ln(x^2 - y^2) = \ln(x - y) + \ln(x + y)",
    ],
)
def test_a_condition_that_is_no_bound(latex: str) -> None:
    found = judged("identity", latex)
    check(found, "proved")
    assert found.domain == "where every part has a value"


def test_an_induction_says_where_too() -> None:
    latex = r"\sum_{k=0}^{n} e^{k x} = \frac{e^{(n+1) x} - 1}{e^x - 1}"
    found = judged("identity", f"latex = '{latex}'\ndomain = 'n \\geq 0'")
    check(found, "proved")
    assert found.domain == "n >= 0, n an integer, where every part has a value"


def test_what_is_compared_with_0_alone_is_no_angle() -> None:
    latex = r"x > 0 \Rightarrow \frac{x}{\cos\theta} = x \sec\theta"
    found = judged("implication", f"latex = '{latex}'\ndomain = '{ALL}'")
    check(found, "conditional")
    assert found.witness is not None
    assert "x" in found.witness["point"]


def test_the_points_are_right() -> None:
    """By another library: these angles have no value, as near as it can tell."""
    for _, latex, _, turns in TRUE_ELSEWHERE:
        up, down = map(int, [*turns.split("/"), "1"][:2])
        with mpmath.workdps(40):
            angle = mpmath.pi * up / down
            divisors = {
                r"\cos\theta}": mpmath.cos(angle),
                r"\tan\theta": mpmath.cos(angle),
                r"\cot": mpmath.sin(angle),
                r"1 + \cos": 1 + mpmath.cos(angle),
                r"2\theta": mpmath.cos(2 * angle),
                r"\cos^2": mpmath.cos(angle),
            }
            assert any(part in latex and abs(d) < 1e-30 for part, d in divisors.items()), latex


@pytest.mark.parametrize(
    ("latex", "domain", "wanted"),
    [
        (r"\tan\theta \geq \theta", QUARTER, r"for 0 <= \theta/pi < 1/2"),
        (r"\tan\theta \leq \theta", r"-\pi/2 \leq \theta \leq 0", r"for -1/2 < \theta/pi <= 0"),
        further(
            r"\tan^2\theta \geq \theta^2",
            r"-\pi/2 \leq \theta \leq \pi/2",
            r"for -1/2 < \theta/pi < 1/2",
        ),
        (r"\ln x \leq x - 1", r"0 \leq x \leq 3", "for 0 < x <= 3"),
    ],
)
def test_an_end_without_a_value_is_taken_out(latex: str, domain: str, wanted: str) -> None:
    found = judged("inequality", f"latex = '{latex}'\ndomain = '{domain}'")
    check(found, "conditional")
    assert found.domain == wanted
    assert found.witness is not None
    assert found.witness["note"] == "a side has no value"
    assert found.certificate is not None
    assert replay(found.certificate, "conditional") is None


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\tan\theta \geq 2 \theta", QUARTER),
        (r"\tan\theta \geq \theta", r"-\pi/2 \leq \theta \leq \pi/2"),
        (r"\tan\theta \geq \theta", r"0 \leq \theta \leq \pi"),
    ],
)
def test_what_is_false_within_stays_refuted(latex: str, domain: str) -> None:
    check(judged("inequality", f"latex = '{latex}'\ndomain = '{domain}'"), "refuted")


NUMBER = "{ unit = '1', domain = '%s', meaning = 'a number' }"
ENDS = {"x": NUMBER % r"x \geq 0", "y": NUMBER % "-1 < y < 1", "p": NUMBER % "p > 0"}


@pytest.mark.parametrize(
    ("latex", "wanted"),
    [
        (r"\sin(x)\frac{p}{x} = \frac{p \sin x}{x}", "for p > 0, x > 0"),
        (r"\ln x + \ln p = \ln(x p)", "for p > 0, x > 0"),
        (r"\ln(x) \sin a = \sin(a) \ln x", "for x > 0"),
        (r"\frac{\sin y}{y} + \sqrt{x} = \frac{\sin(y) + y\sqrt{x}}{y}",
         "for x >= 0, -1 < y < 1, y != 0"),
        # with y = 1/2 there is a value at x = 0, so that this is not taken out
        (r"\frac{\sin p}{x + y^2} + 0 = \frac{1}{x + y^2} \sin p",
         "for p > 0, x >= 0, -1 < y < 1, where every part has a value"),
    ],
)  # fmt: skip
def test_values_of_one_symbol_without_a_value_are_named(latex: str, wanted: str) -> None:
    """By hand: log 0 and 0/0 have no value whatever the other symbols are."""
    found = judged("identity", latex, ENDS)
    check(found, "conditional")
    assert found.domain == wanted
    assert replay(found.certificate, "conditional") is None
