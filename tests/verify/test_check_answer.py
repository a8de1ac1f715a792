"""Certificates of answers: what is true is accepted, what is false never, however it is altered.

Steps are written here by hand, right ones and wrong ones. What an altered certificate states is
evaluated from its lines with mpmath, its filter by going through the Riccati recursion until it
settles: nothing of the checker's own.
"""

from __future__ import annotations

import ast
import copy
import json
import random
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest

from gainproof.answers.judge import Judge
from gainproof.verify import check_answer
from gainproof.verify.check_answer import FILTER, FORMAT, GAINS, KALMAN_BUCY, Poly, main, symmetric
from gainproof.verify.judge.answer_certificate import rejected

FILE = Path(check_answer.__file__)
Data = dict[str, Any]
ALONE: list[Any] = [[1], []]
# true by hand, or refuted at a point: (formula, what else is said, verdict)
ASKED: list[Any] = [
    (r"\beta = 2(2 - \alpha) - 4\sqrt{1 - \alpha}", {"model": "random-acceleration"}, "proved"),
    (r"\beta = 2(2 - \alpha) + 4\sqrt{1 - \alpha}", {"model": "random-acceleration"}, "refuted"),
    (r"\beta = \frac{\alpha^2}{2 - \alpha}", {"model": "random-velocity"}, "proved"),
    (r"\frac{P_{11}}{R} = \frac{\alpha}{1 - \alpha}", {"model": "random-velocity"}, "proved"),
    (r"\sqrt{x^2 + 2 x y + y^2} = x + y", {"domain": "x > 0, y > 0"}, "proved"),
    (r"\sqrt{x^2 + y^2} = x + y", {"domain": "x > 0, y > 0"}, "refuted"),
    (r"x + 1/x >= 2", {"domain": "x > 0"}, "proved"),
    (r"x^3 - x + 1 > 0", {"domain": "0 < x < 5"}, "proved"),
    (r"\frac{x^2 - y^2}{x - y} = x + y", {}, "proved"),
    (r"\cos(2 u) = 1 - 2 \sin^2 u", {"model": "none"}, "proved"),
    (r"\sin(u - v) = \sin u \cos v - \cos u \sin v", {"model": "none"}, "proved"),
    (r"e^{a + b} = e^a e^b", {}, "proved"),
    (r"a/c >= b/c", {"given": "a >= b", "domain": "c > 0"}, "proved"),
    (r"(x + y)^2 = x^2 + y^2", {}, "refuted"),
    (r"e^{x} = 1 + x", {"domain": "x > 0"}, "refuted"),
    (r"\sqrt{3 + 2 \sqrt{2}} = 1 + \sqrt{2}", {}, "proved"),
]


@pytest.fixture(scope="module")
def certificates() -> Iterator[list[Data]]:
    with Judge(seconds=60) as judge:
        found = []
        for formula, said, _ in ASKED:
            answer = judge.ask(formula, **said)
            found.append(json.loads(json.dumps(answer.certificate)))
        yield found


def run(path: Path, data: Any, capsys: pytest.CaptureFixture[str]) -> tuple[int, list[str]]:
    path.write_text(data if isinstance(data, str) else json.dumps(data))
    status = main([str(path)])
    return status, capsys.readouterr().out.splitlines()


def certificate(*lines: Any, **point: list[Any]) -> Data:
    return {"format": FORMAT, "point": point, "lines": [*lines]}


def real(name: str, *conditions: str) -> list[Any]:
    return [["real", name], *[["where", c] for c in conditions]]


X = real("x")
PLUS = real("x", "x > 0")
ONE: list[Any] = [[1]]
P: list[Any] = [[[1], "x"]]
SQUARE: list[Any] = [[[1], "x", "x"]]
ROOT: list[Any] = [[[1], "sqrt(x ** 2)"]]
DIFFERENCE = [*ROOT, [[-1], "x"]]
SUM = [*ROOT, *P]
CLAIM = ["claim", "sqrt(x**2) == x"]
# facts of PLUS: 0 x > 0; then 1 x^2 > 0, 2 r^2 - x^2 == 0, 3 r > 0
ABSOLUTE = [
    ["shows", SQUARE, ">", ALONE, [[[1], [0, 0]]]],
    ["opens", "sqrt(x ** 2)", 1],
    ["shows", SQUARE, ">=", ALONE, [[[1], [1]]]],
]
SHOWN = ["shows", DIFFERENCE, "==", ALONE, [[[1], [2]]], SUM]


def test_a_root_has_its_sign_where_it_is_shown() -> None:
    assert rejected(certificate(*PLUS, CLAIM, *ABSOLUTE, SHOWN, x=[2])) is None
    negative = [["shows", SUM, "==", ALONE, [[[1], [2]]], DIFFERENCE]]
    wrong = ["claim", "sqrt(x**2) == 0 - x"]
    assert rejected(certificate(*PLUS, wrong, *ABSOLUTE, *negative, x=[2])) is not None


