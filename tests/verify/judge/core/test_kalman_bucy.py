"""Kalman-Bucy filters in their steady state: covariances and gains against SciPy's Riccati solver,
published formulas and misprints of them, filters that do not exist.
"""

from __future__ import annotations

from fractions import Fraction
from math import prod
from typing import Any

import numpy as np
import pytest
from claim_texts import HEAD
from scipy.linalg import solve_continuous_are

from gainproof.verify.judge.claim.errors import ClaimFileError
from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.claim.record import ClaimFile
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.judge import judge_file
from gainproof.verify.judge.setting import kalman_bucy as module
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.setting.kalman_bucy import kalman_bucy
from gainproof.verify.judge.setting.own_matrices import model_key
from gainproof.verify.judge.verdict import ClaimVerdict

Rows = list[list[str]]
Model = tuple[Rows, Rows, Rows, str]
ACCELERATION: Rows = [["0", "0"], ["0", "q"]]
FIRST: Rows = [["1", "0"]]
THREE: Rows = [["0", "1", "0"], ["0", "0", "1"], ["0", "0", "0"]]
JERK: Rows = [["0", "0", "0"], ["0", "0", "0"], ["0", "0", "q"]]
MODELS: dict[str, Model] = {
    "random walk": ([["0"]], [["q"]], [["1"]], "r"),
    "decaying": ([["-a"]], [["q"]], [["1"]], "r"),
    "growing, seen with a factor": ([["a"]], [["q"]], [["b"]], "r"),
    "either way": ([["u"]], [["q"]], [["1"]], "r"),
    "growing, without noise": ([["a"]], [["0"]], [["1"]], "r"),
    "white acceleration": ([["0", "1"], ["0", "0"]], ACCELERATION, FIRST, "r"),
    "white velocity too": ([["0", "1"], ["0", "0"]], [["b", "0"], ["0", "q"]], FIRST, "r"),
    "correlated": ([["0", "1"], ["0", "0"]], [["2 q", "q"], ["q", "q"]], FIRST, "r"),
    "velocity that decays": ([["0", "1"], ["0", "-a"]], ACCELERATION, FIRST, "r"),
    "oscillator": ([["0", "1"], ["-a^2", "0"]], ACCELERATION, FIRST, "r"),
    "damped": ([["0", "1"], ["-a^2", "-2 a b"]], ACCELERATION, FIRST, "r"),
    "oscillator, its velocity seen": ([["0", "1"], ["-a^2", "0"]], ACCELERATION, [["0", "1"]], "r"),
    "white jerk": (THREE, JERK, [["1", "0", "0"]], "r"),
    "numbers": ([["-1", "2"], ["3/2", "1"]], [["2", "1"], ["1", "1"]], [["1", "1/2"]], "1/4"),
}
POINTS = [
    {"q": "2", "r": "3", "a": "5", "b": "7", "u": "-3"},
    {"q": "1/7", "r": "1/50", "a": "1/3", "b": "1/9", "u": "2"},
]
UNITS = {"q": "m^2 s^-3", "r": "m^2 s", "a": "s^-1", "b": "1", "u": "s^-1"}


POSITIVE = {name: f"{name} > 0" for name in "qrab"}


