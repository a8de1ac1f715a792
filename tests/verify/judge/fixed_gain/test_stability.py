"""Conditions of stability: true ones are proved, each false neighbour is refuted at a filter whose
eigenvalues say so.
"""

from __future__ import annotations

import re
from fractions import Fraction

import pytest
from free_gains import radius, verdict
from one_of_each import further
from small_claims import check

from gainproof.verify.judge.replay import replay

TWO = r"0 < \alpha \text{ and } 0 < \beta < 4 - 2\alpha"
THREE = TWO + r" \text{ and } \gamma (1 - \frac{\alpha}{2}) < \alpha\beta \text{ and } 0 < \gamma"
GAINS = (r"\alpha", r"\beta", r"\gamma")


@pytest.mark.alike
@pytest.mark.parametrize(
    ("latex", "states", "stable"),
    [
        # the border belongs to it, a side is missing, a constant or a sign is another
        (TWO.replace("0 < \\alpha", "0 \\leq \\alpha"), 2, False),
        (TWO.replace("0 < \\beta", "0 \\leq \\beta"), 2, False),
        (TWO.replace("< 4", "\\leq 4"), 2, False),
        (TWO.replace("< 4 - 2\\alpha", ""), 2, False),
        (TWO.replace("0 < \\alpha \\text{ and }", ""), 2, False),
        further(TWO.replace("4 - 2", "4 + 2"), 2, False),
        further(TWO.replace("4 - 2", "5 - 2"), 2, False),
        (TWO.replace("4 - 2", "3 - 2"), 2, True),
        (TWO.replace("4 - 2", "4 - 3"), 2, True),
        (TWO.replace("0 < \\alpha", "0 < \\alpha < 1"), 2, True),
        (TWO.replace("0 < \\beta", "1 < \\beta"), 2, True),
        (THREE.replace(" \\text{ and } 0 < \\gamma", ""), 3, False),
        further(THREE.replace("< \\alpha\\beta", "\\leq \\alpha\\beta"), 3, False),
        further(THREE.replace("< \\alpha\\beta", "< 2\\alpha\\beta"), 3, False),
        (THREE.replace("1 - \\frac", "1 + \\frac"), 3, True),
        further(THREE.replace("\\frac{\\alpha}{2}", "\\alpha"), 3, False),
        further(THREE.replace("0 < \\gamma", "\\frac{1}{9} < \\gamma"), 3, True),
        (TWO, 3, False),
    ],
)
def test_false_neighbours(latex: str, states: int, stable: bool) -> None:
    found = verdict("stability", latex, states)
    check(found, "refuted")
    assert found.witness is not None
    gains = [float(Fraction(found.witness["point"].get(name, "1"))) for name in GAINS[:states]]
    assert (radius(gains) < 1 - 1e-9) is stable, (gains, found.reason)
    # what is told of the filter there, with the modulus of its poles as NumPy has it
    assert found.witness["shows"] == "stability"
    note = found.witness["note"]
    assert note.startswith(f"the filter is {'stable (poles' if stable else 'not stable (a pole'}")
    modulus = re.search(r"modulus (?:at most )?([\d.e+-]+)\)", note)
    assert modulus is not None
    assert float(modulus[1]) == pytest.approx(radius(gains), rel=1e-5)
    assert note.endswith(" fails" if stable else "though all that is stated holds")
    # one direction is false on a part of its domain, which refutes the claim
    assert found.certificate is not None
    assert replay(found.certificate, "refuted") is None
    assert replay(found.certificate, "proved") is not None


@pytest.mark.parametrize(("latex", "states"), [(TWO, 2), (THREE, 3)])
def test_exact_conditions(latex: str, states: int) -> None:
    check(verdict("stability", latex, states), "proved")


def test_a_condition_that_follows_may_be_said() -> None:
    check(verdict("stability", THREE + r" \text{ and } \gamma < 4\alpha", 3), "proved")


RV = r"given = ['\alpha(\alpha+\beta) = 2\beta']"
RA = r"given = ['(\alpha+\frac{\beta}{2})^2 = 2\beta']"
MV = r"given = ['\alpha = -\frac{\beta}{2}+\sqrt{\beta}']"


