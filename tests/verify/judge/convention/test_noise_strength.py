"""A claim that is false of the noise that a model's matrices say, and true of another meaning of
its strength, names that meaning and stays refuted.

By hand, for F = [1 T; 0 1] and H = [1 0]: S = P_11 + R and the fixed point of the covariance
give (1 - alpha) S = R and beta^2 S = Q_22 T^2, so that beta^2 R = Q_22 T^2 (1 - alpha), whatever
the rest of Q is.
"""

from __future__ import annotations

import os
import subprocess
import sys

import pytest
from claim_texts import judged
from one_of_each import further

from gainproof.verdicts.verdict_text import overview

FORMS = {
    "white": (r"{s} T^3/3", r"{s} T^2/2", r"{s} T"),
    "constant": (r"{s} T^4/4", r"{s} T^3/2", r"{s} T^2"),
    "increment": ("0", "0", "{s}"),
}
MODEL = """
[settings.s]
title = "a filter of two states"
kind = "steady_state"
transition = [["1", "T"], ["0", "1"]]
process_noise = [['{a}', '{b}'], ['{b}', '{c}']]
measurement = [["1", "0"]]
measurement_noise = [['{r}']]
[settings.s.symbols]
T = {{ unit = "s", domain = "T > 0", meaning = "interval" }}
q = {{ unit = "{unit}", domain = "q > 0", meaning = "strength" }}
v = {{ unit = "{measured}", domain = "v > 0", meaning = "noise of the measurement" }}
'\\alpha' = {{ quantity = "filter_gain.1", meaning = "first gain" }}
'\\beta' = {{ quantity = "filter_gain.2", meaning = "second gain" }}
"""
UNITS = {"white": -3, "constant": -4, "increment": -2}
REST = ", the rest of Q in proportion"
CONSTANT = "the variance of a process noise that is constant between samples"


def model(form: str, size: int, measured: int = 2) -> str:
    strength = "q" if size == 1 else "q^2"
    a, b, c = (entry.format(s=strength) for entry in FORMS[form])
    unit = f"m^2 s^{UNITS[form]}" if size == 1 else f"m s^{UNITS[form]}/2".replace("-4/2", "-2")
    unit = unit.replace("-2/2", "-1")
    r, of_r = ("v^2", "m") if measured == 2 else ("v", "m^2")
    return MODEL.format(a=a, b=b, c=c, r=r, unit=unit, measured=of_r)


@pytest.mark.alike
@pytest.mark.parametrize(
    ("form", "size", "formula", "named"),
    [
        ("white", 1, "q T^4", f"q as {CONSTANT}: Q_{{22}} = q T^2{REST}"),
        (
            "white",
            1,
            "q T^2",
            f"q as the variance of an increment at each sample: Q_{{22}} = q{REST}",
        ),
        ("white", 1, "q^2 T^3", "q^2 as the density of the process noise: Q_{22} = q^2 T"),
        further("white", 1, "q^2 T^4", f"q^2 as {CONSTANT}: Q_{{22}} = q^2 T^2{REST}"),
        further("white", 2, "q T^3", "q as the density of the process noise: Q_{22} = q T"),
        further(
            "constant",
            2,
            "q^2 T^3",
            f"q^2 as the density of the process noise: Q_{{22}} = q^2 T{REST}",
        ),
        ("constant", 2, "q T^4", f"q as {CONSTANT}: Q_{{22}} = q T^2"),
        further(
            "increment", 2, "q^2 T^3", "q^2 as the density of the process noise: Q_{22} = q^2 T"
        ),
        further(
            "increment",
            1,
            "q^2 T^2",
            "q^2 as the variance of an increment at each sample: Q_{22} = q^2",
        ),
        # no meaning of the strength has these
        ("white", 1, "q T^7", None),
        further("constant", 2, "2 q^2 T^4", None),
    ],
)
def test_another_strength_is_named(form: str, size: int, formula: str, named: str | None) -> None:
    (found,) = judged(model(form, size), ("identity", rf"\beta^2 v^2 = {formula} (1 - \alpha)"))
    assert found.verdict == "refuted"
    assert found.certificate.get("would hold with") == named


@pytest.mark.parametrize("form", ["white", "constant"])
def test_a_noise_of_another_power_of_the_interval_is_told_with_all_of_its_matrix(form: str) -> None:
    # with r = (T Q_12 - Q_11)/(Q_22 T^2), which is 1/6 of white noise and 1/4 of a constant one,
    # the fixed point gives alpha^2 = 2 beta - alpha beta - r beta^2: with the r of one form and the
    # power of T of the other the claim is true of neither noise
    part, power, of = ("6", "T^4", "q T^2") if form == "white" else ("4", "T^3", "q T")
    relation = rf"\alpha^2 - 2\beta + \alpha\beta + \frac{{\beta^2}}{{{part}}}"
    claim = rf"v^2 (\beta^2 + {relation}) = q {power} (1 - \alpha)"
    (found,) = judged(model(form, 1), ("identity", claim))
    assert found.verdict == "refuted"
    assert found.certificate["would hold with"].endswith(f"Q_{{22}} = {of}{REST}")


@pytest.mark.parametrize(
    ("measured", "printed", "named"),
    [
        (2, "v", "v as the variance of the measurement noise"),
        (1, "v^2", "v as the deviation of the measurement noise"),
    ],
)
def test_so_is_another_noise_of_the_measurement(measured: int, printed: str, named: str) -> None:
    latex = rf"\beta^2 {printed} = q T^3 (1 - \alpha)"
    (found,) = judged(model("white", 1, measured), ("identity", latex))
    assert (found.verdict, found.certificate.get("would hold with")) == ("refuted", named)


def test_true_claims_and_those_without_the_strength_name_nothing() -> None:
    found = judged(
        model("white", 1),
        ("identity", r"\beta^2 v^2 = q T^3 (1 - \alpha)"),
        ("identity", r"\beta = 3\alpha"),
    )
    assert [verdict.verdict for verdict in found] == ["proved", "refuted"]
    assert all("would hold with" not in verdict.certificate for verdict in found)


def test_what_is_true_by_chance_names_nothing() -> None:
    (found,) = judged(model("white", 1), ("inequality", r"\beta^2 v^2 < 2 q^2 T^3 (1 - \alpha)"))
    assert found.verdict != "proved"
    assert "would hold with" not in found.certificate


def test_check_says_it() -> None:
    found = judged(model("white", 1), ("identity", r"\beta^2 v^2 = q^2 T^3 (1 - \alpha)"))
    source = {"key": "test", "title": "made for this test"}
    page = overview({"source": source, "claims": [verdict.to_json() for verdict in found]})
    assert "would hold with q^2 as the density of the process noise" in " ".join(page.split())


def test_its_value_is_written_in_one_order_whatever_the_hash_seed() -> None:
    """Certificates of one claim are equal in all processes."""
    script = (
        "from fractions import Fraction\n"
        "from gainproof.verify.judge.exact.expression import mul, power, symbol\n"
        "from gainproof.verify.judge.noise_strength import Strength\n"
        "names = map(symbol, ('sampling_interval', 'measurement_noise_deviation', 'x', 'y'))\n"
        "whole = mul(*(power(each, Fraction(2)) for each in names))\n"
        "print(Strength('w', 2).value(Strength('w', 1), whole).key)"
    )
    seeds = [{**os.environ, "PYTHONHASHSEED": str(seed)} for seed in range(1, 5)]
    run = [sys.executable, "-c", script]
    assert len({subprocess.check_output(run, env=seed) for seed in seeds}) == 1