def read(
    model: Model,
    *claims: str,
    units: bool | dict[str, str] = False,
    domains: str | dict[str, str] = "qrab",
    more: str = "",
) -> ClaimFile:
    text = HEAD + "[symbols]\n"
    said = {n: POSITIVE[n] for n in domains} if isinstance(domains, str) else domains
    for name, unit in (units if isinstance(units, dict) else UNITS).items():
        domain = f"domain = '{said[name]}', " if said.get(name) else ""
        text += f"'{name}' = {{ unit = '{unit if units else '1'}', {domain}meaning = 'd' }}\n"
    a, q, h, r = model
    text += f"[settings.s]\ntitle = 's'\nkind = 'kalman_bucy'\ntransition = {a}\n{more}"
    text += f"process_noise = {q}\nmeasurement = {h}\nmeasurement_noise = {[[r]]}\n"
    text += "[settings.s.symbols]\n"
    for i in range(1, min(len(a), 3) + 1):
        text += f"'K_{i}' = {{ quantity = 'continuous_gain.{i}', meaning = 'g' }}\n"
        text += f"'P_{i}' = {{ quantity = 'covariance.{i}.{i}', meaning = 'v' }}\n"
    for at, latex in enumerate(claims or ("q = q",)):
        kind = "inequality" if ">" in latex else "identity"
        text += f"[[claims]]\nid = 'c{at}'\nplace = 'p'\nkind = '{kind}'\nsetting = 's'\n"
        text += f"latex = '{latex}'\n"
    return read_claim_text(text)


def judged(model: Model, *claims: str, **options: Any) -> list[ClaimVerdict]:
    return list(judge_file(read(model, *claims, **options), ()))


def numbers(rows: Rows, at: dict[str, float]) -> Any:
    """The matrix at a point, read in a way of its own: sums of products."""

    def one(entry: str) -> float:
        if "/" in entry:
            return float(Fraction(entry))
        product = -1.0 if entry.startswith("-") else 1.0
        for part in entry.removeprefix("-").split():
            base, _, exponent = part.partition("^")
            product *= (at[base] if base in at else float(base)) ** int(exponent or 1)
        return product

    return np.array([[one(entry) for entry in row] for row in rows])


@pytest.mark.alike
@pytest.mark.parametrize("name", MODELS)
@pytest.mark.parametrize("point", POINTS)
def test_agrees_with_the_riccati_solver_of_scipy(name: str, point: dict[str, str]) -> None:
    model = MODELS[name]
    quantities = kalman_bucy(read(model).settings["s"]).quantities
    known = {token: float(Fraction(x)) for token, x in point.items()}
    a, q, h = (numbers(rows, known) for rows in model[:3])
    r = numbers([[model[3]]], known)
    p = solve_continuous_are(a.T, h.T, q, r)
    gain = p @ h.T / r
    assert max(np.linalg.eigvals(a - gain @ h).real) < 0
    values = {free_name(token): x for token, x in known.items()}

    def found(expr: Expr) -> float:
        done: dict[bytes, float] = {}
        for node in walk(expr):
            parts = [done[p.key] for p in node.parts]
            done[node.key] = {
                "number": lambda _, n=node: float(n.fraction),
                "symbol": lambda _, n=node: values[n.name],
                "add": sum,
                "mul": prod,
                "neg": lambda p: -p[0],
                "div": lambda p: p[0] / p[1],
                "pow": lambda p, n=node: p[0] ** float(n.fraction),
            }[node.kind](parts)  # type: ignore[operator]
        return done[expr.key]

    for i in range(len(a)):
        assert found(quantities[f"continuous_gain.{i + 1}"]) == pytest.approx(gain[i, 0], rel=1e-6)
        for j in range(len(a)):
            wanted = pytest.approx(p[i, j], rel=1e-6, abs=1e-9)
            assert found(quantities[f"covariance.{i + 1}.{j + 1}"]) == wanted


