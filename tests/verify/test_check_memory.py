"""Certificates about growing and fading memories: what is true is accepted, what is false never.

What a certificate states is evaluated from its lines with exact fractions and mpmath: gain and
covariance by solving least squares of its F and H sample by sample, nothing of N and V.
"""

from __future__ import annotations

import ast
import copy
import json
import random
import subprocess
import sys
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from time import process_time
from typing import Any

import mpmath
import pytest
from small_claims import judged

from gainproof.verify import check_memory
from gainproof.verify.check_memory import FADING, FORMAT, GROWING, main
from gainproof.verify.judge.answer_certificate import (
    NoCertificateError,
    answer_certificate,
    rejected,
)

FILE = Path(check_memory.__file__)
Data = dict[str, Any]
SYMBOLS = {
    "k": ("sample_number", "growing"),
    "w": ("forgetting_factor", "fading"),
    "T": ("sampling_interval", ""),
    "R": ("measurement_noise_variance", ""),
    "a": ("filter_gain.1", ""),
    "b": ("filter_gain.2", ""),
    "c": ("filter_gain.3", ""),
    "d": ("predictor_gain.1", ""),
    "P": ("updated_covariance.1.1", ""),
    "Q": ("updated_covariance.2.2", ""),
    "M": ("predicted_covariance.1.1", "fading"),
    "z": ("measurement", ""),
    "x": ("updated_state.1", ""),
    "p": ("previous_state.1", ""),
}
# textbook formulas (Brookner, Morrison): memory, degree, formula
TRUE = [
    ("growing", 0, r"a = \frac{1}{k + 1}"),
    ("growing", 0, r"x = \frac{k p + z}{k + 1}"),
    ("growing", 1, r"a = \frac{2 (2k + 1)}{(k + 1)(k + 2)}"),
    ("growing", 1, r"b = \frac{6}{(k + 1)(k + 2)} \quad (1 \leq k)"),
    ("growing", 1, r"d = \frac{4}{k + 1}"),
    ("growing", 1, r"Q = \frac{12 R}{T^2 k (k + 1)(k + 2)}"),
    ("growing", 1, r"\sqrt{P} = \sqrt{R} \sqrt{\frac{2 (2k + 1)}{(k + 1)(k + 2)}}"),
    ("growing", 2, r"c = \frac{60}{(k + 1)(k + 2)(k + 3)}"),
    ("growing", 3, r"a = \frac{8 (2k^3 + 3k^2 + 7k + 3)}{(k + 1)(k + 2)(k + 3)(k + 4)}"),
    ("fading", 0, r"P = \frac{1 - w}{1 + w} R"),
    ("fading", 1, "a = 1 - w^2"),
    ("fading", 1, r"M = \frac{R (1 - w)(5 + 4w + w^2)}{(1 + w)^3}"),
    ("fading", 2, r"b = \frac{3}{2} (1 - w)^2 (1 + w)"),
    ("fading", 3, "a = 1 - w^4"),
]


def asked(memory: str, degree: int, latex: str, sort: str = "identity", **setting: Any) -> Any:
    """The verdict on a formula."""
    symbols = {
        name: f"{{ quantity = '{quantity}', meaning = 'a quantity' }}"
        for name, (quantity, only) in SYMBOLS.items()
        if only in ("", memory)
        and int(quantity[-1] if quantity[-1:].isdigit() else 1) <= degree + 1
    }
    fields = "".join(f"\n{name} = {value!r}" for name, value in setting.items())
    kind = f"kind = '{memory}_memory'\ndegree = {degree}\ngain = 'filter'{fields}"
    return judged(sort, latex, symbols, kind)


@cache
def certified(number: int) -> str:
    """As text, so that nobody changes it."""
    claim = asked(*TRUE[number]).to_json()
    assert claim["verdict"] == "proved", claim["reason"]
    return json.dumps(answer_certificate(claim))


