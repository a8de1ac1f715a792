"""Sentences of derivations: references, formulas kept whole, formulas as LaTeX."""

from __future__ import annotations

import pytest

from gainproof.formulas.latex_display import aligned
from gainproof.formulas.prose import latex_math, latex_prose, numbered, plain_prose, wrapped
from gainproof.pages.lecture_items import items, numbers
from gainproof.pages.lecture_latex import escaped
from gainproof.subjects.derived import DerivedStep

SYMBOLS = {
    "innovation_deviation": r"\sigma",
    "measurement_deviation": r"\sigma_v",
    "predicted_11": "M_{11}",
    "tracking_index": r"\Lambda",
    "predictor_position": "(FK)_1",
}


def test_references_become_numbers() -> None:
    assert numbered("By step @velocity-gain.", {"velocity-gain": 7}) == "By step 7."
    with pytest.raises(KeyError):
        numbered("By step @nowhere.", {})


def test_a_short_formula_is_not_broken() -> None:
    text = "The sum of both is the number `a + b + c` and no other."
    lines = wrapped(text, 30)
    assert any("a + b + c" in line for line in lines)
    assert " ".join(lines) == plain_prose(text)


@pytest.mark.parametrize(
    ("plain", "latex"),
    [
        ("sigma^2 c(1/z)", r"\sigma^{2} c(1/z)"),
        ("sigma_v/T", r"\sigma_v/T"),
        ("M11 -> infinity", r"M_{11} \to \infty"),
        ("D^-1 F D", "D^{-1} F D"),
        ("1/sqrt(1 - v)", r"1/\sqrt{1 - v}"),
        ("det(z I - F)", r"\det(z I - F)"),
        ("Lambda^2 Q0", r"\Lambda^{2} Q_0"),
        ("noise(4)", r"\mathrm{noise}(4)"),
        ("(FK)1", "(FK)_1"),
        ("(d/dLambda) f", r"(d/d\Lambda) f"),
    ],
)
def test_formulas_of_sentences_in_latex(plain: str, latex: str) -> None:
    assert latex_math(plain, SYMBOLS) == latex


def test_words_around_formulas_are_escaped() -> None:
    shown = latex_prose("50 % of `sigma`", SYMBOLS, escaped)
    assert shown == r"50 \% of $\sigma$"


def _step(name: str, *, shown: bool = True, joins: bool = False) -> DerivedStep:
    return DerivedStep(name, "equal", "main", "", "", {}, shown, "", joins)


def test_joined_steps_share_a_number() -> None:
    steps = [_step("a"), _step("b", joins=True), _step("c", shown=False), _step("d")]
    found = items(steps)
    assert numbers(found) == {"a": 1, "b": 1, "d": 2}
    assert found[0].mark({"a": "proved", "b": "proved"}) == "proved"
    assert found[0].mark({"a": "proved", "b": "rejected"}) == "proved: a; rejected: b"


def test_displays_are_aligned_and_broken() -> None:
    assert aligned(["a = b", "c = d"]) == "a &= b\\\\\nc &= d"
    assert aligned(["a > 0", "c = d"]) == "&a > 0\\\\\n&c = d"
    long = "y = " + " + ".join(f"a_{{{n}}} b_{{{n}}}" for n in range(10, 40))
    rows = aligned([long]).split("\\\\\n")
    assert len(rows) > 2
    assert all(row.startswith(("y &= ", r"&\qquad + ")) for row in rows)


def test_a_name_with_several_underscores_is_a_word_and_has_no_second_subscript() -> None:
    found = latex_math("bearing_D_target_x = x_1", {"x": "x"})
    assert found == r"\mathrm{bearing\_D\_target\_x} = x_1"
