"""Limits of steady quantities as one gain gets small, the other held: for those values of it for
which the filter is stable close to the limit.
"""

from __future__ import annotations

import pytest
from free_gains import predicted_covariance, radius, verdict

NEAR = 1e-7


@pytest.mark.parametrize(
    ("latex", "wanted", "domain"),
    [
        (r"p_{11} \to \infty \quad (\alpha \to 0)", "proved", r"0 < \beta < 4"),
        (r"s_{11} \to \infty \quad (\alpha \to 0)", "proved", r"0 < \beta < 4"),
        (r"p_{11} \to \frac{\alpha}{2-\alpha} B \quad (\beta \to 0)", "proved", r"0 < \alpha < 2"),
        (r"p_{22} \to 0 \quad (\beta \to 0)", "proved", r"0 < \alpha < 2"),
        (r"p_{11} \to 0 \quad (\alpha \to 0)", "refuted", ""),
        (r"p_{11} \to \infty \quad (\beta \to 0)", "refuted", ""),
        (r"p_{11} \to B \quad (\beta \to 0)", "refuted", ""),
        (r"s_{11} \to -\infty \quad (\alpha \to 0)", "refuted", ""),
    ],
)
def test_one_gain_gets_small(latex: str, wanted: str, domain: str) -> None:
    found = verdict("limit", f"latex = '{latex}'")
    assert found.verdict == wanted, found.reason
    assert domain in (found.domain or "")


@pytest.mark.parametrize("beta", [0.01, 1.0, 3.9])
def test_the_small_gain_of_the_position_in_numbers(beta: float) -> None:
    assert radius([NEAR, beta]) < 1
    assert predicted_covariance([NEAR, beta])[0, 0] > 1e-3 * beta / NEAR


@pytest.mark.parametrize("alpha", [0.1, 1.0, 1.9])
def test_the_small_gain_of_the_velocity_in_numbers(alpha: float) -> None:
    found = predicted_covariance([alpha, NEAR])
    assert found[0, 0] == pytest.approx(alpha / (2 - alpha), rel=1e-3)


def test_at_a_border_that_is_excluded_nothing_is_said() -> None:
    """With beta = 4 no small gain of the position makes a stable filter."""
    assert radius([NEAR, 4.0]) > 1
    claim = "latex = 'p_{11} \\to \\infty \\quad (\\alpha \\to 0)'\ndomain = '\\beta = 4'"
    assert verdict("limit", claim).verdict == "undecided"
