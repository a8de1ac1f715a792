"""All nearest true formulas are named, the likeliest first; none that cancels, none across a wrong
convention.
"""

from __future__ import annotations

import pytest
from claim_texts import algebra, claim_file, judged, steady

from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.repair.printed_formula import printed
from gainproof.verify.judge.repair.senseless_parts import (
    is_more_senseless,
    lacks_more,
    senseless_parts,
)

RV, RA = steady("random-velocity"), steady("random-acceleration")
LENGTHS = algebra(
    "'x' = { unit = 'm', meaning = 'position' }\n"
    "'v' = { unit = 'm s^-1', meaning = 'velocity' }\n"
    "'a' = { unit = 'm s^-2', meaning = 'acceleration' }\n"
    "'T' = { unit = 's', meaning = 'interval' }\n"
    "'r' = { unit = '1', domain = 'r > 0', meaning = 'a ratio' }\n"
    "'y' = { definition = 'x + v T + \\frac{a T^2}{2}', meaning = 'position later' }\n"
    "'q' = { definition = 'r x', meaning = 'a part' }\n"
)


class Declared:
    """A number."""

    arguments: tuple[str, ...] = ()
    shape = None
    integer = False


SYMBOLS = {canonical_token(name): Declared() for name in ("a", "b", "k")}


def plain(latex: str) -> str:
    return " ".join(latex.replace("\\left", "").replace("\\right", "").split())


def read(latex: str):  # type: ignore[no-untyped-def]
    return printed(read_formula(latex, SYMBOLS).readings[0])


@pytest.mark.parametrize(
    ("setting", "latex", "expected"),
    [
        # SciPy's gains at Lambda = 1 and 1/3 agree to 1e-15 with both
        (RA, r"\Lambda = 1 - \alpha", r"\frac{\beta^{2}}{\Lambda^{2}} = 1 - \alpha"),
        (RV, r"\beta = \frac{2 - \alpha}{\alpha}", r"\beta = \frac{\alpha^{2}}{2 - \alpha}"),
        # a factor too many, with another dimension, is left out and not put on both sides
        (LENGTHS, r"q = r x T", "q = r x"),
        (LENGTHS, r"y = x + v + \frac{a T^2}{2}", r"y = x + v T + \frac{a T^{2}}{2}"),
    ],
)
def test_nothing_cancels(setting: str, latex: str, expected: str) -> None:
    (verdict,) = judged(setting, ("identity", latex))
    assert verdict.repair is not None, verdict.reason
    assert plain(verdict.repair["latex"]) == expected
    assert verdict.repair == {n: verdict.repairs[0][n] for n in ("latex", "verdict")}
    assert len({repair["latex"] for repair in verdict.repairs}) == len(verdict.repairs)


@pytest.mark.parametrize(
    ("latex", "count"),
    [
        (r"k = \frac{a^2 b}{b^3}", 1),
        (r"k = a \frac{b}{a}", 1),
        (r"k = \frac{a}{b} \frac{b}{k}", 1),
        (r"k = (a^2)^2", 1),
        (r"k = (a^{1/2})^4", 0),
        (r"k = a \frac{a}{b}", 0),
    ],
)
def test_factors_that_cancel_are_counted(latex: str, count: int) -> None:
    assert senseless_parts(read(latex)) == count


def test_a_factor_put_on_both_sides_is_senseless() -> None:
    assert is_more_senseless(read("k a = b a"), read("k = b a"))
    # exchanged for another it may be what was meant
    assert not is_more_senseless(read("k a = b a"), read("k a = b k"))


def test_values_that_are_missing_are_not_moved() -> None:
    assert lacks_more(read(r"\frac{a^2}{b^2} = 0"), read("a^2 + b^2 = 0"))
    assert not lacks_more(read(r"\frac{a^2}{b} = 0"), read(r"\frac{a}{b^2} = 0"))
    assert lacks_more(read(r"\ln a = 0"), read("a = 0"))
    (verdict,) = judged(LENGTHS, ("equivalence", r"r^2 + q^2 = 0 \Leftrightarrow q = 0"))
    assert not any("frac" in repair["latex"] for repair in verdict.repairs)


