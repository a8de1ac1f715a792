"""Certificates about matrices of any size: each step by hand, right and wrong; what is altered.

What an altered certificate states is evaluated with NumPy at drawn matrices: nothing of the
checker's own.
"""

from __future__ import annotations

import ast
import copy
import json
import random
import subprocess
import sys
import time
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matrix_claims import SYMBOLS, judged_matrices

from gainproof.verify import check_matrices
from gainproof.verify.certificate.matrix_words import proof as words
from gainproof.verify.check_matrices import FORMAT, Certificate, main
from gainproof.verify.judge.answer_certificate import (
    NoCertificateError,
    answer_certificate,
    rejected,
)
from gainproof.verify.judge.matrix_certificate import matrix_certificate

FILE = Path(check_matrices.__file__)
Data = dict[str, Any]
ASKED = [
    r"(A B)^T = B^T A^T",
    r"H^T V H = V_2",
    r"V = \begin{pmatrix} V_1 & V_{12} \\ V_{12}^T & V_2 \end{pmatrix}",
    r"(Q B Q)^T = Q B^T Q",
    r"(Q + A^T R A)^{-1} = Q^{-1} - Q^{-1} A^T (R^{-1} + A Q^{-1} A^T)^{-1} A Q^{-1}",
    r"H^T V^{-1} H = (V_2 - V_{12}^T V_1^{-1} V_{12})^{-1}",
    r"E[z] = A a",
    r"E[v v^T] = R",
    r"E[v w^T] = 0",
    r"0 < Q + A^T A",
    r"0 \leq A^T A",
]


def made(latex: str) -> Data:
    kind = "inequality" if latex[0] == "0" else "identity"
    verdict = judged_matrices(latex, kind=kind)
    assert verdict.verdict == "proved", verdict.reason
    proofs = verdict.certificate["words"]
    assert all(words.rejected(proof | {"asked": [None, True]}) is None for proof in proofs)
    found, _ = matrix_certificate({"typed": latex}, proofs)
    return json.loads(json.dumps(found))  # type: ignore[no-any-return]


@pytest.fixture(scope="module")
def certificates() -> list[Data]:
    return [made(latex) for latex in ASKED]


def certificate(*lines: Any, sizes: Any = None, **numbers: Any) -> Data:
    """A number stands for that multiple of the unit matrix of 2 rows."""
    all_of = {k: a if isinstance(a, list) else [[a, 0], [0, a]] for k, a in numbers.items()}
    said = {k: [[str(x) for x in row] for row in a] for k, a in all_of.items()}
    sizes = sizes or {"size_n": 2, "size_m": 3}
    return {"format": FORMAT, "sizes": sizes, "numbers": said, "lines": lines}


A, B = ["matrix", "A = size_n by size_m"], ["matrix", "B = size_m by size_n"]
S, T = ["matrix", "S = size_n by size_n"], ["matrix", "T = size_n by size_n"]
ROW, COLUMN = [[1, 2, 0], [0, 1, 1]], [[3, 1], [4, 0], [5, 2]]
SYMMETRIC = ["where", "S.T == S"]
POSITIVE = ["where", "S > 0"]
INVERSE = ["inverse", "T = S**-1"]
FREE = {"A": ROW, "B": COLUMN}
TWO = {"S": 2, "T": "1/2"}

