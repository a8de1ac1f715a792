"""Formulas asked for one by one: verdicts, guesses, errors, and the doors they come through."""

from __future__ import annotations

import contextlib
import json
import os
import subprocess
import sys
import tomllib
from collections.abc import Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path
from typing import Any

import jsonschema  # type: ignore[import-untyped]
import pytest
from one_of_each import further

import gainproof.answers
from gainproof.answers.judge import Judge
from gainproof.answers.possible_filters import Options
from gainproof.bad_input import BadInputError
from gainproof.claims.judgements import shipped_models
from gainproof.cli import main
from gainproof.verify import check_answer
from gainproof.verify.judge.claim.notation import is_plain

SCHEMA = Path(gainproof.answers.__file__).with_name("answers.schema.json")
MODELS = Path(__file__).parents[2] / "docs" / "models"
HOSTILE = Path(__file__).parents[1] / "verify" / "judge" / "hostile"


@pytest.fixture(scope="module")
def judge() -> Iterator[Judge]:
    with Judge(seconds=20, fresh=True) as found:
        yield found


# what is true of each is known by hand: gains of random velocity and random acceleration (Kalata
# 1984), least squares (Brookner 1998, chapter 1), school algebra
TRUE: list[Any] = [
    (r"\beta = \frac{\alpha^2}{2 - \alpha}", {}, "random-velocity"),
    (r"\beta = 2(2-\alpha) - 4\sqrt{1-\alpha}", {}, "random-acceleration"),
    ("beta = 2(2 - alpha) - 4 sqrt(1 - alpha)", {}, "random-acceleration"),
    ("h = g^2/(2 - g)", {}, "random-velocity"),
    (r"\beta = \frac{\alpha^2}{2 + \alpha}", {}, "gains are those of the predictor"),
    (r"K_2 = \frac{K_1^2}{2 - K_1}", {}, "random-velocity"),
    (r"P_{11} = \alpha R", {}, "updated"),
    further(r"P_{11} = \frac{\alpha}{1-\alpha} \sigma_v^2", {}, "predicted"),
    (r"\Lambda = \frac{\sigma_w T^2}{\sigma_v} = \frac{\beta}{\sqrt{1-\alpha}}", {}, "filter (K)"),
    further(r"\alpha_k = \frac{2(2k+1)}{(k+1)(k+2)}", {}, ""),
    (r"\alpha \to 1 \quad (\Lambda \to \infty)", {}, ""),
    (r"(a+b)^2 = a^2 + 2ab + b^2", {}, ""),
    ("(a+b)^2 = a^2 + 2ab + b^2", {}, ""),
    ("x y = yx", {}, ""),
    (r"\sin 2x = 2 \sin x \cos x", {}, ""),
    ("x + 1/x >= 2", {"domain": "x > 0"}, ""),
    ("a/c >= b/c", {"given": ("a >= b", "c > 0")}, ""),
    (r"n^2 \geq n", {"symbols": {"n": "integer"}}, ""),
    ("β = α²/(2 − α)", {}, "random-velocity"),
    ("beta = alpha^{2}/(2 - alpha)", {}, "random-velocity"),
    (r"P_{12} \Delta t = \beta R", {}, "updated"),
    (r"P_{12} dt = \beta R", {}, "updated"),
    (r"\frac{\beta^2}{1-\alpha} = \frac{\tilde{q}T^3}{R}", {}, "filter (K)"),
    (r"\sin(\alpha + \beta) = \sin\alpha\cos\beta + \cos\alpha\sin\beta", {}, "symbols"),
    (r"e^2 > 7", {}, "symbols"),
    (r"\ln e = 1", {}, "symbols"),
    (r"\frac{d}{dt} t^2 = 2t", {}, "symbols"),
    ("(a+b)^3 = a^3 + 3a^2 b + 3ab^2 + b^3", {}, "symbols"),
    ("(a+b)^2 >= a^2+b^2+ab", {"given": "ab > 0"}, "symbols"),
    ("r = 2ab + a + b", {"symbols": {"r": "= 2ab + a + b"}}, "symbols"),
    ("r^2 = a", {"symbols": {"r": "= sqrt(a)"}}, "symbols"),
    ("K_{1} = K_{1}^{2}/K_{1}", {"model": "none"}, "symbols"),
    (r"P_k^- > 0", {"symbols": {"P_k^-": "1 > 0"}}, ""),
    ("(1-K)^2 P^- + K^2 R = (1-K) P^-", {"symbols": {"K": r"= \frac{P^-}{P^- + R}"}}, ""),
    (r"P_k^{+} + R = P_k^{+} (1 + R/P_k^{+})", {}, ""),
    ("x y >= 0", {"given": r"\alpha > 0", "symbols": {"alpha": "= x y"}}, ""),
    ("P P + P R = R^2", {"symbols": {"P": "= R (s - 1)/2"}, "domain": r"s^2 = 5"}, ""),
    ("s = v*t + v*t", {"symbols": {"s": "= 2 v t"}}, ""),
]


