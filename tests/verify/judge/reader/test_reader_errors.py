"""What the reader refuses, and how it says so."""

from __future__ import annotations

from dataclasses import dataclass

import pytest

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import read_conditions, read_formula, read_plain


@dataclass(frozen=True)
class Declared:
    arguments: tuple[str, ...] = ()
    shape: object | None = None
    integer: bool = False


TOKENS = ("\\alpha", "\\alpha_k", "\\beta", *"kTabcx", "\\dot{x}_{sk-1}")
SYMBOLS: dict[str, Declared] = {canonical_token(token): Declared() for token in TOKENS}
SYMBOLS["S"] = Declared(("a", "b"))


CASES = r"\begin{cases} 1 & a > 0 {} a < 0 \\ 0 \end{cases} = b"


def refusal(text: str, symbols: dict[str, Declared] = SYMBOLS) -> ReaderError:
    with pytest.raises(ReaderError) as caught:
        read_formula(text, symbols)
    return caught.value


@pytest.mark.parametrize(
    ("text", "line", "column", "token", "nearest"),
    [
        (r"\alpha_j = 1", 1, 1, r"\alpha_j", r"\alpha_k"),
        ("a = b +\n  \\alpha_{kk} c", 2, 3, r"\alpha_{kk}", r"\alpha_k"),
        (r"a = \dot{x}_{sk}", 1, 5, r"\dot{x}_{sk}", r"\dot{x}_{sk-1}"),
        (r"a = \alpa", 1, 5, r"\alpa", r"\alpha"),
        ("a = y", 1, 5, "y", None),
        (r"a = \dot x", 1, 5, r"\dot{x}", r"\dot{x}_{sk-1}"),
    ],
)
def test_undeclared(text: str, line: int, column: int, token: str, nearest: str | None) -> None:
    error = refusal(text)
    assert (error.line, error.column, error.token) == (line, column, token)
    assert error.nearest[0] == nearest if nearest else not error.nearest
    shown, mark = error.caret.split("\n")
    assert shown[mark.index("^") :].startswith(text.split("\n")[line - 1][column - 1 :][:1])
    assert str(error).startswith(f"line {line}, column {column}: ")


