"""Certificates keep what was typed: symbols, the point of a value, convention and filter."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from small_claims import judged

from gainproof.answers.judge import Judge
from gainproof.verify import check_answer
from gainproof.verify.judge.answer_certificate import (
    NoCertificateError,
    answer_certificate,
    unexplained,
)

VELOCITY = {"model": "random-velocity"}
SAME = {"a": "sampling_interval", "T": "sampling_interval"}
AT_ONE = VELOCITY | {"given": r"\lambda = 1"}


@pytest.fixture(scope="module")
def judge() -> Iterator[Judge]:
    with Judge(seconds=60) as found:
        yield found


def lines(judge: Judge, formula: str, **said: Any) -> list[str]:
    """What the file prints, without spaces that align it; empty where there is no certificate."""
    certificate = judge.ask(formula, **said).certificate
    told = check_answer.Certificate(certificate).decide() if certificate else []
    return [" ".join(line.split()) for line in told]


@pytest.mark.parametrize(
    ("formula", "said", "letters"),
    [
        (r"K_1 = \alpha", VELOCITY, ["K_1 = K[1,1]", "alpha = K[1,1]"]),
        (
            r"\hat P_{11} = P_{11}",
            VELOCITY,
            ["hat_P_11 = X[1,1]", "P_11 = X[1,1]"],
        ),
        ("a = T", VELOCITY | {"symbols": SAME}, ["a = T"]),
        (
            "D + c = E + 3",
            {"symbols": {"D": "= a + b", "E": "= a + b", "c": "= 3"}},
            ["D = a + b", "E = a + b", "c = 3"],
        ),
        (
            "D + c = E + 4",
            {"symbols": {"D": "= a + b", "E": "= a + b", "c": "= 3"}},
            ["D = a + b", "E = a + b", "c = 3"],
        ),
    ],
)
def test_symbols_that_stand_for_the_same_have_a_line_each(
    judge: Judge, formula: str, said: dict[str, Any], letters: list[str]
) -> None:
    found = lines(judge, formula, **said)
    assert {f"with: {letter}" for letter in letters} <= {*found}


@pytest.mark.parametrize("formula", [r"\beta \approx 0.48", r"\beta \approx 0.50"])
def test_a_value_keeps_its_symbol_condition_and_model(judge: Judge, formula: str) -> None:
    found = lines(judge, formula, **AT_ONE)
    assert "with: lambda_ = 1" in found
    assert r"name: lambda_ for \lambda" in found
    assert "with: beta = K[2,1]*sampling_interval" in found
    assert "with: H = [[1, 0]]" in found


@pytest.mark.parametrize(
    ("formula", "convention", "letter"),
    [
        # by hand: alpha = 0.769 and beta = 0.480 there, so K_1 + T K_2 = 1.25 is F K
        (r"\alpha < 0.9", "gains are those of the filter (K)", "K[1,1]"),
        (
            r"\alpha > 0.9",
            "gains are those of the predictor (F K)",
            "(1*K[1,1] + sampling_interval*K[2,1] + 0)*1",
        ),
    ],
)
def test_the_convention_is_told(judge: Judge, formula: str, convention: str, letter: str) -> None:
    found = lines(judge, formula, **AT_ONE)
    assert f"convention: {convention}" in found
    assert f"with: alpha = {letter}" in found


def test_what_is_lost_of_a_filter_has_no_certificate(judge: Judge) -> None:
    said = VELOCITY | {"given": r"\alpha < 1/2"}
    assert lines(judge, r"\alpha^2 = \beta(2 - \alpha)", **said) == []


def test_of_any_gains_the_stable_ones_are_told(judge: Judge) -> None:
    formula = r"X_{11} = (1 - \alpha)^2 P_{11} + \alpha^2 \sigma_v^2"
    found = lines(judge, formula, model="fixed")
    assert {f"filter: {check_answer.GAINS}", "with: X_11 = X[1,1]", "with: P_11 = P[1,1]"} <= {
        *found
    }
    gains = r"filter_gain_\d|alpha|beta"
    where = {re.sub(gains, "g", line) for line in found if line.startswith("where")}
    # by hand: alpha > 0, beta > 0, 4 - 2 alpha - beta > 0
    assert {"where: g > 0", "where: -2*g - g + 4 > 0"} <= where
    assert len([line for line in found if re.search(gains + r".* > 0", line)]) >= 3
    false = r"X_{11} = (1 - \alpha)^2 P_{11} + \alpha \sigma_v^2"
    assert lines(judge, false, model="fixed")[-1] == "refuted"


KIND = "kind = 'fixed_gain'\nstates = 2\ngain = 'filter'"
MOVING = {
    "a": "{ quantity = 'filter_gain.1', meaning = 'a gain' }",
    "b": "{ quantity = 'filter_gain.2', meaning = 'a gain' }",
    "T": "{ quantity = 'sampling_interval', meaning = 'an interval' }",
    "c": "{ quantity = 'target_motion.2', meaning = 'an acceleration' }",
    "l": "{ quantity = 'predicted_lag.1.2', meaning = 'the lag of the prediction' }",
    "m": "{ quantity = 'predicted_lag.2.2', meaning = 'that of the velocity' }",
    "z": "{ quantity = 'predicted_lag.1.1', meaning = 'that of a steady motion' }",
}


@pytest.mark.parametrize(
    ("latex", "verdict", "motion"),
    [
        # Kalata 1984: an acceleration c is followed with the lag c T^2/beta
        (r"l = \frac{c T^2}{b}", "proved", "c*T"),
        (r"l = \frac{c T^2}{2 b}", "refuted", "c*T"),
        (r"m = c T (\frac{a}{b} + \frac{1}{2})", "proved", "c*T"),
        ("z = 0", "proved", "[[0], [0]]"),
    ],
)
def test_a_lag_is_told_with_the_motion(latex: str, verdict: str, motion: str) -> None:
    claim = judged("identity", latex, MOVING, KIND).to_json()
    assert claim["verdict"] == verdict, claim["reason"]
    found = check_answer.Certificate(answer_certificate(claim)).decide()
    assert found[-1] == verdict
    (driven,) = (line for line in found if line.startswith("with:") and " D = " in line)
    assert motion in driven


@pytest.mark.parametrize(
    ("formula", "last"),
    [
        (r"K_2 = \sqrt{q/r}", ["claim: K_2 == sqrt(q/r)", "proved"]),
        (r"3 \sqrt{q/r} = 3 K_{2}", ["claim: 3*sqrt(q/r) == 3*K_2", "proved"]),
        (r"K_2 = -\sqrt{q/r}", ["false: K_2 == -sqrt(q/r)", "refuted"]),
        (r"K_1^2 = 2 K_2", ["claim: K_1**2 == 2*K_2", "proved"]),
        (r"2 K_2 = K_2 + \sqrt{q/r}", []),
    ],
)
def test_a_gain_that_is_written_out_is_kept_so(judge: Judge, formula: str, last: list[str]) -> None:
    """Not K_2 == K_2, which is true of any gain."""
    found = lines(judge, formula, symbols={"q": "m^2 s^-3 > 0", "r": "m^2 s > 0"})
    assert found[-2:] == last


def test_lags_of_two_motions_have_no_certificate() -> None:
    claim = judged("identity", r"l + z = \frac{c T^2}{b}", MOVING, KIND).to_json()
    assert claim["verdict"] == "proved"
    with pytest.raises(NoCertificateError):
        answer_certificate(claim)


@pytest.mark.parametrize(
    ("formula", "convention", "letter"),
    [
        (r"\alpha + x = x + K_1", "gains are those of the filter (K)", "alpha = K[1,1]"),
        ("P_{12} > 0", "the covariance is the predicted one", "P_12 = P[1,2]"),
    ],
)
def test_of_more_conventions_that_which_is_stated_is_told(
    judge: Judge, formula: str, convention: str, letter: str
) -> None:
    assert str(judge.ask(formula, model="random-velocity").claim["convention"]).startswith(
        "any of: "
    )
    found = lines(judge, formula, **VELOCITY)
    assert f"convention: {convention}" in found
    assert f"with: {letter}" in found


@pytest.mark.parametrize(
    ("latex", "tokens"),
    [
        ("H K_k = K_{k1}", ["free K_{k1}[1,1]", "free K_{k1}[1,2]"]),
        (r"K_k = \begin{pmatrix} K_{k1} \\ K_{k2} \end{pmatrix}", ["K_{k1}[1,1]", "K_{k2}[1,1]"]),
        (r"K = \begin{bmatrix} \alpha_r & 0 \end{bmatrix}", [r"\alpha_r"]),
        (r"E[y - y_c] = 0", ["y_c", "y"]),
        (r"\mathrm{E}(x) = a", ["x", "a"]),
        (r"\hat{x} = x", ["x"]),
        (r"x = \hat{x}", [r"\hat{x}"]),
        ("x_k = x", ["x"]),
        (r"\sigma_{\theta} = \theta", [r"\theta"]),
        ("x' = x", ["x"]),
        ("dt = 2 t", ["t"]),
        (r"\omega(t) = t", ["t"]),
        ("A = I", ["A"]),
        (r"\theta = h", ["h"]),
        ("e > 2", []),
    ],
)
def test_a_symbol_that_no_line_explains_is_found(latex: str, tokens: list[str]) -> None:
    assert unexplained(latex, tokens)


@pytest.mark.parametrize(
    ("latex", "tokens"),
    [
        (r"\frac{d^2 \beta}{d\lambda^2} < 0", [r"\beta", r"\lambda"]),
        (
            r"\frac{\partial \dot{\phi}}{\partial \theta} = \omega \tan \theta",
            [r"\dot{\phi}", r"\theta", r"\omega"],
        ),
        (r"Q_{00} = \frac{dt^7}{252}", ["dt", "Q_{00}"]),
        (r"e^{a + b} = e^a e^b", ["a", "b"]),
        (r"\hat P_{11} = P_{11}", [r"\hat P_{11}", "P_{11}"]),
        (r"\left( \alpha_{k+1} \right)^2 \geq 0 < \pi", [r"\alpha_{k+1}"]),
        (r"\gamma = {\beta^2 \over 2\alpha}", [r"\alpha", r"\beta", r"\gamma"]),
        ("xy = yx", ["x", "y"]),
        (r"A^{\mathsf T} A^T = B^{\mathsf{T}}", ["A", "B"]),
        (r"A A^T = B", ["A[1,1]", "B[1,1]"]),
        # letters in the names of commands, and accents in any order
        (
            r"\hat{\underline{n}} = \underline{t} + n t",
            ["n", r"\underline{\hat{n}}", r"\underline{t}", "t"],
        ),
    ],
)
def test_layout_and_functions_are_no_symbols(latex: str, tokens: list[str]) -> None:
    assert unexplained(latex, tokens) == ""


@pytest.mark.parametrize(
    "other", [{"latex": "x^2 + H = 1"}, {"latex": "E[x^2] = 1"}, {"kind": "monotone"}]
)
def test_what_is_lost_of_a_formula_has_no_certificate(judge: Judge, other: dict[str, str]) -> None:
    claim = judge.ask("x^2 = 1", given="x = 1").claim
    assert answer_certificate(claim)["lines"]
    with pytest.raises(NoCertificateError):
        answer_certificate({**claim, **other})


@pytest.mark.parametrize(
    ("formula", "said", "certified"),
    [
        # by hand: x^4 + x^3 + x^2 + x + 1 = (x^5 - 1)/(x - 1) > 0, so nothing need be asked of x
        (r"\sqrt{x^4 + x^3 + x^2 + x + 1} \ge 0", {}, False),
        (r"\frac{x^2 - y^2}{x - y} = x + y", {}, True),
        (r"\tan(x) \cos(x) = \sin(x)", {}, True),
        ("D = a + b", {"symbols": {"D": "= a + b"}}, True),
        ("D = b + a", {"symbols": {"D": "= a + b"}}, True),
    ],
)
def test_a_certificate_asks_for_no_more_than_its_verdict(
    judge: Judge, formula: str, said: dict[str, Any], certified: bool
) -> None:
    assert judge.ask(formula, **said).verdict == "proved"
    assert bool(lines(judge, formula, **said)) == certified


@pytest.mark.parametrize(
    ("formula", "read"),
    [
        ("P^+ = (P^+)^T", r", read as P_{posterior} = (P_{posterior})^T"),
        ("(A B)^T = B^T A^T", ""),
        ("A'*A >= 0", r", read as A^{\mathsf{T}} A \ge 0"),
    ],
)
def test_a_formula_is_printed_as_it_was_typed(judge: Judge, formula: str, read: str) -> None:
    symbols = {"P^+": "n x n, symmetric"} if "+" in formula else {}
    found = judge.ask(formula, model="matrices", symbols=symbols).certified()["certificate"]
    typed = next(text for title, text in found["lines"] if title == "typed")
    assert typed == formula + read


TURN = r"\begin{bmatrix} \cos\theta & -\sin\theta \\ \sin\theta & \cos\theta \end{bmatrix}"
WITH_SINE = {"D": TURN, "B": r"\begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}"}
GAIN = r"\begin{bmatrix} a & b + 1 \\ b + 1 & a \end{bmatrix}"


def of_matrices(latex: str, **definitions: str) -> list[str]:
    """What the file prints of an identity of 2 by 2 matrices that are defined in letters."""
    symbols = {
        name: f"{{ definition = '{text}', shape = [2, 2], meaning = 'a matrix' }}"
        for name, text in definitions.items()
    }
    claim = judged("identity", latex, symbols).to_json()
    assert claim["verdict"] in ("proved", "refuted"), claim["reason"]
    told = check_answer.Certificate(answer_certificate(claim)).decide()
    return [" ".join(line.split()) for line in told]


@pytest.mark.parametrize(("latex", "verdict"), [("D D^T = B", "proved"), ("D D = B", "refuted")])
def test_a_matrix_is_explained_entry_by_entry(latex: str, verdict: str) -> None:
    found = of_matrices(latex, D=TURN, B=r"\begin{bmatrix} 1 & 0 \\ 0 & 1 \end{bmatrix}")
    assert found[-1] == verdict
    angle = "theta" if verdict == "proved" else "1"
    assert f"with: D_1_2 = -sin({angle})" in found
    assert "name: D_1_2 for D[1, 2]" in found
    assert "with: B_2_1 = 0" in found
    # two entries are the cosine: it stands as it is, not as the letter of one of them
    other = "D_1_2" if verdict == "proved" else "D_2_1"
    sort = "claim" if verdict == "proved" else "false"
    assert f"{sort}: cos({angle})*cos({angle}) + D_1_2*{other} == 1" in found


def test_an_entry_is_told_from_a_number_that_is_spelled_like_it() -> None:
    matrices = {name: f"definition = '{text}', shape = [2, 2]" for name, text in WITH_SINE.items()}
    for entry, value in (("D_{1,2}", "2 a"), ("D_{1,2}", r"-\sin\theta"), ("D_{1,1}", "b^2")):
        table = matrices | {entry: f"definition = '{value}'"}
        symbols = {name: f"{{ {text}, meaning = 'any' }}" for name, text in table.items()}
        claim = judged("identity", f"D^T D {entry} = B {entry}", symbols).to_json()
        assert claim["verdict"] == "proved", claim["reason"]
        lines = check_answer.Certificate(answer_certificate(claim)).decide()
        names = [" ".join(line.split()) for line in lines if line.startswith("name:")]
        row, column = entry[3], entry[5]
        assert f"name: D_{row}_{column} for {entry}" in names
        assert f"name: entry_of_D_{row}_{column} for D[{row}, {column}]" in names
        assert not any("_ for" in name for name in names)


def test_a_matrix_may_have_the_name_of_a_gain() -> None:
    found = of_matrices("K D = D K", K=GAIN, D=GAIN)
    assert {"with: K_1_2 = b + 1", "with: D_2_1 = b + 1"} <= {*found}
    assert found[-1] == "proved"


@pytest.mark.parametrize(
    ("latex", "symbols"),
    [
        ("P = q^2", {"P": "definition = 'E[v^2]'"}),
        ("2 B = 2 q^2", {"P": "definition = 'E[v^2]'", "B": "definition = 'P'"}),
        (
            r"S = \begin{bmatrix} q^2 \end{bmatrix}",
            {"S": r"definition = 'E[\begin{bmatrix} v^2 \end{bmatrix}]', shape = [1, 1]"},
        ),
    ],
)
def test_a_mean_in_a_definition_has_no_certificate(latex: str, symbols: dict[str, str]) -> None:
    noise = {"v": "{ unit = '1', variance = 'q^2', meaning = 'noise' }"}
    table = {name: f"{{ {text}, meaning = 'a variance' }}" for name, text in symbols.items()}
    claim = judged("identity", latex, noise | table).to_json()
    assert claim["verdict"] == "proved"
    with pytest.raises(NoCertificateError, match=r"a mean, that of [PS]"):
        answer_certificate(claim)


def test_functions_of_a_source_are_told_as_it_defines_them() -> None:
    symbols = {
        "f": "{ arguments = ['x'], definition = 'x^2 + 1', meaning = 'a function' }",
        "g": "{ arguments = ['x'], definition = 'f(x) - 1', meaning = 'one by the other' }",
        "h": "{ arguments = ['x'], definition = '5 x', meaning = 'one that is not called' }",
    }
    claim = judged("identity", "g(a + b) = (a + b)^2", symbols).to_json()
    assert claim["verdict"] == "proved"
    found = answer_certificate(claim)["lines"]
    told = [line[1] for line in found if line[0] == "typed"]
    assert told == ["g(a + b) = (a + b)^2", "g(x) = f(x) - 1", "f(x) = x^2 + 1"]
    assert ["claim", "(a + b)**2 + 1 - 1 == (a + b)**2"] in found


def test_what_holds_of_all_gains_is_not_narrowed_to_stable_ones() -> None:
    states = {
        "p": "{ quantity = 'predicted_state.1', meaning = 'a prediction' }",
        "s": "{ quantity = 'updated_state.1', meaning = 'an estimate' }",
        "z": "{ quantity = 'measurement', meaning = 'a measurement' }",
    }
    claim = judged("recursion", "s = p + a (z - p)", MOVING | states, KIND).to_json()
    assert claim["verdict"] == "proved"
    with pytest.raises(NoCertificateError):
        answer_certificate(claim)


def test_two_names_of_one_definition_are_not_exchanged() -> None:
    symbols = dict.fromkeys("uv", "{ definition = 'a + b', meaning = 'a sum' }")
    claim = judged("identity", "u = v", symbols).to_json()
    assert claim["verdict"] == "proved"
    with pytest.raises(NoCertificateError):
        answer_certificate(claim)