@pytest.mark.alike
@pytest.mark.parametrize(("formula", "said", "convention"), TRUE)
def test_what_is_true_is_proved(
    judge: Judge, formula: str, said: Mapping[str, Any], convention: str
) -> None:
    found = judge.ask(formula, **said)
    assert found.verdict == "proved", str(found)
    assert convention in found.headline()


FALSE: list[Any] = [
    (r"\beta = \frac{\alpha^2}{2 + \alpha}", {"conventions": {"gain": "filter"}}),
    (r"\beta = \frac{\alpha^2}{2 - \alpha}", {"model": "random-acceleration"}),
    (r"\beta = \frac{\alpha^2}{2 - \alpha}", {"conventions": {"gain": "predictor"}}),
    (r"\Lambda = \frac{\sigma_w T^2}{\sigma_v} = \frac{\beta}{1-\alpha}", {}),
    further(r"\alpha_k = \frac{2(2k+1)}{(k+1)(k+3)}", {}),
    ("(a+b)^2 = a^2 + ab + b^2", {}),
    (r"\sqrt{x^2} = x", {"domain": "x < 0"}),
    ("x + y = x y", {}),
    (r"\sqrt{1 - e^2} < 1", {"symbols": {"e": "1"}}),
    ("x = y + 7", {"given": ("x = y",)}),
    ("x = 5", {"domain": "0 < x, x < 1"}),
    ("ab^2 = a^2 b^2", {}),
    ("D = a, D = 2a", {}),
    (r"e^{D} = -a^2", {}),
    (r"(D, 1) = (a, 2)", {}),
    ("h = 2 - g - 2 sqrt(1 - g)", {}),
    ("n^2 > n", {"symbols": {"n": "integer"}, "domain": "n < 2"}),
]


@pytest.mark.alike
@pytest.mark.parametrize(("formula", "said"), FALSE)
def test_what_is_false_is_never_proved(judge: Judge, formula: str, said: Mapping[str, Any]) -> None:
    found = judge.ask(formula, **said)
    assert found.verdict in ("refuted", "conditional"), str(found)
    assert found.verdict == "conditional" or found.witness or found.claim["evidence"]["method"]


@pytest.mark.parametrize("formula", ["x = y", r"\beta = \alpha^2/2", r"\alpha_k = 1/(k+1)"])
def test_no_guess_is_silent(judge: Judge, formula: str) -> None:
    """All symbols, and the filter or that there is none; what the user says is no guess."""
    found = judge.ask(formula)
    names = {each.of for each in found.assumed}
    assert names > {"filter"}
    assert all(each.guessed for each in found.assumed)
    assert "assumed: symbols and " in found.headline()
    for each in found.assumed:
        assert f"{each.of}: {each.meaning}" in " ".join(str(found).split())
    said = dict.fromkeys(names - {"filter"}, "1")
    plain = judge.ask(formula, symbols=said, model="none")
    assert not any(each.guessed for each in plain.assumed)
    assert "assumed" not in plain.headline()


