"""Polynomials fitted to all samples, with weights that fall with age or without: gains, covariances
and lags against the batch in NumPy, published formulas and misprints of them.
"""

from __future__ import annotations

from fractions import Fraction
from math import factorial
from typing import Any

import numpy as np
import pytest
from claim_texts import HEAD, SOLVED

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.setting import fading_memory
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.setting.quantities import fading, memory
from gainproof.verify.judge.verdict import ClaimVerdict

WEIGHTS = {"sampling_interval": Fraction(3, 2), "measurement_noise_deviation": Fraction(2)}
FADING = r"""
[symbols]
'\theta' = { quantity = "forgetting_factor", meaning = "weight" }
'T' = { quantity = "sampling_interval", meaning = "interval" }
'R' = { quantity = "measurement_noise_variance", meaning = "variance" }
'g' = { quantity = "gain.1", meaning = "gain" }
'h' = { quantity = "gain.2", meaning = "gain" }
'k' = { quantity = "gain.3", meaning = "gain" }
'u' = { quantity = "gain.4", meaning = "gain" }
'P' = { quantity = "updated_covariance.1.1", meaning = "variance" }
'V' = { quantity = "updated_covariance.2.2", meaning = "variance" }
'D' = { quantity = "updated_lag.1.3", meaning = "lag" }
'J' = { quantity = "target_motion.3", meaning = "jerk" }
"""
GROWING = r"""
[symbols]
'n' = { quantity = "sample_number", meaning = "sample" }
'T' = { quantity = "sampling_interval", meaning = "interval" }
'R' = { quantity = "measurement_noise_variance", meaning = "variance" }
'g' = { quantity = "filter_gain.1", meaning = "gain" }
'u' = { quantity = "filter_gain.4", meaning = "gain" }
'V' = { quantity = "updated_covariance.4.4", meaning = "variance" }
"""


def judged(kind: str, degree: int, *claims: tuple[str, str], more: str = "") -> list[ClaimVerdict]:
    text = HEAD + (FADING if kind == "fading_memory" else GROWING)
    text += f"[settings.s]\ntitle = 's'\nkind = '{kind}'\ndegree = {degree}\n{more}\n"
    for at, (what, latex) in enumerate(claims):
        text += f"[[claims]]\nid = 'c{at}'\nplace = 'p'\nkind = '{what}'\nsetting = 's'\n"
        text += f"latex = '{latex}'\n"
    return list(judge_file(read_claim_text(text), (), solved=SOLVED))


def value(expr: Expr, **at: Fraction) -> float:
    known = constant_value(substituted(expr, {n: number(v) for n, v in {**WEIGHTS, **at}.items()}))
    assert known is not None
    return float(known)


def batch(degree: int, weights: Any, interval: float) -> tuple[Any, Any]:
    """What multiplies samples 0, 1, ... intervals old in the estimate by weighted least squares,
    and the transition.
    """
    ages = -interval * np.arange(len(weights))
    columns = [ages**m / factorial(m) for m in range(degree + 1)]
    design, root = np.column_stack(columns), np.sqrt(weights)[:, None]
    q, r = np.linalg.qr(design * root)
    step = [
        [interval ** (j - i) / factorial(j - i) if j >= i else 0 for j in range(degree + 1)]
        for i in range(degree + 1)
    ]
    return np.linalg.solve(r, (q * root).T), np.array(step)


def compared(degree: int, quantities: Any, fitted: Any, before: Any, step: Any, **at: Any) -> None:
    """Gains and covariances against those of the batch `fitted` and the one `before`."""
    predicted = step @ before @ before.T @ step.T * 4
    updated = fitted @ fitted.T * 4
    gains = fitted[:, 0] * 1.5 ** np.arange(degree + 1)
    wanted = {"innovation_variance": predicted[0, 0] + 4}
    for i in range(degree + 1):
        wanted[f"filter_gain.{i + 1}"] = gains[i]
        for j in range(degree + 1):
            wanted[f"predicted_covariance.{i + 1}.{j + 1}"] = predicted[i, j]
            wanted[f"updated_covariance.{i + 1}.{j + 1}"] = updated[i, j]
    for name, expected in wanted.items():
        assert value(quantities[name], **at) == pytest.approx(expected, rel=1e-7), name


@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("theta", [Fraction(1, 5), Fraction(7, 10)])
def test_fading_memory_is_the_weighted_batch(degree: int, theta: Fraction) -> None:
    weights = float(theta) ** np.arange(120)
    fitted, step = batch(degree, weights, 1.5)
    quantities = fading(degree).quantities
    at = {"forgetting_factor": theta}
    compared(degree, quantities, fitted, fitted, step, **at)
    # a target that moves as t^n / n! seen from its newest sample, and its state an interval on
    order = degree + 1
    seen = (-1.5 * np.arange(120.0)) ** order / factorial(order)
    updated = -(fitted @ seen)
    on = np.array([1.5 ** (order - i) / factorial(order - i) for i in range(order)])
    predicted = step @ updated + on
    motion = {f"target_motion.{order}": Fraction(1)}
    for which, lags in (("updated", updated), ("predicted", predicted)):
        for i, expected in enumerate(lags):
            found = value(quantities[f"{which}_lag.{i + 1}.{order}"], **at, **motion)
            assert found == pytest.approx(expected, rel=1e-7), (which, i)
            assert quantities[f"{which}_lag.{i + 1}.{degree}"] == number(0)
    loop = step @ (np.eye(order) - np.outer(fitted[:, 0], np.eye(order)[0]))
    for i, expected in enumerate(np.poly(loop)[::-1]):
        found = value(quantities[f"closed_loop_coefficient.{i}"], **at)
        assert found == pytest.approx(expected, abs=1e-7)


