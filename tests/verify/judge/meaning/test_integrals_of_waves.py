"""Integrals of polynomials times exponentials, sines and cosines, against mpmath's quadrature."""

from __future__ import annotations

import random

import mpmath
import pytest
from samples import samples
from small_claims import check, judged

DOMAIN = r"domain = 'a > 0, w > 0, t > 0'"
RIGHT = [
    (r"\int_0^t \sin(w x) dx", r"\frac{%d - %d \cos(w t)}{w}", (1, 1)),
    (
        r"\int_0^t x \cos(w x) dx",
        r"\frac{%d t \sin(w t)}{w} - \frac{%d - %d \cos(w t)}{w^2}",
        (1,) * 3,
    ),
    (r"\int_0^t \sin^2(w x) dx", r"\frac{%d t}{2} - \frac{\sin(%d w t)}{%d w}", (1, 2, 4)),
    (r"\int_0^t \sin(w x) \cos(w x) dx", r"\frac{%d \sin^2(%d w t)}{%d w}", (1, 1, 2)),
    (
        r"\int_0^t x^2 \sin(w x) dx",
        r"\frac{(%d - %d w^2 t^2) \cos(w t) + %d w t \sin(w t) - %d}{w^3}",
        (2, 1, 2, 2),
    ),
    (
        r"\int_0^t e^{-a x} \cos(w x) dx",
        r"\frac{%d a - e^{-a t} (%d a \cos(w t) - %d w \sin(w t))}{a^2 + %d w^2}",
        (1, 1, 1, 1),
    ),
    (r"\int_0^\infty x e^{-a x} \sin(w x) dx", r"\frac{%d a w}{(a^2 + %d w^2)^%d}", (2, 1, 2)),
    (
        r"\int_0^\infty e^{-a x} \cos^2(w x) dx",
        r"\frac{%d a^2 + %d w^2}{a^3 + %d a w^2}",
        (1, 2, 4),
    ),
    (
        r"\int_t^{2 t} \cos(w x - \theta) dx",
        r"\frac{\sin(%d w t - \theta) - \sin(%d w t - \theta)}{w}",
        (2, 1),
    ),
    (
        r"\int_0^{\frac{2 \pi}{w}} \cos^2(w x) dx",
        r"\frac{%d \pi}{%d w}",
        (1, 1),
    ),
    # a rate that is zero, as it is written or after terms cancel
    (r"\int_0^t x e^{0 x} \cos(0 x) dx", r"\frac{%d t^2}{%d}", (1, 2)),
    (r"\int_0^t e^{(a - a) x} \cos(w x) dx", r"\frac{%d \sin(%d w t)}{w}", (1, 1)),
]


@pytest.mark.parametrize(("left", "right", "numbers"), RIGHT)
def test_what_is_true_is_proved(left: str, right: str, numbers: tuple[int, ...]) -> None:
    check(judged("identity", f"latex = '{left} = {right % numbers}'\n{DOMAIN}"), "proved")


@pytest.mark.sampled
@pytest.mark.parametrize("seed", range(samples(10)))
def test_one_other_number_is_refuted(seed: int) -> None:
    # each number stands for a term, a rate or an order of its own: no other makes it true
    generator = random.Random(seed)
    left, right, numbers = RIGHT[seed % len(RIGHT)]
    place = generator.randrange(len(numbers))
    other = numbers[place] + generator.choice((1, 2, 3))
    wrong = (*numbers[:place], other, *numbers[place + 1 :])
    check(judged("identity", f"latex = '{left} = {right % wrong}'\n{DOMAIN}"), "refuted")


@pytest.mark.parametrize(
    ("latex", "domain", "why"),
    [
        (r"\int_0^\infty \cos(x) dx = 0", "", "does not decay"),
        (r"\int_0^t \cos(x^2) dx = t", "", "not linear"),
        (r"\int_0^t \cos(x) e^{-x^2} dx = t", "", "times an exponential of a square"),
        (r"\int_0^t \tan(x) dx = t", "", "anything but polynomials"),
        (r"\int_0^t \cos(w x) dx = \frac{\sin(w t)}{w}", "-1 < w < 1", "does not say that w != 0"),
        (r"\int_0^\infty e^{-a x} \sin(x) dx = \frac{1}{a^2 + 1}", "a > -1", "say that a > 0"),
        (r"\int_0^t \cos((\frac{b}{b} - 1) x) dx = t", "-1 < b < 1", None),
        (r"\int_0^t e^{(\frac{b}{b} - 1) x} dx = t", "-1 < b < 1", None),
        (r"\int_0^\infty e^{0 x} dx = t", "", "does not decay"),
    ],
)
def test_what_has_no_value_is_not_proved(latex: str, domain: str, why: str | None) -> None:
    found = judged("identity", f"latex = '{latex}'" + (f"\ndomain = '{domain}'" if domain else ""))
    assert found.verdict != "proved"
    assert why is None or why in found.reason


@pytest.mark.alike
@pytest.mark.sampled
@pytest.mark.parametrize("seed", range(samples(8)))
def test_the_value_is_that_of_quadrature(seed: int) -> None:
    generator = random.Random(seed)
    powers = [generator.randint(-3, 3) for _ in range(generator.randint(1, 4))]
    growth = generator.randint(-2, 2)
    turns = [
        (generator.choice(("sin", "cos")), generator.randint(-3, 3), generator.randint(-1, 1))
        for _ in range(generator.randint(1, 3))
    ]
    low, high = generator.choice([(-1, 2), (0, 1), (2, 0)])
    terms = " + ".join(f"({c}) x^{n}" if n else f"({c})" for n, c in enumerate(powers))
    waves = " ".join(rf"\{name}({w} x {phase:+})" for name, w, phase in turns)
    latex = rf"\int_{{{low}}}^{{{high}}} ({terms}) e^{{{growth} x}} {waves} dx"

    def integrand(x: mpmath.mpf) -> mpmath.mpf:
        value = sum(c * x**n for n, c in enumerate(powers)) * mpmath.exp(growth * x)
        for name, w, phase in turns:
            value *= getattr(mpmath, name)(w * x + phase)
        return value

    with mpmath.workdps(30):
        value = mpmath.quad(integrand, mpmath.linspace(low, high, 9))
        above, below = (
            mpmath.nstr(value + d, 20, min_fixed=-99, max_fixed=99) for d in (1e-9, -1e-9)
        )
    check(judged("inequality", f"latex = '{below} < {latex} < {above}'"), "proved")
    check(judged("inequality", f"latex = '{latex} < {below}'"), "refuted")