def test_a_formula_without_a_filter_says_where_its_parts_have_values(judge: Judge) -> None:
    found = judge.ask("e^2 > 7 + log(1)")
    assert {(each.of, each.meaning) for each in found.assumed} >= {
        ("e", "Euler's number"),
        ("log", "natural logarithm"),
    }
    assert judge.ask(r"\frac{x^2-y^2}{x-y} = x+y").domain == "where the divisor x - y is not zero"
    assert "for x >= 0" in str(judge.ask(r"\sqrt{x}^2 = x"))


@pytest.mark.parametrize(
    "formula",
    [
        *("D = a + b", "a + b = D", "x_k = x_p + alpha (z - x_p)", r"\sigma^2 = p (1 - p)"),
        *(r"g = 1 - \theta^2, h = (1 - \theta)^2", r"K_2 = \frac{\beta}{T}"),
        *(
            r"VRR = \frac{\alpha}{2 - \alpha}",
            r"-2\ln L = \frac{d^2}{C} + \ln C",
            r"e = \frac{a T^2}{b}",
        ),
    ],
)
def test_what_can_only_define_is_not_refuted(judge: Judge, formula: str) -> None:
    found = judge.ask(formula)
    assert found.verdict == "definition"
    assert "so that the formula only says what it is" in " ".join(str(found).split())


def test_a_statement_about_any_numbers_is_refuted_as_one(judge: Judge) -> None:
    found = judge.ask("x + y = x y")
    assert found.headline().startswith("refuted as a statement about any numbers; assumed")
    said = judge.ask("x + y = x y", symbols={"x": "1", "y": "1"}, model="none")
    assert said.headline() == "refuted"


def test_ways_to_understand_it_are_all_told(judge: Judge) -> None:
    found = judge.ask(r"\alpha_k = \frac{2(2k+1)}{(k+1)(k+2)}")
    assert "degree 1" in found.headline()
    assert [verdict for _, verdict in found.others] == ["refuted", "refuted", "refuted"]
    assert "degree 0: refuted" in " ".join(str(found).split())


def test_a_weight_makes_a_filter_one_of_fading_memory(judge: Judge) -> None:
    weight = {r"\theta": "forgetting_factor"}
    found = judge.ask(r"\alpha = 1 - \theta^2, \beta = (1 - \theta)^2", symbols=weight)
    assert found.verdict == "proved"
    assert "fading-memory filter, polynomial of degree 1" in " ".join(str(found).split())
    # of the degrees the one in which it is a misprint
    wrong = r"P_{11} = R \frac{(1 - \theta)(1 + 4\theta + 5\theta^2)}{(1 + \theta)^2}"
    found = judge.ask(wrong, symbols=weight)
    assert found.verdict == "refuted"
    assert "degree 1" in found.headline()
    assert "^{3}" in found.repairs[0]["latex"]


def test_densities_make_a_filter_one_in_continuous_time(judge: Judge) -> None:
    said = {"q": "m^2 s^-3 > 0", "r": "m^2 s > 0"}
    found = judge.ask(r"K_1 = \sqrt{2} (q/r)^{1/4}, K_2 = \sqrt{q/r}", symbols=said)
    assert found.verdict == "proved"
    assert "white acceleration" in found.headline()
    found = judge.ask(r"P_{22} = \sqrt{2} q^{3/4} r^{3/4}", symbols=said)
    assert found.verdict == "refuted"
    found = judge.ask(r"K_1 = \sqrt{q/r}", symbols={"q": "m^2/s > 0", "r": "m^2 s > 0"})
    assert found.verdict == "proved"


VELOCITY = {"q": "m^2/s > 0", "r": "m^2 s > 0"}
BOTH = {"q_1": "m^2/s > 0", "q_2": "m^2 s^-3 > 0", "r": "m^2 s > 0"}


def test_each_density_has_its_place(judge: Judge) -> None:
    # two integrators, both driven: P_12 = sqrt(q_2 r), P_11^2 / r = q_1 + 2 P_12
    true, false = (rf"P_{{11}} = r \sqrt{{q_1/r + {n} \sqrt{{q_2/r}}}}" for n in (2, 3))
    found = judge.ask(true, symbols=BOTH)
    assert found.verdict == "proved"
    told = "q_1 of a white velocity, q_2 of a white acceleration, r of the measured position"
    assert told in " ".join(str(found).split())
    assert judge.ask(false, symbols=BOTH).verdict == "refuted"


