"""LaTeX set as MathML: what is not plain presentation never becomes an element."""

from __future__ import annotations

import xml.etree.ElementTree as ET

import pytest

from gainproof.book.mathematics import displayed, inline
from gainproof.claims import judgements
from gainproof.files import places

HOSTILE = (
    r"\href{javascript:alert(1)}{x}",
    r"\text{<script>alert(1)</script>}",
    r"<img src=x onerror=alert(1)>",
    r"\style{color:red}{x}",
    r"\class{a b}{x}",
    r"x & \notacommand{y",
    r"\frac{1",
    r"{" * 500,
)


def test_carries_its_latex_along() -> None:
    root = ET.fromstring(displayed(r"\frac{\alpha}{2}  =  \beta"))
    assert root.tag == "math"
    assert root.attrib["display"] == "block"
    assert root.findtext(".//annotation") == r"\frac{\alpha}{2} = \beta"
    (fraction,) = root.iter("mfrac")
    assert [child.text for child in fraction.iter("mi")] == ["α"]


def test_within_a_sentence() -> None:
    assert ET.fromstring(inline("x")).attrib["display"] == "inline"


@pytest.mark.parametrize("latex", HOSTILE)
def test_nothing_of_a_claim_file_becomes_code(latex: str) -> None:
    text = str(displayed(latex))
    elements = {element.tag for element in ET.fromstring(text).iter()}
    assert not elements & {"script", "a", "img", "style", "maction", "mglyph"}
    attributes = {name for element in ET.fromstring(text).iter() for name in element.attrib}
    assert not any(name.startswith("on") or "href" in name for name in attributes)


def test_every_printed_formula_is_set() -> None:
    import tomllib

    for file in places.claim_files():
        for claim in tomllib.loads(judgements.read(file))["claims"]:
            if "latex" in claim:
                assert str(displayed(claim["latex"])).startswith("<math"), claim["id"]


def test_a_long_formula_in_a_sentence_scrolls_in_its_box() -> None:
    assert inline(r"\alpha + \beta").startswith("<math")
    long = inline(" + ".join(["a_1"] * 12))
    assert long.startswith('<span class="long" tabindex="0"><math')
    # few characters, but the space around signs and two roots
    wide = inline(r"\kappa = \sqrt{4/\Lambda^{2} + 1/4}, \rho = \sqrt{\kappa + 1/2} = \alpha/\beta")
    assert wide.startswith('<span class="long" tabindex="0"><math')
