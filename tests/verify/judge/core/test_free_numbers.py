"""Models with free numbers in their matrices and several strengths, against SciPy and by hand."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from math import isclose, sqrt

import numpy as np
import pytest
from samples import samples
from scipy.linalg import solve_discrete_are
from small_claims import HEAD, check, judged

from gainproof.verify.judge.claim.file import read_claim_text
from gainproof.verify.judge.exact.expression import Expr, symbols_of
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import Environment
from gainproof.verify.judge.setting.own_model import own_environment

MATRICES = ("transition", "process_noise", "measurement", "measurement_noise")
QUANTITIES = {
    "T": "sampling_interval",
    "R": "measurement_noise_variance",
    r"\alpha": "filter_gain.1",
    r"\beta": "filter_gain.2",
    r"\gamma": "filter_gain.3",
    "P": "predicted_covariance.1.1",
    "U": "updated_covariance.1.1",
    "S": "innovation_variance",
}
SYMBOLS = {
    name: f"{{ quantity = '{quantity}', meaning = 'known' }}"
    for name, quantity in QUANTITIES.items()
} | {
    "a": "{ unit = '1', domain = '0 < a < 1', meaning = 'factor' }",
    "b": "{ unit = '1', domain = 'b > 0', meaning = 'another' }",
    "r": "{ unit = 'm^2', domain = 'r > 0', meaning = 'variance' }",
    "s": "{ unit = 'm', domain = 's > 0', meaning = 'deviation' }",
    "d": "{ unit = 'm^2', domain = 'd > 0', meaning = 'variance' }",
    "q": "{ unit = 'm^2 s^-2', domain = 'q > 0', meaning = 'variance' }",
    "w": "{ unit = 'm s^-1', domain = 'w > 0', meaning = 'deviation' }",
    "c": "{ unit = 'm^2 s^-1', domain = 'c > 0', meaning = 'density' }",
    "g": "{ unit = 'm^2 s^-3', domain = 'g > 0', meaning = 'density' }",
    "u": "{ unit = 's', domain = 'u > 0', meaning = 'time constant' }",
    "p": "{ unit = 'm^2 s^-4', domain = 'p > 0', meaning = 'variance' }",
}
LEVEL = ("[['a']]", "[['d']]", "[['1']]", "[['R']]")
TWO = ("[['1', 'T'], ['0', '1']]", "[['d', '0'], ['0', 'q']]", "[['1', '0']]", "[['R']]")
FADING = ("[['1', 'T'], ['0', 'a']]", "[['0', '0'], ['0', 'w^2']]", "[['1', '0']]", "[['R']]")
MODELS: list[tuple[str, ...]] = [
    LEVEL,
    ("[['a']]", "[['s^2']]", "[['1']]", "[['4']]"),
    ("[['a']]", "[['3']]", "[['b']]", "[['r']]"),
    TWO,
    FADING,
    ("[['a', 'T'], ['0', '1']]", "[['d', '0'], ['0', 'q']]", "[['1', '0']]", "[['R']]"),
    (
        r"[['1', 'T'], ['0', '1 - \frac{T}{u}']]",
        "[['0', '0'], ['0', 'g T']]",
        "[['1', '0']]",
        "[['R']]",
    ),
    (
        "[['1', 'T'], ['0', '1']]",
        r"[['c T + \frac{g T^3}{3}', '\frac{g T^2}{2}'], ['\frac{g T^2}{2}', 'g T']]",
        "[['1', '0']]",
        "[['s^2']]",
    ),
    (
        r"[['1', 'T', '\frac{T^2}{2}'], ['0', '1', 'T'], ['0', '0', '1']]",
        "[['d', '0', '0'], ['0', 'q', '0'], ['0', '0', 'p']]",
        "[['1', '0', '0']]",
        "[['R']]",
    ),
]
At = Mapping[str, float]


def in_numbers(place: int, at: At) -> Sequence[Sequence[Sequence[float]]]:
    """F, Q, H and R of one of the models."""
    a, b, c, d, g, p, q, t, w = (at[name] for name in "abcdgpqTw")
    r, s = at["R"], at["s"]
    taylor: list[list[float]] = [[1, t, t**2 / 2], [0, 1, t], [0, 0, 1]]
    white: list[list[float]] = [[c * t + g * t**3 / 3, g * t**2 / 2], [g * t**2 / 2, g * t]]
    models: tuple[tuple[Sequence[Sequence[float]], ...], ...] = (
        ([[a]], [[d]], [[1]], [[r]]),
        ([[a]], [[s**2]], [[1]], [[4]]),
        ([[a]], [[3]], [[b]], [[at["r"]]]),
        ([[1, t], [0, 1]], [[d, 0], [0, q]], [[1, 0]], [[r]]),
        ([[1, t], [0, a]], [[0, 0], [0, w**2]], [[1, 0]], [[r]]),
        ([[a, t], [0, 1]], [[d, 0], [0, q]], [[1, 0]], [[r]]),
        ([[1, t], [0, 1 - t / at["u"]]], [[0, 0], [0, g * t]], [[1, 0]], [[r]]),
        ([[1, t], [0, 1]], white, [[1, 0]], [[s**2]]),
        (taylor, [[d, 0, 0], [0, q, 0], [0, 0, p]], [[1, 0, 0]], [[r]]),
    )
    return models[place]


def setting(model: tuple[str, ...]) -> str:
    lines = [f"{name} = {rows}" for name, rows in zip(MATRICES, model, strict=True)]
    return "\n".join(["kind = 'steady_state'", *lines])


@cache
def solved(model: tuple[str, ...], token: str = "", domain: str = "") -> Environment | str:
    said = {token: f"{{ unit = '1', domain = '{domain}', meaning = 'said' }}"} if token else {}
    table = "".join(f"'{k}' = {v}\n" for k, v in (SYMBOLS | said).items())
    text = f"{HEAD}{setting(model)}\n[settings.s.symbols]\n{table}"
    text += "[[claims]]\nid = '1'\nplace = '-'\nkind = 'identity'\nsetting = 's'\nlatex = 'P = P'\n"
    try:
        return own_environment(read_claim_text(text, "trial.toml").settings["s"])
    except Undecided as reason:
        return str(reason)


def value(expr: Expr, at: Mapping[str, float]) -> float:
    parts = [value(part, at) for part in expr.parts]
    match expr.kind:
        case "number":
            return float(expr.fraction)
        case "symbol":
            return at[expr.name]
        case "add":
            return sum(parts)
        case "mul":
            return float(np.prod(parts))
        case "neg":
            return -parts[0]
        case "div":
            return parts[0] / parts[1]
        case _:
            return float(parts[0] ** float(expr.fraction))


def holds(rel: Rel, at: Mapping[str, float]) -> bool:
    left, right = value(rel.left, at), value(rel.right, at)
    return {">": left > right, ">=": left >= right - 1e-9, "<": left < right}[rel.operator]


@pytest.mark.alike
@pytest.mark.sampled
@pytest.mark.parametrize("place", range(len(MODELS)))
def test_all_quantities_are_those_of_the_riccati_equation(place: int) -> None:
    environment = solved(MODELS[place])
    assert isinstance(environment, Environment)
    generator = random.Random(place)
    for _ in range(samples(4)):
        at = {name: generator.uniform(0.2, 3) for name in "bcdgpqrswTR"}
        at["u"] = at["T"] * generator.uniform(1.1, 4)
        at["a"] = generator.uniform(0.1, 0.9)
        f, q, h, r = (np.array(rows, dtype=float) for rows in in_numbers(place, at))
        m = solve_discrete_are(f.T, h.T, q, r)
        innovation = (h @ m @ h.T + r)[0, 0]
        gain = (m @ h.T)[:, 0] / innovation
        base = {f"free {name}": x for name, x in at.items()}
        base |= {f"filter_gain.{i + 1}": g * at["T"] ** i for i, g in enumerate(gain)}
        base |= {"sampling_interval": at["T"], "measurement_noise_deviation": sqrt(r[0, 0])}
        wanted = {f"filter_gain.{i + 1}": g * at["T"] ** i for i, g in enumerate(gain)}
        wanted |= {f"predictor_gain.{i + 1}": g * at["T"] ** i for i, g in enumerate(f @ gain)}
        for i, row in enumerate(m):
            for j, entry in enumerate(row):
                wanted[f"predicted_covariance.{i + 1}.{j + 1}"] = entry
                left = entry - gain[i] * (h @ m)[0, j]
                wanted[f"updated_covariance.{i + 1}.{j + 1}"] = left
        wanted["innovation_variance"] = innovation
        found = {name: value(environment.quantities[name], base) for name in wanted}
        found |= {token: value(e, base) for token, e in environment.assigned.items()}
        for name, x in found.items():
            assert isclose(x, wanted.get(name, at.get(name, 0)), rel_tol=1e-6, abs_tol=1e-9), name
        assert all(holds(rel, base) for rel in environment.conditions)


ROOT = r"\sqrt{((a^2 - 1) R + d)^2 + 4 d R}"
CLAIMS = [
    (LEVEL, "identity", r"P = a^2 \alpha R + d", "proved"),
    (LEVEL, "identity", rf"P = \frac{{(a^2 - 1) R + d + {ROOT}}}{{2}}", "proved"),
    (LEVEL, "identity", rf"P = \frac{{(a^2 - 1) R + d - {ROOT}}}{{2}}", "refuted"),
    (LEVEL, "identity", rf"P = \frac{{(a^2 + 1) R + d + {ROOT}}}{{2}}", "refuted"),
    (LEVEL, "identity", r"P = a \alpha R + d", "refuted"),
    (LEVEL, "inequality", r"0 < \alpha < 1", "proved"),
    (LEVEL, "inequality", r"d < P < \frac{d}{1 - a^2}", "proved"),
    (LEVEL, "inequality", r"P < d", "refuted"),
    (LEVEL, "equivalence", r"P > R \Leftrightarrow \alpha > \frac{1}{2}", "proved"),
    (TWO, "identity", r"\beta^2 = \frac{q T^2 (1 - \alpha)}{R}", "proved"),
    (
        TWO,
        "identity",
        r"\frac{d}{R} = \frac{\alpha^2 - 2 \beta + \alpha \beta}{1 - \alpha}",
        "proved",
    ),
    (TWO, "identity", r"\beta (2 - \alpha) = \alpha^2", "refuted"),
    (TWO, "inequality", r"\beta (2 - \alpha) < \alpha^2", "proved"),
    (TWO, "inequality", r"\beta (2 - \alpha) > \alpha^2", "refuted"),
    (TWO, "inequality", r"0 < \beta < 1", "proved"),
    (TWO, "inequality", r"\beta < \frac{1}{2}", "conditional"),
    (TWO, "identity", "S = P + R", "proved"),
    (FADING, "identity", r"\beta = \frac{a \alpha^2}{1 + a (1 - \alpha)}", "proved"),
    (FADING, "identity", r"\beta = \frac{\alpha^2}{1 + a (1 - \alpha)}", "refuted"),
    (FADING, "inequality", r"\beta < \alpha", "proved"),
]


@pytest.mark.alike
@pytest.mark.parametrize(("model", "kind", "latex", "wanted"), CLAIMS)
def test_claims(model: tuple[str, ...], kind: str, latex: str, wanted: str) -> None:
    check(judged(kind, f"latex = '{latex}'", SYMBOLS, setting(model)), wanted)


@pytest.mark.parametrize(
    ("domain", "wanted"),
    [("0 < d < R", "proved"), ("0 < d < 2 R", "conditional"), ("d > 0", "conditional")],
)
def test_what_is_said_of_a_strength_is_true_of_the_gains(domain: str, wanted: str) -> None:
    # a = 1, d = R has the gain (sqrt(5) - 1)/2, less than 5/8, and the gain grows with both
    said = SYMBOLS | {"d": f"{{ unit = 'm^2', domain = '{domain}', meaning = 'variance' }}"}
    check(judged("inequality", r"latex = '\alpha < \frac{5}{8}'", said, setting(LEVEL)), wanted)


def test_what_is_said_beside_a_measurement_noise_in_numbers() -> None:
    said = SYMBOLS | {"s": "{ unit = '1', domain = '0 < s < 2', meaning = 'deviation' }"}
    check(
        judged("inequality", r"latex = '\alpha < \frac{5}{8}'", said, setting(MODELS[1])), "proved"
    )
    found = solved(MODELS[1], "s", "0 < s < 2")
    assert isinstance(found, Environment)
    sides = [side for rel in found.conditions for side in (rel.left, rel.right)]
    assert symbols_of(*sides) == {"filter_gain.1", "free a"}


@pytest.mark.parametrize(
    ("kind", "fields"),
    [
        ("identity", r"latex = '\frac{\partial \alpha}{\partial a} = 0'"),
        ("identity", r"latex = '\frac{\partial \alpha}{\partial R} = 0'"),
        ("identity", r"latex = '\frac{\partial \alpha}{\partial d} = 0'"),
        ("identity", r"latex = '\left. \alpha \right|_{a = 1/2} = \alpha'"),
        ("limit", r"latex = '\alpha \to 0 \quad (a \to 0)'"),
        ("monotone", "about = ['P', 'a']\ntrend = 'nondecreasing'\ntext = 'in words'"),
        ("determines", "about = ['a', 'P']\ntext = 'in words'"),
    ],
)
def test_how_gains_change_with_a_number_is_not_seen_at_one_filter(kind: str, fields: str) -> None:
    check(judged(kind, fields, SYMBOLS, setting(LEVEL)), "undecided")


@pytest.mark.parametrize(
    ("model", "why"),
    [
        (("[['a']]", "[['d w']]", "[['1']]", "[['R']]"), "product of symbols"),
        (
            ("[['a', '0'], ['0', 'a']]", "[['d', '0'], ['0', 'b d']]", "[['1', '1']]", "[['R']]"),
            "",
        ),
        (("[['a']]", "[['d + c T']]", "[['1']]", "[['R']]"), "more strengths than the gains tell"),
        (("[['a']]", "[['2']]", "[['1']]", "[['3']]"), ""),
        (("[['b']]", "[['d - c T']]", "[['1']]", "[['R']]"), "more strengths"),
        (
            ("[['1', 'T'], ['0', 'a']]", "[['d', 'c'], ['0', 'q']]", "[['1', '0']]", "[['R']]"),
            "not symmetric",
        ),
    ],
)
def test_what_is_not_solved_says_so(model: tuple[str, ...], why: str) -> None:
    found = solved(model)
    assert isinstance(found, str)
    assert why in found


def test_a_time_constant_is_not_the_interval() -> None:
    model = setting((r"[['1 - \frac{T}{u}']]", *LEVEL[1:]))
    check(judged("identity", r"\alpha = \frac{d}{d + R}", SYMBOLS, model), "refuted")
    true = r"P = \left(1 - \frac{T}{u}\right)^2 \alpha R + d"
    check(judged("identity", true, SYMBOLS, model), "proved")


DRIFT = ("[['1', 'T'], ['0', 'a']]", *TWO[1:])
LAGGED = (r"[['1', 'T'], ['0', '1 - \frac{T}{u}']]", *TWO[1:])
SEEN = ("[['a']]", "[['d']]", "[['b']]", "[['R']]")
TURNED = (r"[['a', 'b T'], ['-\frac{b}{T}', 'a']]", *TWO[1:])


@pytest.mark.alike
@pytest.mark.parametrize(
    ("model", "token", "domain", "latex", "wanted"),
    [
        # b = 0 sees nothing: P = d/(1 - a^2) and no gain
        (SEEN, "b", r"b \geq 0", r"P < \frac{d}{1 - a^2}", "undecided"),
        (SEEN, "b", r"b \geq 0", r"\alpha > 0", "undecided"),
        (SEEN, "b", "b < 1", r"b > 0", "undecided"),
        (SEEN, "b", r"b \neq 0", r"P < \frac{d}{1 - a^2}", "proved"),
        (SEEN, "b", "b < 0", r"\alpha < 0", "proved"),
        # a = 0 forgets the velocity: its prediction varies by q alone, and its gain is 0
        (DRIFT, "a", r"0 \leq a < 1", r"\beta \neq 0", "undecided"),
        (DRIFT, "a", "a < 1", r"V > q", "undecided"),
        (DRIFT, "a", "0 < a < 1", r"V > q", "proved"),
        (DRIFT, "a", r"a \neq 0", r"V > q", "proved"),
        # with one strength nothing is divided by a
        (FADING, "a", r"0 \leq a < 1", r"\beta \geq 0", "proved"),
        (FADING, "a", r"0 \leq a < 1", r"\beta > 0", "conditional"),
        (LAGGED, "u", "u > 0", r"u \neq T", "undecided"),
        (LAGGED, "u", "u > T", r"u \neq T", "proved"),
        # a quarter of a turn, a = 0, measures the first state anew each time
        (TURNED, "a", "a^2 + b^2 = 1", r"\beta \neq 0", "undecided"),
    ],
)
def test_a_filter_at_which_the_solution_divides_by_zero_counts(
    model: tuple[str, ...], token: str, domain: str, latex: str, wanted: str
) -> None:
    unit = "s" if token == "u" else "1"
    said = SYMBOLS | {token: f"{{ unit = '{unit}', domain = '{domain}', meaning = 'said' }}"}
    said |= {"V": "{ quantity = 'predicted_covariance.2.2', meaning = 'of the velocity' }"}
    found = judged("inequality", f"latex = '{latex}'", said, setting(model))
    check(found, wanted)
    if wanted == "undecided":
        assert "is 0, which no domain excludes" in found.reason


HALF = ("[['1/2']]", *LEVEL[1:])
SQUARED = (TWO[0], "[['s^2', '0'], ['0', 'w^2']]", *TWO[2:])
ROOT_SAYS = "solved for s > 0 only"


@pytest.mark.alike
@pytest.mark.parametrize(
    ("model", "domain", "latex", "wanted"),
    [
        # s = 0 is a filter: of one state with a > 1 its gain is 1 - 1/a^2, of two random velocity
        ((LEVEL[0], "[['s^2']]", *LEVEL[2:]), r"s \geq 0", "s > 0", "conditional"),
        ((LEVEL[0], "[['s^2']]", *LEVEL[2:]), r"s \geq 0", r"\alpha > 0", "conditional"),
        ((LEVEL[0], "[['s^2']]", *LEVEL[2:]), r"s \geq 0", r"\alpha \geq 0", "proved"),
        ((LEVEL[0], "[['s^2']]", *LEVEL[2:]), "s > 0", r"\alpha > 0", "proved"),
        ((LEVEL[0], "[['s^2']]", *LEVEL[2:]), r"s \neq 0", "s > 0", ROOT_SAYS),
        ((LEVEL[0], "[['s^2']]", *LEVEL[2:]), "s < 0", r"\alpha > 0", ROOT_SAYS),
        (SQUARED, r"s \geq 0", r"\beta (2 - \alpha) < \alpha^2", "conditional"),
        (SQUARED, r"s \geq 0", r"\beta (2 - \alpha) \leq \alpha^2", "proved"),
        (SQUARED, "s > 0", r"\beta (2 - \alpha) < \alpha^2", "proved"),
        (SQUARED, "s > w T", r"\beta (2 - \alpha) < \alpha^2", "proved"),
        (SQUARED, r"s \neq 0", "w s > 0", ROOT_SAYS),
        # the measurement has noise; s itself may be either root of its variance
        ((*LEVEL[:3], "[['s^2']]"), r"s \geq 0", "s > 0", ROOT_SAYS),
        ((*LEVEL[:3], "[['s^2']]"), r"s \neq 0", "s > 0", ROOT_SAYS),
        ((*LEVEL[:3], "[['s^2']]"), "s > 0", r"\alpha < 1", "proved"),
        ((*LEVEL[:3], "[['s']]"), r"s \geq 0", r"\alpha < 1", ROOT_SAYS),
        # one strength, all else numbers: half of the state stays, so no noise is a filter too
        ((HALF[0], "[['s^2']]", *HALF[2:]), r"s \geq 0", r"\alpha > 0", ROOT_SAYS),
        ((HALF[0], "[['s']]", *HALF[2:]), r"s \geq 0", "s > 0", ROOT_SAYS),
        ((HALF[0], "[['s']]", *HALF[2:]), "s > 0", r"\alpha > 0", "proved"),
        # what moves on without noise has no steady state
        (("[['1']]", "[['s^2']]", *LEVEL[2:]), r"s \geq 0", r"\alpha > 0", "proved"),
        (("[['1']]", "[['s^2']]", *LEVEL[2:]), r"s \neq 0", "s > 0", ROOT_SAYS),
    ],
)
def test_a_strength_may_be_zero_and_a_root_negative_where_no_domain_says_otherwise(
    model: tuple[str, ...], domain: str, latex: str, wanted: str
) -> None:
    unit = "m^2" if "[['s']]" in model else "m"
    said = SYMBOLS | {"s": f"{{ unit = '{unit}', domain = '{domain}', meaning = 'said' }}"}
    if "s" in model[3]:
        said = {k: v for k, v in said.items() if k != "R"}
    found = judged("inequality", f"latex = '{latex}'", said, setting(model))
    if wanted == ROOT_SAYS:
        assert found.verdict == "undecided"
        assert wanted in found.reason
    else:
        check(found, wanted)


Sides = Callable[..., tuple[float, float]]
SLOTS: list[tuple[tuple[str, ...], str, tuple[int, ...], Sides]] = [
    (
        LEVEL,
        r"P = %d a^%d \alpha R + %d d",
        (1, 2, 1),
        lambda v, i, j, k: (v["P"], i * v["a"] ** j * v["K1"] * v["R"] + k * v["d"]),
    ),
    (
        LEVEL,
        r"P^2 + (%d - a^%d) R P - %d d P = %d d R",
        (1, 2, 1, 1),
        lambda v, i, j, k, m: (
            v["P"] ** 2 + (i - v["a"] ** j) * v["R"] * v["P"] - k * v["d"] * v["P"],
            m * v["d"] * v["R"],
        ),
    ),
    (
        TWO,
        r"%d \beta^2 R = %d q T^2 (%d - \alpha)",
        (1, 1, 1),
        lambda v, i, j, k: (
            i * v["K2"] ** 2 * v["R"],
            j * v["q"] * v["T"] ** 2 * (k - v["K1"]),
        ),
    ),
    (
        TWO,
        r"d (%d - \alpha) = R (%d \alpha^%d - %d \beta + %d \alpha \beta)",
        (1, 1, 2, 2, 1),
        lambda v, i, j, k, m, n: (
            v["d"] * (i - v["K1"]),
            v["R"] * (j * v["K1"] ** k - m * v["K2"] + n * v["K1"] * v["K2"]),
        ),
    ),
    (
        FADING,
        r"(%d + %d a (%d - \alpha)) \beta = %d a \alpha^%d",
        (1, 1, 1, 1, 2),
        lambda v, i, j, k, m, n: (
            (i + j * v["a"] * (k - v["K1"])) * v["K2"],
            m * v["a"] * v["K1"] ** n,
        ),
    ),
]


@pytest.mark.alike
@pytest.mark.sampled
@pytest.mark.parametrize("seed", range(samples(10)))
def test_one_other_number_is_as_scipy_has_it(seed: int) -> None:
    generator = random.Random(seed)
    model, latex, numbers, sides = SLOTS[seed % len(SLOTS)]
    place = generator.randrange(len(numbers))
    other = list(numbers)
    other[place] += generator.choice((-1, 1, 2))
    at = {name: generator.uniform(0.2, 3) for name in "bcdgpqrswTRu"}
    at["a"] = generator.uniform(0.1, 0.9)
    f, q, h, r = (np.array(x, dtype=float) for x in in_numbers(MODELS.index(model), at))
    m = solve_discrete_are(f.T, h.T, q, r)
    gain = (m @ h.T)[:, 0] / (h @ m @ h.T + r)[0, 0]
    at |= {"P": m[0, 0]} | {f"K{i + 1}": g * at["T"] ** i for i, g in enumerate(gain)}
    for slots in (numbers, tuple(other)):
        left, right = sides(at, *slots)
        wanted = "proved" if isclose(left, right, rel_tol=1e-8) else "refuted"
        found = judged("identity", f"latex = '{latex % slots}'", SYMBOLS, setting(model))
        assert found.verdict == wanted, found.reason