# what a certificate states, by its lines alone


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
        case ast.Call(args=[a]):
            return mpmath.sqrt(value(a, known))
        case ast.BinOp(left=left, op=op, right=right):
            a, b = value(left, known), value(right, known)
            if isinstance(op, ast.Pow):
                return a ** int(b)
            names = {ast.Add: "add", ast.Sub: "sub", ast.Mult: "mul", ast.Div: "truediv"}
            return getattr(a, f"__{names[type(op)]}__")(b)
    raise AssertionError(ast.dump(node))


def least_squares(known: dict[str, Any], text: str) -> None:
    """Gain and covariances from the weights of samples, the oldest first."""
    f, h, r = mpmath.matrix(known["F"]), mpmath.matrix(known["H"]), known["r"]
    growing = text == GROWING
    count = int(known["n"]) + 1 if growing else 220
    w = mpmath.mpf(1) if growing else known["w"]
    back, row = f**-1, h
    normal, squared = mpmath.zeros(f.rows), mpmath.zeros(f.rows)
    for i in range(count):
        normal += w**i * row.T * row
        squared += w ** (2 * i) * row.T * row
        row = row * back
    inverse = normal**-1
    covariance = r * inverse * squared * inverse
    found = {"K": inverse * h.T, "X": covariance, "P": f * covariance * f.T}
    for name, m in found.items():
        for i in range(m.rows):
            for j in range(m.cols):
                known[f"{name}[{i + 1}, {j + 1}]"] = m[i, j]


def states_what_is_so(data: Data, source: random.Random) -> bool:
    """At numbers that meet its conditions, as far as some are found."""
    lines = [(title, text) for title, text in data["lines"] if title not in ("typed", "name")]
    met = 0
    with mpmath.workdps(60):
        for _ in range(60):
            known: dict[str, Any] = {}
            try:
                fits = all(holds(title, text, known, source) for title, text in lines)
            except KeyError:
                return False
            except ZeroDivisionError:
                continue
            if not fits:
                return False
            met += 1
            if met == 4:
                return True
    return True


def holds(title: str, text: str, known: dict[str, Any], source: random.Random) -> bool:
    name, _, said = (part.strip() for part in text.partition("="))
    if title == "real":
        whole = mpmath.mpf(source.randint(0, 9))
        known[name] = whole if name == "n" else mpmath.mpf(source.randint(1, 39)) / 80
        known[name] += source.randint(0, 1) * (name not in "nw")
    elif title == "with":
        known[name] = value(said, known)
    elif title == "memory":
        least_squares(known, text)
    elif title in ("where", "claim"):
        node: Any = ast.parse(text, mode="eval").body
        left, right = value(node.left, known), value(node.comparators[0], known)
        difference = left - right
        if abs(difference) < (1 + abs(left) + abs(right)) * mpmath.mpf(10) ** -25:
            difference = 0
        signs = {ast.Eq: difference == 0, ast.Gt: difference > 0, ast.GtE: difference >= 0}
        if title == "where" and not signs[type(node.ops[0])]:
            raise ZeroDivisionError
        return bool(signs[type(node.ops[0])])
    return True


@pytest.mark.parametrize("number", range(len(TRUE)))
def test_a_formula_of_a_memory_has_a_certificate(number: int) -> None:
    data = json.loads(certified(number))
    assert rejected(data) is None
    texts = dict(data["lines"])
    assert texts["memory"] == (GROWING if TRUE[number][0] == "growing" else FADING)
    assert states_what_is_so(data, random.Random(number))


@pytest.mark.parametrize("number", range(len(TRUE)))
def test_an_altered_certificate_is_rejected_or_states_what_is_so(number: int) -> None:
    source, refused = random.Random(number), 0
    for _ in range(12):
        data = json.loads(certified(number))
        line = source.choice([line for line in data["lines"] if line[0] not in ("typed", "name")])
        if source.random() < 0.1:
            data["lines"].remove(line)
        else:
            pairs = ["+-", "-+", "12", "23", "*+", ("**2", "**3"), (">=", ">"), (">", "<"), "nk"]
            pairs += [("1/2*", ""), ("0", "1"), "Fw", "12", ("1,1", "1,2")]
            old, new = source.choice([pair for pair in pairs if pair[0] in line[1]] or ["rs"])
            places = [k for k in range(len(line[1])) if line[1].startswith(old, k)] or [0]
            k = source.choice(places)
            line[1] = line[1][:k] + new + line[1][k + len(old) :]
        if rejected(data) is None:
            assert states_what_is_so(data, source), json.dumps(data)
        else:
            refused += 1
    assert refused > 4


