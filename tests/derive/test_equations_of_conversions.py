"""What conversions say of themselves: each formula of a docstring is what the kernel computes."""

from __future__ import annotations

import re

import numpy as np
import pytest
import sympy as sp
from docstring_formulas import DIGITS, Text, Values, drawn, exact, expression, near, value

from gainproof.derive.pages.kernel_page import kernel_words
from gainproof.derive.sensors.converted_measurements import FORMULAS, graphs
from gainproof.generated import converted_measurements

WORDS = kernel_words(FORMULAS)
EQUATIONS = {name: WORDS.of(name).equations for name in graphs()}
PLANE = {
    "classical_conversion_in_plane": ("the variance ", "across it "),
    "debiased_conversion_in_plane": (),
    "unbiased_conversion_in_plane": ("along ", "across "),
    "modified_unbiased_conversion_in_plane": ("the variance ", "across it "),
}


def polar(seed: int) -> dict[str, float]:
    """A range, an azimuth and deviations; of an elevation too, and a correlation."""
    r, sr = drawn(seed, 1, 5, 2)
    e, a, se, sa, correlation = np.random.default_rng(seed).uniform(0.1, 0.9, 5)
    angles = {"e": e, "a": a, "se": se, "sa": sa, "correlation": correlation}
    return {"r": r, "sr": sr} | {name: float(each) for name, each in angles.items()}


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("name", PLANE)
def test_conversions_in_the_plane(name: str, seed: int) -> None:
    text = Text(EQUATIONS[name])
    given = polar(seed)
    known = exact(**given)
    if "k = " in text.text:
        known["k"] = value(text.formula("k = "), known)
    place = text.formula("x = ")
    wanted = {"x": value(place, known), "y": value(place.replace("cos a", "sin a"), known)}
    if "y = " in text.text:
        assert text.formula("y = ") == place.replace("cos a", "sin a")
    for output, start in zip(("radial_variance", "cross_variance"), PLANE[name], strict=False):
        wanted[output] = value(text.formula(start), known)
    assert text.everything_is_read()
    inputs = [given[each] for each in ("r", "a", "sr", "sa")]
    near(getattr(converted_measurements, name)(*inputs), wanted)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("name", [each.removesuffix("_in_plane") for each in PLANE])
def test_conversions_in_space(name: str, seed: int) -> None:
    text = Text(EQUATIONS[name])
    given = polar(seed)
    known = exact(**given)
    if "ke = " in text.text:
        known["ke"] = value(text.formula("ke = "), known)
        known["k"] = value(text.formula(", k = "), known)
    place = text.formula("x = ")
    formulas = {"x": place, "y": place.replace("cos a", "sin a"), "z": text.formula("z = ")}
    wanted = {axis: value(formula, known) for axis, formula in formulas.items()}
    if "y = " in text.text:
        assert text.formula("y = ") == formulas["y"]
        wanted |= _first_order(text, formulas, known)
    assert text.everything_is_read()
    inputs = [given[each] for each in ("r", "e", "a", "sr", "se", "sa")]
    near(getattr(converted_measurements, name)(*inputs), wanted)


def _first_order(text: Text, formulas: dict[str, str], known: Values) -> Values:
    """J D J', with D as the text has it."""
    assert text.formula("D = ") == "diag(sr^2"
    inside = re.search(r"D = diag\((.*?)\)", text.text)
    assert inside is not None
    squares = [expression(each, known) for each in inside[1].split(", ")]
    rows = {axis: expression(formula, known) for axis, formula in formulas.items()}
    letters = [sp.Symbol(each) for each in "rea"]
    return {
        f"covariance_{pair}": sp.Add(
            *(
                rows[pair[0]].diff(x) * rows[pair[1]].diff(x) * square
                for x, square in zip(letters, squares, strict=True)
            )
        ).evalf(DIGITS, subs=known)
        for pair in ("xx", "xy", "xz", "yy", "yz", "zz")
    }


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("name", [each for each in EQUATIONS if "correl" in each])
def test_conversions_of_correlated_noises(name: str, seed: int) -> None:
    text = Text(EQUATIONS[name])
    given = polar(seed)
    known = exact(**given)
    known["k"] = value(text.formula(" k = "), known)
    known["c"] = value(text.formula(" c = "), known)
    assert text.everything_is_read()
    pair = re.search(r": \(([^,]*), ([^)]*)\) along and across", text.text)
    assert pair is not None
    along, across = (value(each, known) for each in pair.groups())
    cosine, sine = sp.cos(known["a"]), sp.sin(known["a"])
    wanted = {"x": along * cosine - across * sine, "y": along * sine + across * cosine}
    inputs = [given[each] for each in ("r", "a", "sr", "sa", "correlation")]
    near(getattr(converted_measurements, name)(*inputs), wanted)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize(
    ("name", "start"),
    [
        ("classical_conversion_in_plane", "given the truth by "),
        ("debiased_conversion_in_plane", "given the truth is "),
    ],
)
def test_what_is_said_of_the_bias(name: str, start: str, seed: int) -> None:
    """The mean of cos(a) at a noisy azimuth is exp(-sa^2/2) times that at the true one."""
    text = Text(EQUATIONS[name])
    known = exact(**polar(seed))
    known["k"] = sp.exp(-(known["sa"] ** 2) / 2)
    place = value(text.formula("x = "), known) / known["r"] / sp.cos(known["a"])
    said = value(text.formula(start), known)
    assert float(place * known["k"] - 1) == pytest.approx(float(said), rel=1e-12)


@pytest.mark.parametrize("seed", range(4))
def test_where_the_classical_covariance_is_too_small(seed: int) -> None:
    """What misses is a positive factor times the difference of both sides, by the exact one."""
    text = Text(EQUATIONS["classical_conversion_in_plane"])
    exactly = Text(EQUATIONS["modified_unbiased_conversion_in_plane"])
    known = exact(**polar(seed))
    left, right = (value(text.formula(start).strip(), known) for start in ("where ", "> "))
    known["k"] = value(exactly.formula("k = "), known)
    variance = value(exactly.formula("the variance "), known)
    stated = value(text.formula("the variance "), known)
    wanted = (1 - known["k"] ** 4) / 2 * (left - right)
    assert float(variance - stated) == pytest.approx(float(wanted), rel=1e-12)


def test_every_kernel_is_read() -> None:
    uncorrelated = {*PLANE, *(each.removesuffix("_in_plane") for each in PLANE)}
    assert {each for each in EQUATIONS if "correl" not in each} == uncorrelated