@pytest.mark.parametrize(
    ("domain", "opening"),
    [
        # of any x the root has a kink at 0; without 0 the domain falls apart
        (X, [["shows", SQUARE, ">=", ALONE, [[[1], [], P]]], ["opens", "sqrt(x ** 2)", 0]]),
        (
            real("x", "x != 0"),
            [
                ["shows", SQUARE, "!=", ALONE, [[[1], [0, 0]]]],
                ["shows", SQUARE, ">=", ALONE, [[[1], [], P]]],
                ["opens", "sqrt(x ** 2)", 2],
            ],
        ),
        (
            real("x", "x**2 > 1"),
            [
                ["shows", SQUARE, ">", ALONE, [[[1], [0]], [[1], []]]],
                ["opens", "sqrt(x ** 2)", 1],
                ["shows", SQUARE, ">=", ALONE, [[[1], [1]]]],
            ],
        ),
    ],
)
def test_a_branch_is_not_carried_over_a_kink_or_a_gap(domain: Any, opening: Any) -> None:
    fact = {1: 1, 3: 3, 2: 2}
    for number in fact:
        shown = ["shows", DIFFERENCE, "==", ALONE, [[[1], [number]]], SUM]
        assert rejected(certificate(*domain, CLAIM, *opening, shown, x=[2])) is not None


POSITIVE = ["claim", "x > 0"]
WRONG: list[Any] = [
    # what is said to be shown, with what: none of it follows
    (PLUS, ["claim", "x > 1"], ["shows", [*P, [[-1]]], ">", ALONE, [[[1], [0]]]]),
    (PLUS, ["claim", "0 > x"], ["shows", [[[-1], "x"]], ">", ALONE, [[[-1], [0]]]]),
    (X, POSITIVE, ["shows", P, ">", ALONE, []]),
    (X, ["claim", "x**2 > 0"], ["shows", SQUARE, ">", ALONE, [[[1], [], P]]]),
    (real("x", "x >= 0"), POSITIVE, ["shows", P, ">", ALONE, [[[1], [0]]]]),
    (X, ["claim", "x == 0"], ["shows", P, "==", [[0], []], []]),
    (X, ["claim", "x == 0"], ["shows", P, "==", [[1], [], []], []]),
    (X, ["claim", "x == 0"], ["shows", P, "==", ALONE, [], [[[0]]]]),
    (X, ["claim", "0 != 0"], ["shows", [], "!=", ALONE, [[[0], []]]]),
    (X, ["claim", "0 > 0"], ["shows", [], ">", ALONE, [[[0], []]]]),
    (X, ["claim", "x != 0"], ["shows", P, "!=", ALONE, [[[1], [], P]], ONE]),
    (X, ["claim", "x != 0"], ["shows", P, "!=", ALONE, []]),
    (real("x", "x >= 0"), ["claim", "x == 0"], ["shows", P, "==", [[1], [0]], []]),
    (real("x", "x >= 0"), ["claim", "0 - x >= 0"], ["shows", [[[-1], "x"]], ">=", [[1], [0]], []]),
    (PLUS, POSITIVE, ["shows", P, "=", ALONE, [[[1], [0]]]]),
    (X, POSITIVE, ["shows", P, ">", ALONE, [], P]),
    # never 0 on a domain that falls apart
    (real("x", "x != 0"), POSITIVE, ["shows", P, ">", ALONE, [[[1], [0]]]]),
    (PLUS, ["claim", "1/x > 0"], ["opens", "1/(x)", 7]),
    (PLUS, ["claim", "1/(x - 1) != 0"], ["opens", "1/(x - 1)", 0]),
    (X, ["claim", "exp(x) == exp(x)*exp(x)"], ["sums", "x", "x", "x"]),
    (X, ["claim", "1/x == 1/x"], ["shows", [], "==", ALONE, []]),
    (X, ["claim", "sqrt(x) == sqrt(x)"], ["shows", [], "==", ALONE, []]),
    # where x = 0, x times -1 is -x, which is not negative
    (
        real("x", "x >= 0", "0 - x >= 0"),
        ["claim", "0 - 1 >= 0"],
        ["shows", [[[-1]]], ">=", [[1], [0]], [[[1], [1]]]],
    ),
]


@pytest.mark.parametrize("number", range(len(WRONG)))
def test_a_step_that_does_not_follow_is_refused(number: int) -> None:
    domain, claim, step = WRONG[number]
    point = [0] if "0 - x >= 0" in str(domain) else [3]
    assert rejected(certificate(*domain, claim, step, x=point)) is not None


@pytest.mark.parametrize(("by", "accepted"), [(2, True), (0, False)])
def test_a_letter_is_opened_by_its_own_divisor(by: int, accepted: bool) -> None:
    less = [[[1], "x"], [[-1]]]
    lines = [
        *real("x", "x > 5"),
        ["claim", f"({'x - 1' if accepted else 'x - 5'})*(1/(x - 1)) == 1"],
        ["shows", less, ">", ALONE, [[[1], [0]], [[4], []]]],
        ["shows", less, "!=", ALONE, [[[1], [1]]]],
        ["opens", "1/(x - 1)", by],
    ]
    assert (rejected(certificate(*lines, x=[6])) is None) == accepted


