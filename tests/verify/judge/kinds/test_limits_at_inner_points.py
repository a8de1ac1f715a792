"""Limits where a function is continuous: its value there, at irrational points and in the noise."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from small_claims import check, judged

POSITION = "{ quantity = 'filter_gain.1', meaning = 'gain' }"
SYMBOLS = {
    "x": "{ unit = '1', meaning = 'a number' }",
    "A": POSITION,
    "w": "{ unit = 'm s^-2', domain = 'w > 0', meaning = 'deviation of the noise' }",
    "v": "{ quantity = 'measurement_noise_deviation', meaning = 'of the measurement' }",
    "T": "{ quantity = 'sampling_interval', meaning = 'interval' }",
}
TWO = (
    "kind = 'steady_state'\ngain = 'filter'\nmeasurement_noise = [['v^2']]\n"
    "transition = [['1', 'T'], ['0', '1']]\nmeasurement = [['1', '0']]\n"
    r"process_noise = [['\frac{T^4 w^2}{4}', '\frac{T^3 w^2}{2}'],"
    r" ['\frac{T^3 w^2}{2}', 'T^2 w^2']]"
)
THREE = (
    "kind = 'steady_state'\ngain = 'filter'\nmeasurement_noise = [['v^2']]\n"
    r"transition = [['1', 'T', '\frac{T^2}{2}'], ['0', '1', 'T'], ['0', '0', '1']]"
    "\nmeasurement = [['1', '0', '0']]\n"
    r"process_noise = [['\frac{T^4 w^2}{4}', '\frac{T^3 w^2}{2}', '\frac{T^2 w^2}{2}'],"
    r" ['\frac{T^3 w^2}{2}', 'T^2 w^2', 'T w^2'], ['\frac{T^2 w^2}{2}', 'T w^2', 'w^2']]"
)


def _gain(states: int, noise: float) -> float:
    """Of the position, from the recursion for T = 1 and a measured variance of 1."""
    f = np.array([[1, 1, 0.5], [0, 1, 1], [0, 0, 1]])[:states, :states]
    moved = np.array([0.5, 1, 1])[:states]
    p, q = np.eye(states), noise**2 * np.outer(moved, moved)
    for _ in range(3000):
        k = p[:, :1] / (p[0, 0] + 1)
        p = f @ (p - k @ p[:1]) @ f.T + q
    return float(p[0, 0] / (p[0, 0] + 1))


@pytest.mark.parametrize(("states", "setting"), [(2, TWO), (3, THREE)])
@pytest.mark.parametrize("noise", ["2", r"\frac{1}{3}", r"\frac{4}{3}"])
def test_gains_where_the_noise_tends_to_a_number(states: int, setting: str, noise: str) -> None:
    """The recursion in NumPy, to six digits; the last digit wrong is refuted."""
    top, _, below = noise.strip("}").removeprefix(r"\frac{").partition("}{")
    exact = _gain(states, float(top) / float(below or 1))
    for value, wanted in ((exact, True), (exact + 1e-5, False)):
        bounds = (rf"A \to {value - 2e-6:.9f}", rf"A \to {value + 2e-6:.9f}")
        for formula in bounds:
            fields = f"latex = '{formula} \\quad (w \\to {noise})'\ndomain = 'T = 1, v = 1'"
            found = judged("limit", fields, SYMBOLS, setting)
            check(found, "refuted")
            assert found.witness is not None
            shown = float(found.witness["left"]["midpoint"])
            assert (abs(shown - value) < 2e-6) == wanted


@pytest.mark.parametrize(
    ("formula", "domain", "wanted"),
    [
        # random acceleration at the index 1: K_1 = 3/4, K_2 = 1/2
        (r"A \to \frac{3}{4} \quad (w \to 1)", "T = 1, v = 1", "proved"),
        (r"A \to \frac{3}{4} \quad (w \to 8)", "T = 1, v = 8", "proved"),
        (r"A \to \frac{3}{4} \quad (w \to 8)", "T = 1, v = 4", "refuted"),
        (r"\lim_{w \to v/T^2} A = \frac{3}{4}", "", "proved"),
        (r"\lim_{w \to 2 v/T^2} A = \frac{3}{4}", "", "refuted"),
        # there is no such noise, or only for some T
        (r"A \to \frac{3}{4} \quad (w \to -1)", "T = 1, v = 1", "undecided"),
        (r"\lim_{w \to x v/T^2} A = \frac{3}{4}", "", "undecided"),
    ],
)
def test_limits_in_the_noise(formula: str, domain: str, wanted: str) -> None:
    fields = f"latex = '{formula}'" + (f"\ndomain = '{domain}'" if domain else "")
    check(judged("limit", fields, SYMBOLS, TWO), wanted)


@pytest.mark.parametrize(
    ("formula", "domain", "wanted"),
    [
        (r"\lim_{x \to \sqrt{2}} x^4 = 4", "", "proved"),
        (r"\lim_{x \to \sqrt{2}} x^4 = 5", "", "refuted"),
        (r"\lim_{x \to \sqrt{2}} \frac{1}{x^2 - 1} = 1", "", "proved"),
        (r"\lim_{x \to \sqrt[3]{2}} \sqrt{x^3 + 2} = 2", "", "proved"),
        # not continuous there, or without values nearby
        (r"\lim_{x \to \sqrt{2}} \frac{x^2 - 2}{x - \sqrt{2}} = 2 \sqrt{2}", "", "undecided"),
        (r"\lim_{x \to \sqrt{2}} \sqrt{-(x^2 - 2)^2} = 0", "", "undecided"),
        (r"\lim_{x \to \sqrt{2}} \lfloor x \rfloor = 1", "", "undecided"),
        # a whole number comes close to none, and what is outside has no limit
        (r"\lim_{n \to \sqrt{4}} n = 2", "", "undecided"),
        (r"\lim_{x \to \sqrt{2}} x^2 = 2", "0 < x < 1", "undecided"),
        (r"\lim_{x \to \sqrt{2}} x^2 = 2", "0 < x < 2", "proved"),
    ],
)
def test_limits_at_irrational_points(formula: str, domain: str, wanted: str) -> None:
    fields = f"latex = '{formula}'" + (f"\ndomain = '{domain}'" if domain else "")
    check(judged("limit", fields), wanted)


@pytest.mark.parametrize(
    ("kind", "formula", "domain"),
    [
        ("limit", r"A \to \frac{1}{3} \quad (w \to 1)", "T = 2, v = 3"),
        ("limit", r"A \to \frac{1}{3} \quad (w \to 5)", "v = 0.5, T = 0.25"),
        ("limit", r"A \to \frac{1}{3} \quad (w \to v)", "T = 2"),
        ("identity", r"A = \frac{1}{3}", "w = 1, T = 2, v = 3"),
        ("inequality", r"A < \frac{1}{3}", "T = 2"),
        ("inequality", r"A < \frac{1}{3}", "v = 7"),
    ],
)
def test_a_witness_keeps_what_the_domain_sets(kind: str, formula: str, domain: str) -> None:
    """The recursion in NumPy at the index of the point that is told."""
    fields = f"latex = '{formula}'\ndomain = '{domain}'"
    found = judged(kind, fields, SYMBOLS, TWO)
    assert found.witness is not None
    point = found.witness["point"]
    for said in domain.split(", "):
        name, value = said.split(" = ")
        assert Fraction(point[name]) == Fraction(value)
    index = Fraction(point["w"]) * Fraction(point["T"]) ** 2 / Fraction(point["v"])
    assert abs(float(found.witness["left"]["midpoint"]) - _gain(2, float(index))) < 1e-9
    assert "tracking_index" not in found.reason
    assert all(f"{name} = {value}" in found.reason for name, value in point.items())


@pytest.mark.parametrize(
    ("setting", "formula", "domain", "told"),
    [
        (TWO, r"A \to \frac{3}{4} \quad (w \to 1)", "T = 2, v = 4", "as w -> 1, for T = 2, v = 4"),
        (TWO, r"A \to \frac{3}{4} \quad (w \to v)", "T = 1", "as w -> v, for T = 1"),
        ("", r"\lim_{x \to a} x = a", "a > 3", "as x -> a, for a > 3"),
        ("", r"\lim_{x^2 \to \sqrt{2}} b x^4 = 2 b", "x > 0", "as x^{2} -> sqrt(2)"),
        (
            "",
            r"\lim_{x^2 \to \sqrt{2}} a b x^4 = 6 a",
            "a > 3, x > 0, b = 3",
            "as x^{2} -> sqrt(2), for a > 3, b = 3",
        ),
    ],
)
def test_a_limit_is_told_with_its_conditions(
    setting: str, formula: str, domain: str, told: str
) -> None:
    fields = f"latex = '{formula}'\ndomain = '{domain}'"
    found = judged("limit", fields, SYMBOLS, setting) if setting else judged("limit", fields)
    check(found, "proved")
    assert found.domain == told


def test_a_refuted_limit_names_its_point() -> None:
    found = judged("limit", r"latex = '\lim_{x \to a} x = 2 a'" + "\ndomain = 'a = 3'")
    check(found, "refuted")
    assert found.reason.startswith("the limit is another: fails at x -> a, a = 3: left 3")
