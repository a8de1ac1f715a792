"""The figures of example 1: what is counted agrees with theory, and the files hold it."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from gainproof import cli
from gainproof.figures.doppler import drawing, example
from gainproof.location.monte_carlo import position_covariance


@pytest.fixture(autouse=True)
def few_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (example, drawing):
        for name, count in (("RUNS", 200), ("CURVE_RUNS", 200), ("POINTS", 150)):
            if hasattr(module, name):
                monkeypatch.setattr(module, name, count)


def test_errors_are_those_that_the_covariance_promises() -> None:
    table = example.monte_carlo()
    assert len(table["bias_B1_m"]) == 4 * len(example.SETS)
    for name in ("x_m", "y_m", "vx_m_s", "vy_m_s"):
        known = np.isfinite(table[f"promised_{name}"])
        # an RMS of n draws is off by 1/sqrt(2 n): 0.05; 11 rows of four, 4.5 deviations
        share = table[f"rms_{name}"][known] / table[f"promised_{name}"][known]
        assert known.sum() == 11
        assert np.abs(share - 1).max() < 4.5 / np.sqrt(2 * 200)
    biased = [row for row, name in enumerate(table.words("ranges")) if name == "4 clean ranges"]
    assert np.isfinite(table["promised_x_m"][biased]).tolist() == [True] + [False] * 5


def test_detection_rates_are_those_of_the_noncentral_chi_square() -> None:
    from scipy import stats  # half a second, in every process that collects

    table = example.detection_rates()
    limit = stats.chi2.ppf(0.95, 1)
    for i in range(1, 5):
        deviation = table.numbers["1-sigma of the bias found (m)"][f"B{i}"]
        shift = (table["bias_m"][1:] / deviation) ** 2
        wanted = stats.ncx2.sf(limit, 1, shift)
        assert np.allclose(table[f"theory_B{i}"][1:], wanted, rtol=1e-9, atol=0)
        counted = table[f"counted_B{i}"]
        told = np.isfinite(counted)
        assert table["bias_m"][told].tolist() == list(range(0, 121, 10))
        spread = np.sqrt(np.maximum(wanted.min(), 0.25) / 200)
        assert np.abs(counted[told] - table[f"theory_B{i}"][told]).max() < 4.5 * spread


def test_ellipses_hold_the_draws() -> None:
    """Of bias detection 95 %, off by the sampling; of 4 clean ranges the area is the least."""
    table = example.geometry()
    what = np.array(table.words("what"))
    points = np.stack([table["x_m"], table["y_m"]], axis=1)
    found = points[what == "bias detection"]
    covariance = position_covariance((0, 1, 2, 3))
    inside = np.einsum("ni,ij,nj->n", found, np.linalg.inv(covariance), found) < example.RADIUS**2
    assert abs(inside.mean() - 0.95) < 4.5 * np.sqrt(0.95 * 0.05 / 150)
    sizes = [np.ptp(points[what == name], axis=0).prod() for name, _ in example.MODELS]
    assert sizes == sorted(sizes, reverse=True)


def test_each_is_drawn_and_the_same_twice(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["figure", "doppler"]) == 0
    names = [line.split()[0] for line in capsys.readouterr().out.splitlines()]
    assert names == ["monte-carlo", "detection", "geometry"]
    for name in ("detection", "geometry"):
        assert cli.main(["figure", "doppler", name]) == 0
        assert cli.main(["figure", "doppler", name, "--csv", "--out", "again"]) == 0
        one = (tmp_path / "figures" / f"doppler-{name}.csv").read_bytes()
        assert one == (tmp_path / "again" / f"doppler-{name}.csv").read_bytes()
        picture = (tmp_path / "figures" / f"doppler-{name}.svg").read_text(encoding="utf-8")
        assert "</svg>" in picture
        assert (tmp_path / "figures" / f"doppler-{name}.png").stat().st_size > 20_000