@pytest.mark.parametrize(
    ("conditions", "point"),
    [
        (["x > 0", "0 - 1 > x"], [1]),
        (["x > 5", "1 > x"], [6]),
        (["x == 5", "1 > x"], [5]),
        (["x**2 == 2"], [7, 5]),
        (["0 > x**2"], [0]),
    ],
)
def test_nothing_is_shown_of_no_number(conditions: list[str], point: list[int]) -> None:
    lines: list[Any] = [*real("x", *conditions), ["claim", "0 == 1"]]
    shown = ["shows", [[[1]]], "==", ALONE, []]
    assert rejected(certificate(*lines, shown, x=point)) is not None
    lines[-1] = ["claim", "0 == 0"]
    assert rejected(certificate(*lines, ["shows", [], "==", ALONE, []], x=point)) is not None


@pytest.mark.parametrize(
    "line",
    [
        ["with", "sqrt(2) = 5"],
        ["with", "K[1,1] = 5"],
        ["with", "x = 5"],
        ["with", "y == 5"],
        ["with", "y = x\nclaim:      x == 1"],
        ["real", "y\nclaim: 1 == 2"],
        ["real", "y = 3"],
        ["typed", "a\nclaim: 1 == 2"],
        ["other", "x"],
        ["claim", "[x, x]"],
        ["claim", "x = 1"],
        ["claim", "x == 1 # == 2"],
        ["with", "y = exp(x, y=3)"],
        ["with", "y = exp(*x)"],
        ["with", "y = x.real"],
        ["with", "y = x if x else x"],
        ["with", "y = x // x"],
        ["claim", "\u0430 == \u0430"],
        ["claim", "x < 1 < 2"],
        ["filter", FILTER],
        ["filter", "P is the covariance"],
        ["with", "y = z"],
        # lines that print as others do, or over them
        ["with", "y = 5\r" + " ".join("     ")],
        ["typed", "x = 0\x1b[2K"],
        ["convention", "a\x0bb"],
        ["real", "\ny"],
        ["typed", f"x{' ' * 70}real: x"],
        ["typed", "x\u00a0y"],
        # spellings of numbers and words of Python
        ["claim", "1_0 == 10"],
        ["claim", "0xa == 10"],
        ["claim", "1e1 == 10"],
        ["claim", "x**True == x"],
        ["real", "lambda"],
        ["real", "None"],
        # of the filter, whether there is one or not
        ["real", "S"],
        ["with", "X = 1"],
    ],
)
def test_lines_that_mislead_are_refused(line: list[str]) -> None:
    true = [["claim", "x == x"], ["shows", [], "==", ALONE, []]]
    assert rejected(certificate(*X, *true)) is None
    assert rejected(certificate(*X, *true[:1], line, *true[1:])) is not None


LISTS = ["A = [x + 1]", "B = [x + 2]", "C = [[1, 2]]"]
OF_LISTS = ["A", "C", "[x]", "[x + 1]", "[[x]]", "[]"]


@pytest.mark.parametrize("other", OF_LISTS)
@pytest.mark.parametrize("one", OF_LISTS)
@pytest.mark.parametrize("form", ["{} + {}", "{} - {}", "{}*{}", "({})/({})"])
def test_lists_are_no_numbers(form: str, one: str, other: str) -> None:
    # entries of lists side by side would be lost as those of polynomials are added
    said = [*X, *[["with", text] for text in LISTS]]
    shown = ["shows", [], "==", ALONE, []]
    both = form.format(one, other)
    for text in (
        f"{both} == {both}",
        f"{form.format(one, 'x')} == {both}",
        f"0*{one} == 0",
        f"{one}**2 == {other}**2",
        f"-{one} == {other}",
        f"exp({one}) == exp({other})",
        f"{one} == {one}",
    ):
        assert rejected(certificate(*said, ["claim", text], shown)) is not None, text
    for line in (["with", f"D = {both}"], ["where", f"{one} >= {other}"], ["with", "E = 1 == 1"]):
        whole = certificate(*said, line, ["claim", "x == x"], shown)
        assert rejected(whole) is not None, line
    assert rejected(certificate(*said, ["claim", "x == x"], shown)) is None


def test_claims_are_not_mixed_with_what_is_false() -> None:
    proved = [["claim", "1 == 1"], ["shows", [], "==", ALONE, []]]
    refuted = [["false", "1 == 2"], ["shows", [[[1]]], "!=", ALONE, [[[1], []]]]]
    assert rejected(certificate(*proved)) is None
    assert rejected(certificate(*refuted)) is None
    assert rejected(certificate(*proved, *refuted)) is not None
    assert rejected(certificate(*refuted, *proved)) is not None


def test_without_a_claim_nothing_is_proved() -> None:
    assert rejected(certificate()) is not None
    assert rejected(certificate(*X)) is not None


