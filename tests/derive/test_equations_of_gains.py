"""What kernels of updated gains say of themselves: each formula is what the kernel computes."""

from __future__ import annotations

import numpy as np
import pytest
from docstring_formulas import Text, Values, drawn, exact, near, value

from gainproof.derive.pages.kernel_page import kernel_words
from gainproof.derive.updated_gains.subject import FORMULAS
from gainproof.generated import updated_gains

EQUATIONS = {name: told.equations for name, told in kernel_words(FORMULAS).own.items()}
GAINS: dict[str, dict[str, str]] = {
    "first_order_gains": {"alpha": ": alpha = ", "beta": "beta = "},
    "first_order_errors": {
        "alpha_excess_over_square": "alpha: ",
        "beta_excess_over_square": "beta: ",
    },
    "cycle_drift": {"alpha_drift_over_square": "alpha: ", "beta_drift_over_square": "beta: "},
    "mismatch_variances": {
        name: f"{name} = " for name in ("predicted_11", "updated_11", "updated_22", "predicted_22")
    },
}


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("name", GAINS)
def test_gains_of_two_indices(name: str, seed: int) -> None:
    text = Text(EQUATIONS[name])
    nominal, index = drawn(seed, -2, 2, 2)
    known = exact(L=nominal, Lambda=index)
    root = text.formula("n = ")
    known["n"] = value(root, known)
    known["e"] = value(root, {"L": known["Lambda"]})
    for letter in "bc":
        if f" {letter} = " in text.text:
            known[letter] = value(text.formula(f" {letter} = "), known)
    wanted: Values = {}
    for output, start in GAINS[name].items():
        wanted[output] = value(text.formula(start), known | wanted)
    assert text.everything_is_read()
    near(getattr(updated_gains, name)(nominal, index), wanted)


@pytest.mark.parametrize("seed", range(5))
def test_the_index_of_an_axis(seed: int) -> None:
    text = Text(EQUATIONS["tracking_index"])
    given = drawn(seed, -1, 2, 3)
    known = exact(**dict(zip(("sigma_w", "T", "R"), given, strict=True)))
    wanted = value(text.formula("Lambda = "), known)
    assert text.everything_is_read()
    near(updated_gains.tracking_index(*given), {"tracking_index": wanted})


@pytest.mark.parametrize("seed", range(5))
def test_recursive_gains(seed: int) -> None:
    text = Text(EQUATIONS["recursive_gains"])
    given = drawn(seed, -1, 1, 4)
    known = exact(**dict(zip(("alpha", "beta", "Lambda", "next_index"), given, strict=True)))
    known["e"] = value(text.formula(" e = "), known)
    for gain in ("alpha", "beta"):
        known[f"{gain}_slope"] = value(text.formula(f"{gain}' = "), known)
    rule = text.formula("next_alpha = ")
    assert text.everything_is_read()
    wanted = {
        "next_alpha": value(rule, known),
        "next_beta": value(rule.replace("alpha", "beta"), known),
    }
    near(updated_gains.recursive_gains(*given), wanted)


@pytest.mark.parametrize("seed", range(5))
def test_limits_of_the_update(seed: int) -> None:
    text = Text(EQUATIONS["update_limits"])
    (nominal,) = drawn(seed, -2, 2, 1)
    known = exact(L=nominal)
    known["n"] = value(text.formula("n = "), known)
    wanted = {
        name: value(text.formula(f"{name} = "), known)
        for name in ("alpha_one_ratio", "unstable_ratio", "variance_ratio")
    }
    index = text.formula(" Lambda = ")
    for gain, letter, start in (
        ("alpha", "s", "alpha_gain_ratio: Lambda/L at e = "),
        ("beta", "u", "beta_gain_ratio: at e = "),
    ):
        known[letter] = value(text.formula(f" {letter} = "), known)
        place = {"e": value(text.formula(start), known)}
        wanted[f"{gain}_gain_ratio"] = value(index, place) / known["L"]
    found = updated_gains.update_limits(nominal)
    near(found, wanted)
    ratio = wanted["variance_ratio"]
    described = value(text.formula("c - 1/c = "), known)
    assert float(ratio - 1 / ratio) == pytest.approx(float(described), rel=1e-12)
    assert text.everything_is_read()


@pytest.mark.parametrize("seed", range(5))
def test_gains_along_the_line_of_sight(seed: int) -> None:
    text = Text(EQUATIONS["line_of_sight_gains"])
    along, across, angle = drawn(seed, -1, 0.4, 3)
    given = {"along": along, "across": across, "cosine": np.cos(angle), "sine": np.sin(angle)}
    known = exact(**{name: float(each) for name, each in given.items()})
    names = ("gain_xx", "gain_xy", "gain_yy")
    wanted = {name: value(text.formula(f"{name} = "), known) for name in names}
    assert text.everything_is_read()
    near(updated_gains.line_of_sight_gains(**given), wanted)


def test_every_kernel_is_read() -> None:
    gains = {*GAINS, "tracking_index", "recursive_gains", "update_limits", "line_of_sight_gains"}
    assert set(EQUATIONS) == gains


def test_a_slip_is_seen(monkeypatch: pytest.MonkeyPatch) -> None:
    changed = tuple(
        each.replace("(1 + n)^2)/(2 + n)", "(1 + n)^2)/(3 + n)")
        for each in EQUATIONS["mismatch_variances"]
    )
    assert changed != EQUATIONS["mismatch_variances"]
    monkeypatch.setitem(EQUATIONS, "mismatch_variances", changed)
    with pytest.raises(AssertionError, match="predicted_11"):
        test_gains_of_two_indices("mismatch_variances", 0)