RIGHT: list[Any] = [
    ([A, B, ["claim", "(A*B).T == B.T*A.T"], ["shows", "(A*B).T == B.T*A.T", []]], FREE),
    ([A, ["claim", "A.T*A >= 0"], ["shows", "A.T*A >= 0", [], [["1", "A", None]]]], {"A": ROW}),
    ([S, SYMMETRIC, ["claim", "S == S.T"], ["shows", "S == S.T", [["-1", 0, "1"]]]], {"S": 3}),
    ([S, POSITIVE, INVERSE, ["claim", "T*S == 1"], ["opens", "T", 0]], TWO),
    (
        [
            S,
            POSITIVE,
            ["claim", "S + 1 > 0"],
            ["shows", "S + 1 > 0", [], [["1", "1", 0], ["1", "1", None]], [["1", 1, "1"]]],
        ],
        {"S": 2},
    ),
    (
        [
            S,
            ["random", "v = S"],
            A,
            ["claim", "E(A.T*v*v.T*A) == A.T*S*A"],
            ["shows", "A.T*S*A == A.T*S*A", []],
        ],
        {"S": 2, "v": 0, "A": ROW},
    ),
    (
        [
            S,
            ["random", "v = S"],
            ["random", "w = S"],
            ["matrix", "A = 1 by size_n"],
            ["claim", "E(v*v.T + v*w.T + v*A) == S"],
            ["shows", "E(v*v.T + v*w.T + v*A) == S", []],
        ],
        {"S": 2, "v": 0, "w": 0, "A": [[1, 2]]},
    ),
    ([["unit", "I = size_n"], ["claim", "I*I == I"], ["shows", "I*I == I", []]], {}),
    (
        [
            ["name", "size_n for n"],
            ["name", "J for I"],
            ["unit", "J = size_n"],
            ["claim", "J.T == J"],
            ["shows", "J.T == J", []],
        ],
        {},
    ),
]
BOTH = [["1", 0, "1"], ["T", 0, "U"]]
"""Multiples from both sides."""
WRONG: list[Any] = [
    # a property that is not printed
    ([S, ["claim", "S == S.T"], ["shows", "S == S.T", []]], {"S": 3}),
    ([S, ["claim", "S == S.T"], ["shows", "S == S.T", [["-1", 0, "1"]]]], {"S": 3}),
    ([S, ["claim", "S >= 0"], ["shows", "S >= 0", [], [["1", "1", 0]]]], {"S": 3}),
    ([S, SYMMETRIC, ["claim", "S >= 0"], ["shows", "S >= 0", [], [["1", "1", 0]]]], {"S": 3}),
    # an inverse that is not supposed or shown, or of something else
    ([S, INVERSE, ["claim", "T*S == 1"], ["shows", "T*S == 1", []]], TWO),
    ([S, SYMMETRIC, INVERSE, ["claim", "T*S == 1"], ["opens", "T", 0]], TWO),
    ([S, ["where", "S >= 0"], INVERSE, ["claim", "T*S == 1"], ["opens", "T", 0]], TWO),
    ([S, ["where", "S + 1 > 0"], INVERSE, ["claim", "T*S == 1"], ["opens", "T", 0]], TWO),
    ([S, POSITIVE, INVERSE, ["claim", "1 == S - S + 1"], ["shows", "1 == S - S + 1", []]], TWO),
    ([A, B, ["inverse", "T = A**-1"], ["claim", "A == A"], ["shows", "A == A", []]], FREE),
    ([S, SYMMETRIC, INVERSE, ["claim", "T*S == 1"], ["opens", "T", 0, "S"]], TWO),
    # shapes that do not fit, also where it drops out
    ([A, B, ["claim", "A*A == A*A"], ["shows", "A*A == A*A", []]], FREE),
    ([A, B, ["claim", "A - A + B == B"], ["shows", "B == B", []]], FREE),
    ([A, B, ["claim", "A + 1 == 1 + A"], ["shows", "A == A", []]], FREE),
    ([A, B, ["claim", "A.T*B == A.T*B"], ["shows", "A.T*B == A.T*B", []]], FREE),
    ([A, ["claim", "A > 0"], ["shows", "A > 0", [], [["1", "A", None]]]], {"A": ROW}),
    # letters do not commute, products are transposed backwards
    ([S, T, ["claim", "S*T == T*S"], ["shows", "S*T == T*S", []]], {"S": 3, "T": 4}),
    ([S, T, ["claim", "(S*T).T == S.T*T.T"], ["shows", "(S*T).T == S.T*T.T", []]], TWO),
    # a relation that is not printed, one that does not exist, an order in its place
    ([S, T, ["claim", "S == T"], ["shows", "S == T", [["1", 0, "1"]]]], TWO),
    ([S, POSITIVE, ["claim", "S == 0"], ["shows", "S == 0", [["1", 0, "1"]]]], {"S": 3}),
    # squares: a negative number, rank that is missing, an equation by squares
    ([A, ["claim", "0 >= A.T*A"], ["shows", "0 >= A.T*A", [], [["-1", "A", None]]]], {"A": ROW}),
    ([A, ["claim", "A.T*A > 0"], ["shows", "A.T*A > 0", [], [["1", "A", None]]]], {"A": ROW}),
    (
        [A, ["claim", "A.T*A > 0"], ["shows", "A.T*A > 0", [], [["1", "A", None]], [["A.T", 0]]]],
        {"A": ROW},
    ),
    ([A, ["claim", "A.T*A == 0"], ["shows", "A.T*A == 0", [], [["1", "A", None]]]], {"A": ROW}),
    (
        [
            S,
            ["where", "S >= 0"],
            ["claim", "S > 0"],
            ["shows", "S > 0", [], [["1", "1", 0]], [["1", 0, "1"]]],
        ],
        {"S": 3},
    ),
    ([S, POSITIVE, ["claim", "S.T == 0"], ["shows", "S.T == 0", [["1", 1, "1"]]]], {"S": 3}),
    (
        [
            S,
            ["claim", "S.T*S + S*S.T*S >= 0"],
            ["shows", "S.T*S + S*S.T*S >= 0", [], [["1 + S", "S", None]]],
        ],
        {"S": 3},
    ),
    # definite by a multiple from the right: C' C = 1 - F' C' C F here; and what is 0 from that
    (
        [
            ["matrix", "C = size_m by size_n"],
            S,
            ["where", "C.T*C + S.T*C.T*C*S == 1"],
            ["claim", "C.T*C > 0"],
            [
                "shows",
                "C.T*C > 0",
                [],
                [["1", "C", None]],
                [["C.T", 0, "1"], ["S.T*C.T", 0, "S"]],
                [["-1", 0, "1"]],
            ],
        ],
        {"S": 0, "C": [[1, 0], [0, 1], [0, 0]]},
    ),
    (
        [
            *(["matrix", f"{name} = size_n by size_n"] for name in "STUV"),
            ["where", "S + T*S*U == 1"],
            ["where", "V + U*V*T == 1"],
            ["where", "S*V == 0"],
            ["claim", "S > S"],
            ["shows", "S.T*S > 0", [], [["1", "S", None]], BOTH, [["-1", 0, "1"]]],
            [
                "shows",
                "S > S",
                [["-V.T*S.T", 4, "1"]],
                [["1", "V", 6]],
                [["1", 0, "1"], ["U", 0, "T"]],
                [["-1", 2, "1"]],
            ],
        ],
        {
            "S": [[1, 0], [0, 0]],
            "T": [[0, 0], [1, 0]],
            "U": [[0, 1], [0, 0]],
            "V": [[0, 0], [0, 1]],
        },
    ),
    # conditions that nothing meets, or not these numbers
    (
        [
            S,
            POSITIVE,
            INVERSE,
            ["opens", "T", 0],
            ["where", "S == 2"],
            ["where", "T == 5"],
            ["claim", "S == S"],
            ["shows", "S == S", []],
        ],
        {"S": 2, "T": 5},
    ),
    ([S, POSITIVE, ["where", "S == 0"], ["claim", "S == 0"]], {"S": 0}),
    ([S, POSITIVE, ["claim", "S > 0"]], {"S": -2}),
    ([S, POSITIVE, ["claim", "S > 0"]], {"S": 0}),
    ([S, ["where", "0 - S.T*S - 1 >= 0"], ["claim", "S == 1"]], {"S": 1}),
    ([S, POSITIVE, ["claim", "S > 0"]], {}),
    ([S, POSITIVE, ["claim", "S > 0"]], {"S": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}),
    ([["matrix", "S = 2 by 2"], POSITIVE, ["claim", "S > 0"]], {"S": [[1, 2], [2, 1]]}),
    ([["matrix", "S = 2 by 2"], POSITIVE, ["claim", "S > 0"]], {"S": [[1, 1], [0, 1]]}),
    # means: a mean of one, of other words, conditions on what is random, what is named later
    ([S, ["random", "v = S"], ["claim", "E(v) == v"]], {"S": 2, "v": 0}),
    ([S, ["random", "v = S"], ["claim", "E(v.T*v) == S"]], {"S": 2, "v": 0}),
    (
        [
            S,
            ["matrix", "c = 1 by 1"],
            ["random", "v = S"],
            ["claim", "E(v*c*v.T) == E(v*c*v.T)"],
            ["shows", "E(v*c*v.T) == E(v*c*v.T)", []],
        ],
        {"S": 2, "v": 0, "c": [[1]]},
    ),
    ([S, ["random", "v = S"], ["claim", "E(v.T*S*v) == 0"]], {"S": 2, "v": 0}),
    (
        [
            S,
            *(["random", f"{v} = S"] for v in "uvw"),
            ["claim", "E(u*v.T*w) == 0"],
            ["shows", "E(u*v.T*w) == 0", []],
        ],
        {"S": 2},
    ),
    ([S, ["random", "v = S"], ["where", "v == 0"], ["claim", "v == 0"]], {"S": 2, "v": 0}),
    (
        [S, ["random", "v = S"], ["let", "w = v"], ["claim", "E(w) == w"], ["shows", "w == w", []]],
        {"S": 2, "v": 0, "w": 0},
    ),
    (
        [
            S,
            ["matrix", "v = size_n by 1"],
            ["claim", "E(v) == v"],
            ["shows", "v == v", []],
            ["random", "v = S"],
        ],
        {"S": 2, "v": 0},
    ),
    (
        [S, ["random", "v = S"], ["claim", "E(v) == 0"], ["shows", "E(v) == 0", []]],
        {"S": -2, "v": 0},
    ),
    (
        [A, ["random", "v = A"], ["claim", "E(v) == 0"], ["shows", "E(v) == 0", []]],
        {"A": ROW, "v": 0},
    ),
    # nothing claimed, or nothing shown
    ([S], {"S": 3}),
    ([], {}),
    ([S, ["claim", "S == 0"]], {"S": 0}),
    # lines that mislead
    ([S, ["claim", "S == S"], ["shows", "S == S", []], ["with", "S = 5"]], {"S": 3}),
    ([S, ["claim", "S == S"], ["shows", "S == S", []], ["matrix", "S = 2 by 2"]], {"S": 3}),
    ([S, ["claim", "S == S"], ["shows", "S == S", []], ["typed", "a\nproved"]], {"S": 3}),
    (
        [S, ["claim", "S == S"], ["shows", "S == S", []], ["matrix", "\nU = size_n by size_n"]],
        {"S": 3},
    ),
    ([S, ["claim", "S == S"], ["shows", "S == S", []], ["unit", "I = size_n by size_m"]], {"S": 3}),
    ([S, ["claim", "S == S"], ["shows", "S == S", []], ["other", "S"]], {"S": 3}),
    ([["matrix", "E = size_n by size_n"], ["claim", "E == E"], ["shows", "E == E", []]], {"E": 3}),
    ([["matrix", "S = size_n by 0"], ["claim", "S == S"], ["shows", "S == S", []]], {"S": [[]]}),
]