@pytest.mark.parametrize(
    ("text", "column", "problem"),
    [
        ("", 1, "empty"),
        ("a", 2, "ends too early"),
        ("a =", 4, "ends too early"),
        ("a = b = ", 8, "ends too early"),
        ("a = (b", 5, "never closed"),
        ("a = b)", 6, "never opened"),
        (r"a = \ln(e b)", 9, "the symbol e is not declared; Euler's number alone is e^1"),
        (r"\log_{10} = b", 10, "of what?"),
        (r"\ln_2 a = b", 4, "a natural logarithm with a base: write \\log"),
        (r"\log_b a = b", 6, "the base of a logarithm is to be e or a whole number from 2 on"),
        (r"\log_{1} a = b", 6, "the base of a logarithm is to be"),
        (r"\log_{ a = b", 6, "the base of a logarithm is to be"),
        (r"\log_", 6, "the base of a logarithm is to be"),
        ("a = (b]", 7, "cannot be closed"),
        (r"a = \left( b", 5, "never closed"),
        (r"a = \left b", 5, "needs a bracket"),
        (r"a = \left) b", 5, "wrong side"),
        ("a = |b|", 5, "two things"),
        ("a = b^T", 6, "the transpose of what is not declared as a matrix"),
        ("a = b^{-\\top}", 6, "the transpose of what is not declared as a matrix"),
        ("a = b^12", 8, "a number right after a factor"),
        ("a = b 2", 7, "a number right after a factor"),
        ("a = (b + c)2", 12, "a number right after a factor"),
        ("a = b^2_k", 5, "b_k is not declared"),
        ("a = (b)_k", 8, "belongs to no symbol"),
        ("a = S^2(b, c)", 7, "an exponent between S and its brackets"),
        ("a = b^2^3", 8, "cannot stand here"),
        ("a = b + - c", 9, "cannot stand here"),
        ("a = 2{3}", 6, "a number right after a factor"),
        (r"a = b {2}^2", 7, "a number right after a factor"),
        (r"a = 2\frac12", 6, "a number before a fraction of numbers"),
        (r"a = 2\tfrac{1}{2} b", 6, "a number before a fraction of numbers"),
        ("a = {b + c}^2", 8, "cannot stand here"),
        ("a = 2{b c}", 9, "cannot stand here"),
        (r"a = b \quad c", 14, "ends too early"),
        (r"a = b + \quad c", 9, "separates relations"),
        (r"a = \frac{b \quad c}{2}", 13, "separates relations"),
        (r"a = b/c \sum_{k=0}^2 k", 6, "a slash before a sum"),
        (r"a = \prod_{k=0}^2 b \prod_{c=0}^2 c", 5, "what the product goes over"),
        (r"a = b \prod_{k=0}^2 k \sum_{c=0}^2 c", 7, "what the product goes over"),
        # the index there is another one
        (r"a = \prod_{k=0}^2 k \sum_{c=0}^2 \prod_{k=0}^c k", 5, "what the product goes over"),
        (r"a = 1/2 \cdot \frac{\partial}{\partial k} k", 6, "a slash before a sum"),
        ("a = .5", 5, "digits on both sides"),
        ("a = 1.2.3", 5, "digits on both sides"),
        ("(a = b)", 1, "only stand at the end"),
        ("a + (a = b) c = b", 5, "only stand at the end"),
        (r"a = \infty", 3, "on the right of an arrow"),
        (r"a = b + \infty", 9, "on the right of an arrow"),
        (r"\frac{a} = b", 10, "cannot stand here"),
        (r"a = \sqrt[k]{b}", 11, "cannot stand here"),
        (r"a = \sqrt[1]{b}", 13, "index of a root"),
        ("a = S", 6, "ends too early"),
        ("a = S b", 7, "cannot stand here"),
        ("a = b!", 6, "no meaning here"),
        ("a = b $", 7, "no meaning here"),
        ("a & = b", 3, "no meaning here"),
        (r"a = \begin{aligned} b \end{aligned}", 5, "round the whole formula"),
        (r"a = \begin{tikz} b \end{tikz}", 5, "not known"),
        (r"a = \begin{pmatrix} b & c \\ k \end{pmatrix}", 5, "rows of a matrix with 2, 1"),
        (r"a = \pm b", 5, "declare branch"),
        (r"a \ll b", 3, "no exact meaning"),
        (r"a = b + \cdots + c", 5, "pattern"),
        (r"a = \sin b c", 12, "not clear"),
        (r"a = \sin b \cdot c", 12, "not clear"),
        (r"a = b \\ - c = k", 9, "not clear"),
        (r"a = b \\ (c + k)", 9, "not clear"),
        (r"a = \sin^{-1} b", 10, "may be its inverse"),
        (r"a = \frac{\partial b}{\partial c}(k)", 34, "parentheses after a derivative"),
        (r"a = \frac{\partial}{\partial c} b|_{c=0}", 33, "a bar behind a derivative"),
        (r"a = b|_{c}", 10, "wanted"),
        (r"a = b|_{c<0}", 9, "a symbol = value is wanted"),
        (r"a = k b|_{c=0} b", 8, "a bar amid a product"),
        (r"\lim_{k \to 0} a + b = c", 18, "cannot stand here"),
        (r"\lim_{k \to 0} a < c", 1, "a limit must be said to equal"),
        (r"a \to 0+", 8, "behind the arrow of a condition"),
        ("a = b (130)", 7, "a number alone in parentheses"),
        (r"a = \int_0^1 b dc k", 19, "a factor right after an integral"),
        (r"a = k b \otimes c", 9, "beside other factors"),
        (r"a = \frac{\partial^2 b}{\partial c}", 5, "orders above and below"),
        (r"\begin{aligned} a &= b", 23, "never ended"),
        (r"a = \dot{a b}", 12, "must hold one symbol"),
        (r"a = \dot", 9, "needs a letter"),
        (r"a = b_", 7, "a subscript must be"),
        (r"a = b_{}", 7, "an empty subscript"),
        (r"a = b_{k", 7, "never closed"),
        ("a = 1,000", 10, "ends too early"),
    ],
)
def test_refused(text: str, column: int, problem: str) -> None:
    error = refusal(text)
    assert problem in error.problem
    assert (error.line, error.column) == (1, column)


