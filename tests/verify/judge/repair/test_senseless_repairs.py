"""True formulas that say nothing, or that nobody prints, are not offered as repairs."""

from __future__ import annotations

import re

import pytest
from claim_texts import MODELS, algebra, claim_file, judged, steady

from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.repair.printed_formula import printed
from gainproof.verify.judge.repair.proof import is_of_use, is_proved
from gainproof.verify.judge.repair.senseless_parts import is_more_senseless, senseless_parts
from gainproof.verify.judge.verdict import ClaimVerdict

RV = steady("random-velocity")
PLAIN = algebra(
    "'x' = { unit = '1', meaning = 'a number' }\n"
    "'l' = { unit = '1', meaning = 'another' }\n"
    "'a' = { unit = '1', meaning = 'a number' }\n"
    "'b' = { unit = '1', meaning = 'a number' }\n"
    "'y' = { unit = '1', domain = 'y > 0', meaning = 'a positive one' }\n"
)


class Declared:
    """A number."""

    arguments: tuple[str, ...] = ()
    shape = None
    integer = False


SYMBOLS = {canonical_token(name): Declared() for name in ("a", "b", "k", "\\beta")}


@pytest.mark.alike
@pytest.mark.parametrize(
    ("setting", "kind", "latex"),
    [
        (PLAIN, "limit", r"y \to 1 \quad (y \to 0)"),
        (PLAIN, "identity", r"\frac{x}{y} = 1"),
        (PLAIN, "identity", r"-x^2 = x^2"),
        (PLAIN, "identity", r"\sin(2 x) = 2 \sin(x)"),
        (PLAIN, "identity", r"x = x + 1"),
        (PLAIN, "inequality", r"0 \le x^2 < y^2 + 1"),
        (RV, "implication", r"\alpha > \frac{1}{2} \Rightarrow \beta > 1"),
        (RV, "identity", r"\frac{\partial \beta}{\partial \alpha} = 2"),
        (PLAIN, "identity", r"\frac{\partial}{\partial x} \sqrt{y} = \frac{1}{2 \sqrt{y}}"),
    ],
)
def test_not_offered(setting: str, kind: str, latex: str) -> None:
    (verdict,) = judged(setting, (kind, latex))
    assert verdict.verdict in ("refuted", "conditional"), verdict.reason
    assert verdict.repair is None, verdict.repair


@pytest.mark.parametrize(
    ("setting", "kind", "latex", "expected"),
    [
        (PLAIN, "identity", r"\sqrt{x^4} = x^2 \frac{x}{l}", r"\sqrt{x^{4}} = x^{2}"),
    ],
)
def test_what_says_something_is_offered_in_its_place(
    setting: str, kind: str, latex: str, expected: str
) -> None:
    (verdict,) = judged(setting, (kind, latex))
    assert verdict.repair == {"latex": expected, "verdict": "proved"}


@pytest.mark.parametrize(
    ("kind", "latex", "expected"),
    [
        ("implication", r"\alpha > \frac{1}{2} \Rightarrow \beta > \frac{1}{8}", True),
        ("implication", r"\alpha > \frac{1}{2} \Rightarrow \beta > 1 - 2", False),
        ("equivalence", r"\alpha > 2 \Leftrightarrow \beta > 5", False),
        ("implication", r"\alpha = \frac{2}{3} \Rightarrow \beta = \frac{1}{3}", True),
        ("equivalence", r"\alpha < 1 \Leftrightarrow \beta > 0", False),
        ("inequality", r"\alpha < 1 \Leftrightarrow \beta > 0", False),
        ("identity", r"\alpha(\alpha + \beta) = 2 \beta", True),
    ],
)
def test_two_parts_must_have_to_do_with_one_another(kind: str, latex: str, expected: bool) -> None:
    found = claim_file(RV, [(kind, latex)])
    convention = next(iter(conventions(found.settings["s"], MODELS, {})))
    assert isinstance(convention, Convention)
    (claim,) = found.claims
    assert is_proved(claim, convention.setting, convention.environment)
    assert is_of_use(claim, convention.setting, convention.environment) is expected


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        ("a = 0 b", 1),
        ("a = -0", 1),
        (r"a = \frac{0}{b}", 1),
        (r"a = \frac{2 b}{2}", 1),
        (r"a = \frac{a b}{b}", 1),
        ("a = b - b", 1),
        (r"a = k^2 - \frac{2 k^2}{3} + b", 1),
        ("a = 1 - 2 + b", 1),
        ("a + b = b", 1),
        ("a = b^0", 1),
        (r"a = (\sqrt{b})^2", 1),
        ("a = 1^k", 1),
        (r"a = \frac{\partial b}{\partial b}", 1),
        (r"a = \left. b k \right|_{b = b}", 1),
        (r"a = \frac{b^2}{2 - b}, \quad k = a b + \beta", 0),
        (r"a a = 2 \beta - \beta a", 0),
        (r"a = \sqrt{2} - 1 + \sqrt{3}", 0),
        (r"a = b \frac{\partial k}{\partial b} + b^2 \frac{k}{2 b + 1}", 0),
        ("a < a + b", 0),
    ],
)
def test_parts_that_nobody_prints_are_counted(latex: str, expected: int) -> None:
    formula = printed(read_formula(latex, SYMBOLS).readings[0])
    assert senseless_parts(formula) == expected


