"""Angles in degrees beside angles in radians: what is true of them, by hand, and where a witness
says that they were mixed up, checked in mpmath.
"""

from __future__ import annotations

import mpmath
import pytest

from gainproof.verify.judge.claim.file import ClaimFileError, read_claim_text
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.verdict import ClaimVerdict

HEAD = r"""
format = "gainproof claims 1"
[source]
title = "made for this test"
[settings.s]
title = "angles"
kind = "algebra"
[settings.s.symbols]
'\theta' = { unit = "deg", meaning = "an angle" }
'\phi' = { unit = "degree", meaning = "another" }
'\omega' = { unit = "deg/s", meaning = "a rate" }
't' = { unit = "s", meaning = "time" }
'\epsilon' = { unit = "rad", meaning = "an angle in radians" }
'\eta' = { definition = '\frac{\pi \theta}{180}', meaning = "the first in radians" }
'\psi' = { definition = '2 \theta + \phi', meaning = "an angle" }
'V' = { unit = "deg^2", domain = 'V > 0', meaning = "a variance" }
'\sigma' = { unit = "deg", domain = '\sigma > 0', meaning = "a deviation" }
'\rho' = { unit = "rad", domain = '\rho > 0', meaning = "a deviation in radians" }
'c' = { unit = "1", meaning = "a number" }
'u' = { undefined = true, meaning = "never said" }
'h' = { definition = '\tan \theta', arguments = ['\theta'], meaning = "a slope" }
"""


def judged(kind: str, latex: str, domain: str = "") -> ClaimVerdict:
    text = f"{HEAD}[[claims]]\nid = 'c'\nplace = 'p'\nkind = '{kind}'\nsetting = 's'\n"
    text += f"latex = '{latex}'\n" + (f"domain = '{domain}'\n" if domain else "")
    return judge_file(read_claim_text(text), ())[0]


@pytest.mark.parametrize(
    ("kind", "latex", "domain"),
    [
        ("identity", r"\sin^2 \theta + \cos^2 \theta = 1", ""),
        ("identity", r"\sin(\theta - \phi) = \sin\theta \cos\phi - \cos\theta \sin\phi", ""),
        ("identity", r"\sin(\omega t + \theta) = \sin(\theta + t \omega)", ""),
        ("identity", r"\cos\psi = 1 - 2 \sin^2(\theta + \frac{\phi}{2})", ""),
        ("identity", r"\sin\eta = \sin\theta", ""),
        (
            "identity",
            r"\tan\frac{\pi \theta}{180} = \frac{\sin\theta}{\cos\theta}",
            r"\cos\theta > 0",
        ),
        ("identity", r"h(\phi) \cos\phi = \sin\phi", r"\cos\phi > 0"),
        ("identity", r"\sec^2\theta = 1 + \tan^2\theta", r"\cos\theta > 0"),
        ("identity", r"\frac{d \sin\theta}{d\theta} = \frac{\pi}{180} \cos\theta", ""),
        ("inequality", r"\cos\theta > 0", r"-90 < \theta < 90"),
        ("inequality", r"\sin\theta > 0", r"0 < \theta < 180"),
        ("implication", r"V = \sigma^2 \Rightarrow \sqrt{V} = \sigma", ""),
    ],
)
def test_true_of_angles_in_degrees(kind: str, latex: str, domain: str) -> None:
    assert judged(kind, latex, domain).verdict == "proved"


def test_a_sine_of_degrees_is_not_that_of_radians() -> None:
    verdict = judged("identity", r"\sin\theta = \sin\epsilon")
    assert verdict.verdict == "refuted"
    assert verdict.witness is not None
    point = {name: mpmath.mpf(value) for name, value in verdict.witness["point"].items()}
    left, right = mpmath.sin(mpmath.radians(point[r"\theta"])), mpmath.sin(point[r"\epsilon"])
    assert float(verdict.witness["left"]["midpoint"]) == pytest.approx(float(left), rel=1e-12)
    assert float(verdict.witness["right"]["midpoint"]) == pytest.approx(float(right), rel=1e-12)
    assert abs(left - right) > 1e-6


