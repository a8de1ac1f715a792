"""Domains and witnesses are told in symbols that a source has, and the sets stay the same."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from claim_texts import claim_file
from one_of_each import further
from scipy.linalg import solve_discrete_are

from gainproof.verify.judge.exact.algebraic_numbers import Algebraic, rational_point
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, power, sqrt, symbol
from gainproof.verify.judge.exact.images import image, images
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.exact.region_text import region_text
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.verdict import ClaimVerdict

x = symbol("x")
SOLVED: dict[Any, Environment] = {}
WIENER = {
    "name": "wiener-acceleration",
    "transition": [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]],
    "process_noise": [["1/4", "1/2", "1/2"], ["1/2", "1", "1"], ["1/2", "1", "1"]],
    "measurement": [["1", "0", "0"]],
    "measurement_noise": [["1"]],
}
JERK = {
    **WIENER,
    "name": "random-jerk",
    "process_noise": [["1/36", "1/12", "1/6"], ["1/12", "1/4", "1/2"], ["1/6", "1/2", "1"]],
}
RANDOM_VELOCITY = {
    "name": "random-velocity",
    "transition": [["1", "1"], ["0", "1"]],
    "process_noise": [["0", "0"], ["0", "1"]],
    "measurement": [["1", "0"]],
    "measurement_noise": [["1"]],
}
MODELS = (WIENER, JERK, RANDOM_VELOCITY)


def first_gain(model: Mapping[str, Any], strength: float) -> float:
    """By SciPy, T = 1 and measurement noise 1; the process noise is strength times that given."""
    f, q, h = (
        np.array([[float(Fraction(e)) for e in row] for row in model[name]])
        for name in ("transition", "process_noise", "measurement")
    )
    predicted = solve_discrete_are(f.T, h.T, strength * q, np.eye(1))
    return float(predicted[0, 0] / (predicted[0, 0] + 1))


def judged(model: str, symbols: str, kind: str, latex: str, more: str = "") -> ClaimVerdict:
    setting = f"""
[settings.s]
title = 's'
kind = 'steady_state'
{model}
[settings.s.symbols]
'a' = {{ quantity = "filter_gain.1", meaning = "gain" }}
'b' = {{ quantity = "filter_gain.2", meaning = "gain" }}
{symbols}
"""
    (found,) = judge_file(claim_file(setting, [(kind, latex)], more), MODELS, solved=SOLVED)
    return found


INDEX = "'L' = { quantity = 'tracking_index', meaning = 'index' }"


@pytest.mark.parametrize("model", MODELS, ids=lambda model: str(model["name"]))
@pytest.mark.parametrize("bound", [further("8/9"), "3/4", further("1/3")])
def test_where_a_gain_is_below_a_bound(model: Mapping[str, Any], bound: str) -> None:
    top, bottom = bound.split("/")
    latex = rf"a < \frac{{{top}}}{{{bottom}}}"
    found = judged(f"model = '{model['name']}'", INDEX, "inequality", latex)
    assert found.verdict == "conditional", found.reason
    assert found.domain is not None
    end = re.fullmatch(r"for 0 < L < (.*)", found.domain)
    assert end is not None, found.domain
    value = number_in(end[1])
    assert first_gain(model, value**2) == pytest.approx(float(Fraction(bound)), rel=1e-6)
    assert found.witness is not None
    (name, at), *others = found.witness["point"].items()
    assert (name, others) == ("L", [])
    assert float(found.witness["left"]["midpoint"]) == pytest.approx(
        first_gain(model, number_in(at) ** 2), rel=1e-6
    )
    assert found.domain in found.reason


def number_in(text: str) -> float:
    """What is told of an end, `3/2 - 1/4*sqrt(5)` or a root with its digits, as a number."""
    near = re.fullmatch(r"the root of .* near (\S+)", text)
    if near:
        return float(near[1])
    total = 0.0
    for part in text.replace(" - ", " + -").split(" + "):
        factor, _, root = part.partition("sqrt")
        size = factor.rstrip("*")
        size = f"{size}1" if size in ("", "-") else size
        total += float(Fraction(size)) * math.sqrt(float(root.strip("()") or 1))
    return total


@pytest.mark.parametrize(
    ("kind", "latex", "domain"),
    [
        ("inequality", r"a < \frac{3}{4}", "for 0 < q < 81/100"),
        further("inequality", r"a \geq \frac{3}{4}", "for q >= 81/100"),
        ("inequality", r"(a - \frac{3}{4})^2 > 0", "for 0 < q < 81/100 or q > 81/100"),
        ("inequality", r"a + b > 0", "for q > 0"),
    ],
)
def test_the_one_free_number_of_a_model(kind: str, latex: str, domain: str) -> None:
    """K_1 = 3/4 at q = K_1^4 / ((2 - K_1)^2 (1 - K_1)) = 81/100, by hand and by SciPy."""
    assert first_gain(RANDOM_VELOCITY, 0.81) == pytest.approx(0.75, rel=1e-9)
    matrices = (
        "transition = [['1', '1'], ['0', '1']]\nprocess_noise = [['0', '0'], ['0', 'q']]\n"
        "measurement = [['1', '0']]\nmeasurement_noise = [['1']]"
    )
    free = "'q' = { unit = '1', domain = 'q > 0', meaning = 'strength' }"
    found = judged(matrices, free, kind, latex)
    assert found.domain == domain, found.reason
    if found.verdict == "conditional":
        assert found.witness is not None
        assert set(found.witness["point"]) == {"q"}


NOISES = {
    "q T^3/r": ("[['q T^3/3', 'q T^2/2'], ['q T^2/2', 'q T']]", "[['r']]", "m^2/s^3"),
    "q T^2/r": ("[['0', '0'], ['0', 'q']]", "[['r']]", "m^2/s^2"),
    "q T^2/s": ("[['q^2 T^4/4', 'q^2 T^3/2'], ['q^2 T^3/2', 'q^2 T^2']]", "[['s^2']]", "m/s^2"),
}
UNITS_OF = {"r": "m^2", "s": "m"}


@pytest.mark.parametrize("words", NOISES)
def test_one_strength_in_units(words: str) -> None:
    """The bound and the witness are those of SciPy, with T and the noise put in as numbers."""
    noise, measured, unit = NOISES[words]
    letter = words[-1]
    matrices = (
        f"transition = [['1', 'T'], ['0', '1']]\nprocess_noise = {noise}\n"
        f"measurement = [['1', '0']]\nmeasurement_noise = {measured}"
    )
    symbols = f"""