TRUE = {
    "random walk": [r"K_1 = \sqrt{q/r}, P_1 = \sqrt{q r}"],
    "decaying": [r"P_1 = \frac{q}{a + \sqrt{a^2 + q/r}}", r"K_1 = \sqrt{a^2 + q/r} - a"],
    "either way": [r"P_1 = r(u + \sqrt{u^2 + q/r})"],
    "white acceleration": [
        r"K_1 = \sqrt{2} (q/r)^{1/4}, K_2 = \sqrt{q/r}",
        r"P_1 = \sqrt{2} q^{1/4} r^{3/4}",
        r"P_2 = \sqrt{2} q^{3/4} r^{1/4}",
    ],
    "oscillator": [
        r"K_2 = \sqrt{a^4 + q/r} - a^2",
        r"K_1 = \sqrt{2} \sqrt{\sqrt{a^4 + q/r} - a^2}",
    ],
    "white jerk": [r"K_1 = 2 (q/r)^{1/6}, K_2 = 2 (q/r)^{1/3}, K_3 = \sqrt{q/r}"],
}
"""Kalman and Bucy 1961, section 11; Gelb 1974, section 4.6."""
SLIPS = [
    ("random walk", r"P_1 = \sqrt{q/r}", r"\sqrt{q r}"),
    ("decaying", r"P_1 = r(-a - \sqrt{a^2 + q/r})", r"-a + \sqrt"),
    ("decaying", r"K_1 = \sqrt{a^2 + q/r} + a", r"} - a"),
    ("white acceleration", r"K_1 = 2 (q/r)^{1/4}", None),
    ("white acceleration", r"P_2 = \sqrt{2} q^{3/4} r^{3/4}", r"\sqrt[4]{r}"),
    ("white acceleration", r"K_2 = -\sqrt{q/r}", r"K_2 = \sqrt"),
    ("oscillator", r"K_2 = -\sqrt{a^4 + q/r} - a^2", r"K_2 = \sqrt"),
    ("white jerk", r"K_2 = 2 (q/r)^{1/2}", r"\sqrt[3]"),
]
"""Among them other solutions of the Riccati equation, which stabilise nothing."""


@pytest.mark.alike
@pytest.mark.parametrize(("name", "latex"), [(n, c) for n, found in TRUE.items() for c in found])
def test_published_formulas_are_proved(name: str, latex: str) -> None:
    # q is the density of an acceleration
    for units in {False, name in ("white acceleration", "oscillator")}:
        (found,) = judged(MODELS[name], latex, units=units)
        assert found.verdict == "proved", found.reason
        assert not found.any_filter


@pytest.mark.alike
@pytest.mark.parametrize(("name", "latex", "repaired"), SLIPS)
def test_misprints_are_refuted_and_mended(name: str, latex: str, repaired: str | None) -> None:
    (found,) = judged(MODELS[name], latex)
    assert found.verdict == "refuted", found.reason
    assert repaired is None or repaired in (found.repair or {})["latex"]


def test_units_of_densities_are_compared() -> None:
    model = MODELS["white acceleration"]
    wrong = r"K_1 = \sqrt{2} (q/r)^{1/2}"
    (found,) = judged(model, wrong, units=True)
    assert found.verdict == "refuted"
    assert "s^-1 and s^-2" in found.reason
    (found,) = judged(model, wrong)
    assert found.verdict == "refuted"
    assert "dimensions" not in found.reason
    with pytest.raises(ClaimFileError, match="a unit that fits no state"):
        read(([["-q"]], [["q"]], [["1"]], "r"), units=True)


V = {"q": "m^2 s^-1"}
"""Of white velocity."""
COUNTED: list[tuple[Model, dict[str, str], str, str]] = [
    (([["-2"]], [["q"]], [["1"]], "r"), V, r"K_1 = \sqrt{4 + q/r} - 2", "K_1 = 2 + q/r"),
    (([["-2 - a"]], [["q"]], [["1"]], "r"), V, r"P_1 = r(K_1)", r"P_1 = q r + a"),
    (([["0"]], [["q"]], [["3"]], "r"), V, r"P_1 = \sqrt{q r}/3", r"P_1 = \sqrt{q r}"),
    (([["-1"]], [["2"]], [["1"]], "r"), V, r"K_1 = \sqrt{1 + 2/r} - 1", "K_1 = 1 + r"),
    (
        ([["0", "1"], ["-4", "0"]], ACCELERATION, FIRST, "r"),
        {},
        r"K_2 = \sqrt{16 + q/r} - 4",
        r"K_2 = \sqrt{16 + q/r}",
    ),
    (
        ([["0", "1"], ["0", "-3"]], ACCELERATION, FIRST, "r"),
        {},
        r"K_1 = \sqrt{9 + 2 \sqrt{q/r}} - 3",
        r"K_1 = \sqrt{9 + \sqrt{q/r}} - 3",
    ),
    (([["0", "2"], ["0", "0"]], ACCELERATION, FIRST, "r"), {}, "K_1^2 = 4 K_2", "K_1^2 = 2 K_2"),
]
"""Numbers that count rates, or what the measurement shows, beside symbols with units."""


