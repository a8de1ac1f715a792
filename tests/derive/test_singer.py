"""The Singer model: its formulas against matrix exponentials, and altered ones are rejected."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from numpy.typing import NDArray
from scipy.linalg import expm

from gainproof import cli
from gainproof.bench.subjects import measured_kernels
from gainproof.derive.expression import ExpressionError, graph_of, real
from gainproof.derive.families.singer import NAME, build
from gainproof.derive.pages.derivation import FOLDER
from gainproof.subjects import derivations
from gainproof.verify.certificate import check, check_statement

TEXT = (FOLDER / f"{NAME}.md").read_text(encoding="utf-8")
PLACES = [(1, 1), (1, 2), (1, 3), (2, 2), (2, 3), (3, 3)]
Reals = NDArray[np.float64]


def printed(alpha: float, interval: float, deviation: float) -> tuple[Reals, Reals]:
    """F and Q as the page has them, where rho is the exponential that it stands for."""
    tower = build().towers["main"]
    given = {"alpha": alpha, "T": interval, "maneuver_deviation": deviation}
    given["rho"] = math.exp(-alpha * interval)

    def value(name: str) -> float:
        found = tower.expressions[name]
        while names := {each.name for each in found.free_symbols} - set(given):
            found = found.subs({real(each): tower.expressions[each] for each in names})
        return float(found.subs({real(each): number for each, number in given.items()}))

    across, along = value("transition_13"), value("transition_23")
    noise = np.zeros((3, 3))
    for i, j in PLACES:
        noise[i - 1, j - 1] = noise[j - 1, i - 1] = value(f"process_noise_{i}{j}")
    return np.array([[1, interval, across], [0, 1, along], [0, 0, given["rho"]]]), noise


@pytest.mark.parametrize(
    ("alpha", "interval", "deviation"), [(1.0, 1.0, 1.0), (0.5, 3.0, 2.0), (2.0, 2.5, 0.3)]
)
def test_it_is_the_integral_of_the_exponential(
    alpha: float, interval: float, deviation: float
) -> None:
    """Van Loan: both are blocks of one exponential, made from the equations in time alone."""
    system = np.array([[0, 1, 0], [0, 0, 1], [0, 0, -alpha]])
    both = np.zeros((6, 6))
    both[:3, :3], both[3:, 3:] = -system, system.T
    both[2, 5] = 2 * alpha * deviation**2
    blocks = expm(both * interval)
    wanted = blocks[3:, 3:].T
    transition, noise = printed(alpha, interval, deviation)
    assert transition == pytest.approx(wanted, rel=1e-12, abs=1e-14)
    assert noise == pytest.approx(wanted @ blocks[:3, 3:], rel=1e-9)


def test_numbers_of_a_manual() -> None:
    """What MathWorks prints for `singerProcessNoise`: 1 s, 20 s, 1 m/s^2, to four decimals."""
    _, noise = printed(1 / 20, 1.0, 1.0)
    wanted = [[0.0049, 0.0121, 0.0159], [0.0121, 0.0321, 0.0476], [0.0159, 0.0476, 0.0952]]
    assert noise == pytest.approx(np.array(wanted), abs=5e-5)


def certificate(folder: Path, right: str = "", wrong: str = "") -> dict[str, Any]:
    """That of the page with one place changed."""
    assert not right or TEXT.count(right) == 1
    text = TEXT.replace(right, wrong) if right else TEXT
    (folder / f"{NAME}.md").write_text(text, encoding="utf-8")
    found: dict[str, Any] = json.loads(json.dumps(build(folder).certificate()))
    return found


def test_as_written_everything_is_proved(tmp_path: Path) -> None:
    report = check(certificate(tmp_path))
    assert report.accepted
    assert [each.status for each in report.statements].count("proved") >= 25


@pytest.mark.parametrize(
    ("step", "right", "wrong"),
    [
        ("transition-equation", "(alpha t - 1 + r)/alpha^2", "(alpha t - 1 - r)/alpha^2"),
        ("transition-equation", "- alpha rho derivative(f, rho)", "+ alpha rho derivative(f, rho)"),
        ("transition-start", "at(at(f, T, 0), rho, 1)", "at(at(f, T, 0), rho, 2)"),
        ("two-intervals", "= moved(T + U, rho kappa)\n    back", "= moved(T, rho)\n    back"),
        ("noise-equation", "- 4 alpha t r)/(2 alpha^5)", "- 2 alpha t r)/(2 alpha^5)"),
        ("noise-12", "    noise-12: Q_12 = q (rho^2 + 1", "    noise-12: Q_12 = q (rho^2 - 1"),
        ("two-noises", "Q moved(U, kappa)' + W", "Q moved(U, kappa)' - W"),
        ("both-noises", "at(at(Q, T, T + U), rho, rho kappa)", "at(at(Q, T, T + U), rho, rho)"),
        ("stationary", "rho^2 sigma_m^2 + Q_33", "rho sigma_m^2 + Q_33"),
        ("size", "(1 + 4 P_M - P_0)", "(1 + 2 P_M - P_0)"),
        ("white-jerk", "[q T^5/20,", "[q T^5/10,"),
    ],
)
def test_an_altered_page_is_rejected(tmp_path: Path, step: str, right: str, wrong: str) -> None:
    found = certificate(tmp_path, right, wrong)
    assert check_statement(found, step).status == "rejected"


def test_values_of_two_quantities_are_put_in_one_after_the_other() -> None:
    """A value with the quantity that comes next would be another one if both went in at once."""
    x, y = real("x"), real("y")
    found = graph_of(sp.Subs(sp.Subs(x * y, x, 2), y, x))
    assert [node[0] for node in found["nodes"]].count("at") == 2
    with pytest.raises(ExpressionError, match="free of"):
        graph_of(sp.Subs(x * y, (x, y), (y, 2)))


def test_no_kernels_no_module(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Named for a package it is refused; of everything it is left out; nothing is measured."""
    out = tmp_path / "made"
    assert cli.main(["generate", NAME, "--out", str(out)]) == 2
    assert f"{NAME}: has no kernels" in capsys.readouterr().err
    assert list(measured_kernels([NAME])) == []
    monkeypatch.setattr(derivations, "catalogue", lambda: ["filter-step", NAME])
    assert cli.main(["generate", "--out", str(out), "--target", "c"]) == 0
    names = {path.name for path in out.iterdir()}
    assert "filter_step.py" in names
    assert not any(name.startswith(NAME) for name in names)
    assert NAME not in (out / "README.md").read_text(encoding="utf-8")
