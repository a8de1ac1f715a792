"""True formulas that say nothing, or that nobody prints, are not offered as repairs."""

from __future__ import annotations

import pytest
from claim_texts import MODELS, algebra, claim_file, judged, steady

from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.reader.names import canonical_token
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.repair.printed import printed
from gainproof.verify.judge.repair.proof import is_of_use, is_proved
from gainproof.verify.judge.repair.senseless import is_more_senseless, senseless_parts

RV = steady("random-velocity")
PLAIN = algebra(
    "'x' = { unit = '1', meaning = 'a number' }\n"
    "'l' = { unit = '1', meaning = 'another' }\n"
    "'y' = { unit = '1', domain = 'y > 0', meaning = 'a positive one' }\n"
)


class Declared:
    """A number."""

    arguments: tuple[str, ...] = ()
    shape = None
    integer = False


SYMBOLS = {canonical_token(name): Declared() for name in ("a", "b", "k", "\\beta")}


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