LINE = [
    ["real", "n"],
    ["where", "n >= 1"],
    ["with", "F = [[1, 1], [0, 1]]"],
    ["with", "H = [[1, 0]]"],
    ["with", "N = [[n + 1, -n*(n + 1)/2], [-n*(n + 1)/2, n*(n + 1)*(2*n + 1)/6]]"],
    ["with", "d = 1/((n + 1)*(n + 2))"],
    [
        "with",
        "V = [[(4*n + 2)*d, 6*d], [6*d, 12*d/n]]",
    ],
    ["with", "r = 1"],
    ["memory", GROWING],
]
MEAN = [
    ["real", "w"],
    ["where", "w > 0"],
    ["where", "1 > w"],
    ["with", "F = [[1]]"],
    ["with", "H = [[1]]"],
    ["with", "N = [[1/(1 - w)]]"],
    ["with", "V = [[1 - w]]"],
    ["with", "Z = [[1/((1 - w)*(1 + w))]]"],
    ["with", "r = 1"],
    ["memory", FADING],
]
ONE = [
    ["real", "n"],
    ["where", "n >= 0"],
    ["with", "F = [[1]]"],
    ["with", "H = [[1]]"],
    ["with", "N = [[n + 1]]"],
    ["with", "V = [[1/(n + 1)]]"],
    ["with", "r = 1"],
    ["memory", GROWING],
]
V2, Z4 = "V = [[1/(n + 1)**2]]", "Z = [[1/(1 - 4*w**2)]]"
GAIN, OF_MEAN = ["claim", "K[2,1] == 6/((n + 1)*(n + 2))"], ["claim", "K[1,1] == 1 - w"]


def certificate(
    lines: list[list[str]], *more: list[str], other: Mapping[str, str] | None = None
) -> Data:
    """With another text for what begins so, which is left out if that is empty."""
    told = [*copy.deepcopy(lines), *more]
    for name, text in (other or {}).items():
        (k,) = (k for k, line in enumerate(told) if line[1].startswith(name))
        told[k] = [told[k][0], text]
    return {"format": FORMAT, "lines": [line for line in told if line[1]]}


def test_certificates_by_hand_are_accepted() -> None:
    assert rejected(certificate(LINE, GAIN)) is None
    assert rejected(certificate(ONE, ["claim", "K[1,1] == 1/(n + 1)"])) is None
    assert rejected(certificate(MEAN, OF_MEAN, ["claim", "X[1,1] == (1 - w)/(1 + w)"])) is None


