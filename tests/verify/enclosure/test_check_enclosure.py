"""The checker of steady states that stands alone: each condition by hand, right and wrong."""

from __future__ import annotations

import ast
import copy
import json
import random
import subprocess
import sys
from fractions import Fraction
from math import isqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from riccati_recursion import drawn, limit, model
from samples import samples

from gainproof.verify import check_enclosure
from gainproof.verify.check_enclosure import Box, decide, definite, root
from gainproof.verify.enclosure.steady import steady
from gainproof.verify.enclosure.structure import Model

FILE = Path(check_enclosure.__file__)
Data = dict[str, Any]
GRIDS = ("upper", "slack", "predictor", "filter", "floor")


def scalar(**changes: str) -> Data:
    """F = 2, H = 1, R = 1 without process noise: of P = 4 P/(P + 1) the solutions are 0 and 3."""
    numbers = {"F": "2", "H": "1", "Q": "0", "R": "1", "S": "0", "upper": "3.001", "slack": "0.002"}
    numbers |= {"predictor": "1.5", "filter": "0.75", "floor": "3.9"} | changes
    grids: Data = {name: [[x]] for name, x in numbers.items()}
    return {"format": check_enclosure.FORMAT, "parts": [[0], [0]], **grids}


def test_a_certificate_by_hand_encloses_the_solution_that_is_stable() -> None:
    found = decide(scalar())
    true = {"predicted": "3", "updated": "3/4", "filter": "3/4", "predictor": "3/2"}
    for name, value in true.items():
        assert abs(found[name].c[0][0] - Fraction(value)) <= found[name].radius[0][0] < 0.01


def test_gains_that_belong_to_the_upper_matrix_are_not_taken_for_exact() -> None:
    """At X = 3.001 they are 3001/4001 and 6002/4001, where nothing is left but X - P."""
    found = decide(scalar(filter="3001/4001", predictor="6002/4001"))
    for name, value in (("filter", Fraction(3, 4)), ("predictor", Fraction(3, 2))):
        assert 0 < abs(found[name].c[0][0] - value) <= found[name].radius[0][0] < 0.001


@pytest.mark.sampled
def test_definite_as_the_eigenvalues_say() -> None:
    """Small matrices of small numbers, many of them singular, against NumPy."""
    draw = random.Random(9)
    seen = set()
    for _ in range(samples(300)):
        n = draw.randint(1, 4)
        a = [[Fraction(draw.randint(-2, 2)) for _ in range(n)] for _ in range(n)]
        a = [[a[i][j] if i <= j else a[j][i] for j in range(n)] for i in range(n)]
        if draw.random() < 0.5:
            a = (Box(a) @ Box(a)).c
        least = np.linalg.eigvalsh(np.array(a, dtype=float)).min()
        for strict in (False, True):
            true = least > 1e-9 if strict else least > -1e-9
            try:
                definite(Box(a), "", strict)
                found = True
            except ValueError:
                found = False
            assert found == true, a
        seen.add(int(np.sign(least.round(9))))
    assert seen == {-1, 0, 1}


BROKEN = {
    # P = P/4/(P + 1) - 1/16 has a solution next to -0.084: no covariance
    "W >= 0": scalar(
        F="1/2", Q="-1/16", upper="-0.08", slack="0.01", predictor="-0.04", filter="-0.09",
        floor="0.9"
    ),
    # Ric(-1/10) = -4/9 and Ric(1) = 2, with nothing between that needs be a solution
    "X >= Y": scalar(upper="-0.1", slack="-1.1", predictor="-0.22", filter="-0.1", floor="2"),
    # Ric(2) = 8/3
    "X >= Ric(X)": scalar(upper="2", slack="0.5", predictor="4/3", filter="2/3", floor="2"),
    # the fixed point 0, whose filter is not stable: Ric(0) = 0 is not above 0
    "Ric(Y) > Y": scalar(upper="0", slack="0", predictor="0", filter="0", floor="1"),
    # H Y H' + R is not 100, which would make errors of gains small
    "H Y H' + R >= diag(floor)": scalar(floor="100"),
}  # fmt: skip


