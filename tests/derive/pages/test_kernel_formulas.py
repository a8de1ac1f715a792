"""Formulas of kernels as text, against Python's own arithmetic on fractions."""

from __future__ import annotations

from fractions import Fraction

import pytest

from gainproof.derive.pages.formula import FormulaError
from gainproof.derive.pages.kernel_formulas import Value, kernel_values, read_sections
from gainproof.derive.printer.fixed_point import fixed_point, near_cbrt
from gainproof.derive.printer.graph import Graph, GraphBuilder, Node, operands

GIVEN = {"a": Fraction(2, 3), "b": Fraction(7), "c": Fraction(5, 11)}


def graph_of(page: str, *outputs: str, **numbers: int) -> Graph:
    builder = GraphBuilder()
    known: dict[str, Value] = {name: builder.symbol(name) for name in GIVEN}
    known |= {name: Fraction(number) for name, number in numbers.items()}
    return builder.graph(kernel_values(read_sections(page), known, outputs))


def values(graph: Graph) -> dict[str, Fraction]:
    found: list[Fraction] = []
    for node in graph["nodes"]:
        parts = [found[part] for part in operands(node)]
        match node[0]:
            case "symbol":
                found.append(GIVEN[str(node[1])])
            case "number":
                found.append(Fraction(node[1]))
            case "add":
                found.append(parts[0] + parts[1])
            case "mul":
                found.append(parts[0] * parts[1])
            case "div":
                found.append(parts[0] / parts[1])
            case _:
                found.append(-parts[0])
    return {name: found[end] for name, end in graph["outputs"].items()}


def test_lines_stand_for_what_python_makes_of_them() -> None:
    page = """
    x = (3/4) a^2 + part (b - c)/2
    part = (a + b)/(a c)
Prose between formulas, with = and numbers: 1/0.
    y = -(x/part) b^3
"""
    a, b, c = GIVEN.values()
    part = (a + b) / (a * c)
    x = Fraction(3, 4) * a**2 + part * (b - c) / 2
    assert values(graph_of(page, "x", "y")) == {"x": x, "y": -(x / part) * b**3}


def test_operations_are_made_from_the_left_in_the_order_that_is_written() -> None:
    builder = GraphBuilder()
    a, b, c = (builder.symbol(name) for name in GIVEN)
    by_hand = builder.graph({"x": (a * b) * (c + a) + ((a + b) + c) / a})
    assert graph_of("    x = a b (c + a) + (a + b + c)/a", "x") == by_hand
    behind = builder.graph({"x": (a * Fraction(3, 4)) * b})
    assert graph_of("    x = (3/4) a b", "x") == behind


def test_functions_are_calls_of_a_library_and_roots_are_powers() -> None:
    builder = GraphBuilder()
    a, b, _ = (builder.symbol(name) for name in GIVEN)
    by_hand = builder.graph({"x": builder.sqrt(a * a + b), "y": builder.call("atan2", b, a)})
    graph = graph_of("    x = sqrt(a^2 + b)\n    y = atan2(b, a)", "x", "y")
    assert graph == by_hand


def test_a_formula_goes_on_where_the_next_line_begins_with_more() -> None:
    assert graph_of("    x = a +\n        b", "x") == graph_of("    x = a + b", "x")


@pytest.mark.parametrize(
    "text", ["n a + b", "b + n a", "(1 + n) b", "b/(1 + n)", "b - n", "b + n/a"]
)
def test_what_zero_and_one_make_superfluous_is_left_out(text: str) -> None:
    graph = graph_of(f"    x = {text}", "x", n=0)
    assert graph["nodes"] == [["symbol", "b"]]


@pytest.mark.parametrize("text", ["n a", "a n", "a/n", "n/a", "a + n", "n + a", "b (a + n c)"])
def test_a_negative_number_with_a_node_is_no_form(text: str) -> None:
    with pytest.raises(ArithmeticError, match="no form without a subtraction: -2"):
        graph_of(f"    x = {text}", "x", n=-2)


def test_a_number_that_is_written_may_be_taken_away() -> None:
    builder = GraphBuilder()
    a, b, _ = (builder.symbol(name) for name in GIVEN)
    by_hand = builder.graph({"x": (a - Fraction(3, 4)) * (b * 4 - 1)})
    assert graph_of("    x = (a - 3/4) (4 b - 1)", "x") == by_hand
    with pytest.raises(ArithmeticError, match="no form without a subtraction"):
        graph_of("    x = a - n", "x", n=2)


def test_the_root_of_a_number_and_of_an_equation() -> None:
    builder = GraphBuilder()
    a = builder.symbol("a")
    assert graph_of("    x = a sqrt(2)", "x") == builder.graph({"x": a * builder.sqrt(2)})
    root = fixed_point(near_cbrt(a), lambda u: builder.sqrt(builder.sqrt(a * u)), within="1/25")
    page = """
    u = unknown(near_cbrt(a), 1/25)
    inner = sqrt(a u)
    x = fixed_point(u, sqrt(inner))
"""
    assert graph_of(page, "x") == builder.graph({"x": root})
    with pytest.raises(FormulaError, match="sqrt of a number: write its value"):
        kernel_values(read_sections("    x = sqrt(2)"), {}, ["x"])