@pytest.mark.parametrize("text", ["a = E[b^2]", r"a = 2 E \left[ b \right]", r"a = b + E\{c\}"])
def test_a_declared_letter_before_square_brackets_is_no_expectation(text: str) -> None:
    declared = {**SYMBOLS, "E": Declared()}
    with pytest.raises(ReaderError, match="leave it undeclared"):
        read_formula(text, declared)
    assert read_formula(text, SYMBOLS).readings
    assert read_formula("a = E(b^2) + E [b]", {**SYMBOLS, "E": Declared(("x",))}).readings
    assert read_formula("a = E(b + c)", declared).readings
    with pytest.raises(ReaderError, match="leave it undeclared"):
        read_plain("a = 2 E [b]", declared)


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("a = b" + " " * 3996, "4001 characters"),
        ("a = " + "(" * 41 + "b" + ")" * 41, "more than 40 deep"),
        ("a = " + r"\sqrt{" * 41 + "b" + "}" * 41, "more than 40 deep"),
        ("a = b^{65}", "beyond 64"),
        ("a = b^{1/65}", "beyond 64"),
        ("a = b^{" + "9" * 60 + "}", "beyond 64"),
        (r"a = \sqrt[65]{b}", "beyond 64"),
        ("a = " + "1" * 201, "at most 200"),
        ("a = b" + "/c" * 9, "more than 8 slashes"),
        ("a = " + "+".join(["a/b c"] * 7), "too many slashes"),
        ("a = " + r"\dot " * 7 + "x", "more than 6 accents"),
        ("a = x_{" + "k" * 100 + "}", "more than 80 characters"),
        ("a = x" + "'" * 100, "more than 80 characters"),
        ("a = " + r"\sum_{k=0}^2 " * 41 + "b", "more than 40 sums"),
    ],
)
def test_limits(text: str, problem: str) -> None:
    assert problem in refusal(text).problem


def test_limits_are_reached_without_error() -> None:
    read_formula("a = b" + " " * 3995, SYMBOLS)
    read_formula("a = " + "(" * 40 + "b" + ")" * 40, SYMBOLS)
    read_formula("a = b^{64}" + "/c" * 8 + "+" + "1" * 200, SYMBOLS)
    assert len(read_formula("a = " + "+".join(["a/b c"] * 6), SYMBOLS).readings) == 64


def test_conditions_have_one_reading() -> None:
    with pytest.raises(ReaderError, match="two readings"):
        read_conditions("a > 1/b c", SYMBOLS)


@pytest.mark.parametrize("word", ["log10", "sin", "sqrt", "abs"])
def test_a_function_without_brackets_in_plain_text(word: str) -> None:
    with pytest.raises(ReaderError, match=rf"{word} needs brackets: {word}\(\.\.\.\)"):
        read_plain(f"a = {word} b", SYMBOLS)


@pytest.mark.parametrize(
    ("text", "forms"),
    [
        (r"a = \sin b c", r"\sin(b c) or \sin(b) c"),
        (r"\cos 2 b c = a", r"\cos(2 b c) or \cos(2 b) c"),
        (r"a = \sin^2 b c \cos k + 1", r"\sin^2(b c) or \sin^2(b) c"),
        (r"a = \sin b \cdot c", r"\sin(b \cdot c) or \sin(b) \cdot c"),
        (r"a = \ln b/c", r"\ln(b/c) or \ln(b)/c"),
        (r"a = \exp b (c + 1)", r"\exp(b (c + 1)) or \exp(b) (c + 1)"),
        (r"a = \tan 2 b \frac{c}{k} x", r"\tan(2 b \frac{c}{k} x) or \tan(2 b) \frac{c}{k} x"),
    ],
)
def test_both_forms_with_brackets_are_printed_and_read(text: str, forms: str) -> None:
    error = refusal(text)
    assert error.problem.endswith(f"write {forms}")
    graphs = []
    unclear = text.partition("=")[2].strip() if text.startswith("a") else text.partition(" =")[0]
    for form in forms.split(" or "):
        end = unclear.find(" \\cos") if "\\cos k" in unclear else len(unclear)
        written = text.replace(unclear[:end], form)
        graphs.append(read_formula(written, SYMBOLS).readings[0].relations)
    assert graphs[0] != graphs[1]


@pytest.mark.parametrize(
    ("text", "form"),
    [
        (r"a = \ln \sin b", r"\ln(\sin b)"),
        (r"\ln \sin^2 b = a", r"\ln(\sin^2 b)"),
        (r"a = \exp \max(b, c)", r"\exp(\max(b, c))"),
    ],
)
def test_a_function_of_a_function_is_told_with_brackets(text: str, form: str) -> None:
    assert refusal(text).problem.endswith(f"of another function: write {form}")


