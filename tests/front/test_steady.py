"""`gainproof steady` and `gainproof.steady_state`: what users see, and refusals in their words."""

from __future__ import annotations

import json
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import mpmath
import numpy as np
import pytest
from scipy.linalg import solve_discrete_are

import gainproof
from gainproof import cli
from gainproof.steady.state import Enclosed, first_samples
from gainproof.verify import check_enclosure

PLANE = """
format = "gainproof model 1"
title = "two axes"
transition = [[1, 0, "T", 0], [0, 1, 0, "T"], [0, 0, 1, 0], [0, 0, 0, 1]]
process_noise = [
  ["q T^4/4", 0, "q T^3/2", 0], [0, "q T^4/4", 0, "q T^3/2"],
  ["q T^3/2", 0, "q T^2", 0], [0, "q T^3/2", 0, "q T^2"],
]
measurement = [[1, 0, 0, 0], [0, 1, 0, 0]]
measurement_noise = [["R", 0], [0, "R"]]
states = { x = "m", y = "m", vx = "m/s", vy = "m/s" }
measurements = { east = "m", north = "m" }

[symbols]
'T' = { unit = "s", domain = 'T > 0', meaning = "interval" }
'q' = { unit = "m^2/s^4", domain = 'q > 0', meaning = "variance of the acceleration" }
'R' = { unit = "m^2", domain = 'R > 0', meaning = "variance of a measurement" }
"""


@pytest.fixture
def plane(tmp_path: Path) -> Path:
    path = tmp_path / "plane.toml"
    path.write_text(PLANE)
    return path