def test_what_the_source_itself_prints_is_no_fault_of_a_change() -> None:
    def formula(latex: str) -> object:
        return printed(read_formula(latex, SYMBOLS).readings[0])

    assert not is_more_senseless(formula("a = b^0 + 0 k"), formula("a = b^0 + 0 a"))  # type: ignore[arg-type]
    assert is_more_senseless(formula("a = b^0 + 0 k"), formula("a = b^0 + k"))  # type: ignore[arg-type]


def only_sides(verdict: ClaimVerdict) -> list[list[str]]:
    """The sides of all repairs, without the size of their brackets."""
    shown = [repair["latex"] for repair in verdict.repairs]
    plain = [" ".join(re.sub(r"\\left|\\right", "", latex).split()) for latex in shown]
    return [latex.split(" = ") for latex in plain]


@pytest.mark.parametrize(
    ("latex", "right"),
    [
        (r"(a+b)(a-b) = a^2 - b^2 + x", "a^{2} - b^{2}"),
        (r"(a+b)(a-b) = a^2 - b^2 + 1", "a^{2} - b^{2}"),
        (r"y (a+b) = y a + y b + a x", "y a + y b"),
        (r"\frac{(a+b)(a-b)}{y} = \frac{a^2 - b^2 - l}{y}", r"\frac{a^{2} - b^{2}}{y}"),
        (r"\frac{\partial}{\partial a}(y\cos a) = -y \sin a + y", r"-y \sin ( a )"),
        (r"\frac{\partial}{\partial a}(a^2 b) = 2 a b + b", "2 a b"),
        (r"\frac{\partial}{\partial x}(a x^2 + b x y) = 2 a x + b y - x", "2 a x + b y"),
    ],
)
def test_a_part_too_many_is_left_out_and_not_taken_away_again(latex: str, right: str) -> None:
    (verdict,) = judged(PLAIN, ("identity", latex))
    assert verdict.verdict == "refuted"
    assert [sides[1] for sides in only_sides(verdict)] == [right]
    assert verdict.repairs[0]["changes"][0].startswith("a part too many")


@pytest.mark.parametrize(
    ("latex", "repaired"),
    [
        (r"(a + b)^2 + (a - b)^2 = 4 a b", ["( a + b )^{2} - ( a - b )^{2}", "4 a b"]),
        (r"(a - b)(a - b) = a^2 - b^2", ["( a - b ) ( a + b )", "a^{2} - b^{2}"]),
        (r"(a + b)^2 + a^2 = 2 a b + b^2", ["( a + b )^{2} - a^{2}", "2 a b + b^{2}"]),
        (r"a (b + x) = a b", ["a ( b + x )", "a b + a x"]),
    ],
)
def test_what_cancels_by_a_sign_may_be_meant(latex: str, repaired: list[str]) -> None:
    (verdict,) = judged(PLAIN, ("identity", latex))
    assert repaired in only_sides(verdict)


@pytest.mark.parametrize(
    ("latex", "first", "others"),
    [
        (
            r"\cos(a+b) = \cos a \cos b + \sin a \sin b",
            r"\cos ( a ) \cos ( b ) - \sin ( a ) \sin ( b )",
            1,
        ),
        (
            r"\sin(a+x) = \sin a \cos x - \cos a \sin x",
            r"\sin ( a ) \cos ( x ) + \cos ( a ) \sin ( x )",
            1,
        ),
        (
            r"\cosh(a-b) = \cosh a \cosh b + \sinh a \sinh b",
            r"\cosh ( a ) \cosh ( b ) - \sinh ( a ) \sinh ( b )",
            1,
        ),
    ],
)
def test_the_sign_between_terms_comes_before_one_inside_a_function(
    latex: str, first: str, others: int
) -> None:
    (verdict,) = judged(PLAIN, ("identity", latex))
    found = only_sides(verdict)
    assert found[0][1] == first
    assert len(found) == 1 + others, found
    assert not re.search(r"\( -[a-z]", " ".join(side for sides in found for side in sides))