@pytest.mark.parametrize(("model", "other", "true", "false"), COUNTED)
def test_numbers_beside_units_may_count_anything(
    model: Model, other: dict[str, str], true: str, false: str
) -> None:
    found = judged(model, true, false, units={**UNITS, **other})
    assert [each.verdict for each in found] == ["proved", "refuted"]
    assert "dimensions" not in found[1].reason


@pytest.mark.parametrize("one", ["1", "2/2"])
def test_numbers_that_count_nothing_leave_units_compared(one: str) -> None:
    model = ([["0", one], ["0", "0"]], ACCELERATION, [[one, "0"]], "r")
    (found,) = judged(model, r"K_2 = (q/r)^{1/3}", units=True)
    assert "s^-2 and s^(-4/3)" in found.reason
    (found,) = judged(([["-a"]], [["q"]], [[one]], "r"), "K_1 = a + 2", units={**UNITS, **V})
    assert "dimensions" in found.reason


RESTING: list[tuple[Model, dict[str, str], str, set[str]]] = [
    (
        ([["a", "1"], ["0", "b"]], [["0", "0"], ["0", "0"]], FIRST, "r"),
        {"a": r"a \neq 0", "b": r"b \neq 0"},
        r"K_1 = a + b + \left|a\right| + \left|b\right|",
        {"a != 0", "b != 0", "r > 0"},
    ),
    (
        ([["a"]], [["0"]], [["b"]], "r"),
        {"a": r"a \neq 0", "b": r"b \neq 0"},
        r"b K_1 = a + \left|a\right|",
        {"a != 0", "b != 0", "r > 0"},
    ),
    (([["0"]], [["q - a"]], [["1"]], "r"), {"q": "q > a", "a": ""}, "K_1 > 0", {"q > a", "r > 0"}),
    # a bound that is told says nothing of the number that is taken out
    (
        ([["a"]], [["0"]], [["b"]], "r"),
        {"a": r"a > -5, a \neq 0", "b": r"b \neq 0"},
        r"b K_1 = a + \left|a\right|",
        {"a > -5", "a != 0", "b != 0", "r > 0"},
    ),
    # a relation with a symbol that no matrix holds
    (
        ([["a"]], [["0"]], [["1"]], "r"),
        {"a": "a > b", "b": "b > 0"},
        "K_1 = 2 a",
        {"a > b", "b > 0", "r > 0"},
    ),
    (
        ([["0"]], [["q"]], [["b"]], "r"),
        {"b": r"b \neq 0"},
        "P_1 > 0",
        {"b < 0 or b > 0", "q > 0", "r > 0"},
    ),
    (([["0"]], [["q"]], [["1"]], "r"), {}, "P_1 = r K_1", {"q > 0", "r > 0"}),
]


@pytest.mark.parametrize(("model", "domains", "latex", "wanted"), RESTING)
def test_the_domain_holds_all_that_the_steady_state_rests_on(
    model: Model, domains: dict[str, str], latex: str, wanted: set[str]
) -> None:
    (found,) = judged(model, latex, domains={**POSITIVE, **domains})
    assert found.verdict == "proved", found.reason
    told = (found.domain or "").replace("(q)^(1/2)", "q").replace("(r)^(1/2)", "r")
    assert {part.removeprefix("for ") for part in told.split(", ")} == wanted
    # what speaks of no gain rests on nothing
    (found,) = judged(model, "a + a = 2 a", domains={**POSITIVE, **domains})
    assert found.verdict == "proved"
    assert "r > 0" not in (found.domain or "")