SHOWN = [["claim", "S == S"], ["shows", "S == S", []]]
"""What is right, of S."""
ONES: list[Any] = [["matrix", "e = size_n by 1"], ["where", "e*e.T == 1"]]
FAULTS: list[Any] = [
    # words of Python as letters
    *(
        ([["matrix", f"{name} = size_n by size_n"], S, *SHOWN], {"S": 3, name: 3}, "not known")
        for name in ("True", "False", "None", "lambda", "if", "E")
    ),
    ([S, ["claim", "S/True == S"], ["shows", "S/True == S", []]], {"S": 3}, "not known"),
    # an order, a variance of what is not square, where nothing is left of it too
    ([A, ["claim", "A >= A"], ["shows", "0 >= 0", []]], {"A": ROW}, "not square"),
    ([A, ["where", "A > A - A"], S, *SHOWN], {"A": ROW, "S": 3}, "not square"),
    ([A, ["random", "v = A - A"], S, *SHOWN], {"A": ROW, "S": 3, "v": 0}, "not square"),
    # a run of blanks that pushes text out of sight
    *(
        ([S, *SHOWN, line], {"S": 3}, "misleads")
        for line in (
            ["where", "S  == S"],
            ["claim", " S == S"],
            ["typed", "a  proved"],
            ["typed", "a\tb"],
            ["typed", "a\x1b[2Jproved"],
            ["name", "S for\u00a0T"],
        )
    ),
    # numbers that look like others
    *(
        ([S, ["claim", f"{n}*S == {n}*S"], ["shows", f"{n}*S == {n}*S", []]], {"S": 3}, "")
        for n in ("1_0", "0x10", "1e1", "1.0", "00", "0b1", "1j")
    ),
    # a relation inside of an expression, none where there has to be one
    ([S, *SHOWN, ["with", "T = (S == S)"]], {"S": 3}, "a relation, or none"),
    ([S, *SHOWN, ["with", "T = S == S"]], {"S": 3}, ""),
    ([S, *SHOWN, ["let", "T = (S == S)*S"]], {"S": 3, "T": 3}, "a relation, or none"),
    ([S, *SHOWN, ["where", "S"]], {"S": 3}, "a relation, or none"),
    ([S, *SHOWN, ["where", "S == S == S"]], {"S": 3}, "not known"),
    # a number that is a letter as the weight of a square
    (
        [
            A,
            ["let", "x = 2"],
            ["claim", "0 >= A.T*A"],
            ["shows", "0 >= A.T*A", [["-1", 0, "A.T*A"]], [["1 - x", "A", None]]],
        ],
        {"A": ROW, "x": 2},
        "no shape",
    ),
    ([["matrix", "R = rows by rows"], S, *SHOWN], {"R": 3, "S": 3}, "no shape"),
    ([S, POSITIVE, ["inverse", "T = S"], ["opens", "T", 0], *SHOWN], TWO, "no inverse"),
    # conditions that nothing meets but one row, or sizes that are the same
    ([*ONES, S, *SHOWN], {"S": 3, "e": [[1], [0]]}, "do not meet"),
    ([*ONES, S, *SHOWN], {"S": [[3]], "e": [[1]], "sizes": {"size_n": 1}}, "sizes alike"),
    ([A, S, *SHOWN], {"A": [[1, 2], [3, 4]], "S": 3, "sizes": {"size_n": 2, "size_m": 2}}, "alike"),
    ([S, *SHOWN], {"S": 3, "sizes": {"size_n": True}}, "sizes alike"),
    ([S, *SHOWN], {"S": 3, "sizes": {"size_n": 2.0}}, "sizes alike"),
    # one name of two things
    *(
        ([*(["name", line] for line in lines), S, T, *SHOWN], {"S": 3, "T": 3}, "two things")
        for lines in (
            ["S for T"],
            ["S for size_n"],
            ["size_n for S"],
            ["S for Q", "T for Q"],
            ["S for Q", "S for P"],
            ["size_n for n", "size_n for m"],
            # what is no letter and no size
            ["U for Q"],
            ["S.T for Q"],
            ["+ for -"],
            ["2 for n"],
            ["n for S", "S for n"],
            ["size_m for m"],
            ["S is what is 0 for Q"],
        )
    ),
    ([["matrix", "S = size_2 by size_2"], *SHOWN], {"S": 3, "sizes": {"size_2": 2}}, "no shape"),
    ([["unit", "I = size_07"], S, *SHOWN], {"S": 3}, "not known: unit"),
    # what is random under a condition
    ([S, ["random", "v = S"], ["where", "v.T*v >= 1"], *SHOWN], {"S": 3, "v": [[1], [0]]}, "v"),
]