@pytest.mark.parametrize("degree", range(4))
@pytest.mark.parametrize("newest", [4, 9])
def test_growing_memory_is_the_batch(degree: int, newest: int) -> None:
    fitted, step = batch(degree, np.ones(newest + 1), 1.5)
    before, _ = batch(degree, np.ones(newest), 1.5)
    at = {"sample_number": Fraction(newest)}
    compared(degree, memory(degree).quantities, fitted, before, step, **at)


TRUE = [
    (0, r"g = 1 - \theta"),
    (0, r"P = R \frac{1 - \theta}{1 + \theta}"),
    (1, r"g = 1 - \theta^2, h = (1 - \theta)^2"),
    (1, r"V = \frac{2 R (1 - \theta)^3}{T^2 (1 + \theta)^3}"),
    (2, r"g = 1 - \theta^3"),
    (2, r"h = \frac{3}{2} (1 - \theta)^2 (1 + \theta)"),
    (2, r"k = \frac{(1 - \theta)^3}{2}"),
    (2, r"D = J T^3 \left(\frac{\theta}{1 - \theta}\right)^3"),
    (3, r"g = 1 - \theta^4"),
    (3, r"h = \frac{1}{6} (1 - \theta)^2 (11 + 14\theta + 11\theta^2)"),
    (3, r"u = (1 - \theta)^4"),
]
"""Brookner 1998, sections 1.2 and 7; Zarchan and Musoff 2015, chapter on fading-memory filters."""
SLIPS = [
    (0, r"P = R \frac{1 + \theta}{1 - \theta}", None),
    (1, r"h = (1 - \theta^2)", r"\left( 1 - \theta \right)^{2}"),
    (1, r"V = \frac{2 R (1 - \theta)^3}{T (1 + \theta)^3}", r"T^{2}"),
    (2, r"h = \frac{3}{2} (1 - \theta)^2 (1 - \theta)", r"1 + \theta"),
    (2, r"k = \frac{(1 - \theta)^2}{2}", r"\left( 1 - \theta \right)^{3}"),
    (3, r"g = 1 - \theta^3", r"\theta^{4}"),
    (3, r"h = \frac{1}{6} (1 - \theta)^2 (11 + 14\theta + 12\theta^2)", r"11 \theta^{2}"),
]


@pytest.mark.alike
@pytest.mark.parametrize(("degree", "latex"), TRUE)
def test_published_formulas_are_proved(degree: int, latex: str) -> None:
    (found,) = judged("fading_memory", degree, ("identity", latex), more="third_gain = '1/2'")
    assert found.verdict == "proved", found.reason
    assert not found.any_filter


@pytest.mark.alike
@pytest.mark.parametrize(("degree", "latex", "repaired"), SLIPS)
def test_misprints_are_refuted_and_mended(degree: int, latex: str, repaired: str | None) -> None:
    (found,) = judged("fading_memory", degree, ("identity", latex), more="third_gain = '1/2'")
    assert found.verdict == "refuted", found.reason
    assert repaired is None or repaired in (found.repair or {})["latex"]


def test_other_kinds_of_claims_about_weights() -> None:
    found = judged(
        "fading_memory",
        1,
        ("limit", r"g \to 0 \quad (\theta \to 1)"),
        ("inequality", r"g^2 < 4 h \quad (\theta > \frac{1}{3})"),
        ("inequality", r"P < R"),
        ("identity", r"\frac{\partial V}{\partial T} = -\frac{2 V}{T}"),
        ("value", r"g \approx 0.75 \quad (\theta = 0.5)"),
        ("inequality", r"h > \theta^2"),
    )
    assert [each.verdict for each in found] == [*["proved"] * 2, *["proved"] * 3, "conditional"]


def test_cubic_fitted_to_all_samples() -> None:
    good, variance, bad = judged(
        "growing_memory",
        3,
        ("identity", r"g = \frac{8(2n^3 + 3n^2 + 7n + 3)}{(n+1)(n+2)(n+3)(n+4)}"),
        (
            "identity",
            r"V = \frac{100800 R}{T^6 n (n-2)(n-1)(n+1)(n+2)(n+3)(n+4)} \quad (n \geq 3)",
        ),
        ("identity", r"u = \frac{480}{(n+1)(n+2)(n+3)(n+4)}"),
    )
    assert good.verdict == variance.verdict == "proved"
    assert bad.verdict == "refuted"
    assert "840" in (bad.repair or {})["latex"]


def test_a_fading_memory_has_no_tracking_index() -> None:
    text = FADING + "'q' = { quantity = 'tracking_index', meaning = 'index' }\n"
    text = HEAD + text + "[settings.s]\ntitle = 's'\nkind = 'fading_memory'\ndegree = 1\n"
    text += "[[claims]]\nid = 'c'\nplace = 'p'\nkind = 'identity'\nsetting = 's'\nlatex = 'g = q'\n"
    (found,) = judge_file(read_claim_text(text), ())
    assert found.verdict == "undecided"
    assert "no tracking index" in found.reason


@pytest.mark.parametrize("wrong", ["_moment", "_power_sums", "inverse"])
def test_what_is_derived_wrongly_is_not_established(
    monkeypatch: pytest.MonkeyPatch, wrong: str
) -> None:
    right = getattr(fading_memory, wrong)

    def changed(*args: Any) -> Any:
        found = right(*args)
        if isinstance(found, list):
            return [found[0], *[2 * each for each in found[1:]]]
        return -found if isinstance(found, Expr) else tuple((2 * r[0], *r[1:]) for r in found)

    monkeypatch.setattr(fading_memory, wrong, changed)
    with pytest.raises(NotEstablished):
        fading_memory.fading_memory(2)
