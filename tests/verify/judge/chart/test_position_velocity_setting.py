"""The steady state with position and velocity measured, and that what establishes it can fail."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

import pytest
from claim_texts import HEAD, SOLVED
from mpmath import inverse, matrix, mp, mpf
from one_of_each import cases, further

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.exact.balls import enclosed
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.setting import position_velocity as module
from gainproof.verify.judge.setting.environment import (
    DEVIATION,
    INDEX,
    INTERVAL,
    RATIO,
    NotEstablished,
)
from gainproof.verify.judge.setting.plane_chart import COVERED
from gainproof.verify.judge.setting.position_velocity import chart_of, position_velocity
from gainproof.verify.judge.setting.two_measurements import (
    Entries,
    Noise,
    entries,
    exact_velocity,
)
from gainproof.verify.judge.verdict import ClaimVerdict

NAMES = ("predicted_covariance.1.1", "predicted_covariance.1.2", "predicted_covariance.2.2")
GAINS = ("gain_matrix.1.1", "gain_matrix.1.2", "gain_matrix.2.1", "gain_matrix.2.2")


NOISES = {
    "continuous white acceleration": COVERED,
    "random acceleration": Noise(Fraction(1, 4), Fraction(1, 2)),
    "random velocity": Noise(Fraction(0), Fraction(0)),
}


def iterated(index: Fraction, ratio: Fraction, noise: Noise) -> tuple[list[mpf], list[mpf]]:
    """Predicted covariance and gain in units T = 1, by the filter's own recursion."""
    with mp.workdps(40):
        f, a = matrix([[1, 1], [0, 1]]), _real(index)
        mixed = _real(noise.mixed)
        q = a**2 * matrix([[_real(noise.position), mixed], [mixed, 1]])
        r = matrix([[1, 0], [0, _real(ratio) ** 2]])
        p = q + matrix([[1, 0], [0, 1]])
        for _ in range(600):
            gain = p * inverse(p + r)
            p = f * (p - gain * p) * f.T + q
        gain = p * inverse(p + r)
        return [p[0, 0], p[0, 1], p[1, 1]], [gain[i, j] for i in range(2) for j in range(2)]


def _real(value: Fraction) -> mpf:
    return mpf(value.numerator) / value.denominator


@pytest.mark.parametrize("name", cases(NOISES, lambda name: name == "random acceleration"))
def test_numbers(name: str) -> None:
    environment = position_velocity(NOISES[name], name)
    units = {INTERVAL: Fraction(1), DEVIATION: Fraction(1)}
    for index, ratio in (("1", "1"), ("1/3", "2"), ("5", "1/7"), ("9/2", "3/2"), ("2", "40")):
        point = {INDEX: Fraction(index), RATIO: Fraction(ratio)}
        covariance, gain = iterated(point[INDEX], point[RATIO], NOISES[name])
        for quantity, wanted in zip((*NAMES, *GAINS), (*covariance, *gain), strict=True):
            ball = enclosed(environment.quantities[quantity], {**point, **units}, 128)
            assert float(ball.mid()) == pytest.approx(float(wanted), rel=1e-14, abs=0)


def test_other_noises_are_refused() -> None:
    with pytest.raises(Undecided):
        position_velocity(Noise(Fraction(1, 2), Fraction(1, 2)), "none with a name")


def _other(found: Entries, place: int) -> Entries:
    """The entries with one a little greater."""
    both: Sequence[Expr] = (*found.predicted, *found.updated)
    changed = [e * number(Fraction(1001, 1000)) if k == place else e for k, e in enumerate(both)]
    return Entries((changed[0], changed[1], changed[2]), (changed[3], changed[4], changed[5]))


@pytest.mark.parametrize("place", range(6))
def test_a_wrong_entry_is_no_steady_state(place: int, monkeypatch: pytest.MonkeyPatch) -> None:
    right = chart_of(COVERED)
    wrong = replace(right, entries=_other(right.entries, place))
    monkeypatch.setattr(module, "chart_of", lambda _: wrong)
    with pytest.raises(NotEstablished):
        position_velocity(COVERED, "white acceleration")


@pytest.mark.parametrize("place", range(6))
def test_a_wrong_closed_form_is_found(place: int, monkeypatch: pytest.MonkeyPatch) -> None:
    right = entries
    monkeypatch.setattr(module, "entries", lambda *given: _other(right(*given), place))
    with pytest.raises(NotEstablished):
        position_velocity(COVERED, "white acceleration")


