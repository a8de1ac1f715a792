"""How many real solutions an equation has: by hand, and by NumPy's roots."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise
from typing import Any

import flint
import numpy as np
import pytest
from small_claims import check, judged

from gainproof.verify.judge.exact.algebraic_numbers import real_roots
from gainproof.verify.judge.exact.root_count import NumberField

NEAR = 1e-7
"""So near to an end, to each other or to the real line roots are left out of a comparison."""


def _judged(equation: str, count: int, domain: str = "") -> Any:
    said = f"\ndomain = '{domain}'" if domain else ""
    return judged("solutions", f"latex = '{equation}'\nvariable = 'x'\nnumber = {count}{said}")


@pytest.mark.parametrize(
    ("equation", "count", "domain", "wanted"),
    [
        # the slope 3 (x - 1)^2 + 1 is positive
        ("x^3 - 3 x^2 + 4 x - 1 = 0", 1, "", "proved"),
        ("x^3 - 3 x^2 + 4 x - 1 = 0", 3, "", "refuted"),
        # least at x = -1, where it is c - 3
        ("x^4 + 4 x + c = 0", 2, "c < 3", "proved"),
        ("x^4 + 4 x + c = 0", 2, r"c \leq 3", "conditional"),
        ("x^4 + 4 x + c = 0", 1, "c = 3", "proved"),
        ("x^4 + 4 x + c = 0", 0, "c > 3", "proved"),
        ("x^4 + 4 x + c = 0", 1, r"c \geq 3", "refuted"),
        # discriminants, with one double root where they are zero
        ("x^2 + p x + q = 0", 2, "p^2 > 4 q", "proved"),
        ("x^2 + p x + q = 0", 2, r"p^2 \geq 4 q", "refuted"),
        ("x^2 + p x + q = 0", 2, "p^2 > 3 q", "refuted"),
        ("x^2 + p x + q = 0", 0, "p^2 < 4 q", "proved"),
        ("x^2 + p x + q = 0", 2, "q < 0", "proved"),
        # parameters with one value, and an equation between them
        ("x^2 + p x + q = 0", 2, r"q = 2, p \geq 3", "proved"),
        ("x^2 + p x + q = 0", 2, r"q = 3, p \geq 3", "conditional"),
        ("x^2 + p x + q = 0", 1, r"2 \leq p \leq 2, q = 1", "proved"),
        ("x^2 + p x + q = 0", 2, "p q = 3, p > 100", "undecided"),
        ("a x^2 + p x + q = 0", 2, "p^2 > 4 a q", "refuted"),  # a = 0 leaves one
        ("a x^2 + p x + q = 0", 2, "p^2 > 4 a q, a > 0", "proved"),
        ("x^3 + p x + q = 0", 1, "p > 0", "proved"),
        ("x^3 + p x + q = 0", 1, r"p \geq 0", "undecided"),  # true: at p = q = 0 one triple root
        ("x^3 + p x + q = 0", 3, "4 p^3 + 27 q^2 < 0", "proved"),
        ("x^3 + p x + q = 0", 3, "4 p^3 + 27 q^2 > 0", "refuted"),
        # ends that belong to the interval, and that do not
        ("x^2 = 4", 1, "x > 0", "proved"),
        ("x^2 = 4", 0, "x > 2", "proved"),
        ("x^2 = 4", 1, r"x \geq 2", "proved"),
        ("x^2 = 4", 1, r"-2 \leq x < 2", "proved"),
        ("x^2 = 4", 2, r"-2 \leq x \leq 2", "proved"),
        ("x^2 = 4", 0, "-2 < x < 2", "proved"),
        # ends that are parameters: x = sqrt(c) < c for c > 1
        ("x^2 = c", 1, "0 < x < c, c > 1", "proved"),
        ("x^2 = c", 1, r"0 < x < c, c \geq 1", "conditional"),
        ("x^2 = c", 1, r"0 < x \leq c, c \geq 1", "proved"),
        ("x = c + p", 1, "0 < x < 1, c > 0, p > 0, c + p < 1", "proved"),
        ("x = c + p", 1, "0 < x < 1, c > 0, p > 0, c + p < 2", "refuted"),
        ("x = c + p", 1, r"0 < x, c > 0, p \geq 0, c \geq p", "proved"),
        # divisors: solutions that lie where they are zero are none
        (r"\frac{x^2}{x} = 0", 0, "", "proved"),
        (r"\frac{x^2 - 1}{x - c} = 0", 2, "c > 1", "proved"),
        (r"\frac{x^2 - 1}{x - c} = 0", 2, "c > 0", "conditional"),
        (r"\frac{x^2 - 2}{x - c} = 0", 2, "c > 0", "conditional"),  # c = sqrt(2) is not rational
        (r"\frac{x^2}{2 - x} = c", 1, "0 < c < 1, 0 < x < 1", "proved"),
        (r"\frac{x^2}{2 - x} = c", 1, "0 < c < 2, 0 < x < 1", "conditional"),
        ("(x^2 - 2)(x - c) = 0", 3, "c > 0", "conditional"),
        ("(x^2 - 2)^2 (x - c)^3 = 0", 3, "c > 2", "proved"),
        # a solution that runs off to infinity at c = 2
        ("(c - 2) x = 1", 1, "c > 0", "conditional"),
        ("(c - 2) x^2 - x = 1", 2, "c > 3", "proved"),
        ("(c - a) x^2 - x = 1", 2, "c > a", "proved"),
        ("(c - a) x^2 - x = 1", 2, "c > 0, a > 0", "refuted"),
        # every number, and none
        ("c x = 0", 1, "c > 0", "proved"),
        ("c x = 0", 1, "", "conditional"),
        ("c x = c", 1, r"0 < x \leq 1", "conditional"),
        # an interval of one point, where an identity may have no value
        (r"\frac{(c - 1) x}{x - 1} = 0", 1, r"1 \leq x \leq c, c = 1", "refuted"),
        (r"\frac{(c - 1) x}{x - 1} = 0", 0, r"1 \leq x \leq c, c = 1", "proved"),
        (r"\frac{0}{x} = 0", 1, r"0 \leq x \leq 0", "refuted"),
        (r"\frac{0}{x} = 0", 1, r"2 \leq x \leq 2", "proved"),
        (r"\frac{0}{x^2 - 2} = 0", 1, r"c \leq x \leq c, c > 0", "conditional"),
        (r"\frac{0}{x - a} = 0", 1, r"b \leq x \leq b", "refuted"),
        (r"\frac{0}{x - a} = 0", 1, r"b \leq x \leq b, a > b", "proved"),
        # conditions without a value where a divisor is zero
        ("x^2 = c", 2, r"\frac{1}{c} \geq 0", "proved"),
        ("x^2 = c", 2, r"\frac{c^2}{c} \geq 0", "proved"),
        ("x^2 = c", 2, r"\frac{a}{c} \geq 0, a > 0", "undecided"),  # true: c > 0
        ("c x = a", 1, r"\frac{1}{c} \geq a - \frac{a c}{c}", "proved"),
        ("x^2 = c", 1, r"\frac{1}{c} \geq a, a > 0", "refuted"),
        # ends without a value where a divisor is zero: no solution is there
        ("x^2 = 1", 1, r"x > \frac{a^2}{a}, -1 < a < 1", "conditional"),
        ("x^2 = 1", 1, r"x > \frac{a^2}{a}, 0 < a < 1", "proved"),
        ("x = 1", 1, r"x < \frac{a b}{b}, a > 2, -1 < b < 1", "refuted"),
        ("x = 1", 1, r"x < \frac{a b}{b}, a > 2, 0 < b < 1", "proved"),
        # roots of numbers, and one that is a number itself
        ("x^2 = 1", 1, r"x > \sqrt{2}", "undecided"),
        ("x^2 = 1", 0, r"x > \sqrt{2}", "undecided"),
        ("x^2 = a", 2, r"a > \sqrt{2}", "undecided"),
        ("x^2 = c", 1, r"0 < x < \sqrt[3]{2} c, c > 1", "undecided"),
        (r"x^2 = \sqrt{4} p + q", 2, "p > 1, q > -2", "proved"),
        (r"x^2 = \sqrt{4} p + q", 2, "p > -1, q > 1", "refuted"),
        # what is not covered
        (r"\sqrt{x} = c", 1, "c > 0", "undecided"),
        ("x^2 = c", 1, "x^2 < c", "undecided"),
        ("x = i", 1, "", "undecided"),
    ],
)
def test_number_of_solutions(equation: str, count: int, domain: str, wanted: str) -> None:
    check(_judged(equation, count, domain), wanted)


@pytest.mark.parametrize("given", ["a < b", r"a \neq 3", "a b = 8", "b - 1 > a"])
@pytest.mark.parametrize("count", [2, 5])
def test_nothing_is_said_where_hypotheses_contradict_each_other(count: int, given: str) -> None:
    fields = f"latex = 'x^2 = c a b'\nvariable = 'x'\nnumber = {count}\ndomain = 'c > 0'"
    found = judged("solutions", f"{fields}\ngiven = ['a = 3', 'b = 3', '{given}']")
    check(found, "undecided")


def test_a_refutation_shows_the_true_number_and_where() -> None:
    found = _judged("x^2 + p x = q", 1, "p > 0, q > 0")
    check(found, "refuted")
    assert found.witness is not None
    p, q = (Fraction(found.witness["point"][name]) for name in "pq")
    low, high = sorted(np.roots([1, float(p), -float(q)]))
    assert found.reading == "exactly 1 real x satisfies it"
    assert found.witness["note"] == f"there are 2 real solutions, near {low:.6g}, {high:.6g}"


def test_where_one_parameter_has_so_many() -> None:
    """The discriminant of x^3 + (p/2 - 3) x^2 + (p/2 + 3) x - 1 is p^2 (p^2 - 432)/16."""
    found = _judged(r"x^3 + (\frac{p}{2} - 3) x^2 + (\frac{p}{2} + 3) x - 1 = 0", 1, "p > 0")
    check(found, "conditional")
    assert found.domain == "for 0 < p < 12*sqrt(3)"
    only = r"x^3 + (\frac{p}{2} - 3) x^2 + (\frac{p}{2} + 3) x - 1 = 0"
    inside = _judged(only, 1, "p > 0, 0 < x < 1")
    check(inside, "proved")
    assert inside.reading == "exactly 1 real x with 0 < x < 1 satisfies it"


@pytest.mark.parametrize(
    ("equation", "count", "domain", "holds"),
    [
        ("x^2 = c", 2, "c^2 = 2", "for c = sqrt(2)"),
        ("x^2 = c", 0, "c^2 = 2", "for c = -sqrt(2)"),
        ("x^2 = c", 2, "(c^2 - 9)(c - 5) = 0", "for c = 3 or c = 5"),
        ("x^2 = c", 1, "", "for c = 0"),
        ("x^4 + 4 x + c = 0", 1, r"c \geq 3", "for c = 3"),
        ("x^2 = c", 3, "c^2 = 2", "nowhere"),
    ],
)
def test_isolated_points_that_have_so_many(
    equation: str, count: int, domain: str, holds: str
) -> None:
    found = _judged(equation, count, domain)
    check(found, "refuted")
    assert found.domain == holds
    assert f"; holds only {holds}" in found.reason or holds == "nowhere"


def _clear(roots: Any, ends: tuple[float, ...]) -> bool:
    """Whether floating point tells how many are real, different and inside."""
    doubtful = [r for r in roots if 0 < abs(r.imag) < NEAR]
    real = sorted(r.real for r in roots if r.imag == 0)
    close = any(b - a < NEAR for a, b in pairwise(real))
    return not doubtful and not close and all(abs(r - e) > NEAR for r in real for e in ends)


@pytest.mark.parametrize("root", [None, 0, 1])
def test_counts_agree_with_numerical_roots(root: int | None) -> None:
    """Rational coefficients, and those in the field of a root of t^3 - 4 t + 1."""
    source, compared = np.random.default_rng(7), 0
    numbers = real_roots(flint.fmpz_poly([1, -4, 0, 1]))
    number = numbers[root or 0]
    field, near = NumberField(number), float(number.refined(Fraction(1, 10**15)).low)
    for _ in range(150):
        rows = source.integers(-6, 7, (int(source.integers(2, 7)), 1 if root is None else 3))
        f = field.polynomial([flint.fmpq_poly([int(c) for c in row]) for row in rows])
        low, high = sorted(int(e) for e in source.integers(-4, 5, 2))
        if len(f) < 2 or low == high:
            continue
        values = [sum(float(c) * near**k for k, c in enumerate(row)) for row in rows]
        roots = np.roots(values[::-1])
        if not _clear(roots, (low, high)):
            continue
        compared += 1
        real = [r.real for r in roots if r.imag == 0]
        simple = field.simple(f)
        ends = flint.fmpq_poly([low]), flint.fmpq_poly([high])
        assert field.roots_up_to(simple, None, None) == len(real)
        assert field.roots_up_to(simple, *ends) == sum(low < r < high for r in real)
        assert field.roots_up_to(simple, None, ends[0]) == sum(r < low for r in real)
    assert compared > 80


def test_multiple_roots_count_once_over_a_field() -> None:
    """(x - t)^3 (x^2 - 2) with t = sqrt(2): the roots t and -t."""
    (_, number) = sorted(real_roots(flint.fmpz_poly([-2, 0, 1])), key=lambda n: n.low)
    field, t = NumberField(number), flint.fmpq_poly([0, 1])
    cube = [-(t**3), 3 * t**2, -3 * t, flint.fmpq_poly([1])]
    f = [flint.fmpq_poly([0])] * 6
    for i, c in enumerate(cube):
        f[i], f[i + 2] = f[i] - 2 * c, f[i + 2] + c
    simple = field.simple(field.polynomial(f))
    assert len(simple) == 3
    assert field.roots_up_to(simple, t, None) == 0
    assert field.roots_up_to(simple, -t, t) == 1
    assert (
        field.roots_up_to(
            field.simple(field.polynomial(f), [[-t, flint.fmpq_poly([1])]]), None, None
        )
        == 1
    )


@pytest.mark.parametrize("seed", range(12))
def test_verdicts_agree_with_numerical_roots(seed: int) -> None:
    """Equations in one and two parameters: what is proved holds at all points that NumPy tells, and
    the point of a refutation has another number by NumPy too.
    """
    source = np.random.default_rng(seed)
    names = ("p",) if seed % 2 else ("p", "q")
    powers = range(int(source.integers(2, 5)) + 1)
    table = {(k, n): int(source.integers(-3, 4)) for k in powers for n in ("", *names)}
    text = "".join(f"{c:+d} {n} x^{k}" if k else f"{c:+d} {n}" for (k, n), c in table.items())
    equation = f"{text.removeprefix('+')} = 0".replace("x^1", "x")
    low, high = sorted(int(e) for e in source.choice(np.arange(-3, 4), 2, replace=False))

    def count(point: dict[str, float]) -> int | None:
        at = {"": 1.0, **point}
        values = [sum(table[k, n] * at[n] for n in at) for k in powers]
        roots = np.roots(values[::-1])
        if abs(values[-1]) < NEAR or not _clear(roots, (low, high)):
            return None
        return sum(1 for r in roots if r.imag == 0 and low < r.real < high)

    points = [dict(zip(names, source.uniform(0.05, 4, len(names)), strict=True)) for _ in range(60)]
    counts = [n for n in map(count, points) if n is not None]
    assert len(counts) > 20
    for number in {*counts, 3}:
        domain = ", ".join(f"{n} > 0" for n in names) + f", {low} < x < {high}"
        found = _judged(equation, number, domain)
        if found.verdict == "proved":
            assert set(counts) == {number}
        if found.verdict in ("refuted", "conditional"):
            assert found.witness is not None
            point = {n: v for n, v in found.witness["point"].items() if "root" not in v}
            if len(point) == len(names) and "sqrt" not in str(point):
                seen = count({n: float(Fraction(v)) for n, v in point.items()})
                assert seen is None or seen != number
