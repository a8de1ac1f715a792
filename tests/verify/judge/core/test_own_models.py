"""Models of a source's own, with symbols in their matrices."""

from __future__ import annotations

import pytest
from small_claims import check, judged

from gainproof.verify.judge.claim.errors import ClaimFileError

MODEL = """kind = 'steady_state'
transition = {0}
process_noise = {1}
measurement = {2}
measurement_noise = [['{3}']]
"""
WHITE = MODEL.format(
    "[['1', 'T'], ['0', '1']]",
    r"[['\frac{q T^3}{3}', '\frac{q T^2}{2}'], ['\frac{q T^2}{2}', 'q T']]",
    "[['1', '0']]",
    "r",
)
KNOWN = {
    "T": "{ quantity = 'sampling_interval', meaning = 'interval' }",
    "q": "{ unit = 'm^2 s^-3', domain = 'q > 0', meaning = 'density' }",
    "r": "{ unit = 'm^2', domain = 'r > 0', meaning = 'variance' }",
    r"\alpha": "{ quantity = 'filter_gain.1', meaning = 'gain' }",
    r"\beta": "{ quantity = 'filter_gain.2', meaning = 'gain' }",
    "P": "{ quantity = 'predicted_covariance.1.1', meaning = 'variance' }",
    "S": "{ quantity = 'innovation_variance', meaning = 'variance' }",
}
ONE = {
    "q": "{ unit = 'm^2', domain = 'q > 0', meaning = 'variance of the steps' }",
    "r": KNOWN["r"],
    "w": "{ unit = 'm', domain = 'w > 0', meaning = 'deviation of the steps' }",
    "v": "{ unit = 'm', domain = 'v > 0', meaning = 'deviation' }",
    "K": "{ quantity = 'filter_gain.1', meaning = 'gain' }",
    "P": KNOWN["P"],
}


def walk(noise: str, measured: str, transition: str = "1") -> str:
    return MODEL.format(f"[['{transition}']]", f"[['{noise}']]", "[['1']]", measured)


@pytest.mark.parametrize(
    ("kind", "fields", "wanted"),
    [
        ("identity", r"\frac{\beta^2}{1 - \alpha} = \frac{q T^3}{r}", "proved"),
        ("identity", r"\frac{\beta^2}{1 - \alpha} = \frac{q T^2}{r} T \alpha", "refuted"),
        ("identity", "S = P + r", "proved"),
        ("inequality", r"\alpha < 1", "proved"),
        ("limit", r"\lim_{q \to 0} \alpha = 0", "proved"),
        ("limit", r"\lim_{q \to \infty} \alpha = \frac{1}{2}", "refuted"),
        ("monotone", "about = ['\\alpha', 'q']\ntrend = 'increasing'\ntext = 't'", "proved"),
        ("monotone", "about = ['\\alpha', 'q']\ntrend = 'decreasing'\ntext = 't'", "refuted"),
        # the index changes with T and r too, while the gains are formulas of the index alone; with
        # T it does so that the intensity stays
        ("identity", r"\frac{\partial \alpha}{\partial T} = 0", "refuted"),
        (
            "identity",
            r"\frac{\partial}{\partial T} \frac{\beta^2}{1 - \alpha} = \frac{3 q T^2}{r}",
            "proved",
        ),
        ("identity", r"\frac{\partial q}{\partial T} = 0", "proved"),
        ("monotone", "about = ['\\alpha', 'T']\ntrend = 'increasing'\ntext = 't'", "proved"),
        ("monotone", "about = ['\\alpha', 'T']\ntrend = 'nonincreasing'\ntext = 't'", "refuted"),
        ("identity", r"\frac{\partial \alpha}{\partial r} = 0", "undecided"),
        ("limit", r"\lim_{T \to 0} \alpha = \alpha", "undecided"),
    ],
)
def test_white_acceleration(kind: str, fields: str, wanted: str) -> None:
    check(judged(kind, fields, KNOWN, WHITE), wanted)


@pytest.mark.parametrize(
    ("noise", "measured", "latex", "wanted"),
    [
        ("q", "r", r"P = \frac{q + \sqrt{q^2 + 4 q r}}{2}", "proved"),
        ("q", "r", r"P = \frac{-q + \sqrt{q^2 + 4 q r}}{2}", "refuted"),
        ("q", "r", r"K = \frac{P}{P + r}", "proved"),
        ("w^2", "v^2", r"K = \frac{w^2}{2 v^2} (\sqrt{1 + \frac{4 v^2}{w^2}} - 1)", "proved"),
        ("w^2", "v^2", r"K = \frac{w}{v + w}", "refuted"),
        ("1", "r", "K = 1", "refuted"),
        # the ratio of the noises is a number
        ("r", "r", r"K = \frac{\sqrt{5} - 1}{2}", "proved"),
        ("r", "r", r"K = \frac{\sqrt{5} - 1}{3}", "refuted"),
        ("v^2", "v^2", r"P = \frac{1 + \sqrt{5}}{2} v^2", "proved"),
        ("4 v^2", "v^2", r"P = (2 + 2\sqrt{2}) v^2", "proved"),
        ("4 v^2", "v^2", r"P = (2 + \sqrt{2}) v^2", "refuted"),
    ],
)  # fmt: skip
def test_random_walk(noise: str, measured: str, latex: str, wanted: str) -> None:
    check(judged("identity", latex, ONE, walk(noise, measured)), wanted)