def test_the_other_root_is_no_steady_state(monkeypatch: pytest.MonkeyPatch) -> None:
    right = chart_of(COVERED)
    p11, p12, p22 = right.entries.predicted
    turned = replace(right.entries, predicted=(p11, -p12, p22))
    monkeypatch.setattr(module, "chart_of", lambda _: replace(right, entries=turned))
    with pytest.raises(NotEstablished):
        position_velocity(COVERED, "white acceleration")


@pytest.mark.parametrize("name", ["random acceleration", "random velocity"])
@pytest.mark.parametrize("place", range(6))
def test_a_wrong_entry_of_another_noise(
    place: int, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    right = chart_of(NOISES[name])
    wrong = replace(right, entries=_other(right.entries, place))
    monkeypatch.setattr(module, "chart_of", lambda _: wrong)
    with pytest.raises(NotEstablished):
        position_velocity(NOISES[name], name)


@pytest.mark.parametrize("name", NOISES)
def test_a_chart_of_other_pairs_is_found(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    right = chart_of(NOISES[name])
    wrong = replace(right, ratio2=2 * right.ratio2)
    monkeypatch.setattr(module, "chart_of", lambda _: wrong)
    with pytest.raises(NotEstablished):
        position_velocity(NOISES[name], name)


def test_a_wrong_limit_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    right = exact_velocity
    monkeypatch.setattr(module, "exact_velocity", lambda *given: right(*given) * 2)
    with pytest.raises(NotEstablished, match="continuous"):
        position_velocity(COVERED, "white acceleration")


SETTING = r"""
[symbols]
'T' = { quantity = "sampling_interval", meaning = "interval" }
'a' = { unit = "m s^-2", domain = 'a > 0', meaning = "deviation of the acceleration" }
'd' = { unit = "m s^-1", domain = 'd > 0', meaning = "deviation of a measured velocity" }
'o' = { quantity = "measurement_noise_deviation", meaning = "of a measured position" }
'S' = { quantity = "velocity_deviation_ratio", meaning = "ratio" }
'P' = { quantity = "predicted_covariance.1.1", meaning = "variance" }
'K' = { quantity = "gain_matrix.1.2", meaning = "gain" }
'L' = { quantity = "gain_matrix.2.1", meaning = "gain" }
'G' = { definition = 'P/o^2', meaning = "ratio of variances" }
'r' = { definition = '\frac{4 o}{a T^2}', meaning = "4 over the index" }
'Z' = { quantity = "exact_velocity_covariance.1.1", meaning = "limit" }
'N' = { quantity = "no_velocity_covariance.1.1", meaning = "limit" }
[settings.s]
title = "both measured"
kind = "steady_state"
transition = [["1", "T"], ["0", "1"]]
process_noise = [['a^2 T^4/3', 'a^2 T^3/2'], ['a^2 T^3/2', 'a^2 T^2']]
measurement = [["1", "0"], ["0", "1"]]
measurement_noise = [['o^2', "0"], ["0", 'd^2']]
"""

WHITE = "[['a^2 T^4/3', 'a^2 T^3/2'], ['a^2 T^3/2', 'a^2 T^2']]"
B = """'b' = { unit = "1", domain = 'b > 0', meaning = "ratio" }
"""


def only(kind: str, fields: str, setting: str = SETTING) -> ClaimVerdict:
    said = fields if fields.startswith("about") else f"latex = '{fields}'"
    text = f"[[claims]]\nid = 'c'\nplace = 'p'\nsetting = 's'\nkind = '{kind}'\n{said}\n"
    return judge_file(read_claim_text(HEAD + setting + text), [], solved=SOLVED)[0]


def trend(what: str, along: str, way: str) -> str:
    return f"about = ['{what}', '{along}']\ntrend = '{way}'\ntext = 't'"


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kind", "fields", "wanted"),
    [
        ("identity", r"S = \frac{d T}{o}", "proved"),
        further("identity", r"K = \frac{L o^2}{d^2}", "proved"),
        ("identity", r"K = \frac{2 L o^2}{d^2}", "refuted"),
        ("inequality", r"P > 0", "proved"),
        ("inequality", r"P < \frac{a^2 T^4}{3}", "refuted"),
        ("monotone", trend("G", "S", "increasing"), "proved"),
        ("monotone", trend("G", "S", "decreasing"), "refuted"),
        ("limit", r"\lim_{S \to 0} G = \frac{Z}{o^2}", "proved"),
        further("limit", r"\lim_{S \to \infty} G = \frac{N}{o^2}", "proved"),
        further("limit", r"\lim_{S \to \infty} G = \frac{Z}{o^2}", "refuted"),
        further("monotone", trend(r"\frac{Z}{N}", "r", "decreasing"), "proved"),
        further("monotone", trend(r"\frac{Z}{N}", "r", "increasing"), "refuted"),
        ("value", r"\frac{Z}{N} \approx 0.536 \quad (r \to 0)", "proved"),
        further("value", r"\frac{Z}{N} \approx 0.537 \quad (r \to 0)", "refuted"),
        # with these the index changes in ways that the formulas hide
        ("identity", r"\frac{\partial G}{\partial T} = 0", "refuted"),
        further("identity", r"\frac{\partial G}{\partial o} = 0", "refuted"),
    ],
)
def test_claims(kind: str, fields: str, wanted: str) -> None:
    verdict = only(kind, fields)
    assert verdict.verdict == wanted, verdict.reason
    if wanted == "refuted":
        assert verdict.witness is not None


@pytest.mark.parametrize(
    ("noise", "wanted"),
    [
        ("[['a^2 T^4/4', 'a^2 T^3/2'], ['a^2 T^3/2', 'a^2 T^2']]", "random acceleration"),
        ("[['0', '0'], ['0', 'a^2 T^2']]", "random velocity"),
    ],
)
def test_trends_with_other_noises(noise: str, wanted: str) -> None:
    start = SETTING.index("process_noise = ") + len("process_noise = ")
    setting = SETTING[:start] + noise + SETTING[SETTING.index("\n", start) :]
    for way, verdict in (("increasing", "proved"), ("decreasing", "refuted")):
        found = only("monotone", trend("G", "S", way), setting)
        assert found.verdict == verdict, (wanted, found.reason)


def test_a_divisor_that_vanishes_on_a_curve_has_an_exact_witness() -> None:
    verdict = only("identity", r"P \frac{S^2 - (4/r)^2}{S^2 - (4/r)^2} = P")
    assert verdict.verdict == "conditional"
    assert verdict.witness is not None
    assert verdict.witness["left"]["undefined"]
    assert "is not zero" in (verdict.domain or "")


@pytest.mark.parametrize(
    ("before", "after"),
    [
        ("[\"0\", 'd^2']", "[\"0\", '2 d^2']"),
        ("['o^2', \"0\"]", "['o^2', \"1\"]"),
        ("['a^2 T^4/3', 'a^2 T^3/2']", "['a^2 T^4/2', 'a^2 T^3/2']"),
        ('measurement = [["1", "0"], ["0", "1"]]', 'measurement = [["1", "0"], ["1", "1"]]'),
        (WHITE, "[['d^2 T^2/3', 'd^2 T/2'], ['d^2 T/2', 'd^2']]"),
        (WHITE, "[['0', '0'], ['0', 'd^2']]"),
        (WHITE, "[['0', '0'], ['0', 'o^2/T^2']]"),
        (WHITE, "[['0', '0'], ['0', '4 o^2/T^2']]"),
    ],
)
def test_models_that_are_not_covered(before: str, after: str) -> None:
    assert before in SETTING
    for kind, claim in (("inequality", "P > 0"), ("identity", "S = r"), ("identity", "r = 4")):
        verdict = only(kind, claim, SETTING.replace(before, after))
        assert verdict.verdict == "undecided"


def test_a_deviation_of_both_noises() -> None:
    """What is left of the index is a symbol that the velocity's deviation is divided out of."""
    noise = "[['0', '0'], ['0', 'b^2 d^2']]"
    setting = SETTING.replace(WHITE, noise).replace("[settings.s]", f"{B}[settings.s]")
    verdict = only("identity", "b = \\frac{4}{r S}", setting.replace("a T^2", "b d T"))
    assert verdict.verdict == "proved", verdict.reason
    assert only("identity", "b = \\frac{4}{r}", setting).verdict == "refuted"


@pytest.mark.parametrize(
    ("token", "relation", "wanted"),
    [
        ("d", r"\geq", "undecided"),
        ("d", r"\neq", "undecided"),
        ("a", r"\neq", "undecided"),
        # without process noise nothing is steady
        ("a", r"\geq", "proved"),
    ],
)
def test_a_root_is_positive_where_a_domain_says_so(token: str, relation: str, wanted: str) -> None:
    setting = SETTING.replace(f"domain = '{token} > 0'", f"domain = '{token} {relation} 0'")
    verdict = only("inequality", f"{token} > 0", setting)
    assert verdict.verdict == wanted
    assert wanted == "proved" or f"solved for {token} > 0 only" in verdict.reason