@pytest.mark.parametrize(
    ("formula", "more", "told"),
    [
        ("K_1 = 1/r", {"q": None}, "density of the process noise is.*--model"),
        (r"K_1 = \sqrt{q/r}", {"r_2": "m^2 s > 0"}, r"r and r_2 are both in m\^2 s,"),
        (r"K_1 = \sqrt{q/r}", {"q_2": "m^2/s > 0"}, "q and q_2 are both in m.2 s.-1"),
        (r"K_1 = \sqrt{a^2 + q/r} - a", {"a": "s^-1 > 0"}, "a in s.-1 is no density.*claim file"),
        (r"K_1 = \sqrt{q/r} + 1/\theta", {r"\theta": "s > 0"}, "in s is no density"),
        (r"K_2 = q/r", {}, "K_2 is a component 2, .*m.2 s.-3 > 0"),
        (r"P_{33} = q/r", {}, "component 3, .*m.2 s.-5 > 0"),
        (r"K_1 = T \sqrt{q/r}", {}, "T is taken for the time between samples"),
        (r"K_1 = \sqrt{q/r}", {"K_1": "filter_gain.1"}, "K_1 .*in continuous time does not have"),
        (r"K_1 = \sqrt{(q + q_c)/r}", {}, "q_c is taken for another density.* by its unit"),
    ],
)
def test_what_the_densities_leave_out_is_refused(
    judge: Judge, formula: str, more: dict[str, str | None], told: str
) -> None:
    said = {name: text for name, text in {**VELOCITY, **more}.items() if text is not None}
    with pytest.raises(BadInputError, match=told):
        judge.ask(formula, symbols=said)


def test_a_convention_of_discrete_time_is_refused_beside_densities(judge: Judge) -> None:
    with pytest.raises(BadInputError, match="a Kalman-Bucy filter has none"):
        judge.ask(r"K_1 = \sqrt{q/r}", symbols=VELOCITY, conventions={"gain": "predictor"})


def test_densities_need_not_stand_in_the_formula(judge: Judge) -> None:
    assert judge.ask("K_1 > 0", symbols=VELOCITY).verdict == "proved"
    said = {"q": "m^2 s^-3 > 0", "r": "m^2 s > 0"}
    assert judge.ask(r"\beta = \alpha^2/2", symbols=said).verdict == "proved"
    assert judge.ask(r"\beta = \alpha^2/3", symbols=said).verdict == "refuted"
    with pytest.raises(BadInputError, match="has no x"):
        judge.ask("K_1 > 0", symbols={**VELOCITY, "x": "m"})


def test_a_domain_of_densities_belongs_to_the_model(judge: Judge) -> None:
    plain = {"q": "m^2/s", "r": "m^2 s"}
    found = judge.ask(r"K_1 = \sqrt{q/r}", symbols=plain, domain="q > 0, r > 0")
    assert found.verdict == "proved"
    found = judge.ask(r"K_1 = \sqrt{q/r}", symbols=plain)
    assert found.verdict == "undecided"
    assert "could be solved: the density of the measurement noise" in " ".join(str(found).split())


def test_a_number_in_the_unit_of_a_density_may_stand_in_discrete_time(judge: Judge) -> None:
    said = {"r": "m^2 s > 0"}
    assert judge.ask(r"T r > 0, \alpha > 0", symbols=said).verdict == "proved"


@pytest.mark.parametrize(
    ("formula", "more", "verdict"),
    [
        # of one degree: x is estimated by (1 - theta) sum theta^j y_j, of variance R (1-t)/(1+t)
        (r"S = \frac{2 R}{1 + \theta}", {}, "proved"),
        (r"e = \frac{\theta}{1 - \theta} T v", {"e": "updated_lag.1.1"}, "proved"),
        (r"e = \frac{\theta}{1 + \theta} T v", {"e": "updated_lag.1.1"}, "refuted"),
    ],
)
def test_a_weight_alone_makes_it_a_filter(
    judge: Judge, formula: str, more: dict[str, str], verdict: str
) -> None:
    said = {r"\theta": "forgetting_factor", **more}
    if more:
        said["v"] = "target_motion.1"
    assert judge.ask(formula, symbols=said).verdict == verdict