def matrix(rows: Any) -> str:
    return f"[{', '.join('[' + ', '.join(map(str, row)) + ']' for row in rows)}]"


def of_filter(numbers: Mapping[str, Any], law: str = FILTER) -> Data:
    """All that is wanted is of numbers, each of which has the sign that is seen, or is 0."""
    lines: list[Any] = [["with", f"{name} = {matrix(rows)}"] for name, rows in numbers.items()]
    lines += [["filter", law], ["claim", "K[1,1] == K[1,1]"]]
    whole = certificate(*lines)
    checker = check_answer.Certificate(whole)
    for line in lines:
        checker.line(*line)
    for p, sign in checker.wanted:
        said = [
            [[*c.as_integer_ratio()] if isinstance(c, Fraction) else [c], *m] for m, c in p.items()
        ]
        if said:
            lines.append(["shows", said, ">", ALONE, []])
            if sign == ">=":
                lines.append(["shows", said, ">=", ALONE, [[p[()].as_integer_ratio(), []]]])
        else:
            lines.append(["shows", [], sign, ALONE, []])
    return certificate(*lines)


SCALAR = {"F": [[2]], "H": [[1]], "Q": [[0]], "R": [[1]], "P": [[3]], "K": [["3/4"]]}


@pytest.mark.parametrize(
    ("other", "accepted"),
    [
        ({}, True),
        ({"P": [[0]], "K": [[0]]}, False),  # P = 4 P/(P + 1) for P = 0 too, but F - F K H = 2
        ({"K": [["1/2"]]}, False),
        ({"Q": [[1]]}, False),
        ({"F": [[3]]}, False),
        ({"R": [[2]]}, False),
        ({"P": [[2]]}, False),
        ({"H": [[1, 0]]}, False),
    ],
)
def test_of_two_solutions_only_the_stable_one_is_the_filter(other: Any, accepted: bool) -> None:
    try:
        found = rejected(of_filter(SCALAR | other))
    except (ValueError, TypeError) as error:
        found = str(error)
    assert (found is None) == accepted


@pytest.mark.parametrize(
    ("q", "r", "accepted"),
    [
        ([[3]], 1, True),
        ([[0]], 1, True),
        ([[-3]], 1, False),
        ([[3]], 0, False),
        ([[3]], -1, False),
        ([[1, 1], [1, 1]], 2, True),
        ([[0, 1], [1, 0]], 2, False),
        ([[1, 2], [2, 1]], 2, False),
        ([[0, 0], [0, -1]], 2, False),
        ([[2, 1, 1], [1, 2, 1], [1, 1, 2]], 1, True),
        ([[2, -2, -2], [-2, 2, -2], [-2, -2, 2]], 1, False),  # only the determinant tells
    ],
)
def test_noise_has_a_covariance(q: list[list[int]], r: int, accepted: bool) -> None:
    # F = 1/2 and H = 0: K = 0 and P = P/4 + Q solve all equations whatever Q and R are
    n = len(q)
    half = [["1/2" if i == j else 0 for j in range(n)] for i in range(n)]
    p = [[Fraction(4 * e, 3) for e in row] for row in q]
    model = {"F": half, "H": [[0] * n], "Q": q, "R": [[r]], "P": p, "K": [[0]] * n}
    assert (rejected(of_filter(model)) is None) == accepted


@pytest.mark.parametrize("last", [0, Fraction(-1, 10)])
@pytest.mark.parametrize("size", [1, 2, 3, 4, 5])
def test_each_measurement_has_noise(size: int, last: Fraction | int) -> None:
    # one state that is 0 but for its noise; the last measurement only of it, or of nothing
    r = [[(1 if i < size - 1 else last) if i == j else 0 for j in range(size)] for i in range(size)]
    h = [[0]] * (size - 1) + [[1 if last else 0]]
    k = [[0] * (size - 1) + [Fraction(1) / (1 + last) if last else 5]]
    model = {"F": [[0]], "H": h, "Q": [[1]], "R": r, "P": [[1]], "K": k}
    with pytest.raises((ValueError, AssertionError)):  # what is wanted > 0 may be no number > 0
        assert rejected(of_filter(model)) is None
    r[-1][-1], k[0][-1] = 1, Fraction(1 if last else 0, 2)
    if size <= 3:
        assert rejected(of_filter(model)) is None


