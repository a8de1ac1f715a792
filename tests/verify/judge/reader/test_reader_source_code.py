"""Plain text as MATLAB, C and Python spell it: read as the same formula in the reader's own words,
numbers exact as printed, and refused where a declared name or a matrix makes it another thing.
"""

from __future__ import annotations

import contextlib
import itertools
import time
from decimal import Decimal
from fractions import Fraction

import pytest
from declared import Declared

from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.reader import read_formula, read_plain

NUMBERS = {name: Declared() for name in ("a", "b", "dt", "x", "y", "\\theta")}
MATRICES = {name: Declared(shape=(2, 2)) for name in ("A", "B")}
SYMBOLS = {**NUMBERS, **MATRICES, "P": Declared(("x",), (2, 2))}


def value(graph: Graph, number: int | None = None) -> Fraction:
    """The value of a graph of numbers, products, quotients and whole powers."""
    kind, *rest = graph["nodes"][graph["outputs"]["value"] if number is None else number]
    match kind:
        case "number":
            return Fraction(rest[0])
        case "mul":
            return value(graph, rest[0]) * value(graph, rest[1])
        case "div":
            return value(graph, rest[0]) / value(graph, rest[1])
        case "pow":
            return value(graph, rest[0]) ** int(rest[1])
    raise AssertionError(kind)


WHOLE = ("", "0", "7", "120")
BEHIND = ("", ".", ".0", ".25", ".007")
POWERS = ("", "e3", "E-2", "e+4", "e0", "E-60")
LITERALS = [
    w + b + p for w, b, p in itertools.product(WHOLE, BEHIND, POWERS) if w + b not in ("", ".")
]


@pytest.mark.parametrize("mark", ["", "f", "F"])
@pytest.mark.parametrize("literal", LITERALS)
def test_a_number_is_exact_as_printed(literal: str, mark: str) -> None:
    if mark and not set(".eE") & set(literal):
        return  # 7f is no number in C
    expected = Fraction(Decimal(literal))
    for text in (f"a = {literal}{mark}", f"a = ({literal}{mark}) "):
        graph = read_plain(text, SYMBOLS).readings[0].relations[0].right
        assert value(graph) == expected
    if expected:
        quotient = read_plain(f"a = 1/{literal}{mark}", SYMBOLS).readings[0].relations[0].right
        assert value(quotient) == 1 / expected


def test_whole_numbers_divide_exactly() -> None:
    graph = read_plain("a = 1/3", SYMBOLS).readings[0].relations[0].right
    assert value(graph) == Fraction(1, 3)


@pytest.mark.parametrize(
    ("shown", "decimals"), [("5.0e-4", 5), ("3.0e4", -3), (".50", 2), ("2.f", 0), ("1e2", -2)]
)
def test_an_exponent_moves_the_digits_that_are_shown(shown: str, decimals: int) -> None:
    relation = read_plain(f"a ~= {shown}", SYMBOLS).readings[0].relations[0]
    assert relation.right_decimals == decimals