@pytest.mark.parametrize(
    ("formula", "plain"),
    [("x^2 = y", True), ("beta = alpha", True), (r"\alpha = 1", False), ("x^{12} = y", True)],
)
def test_which_text_is_latex(formula: str, plain: bool) -> None:
    assert is_plain(formula) == plain


@pytest.mark.parametrize(
    ("formula", "said", "message"),
    [
        ("", {}, "a formula is wanted"),
        ("x = 1\ny = 2", {}, "ask for each by itself"),
        ("x = y", {"conventions": {"gain": "filter"}}, "--convention gain: the formula is"),
        ("x > 0", {"symbols": {"x": "m > foo"}}, "--symbol: the symbol foo"),
        ("sin x = cos x", {}, r"not read: sin needs brackets: sin\(...\)"),
        ("x > 0", {"domain": "x > 0 or x < 1"}, "`or` is not read"),
        (7, {}, "a text is wanted, got int"),
        ("2^ab = b*2^a", {}, r"write \(a b\), or say"),
        ("x = 1", {"symbols": {"x": "="}}, "a formula is wanted behind ="),
        ("a" * 3000 + "_" * 3000, {}, "at most 4000"),
        ("x > 0", {"domain": "x" * 50000}, "--domain: 50000 characters"),
        ("х = х", {}, "CYRILLIC SMALL LETTER HA"),
        ("Α = Α", {}, "GREEK CAPITAL LETTER ALPHA"),
        (r"\alpha + \beta =", {}, r"(?s)ends too early.*\\beta =\n +\^"),
        (r"\beta = \undefinedcommand x", {}, "undefinedcommand"),
        ("x = y", {"symbols": {"z": "m"}}, "--symbol: the formula has no z; its symbols: x, y"),
        ("x = y", {"symbols": {"x": "km"}}, "write m; 1 km is 1000 m"),
        ("x = y", {"symbols": {"x": "filter_gian.1"}}, "filter_gain.1"),
        ("x = y", {"symbols": {"x +": "m"}}, "--symbol 'x \\+'"),
        ("x = y", {"symbols": {"x": "filter_gain.1"}, "model": "none"}, "--model none has none"),
        ("x = y", {"model": "random-velocty"}, "nearest: random-velocity"),
        ("x = y", {"conventions": {"gian": "filter"}}, "no convention is called 'gian'"),
        (r"\beta = \alpha", {"conventions": {"gain": "filtr"}}, "'filtr'"),
        ("x = y", {"domain": "x >"}, "(?s)--domain: not read.*\\^"),
        ("x = y", {"symbols": {"x": "m"}, "domain": "x > 1"}, "--domain: dimensions"),
        (r"e^{i\theta} = \cos\theta + i\sin\theta", {}, "imaginary unit"),
        ("x = " + "y + " * 8000 + "1", {}, "at most 4000 are read"),
        (r"\frac{d}{dx} atan(y/x) = 1", {}, r"(?s)product a t a n: write \\arctan\n.*\^"),
        (r"\beta = sqrt(\alpha)", {}, r"write \\sqrt\{"),
        (r"\frac{log x}{log y} = \frac{x}{y}", {}, r"(?s)product l o g: write \\log\n.*\^"),
        (r"tan x = \frac{\sin x}{\cos x}", {}, r"write \\tan"),
        (r"\frac{e^{-x} sin x}{2} = xlog y", {}, r"write \\sin"),
        (r"\sqrt{x^2} = abs x", {}, r"write \\left\|"),
        ("d/dx tan(x) = 1 + tan(x)^2", {}, r"a derivative is written diff\(f, x\)"),
    ],
)
def test_bad_input_is_told(
    judge: Judge, formula: str, said: Mapping[str, Any], message: str
) -> None:
    with pytest.raises(BadInputError, match=message):
        judge.ask(formula, **said)