@pytest.mark.parametrize("size", [1, 2, 3])
def test_stability_is_that_of_the_eigenvalues(size: int) -> None:
    source, met = random.Random(size), set[bool]()
    zero = [["0"] * size]
    for _ in range(60):
        rows = [
            [Fraction(source.randint(-9, 9), source.choice((4, 7, 11))) for _ in range(size)]
            for _ in range(size)
        ]
        checker = check_answer.Certificate(certificate())
        null = [["0"] * size] * size
        for name, a in zip(
            "FHQRPK", (rows, zero, null, [["1"]], null, [["0"]] * size), strict=True
        ):
            checker.line("with", f"{name} = {matrix(a)}")
        checker.filter(FILTER)
        positive = all(p.get((), 0) > 0 for p, sign in checker.wanted[-5:])
        radius = max(abs(np.linalg.eigvals(np.array(rows, dtype=float))))
        if abs(radius - 1) > 1e-6:
            assert positive == (radius < 1), rows
            met.add(positive)
        values = np.linalg.eigvals(np.array(rows, dtype=float))
        characteristic = np.poly(values)[1:] * [(-1) ** (k + 1) for k in range(size)]
        entries = [[Poly({(): e}) + Poly() for e in row] for row in rows]
        found = [float(p.get((), 0)) for p in symmetric(entries)]
        assert np.allclose(found, characteristic.real)
    assert met == {True, False}