@pytest.mark.parametrize(
    ("code", "written"),
    [
        ("a*pow(dt, 3)", "a*dt^3"),
        ("powf(a + b, -2)", "(a + b)^(-2)"),
        ("pow(x, 1.0f/3.0f)", "sqrt(x)^(2/3)"),
        ("std::pow(x, b)", "x^b"),
        ("np.power(x, 2)", "x^2"),
        ("x.*dt", "x*dt"),
        ("x./dt./y", "x/dt/y"),
        ("x.^2 + x.^-1 + x.^(1/2)", "x^2 + x^-1 + x^(1/2)"),
        ("2.*x + 2./x + 2.**x", "2*x + 2/x + 2^x"),
        ("dt**3/3.", "dt^3/3"),
        ("x^-.5", "x^-0.5"),
        ("fabs(x) + fabsf(y) + np.abs(a)", "abs(x) + abs(y) + abs(a)"),
        ("sqrtf(x) + std::sqrt(y) + math.sqrt(a)", "sqrt(x) + sqrt(y) + sqrt(a)"),
        ("sinf(x)*cosf(y)*tanf(a)", "sin(x)*cos(y)*tan(a)"),
        ("np.arctan2(y, x) + atan2f(y, x)", "atan2(y, x) + atan2(y, x)"),
        ("numpy.exp(x) - expf(y) - Math.log(a)", "exp(x) - exp(y) - ln(a)"),
        ("hypot(x + 1, y)", "sqrt((x + 1)^2 + y^2)"),
        ("log_2(x) + log_{10}(y) + log_e(a)", "log2(x) + log10(y) + ln(a)"),
        ("erf(x)", "erf(x)"),
        ("M_PI*x + np.pi + math.pi + Math.PI", "pi*x + pi + pi + pi"),
        ("tr(A' * B)", "tr(transpose(A)*B)"),
        ("tr((A*B)')", "tr(transpose(A*B))"),
        ("tr([a, b; x, y]')", "tr(transpose([a, b; x, y]))"),
        ("tr(P(x)')", "tr(transpose(P(x)))"),
        ("tr(A.T @ B.')", "tr(transpose(A)*transpose(B))"),
        ("tr(np.linalg.inv(A) + inv(B))", "tr(inverse(A) + inverse(B))"),
        ("tr(x.*A + A.*2 + A./x)", "tr(x*A + A*2 + A/x)"),
    ],
)
def test_a_spelling_of_code_is_the_formula(code: str, written: str) -> None:
    read = read_plain(f"a = {code}", SYMBOLS).readings
    assert [r.relations for r in read] == [
        r.relations for r in read_plain(f"a = {written}", SYMBOLS).readings
    ]


def test_the_letter_t_above_is_a_transpose_in_mathematics_only() -> None:
    declared = {**SYMBOLS, "T": Declared()}
    assert read_plain("tr(A^T) = a", declared).readings
    for code in ("x**T", "x.^T"):
        graph = read_plain(f"a = {code}", declared).readings[0].relations[0].right
        assert graph["nodes"][-1][:2] == ["call", "power"]


def test_conditions_are_joined_by_the_sign_of_c() -> None:
    assert read_plain("a == b if x > 0 && y >= 0", SYMBOLS).readings[0].conditions == (
        read_plain("a = b if x > 0 and y >= 0", SYMBOLS).readings[0].conditions
    )


@pytest.mark.parametrize(
    ("text", "column", "problem"),
    [
        ("a = A.*B", 8, "entry by entry"),
        ("a = x*A.*B", 10, "entry by entry"),
        ("a = 1./A", 8, "entry by entry"),
        ("a = A.^2", 8, "entry by entry"),
        ("a = 2.^A", 8, "entry by entry"),
        ("a = pow(A, 2)", 5, "entry by entry"),
        ("a = hypot(A, x)", 5, "entry by entry"),
        ("a = x'", 6, "has no meaning"),
        ("a = (x)'", 8, "the transpose of what is not declared as a matrix"),
        ("a = pow(x)", 5, "pow takes 2 arguments, not 1"),
        ("a = np.foo(x)", 5, "np.foo is no function that is read"),
        ("a = np.diff(x, y)", 5, "np.diff is no function that is read"),
        ("a = np.var(x)", 5, "np.var is no function that is read"),
        ("a = np.sqrt", 5, "np.sqrt is no function that is read"),
        ("a = math.x", 5, "math.x is no function that is read"),
        ("a = x + 1.2.3", 9, "a number needs digits on both sides of its one point"),
        ("a = 2.x", 5, "a number needs digits on both sides of its one point: write 2"),
        ("a = 1e3x", 5, "a number that runs into what follows: 1e3x"),
        ("a = 1.5f2", 8, "the symbol f2 is not declared"),
        ("a = 1e65", 7, "an exponent beyond 64"),
        ("a = 1e-" + "9" * 3000, 8, "an exponent beyond 64"),
        ("a = " + "7" * 201, 5, "a number of 201 digits, but at most 200 are read"),
        ("a = 2F", 6, "the symbol F is not declared"),
        ("a = log_b(x)", 9, "the base of a logarithm is to be e or a whole number from 2 on"),
        ("a = log_1(x)", 9, "the base of a logarithm is to be e or a whole number from 2 on"),
        ("a = log_2", 5, "log_2 needs brackets: log_2(...)"),
    ],
)
def test_what_is_not_read_is_told_with_its_place(text: str, column: int, problem: str) -> None:
    with pytest.raises(ReaderError) as caught:
        read_plain(text, SYMBOLS)
    assert (caught.value.line, caught.value.column) == (1, column)
    assert problem in caught.value.problem


