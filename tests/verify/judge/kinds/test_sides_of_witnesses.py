"""Which side of an equation has no value, and which side of an equivalence holds, at a witness."""

from __future__ import annotations

import pytest
from matrix_claims import judged_matrices
from small_claims import judged

INVERSE = "an inverse does not exist"


@pytest.mark.parametrize(
    ("latex", "without"),
    [
        (r"C = B^{-1} (B C)", ("right",)),
        (r"B^{-1} (B C) = C", ("left",)),
        (r"C B = B (B^{-1} C) B", ("right",)),
        (r"B^{-1} B = C C^{-1}", ("left", "right")),
    ],
)
def test_of_matrices_the_side_with_the_inverse(latex: str, without: tuple[str, ...]) -> None:
    found = judged_matrices(latex)
    assert found.witness is not None, found.reason
    lacking = [side for side in ("left", "right") if "undefined" in found.witness[side]]
    if len(without) == 1:
        assert lacking == list(without)
        other = {"left": "right", "right": "left"}[without[0]]
        assert found.witness[other]["midpoint"]
    else:
        assert lacking
    assert {found.witness[side]["undefined"] for side in lacking} == {INVERSE}


@pytest.mark.parametrize(
    ("latex", "sides"),
    [
        (r"x^2 = 1 \Leftrightarrow x = 1", ("holds", "does not hold")),
        (r"x = 1 \Leftrightarrow x^2 = 1", ("does not hold", "holds")),
        (r"x y = 0 \Leftrightarrow x = 0", ("holds", "does not hold")),
        (r"x = 0 \Leftrightarrow x y u = 0", ("does not hold", "holds")),
        (r"\frac{x}{x} = 1 \Leftrightarrow x = x \quad (-1 < x < 1)", ("has no value", "holds")),
        (r"x = 0 \Leftrightarrow x y = 0 \quad (y < x)", ("does not hold", "holds")),
        (r"e^x > 1 \Leftrightarrow x > 1", ("holds", "does not hold")),
        (r"x > 1 \Leftrightarrow e^x > 1", ("does not hold", "holds")),
    ],
)
def test_of_an_equivalence_the_truth_of_each_side(latex: str, sides: tuple[str, str]) -> None:
    condition = latex.partition(r"\quad")[2].strip(" ()")
    fields = f"latex = '{latex.partition(chr(92) + 'quad')[0].strip()}'"
    fields += f"\ndomain = '{condition}'" if condition else ""
    found = judged("equivalence", fields)
    assert found.verdict in ("refuted", "conditional"), found.reason
    assert found.witness is not None
    first, second = sides
    assert found.witness["note"].endswith(f"of the equivalence {first}, the right {second}")
    assert found.witness["point"], "a witness without a point"
