"""Derivatives, trends and limits in T or the deviation of the noise: the tracking index is made of
both, so that a claim has to say what stays.

With r = sqrt(1 - alpha) constant acceleration has beta = 2 (1 - r)^2 and index 2 (1 - r)^2 / r, so
that beta has the slope 2 r^2 / (1 + r) with the index.
"""

from __future__ import annotations

import pytest
from claim_texts import MODELS
from small_claims import check, judged

from gainproof.verify.judge.claim.errors import ClaimFileError

STEADY = "kind = 'steady_state'\nmodel = 'random-acceleration'\ngain = 'filter'"
SYMBOLS = {
    name: f"{{ quantity = '{quantity}', meaning = 'm' }}"
    for name, quantity in (
        ("T", "sampling_interval"),
        ("s", "measurement_noise_deviation"),
        ("L", "tracking_index"),
        ("a", "filter_gain.1"),
        ("b", "filter_gain.2"),
        ("P", "predicted_covariance.1.1"),
        ("x", "predicted_state.1"),
        ("u", "updated_state.1"),
        ("v", "previous_state.2"),
        ("y", "measurement"),
    )
} | {
    "w": r"{ definition = '\frac{L s}{T^2}', meaning = 'deviation of the acceleration' }",
    "g": r"{ definition = '\frac{b}{T}', meaning = 'gain of the velocity' }",
    "f": r"{ definition = '\frac{1}{T}', meaning = 'sampling rate' }",
    "q": r"{ definition = 'L + \frac{T f}{2}', meaning = 'no product' }",
}
SLOPE = r"\frac{\partial b}{\partial T} = \frac{4 L (1 - a)}{T (1 + \sqrt{1 - a})}"


def _trend(subject: str, variable: str, trend: str) -> str:
    return f"about = ['{subject}', '{variable}']\ntrend = '{trend}'"


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kind", "claim", "held", "wanted"),
    [
        ("identity", r"\frac{\partial P}{\partial T} = 0", "", "undecided"),
        ("identity", r"\frac{\partial P}{\partial T} = 0", "L", "proved"),
        ("identity", r"\frac{\partial P}{\partial T} = 0", "a", "proved"),
        ("identity", r"\frac{\partial P}{\partial T} = 0", "w", "refuted"),
        ("identity", SLOPE, "w", "proved"),
        ("identity", SLOPE, "L", "refuted"),
        ("identity", SLOPE, "", "undecided"),
        ("identity", r"\frac{\partial L}{\partial T} = \frac{2 L}{T}", "w", "proved"),
        ("identity", r"\frac{\partial L}{\partial s} = -\frac{L}{s}", "w", "proved"),
        ("identity", r"\frac{\partial P}{\partial s} = \frac{2 P}{s}", "", "undecided"),
        ("identity", r"\frac{\partial P}{\partial s} = \frac{2 P}{s}", "L", "proved"),
        ("identity", r"\frac{\partial P}{\partial s} = \frac{2 P}{s}", "w", "refuted"),
        ("identity", r"\frac{\partial^2 L}{\partial T^2} = \frac{2 L}{T^2}", "w", "proved"),
        ("identity", r"\frac{\partial w}{\partial T} = 0", "w", "proved"),
        ("identity", r"\frac{\partial w}{\partial T} = 0", "L", "refuted"),
        # two that fix the index, one that the variable changes
        ("identity", r"\frac{\partial P}{\partial T} = 0", "L', 'w", "undecided"),
        ("identity", r"\frac{\partial P}{\partial T} = 0", "f", "undecided"),
        ("identity", r"\frac{\partial P}{\partial T} = 0", "s", "undecided"),
        # nothing here depends on the index
        ("identity", r"\frac{\partial x}{\partial T} = v", "", "proved"),
        ("identity", r"\frac{\partial u}{\partial y} = a", "", "proved"),
        ("monotone", _trend("g", "T", "decreasing"), "", "undecided"),
        ("monotone", _trend("g", "T", "decreasing"), "L", "proved"),
        ("monotone", _trend("g", "T", "decreasing"), "w", "conditional"),
        ("monotone", _trend("a", "T", "increasing"), "w", "proved"),
        ("monotone", _trend("a", "T", "decreasing"), "w", "refuted"),
        ("monotone", _trend("a", "s", "decreasing"), "w", "proved"),
        ("monotone", _trend("a", "T", "increasing"), "q", "undecided"),
        ("monotone", _trend("a", "T", "increasing") + "\ndomain = '(L-1)(L-2) > 0'", "w",
         "undecided"),
        ("limit", r"g \to 0 \quad (T \to \infty)", "", "undecided"),
        ("limit", r"g \to 0 \quad (T \to \infty)", "L", "proved"),
        ("limit", r"g \to 0 \quad (T \to \infty)", "w", "undecided"),
        ("limit", r"g \to 0 \quad (f \to 0)", "", "undecided"),
        ("limit", r"g \to 0 \quad (f \to 0)", "L", "proved"),
        ("asymptotics", r"P \sim s^2 \frac{a}{1 - a} \quad (s \to 0)", "", "undecided"),
        ("value", r"a \approx 0.75 \quad (L = 1)", "", "proved"),
    ],
)  # fmt: skip
def test_a_claim_says_what_stays(kind: str, claim: str, held: str, wanted: str) -> None:
    fields = claim if " = ['" in claim else f"latex = '{claim}'"
    fields += f"\nheld = ['{held}']" if held else ""
    check(judged(kind, fields, SYMBOLS, STEADY, MODELS), wanted)


def test_what_stays_is_a_declared_symbol() -> None:
    with pytest.raises(ClaimFileError, match="held"):
        judged("identity", "latex = 'a = a'\nheld = ['z']", SYMBOLS, STEADY, MODELS)


def test_where_the_index_is_no_part_it_need_not_stay() -> None:
    fit = "kind = 'growing_memory'\ndegree = 1\ngain = 'filter'"
    kept = {n: SYMBOLS[n] for n in ("T", "s", "P")} | {
        "k": "{ quantity = 'sample_number', meaning = 'm' }"
    }
    claim = r"\frac{\partial P}{\partial s} = \frac{2 P}{s} \quad (k \ge 2)"
    check(judged("identity", claim, kept, fit), "proved")