def test_what_is_kept_of_a_model_depends_on_all_that_it_rests_on() -> None:
    model = ([["a"]], [["0"]], [["1"]], "r")
    domains = [{**POSITIVE, "a": "a > b", "b": b} for b in ("b > 0", "b > 1", "")]
    assert len({model_key(read(model, domains=d).settings["s"]) for d in domains}) == 3


def test_equations_follow_from_the_relations_of_roots(monkeypatch: pytest.MonkeyPatch) -> None:
    def refused(statement: Any, *given: Any, **more: Any) -> Any:
        assert all(rel.operator != "=" for rel in statement.relations)
        return settle(statement, *given, **more)

    monkeypatch.setattr(module, "settle", refused)
    model = ([["a", "b"], ["q", "u"]], [["b", "0"], ["0", "q"]], FIRST, "r")
    assert "covariance.2.2" in kalman_bucy(read(model).settings["s"]).quantities


def test_a_convention_has_no_effect_and_is_refused() -> None:
    with pytest.raises(ClaimFileError, match=r"gain: .* no such convention"):
        read(MODELS["decaying"], more="gain = 'predictor'\n")


WIDE = [["q" if i == j else "0" for j in range(12)] for i in range(12)]
TWELVE: Model = (WIDE, WIDE, WIDE[:1], "r")
REFUSED: list[tuple[Model, str, str]] = [
    (([["0"]], [["0"]], [["1"]], "r"), "qr", "the eigenvalue 0, which no noise drives"),
    (([["0", "1"], ["0", "0"]], [["q", "0"], ["0", "0"]], FIRST, "r"), "qr", "the eigenvalue 0"),
    (
        ([["0", "1"], ["-a^2", "0"]], [["0", "0"], ["0", "0"]], FIRST, "r"),
        "ar",
        "A has imaginary eigenvalues",
    ),
    (([["0", "1"], ["0", "0"]], ACCELERATION, [["0", "1"]], "r"), "qr", "not observable"),
    (MODELS["random walk"], "q", "density of the measurement noise has to be positive: r > 0"),
    (MODELS["random walk"], "r", "process noise has to have a density: q >= 0"),
    (([["0"]], [["q"]], [["u"]], "r"), "qr", "has to be observable: u != 0"),
    (([["u"]], [["0"]], [["1"]], "r"), "r", "noise has to drive an eigenvalue 0 of A: u^2 > 0"),
    (
        (THREE, [["q", "0", "0"], *JERK[1:]], [["1", "0", "0"]], "r"),
        "qr",
        "3 states: covered are up to two",
    ),
    (TWELVE, "qr", "12 states"),
    (([["0", "1"], ["0", "0"]], [["0", "q"], ["0", "q"]], FIRST, "r"), "qr", "not symmetric"),
]


@pytest.mark.parametrize(("model", "domains", "reason"), REFUSED)
def test_where_there_is_no_steady_state_the_reason_is_told(
    model: Model, domains: str, reason: str
) -> None:
    (found,) = judged(model, "K_1 = K_1", domains=domains)
    assert found.verdict == "undecided"
    assert reason in found.reason


@pytest.mark.parametrize("name", ["decaying", "white acceleration", "oscillator", "white jerk"])
@pytest.mark.parametrize("which", [0, 1])
@pytest.mark.parametrize("factor", [-1, 2])
def test_other_roots_are_not_established(
    monkeypatch: pytest.MonkeyPatch, name: str, which: int, factor: int
) -> None:
    right = module._poles

    def changed(*args: Any) -> Any:
        coefficients, roots = right(*args)
        last = [*roots][min(which, len(roots) - 1)]
        return coefficients, {**roots, last: factor * roots[last]}

    monkeypatch.setattr(module, "_poles", changed)
    with pytest.raises(NotEstablished):
        kalman_bucy(read(MODELS[name]).settings["s"])