@pytest.mark.parametrize("number", range(len(FAULTS)))
def test_a_fault_is_refused_for_what_it_is(number: int) -> None:
    lines, numbers, reason = FAULTS[number]
    found = rejected(certificate(*lines, **numbers))
    assert found is not None
    assert reason in found


@pytest.mark.parametrize("number", range(len(RIGHT)))
def test_what_follows_is_accepted(number: int) -> None:
    lines, numbers = RIGHT[number]
    assert rejected(certificate(*lines, **numbers)) is None


@pytest.mark.parametrize("number", range(len(WRONG)))
def test_what_does_not_follow_is_refused(number: int) -> None:
    lines, numbers = WRONG[number]
    assert rejected(certificate(*lines, **numbers)) is not None


def test_definite_is_that_of_the_eigenvalues() -> None:
    source, met = random.Random(1), set[Any]()
    for _ in range(200):
        n = source.randint(1, 4)
        half = np.array([[source.randint(-2, 2) for _ in range(n)] for _ in range(n)])
        matrix = half @ half.T + source.choice((-1, 0, 0, 1)) * np.eye(n, dtype=int)
        least = min(np.linalg.eigvalsh(matrix))
        rows = [[Fraction(int(x)) for x in row] for row in matrix]
        checker = Certificate({"format": FORMAT})
        found = checker.is_positive(rows, True), checker.is_positive(rows, False)
        assert found == (bool(least > 1e-9), bool(least > -1e-9)), matrix
        met.add(found)
    assert len(met) == 3