@pytest.mark.parametrize("row", ["1, 2; 3, 4", "a; b", r"a \quad b; k \quad c", "a, b, c; k"])
@pytest.mark.parametrize(
    "around", ["[{}] = b", r"\left( {} \right) = b", r"a [{}]^T = b", r"\max({}) = b", "S({}) = 1"]
)
def test_a_semicolon_in_brackets_is_no_comma(row: str, around: str) -> None:
    text = around.format(row)
    error = refusal(text)
    assert "a semicolon in brackets" in error.problem
    assert error.position == text.index(";")


@pytest.mark.parametrize("text", ["a = b; b = c", r"a = b \quad (a > 0; c > 0)"])
def test_a_semicolon_between_relations_is_a_comma(text: str) -> None:
    whole = [read_formula(each, SYMBOLS).readings for each in (text, text.replace(";", ","))]
    assert whole[0] == whole[1]


@pytest.mark.parametrize("operator", [r"\frac{d}{dx}", r"\frac{\partial}{\partial x}"])
@pytest.mark.parametrize("bracket", ["(x^2)", r"\left[ x + b \right]^2", r"{(x)}", r"\{x\}"])
@pytest.mark.parametrize("further", ["x", r"\cdot b", "/x", r"(x + b)", r"\sum_{k=0}^2 k x"])
def test_a_derivative_of_a_bracket_with_more_behind_it(
    operator: str, bracket: str, further: str
) -> None:
    error = refusal(f"a = {operator} {bracket} {further}")
    assert "what the derivative is of is not clear" in error.problem
    assert error.position == len(f"a = {operator} ")
    for clear in (f"({bracket} {further})", bracket, f"b x {further}"):
        assert read_formula(f"a = {operator} {clear}", SYMBOLS).readings
    assert "not clear" in refusal(f"a = {operator} {bracket} {operator} {bracket}").problem


@pytest.mark.parametrize("word", ["or", r"\text{or}", r"\text{ or }", r"\mathrm{or}", r"\lor"])
@pytest.mark.parametrize(
    "around", ["a > 0 {} a < b", r"a = b \quad (b > 0 {} c > 0)", r"a = {} 1", CASES]
)
def test_alternatives_are_refused(word: str, around: str) -> None:
    text = around.replace("{}", word, 1)
    error = refusal(text, {**SYMBOLS, "o": Declared(), "r": Declared()})
    assert "`or` is not read" in error.problem
    assert error.position == text.index(word)


@pytest.mark.parametrize("text", ["a = b if c > 0 or b > 0", "cases(1, a > 0 or a <= 0; 0) = 1"])
def test_alternatives_of_plain_text_are_refused(text: str) -> None:
    with pytest.raises(ReaderError, match="`or` is not read") as caught:
        read_plain(text, SYMBOLS)
    assert caught.value.position == text.index("or")
    assert read_plain("a = or b", {**SYMBOLS, "or": Declared()}).readings


def test_letters_of_a_product_are_no_word() -> None:
    declared = {**SYMBOLS, "o": Declared(), "r": Declared()}
    for text in ("a = o r", "a = bor", "a = orb"):
        assert read_formula(text, declared).symbols[1:]


@pytest.mark.parametrize("text", [r"a \equiv b \bmod 3", r"a + b \equiv (c \bmod 2) + 1 = k"])
def test_a_congruence_is_refused(text: str) -> None:
    assert "a congruence is not read" in refusal(text).problem
    assert read_formula(text.replace(r"\equiv", "="), SYMBOLS).readings


@pytest.mark.parametrize("modulus", ["2*c", "2/c", "2*c b", "b c*2"])
def test_what_the_modulus_is_needs_brackets(modulus: str) -> None:
    with pytest.raises(ReaderError, match="what the modulus is is not clear"):
        read_plain(f"a = b mod {modulus}", SYMBOLS)
    latex = modulus.replace("*", r" \cdot ")
    assert "what the modulus is is not clear" in refusal(rf"a = b \bmod {latex}").problem
    assert read_plain(f"a = b mod ({modulus})", SYMBOLS).readings
    assert read_plain("a = 2*b mod 2 c", SYMBOLS).readings