@pytest.mark.alike
@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("identity", r"\theta = \epsilon"),
        ("identity", r"V = \rho^2"),
        ("definition", r"V = \rho^2"),
        ("identity", r"\frac{d \sin\theta}{d\theta} = \cos\theta"),
        ("identity", r"\sin(\theta + \epsilon) = \sin(\epsilon + \theta)"),
        ("identity", r"\cos\omega = \cos\omega"),
        ("identity", r"\sin V = \sin V"),
        ("inequality", r"\theta < \rho"),
        ("inequality", r"\exp(\theta) > 0"),
    ],
)
def test_degrees_and_radians_mixed_up_are_refuted_by_dimensions(kind: str, latex: str) -> None:
    verdict = judged(kind, latex)
    assert verdict.verdict == "refuted"
    assert verdict.reason.startswith("dimensions: ")


@pytest.mark.parametrize(("latex"), [r"\theta = \epsilon", r"V = \rho^2", r"\theta = \eta"])
def test_a_mixed_equation_has_a_point_besides(latex: str) -> None:
    assert judged("identity", latex).witness is not None


@pytest.mark.parametrize(
    "latex",
    [
        r"\sin(\pi - \theta) = \sin\theta",
        r"\sin(\frac{\pi}{180} \theta + \phi) = c",
        r"\sin(\pi \theta / 180 + \pi) + \sin\theta = 0 c",
    ],
)
def test_an_angle_of_which_nobody_can_tell_its_unit_is_not_judged(latex: str) -> None:
    verdict = judged("identity", latex)
    mixed = verdict.verdict == "refuted" and verdict.reason.startswith("dimensions: ")
    told = any(each in verdict.reason for each in ("write a sine of degrees", "declare the angle"))
    assert mixed or (verdict.verdict == "undecided" and told)


def test_a_number_of_radians_is_no_bound_of_degrees() -> None:
    with pytest.raises(ClaimFileError, match="dimensions: the sides have dimensions deg and 1"):
        judged("inequality", r"\cos\theta > 0", r"\theta < \frac{\pi}{2}")


def test_without_degrees_a_multiple_of_pi_is_a_number() -> None:
    verdict = judged("identity", r"\sin(\pi - c) = \sin c")
    assert verdict.verdict == "proved"


@pytest.mark.parametrize(
    ("kind", "latex"),
    [
        ("identity", r"\sin\theta = \cos(90 - \theta)"),
        ("identity", r"\sin(\theta + 360) = \sin\theta"),
        ("identity", r"\sin\theta = \cos(\frac{\pi}{2} - \theta)"),
        ("identity", r"\tan(\phi + \theta + 2 \cdot 90) = \tan(\theta + \phi)"),
        ("identity", r"\sin(\theta)|_{\theta = 90} = 1"),
        ("identity", r"\cos(45 + \psi) = \sin(45 - \psi)"),
        ("inequality", r"\theta^2 < 8100"),
        ("inequality", r"\max(\theta, 3) \ge 3"),
        ("definition", r"V = 4 + \theta^2"),
        ("equivalence", r"\theta + 1 > 0 \Leftrightarrow \theta > -1"),
    ],
)
def test_a_bare_number_beside_degrees_is_not_judged(kind: str, latex: str) -> None:
    verdict = judged(kind, latex)
    assert verdict.verdict == "undecided"
    assert "may be one of degrees or of radians" in verdict.reason


@pytest.mark.alike
@pytest.mark.parametrize(
    "latex",
    [
        r"\theta + 90 = t",
        r"\theta + 0.5 \epsilon = \epsilon",
        r"t = t^2 + 90",
        r"90 + t + \theta = 0",
        r"3 \theta = 2 \epsilon",
    ],
)
def test_other_mixtures_are_refuted_still(latex: str) -> None:
    verdict = judged("identity", latex)
    assert verdict.verdict == "refuted"
    assert verdict.reason.startswith("dimensions: ")
