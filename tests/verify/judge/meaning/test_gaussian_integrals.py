"""Integrals of exponentials of squares, against mpmath's quadrature."""

from __future__ import annotations

import random

import mpmath
import pytest
from samples import samples
from small_claims import check, judged


def identity(latex: str, domain: str | None) -> str:
    return f"latex = '{latex}'" + (f"\ndomain = '{domain}'" if domain else "")


NORMAL = r"\frac{1}{\sqrt{2 \pi} s} e^{-\frac{(x - m)^2}{2 s^2}}"
TRUE = [
    (r"\int_0^\infty e^{-x^2} dx = \frac{\sqrt{\pi}}{2}", None),
    (rf"\int_{{-\infty}}^\infty {NORMAL} dx = 1", "s > 0"),
    (rf"\int_{{-\infty}}^\infty x {NORMAL} dx = m", "s > 0"),
    (rf"\int_{{-\infty}}^\infty (x - m)^4 {NORMAL} dx = 3 s^4", "s > 0"),
    (r"\int_t^\infty \frac{x}{s^2} e^{-\frac{x^2}{2 s^2}} dx = e^{-\frac{t^2}{2 s^2}}", "s > 0"),
    (r"\int_0^\infty \frac{x^2}{s^2} e^{-\frac{x^2}{2 s^2}} dx = s \sqrt{\frac{\pi}{2}}", "s > 0"),
    (
        r"\int_{-\infty}^\infty e^{-a x^2 + b x} dx = \sqrt{\frac{\pi}{a}} e^{\frac{b^2}{4 a}}",
        "a > 0",
    ),
    (r"\int_0^t \frac{2}{\sqrt{\pi}} e^{-x^2} dx = \operatorname{erf}(t)", None),
    (r"\int_{-t}^t e^{-x^2} dx = \sqrt{\pi} \operatorname{erf}(t)", "t > 0"),
    (
        r"\int_t^\infty \frac{1}{\sqrt{\pi}} e^{-x^2} dx = \frac{1 + \operatorname{erf}(-t)}{2}",
        None,
    ),
    (r"\int_0^\infty (x e^{-x^2} + e^{-x}) dx = \frac{3}{2}", None),
    (r"\int_{-\infty}^t x e^{a x} dx = \frac{t e^{a t}}{a} - \frac{e^{a t}}{a^2}", "a > 0"),
    (r"\int_2^1 x e^{-x^2} dx = \frac{e^{-4} - e^{-1}}{2}", None),
]


@pytest.mark.alike
@pytest.mark.parametrize(("latex", "domain"), TRUE)
def test_what_is_true_is_proved(latex: str, domain: str | None) -> None:
    check(judged("identity", identity(latex, domain)), "proved")


@pytest.mark.alike
@pytest.mark.parametrize(("latex", "domain"), TRUE)
def test_twice_as_much_is_refuted(latex: str, domain: str | None) -> None:
    check(judged("identity", identity(latex.replace(" dx =", r" dx = 2 \cdot"), domain)), "refuted")


@pytest.mark.parametrize(
    ("latex", "domain"),
    [
        (r"\int_{-\infty}^\infty x^3 e^{x^2} dx = 0", None),
        (r"\int_{-\infty}^\infty e^{-a x^2} dx = \sqrt{\frac{\pi}{a}}", "a < 0"),
        (r"\int_{-\infty}^\infty e^{-x} dx = 0", None),
        (r"\int_{-\infty}^t e^{a x} dx = \frac{e^{a t}}{a}", "a < 0"),
        (r"\int_0^{-\infty} x e^{-x^2} dx = \frac{1}{2}", None),
        (r"\int_0^1 x e^{b x^2} dx = \frac{e^b - 1}{2 b}", "-1 < b < 1"),
        (r"\int_0^\infty \frac{b}{b} x e^{-x^2} dx = \frac{1}{2}", "-1 < b < 1"),
        (r"\int_0^\infty x e^{-\frac{b}{b} x^2} dx = \frac{1}{2}", "-1 < b < 1"),
        (r"\int_{-\infty}^\infty e^{-x^2 + (\frac{b}{b} - 1) x} dx = \sqrt{\pi}", "-1 < b < 1"),
        (r"\int_0^{\frac{b}{b}} x e^{-x^2} dx = \frac{1 - e^{-1}}{2}", "-1 < b < 1"),
    ],
)
def test_what_does_not_exist_is_not_proved(latex: str, domain: str | None) -> None:
    assert judged("identity", identity(latex, domain)).verdict != "proved"


@pytest.mark.parametrize(
    ("latex", "domain", "verdict"),
    [
        (r"\operatorname{erf}(t) < 1", None, "proved"),
        (r"\operatorname{erf}(t) > 0", "t > 0", "proved"),
        (r"\operatorname{erf}(t) < 0", "t < 0", "proved"),
        (r"\operatorname{erf}(t) > 0", None, "refuted"),
        (r"\operatorname{erf}(t) < t", "t > 0", "refuted"),
    ],
)
def test_the_error_function_lies_between_ends(latex: str, domain: str | None, verdict: str) -> None:
    check(judged("inequality", identity(latex, domain)), verdict)


@pytest.mark.sampled
@pytest.mark.parametrize("seed", range(samples(6)))
def test_the_value_is_that_of_quadrature(seed: int) -> None:
    generator = random.Random(seed)
    powers = [generator.randint(-3, 3) for _ in range(generator.randint(1, 5))]
    a, b = generator.randint(1, 4), generator.randint(-3, 3)
    low = generator.choice([r"-\infty", "-1", "0", "1"])
    high = generator.choice([r"\infty", "0", "2"])
    terms = " + ".join(f"({c}) x^{n}" if n else f"({c})" for n, c in enumerate(powers))
    latex = rf"\int_{{{low}}}^{{{high}}} ({terms}) e^{{-{a} x^2 {b:+} x}} dx"

    def integrand(x: mpmath.mpf) -> mpmath.mpf:
        return sum(c * x**n for n, c in enumerate(powers)) * mpmath.exp(-a * x * x + b * x)

    with mpmath.workdps(30):
        known = {r"-\infty": -9, r"\infty": 9}
        ends = [mpmath.mpf(known.get(end, end)) for end in (low, high)]
        middle = [x for x in map(mpmath.mpf, range(-8, 9)) if min(ends) < x < max(ends)]
        points = [ends[0], *(middle if ends[0] < ends[1] else reversed(middle)), ends[1]]
        value = mpmath.quad(integrand, points)
        above, below = (
            mpmath.nstr(value + d, 20, min_fixed=-99, max_fixed=99) for d in (1e-9, -1e-9)
        )
    above, below = (text.replace("-", r"-") for text in (above, below))
    check(judged("inequality", identity(f"{below} < {latex} < {above}", None)), "proved")
    check(judged("inequality", identity(f"{latex} < {below}", None)), "refuted")