def test_the_answer_is_that_of_check(tmp_path: Path, judge: Judge) -> None:
    for number, (formula, said, _) in enumerate(TRUE[:9:4]):
        asked = judge.question(formula, Options(**said))
        file = tmp_path / f"{number}.toml"
        file.write_text(asked.text, encoding="utf-8")
        checked = {
            claim.claim["id"]: claim.claim for claim in gainproof.check(str(file), seconds=20)
        }
        found = judge.answer(asked).claim
        same = {name: value for name, value in found.items() if name != "seconds"}
        assert {n: v for n, v in checked[found["id"]].items() if n != "seconds"} == same


def test_a_formula_that_hangs_costs_one() -> None:
    with Judge(seconds=0.4, fresh=True) as judge:
        assert judge.ask("((((9^64)^64)^64)^64)^64 = 1").verdict == "undecided"
        assert judge.ask("x^2 >= 0").verdict == "proved"


def test_threads_get_their_own_answers() -> None:
    """One judge, whose process answers one after the other."""
    with Judge(seconds=20, fresh=True) as judge, ThreadPoolExecutor(3) as threads:
        formulas = [f"x^2 >= {-k}" if k % 2 else f"x^2 = x^2 + {k}" for k in range(2, 14)]
        found = [answer.verdict for answer in threads.map(judge.ask, formulas)]
    assert found == ["proved" if k % 2 else "refuted" for k in range(2, 14)]


@pytest.mark.parametrize("seconds", [0, -1, float("nan"), float("inf"), "5"])
def test_a_limit_is_a_number(seconds: Any) -> None:
    with pytest.raises(BadInputError, match="seconds: a number above 0"):
        Judge(seconds=seconds)


def test_answers_fit_their_schema(capsys: pytest.CaptureFixture[str]) -> None:
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    formulas = [r"\beta = \frac{\alpha^2}{2 - \alpha}", r"\sqrt{x^2} = x", "x + y = x y", "x +"]
    assert main(["ask", *formulas, "--json"]) == 2
    data = json.loads(capsys.readouterr().out)
    jsonschema.validate(data, schema)
    assert [each["verdict"] for each in data["answers"]] == ["proved", "conditional", "refuted"]
    assert len(data["errors"]) == 1
    del data["answers"][0]["assumed"]
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(data, schema)


def test_the_command(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["ask", r"\beta = \frac{\alpha^2}{2 - \alpha}", "--explain"]) == 0
    shown = capsys.readouterr().out
    assert shown.startswith(
        "\\beta = \\frac{\\alpha^2}{2 - \\alpha}\n  proved for process noise random-velocity"
    )
    assert "method:" in shown
    file = tmp_path / "asked.toml"
    assert main(["ask", "x = y", "--symbol", "x: m > 0", "--save", str(file)]) == 0
    saved = tomllib.loads(file.read_text(encoding="utf-8"))
    assert saved["settings"]["s1"]["symbols"]["x"]["domain"] == "x > 0"
    capsys.readouterr()
    assert main(["ask", "x = y", "--save", str(file)]) == 2
    assert "exists already" in capsys.readouterr().err
    monkeypatch.setattr(sys, "stdin", iter(["x = x\n", "\n", "x +\n", "y = 2 y\n"]))
    assert main(["ask", "-"]) == 2
    captured = capsys.readouterr()
    assert [line for line in captured.out.split("\n") if line in ("x = x", "y = 2 y")] == [
        "x = x",
        "y = 2 y",
    ]
    assert "ends too early" in captured.err
    assert main(["ask", "x = x", "--symbol", "x"]) == 2
    assert "wanted is NAME: and what it is" in capsys.readouterr().err