def run(path: Path, data: Any, capsys: pytest.CaptureFixture[str]) -> tuple[int, list[str]]:
    path.write_text(data if isinstance(data, str) else json.dumps(data))
    status = main([str(path)])
    return status, capsys.readouterr().out.splitlines()


def test_each_certificate_says_what_it_shows(
    certificates: list[Data], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for latex, data in zip(ASKED, certificates, strict=True):
        status, lines = run(tmp_path / "one.json", data, capsys)
        assert (status, lines[-1]) == (0, "proved"), (latex, lines[-1])
    _, lines = run(tmp_path / "one.json", certificates[1], capsys)
    text = "\n".join(lines)
    assert "claim:      (d_H.T*V*d_H) == d_V2" in text
    assert "name:       d_V2 for V_2" in text
    assert "where:      V > 0" in text
    assert "with:       d_H = " in text
    _, lines = run(tmp_path / "one.json", certificates[7], capsys)
    assert "random:     v = R" in lines


@pytest.mark.parametrize(
    "latex",
    [
        r"(Q^{-1})^{-1} = Q",
        r"(Q^T)^{-1} = Q^{-1}",
        r"W W^{-1} = I_n",
        r"(W^{-1})^{-1} = Q^{-1}",
        r"(Q + S)^{-1} = (S + Q)^{-1}",
        r"T^{-1} = (S + Q)^{-1}",
        r"0 \leq G G^T",
    ],
)
def test_a_step_that_is_left_out_or_a_definition_has_no_certificate(latex: str) -> None:
    assert uncertified(latex) is not None


@pytest.mark.parametrize(
    "latex", [r"U^{-1} U = I_n", r"T^{-1} = (Q + S)^{-1}", r"Q^{-1} (Q + S) = I_n + Q^{-1} S"]
)
def test_an_inverse_as_it_stands_has_a_certificate(latex: str) -> None:
    assert uncertified(latex) is None


def uncertified(latex: str) -> str | None:
    """Why what is proved has no certificate, None if it has one."""
    symbols = SYMBOLS + "".join(
        f"'{name}' = {{ definition = '{text}', meaning = 'short' }}\n"
        for name, text in (("W", "Q^{-1}"), ("U", "Q"), ("T", "Q + S"))
    )
    kind = "inequality" if latex[0] == "0" else "identity"
    verdict = judged_matrices(latex, kind=kind, symbols=symbols)
    assert verdict.verdict == "proved", verdict.reason
    try:
        answer_certificate(verdict.to_json())
    except NoCertificateError as reason:
        return str(reason)
    return None


def test_one_file_decides_alone(certificates: list[Data], tmp_path: Path) -> None:
    tree = [*ast.walk(ast.parse(FILE.read_text()))]
    names = {a.name for n in tree if isinstance(n, ast.Import) for a in n.names}
    names |= {str(n.module) for n in tree if isinstance(n, ast.ImportFrom)}
    assert names <= sys.stdlib_module_names
    assert len(FILE.read_text().splitlines()) <= 300
    (tmp_path / "alone.py").write_text(FILE.read_text())
    (tmp_path / "one.json").write_text(json.dumps(certificates[4]))
    command = [sys.executable, "-I", "alone.py", "one.json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout.splitlines()[-1] == "proved"


# what an altered certificate states, at drawn matrices


def value(node: Any, known: dict[str, Any]) -> Any:
    """A number stands for that multiple of the unit matrix."""
    match node:
        case str():
            return value(ast.parse(node.strip(), mode="eval").body, known)
        case ast.Constant(value=number):
            return number
        case ast.Name(id=name):
            return known[name]
        case ast.Attribute(value=a):
            return np.transpose(value(a, known))
        case ast.UnaryOp(operand=a):
            return -value(a, known)
        case ast.BinOp(left=a, op=op, right=b):
            x, y = value(a, known), value(b, known)
            if isinstance(op, ast.Div):
                return x / y
            if isinstance(op, ast.Mult):
                return x @ y if np.ndim(x) and np.ndim(y) else x * y
            x, y = (v if np.ndim(v) else v * np.eye(len(w)) for v, w in ((x, y), (y, x)))
            return x + y if isinstance(op, ast.Add) else x - y
    raise ValueError(ast.dump(node))


def holds(text: str, known: dict[str, Any]) -> bool:
    node: Any = ast.parse(text.strip(), mode="eval").body
    x, y = value(node.left, known), value(node.comparators[0], known)
    x, y = (v if np.ndim(v) else v * np.eye(*np.shape(w)) for v, w in ((x, y), (y, x)))
    gap = x - y
    size = 1e-7 * (1 + np.abs(x).max() + np.abs(y).max())
    if isinstance(node.ops[0], ast.Eq):
        return bool(np.abs(gap).max() < size)
    if np.abs(gap - gap.T).max() > size:
        return False
    return bool(min(np.linalg.eigvalsh((gap + gap.T) / 2)) > (0 if ">=" not in text else -size))


def states_what_is_so(data: Data, seed: int) -> bool:
    """Blocks as the certificate has them, all else drawn."""
    source = np.random.default_rng(seed)
    for _ in range(12):
        known: dict[str, Any] = {}
        for title, text in [line for line in data["lines"] if len(line) == 2]:
            name, _, meaning = (word.strip() for word in text.partition("="))
            if title == "matrix":
                said = np.array(
                    [[float(Fraction(x)) for x in row] for row in data["numbers"][name]]
                )
                known[name] = said if "block" in name else source.normal(size=said.shape)
                if any(["where", f"{name} {sign} 0"] in data["lines"] for sign in (">", ">=")):
                    known[name] = known[name] @ known[name].T + np.eye(len(said))
            elif title == "unit":
                known[name] = 1
            elif title in ("with", "let"):
                known[name] = value(meaning, known)
            elif title == "inverse":
                known[name] = np.linalg.inv(known[meaning.removesuffix("**-1")])
            elif title == "where" and not holds(text, known):
                break
            elif title == "claim" and not holds(text, known):
                return False
    return True


def altered(data: Data, source: random.Random) -> Data:
    """A sign, letter, number or fact of a line or step changed, or a line gone."""
    data = copy.deepcopy(data)
    if source.random() < 0.15:
        data["lines"].remove(source.choice(data["lines"]))
        return data
    places: list[tuple[list[Any], int]] = []

    def visit(part: list[Any]) -> None:
        for k, each in enumerate(part):
            if isinstance(each, list):
                visit(each)
            elif part is not data["lines"] and (k or part not in data["lines"]):
                places.append((part, k))

    visit(data["lines"])
    part, k = source.choice(places)
    if isinstance(part[k], int):
        part[k] += source.choice((-1, 1, 2))
    elif isinstance(part[k], str):
        pairs = [("+", "-"), (".T", ""), ("A", "A.T"), ("V", "R"), ("Q", "R"), ("1", "2")]
        pairs += [("==", ">="), (">", ">="), ("*A", "*A*A"), (" > ", " >= ")]
        old, new = source.choice([pair for pair in pairs if pair[0] in part[k]] or [("1", "2")])
        at = [i for i in range(len(part[k])) if part[k].startswith(old, i)]
        if at:
            i = source.choice(at)
            part[k] = part[k][:i] + new + part[k][i + len(old) :]
    return data


@pytest.mark.parametrize("number", [0, 1, 2, 3, 4, 5, 9, 10])
def test_an_altered_certificate_is_rejected_or_states_what_is_so(
    number: int, certificates: list[Data]
) -> None:
    source, refused = random.Random(number), 0
    assert states_what_is_so(certificates[number], number)
    for _ in range(30):
        data = altered(certificates[number], source)
        if rejected(data) is None:
            assert states_what_is_so(data, number), json.dumps(data)
        else:
            refused += 1
    assert refused > 8


LONG_NAMES = certificate(
    *(["matrix", f"{'S' * 77}{k} = size_n by size_n"] for k in "01"),
    ["with", f"T = {'S' * 77}0 + {'S' * 77}1"],
    ["with", f"U = {'*'.join(['T'] * 15)}"],
    *(["with", f"V{k} = U.T"] for k in range(300)),
    **{f"{'S' * 77}{k}": 1 for k in "01"},
)
HOSTILE: list[Any] = [
    "",
    "[]",
    "[" * 100_000 + "]" * 100_000,
    certificate(S, ["claim", "(" * 900 + "S" + ")" * 900 + " == S"], S=1),
    certificate(S, ["claim", "+".join(["S"] * 4000) + " == S"], S=1),
    certificate(S, ["claim", "*".join(["S"] * 100) + " == S"], S=1),
    certificate(S, ["with", "T = " + "*".join(["(S + S.T)"] * 30)], S=1),
    certificate(S, ["claim", f"{'9' * 9000}*S == S"], S=1),
    certificate(S, ["claim", "S**9 == S"], S=1),
    certificate(S, ["claim", "S/0 == S"], S=1),
    certificate(S, POSITIVE, ["claim", "S > 0"], S="1e99999999"),
    certificate(S, POSITIVE, ["claim", "S > 0"], S="1/0"),
    certificate(S, POSITIVE, ["claim", "S > 0"], sizes={"size_n": 10**9}, S=1),
    certificate(S, ["claim", "__import__ == 0"], S=1),
    certificate(S, ["claim", "S.real == S"], S=1),
    certificate(S, ["claim", "F(S) == S"], S=1),
    certificate(S, ["shows", "S >= 0", [], [["1e999", "1", None]]], S=1),
    # short lines that multiply out to much, each and all together
    certificate(
        S, ["with", f"T = {'*'.join(['(S + S.T)'] * 12)}"], *[["claim", "T == T*2"]] * 4000
    ),
    *(
        certificate(S, ["with", f"T = {'*'.join(['(S + S.T)'] * 13)}"], *[["where", line]] * 4000)
        for line in ("T.T == S", "-" * 900 + "T == S")
    ),
    certificate(S, ["claim", "S" + ".T" * 9000 + " == S"], S=1),
    certificate(S, ["claim", "-" * 19000 + "S == S"], S=1),
    certificate(
        *[["matrix", f"S{k} = 39 by 39"] for k in range(4)],
        ["where", f"{'*'.join(['S0*S1*S2*S3'] * 15)} > 0"],
        **{f"S{k}": [[f"{j + 7}/{i + 9}" for j in range(39)] for i in range(39)] for k in range(4)},
    ),
    # numbers that grow with each row, words of letters with long names
    certificate(
        ["matrix", "S = 39 by 39"],
        POSITIVE,
        ["claim", "S > 0"],
        ["shows", "S > 0", [], [["1", "1", 0]], [["1", 0, "1"]]],
        S=[
            ["1/3" if i == j else f"1/{10**58 + 7 * (i + j) ** 5 + 39 * i * j}" for j in range(39)]
            for i in range(39)
        ],
    ),
    LONG_NAMES,
    certificate(S, ["claim", "S == \x1b[31m proved" + "x" * 5000], S=1),
    certificate(S, ["\x1b]0;proved\x07", "S"], S=1),
    certificate(["claim", 1]),
    certificate(["shows"]),
    certificate([]),
    {"format": FORMAT},
    {"format": "gainproof answer certificate 2", "lines": []},
]


@pytest.mark.parametrize("number", range(len(HOSTILE)))
def test_what_is_hostile_is_refused_in_a_line(
    number: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    start = time.process_time()
    status, lines = run(tmp_path / "one.json", HOSTILE[number], capsys)
    assert (status, len(lines)) == (1, 1)
    assert lines[0].startswith("REJECTED: ")
    assert lines[0].isascii()
    assert lines[0].isprintable()
    assert len(lines[0]) < 260
    assert time.process_time() - start < 20


def test_what_is_hostile_takes_little_memory(tmp_path: Path) -> None:
    (tmp_path / "one.json").write_text(json.dumps(LONG_NAMES))
    limited = (
        "import resource, runpy, sys; resource.setrlimit(resource.RLIMIT_AS, (1 << 28, 1 << 28));"
        "sys.argv = sys.argv[1:]; runpy.run_path(sys.argv[0], run_name='__main__')"
    )
    command = [sys.executable, "-c", limited, str(FILE), str(tmp_path / "one.json")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.stdout == "REJECTED: ValueError: 'too much work'\n"
