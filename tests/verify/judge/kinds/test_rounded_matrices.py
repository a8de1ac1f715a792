"""Matrices printed with decimals: each entry against the interval of its own digits."""

from __future__ import annotations

import numpy as np
import pytest
from small_claims import check, judged

from gainproof.verify import check_answer
from gainproof.verify.judge.answer_certificate import answer_certificate
from gainproof.verify.judge.claim.record import SymbolEntry
from gainproof.verify.judge.reader.latex_printer import reading_to_latex
from gainproof.verify.judge.reader.plain_printer import reading_to_plain
from gainproof.verify.judge.reader.reader import read_formula, read_plain

EXACT = r"\begin{pmatrix} \frac{1}{3} & \sqrt{2} \\ -\frac{2}{7} & \frac{1}{1000} \end{pmatrix}"
FRACTIONS = r"\begin{pmatrix} \frac13 & \frac23 \\ \frac17 & \frac16 \end{pmatrix}"
VALUES = ((1 / 3, 2**0.5), (-2 / 7, 1e-3))


def _matrix(rows: list[list[str]]) -> str:
    return r"\begin{pmatrix} " + r" \\ ".join(map(" & ".join, rows)) + r" \end{pmatrix}"


@pytest.mark.parametrize("decimals", [1, 2, 4, 7])
def test_every_entry_is_rounded_to_its_digits(decimals: int) -> None:
    """Rounded by Python, and each entry in turn off by one unit of its last digit."""
    rows = [[f"{value:.{decimals}f}" for value in row] for row in VALUES]
    check(judged("value", rf"{EXACT} \approx {_matrix(rows)}"), "proved")
    for place in range(4):
        r, c = divmod(place, 2)
        wrong = [list(row) for row in rows]
        wrong[r][c] = f"{float(rows[r][c]) + 10.0**-decimals:.{decimals}f}"
        found = judged("value", rf"{EXACT} \approx {_matrix(wrong)}")
        check(found, "refuted")
        assert found.witness is not None
        assert found.witness["note"] == f"entry ({r + 1}, {c + 1})"
        assert float(found.witness["left"]["midpoint"]) == pytest.approx(VALUES[r][c])


@pytest.mark.parametrize(
    ("formula", "wanted"),
    [
        (r"(\frac{1}{3}, \frac{2}{3}) \approx (0.3, 0.667)", "proved"),
        (r"(\frac{1}{3}, \frac{2}{3}) \approx (0.3, 0.666)", "refuted"),
        (r"(0.3, 0.667) = (\frac{1}{3}, \frac{2}{3})", "proved"),
        (r"(\frac{1}{3}, \frac{2}{3})^T \approx (0.333, 0.667)^T", "proved"),
        (r"(\frac{1}{3}, \frac{2}{3})^T \approx (0.667, 0.333)^T", "refuted"),
        (
            rf"{FRACTIONS} \approx \begin{{pmatrix}} 0.333 & 0.1 \\ 0.67 & 0.17 \end{{pmatrix}}^T",
            "proved",
        ),
        (
            rf"{FRACTIONS} \approx \begin{{pmatrix}} 0.333 & 0.67 \\ 0.1 & 0.17 \end{{pmatrix}}^T",
            "refuted",
        ),
        # tens, and entries without a point: as exact as the others
        (r"(\frac{1}{3000}, -\frac{1}{3}) \approx (3.3 \times 10^{-4}, -0.33)", "proved"),
        (r"(\frac{1}{3000}, -\frac{1}{3}) \approx (3.4 \times 10^{-4}, -0.33)", "refuted"),
        (r"(\frac{1}{3}, \frac{1}{1000}) \approx (0.33, 0)", "proved"),
        (r"(\frac{1}{3}, \frac{1}{100}) \approx (0.33, 0)", "refuted"),
        (r"(\frac{5}{2}, \frac{7}{3}) \approx (3, 2)", "proved"),
        # the other entries of a matrix decide nothing of one that holds a symbol
        (r"(\frac{1}{3}, a) \approx (0.33, 0.67)", "conditional"),
        (r"(\frac{1}{3}, \frac{a}{3}) \approx (0.33, 0.67) \quad (a = 2)", "proved"),
        (r"(\frac{1}{3}, \frac{a}{3}) \approx (0.33, 0.67) \quad (a = 1)", "refuted"),
    ],
)
def test_matrix(formula: str, wanted: str) -> None:
    check(judged("value", formula), wanted)