def test_the_last_column_bounds_what_is_shown(
    plane: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """In a narrow table, whose digits are few, against the recursion of one axis in 50 digits."""
    monkeypatch.setenv("COLUMNS", "72")
    assert cli.main(["steady", str(plane), "--at", "T=1/2,q=2,R=9"]) == 0
    table = capsys.readouterr().out.partition("predicted covariance\n")[2].splitlines()
    with mpmath.workdps(50):
        t, r = mpmath.mpf(1) / 2, 9
        f = mpmath.matrix([[1, t], [0, 1]])
        noise = 2 * mpmath.matrix([[t**4 / 4, t**3 / 2], [t**3 / 2, t**2]])
        p = mpmath.eye(2)
        for _ in range(600):
            seen = p[:, 0]
            p = f * (p - seen * seen.T / (p[0, 0] + r)) * f.T + noise
        for row, true in ((1, p[0, 0]), (3, p[1, 1])):
            cells, _, error = table[row].partition("+-")
            shown = cells.split("]")[1].split()[row - 1]
            assert 0 < abs(mpmath.mpf(shown) - true) <= mpmath.mpf(error.strip()) < 1e-6
            assert len(shown) < 16


def test_a_page_and_json(plane: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """T = q = R = 1: alpha = 3/4 and beta = 1/2 on each axis, by hand."""
    assert cli.main(["steady", str(plane), "--at", "T=1,q=1,R=1"]) == 0
    page = capsys.readouterr().out
    assert "two axes, at T = 1, q = 1, R = 1" in page
    assert "  vx [m s^-1]    0.5      0  +- 2e-17" in page
    assert "2 within" in page
    said = ["steady", str(plane), "--at", "T=1", "--at", "q=1, R=1.00", "--json"]
    assert cli.main(said) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["filter_gain"]["values"] == [[0.75, 0], [0, 0.75], [0.5, 0], [0, 0.5]]
    assert found["filter_gain"]["errors"][0][1] == 0 < found["filter_gain"]["errors"][0][0] < 1e-16
    assert found["states"][2] == {"name": "vx", "unit": "m s^-1"}
    assert [pole["count"] for pole in found["poles"]] == [2, 2]
    assert found["at"] == {"T": "1", "q": "1", "R": "1"}


def test_a_certificate_for_strangers(plane: Path, tmp_path: Path) -> None:
    file = tmp_path / "c.json"
    said = ["steady", str(plane), "--at", "T=1/3,q=2.5,R=1e-3", "--certificate", str(file)]
    assert cli.main(said) == 0
    command = [sys.executable, "-I", check_enclosure.__file__, str(file)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert "proved" in done.stdout
    assert '"1/3"' in done.stdout


def test_a_singular_noise_that_is_not_rational(plane: Path) -> None:
    """Of rank one, with a strength whose root is no rational number: no rounding of ours is blamed,
    and what is no covariance is.
    """
    text = PLANE.replace(
        "[symbols]\n", "[symbols]\n's' = { definition = '\\exp(q)', meaning = 'x' }\n"
    )
    text = text.replace('unit = "m^2/s^4", domain', 'unit = "1", domain').replace("m/s", "m")
    text = text.replace("q T", "s T").replace('unit = "s"', 'unit = "1"').replace("m^2", "1")
    plane.write_text(text.replace('= "m"', '= "1"'))
    assert cli.main(["steady", str(plane), "--at", "T=1/3,q=1/7,R=1"]) == 0
    plane.write_text(plane.read_text().replace("s T^4/4", "0.9 s T^4/4"))
    assert cli.main(["steady", str(plane), "--at", "T=1/3,q=1/7,R=1"]) == 2


def test_the_first_samples(plane: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """From the variance 1 of a position measured with the variance 1 the gain is 1/2 at first; of
    the velocity it is 0 then.
    """
    said = ["steady", str(plane), "--at", "T=1,q=1,R=1", "--first", "3"]
    assert cli.main(said) == 2
    assert "--first needs `start`" in capsys.readouterr().err
    unit = [[int(i == j) for j in range(4)] for i in range(4)]
    plane.write_text(PLANE.replace("[symbols]", f"start = {unit}\n\n[symbols]"))
    assert cli.main(said) == 0
    page = capsys.readouterr().out
    assert "x, east" in page
    assert "  1" in page
    assert cli.main([*said, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)["samples"]
    assert [row[0] for row in found[0]["filter_gain"]["values"]] == [0.5, 0, 0, 0]
    assert found[2]["filter_gain"]["errors"][0][0] < 1e-16
    for wrong, words in ((["--first", "0"], "1 to 1000"), (["--first", "x"], "a whole number")):
        assert cli.main([*said, *wrong]) == 2
        assert words in capsys.readouterr().err
    assert cli.main([*said, "--certificate", str(plane.parent / "c")]) == 2
    assert "belongs to the steady state" in capsys.readouterr().err


def test_the_first_samples_from_python() -> None:
    """Gains 1/2, 1/3, 1/4 of a mean, by hand."""
    found = first_samples([[1]], [[1]], [[0]], [[1]], [[1]], 3)
    assert [each.filter_gain.values[0][0] for each in found] == [1 / 2, 1 / 3, 1 / 4]
    for start, words in (([[1, 0]], "start: wanted 1 by 1"), ([[-1]], "start: row 1, column 1")):
        with pytest.raises(gainproof.BadInputError, match=words):
            first_samples([[1]], [[1]], [[0]], [[1]], start, 3)


def test_the_first_samples_of_a_mode_that_no_measurement_sees() -> None:
    """Its variance leaves the doubles after a sample, or falls below all of them; 0 stays exact."""
    with pytest.raises(gainproof.BadInputError, match="beyond float64: scale the units"):
        first_samples([["1e999"]], [[0]], [[1]], [[1]], [[1]], 1000)
    last = first_samples([["1e-999"]], [[0]], [[0]], [[1]], [[1]], 1000)[-1]
    assert (last.predicted_covariance.values, last.filter_gain.errors) == (((0.0,),), ((0.0,),))
    assert 0 < last.predicted_covariance.radius[0][0] < Fraction(1, 10**400)
    (known,) = first_samples([[1]], [[1]], [[0]], [[1]], [[0]], 1)
    assert known.filter_gain.errors == known.updated_covariance.errors == ((0.0,),)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--at", "T=1,q=1"], "R has no value: say it with --at R=..."),
        (["--at", "T=0,q=1,R=1"], "T is outside of its domain, T > 0"),
        (["--at", "T=1,q=1,R=x"], "--at: R: a number is wanted, got 'x'"),
        (["--at", "T=1,q=1,R=1e9999"], "--at: R: a number is wanted"),
        (["--at", "T=1,q=1,r=1"], "nearest: R"),
        (["--at", "T=1,T=2"], "T has two values"),
        (["--at", "T"], "NAME=VALUE is wanted, got 'T'"),
    ],
)
def test_values_that_do_not_fit(
    plane: Path, arguments: list[str], words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert cli.main(["steady", str(plane), *arguments]) == 2
    told = capsys.readouterr().err
    assert words in told
    assert told.count("\n") == 1


def test_values_beyond_doubles_are_told(plane: Path, capsys: pytest.CaptureFixture[str]) -> None:
    without_units = [x for x in PLANE.splitlines() if not x.startswith(("states", "measurements"))]
    plane.write_text("\n".join(without_units).replace('"R"', '"R/R"'))
    assert cli.main(["steady", str(plane), "--at", "T=1,q=1,R=1e400"]) == 0
    assert "two axes, at T = 1, q = 1, R = 1e+400\n" in capsys.readouterr().out


def test_all_mistakes_of_a_file_are_told(plane: Path, capsys: pytest.CaptureFixture[str]) -> None:
    plane.write_text(PLANE.replace("q T^2", "q_3 T^2").replace('unit = "s"', 'unit = "sec"'))
    assert cli.main(["steady", str(plane)]) == 2
    told = capsys.readouterr().err
    assert "plane.toml, line 15: symbols.T.unit: " in told
    assert (
        "plane.toml, line 7, column 19: model.process_noise: the symbol q_3 is not declared" in told
    )


def test_a_model_in_python_is_not_executed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "model.py"
    file.write_text("raise SystemExit(7)")
    assert cli.main(["steady", str(file)]) == 2
    assert "a model as text is wanted" in capsys.readouterr().err


def within(enclosed: Enclosed, true: Any) -> bool:
    values, errors = np.array(enclosed.values), np.array(enclosed.errors)
    return bool(np.all(np.abs(values - np.array(true, dtype=float)) <= errors + 1e-13))


def test_from_python_with_arrays_and_exact_numbers() -> None:
    """Against SciPy, whose errors are of 1e-14 here."""
    f, h = np.array([[1, 0.5], [0, 0.75]]), np.array([[1, 0]])
    q, r = np.diag([0.25, 2.0]), np.array([[0.5]])
    found = gainproof.steady_state(f, h, q, r)
    p = solve_discrete_are(f.T, h.T, q, r)
    assert within(found.predicted_covariance, p)
    k = p @ h.T / (p[0, 0] + 0.5)
    assert within(found.filter_gain, k)
    assert within(found.predictor_gain, f @ k)
    assert within(found.updated_covariance, p - k @ h @ p)
    poles = np.linalg.eigvals(f - f @ k @ h)
    assert min(abs(found.poles[0].centre - z) for z in poles) < 1e-12
    found.check()
    same = gainproof.steady_state(
        [[1, Decimal("0.5")], [0, "3/4"]],
        [[np.int64(1), 0]],
        [["0.25", 0], [0, 2]],
        [[Fraction(1, 2)]],
    )
    assert same.predicted_covariance == found.predicted_covariance


def test_errors_are_those_of_the_doubles() -> None:
    """P^2 = P + 1 for F = Q = R = 1: the error holds for the double, not for the centre alone."""
    found = gainproof.steady_state([[1]], [[1]], [[1]], [[1]]).predicted_covariance
    value, error = Fraction(found.values[0][0]), Fraction(found.errors[0][0])
    assert 0 < error < Fraction(1, 2**51)
    low, high = value - error, value + error
    assert low**2 - low - 1 < 0 < high**2 - high - 1


def test_correlated_noises() -> None:
    """Against SciPy."""
    f, h, q, r, s = [[0.9]], [[1.0]], [[1.0]], [[2.0]], [[0.5]]
    found = gainproof.steady_state(f, h, q, r, s)
    p = solve_discrete_are(np.array(f).T, np.array(h).T, q, r, s=np.array(s))
    assert within(found.predicted_covariance, p)
    assert within(found.predictor_gain, (0.9 * p + 0.5) / (p + 2))


def test_roundings_of_doubles_are_told_from_mistakes() -> None:
    """g g' in doubles, with one place less than is right, and a product that is not symmetric."""
    f, h, r = np.array([[1, 0.1], [0, 1]]), [[1, 0]], [[1]]
    q = np.outer([0.1**2 / 2, 0.1], [0.1**2 / 2, 0.1])
    q[0, 0] *= 1 - 1e-15
    with pytest.raises(gainproof.BadInputError, match=r"Q: .* by rounding alone: write its"):
        gainproof.steady_state(f, h, q, r)
    gainproof.steady_state(f, h, q + np.diag(1e-12 * np.diag(q)), r)
    q = np.array([[1, 0.1], [np.nextafter(0.1, 1), 1]])
    with pytest.raises(gainproof.BadInputError, match=r"by rounding: take \(Q \+ Q\.T\)/2"):
        gainproof.steady_state(f, h, q, r)
    gainproof.steady_state(f, h, (q + q.T) / 2, r)
    with pytest.raises(gainproof.BadInputError, match=r"semidefinite$"):
        gainproof.steady_state(f, h, [[1, 1.001], [1.001, 1]], r)


@pytest.mark.parametrize(
    ("matrices", "words"),
    [
        (([[1, 0]], [[1]], [[1]], [[1]]), "F: wanted 1 by 1, but it is 1 by 2"),
        (([[1]], [[1], [1]], [[1]], [[1]]), "R: wanted 2 by 2, but it is 1 by 1"),
        (([[1]], [[1]], [[1]], [[1]], [[0, 0]]), "S: wanted 1 by 1, but it is 1 by 2"),
        ((3, [[1]], [[1]], [[1]]), "F: a matrix is wanted, as a list of rows"),
        (([[1, 2], [1]], [[1]], [[1]], [[1]]), "F: rows of one length are wanted"),
        (([[1]], [[1]], [[float("nan")]], [[1]]), "Q: row 1, column 1: a finite number is wanted"),
        (
            ([[1]], [["two"]], [[1]], [[1]]),
            "H: row 1, column 1: a finite number is wanted, got 'two'",
        ),
        (([[1]], [[1]], [[1]], [["1/0"]]), "R: row 1, column 1: a finite number is wanted"),
        (([[1]], [[1]], [[1]], [[-1]]), "R: row 1, column 1 is -1: a variance is not negative"),
        (
            (np.eye(2), [[1, 0]], [[1, 2], [3, 1]], [[1]]),
            "Q: row 2, column 1 is 3, and row 1, column 2 is 2: a covariance is symmetric",
        ),
        ((np.eye(2), [[1, 0]], [[1, 2], [2, 1]], [[1]]), "Q: no covariance"),
        (([[1]], [[1]], [[1]], [[1]], [[2]]), "S: more than Q and R allow"),
        (([[1]], [[1]], [[0]], [[1]]), "no steady state: not driven: no noise reaches"),
        (([[1]], [[0]], [[1]], [[1]]), "no steady state: not seen: no measurement sees"),
        ((np.eye(41), np.eye(41), np.eye(41), np.eye(41)), "at most 40"),
        (([["1e300"]], [[1]], [["1e300"]], [["1e-300"]]), ""),
        (([[1]], [[1]], [["1e350"]], [["1"]]), "beyond float64"),
        ((np.eye(2), [[1, 0]], [[1, 10**400], [2, 1]], [[1]]), "column 2 is 1.00000e+400: a cov"),
        (([[1]], [[1]], [[1]], [["-1e-400"]]), "R: row 1, column 1 is -1e-400: a variance"),
        (([[10**5000]], [[1]], [[1]], [[1]]), "F: row 1, column 1: a number has at most 1200"),
        (([[1]], [[1]], [[1]], [[Fraction(1, 10**1200)]]), "R: row 1, column 1: a number has"),
    ],
)
def test_what_cannot_be_used_is_told_in_a_line(matrices: Any, words: str) -> None:
    if not words:
        gainproof.steady_state(*matrices)
        return
    with pytest.raises(gainproof.BadInputError) as raised:
        gainproof.steady_state(*matrices)
    assert words in str(raised.value)
    assert "\n" not in str(raised.value)