def test_matrices_that_do_not_scale_are_named() -> None:
    found = judged("identity", "K = 1", ONE, walk("q", "w^2", r"\frac{v}{w}"))
    check(found, "undecided")
    assert "transition of the model" in found.reason


def test_states_are_moved_by_the_model_itself() -> None:
    symbols = {
        "z": "{ quantity = 'measurement', meaning = 'measured' }",
        "x": "{ quantity = 'previous_state.1', meaning = 'state before' }",
        "p": "{ quantity = 'predicted_state.1', meaning = 'predicted' }",
    }
    setting = walk("1", "1", r"\frac{1}{2}")
    check(judged("identity", r"p = \frac{x}{2}", symbols, setting), "proved")
    check(judged("identity", "p = x", symbols, setting), "refuted")


INDEX = {
    "T": KNOWN["T"],
    "w": "{ unit = 'm s^-1', domain = 'w > 0', meaning = 'deviation of the increments' }",
    "v": "{ quantity = 'measurement_noise_deviation', meaning = 'deviation' }",
    r"\alpha": KNOWN[r"\alpha"],
    r"\beta": KNOWN[r"\beta"],
    r"\Lambda": "{ quantity = 'tracking_index', meaning = 'index' }",
}
FADING = (
    "[['1', '0.953 T'], ['0', '0.917']]",
    ("[['0.318 w^2 T^2', '0.477 w^2 T'], ['0.477 w^2 T', '0.982 w^2']]"),
)
THIRD = "[['1', 'T'], ['0', '1']]", "[['w^2 T^2/12', 'w^2 T/6'], ['w^2 T/6', 'w^2/3']]"


@pytest.mark.parametrize(
    ("matrices", "formula", "wanted"),
    [
        (FADING, r"\Lambda^2 = \frac{T^2 w^2}{v^2}", "proved"),
        (FADING, r"\Lambda^2 = 0.982 \frac{T^2 w^2}{v^2}", "refuted"),
        (THIRD, r"\Lambda^2 = \frac{T^2 w^2}{v^2}", "proved"),
        (THIRD, r"\Lambda^2 = \frac{T^2 w^2}{3 v^2}", "refuted"),
        # by hand: beta^2/(1 - alpha) is the numerator of the spectrum at zero frequency
        (THIRD, r"\frac{\beta^2}{1 - \alpha} = \frac{T^2 w^2}{3 v^2}", "proved"),
        (THIRD, r"\frac{\beta^2}{1 - \alpha} = \frac{\Lambda^2}{3}", "proved"),
    ],
)
def test_the_index_is_the_strength_whatever_numbers_stand_behind_it(
    matrices: tuple[str, str], formula: str, wanted: str
) -> None:
    """As in a user's own model that is derived."""
    setting = MODEL.format(*matrices, "[['1', '0']]", "v^2")
    check(judged("identity", formula, INDEX, setting), wanted)


GAIN = KNOWN | {"K": r"{ definition = '\frac{\beta}{T}', meaning = 'gain in its unit' }"}


@pytest.mark.parametrize(
    ("latex", "more", "wanted"),
    [
        (r"K = \beta", "domain = 'T = 1'", "proved"),
        (r"K = \beta", "given = ['1 = T']", "proved"),
        (r"K = \beta \quad (T = 1)", "", "proved"),
        (r"K = \frac{\beta}{2}", "domain = 'T = 2'", "proved"),
        (r"K = 2 \beta", "domain = 'T = 2'", "refuted"),
        (r"\frac{K^2}{1 - \alpha} = q", "domain = 'T = 1, r = 1'", "proved"),
        (r"\frac{K^2}{1 - \alpha} = q", "domain = 'T = 1'", "refuted"),
        (r"K = \beta", "domain = 'T > 1'", "refused"),
        (r"K = \beta", "", "refuted"),
        (r"K = P", "domain = 'T = 1'", "refuted"),
    ],
)
def test_units_in_which_the_interval_is_one(latex: str, more: str, wanted: str) -> None:
    if wanted == "refused":
        with pytest.raises(ClaimFileError, match="dimensions"):
            judged("identity", f"latex = '{latex}'\n{more}", GAIN, WHITE)
        return
    found = judged("identity", f"latex = '{latex}'\n{more}", GAIN, WHITE)
    assert found.verdict == wanted, found.reason


@pytest.mark.parametrize(
    ("kind", "latex", "wanted"),
    [
        ("implication", r"T = 1 \Rightarrow K = \beta", "proved"),
        ("implication", r"1 = T \Rightarrow 0 < K < 2", "proved"),
        ("implication", r"T = 2 \Rightarrow K = \frac{\beta}{2}", "proved"),
        ("implication", r"T = 2 \Rightarrow K = \beta", "refuted"),
        ("implication", r"T = 1 \Rightarrow K = P", "refuted"),
        ("implication", r"T > 1 \Rightarrow K < \beta", "refuted"),
        ("equivalence", r"T = 1 \Leftrightarrow K = \beta", "proved"),
        ("equivalence", r"K = \beta \Leftrightarrow T = 1", "proved"),
        ("identity", "T = 1", "refuted"),
    ],
)
def test_a_premise_says_units_too(kind: str, latex: str, wanted: str) -> None:
    found = judged(kind, f"latex = '{latex}'", GAIN, WHITE)
    assert found.verdict == wanted, found.reason