def test_all_wrong_entries_are_named() -> None:
    found = judged("value", rf"{EXACT} \approx " + _matrix([["0.3", "1.5"], ["-0.2", "0.0"]]))
    assert found.witness is not None
    assert found.witness["note"] == "entry (1, 2) (wrong too: (2, 1))"


def test_a_rounded_matrix_behind_an_equals_sign_is_told_as_such() -> None:
    found = judged("identity", r"(\frac{1}{3}, \frac{2}{3}) = (0.33, 0.67)")
    check(found, "refuted")
    assert any("a claim of kind value has it" in str(v) for v in found.certificate.values())
    found = judged("identity", r"(\frac{1}{3}, \frac{2}{3}) = (0.33, 0.66)")
    assert not any("a claim of kind value has it" in str(v) for v in found.certificate.values())


@pytest.mark.parametrize(
    "formula",
    [r"\frac13 \approx 0.33, \frac23 \approx 0.67", r"(\frac13, \frac23) \approx (0.33, 0.67)"],
)
def test_the_certificate_holds_every_number(formula: str) -> None:
    """A file that is to stand for all of them must not show the last alone."""
    certificate = answer_certificate(judged("value", formula).to_json())
    lines = check_answer.Certificate(certificate).decide()
    assert sum(line.startswith("claim:") for line in lines) == 4


def test_steady_state_of_three_states() -> None:
    """The fixed point of the recursion in NumPy, and one entry with two digits exchanged."""
    f = np.array([[1.5, -0.75, 0.25], [1, 0, 0], [0, 1, 0]])
    b, h = np.array([[-0.5], [0.5], [1.0]]), np.array([[1.0, 0, 0]])
    p = np.eye(3)
    for _ in range(2000):
        p = f @ (p - p @ h.T @ h @ p / (1 + p[0, 0])) @ f.T + b @ b.T
    gain = (p @ h.T / (1 + p[0, 0])).ravel()
    rows = [[f"'{a:g}'" for a in row] for row in (b @ b.T)]
    setting = (
        "kind = 'steady_state'\ngain = 'filter'\nmeasurement = [['1', '0', '0']]\n"
        "transition = [['1.5', '-0.75', '0.25'], ['1', '0', '0'], ['0', '1', '0']]\n"
        f"process_noise = [{', '.join('[' + ', '.join(row) + ']' for row in rows)}]\n"
        "measurement_noise = [['1']]"
    )
    symbols = {f"M_{i}": f"{{ quantity = 'filter_gain.{i}', meaning = 'gain' }}" for i in (1, 2, 3)}
    printed = [f"{value:.4f}" for value in gain]
    column = _matrix([["M_1"], ["M_2"], ["M_3"]])
    right = judged(
        "value", rf"{column} \approx " + _matrix([[x] for x in printed]), symbols, setting
    )
    check(right, "proved")
    printed[1] = f"{gain[1] + 2e-4:.4f}"
    wrong = judged(
        "value", rf"{column} \approx " + _matrix([[x] for x in printed]), symbols, setting
    )
    check(wrong, "refuted")
    assert wrong.witness is not None
    assert wrong.witness["note"] == "entry (2, 1)"


@pytest.mark.parametrize(
    "formula",
    [
        r"(a, b) \approx (0.50, -1.0260)",
        r"(a, b)^T \approx (0.50, 1.0)^T",
        r"(a, b) \approx \begin{pmatrix} 0.10 & 2.0 \\ 3.000 & 4 \end{pmatrix}^T",
        r"(a, b) \approx (3.0 \times 10^{-4}, 2.50)",
    ],
)
def test_zeros_at_the_end_are_written_again(formula: str) -> None:
    symbols = {name: SymbolEntry(name, "a number", "free") for name in "ab"}
    (reading,) = read_formula(formula, symbols).readings
    (latex,) = read_formula(reading_to_latex(reading), symbols).readings
    (plain,) = read_plain(reading_to_plain(reading), symbols).readings
    assert latex == plain == reading