@pytest.mark.parametrize("condition", BROKEN)
def test_what_breaks_one_condition_is_rejected_by_that_one_alone(
    condition: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(ValueError, match="not shown") as raised:
        decide(BROKEN[condition])
    assert str(raised.value) == f"not shown: {condition}"
    whole = check_enclosure.definite

    def without(box: Any, what: str, strict: bool = False) -> None:
        if what != condition:
            whole(box, what, strict)

    monkeypatch.setattr(check_enclosure, "definite", without)
    decide(BROKEN[condition])


def test_not_strict_is_not_enough() -> None:
    """With Ric(Y) >= Y in place of > the fixed point 0 would pass beside 3."""
    definite(Box([[Fraction(0)]]), "")
    with pytest.raises(ValueError, match="not shown"):
        definite(Box([[Fraction(0)]]), "", strict=True)


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"format": "gainproof answer 1"}, "no gainproof steady state"),
        ({"upper": [["3.001", "0"]]}, "shape"),
        ({"slack": [["nan"]]}, "no numbers"),
        ({"slack": [["1e9999999"]]}, "no numbers"),
        ({"F": [[["2", "-1"]]]}, "radius"),
        ({"upper": [[["3.001", "0.1"]]]}, "radii"),
        ({"floor": [["-1"]]}, "floor"),
        ({"parts": [[0], [1]]}, "parts that meet"),
    ],
)
def test_what_is_no_certificate_is_rejected(changes: Data, reason: str) -> None:
    with pytest.raises(ValueError, match=reason):
        decide(scalar() | changes)


def test_a_box_without_a_covariance_is_rejected() -> None:
    """Q = -1/2: P^2 - 5/2 P + 1/2 = 0 has the root 2.2807764..., which no filter has. That R is a
    box does not help, and a box that reaches 0 may be meant.
    """
    boxed: Data = {"upper": "2.2817764", "slack": "0.002", "predictor": "1.39038", "floor": "3.1"}
    boxed |= {"filter": "0.69519", "Q": "-0.5"}
    for q, r in (("-0.5", "1"), ("-0.5", ["1", "1e-300"]), (["-0.5", "0.499"], "1")):
        with pytest.raises(ValueError, match="W >= 0"):
            decide({**scalar(**boxed), "Q": [[q]], "R": [[r]]})
    decide({**scalar(), "Q": [[["-1e-9", "1e-9"]]]})


@pytest.mark.parametrize("f", [{"2": [["999"]]}, [{"2": "999"}], ["2"], "2"])
def test_what_is_no_list_of_lists_is_rejected(f: Any) -> None:
    with pytest.raises(ValueError, match="shape of F"):
        decide({**scalar(), "F": f})


def test_a_radius_that_is_no_text_is_rejected() -> None:
    """As a double 0.3 is less than it says."""
    wide = {**scalar(), "R": [[["1", "1e-9"]]]}
    decide(wide)
    for radius in (0, 1e-9, 0.3, True, None):
        with pytest.raises(TypeError):
            decide({**wide, "R": [[["1", radius]]]})


def test_noises_that_are_not_symmetric_are_rejected() -> None:
    data = dict(steady(model([[0, 1], [0, 0]], [[1, 0]], [[1, 0], [0, 1]], [[1]])).certificate)
    decide(data)
    for name in ("Q", "upper", "slack"):
        wrong = copy.deepcopy(data)
        wrong[name][0][1] = "1/2"
        with pytest.raises(ValueError, match="not s"):
            decide(wrong)


def encloses(data: Data, true: dict[str, list[list[Fraction]]]) -> bool:
    found = decide(data)
    return all(
        abs(x - y) <= e + Fraction(1, 10**60)
        for name, box in found.items()
        for row in zip(box.c, true[name], box.radius, strict=True)
        for x, y, e in zip(*row, strict=True)
    )


@pytest.mark.sampled
def test_of_an_altered_certificate_whatever_passes_is_still_true() -> None:
    """Any number of the proof altered: most are rejected, and what is not says the truth."""
    draw = random.Random(4)
    rejected = 0
    for kind in ("plain", "singular", "correlated", "unstable"):
        of = drawn(draw, 3, 2, kind)
        data, true = json.loads(json.dumps(steady(of).certificate)), limit(of)
        assert encloses(data, true)
        for _ in range(samples(40)):
            wrong = copy.deepcopy(data)
            name = draw.choice(GRIDS)
            i = draw.randrange(len(wrong[name]))
            j = draw.randrange(len(wrong[name][i]))
            number = Fraction(wrong[name][i][j])
            by = Fraction(draw.choice([1, -1])) / 10 ** draw.choice([3, 12, 18])
            wrong[name][i][j] = str(number * (1 + by) if draw.random() < 0.8 else number + by)
            if name in ("upper", "slack"):
                wrong[name][j][i] = wrong[name][i][j]
            try:
                assert encloses(wrong, true), (kind, name)
            except ValueError:
                rejected += 1
    assert rejected > samples(20)