def test_each_certificate_says_what_it_shows(
    certificates: list[Data], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for (formula, _, verdict), data in zip(ASKED, certificates, strict=True):
        status, lines = run(tmp_path / "one.json", data, capsys)
        assert (status, lines[-1]) == (0, verdict), (formula, lines[-1])
    first = certificates[0]
    _, lines = run(tmp_path / "one.json", first, capsys)
    assert "claim:      beta == 2*(2 - alpha) - 4*sqrt(1 - alpha)" in lines
    assert f"filter:     {FILTER}" in lines
    assert "with:       beta = K[2,1]*sampling_interval" in lines
    assert any(line.startswith("with:       Q = [[1/4*tracking_index**2") for line in lines)


def test_one_file_decides_alone(certificates: list[Data], tmp_path: Path) -> None:
    names = {
        a.name
        for n in ast.walk(ast.parse(FILE.read_text()))
        if isinstance(n, ast.Import)
        for a in n.names
    }
    names |= {
        str(n.module)
        for n in ast.walk(ast.parse(FILE.read_text()))
        if isinstance(n, ast.ImportFrom)
    }
    assert names <= sys.stdlib_module_names
    assert len(FILE.read_text().splitlines()) <= 300
    (tmp_path / "alone.py").write_text(FILE.read_text())
    (tmp_path / "one.json").write_text(json.dumps(certificates[2]))
    command = [sys.executable, "-I", "alone.py", "one.json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "proved"
    (tmp_path / "one.json").write_text(json.dumps(certificate(["typed", "\u03b1"])))
    done = subprocess.run(
        command,
        cwd=tmp_path,
        env={"PYTHONIOENCODING": "ascii"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 1
    assert done.stdout.startswith("REJECTED: ")


# what an altered certificate states, evaluated from its lines


def value(node: Any, known: Mapping[str, Any]) -> Any:
    match node:
        case str():
            return value(ast.parse(node.strip(), mode="eval").body, known)
        case ast.Constant(value=number):
            return mpmath.mpf(number)
        case ast.Name() | ast.Subscript():
            return known[ast.unparse(node)]
        case ast.List(elts=parts):
            return [value(part, known) for part in parts]
        case ast.UnaryOp(operand=a):
            return -value(a, known)
        case ast.Call(func=ast.Name(id=name), args=[a]):
            inner = value(a, known)
            if name == "sqrt" and inner < 0:
                raise ZeroDivisionError
            return getattr(mpmath, name)(inner)
        case ast.BinOp(left=left, op=op, right=right):
            a, b = value(left, known), value(right, known)
            names = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "truediv"}
            return (
                a ** int(b) if isinstance(op, ast.Pow) else getattr(a, f"__{names[type(op)]}__")(b)
            )
    raise AssertionError(ast.dump(node))


def holds(text: str, known: Mapping[str, Any]) -> bool:
    node: Any = ast.parse(text.strip(), mode="eval").body
    left, right = value(node.left, known), value(node.comparators[0], known)
    difference = left - right
    if abs(difference) < (1 + abs(left) + abs(right)) * mpmath.mpf(10) ** -30:
        difference = mpmath.mpf(0)
    names = {ast.Eq: "eq", ast.NotEq: "ne", ast.Gt: "gt", ast.GtE: "ge"}
    return bool(getattr(difference, f"__{names[type(node.ops[0])]}__")(0))


def steady_state(known: dict[str, Any]) -> None:
    f, h, q, r = (mpmath.matrix(known[name]) for name in "FHQR")
    p = q + mpmath.eye(f.rows)
    for _ in range(3000):
        s = h * p * h.T + r
        k = p * h.T * s**-1
        x = p - k * h * p
        after = f * x * f.T + q
        done = mpmath.mnorm(after - p) < mpmath.mpf(10) ** -45 * mpmath.mnorm(p)
        p = after
        if done:
            break
    for name, a in (("P", p), ("K", k), ("S", s), ("X", x)):
        for i in range(a.rows):
            for j in range(a.cols):
                known[f"{name}[{i + 1}, {j + 1}]"] = a[i, j]


def is_so(data: Data, known: dict[str, Any]) -> bool:
    """Whether it states what is so with these values of its variables."""
    missing = False
    for title, *said in data["lines"]:
        try:
            if title == "with":
                name, _, text = said[0].partition("=")
                known[name.strip()] = value(text, known)
            elif title == "filter":
                steady_state(known)
            elif title == "where" and not holds(said[0], known):
                return True
        except (ZeroDivisionError, KeyError):
            missing = True
    try:
        claims = [line[:2] for line in data["lines"] if line[0] in ("claim", "false")]
        return not missing and all(holds(t, known) == (kind == "claim") for kind, t in claims)
    except ZeroDivisionError:
        return False


def states_what_is_so(data: Data, source: random.Random) -> bool:
    names = [line[1].strip() for line in data["lines"] if line[0] == "real"]
    with mpmath.workdps(60):
        for _ in range(40 if names else 1):
            far = [
                mpmath.mpf(source.randint(1, 999)) / source.choice((100, 300, 1000)) for _ in names
            ]
            known = {n: v * source.choice((1, 1, -1)) for n, v in zip(names, far, strict=True)}
            if not is_so(data, known):
                return False
    return True


def altered(data: Data, source: random.Random) -> Data:
    """One number, sign, letter or fact of a step changed, or of the text of a line, or one gone."""
    data = copy.deepcopy(data)
    steps = [line for line in data["lines"] if line[0] in ("shows", "opens", "sums")]
    texts = [
        line for line in data["lines"] if line[0] in ("with", "where", "claim", "false", "real")
    ]
    choice = source.random()
    if choice < 0.1:
        data["lines"].remove(source.choice(data["lines"]))
    elif choice < 0.2 and data["point"]:
        data["point"][source.choice([*data["point"]])] = [source.randint(-3, 3)]
    elif choice < 0.6 or not steps:
        line = source.choice(texts)
        pairs = [
            ("+", "-"),
            ("-", "+"),
            ("2", "3"),
            ("4", "5"),
            ("1", "2"),
            ("==", "!="),
            (">", ">="),
            ("*", "+"),
        ]
        old, new = source.choice([pair for pair in pairs if pair[0] in line[1]] or [("x", "y")])
        places = [k for k in range(len(line[1])) if line[1].startswith(old, k)]
        if places:
            k = source.choice(places)
            line[1] = line[1][:k] + new + line[1][k + len(old) :]
    else:
        alter(source.choice(steps), source)
    return data


def alter(step: list[Any], source: random.Random) -> None:
    places: list[tuple[list[Any], int]] = []

    def visit(part: list[Any]) -> None:
        for k, each in enumerate(part):
            if isinstance(each, list):
                visit(each)
            elif part is not step or k:
                places.append((part, k))

    visit(step)
    part, k = source.choice(places)
    if isinstance(part[k], int):
        part[k] += source.choice((-1, 1, 2))
    else:
        part[k] = source.choice(["==", ">", ">=", "!=", "x", "y", "alpha"])


@pytest.mark.parametrize("seed", range(len(ASKED)))
def test_an_altered_certificate_is_rejected_or_states_what_is_so(
    seed: int, certificates: list[Data]
) -> None:
    source = random.Random(seed)
    original = certificates[seed]
    assert states_what_is_so(original, source)
    refused = 0
    for _ in range(16):
        data = altered(original, source)
        if rejected(data) is None:
            assert states_what_is_so(data, source), json.dumps(data)
        else:
            refused += 1
    assert refused > 4 or ASKED[seed][2] == "refuted"


def test_long_numbers_are_no_hindrance() -> None:
    # more than 4300 digits, which Python does not write out
    number = "*".join(["(10**64)**64", *["10**64"] * 4])
    shown = ["shows", [[[1]]], ">", ALONE, [[[1], []]]]
    assert rejected(certificate(["claim", f"{number}/({number}) > 0"], shown)) is None
    with_ = ["with", f"b = {number}"]
    assert (
        rejected(certificate(*X, with_, ["claim", "b*x == x*b"], [*SHOWN[:1], [], "==", ALONE, []]))
        is None
    )
    large = ["claim", f"{number} > 0"]
    assert (
        rejected(certificate(large, ["shows", [[[10**4352]]], ">", ALONE, [[[10**4352], []]]]))
        is None
    )


@pytest.mark.parametrize("arguments", [[], ["-h"], ["--help"]])
def test_who_asks_is_told_the_usage(arguments: list[str]) -> None:
    command = [sys.executable, str(FILE), *arguments]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert "Usage: check_answer.py certificate.json" in done.stderr
    assert "Error" not in done.stdout + done.stderr


DEEP = "[" * 100_000 + "]" * 100_000
GROWING = [["with", f"a{k} = a{k - 1}**64"] for k in range(1, 9)]
FOUR = [line for name in "xyuv" for line in real(name)]
BIG = "((x + y + u + v)**12)*((x + y + u - v)**11)"
LONG = ["claim", f"{BIG} == {BIG}"]


def fractions(letters: str) -> list[Any]:
    """Many terms of two letters, with many digits."""
    top, bottom, x, y = 3**3000, str(7**1700), letters[0], letters[1]
    return [[[str(top + k), bottom], *[x] * (k % 21), *[y] * (k // 21)] for k in range(440)]


HOSTILE: list[Any] = [
    # each line is short, all together take hours
    certificate(*FOUR, *[LONG] * 10_000),
    certificate(
        *[["claim", f"{k} > 0"] for k in range(1, 60_000)] + [["shows", [], "==", ALONE, []]]
    ),
    # what a terminal obeys, in the reason
    certificate(["claim", "\x1b[2K\x1b[1Gclaim:\xa01\xa0==\xa02\x1bEproved\x1b[8m"]),
    certificate(["\x1b[2Kproved", "1 == 1"]),
    certificate(*X, ["shows", [[[1], "\x1b[2Kproved"]], "==", ALONE, []], ["claim", "x == x"]),
    "",
    "[]",
    "{}",
    DEEP,
    '{"format": 1e999}',
    "9" * 10_000,
    certificate(*X, ["claim", "(" * 900 + "x" + ")" * 900 + " == x"]),
    certificate(*X, ["claim", "-" * 1900 + "x == x"]),
    certificate(*X, ["claim", "+".join(["x"] * 900) + " == x"]),
    certificate(*X, ["claim", "x**1000000000 == 0"]),
    certificate(*X, ["claim", "2**64**64 == 0"]),
    certificate(*X, ["claim", "x" * 5000 + " == 0"]),
    certificate(["with", "a0 = 1/7"], *GROWING, ["claim", "a8 == 0"]),
    certificate(*X, ["with", "a0 = x + 1"], *GROWING, ["claim", "a8 == 0"]),
    certificate(*X, ["claim", f"{'9' * 1900} == 0"]),
    certificate(*X, ["claim", "1/0 == 0"]),
    certificate(*X, ["claim", "1/(x - x) == 0"], ["opens", "1/(x - x)", 0]),
    certificate(
        ["claim", "exp(exp(exp(9))) == 0"], ["shows", [[[1], "exp(exp(exp(9)))"]], ">", ALONE, []]
    ),
    certificate(["claim", "1 > 0"], ["shows", [[["1e99999999"]]], ">", ALONE, []]),
    certificate(["claim", "1 > 0"], ["shows", [[[1, 0]]], ">", ALONE, []]),
    certificate(*real("x", "x > 0"), ["claim", "x > 0"], x=["1e99999999"]),
    certificate(*real("x", "x > 0"), ["claim", "x > 0"]),
    certificate(["claim", "system(1) == 0"]),
    certificate(["claim", "__import__ == 0"]),
    certificate([]),
    certificate(["shows"]),
    certificate(["claim", 1]),
    certificate(["claim", None]),
    certificate(["claim", "1 == 1", "1 == 1"]),
    certificate("claim"),
    certificate(*X, ["shows", [[[1], 5]], "==", ALONE, []]),
    certificate(*X, ["shows", {"x": 1}, "==", ALONE, []], ["claim", "x == 0"]),
    {"format": FORMAT, "lines": {"claim": "1 == 1"}},
    {"format": FORMAT},
    {"format": "gainproof answer certificate 1", "lines": []},
    certificate(
        *[["real", x] for x in "abcd"],
        ["shows", fractions("ab"), "==", [1, []], [], fractions("cd")],
    ),
]


@pytest.mark.parametrize("number", range(len(HOSTILE)))
def test_what_is_hostile_is_refused_in_a_line(
    number: int,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(check_answer, "SECONDS", 3)
    start = time.process_time()
    status, lines = run(tmp_path / "one.json", HOSTILE[number], capsys)
    assert status == 1
    assert len(lines) == 1
    assert lines[0].startswith("REJECTED: ")
    assert len(lines[0]) < 500
    assert lines[0].isprintable()
    assert time.process_time() - start < 15


BUCY = {"A": [[0]], "H": [[1]], "Q": [[4]], "R": [[9]], "P": [[6]], "K": [["2/3"]]}
TWO = {
    # x'' = w, position measured, Q = R = 1: K = [sqrt 2, 1] is no number, so with Q = 4: K = [2, 2]
    "A": [[0, 1], [0, 0]],
    "H": [[1, 0]],
    "Q": [[0, 0], [0, 4]],
    "R": [[1]],
    "P": [[2, 2], [2, 4]],
    "K": [[2], [2]],
}


@pytest.mark.parametrize(
    ("model", "other", "accepted"),
    [
        (BUCY, {}, True),
        (BUCY, {"P": [[-6]], "K": [["-2/3"]]}, False),  # the other root, which is not stable
        (BUCY, {"K": [["3/2"]]}, False),
        (BUCY, {"Q": [[5]]}, False),
        (BUCY, {"R": [[-9]], "P": [[6]], "K": [["-2/3"]], "Q": [[-4]]}, False),
        (BUCY, {"A": [[1]]}, False),
        (BUCY, {"H": [[2]]}, False),
        # A = -1 and no noise: K = 0, and with A = 1 the filter that does nothing is not stable
        (BUCY, {"A": [[-1]], "Q": [[0]], "P": [[0]], "K": [[0]]}, True),
        (BUCY, {"A": [[1]], "Q": [[0]], "P": [[0]], "K": [[0]]}, False),
        (TWO, {}, True),
        (TWO, {"P": [[-2, 2], [2, -4]], "K": [[-2], [2]]}, False),
        (TWO, {"Q": [[0, 0], [0, -4]]}, False),
        (TWO, {"Q": [[0, 1], [1, 4]]}, False),
        (TWO, {"P": [[2, 2], [1, 4]]}, False),
    ],
)
def test_in_continuous_time_only_the_stable_solution_is_the_filter(
    model: Any, other: Any, accepted: bool
) -> None:
    try:
        found = rejected(of_filter(model | other, KALMAN_BUCY))
    except (ValueError, TypeError) as error:
        found = str(error)
    assert (found is None) == accepted


def test_three_states_in_continuous_time_are_not_covered() -> None:
    unit = [[int(i == j) for j in range(3)] for i in range(3)]
    null = [[0] * 3] * 3
    model = {"A": [[-e for e in row] for row in unit], "H": [[0] * 3], "Q": null, "R": [[1]]}
    with pytest.raises((ValueError, AssertionError, TypeError)):
        assert rejected(of_filter(model | {"P": null, "K": [[0]] * 3}, KALMAN_BUCY)) is None


def any_gains(seed: int) -> dict[str, Any]:
    """A filter with gains of no optimum, solved in fractions: covariance and lag by a system."""
    source = random.Random(seed)
    size = seed % 3 + 1
    f = [[Fraction(int(i == j) + int(j == i + 1)) for j in range(size)] for i in range(size)]
    k = [[Fraction(source.randint(3, 6), 10)] for _ in range(size)]
    k = [[row[0] / 4**i] for i, row in enumerate(k)]
    h = [[Fraction(int(j == 0)) for j in range(size)]]
    q = [[Fraction(int(i == j == size - 1)) for j in range(size)] for i in range(size)]
    d = [[Fraction(source.randint(-3, 3))] for _ in range(size)]
    known = {"F": f, "H": h, "Q": q, "R": [[Fraction(2)]], "K": k, "D": d}
    a, b = (np.array(known[name], dtype=object) for name in ("F", "K"))
    loop = a - a.dot(b).dot(np.array(h, dtype=object))
    noise = np.array(q, dtype=object) + 2 * a.dot(b).dot(a.dot(b).T)
    p = solved(np.kron(loop, loop), noise.reshape(-1)).reshape(size, size)
    lag = solved(loop, np.array(d, dtype=object).reshape(-1))
    return known | {"P": p.tolist(), "L": [[e] for e in lag]}


def solved(m: Any, b: Any) -> Any:
    """x = m x + b by elimination in fractions."""
    size = len(b)
    rows = [[int(i == j) - m[i][j] for j in range(size)] + [b[i]] for i in range(size)]
    for i in range(size):
        k = next(k for k in range(i, size) if rows[k][i])
        rows[i], rows[k] = rows[k], rows[i]
        rows[i] = [e / rows[i][i] for e in rows[i]]
        for k in range(size):
            if k != i:
                rows[k] = [x - rows[k][i] * y for x, y in zip(rows[k], rows[i], strict=True)]
    return np.array([row[-1] for row in rows], dtype=object)


@pytest.mark.parametrize("other", ["", "P", "L", "D", "K", "Q", "R", "F", "H", "-Q"])
@pytest.mark.parametrize("seed", range(6))
def test_of_any_gains_covariance_and_lag_are_steady(seed: int, other: str) -> None:
    model = any_gains(seed)
    loop = np.array(model["F"], dtype=float) - np.array(model["F"], dtype=float).dot(
        np.array(model["K"], dtype=float)
    ).dot(np.array(model["H"], dtype=float))
    assert max(abs(np.linalg.eigvals(loop))) < 1
    if other == "-Q":
        model |= {"Q": [[-e for e in row] for row in model["Q"]]}
    elif other:
        rows = [[*row] for row in model[other]]
        rows[0][0] += Fraction(1, 7)
        model |= {other: rows}
    try:
        found = rejected(of_filter(model, GAINS))
    except (ValueError, TypeError, AssertionError) as error:
        found = str(error)
    assert (found is None) == (other == "")


def test_gains_that_are_not_stable_have_no_steady_state() -> None:
    # P = (1 - K)^2 P + K^2 R + Q has a solution for K = 3 too, but errors double in each step
    model = {"F": [[1]], "H": [[1]], "Q": [[3]], "R": [[1]], "K": [[3]], "P": [[-4]]}
    with pytest.raises((ValueError, AssertionError)):
        assert rejected(of_filter(model | {"L": [[0]], "D": [[0]]}, GAINS)) is None