def test_what_stands_below_the_name_of_a_kernel_is_its_own() -> None:
    page = """
    x = y
    y = a
### near (Near)
    y = b
### far_in_plane
Only prose.
## More
    z = y
"""
    assert graph_of(page, "x", "z") == graph_of("    x = a\n    z = a", "x", "z")
    near = graph_of(page, "x", "z", near_kernel=1, far_kernel=0)
    assert near["nodes"] == [["symbol", "b"]]
    assert graph_of(page, "x", near_kernel=0)["nodes"] == [["symbol", "a"]]


@pytest.mark.parametrize("text", ["a/n", "n/n", "a/(n b)", "a/(n - n)", "b + a (n/n)"])
def test_a_quotient_by_zero_is_no_form(text: str) -> None:
    with pytest.raises(ZeroDivisionError, match=r"no form: .* divides by 0"):
        graph_of(f"    x = {text}", "x", n=0)


@pytest.mark.parametrize("condition", ["a = 0", "a < 1", "n = 1 and b = 2"])
def test_a_condition_over_what_is_no_number_is_refused(condition: str) -> None:
    with pytest.raises(FormulaError, match=r"a condition is about numbers: [ab] "):
        graph_of(f"    x = a\n## Where {condition}\n    x = b", "x", n=1)


def test_what_is_given_is_taken_before_a_formula_of_that_name() -> None:
    assert graph_of("    a = b\n    x = a", "x")["nodes"] == [["symbol", "a"]]


@pytest.mark.parametrize("line", ["  x = b", "   x = b", "\tx = b", " ## Where n = 1"])
def test_what_begins_with_other_blanks_is_no_prose(line: str) -> None:
    with pytest.raises(FormulaError, match="line 3: a formula begins with four blanks"):
        graph_of(f"    x = a\nProse.\n{line}", "x", n=1)


@pytest.mark.parametrize("heading", ["## where n = 1", "##  Where n = 1", "# Where n = 1"])
def test_a_heading_that_is_nearly_one_of_conditions_is_refused(heading: str) -> None:
    with pytest.raises(FormulaError, match="line 2: wanted a heading `## Where"):
        graph_of(f"    x = a\n{heading}\n    y = b", "x", n=1)


def test_negative_numbers_among_numbers_are_numbers() -> None:
    assert values(graph_of("    x = (5 + n) a - (n n - 3) b", "x", n=-2)) == {
        "x": 3 * GIVEN["a"] - GIVEN["b"]
    }


@pytest.mark.parametrize(
    ("numbers", "wanted"),
    [((0, 1), "b"), ((0, 3), "c"), ((2, 3), "c"), ((2, 1), "a")],
)
def test_what_stands_below_comes_first_where_its_conditions_hold(
    numbers: tuple[int, int], wanted: str
) -> None:
    page = """
    x = y
    y = a
## Where m = 0 and n = 1
    y = b
## Where n^2 = 9
    y = c
"""
    m, n = numbers
    assert graph_of(page, "x", m=m, n=n)["nodes"] == [["symbol", wanted]]


def test_a_condition_may_be_an_inequality() -> None:
    page = "    x = a\n## Where m < 4 n^2\n    x = b"
    assert graph_of(page, "x", m=3, n=1)["nodes"] == [["symbol", "b"]]
    assert graph_of(page, "x", m=4, n=1)["nodes"] == [["symbol", "a"]]


def test_a_name_without_a_formula_is_left_out() -> None:
    assert list(graph_of("    x = a", "x", "y")["outputs"]) == ["x"]


@pytest.mark.parametrize(
    ("page", "message"),
    [
        ("    x = a\n    x", "line 2: wanted a line `name = formula`"),
        ("    x = a b +", "line 1: wanted a name"),
        ("prose\n\n    x = (a)", "line 3: read as"),
        ("    x = a\n    x = b", "line 2: x has a formula here already"),
        ("    x = a\n## Where m > 0", "line 2: wanted a condition such as m2 = 0"),
        ("    x = a\n## Where k = 0\n    x = b", "'k' has no formula"),
        ("    x = z", "'z' has no formula, or one that needs itself"),
        ("    x = y + a\n    y = x b", "'x' has no formula, or one that needs itself"),
        ("    x = log(a)", "no sum, product, quotient or function that is known"),
        ("    x = sqrt(a, b)", "sqrt: 1 wanted in brackets, 2 came"),
        ("    x = atan2(a, 2)", "atan2 of a number: write its value"),
        ("    x = [a, b]", "no sum, product, quotient"),
        ("    x = a'", "no sum, product, quotient"),
    ],
)
def test_what_is_no_formula_is_refused_and_says_where(page: str, message: str) -> None:
    with pytest.raises(FormulaError, match=message.replace("(", r"\(")):
        graph_of(page, "x")


def test_values_may_be_numbers() -> None:
    assert kernel_values(read_sections("    x = 3/4 - n"), {"n": Fraction(1, 4)}, ["x"]) == {
        "x": Fraction(1, 2)
    }
    assert not isinstance(kernel_values(read_sections("    x = 0"), {}, ["x"])["x"], Node)