def test_a_certificate_of_another_model_is_rejected() -> None:
    """Also of one whose numbers differ by one part in 10^15."""
    draw = random.Random(5)
    first, second = drawn(draw, 3, 2, "plain"), drawn(draw, 3, 2, "plain")
    data, other = (json.loads(json.dumps(steady(of).certificate)) for of in (first, second))
    mixed = {**data, **{name: other[name] for name in GRIDS}}
    with pytest.raises(ValueError, match="not shown"):
        decide(mixed)
    for name, i, j in (("F", 0, 0), ("H", 1, 2), ("Q", 1, 1), ("R", 0, 0)):
        wrong = copy.deepcopy(data)
        wrong[name][i][j] = str(Fraction(wrong[name][i][j]) * (1 + Fraction(1, 10**15)))
        with pytest.raises(ValueError, match="not shown"):
            decide(wrong)


def test_a_box_holds_for_all_its_models_and_for_no_more() -> None:
    draw = random.Random(6)
    of = drawn(draw, 3, 1, "plain")
    radius = Fraction(1, 10**40)
    boxes = [Box(b.c, [[radius] * len(row) for row in b.c]) for b in (of.f, of.h)]
    wide = Model(boxes[0], boxes[1], of.q, of.r, of.s, of.names)
    data = json.loads(json.dumps(steady(wide).certificate))
    for sign in (-1, 1):
        f, h = ([[x + sign * radius for x in row] for row in box.c] for box in (of.f, of.h))
        assert encloses(data, limit(model(f, h, of.q.c, of.r.c)))
    for name in ("F", "H"):
        wider = copy.deepcopy(data)
        wider[name][0][0][1] = "1/1000"
        with pytest.raises(ValueError, match="not shown"):
            decide(wider)


def test_roots_are_rounded_upwards_and_not_by_much() -> None:
    draw = random.Random(7)
    assert root(Fraction(0)) == 0
    for _ in range(200):
        x = Fraction(draw.randint(1, 10**9), draw.randint(1, 10**9)) * Fraction(10) ** draw.randint(
            -300, 300
        )
        assert 1 < root(x) ** 2 / x < 1 + Fraction(1, 2**29)


def test_the_file_stands_alone_and_decides_from_the_command_line(tmp_path: Path) -> None:
    text = FILE.read_text()
    assert len(text.splitlines()) <= 150
    imported = {
        (alias.name if isinstance(node, ast.Import) else str(node.module)).partition(".")[0]
        for node in ast.walk(ast.parse(text))
        if isinstance(node, ast.Import | ast.ImportFrom)
        for alias in node.names
    }
    assert imported <= sys.stdlib_module_names
    (tmp_path / "checker.py").write_text(text)
    for changes, status in (({}, 0), ({"upper": "2.9"}, 1)):
        (tmp_path / "c.json").write_text(json.dumps(scalar(**changes)))
        command = [sys.executable, "-I", "checker.py", "c.json"]
        done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode == status
        assert ("proved" in done.stdout) == (status == 0)
        assert ("not shown: " in done.stderr) == (status == 1)


@pytest.mark.parametrize("unit", [0, -200, -330, -400])
def test_errors_that_are_printed_hold_of_the_numbers_as_printed(tmp_path: Path, unit: int) -> None:
    """Q = 2, R = 3 in a unit: P = 1 + sqrt(7). Shown are doubles, which round, even to 0."""
    scale = Fraction(10) ** unit
    data = steady(model([[1]], [[1]], [[2 * scale]], [[3 * scale]])).certificate
    (tmp_path / "c.json").write_text(json.dumps(data))
    command = [sys.executable, str(FILE), str(tmp_path / "c.json")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    p = 1 + Fraction(isqrt(7 * 10**120), 10**60)
    true = {"predicted": p * scale, "updated": 3 * p / (p + 3) * scale, "filter": p / (p + 3)}
    true["predictor"] = true["filter"]
    told = [line.split() for line in done.stdout.splitlines()[:4]]
    assert {name for name, *_ in told} == set(true)
    for name, _, value, _, error in told:
        e = Fraction(error)
        assert abs(Fraction(value) - true[name]) + scale / 10**50 <= e < Fraction("1e-15")


def test_what_is_exact_is_printed_without_an_error(tmp_path: Path) -> None:
    """Without process noise a state that decays is known: P = 0."""
    data = steady(model([[Fraction(1, 2)]], [[1]], [[0]], [[1]])).certificate
    (tmp_path / "c.json").write_text(json.dumps(data))
    command = [sys.executable, str(FILE), str(tmp_path / "c.json")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert all(line.endswith(" 0.0 +- 0.0e+00") for line in done.stdout.splitlines()[:4])