@pytest.mark.parametrize(
    ("text", "name"),
    [("a = 2e-1", "e"), ("a = 2.5E+1*b", "E"), ("a = 1.0f", "f"), ("a = .5F", "F")],
)
def test_a_number_with_a_declared_letter_has_two_readings(text: str, name: str) -> None:
    assert read_plain(text, SYMBOLS).readings
    with pytest.raises(ReaderError, match="may be a number or a product") as caught:
        read_plain(text, {**SYMBOLS, name: Declared()})
    assert caught.value.column == 5


def test_the_mark_of_c_beside_a_function_of_its_name() -> None:
    declared = {**SYMBOLS, "f": Declared(("x",))}
    assert read_plain("a = 1.0f/3.0f", declared).readings
    assert read_plain("a = 1.0 f(x) + 2f(x)", declared).readings
    with pytest.raises(ReaderError, match="may be a number or a product"):
        read_plain("a = 1.0f(x)", declared)


@pytest.mark.parametrize("text", ["a = 2e", "a = 3f + 1e2", "a = pow(b)", "a = 2 e - 1"])
def test_declared_letters_behind_a_number_stay_what_they_are(text: str) -> None:
    declared = {**SYMBOLS, **{name: Declared() for name in ("e", "f", "e2")}}
    assert read_plain(text, {**declared, "pow": Declared(("x",))}).readings


def test_the_logarithm_of_a_library_is_natural_whatever_the_text_means() -> None:
    for code, base in (
        ("log(x)", "log 10"),
        ("math.log(x)", "log"),
        ("logf(x)", "log"),
        ("log_2(x)", "log 2"),
    ):
        graph = read_plain(f"a = {code}", SYMBOLS, logarithm=10).readings[0].relations[0].right
        assert graph["nodes"][-1][1] == base


def test_a_number_with_the_mark_of_c_is_told() -> None:
    assert read_plain("a = 1.0f*b", SYMBOLS).readings[0].taken == (
        "1.0f is the number 1.0, single precision as in C",
    )


@pytest.mark.parametrize("piece", ["1e", "1.", ".1", "np.", "math.", "x'", "A'", "log_", "1e-3f*"])
def test_long_texts_of_code_end_soon(piece: str) -> None:
    started = time.process_time()
    text = (piece * 4000)[:3990]
    with contextlib.suppress(ReaderError):
        read_plain(f"a = {text}", SYMBOLS)
    assert time.process_time() - started < 2


LETTERS = {letter: Declared() for letter in "abcdefghijklmnopqrstuvwxyz"}
UNREAD = [
    "round",
    "int",
    "trunc",
    "fix",
    "cbrt",
    "sech",
    "float",
    "prod",
    "sqrtl",
    "sinl",
    "roundf",
]


@pytest.mark.parametrize("word", UNREAD)
@pytest.mark.parametrize("around", ["a = {}(x)", "{} (2.5) = 3", "a = 2*{}(x + b)"])
def test_a_function_that_is_not_read_is_no_product(word: str, around: str) -> None:
    text = around.format(word)
    for read in (read_plain, read_formula):
        with pytest.raises(ReaderError, match="is no function that is read") as caught:
            read(text, LETTERS)
        assert caught.value.position == text.index(word)
        for declared in (Declared(), Declared(("x",))):
            assert read(text, {**LETTERS, word: declared}).readings
    upright = around.format(rf"\operatorname{{{word}}}")
    with pytest.raises(ReaderError, match="is no function that is read"):
        read_formula(upright, LETTERS)
    assert read_plain(f"a = x*{word}*(b)", {**LETTERS, word: Declared()}).readings