def test_a_model_of_ones_own(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Acceleration constant over each half: 3 beta^2 + 16 alpha^2 + 16 alpha beta = 32 beta, from
    the trace and determinant of (I - K H) F by hand; not so for a whole interval.
    """
    own = str(MODELS / "half_intervals.py")
    formula = r"3\beta^2 + 16\alpha^2 + 16\alpha\beta - 32\beta = 0"
    for model, word in ((own, "proved"), ("random-acceleration", "refuted")):
        assert main(["ask", formula, "--model", model]) == 0
        assert capsys.readouterr().out.splitlines()[1].strip().startswith(word)
    saved = str(tmp_path / "new.toml")
    for file, also, told in (
        (own, ["--save", saved], "cannot name a model in Python"),
        (str(MODELS / "correlated_velocity.py"), [], "it has parameters"),
        (str(tmp_path / "none.py"), [], "none.py"),
    ):
        assert main(["ask", formula, "--model", file, *also]) == 2
        assert told in capsys.readouterr().err


@pytest.mark.parametrize(
    ("model", "formula", "words"),
    [
        ("tank_level.py", r"\alpha = P_{11}/(P_{11} + R)", ["state 1", "the measurement"]),
        ("held_pointer.py", r"\beta < \alpha", ["state 1", "state 2"]),
        ("half_intervals.py", r"\beta < \alpha", ["the position", "the velocity"]),
    ],
)
def test_states_of_a_model_of_ones_own_have_numbers_unless_they_are_a_position_and_its_rates(
    model: str, formula: str, words: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    main(["ask", formula, "--model", str(MODELS / model)])
    told = capsys.readouterr().out
    assert f"in its steady state, model {model[:4]}" in told
    for word in ("the position", "measured position", "the velocity", "state 1", "state 2"):
        assert (word in told) is (word in words), told
    assert all(word in told for word in words), told


def test_certificates_are_written_and_decided_by_their_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "certificate.json"
    assert main(["ask", "x + 1/x >= 2", "--domain", "x > 0", "--certificate", str(file)]) == 0
    assert "check_answer" in capsys.readouterr().err
    assert check_answer.main([str(file)]) == 0
    assert capsys.readouterr().out.endswith("\nproved\n")
    file.unlink()
    assert main(["ask", "D = a + b", "--certificate", str(file)]) == 2  # it can only define D
    assert "no certificate: the verdict is definition" in capsys.readouterr().err
    assert not file.exists()
    assert main(["ask", "x = x", "y = y", "--certificate", str(file)]) == 2
    assert "--certificate writes one formula, got 2" in capsys.readouterr().err


def test_json_carries_the_certificate_or_why_there_is_none(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "certificate.json"
    assert main(["ask", "x + 1/x >= 2", "D = a + b", "--domain", "x > 0", "--json"]) == 0
    first, other = json.loads(capsys.readouterr().out)["answers"]
    file.write_text(json.dumps(first["certificate"]))
    assert check_answer.main([str(file)]) == 0
    assert first["no_certificate"] is None
    assert other["certificate"] is None
    assert other["no_certificate"] == "the verdict is definition"


def test_a_claim_file_has_certificates(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    claims, folder = tmp_path / "claims.toml", tmp_path / "certificates"
    assert main(["ask", r"\sqrt{x^2 + y^2} = x + y", "--save", str(claims)]) == 0
    assert main(["check", str(claims), "--certificates", str(folder)]) == 0
    assert "certificates: 1 of 1 settled claims" in capsys.readouterr().err
    (written,) = folder.glob("*/*.json")
    assert check_answer.main([str(written)]) == 0
    assert capsys.readouterr().out.endswith("\nrefuted\n")
    assert (folder / "without.txt").read_text() == ""


def test_a_script_without_a_guard_is_not_executed_again(tmp_path: Path) -> None:
    file = tmp_path / "script.py"
    file.write_text(
        "import gainproof\nfor _ in range(2):\n    print(gainproof.ask('x^2 >= 0').verdict)\n"
    )
    done = subprocess.run(
        [sys.executable, str(file)], capture_output=True, text=True, check=True, timeout=100
    )
    assert done.stdout == "proved\nproved\n"


def test_formulas_made_to_do_harm_do_none() -> None:
    """Those of the hostile claim files: an answer or an error, in the time that one has."""
    formulas = [
        r"e^{\begin{pmatrix} a \end{pmatrix}} = i",
        r"\sum_{j=0}^{n} e^{-j} > 0",
        "a" * 3900 + " = 1",
        "^{" * 1900,
    ]
    for file in sorted(HOSTILE.glob("*.toml")):
        try:
            claims = tomllib.loads(file.read_text(encoding="utf-8")).get("claims", [])
        except (ValueError, RecursionError):
            continue
        formulas += [
            claim[name]
            for claim in claims[:1]
            for name in ("latex", "plain")
            if isinstance(claim, dict) and isinstance(claim.get(name), str)
        ]
    assert len(formulas) > 19
    with Judge(seconds=0.3, fresh=True) as judge:
        for formula in formulas:
            with contextlib.suppress(BadInputError):
                assert judge.ask(formula).verdict != "proved" or len(formula) < 2000


def test_models_that_are_shipped_have_strengths_that_are_known() -> None:
    """A model of measured position that comes new needs its line in the table of noises."""
    from gainproof.verify.judge.claim.usual_letters import NOISE_ORDERS

    positions = [m["name"] for m in shipped_models() if len(m["measurement"]) == 1]
    assert set(positions) == set(NOISE_ORDERS)


@pytest.mark.parametrize(
    ("formula", "point", "domain"),
    [
        ("sqrt(q)*sqrt(r) = 2*sqrt(q*r)", {"q", "r"}, ""),
        ("P = 2*sqrt(2)*q^(1/4)*r^(3/4)", {"q", "r"}, ""),
        ("q^(1/3)*r^(2/3) = r", {"q", "r"}, ""),
        ("sqrt(q)*sqrt(r) = sqrt(q*r)", set(), "q > 0, r > 0"),
        ("q^(1/4)*r^(3/4) = (q*r^3)^(1/4)", set(), "q > 0, r > 0"),
    ],
)
def test_what_is_found_with_roots_as_symbols_is_told_without_them(
    judge: Judge, formula: str, point: set[str], domain: str
) -> None:
    given = ["P = sqrt(2)*q^(1/4)*r^(3/4)"] if "P" in formula else []
    found = judge.ask(formula, symbols={"q": "1 > 0", "r": "1 > 0"}, given=given)
    if domain:
        assert (found.verdict, found.domain) == ("proved", domain)
        return
    assert found.verdict == "refuted"
    assert point <= set(found.witness["point"]) <= point | {"P"}
    q, r = (float(Fraction(found.witness["point"][name])) for name in ("q", "r"))
    left = {"sqrt(q": (q * r) ** 0.5, "P = 2*": 2**0.5 * q**0.25 * r**0.75}
    wanted = left.get(formula[:6], q ** (1 / 3) * r ** (2 / 3))
    assert float(found.witness["left"]["midpoint"]) == pytest.approx(wanted, rel=1e-9)


def test_what_is_true_of_the_predictor_alone_says_where_it_fails_for_the_filter(
    judge: Judge,
) -> None:
    """beta = alpha^2/(2 - alpha) is that of the filter; the other sign is true of F K alone."""
    said = judge.ask(r"\beta = \frac{\alpha^2}{2 + \alpha}").shown()
    assert "false where gains are those of the filter (K): at tracking_index = 1" in said
    assert "but:" not in judge.ask(r"\beta = \frac{\alpha^2}{2 - \alpha}").shown()


@pytest.mark.parametrize("marks", [("$", "$"), ("$$", "$$"), (r"\[", r"\]"), (r"\( ", r" \)")])
def test_what_latex_puts_round_a_formula_is_taken_off(judge: Judge, marks: tuple[str, str]) -> None:
    assert judge.ask(f"{marks[0]}x + y = y + x{marks[1]}").verdict == "proved"


def test_an_answer_is_the_same_whatever_the_hash_seed() -> None:
    """Certificates too: sets are written in one order."""
    script = (
        "import json; from gainproof.answers.judge import Judge\n"
        f"with Judge(fresh=True) as judge: found = judge.ask({TRUE[8][0]!r}, **{TRUE[8][1]!r})\n"
        "found = {n: v for n, v in found.claim.items() if n != 'seconds'}\n"
        "print(json.dumps(found, sort_keys=True))"
    )
    seeds = [{**os.environ, "PYTHONHASHSEED": str(seed)} for seed in (1, 2, 3)]
    run = [sys.executable, "-c", script]
    assert len({subprocess.check_output(run, env=seed) for seed in seeds}) == 1