def test_a_symbol_is_no_slip_of_what_is_true_on_a_part() -> None:
    setting = algebra(
        "'x' = { unit = '1', meaning = 'a number' }\n'y' = { unit = '1', meaning = 'other' }\n"
    )
    (verdict,) = judged(setting, ("identity", r"\sqrt{x^2 y^4} = x y^2"))
    assert verdict.verdict == "conditional"
    assert verdict.repairs == ()


UPDATE = r"""
[settings.s]
title = "update of any size"
kind = "matrices"
sizes = ['n', 'm']
[settings.s.symbols]
'P' = { shape = ["n", "n"], is = ["positive definite"], meaning = "predicted covariance" }
'R' = { shape = ["m", "m"], is = ["positive definite"], meaning = "measurement noise" }
'H' = { shape = ["m", "n"], meaning = "measurement matrix" }
'F' = { shape = ["n", "n"], meaning = "transition" }
'K' = { definition = 'P H^T (H P H^T + R)^{-1}', meaning = "gain" }
"""


@pytest.mark.parametrize(
    ("latex", "expected", "least"),
    [
        # of several signs the one that leaves the bracket as it stands in the gain: K S = P H^T
        (
            "(I_{n} - K H) P (I_{n} - K H)^T + K R K^T = P - K (H P H^T - R) K^T",
            "(I_{n} - K H) P (I_{n} - K H)^T + K R K^T = P - K (H P H^T + R) K^T",
            3,
        ),
        # the second term of Joseph's form
        (
            "(I_{n} - K H) P (I_{n} - K H)^T = P - K H P",
            "(I_{n} - K H) P (I_{n} - K H)^T + K R K^T = P - K H P",
            1,
        ),
        # a transposition of the last factor that is one of all
        (
            "F (I_{n} - K H) P F^T = F (I_{n} - K H) P F (I_{n} - K H)^T + F K R (F K)^T",
            "F (I_{n} - K H) P F^T = F (I_{n} - K H) P (F (I_{n} - K H))^T + F K R (F K)^T",
            1,
        ),
    ],
)
def test_of_matrices_the_likeliest_comes_first(latex: str, expected: str, least: int) -> None:
    (verdict,) = judge_file(claim_file(UPDATE, [("identity", latex)]), ())
    assert verdict.verdict == "refuted"
    assert verdict.repair is not None, verdict.reason
    assert verdict.repair["latex"] == expected
    assert len(verdict.repairs) >= least


ENTRIES = algebra(
    "'a' = { unit = '1', domain = 'a > 0', meaning = 'a number' }\n"
    "'b' = { unit = '1', domain = 'b > 0', meaning = 'a number' }\n"
    "'c' = { unit = '1', domain = 'c > 0', meaning = 'a number' }\n"
    "'h' = { unit = '1', meaning = 'a number' }\n"
    "'G' = { definition = '\\begin{pmatrix} 1 & h \\\\ 0 & 1 \\end{pmatrix} "
    "\\begin{pmatrix} a & b \\\\ b & c \\end{pmatrix} "
    "\\begin{pmatrix} 1 & 0 \\\\ h & 1 \\end{pmatrix}', meaning = 'covariance' }\n"
)
TRUE = ["a + 2 h b + h^{2} c", "b + h c", "b + h c", "c"]


def table(*entries: str) -> str:
    one, two, three, four = entries
    return rf"\begin{{pmatrix}} {one} & {two} \\ {three} & {four} \end{{pmatrix}}"


@pytest.mark.alike
@pytest.mark.parametrize("turned", [False, True])
@pytest.mark.parametrize(
    "wrong",
    [
        {3: "2 c"},
        {2: "b - h c"},
        {0: "a + h b + h^2 c"},
        {1: "b + h b"},
        {1: "b - h c", 2: "b - h c"},
        {0: "a + 2 h b + h c", 3: "-c"},
    ],
)
def test_wrong_entries_are_named_and_repaired(wrong: dict[int, str], turned: bool) -> None:
    printed_matrix = table(*[wrong.get(n, entry) for n, entry in enumerate(TRUE)])
    latex = f"{printed_matrix} = G" if turned else f"G = {printed_matrix}"
    (verdict,) = judged(ENTRIES, ("identity", latex))
    assert verdict.verdict == "refuted"
    named = [f"entry ({n // 2 + 1}, {n % 2 + 1})" for n in wrong]
    assert verdict.witness is not None
    assert verdict.witness["note"] in named
    assert verdict.repair is not None, verdict.reason
    right = f"{table(*TRUE)} = G" if turned else f"G = {table(*TRUE)}"
    assert plain(verdict.repair["latex"]) == plain(right)
    told = verdict.repairs[0]["changes"]
    assert [change[: len(name)] for change, name in zip(told, named, strict=True)] == named