'T' = {{ quantity = "sampling_interval", meaning = "interval" }}
'q' = {{ unit = "{unit}", domain = 'q > 0', meaning = 'strength' }}
'{letter}' = {{ unit = "{UNITS_OF[letter]}", domain = '{letter} > 0', meaning = 'noise' }}
"""
    found = judged(matrices, symbols, "inequality", r"a < \frac{3}{4}")
    assert found.verdict == "conditional", found.reason
    end = re.fullmatch(rf"for 0 < {re.escape(words)} < (.*)", found.domain or "")
    assert end is not None, found.domain
    entries = [re.sub(r"T(\^\d)?", "1", e) for e in re.findall(r"'([^']*)'", noise)]

    def gain(q: float) -> float:
        numbers = [_entry(e, q) for e in entries]
        model = np.array(numbers).reshape(2, 2)
        f, h = np.array([[1.0, 1.0], [0.0, 1.0]]), np.array([[1.0, 0.0]])
        predicted = solve_discrete_are(f.T, h.T, model, np.eye(1))
        return float(predicted[0, 0] / (predicted[0, 0] + 1))

    assert gain(number_in(end[1])) == pytest.approx(0.75, rel=1e-6)
    assert found.witness is not None
    point = {name: number_in(text) for name, text in found.witness["point"].items()}
    assert set(point) == {"q", "T", letter}
    assert (point["T"], point[letter]) == (1.0, 1.0)
    assert float(found.witness["left"]["midpoint"]) == pytest.approx(gain(point["q"]), rel=1e-6)


def _entry(text: str, q: float) -> float:
    """`q^2 1/4` as a number."""
    if text == "0":
        return 0.0
    _, _, below = text.partition("/")
    return q ** (2 if "q^2" in text else 1) / float(below or 1)


@pytest.mark.parametrize("noise", ["deviation", "variance"])
def test_a_variance_is_no_name_for_its_deviation(noise: str) -> None:
    fields = f"model = 'random-velocity'\nnoise = '{noise}'"
    found = judged(fields, INDEX, "inequality", r"a < \frac{3}{4}")
    assert (
        found.domain == {"deviation": "for 0 < L < 9/10", "variance": "for 0 < L < 81/100"}[noise]
    )


ROOT_TWO = Algebraic((-2, 0, 1), Fraction(1), Fraction(2))
ROOT_OF_CUBIC = Algebraic((-1, 12, 6, 1), Fraction(0), Fraction(1))


@pytest.mark.parametrize("at", [ROOT_TWO, ROOT_OF_CUBIC, rational_point(Fraction(3, 7))])
@pytest.mark.parametrize(
    "expr",
    [
        power(x, 2),
        1 / x,
        2 * power(1 - x, 3) / (x * (1 + x)),
        sqrt(1 + power(x, 2)),
        x + sqrt(x),
        16 * x / sqrt(4 * power(x, 2) + x + 5),
    ],
)
def test_images_of_numbers(expr: Expr, at: Algebraic) -> None:
    found = image(expr, "x", at).refined(Fraction(1, 1 << 60))
    value = float(at.refined(Fraction(1, 1 << 60)).low)
    assert float(found.low) == pytest.approx(_evaluated(expr, value), rel=1e-12)


def _evaluated(expr: Expr, value: float) -> float:
    """In floats, along the tree."""
    parts = [_evaluated(part, value) for part in expr.parts]
    match expr.kind:
        case "number":
            return float(expr.fraction)
        case "symbol":
            return value
        case "add":
            return math.fsum(parts)
        case "mul":
            return math.prod(parts)
        case "neg":
            return -parts[0]
        case "div":
            return parts[0] / parts[1]
        case _:
            return float(parts[0] ** float(expr.fraction))


ONE, TWO = rational_point(Fraction(1)), rational_point(Fraction(2))
POSITIVE = Box(lower=Fraction(0))
ZERO = rational_point(Fraction(0))


@pytest.mark.parametrize(
    ("expr", "kept", "wanted"),
    [
        (power(x, 2), [Place(left=ZERO, right=ROOT_TWO, is_cell=True)], "0 < y < 2"),
        (1 / x, [Place(left=ZERO, right=TWO, is_cell=True), Place(at=TWO)], "y >= 1/2"),
        (1 / x, [Place(at=ONE), Place(left=ONE, is_cell=True)], "0 < y <= 1"),
        (1 / x, [Place(at=ONE), Place(at=TWO)], "y = 1/2 or y = 1"),
        (x + number(1), [Place(left=ZERO, right=ONE, is_cell=True)], None),
        (power(x - 1, 2), [Place(left=ZERO, right=ONE, is_cell=True)], None),
    ],
)
def test_images_of_sets(expr: Expr, kept: list[Place], wanted: str | None) -> None:
    if wanted is None and expr.kind == "add":
        with pytest.raises(Undecided, match="neither 0 nor infinite"):
            images(expr, "x", POSITIVE, kept)
        return
    found = images(expr, "x", POSITIVE, kept)
    assert (None if found is None else region_text(found, "y")) == wanted


TWO_RATIOS = r"""
[settings.s]
title = 's'
kind = 'steady_state'
transition = [["1", "T"], ["0", "1"]]
process_noise = [['q^2 T^4/3', 'q^2 T^3/2'], ['q^2 T^3/2', 'q^2 T^2']]
measurement = [["1", "0"], ["0", "1"]]
measurement_noise = [['p^2', "0"], ["0", 'd^2']]
[settings.s.symbols]
'p' = { quantity = "measurement_noise_deviation", meaning = "deviation" }
'q' = { unit = "m s^-2", domain = 'q > 0', meaning = "deviation" }
'd' = { unit = "m s^-1", domain = 'd > 0', meaning = "deviation" }
'S' = { quantity = "velocity_deviation_ratio", meaning = "ratio" }
'T' = { quantity = "sampling_interval", meaning = "interval" }
'K' = { quantity = "gain_matrix.1.1", meaning = "gain" }
'r' = { definition = '\frac{p}{q T^2}', meaning = "ratio" }
"""


@pytest.mark.parametrize(
    ("declared", "claimed", "wanted"),
    [
        ("'B' = { definition = 'S^2/r^2 - 3/r^2 + 3S^4', meaning = 'no name' }", "B", "B"),
        ("'B' = { definition = '(S^2 - 3 + 3 r^2 S^4)^2', meaning = 'no name' }", "B", "B"),
        (
            "'B' = { definition = 'S^2/r^2 - 2/r^2 + 3S^4', meaning = 'other' }",
            "(S^2/r^2 - 3/r^2 + 3S^4)",
            None,
        ),
    ],
)
def test_an_exception_is_named_by_the_symbol_that_is_zero_there(
    declared: str, claimed: str, wanted: str | None
) -> None:
    latex = rf"\frac{{K ({claimed})}}{{{claimed}}} = K"
    file = claim_file(f"{TWO_RATIOS}{declared}\n", [("identity", latex)])
    (found,) = judge_file(file, MODELS, solved=SOLVED)
    assert found.verdict == "conditional", found.reason
    assert found.domain is not None
    assert "tracking_index" not in found.domain
    index = "(q T^2/p)^2"
    where = wanted or f"{index} S^2 - 3 {index} + 3 S^4"
    assert found.domain.endswith(f", where {where} is not zero")