N3 = "N = [[n + 1, -n*(n + 1)/2], [-n*(n + 1)/2, n**3/3 + n**2/2 + n/6 + {}]]"
WRONG: list[Any] = [
    # a false claim
    (LINE, ["claim", "K[2,1] == 6/((n + 1)*(n + 3))"], {}),
    (LINE, ["claim", "K[2,1] != 6/((n + 1)*(n + 3))"], {}),
    (LINE, ["claim", "K[1,1] > 0"], {}),
    (MEAN, ["claim", "X[1,1] == 1 - w"], {}),
    # no memory, or one that is not shown
    (LINE, GAIN, {"N = s": ""}),
    (LINE[:2], ["claim", "n == n"], {}),
    (LINE, GAIN, {"F": "F = [[1, 2], [0, 1]]"}),
    (LINE, GAIN, {"H": "H = [[1, 1]]"}),
    (LINE, GAIN, {"H": "H = [[1, 0], [1, 0]]"}),
    (LINE, GAIN, {"N = [": "N = [[n, -n*(n - 1)/2], [-n*(n - 1)/2, n*(n - 1)*(2*n - 1)/6]]"}),
    (LINE, GAIN, {"r": "r = 0"}),
    (LINE, GAIN, {"r": "r = n"}),
    (LINE, GAIN, {"r": "r = 0 - 1"}),
    (ONE, ["claim", "X[1,1] == 1/(n + 1)**2"], {"r": "r = 1/(n + 1)"}),
    # no samples that determine it; numbers that are no number of a sample
    (LINE, GAIN, {"n >": "n >= 0"}),
    (LINE, GAIN, {"n >": "n > 0 - 5"}),
    (LINE, GAIN, {"n >": ""}),
    ([*LINE[:2], ["where", "2 > n"], *LINE[2:]], GAIN, {}),
    ([*LINE[:2], ["where", "0 > n"], *LINE[2:]], GAIN, {}),
    ([*LINE[:2], ["where", "n > 5"], *LINE[2:]], GAIN, {}),
    # weights that do not fall, or are others
    (MEAN, OF_MEAN, {"1 > w": ""}),
    (MEAN, OF_MEAN, {"1 > w": "2 > w"}),
    (MEAN, OF_MEAN, {"1 > w": "1 >= w"}),
    (MEAN, OF_MEAN, {"w > 0": ""}),
    (MEAN, OF_MEAN, {"N = [": "N = [[1/(1 + w)]]"}),
    (MEAN, OF_MEAN, {"V": "V = [[1/(1 - w)]]"}),
    (MEAN, ["claim", "X[1,1] == 1 - w"], {"Z": "Z = [[1/(1 - w)]]"}),
    # w = 1 is no fading memory, which a number would be
    ([["with", "w = 1"], *MEAN[3:]], ["claim", "w == 1"], {"N = [": "N = [[1]]", "V": "V = [[1]]"}),
    # what is seen by no sample has no weight: N is not the sum
    ([["real", "a"], *MEAN], OF_MEAN, {"F": "F = [[a]]"}),
    # divisors that vanish, roots of what is negative
    (MEAN, ["claim", "1/(2*w - 1) == 1/(2*w - 1)"], {}),
    (MEAN, ["claim", "1/(w - w) == 1"], {}),
    (MEAN, ["claim", "sqrt(w - 1) == sqrt(w - 1)"], {}),
    (MEAN, ["claim", "sqrt((1 - 2*w)**2) == 1 - 2*w"], {}),
    (MEAN, ["claim", "0 - sqrt(w**2) == w"], {}),
    # what follows from matrices that are not those of the law: another inverse, sum, or start
    (MEAN, ["claim", "K[1,1] == 1/(1 - w)"], {"V": "V = [[1/(1 - w)]]"}),
    (MEAN, ["claim", "K[1,1] == 1 + w"], {"V": "V = [[1 + w]]", "N = [": "N = [[1/(1 + w)]]"}),
    (ONE, ["claim", "K[1,1] == 1/(n + 2)"], {"N = [": "N = [[n + 2]]", "V": "V = [[1/(n + 2)]]"}),
    (ONE, ["claim", "K[1,1] == 1/(n + 1)**2"], {"N = [": "N = [[(n + 1)**2]]", "V": V2}),
    # a sum that has no end and no value
    (
        MEAN,
        ["claim", "K[1,1] == 1 - 4*w"],
        {"F": "F = [[1/2]]", "N = [": "N = [[1/(1 - 4*w)]]", "V": "V = [[1 - 4*w]]", "Z": Z4}
        | {"w > 0": "w > 1/2"},
    ),
    (
        [["with", "w = 5"], *MEAN[3:]],
        ["claim", "K[1,1] == 0 - 4"],
        {"N = [": "N = [[-1/4]]", "V": "V = [[-4]]", "Z": "Z = [[-1/24]]"},
    ),
    (
        MEAN,
        OF_MEAN,
        {"1 > w": "w > 1", "w > 0": "", "N = [": "N = [[1/(1 - w)]]", "Z": "Z = [[1/(1 - w**2)]]"},
    ),
    # a variable without bounds, or without values
    ([["real", "x"], *MEAN], ["claim", "1/(x + 1) == 1/(x + 1)"], {}),
    ([["real", "x"], ["where", "x > 5"], ["where", "1 > x"], *MEAN], OF_MEAN, {}),
    # names of others
    ([*MEAN[:3], ["with", "K = [[1]]"], *MEAN[3:]], OF_MEAN, {}),
    ([*MEAN[:3], ["with", "P = [[1]]"], *MEAN[3:]], OF_MEAN, {}),
    ([*LINE, ["with", "P = [[1]]"]], ["claim", "P[1,1] == 1"], {}),
    (LINE, ["claim", "P[1,1] == P[1,1]"], {}),
    ([*MEAN, ["with", "w = 5"]], OF_MEAN, {}),
    ([*MEAN, ["with", "K = [[1]]"]], OF_MEAN, {}),
    ([*MEAN, MEAN[-1]], OF_MEAN, {}),
    ([*MEAN, ["memory", GROWING]], OF_MEAN, {}),
    ([*MEAN, ["memory", "of elephants"]], OF_MEAN, {}),
    ([*MEAN, ["other", "x"]], OF_MEAN, {}),
    ([*MEAN, ["typed", "x\nclaim: 1 == 2"]], OF_MEAN, {}),
    ([*MEAN, ["typed", "x\x1b[2K"]], OF_MEAN, {}),
    ([*MEAN, ["typed", f"x{' ' * 60}claim: 1"]], OF_MEAN, {}),
    # entries that are none
    (MEAN, ["claim", "K[0,0] == 1 - w"], {}),
    (MEAN, ["claim", "K[-1,-1] == 1 - w"], {}),
    (MEAN, ["claim", "K[True,True] == 1 - w"], {}),
    (MEAN, ["claim", "K == K"], {}),
    (MEAN, OF_MEAN, {"F": "F = [1]"}),
    (MEAN, OF_MEAN, {"F": "F = [[]]"}),
    (MEAN, OF_MEAN, {"F": "F = []"}),
]