def test_an_entry_without_a_near_formula_is_told() -> None:
    (verdict,) = judged(ENTRIES, ("identity", f"G = {table(*TRUE[:3], r'a^3 + 11 h^5')}"))
    assert verdict.repairs == ()
    assert verdict.truth == "entry (2, 2) is c"


@pytest.mark.parametrize(
    ("index", "printed_number", "true"),
    [(r"\frac{1}{3}", r"\frac{1}{3}", r"\frac{2}{9}"), (r"\frac{1}{3}", "7", r"\frac{2}{9}")],
)
def test_a_wrong_number_gets_the_true_one(index: str, printed_number: str, true: str) -> None:
    """beta = 2 (1 - r)^2 for r = 2/3, where Lambda = 2 (1 - r)^2/r is 1/3."""
    more = rf"domain = '\Lambda = {index}'"
    (verdict,) = judged(RA, ("identity", rf"\beta = {printed_number}"), more=more)
    assert verdict.verdict == "refuted"
    assert verdict.repair == {"latex": rf"\beta = {true}", "verdict": "proved"}


def test_a_number_that_is_no_fraction_is_told_in_digits() -> None:
    """SciPy's solve_discrete_are for the random velocity at Lambda = 1: 0.480534."""
    (verdict,) = judged(RV, ("identity", r"\beta = \frac{5}{11}"), more=r"domain = '\Lambda = 1'")
    assert verdict.verdict == "refuted"
    assert verdict.truth is not None
    assert verdict.truth.startswith(r"\beta \approx 0.480534")


def test_dimensions_name_the_term_and_a_point() -> None:
    (verdict,) = judged(LENGTHS, ("identity", r"y = x + v T + \frac{a T}{2}"))
    assert verdict.method == "dimensions"
    assert r"\frac{a T}{2} is not like x" in verdict.reason
    assert verdict.witness is not None
    point = {name: float(value) for name, value in verdict.witness["point"].items()}
    half = point["a"] * point["T"] / 2
    difference = float(verdict.witness["left"]["midpoint"]) - float(
        verdict.witness["right"]["midpoint"]
    )
    assert difference == pytest.approx(half * (point["T"] - 1))


SHARED = r"""
[symbols]
'\alpha' = { quantity = "gain.1", meaning = "gain of the position" }
'\beta' = { quantity = "gain.2", meaning = "gain of the velocity" }
'\gamma' = { quantity = "gain.3", meaning = "gain of the acceleration" }
'T' = { quantity = "sampling_interval", meaning = "interval" }
'j' = { quantity = "target_motion.3", meaning = "jerk" }
'e' = { quantity = "predicted_lag.1.3", meaning = "lag" }
'c_2' = { quantity = "closed_loop_coefficient.2", meaning = "coefficient" }
[settings.s]
title = "s"
kind = "fixed_gain"
states = 3
gain = "filter"
third_gain = "search"
"""


def test_a_repair_stands_under_a_convention_of_the_other_claims_and_names_it() -> None:
    """The lag is T^3 j/gamma for K_3 = gamma/T^2 and 2 T^3 j/gamma for K_3 = gamma/(2 T^2)."""
    lag, pole = judged(
        SHARED,
        ("identity", r"e = \frac{T^3 j}{\gamma}"),
        ("identity", r"c_2 = \alpha + \beta + \frac{\gamma}{4} - 3"),
    )
    assert lag.verdict == pole.verdict == "conditional"
    (repair,) = lag.repairs
    assert plain(repair["latex"]) == r"e = \frac{2 T^{3} j}{\gamma}"
    assert repair["under"] == pole.convention
    (repair,) = pole.repairs
    assert plain(repair["latex"]) == r"c_2 = \alpha + \beta + \frac{\gamma}{2} - 3"
    assert repair["under"] == lag.convention