def test_letters_before_a_bracket_stay_a_product() -> None:
    for text in ("a = a b(x)", "a = r o u n d (x)", "a = ab(x)", "a = kint + x"):
        assert read_formula(text, LETTERS).readings


@pytest.mark.parametrize("exponent", ["1/3", "1./3", "-2/3", "5/7", ".2"])
@pytest.mark.parametrize("code", ["pow(x, {})", "np.power(x, {})", "x**({})", "x.^({})"])
def test_odd_roots_of_code_have_no_negative_radicand(code: str, exponent: str) -> None:
    nodes = read_plain(f"a = {code.format(exponent)}", SYMBOLS).readings[0].relations[0].right
    above, _, below = exponent.partition("/")
    twice = str(2 * Fraction(Decimal(above)) / Fraction(below or "1"))
    assert nodes["nodes"] == [["symbol", "x"], ["pow", 0, "1/2"], ["pow", 1, twice]]
    root = read_plain(f"a = x^({exponent})", SYMBOLS).readings[0].relations[0].right
    assert [node[0] for node in root["nodes"]] == ["symbol", "pow"]


@pytest.mark.parametrize("code", ["pow(x, 1/2)", "x**.5", "x**2", "x.^-3", "pow(x, 3/2)"])
def test_other_powers_of_code_are_one_power(code: str) -> None:
    graph = read_plain(f"a = {code}", SYMBOLS).readings[0].relations[0].right
    assert [node[0] for node in graph["nodes"]] == ["symbol", "pow"]


@pytest.mark.parametrize(
    ("lists", "rows"),
    [
        ("[[a, b], [x, y]]", "[a, b; x, y]"),
        ("[[a + b, -x], [(x + y)*2, [a + b]*y]]", "[a + b, -x; (x + y)*2, (a + b)*y]"),
        ("[[a], [b], [x]]", "[a; b; x]"),
        ("[[a, b],\n [x, y]]'", "[a, b; x, y]'"),
    ],
)
def test_lists_of_lists_are_rows_as_in_python(lists: str, rows: str) -> None:
    found, wanted = (read_plain(f"{each} = A", SYMBOLS).readings for each in (lists, rows))
    assert found[0].relations == wanted[0].relations


@pytest.mark.parametrize(
    "text",
    [
        *(
            "[a -b] = A",
            "a = [x -y]*b",
            "[a b] = A",
            "[1 2] = A",
            "[a, b x] = A",
            "[x y; a, b] = A",
        ),
        *("[dt^2/2 dt] = A", "a = [-a b]", "[x^2 y] = A", "a = [x + 2 y] b", "[a+b x-y] = A"),
        *("[(a) -b, x] = A", "[a, sqrt(x) sqrt(y)] = A", "[[a b], [x, y]] = A", "[a, x +2] = A"),
    ],
)
def test_entries_that_only_a_blank_parts_are_refused(text: str) -> None:
    with pytest.raises(ReaderError, match=r"a blank inside \[ \] may part two entries: write"):
        read_plain(text, SYMBOLS)


@pytest.mark.parametrize(
    "text",
    ["a = [x - y]*b", "a = [x-y] b", "a = [x + 2*y] b", "[a - b, -x; - y, 1] = A", "a = [-x] b"],
)
def test_brackets_of_numbers_stay(text: str) -> None:
    assert read_plain(text, SYMBOLS).readings


@pytest.mark.parametrize("text", ["[[a, b], [x, y], a] = A", "A = [a, [x, y]]", "[[a, b], x] = A"])
def test_lists_beside_other_entries_are_refused(text: str) -> None:
    with pytest.raises(ReaderError, match="lists beside other entries"):
        read_plain(text, SYMBOLS)


def test_a_bracket_in_a_list_stays_one() -> None:
    assert read_plain("[[a + b]*2, x] = A", SYMBOLS).readings