@pytest.mark.parametrize("number", range(len(WRONG)))
def test_what_does_not_follow_is_refused(number: int) -> None:
    lines, claim, other = WRONG[number]
    assert rejected(certificate(lines, claim, other=other)) is not None


@pytest.mark.parametrize(
    "n",
    [
        # right for all n >= 0 but not for n = -1, where no sample is; or not at each step
        N3.format("1"),
        N3.format("n*(n - 1)*(n - 2)"),
        # equal to the sum where a letter has its value alone
        "N = [[n + 1, -n*(n + 1)/2], [-n*(n + 1)/2, (n + 1)*a/6]]",
        "N = [[k, -n*k/2], [-n*k/2, n*k*(2*n + 1)/6]]",
    ],
)
def test_a_sum_is_shown_for_every_number_of_samples(n: str) -> None:
    assert rejected(certificate(LINE, GAIN, other={"N = [": N3.format("0")})) is None
    own = [["with", "a = n*(2*n + 1)"], ["with", "k = n + 1"]]
    lines = [*LINE[:2], *own, *LINE[2:]]
    found = rejected(certificate(lines, GAIN, other={"N = [": n}))
    # names for polynomials of n are these polynomials, and no way round
    assert (found is None) == ("a/6" in n or "k" in n)


def test_a_moving_transition_is_no_transition() -> None:
    # N is the sum that this F would have if it were the same at each step
    for name, text in (("F", "F = [[1, n], [0, 1]]"), ("H", "H = [[n, 0]]")):
        assert rejected(certificate(LINE, GAIN, other={name: text})) is not None


def test_a_false_formula_or_an_order_has_no_certificate() -> None:
    for latex, kind in (("a = 1 - w", "identity"), ("a > 0", "inequality")):
        claim = asked("fading", 1, latex, kind).to_json()
        assert claim["verdict"] in ("proved", "refuted")
        with pytest.raises(NoCertificateError):
            answer_certificate(claim)