@pytest.mark.parametrize(
    ("given", "domain", "sense", "wanted"),
    [
        (RV, r"0 < \alpha < 1", "sufficient", "proved"),
        further(RV, r"0 < \alpha \leq 1", "sufficient", "proved"),
        (RV, r"0 < \alpha < \frac{3}{2}", "sufficient", "conditional"),
        further(RV, r"0 \leq \alpha < 1", "sufficient", "conditional"),
        (MV, r"0 < \alpha < 1", "sufficient", "proved"),
        (MV, r"0 \leq \alpha < 1", "sufficient", "conditional"),
        # the relation alone admits a second, unstable gain of the velocity
        (RA, r"0 < \alpha < 1", "sufficient", "conditional"),
        (RA, r"0 < \alpha < 1, \beta < 2", "sufficient", "proved"),
        further(RA, r"0 < \alpha \leq 1, \beta \leq 2", "sufficient", "conditional"),
        (RA, r"\alpha = 1", "unstable", "proved"),
        (RA, r"\alpha = \frac{1}{2}", "unstable", "conditional"),
        (RA, r"\alpha = \frac{1}{2}, \beta > 2", "unstable", "proved"),
        (RV, r"\alpha = 1", "unstable", "refuted"),
        further(RA, r"\beta \geq 2", "unstable", "proved"),
        further(RA, r"\beta > \frac{3}{2}", "unstable", "conditional"),
    ],
)
def test_named_filters(given: str, domain: str, sense: str, wanted: str) -> None:
    fields = f"text = 'stable'\n{given}\ndomain = '{domain}'\nsense = '{sense}'"
    found = verdict("stability", fields)
    assert found.verdict in ((wanted, "refuted") if wanted == "conditional" else (wanted,)), (
        found.reason
    )


@pytest.mark.parametrize(
    ("latex", "sense", "wanted"),
    [
        (r"0 < \alpha < 1 \text{ and } 0 < \beta < 2 - \alpha", "sufficient", "proved"),
        (r"0 < \alpha < 1 \text{ and } 0 < \beta < 2 - \alpha", "necessary", "refuted"),
        (r"0 < \alpha < 2", "necessary", "proved"),
        (r"0 < \alpha < 1", "necessary", "conditional"),
        (r"0 < \alpha < 2", "sufficient", "conditional"),
        (r"\beta \geq 4 - 2\alpha", "unstable", "proved"),
        (r"\beta > 3 - 2\alpha", "unstable", "conditional"),
    ],
)
def test_one_direction(latex: str, sense: str, wanted: str) -> None:
    found = verdict("stability", f"latex = '{latex}'\nsense = '{sense}'")
    assert found.verdict in ({wanted} | ({"conditional"} if wanted == "refuted" else set())), (
        found.reason
    )


def test_conditions_that_hold_nowhere_are_no_proof() -> None:
    fields = "text = 'x'\ndomain = '\\alpha > 1'\nsense = 'sufficient'\n" + MV
    assert verdict("stability", fields).verdict == "undecided"


@pytest.mark.parametrize(
    "fields",
    [
        "latex = 'p_{11} = p_{11}'",
        r"latex = '\alpha > 0'" + "\ngiven = ['p_{11} > 0']",
        r"latex = '\alpha > 0'" + "\ndomain = 'e_{12} > 0'",
        r"latex = '\alpha > -100 \text{ and } p_{11} = p_{11}'" + "\nsense = 'sufficient'",
        r"latex = 'e_{12} = \frac{a_c}{\beta}T^2'" + "\nsense = 'sufficient'",
    ],
)
def test_stability_is_not_proved_from_what_only_stable_filters_have(fields: str) -> None:
    """alpha = 3, beta = 1 is unstable, and its formulas for variance and lag have values."""
    assert radius((3.0, 1.0)) > 1
    found = verdict("stability", fields)
    assert found.verdict == "undecided", found.reason
    assert "only a stable filter has" in found.reason