def test_samples_counted_from_1_are_told() -> None:
    claim = asked("growing", 1, r"a = \frac{2 (2k - 1)}{k (k + 1)}", index_origin="1").to_json()
    assert claim["verdict"] == "proved"
    lines = answer_certificate(claim)["lines"]
    assert ["with", "k = n + 1"] in lines
    assert ["where", "n >= 1"] in lines
    assert ["claim", "a == 2*(2*k - 1)/(k*(k + 1))"] in lines


def test_one_file_decides_alone(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    nodes = [*ast.walk(ast.parse(FILE.read_text()))]
    names = {a.name for n in nodes if isinstance(n, ast.Import) for a in n.names}
    names |= {str(n.module) for n in nodes if isinstance(n, ast.ImportFrom)}
    assert names <= sys.stdlib_module_names
    assert len(FILE.read_text().splitlines()) <= 300
    (tmp_path / "alone.py").write_text(FILE.read_text())
    (tmp_path / "one.json").write_text(certified(3))
    command = [sys.executable, "-I", "alone.py", "one.json"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=True)
    told = done.stdout.splitlines()
    assert told[-1] == "proved"
    assert f"memory:     {GROWING}" in told
    assert any("least squares" in line for line in told)
    assert main([str(tmp_path / "one.json")]) == 0
    assert capsys.readouterr().out == done.stdout


def powers(letter: str, most: int) -> str:
    return "(" + " + ".join(f"{letter}**{i}" for i in range(most + 1)) + ")"


LETTERS = [["real", x] for x in "abce"]
LONG = [
    ["with", f"q = {3**3000}/{7**1700}"],
    ["with", f"s = q*{powers('a', 30)}*{powers('b', 30)}"],
]
MANY = [["with", f"{x} = {powers(x[0], 36)}*{powers(x[1], 36)}"] for x in ("ab", "ce")]
FAT = "*".join(["(n + a + b + c + d + e)**9"] * 2)
HOSTILE: list[Any] = [
    "",
    "[]",
    "{}",
    "[" * 100_000,
    {"format": FORMAT},
    {"format": FORMAT, "lines": [["claim"]]},
    {"format": FORMAT, "lines": [["claim", 1]]},
    {"format": FORMAT, "lines": {"claim": "1 == 1"}},
    certificate(LINE, ["claim", "2**64**64 == 0"]),
    certificate(LINE, ["claim", "((n + 1)**64)**64 == 0"]),
    certificate(LINE, ["claim", "(" * 900 + "n" + ")" * 900 + " == n"]),
    certificate(LINE, ["claim", "-" * 9000 + "n == n"]),
    certificate(LINE, ["claim", "9" * 9000 + " == n"]),
    certificate(LINE, ["claim", "__import__ == 0"]),
    certificate(LINE, ["claim", "\x1b[2Kproved"]),
    certificate([*[["real", x] for x in "abcde"], *LINE], *[["claim", f"{FAT} == {FAT}"]] * 500),
    certificate([["with", f"N = [{', '.join(['[' + '1, ' * 90 + '1]'] * 60)}]"]], GAIN),
    certificate([*LETTERS, *LONG, *LINE], ["claim", "s*s == s*s"]),  # fractions of many digits
    certificate([*LETTERS, *MANY, *LINE], ["claim", "ab*ce == ab*ce"]),  # millions of terms
]


@pytest.mark.parametrize("number", range(len(HOSTILE)))
def test_what_is_hostile_is_refused_in_a_line(
    number: int,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(check_memory, "SECONDS", 1)
    data, start = HOSTILE[number], process_time()
    (tmp_path / "one.json").write_text(data if isinstance(data, str) else json.dumps(data))
    assert main([str(tmp_path / "one.json")]) == 1
    assert process_time() - start < 3
    (line,) = capsys.readouterr().out.splitlines()
    assert line.startswith("REJECTED: ")
    assert len(line) < 500
    assert line.isprintable()
