"""`gainproof design`: what it prints, its data, its plot, what it says where there is no filter."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from gainproof import cli

Capture = pytest.CaptureFixture[str]


def answer(capsys: Capture, *arguments: str, status: int = 0) -> str:
    """What is printed."""
    assert cli.main(["design", *arguments]) == status
    return capsys.readouterr().out


def data(capsys: Capture, *arguments: str, status: int = 0) -> dict[str, dict[str, object]]:
    """The filters of the JSON by name; the first of a name."""
    found = json.loads(answer(capsys, *arguments, "--json", status=status))
    return {each["name"]: each for each in reversed(found["filters"])}


@pytest.mark.parametrize(
    ("gains", "fitting"), [(("0.095", "0.01"), ["MV", "NP-S"]), (("0.4571", "0.5"), ["MV"])]
)
def test_the_lectures_two_gain_pairs_are_those_of_mv(
    capsys: Capture, gains: tuple[str, str], fitting: list[str]
) -> None:
    """alpha = -beta/2 + sqrt(beta), to all printed digits; neither RV nor RA.

    Three digits do not tell the first from NP-S, whose 2 sqrt(beta) (1 - alpha) = 2 alpha - beta
    has alpha = 0.105/1.1 = 0.0954...; the second is nobody else's.
    """
    alpha, beta = map(float, gains)
    assert abs(np.sqrt(beta) - beta / 2 - alpha) <= 0.5 * 10.0 ** -len(gains[0].partition(".")[2])
    text = answer(capsys, "--gains", *gains, "--interval", "10", "--acceleration", "0.98")
    assert "these are the gains of: MV (minimum variance, also NP-P)" in text
    found = json.loads(answer(capsys, "--gains", *gains, "--json"))
    assert [each["name"] for each in found["belongs"] if each["within_the_digits"]] == fitting
    (own,) = (each for each in found["belongs"] if each["name"] == "MV")
    assert own["off"]["alpha"] == abs(own["gains_at_this_lag"]["alpha"] - alpha) < 1e-5
    assert {each["name"] for each in found["belongs"]} == {"RV", "RA", "MV", "NP-S"}


def test_digits_decide_what_fits(capsys: Capture) -> None:
    """0.5 stands for 0.45 to 0.55, and there RV passes 0.75; 0.50 stands for less."""
    few = json.loads(answer(capsys, "--gains", "0.75", "0.5", "--json"))["belongs"]
    more = json.loads(answer(capsys, "--gains", "0.750", "0.500", "--json"))["belongs"]
    assert {each["name"] for each in few if each["within_the_digits"]} == {"RV", "RA"}
    assert {each["name"] for each in more if each["within_the_digits"]} == {"RA"}
    none = answer(capsys, "--gains", "0.3", "0.500")
    assert "the gains of none of the named filters" in none


def test_all_filters_of_one_lag(capsys: Capture) -> None:
    """The lecture's relations between the gains, and its order: MV, RA, RV."""
    found = data(capsys, "--lag", "3")
    relations: tuple[tuple[str, Callable[..., float]], ...] = (
        ("RV", lambda a, b: a * (a + b) - 2 * b),
        ("RA", lambda a, b: (a + b / 2) ** 2 - 2 * b),
        ("MV", lambda a, b: a + b / 2 - b**0.5),
    )
    for name, relation in relations:
        gains = found[name]["gains"]
        assert isinstance(gains, dict)
        assert abs(relation(gains["alpha"], gains["beta"])) < 1e-15
        assert gains["beta"] == pytest.approx(1 / 3, rel=1e-15)
        assert found[name]["lag"] == pytest.approx(3, rel=1e-15)
        assert found[name]["stable"] is True
    variance = {name: each["predicted_variance"] for name, each in found.items()}
    assert variance["MV"] < variance["RA"] < variance["RV"]  # type: ignore[operator]


def test_three_states_of_one_lag(capsys: Capture) -> None:
    """The lecture's relations of RA, RJ and MV."""
    found = data(capsys, "--states", "3", "--lag", "7")
    relations: dict[str, Callable[..., tuple[float, float]]] = {
        "RA": lambda a, b, c: (a * (a + b + c / 2) - 2 * b, b * b - 2 * a * c),
        "RJ": lambda a, b, c: (
            2 * a * a + 2 * a * b - 4 * b + a * c - c * c / 18,
            2 * a * c - b * b - c * c / 12,
        ),
        "MV": lambda a, b, c: (
            4 * a * b - c * (8 - 4 * a - b),
            b**3 + 2 * (3 * a - 8) * b**2 + 4 * (3 * a * a - 12 * a + 16) * b - 8 * a * a * (2 - a),
        ),
    }
    for name, relation in relations.items():
        gains = found[name]["gains"]
        assert isinstance(gains, dict)
        assert max(map(abs, relation(*gains.values()))) < 1e-14
        assert 1 / gains["gamma"] == pytest.approx(7, rel=1e-14)


def test_a_tracking_index_is_that_of_each_filters_noise(capsys: Capture) -> None:
    """RA: alpha = 1 - r^2, beta = 2 (1 - r)^2 with index 2 (1 - r)^2/r; MV has none."""
    found = data(capsys, "--tracking-index", "1")
    assert found["RA"]["gains"] == {"alpha": 0.75, "beta": 0.5}
    assert found["MV"]["note"] == "has no tracking index: at the lag of RA"
    assert found["MV"]["lag"] == pytest.approx(2)
    three = data(capsys, "--states", "3", "--tracking-index", "0.1")
    assert three["MV"]["note"] == "has no tracking index: at the lag of RJ"
    assert three["MV"]["lag"] == pytest.approx(three["RJ"]["lag"], rel=1e-12)


def test_a_filter_that_does_not_exist_is_named_and_the_others_are_shown(capsys: Capture) -> None:
    found = data(capsys, "--alpha", "0.6")
    assert found["MV"]["absent"] == (
        "does not exist: alpha must be above 0 and at most 1/2: alpha = sqrt(beta) - beta/2 is "
        "never more; got 0.6"
    )
    assert "gains" in found["RA"]
    found = data(capsys, "--lag", "0.55")
    assert "(1 + sqrt(2))/4 = 0.6036" in str(found["RV"]["absent"])
    assert "gains" in found["MV"]
    text = answer(capsys, "--lag", "0.2", status=1)
    assert text.count("does not exist") == 4
    assert "variance/B" not in text


def test_two_filters_of_one_alpha(capsys: Capture) -> None:
    """MV has two betas for one alpha, and one at alpha = 1/2."""
    both = json.loads(answer(capsys, "--alpha", "0.4", "--json"))["filters"]
    betas = [each["gains"]["beta"] for each in both if each["name"] == "MV"]
    assert betas == pytest.approx([(1 - 0.2**0.5) ** 2, (1 + 0.2**0.5) ** 2])
    one = json.loads(answer(capsys, "--alpha", "0.5", "--json"))["filters"]
    assert [each["gains"]["beta"] for each in one if each["name"] == "MV"] == [1.0]


def test_units(capsys: Capture) -> None:
    """e_fin = a_c T^2/beta = 0.98 * 100/0.5; 16 samples of 10 s; 8 m sqrt(variance)."""
    arguments = ("--gains", "0.4571", "0.5", "--interval", "10", "--acceleration", "0.98")
    given = data(capsys, *arguments, "--deviation", "8")["given"]
    variance = given["predicted_variance"]
    assert isinstance(variance, float)
    assert given["in_units"] == pytest.approx(
        {
            "lag_m": 196.0,
            "settling_s": 160.0,
            "predicted_deviation_m": 8 * variance**0.5,
            "smoothed_deviation_m": 8 * given["smoothed_variance"] ** 0.5,  # type: ignore[operator]
        }
    )
    text = answer(capsys, *arguments)
    assert "filter  lag, m  settles, s\ngiven      196         160\n" in text


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("--gains", "0.5", "3.2"), "beta < 4 - 2 alpha fails: beta = 3.2, 4 - 2 alpha = 3;"),
        (("--gains", "1e-2000057", "1"), "a gain must be a number that float64 holds"),
        (("--gains", "1", "1e400"), "a gain must be a number that float64 holds"),
        (("--lag", "2", "--interval", "1e155", "--acceleration", "1"), "is beyond float64"),
        (
            ("--states", "3", "--lag", "2", "--interval", "1e103", "--jerk", "1"),
            "is beyond float64",
        ),
        (("--lag", "2", "--plot", "a\0b.csv"), "--plot takes the name of a file, got 'a\\x00b"),
        (("--gains", "0.5", "x"), "a gain is a number, got 'x'"),
        (("--gains", "nan", "1"), "a gain must be finite, got 'nan'"),
        (("--gains", "0.5"), "--gains takes alpha and beta, or alpha, beta and gamma, got 1"),
        (("--gains", "0.5", "1", "--states", "3"), "--states 3 has as many gains, got 2"),
        (("--gains", "1e-99", "1e-300"), "beyond the reach of the kernels: alpha = 1e-99"),
        (("--lag", "x"), "--lag must be a number, got 'x'"),
        (("--lag", "-1"), "--lag must be above 0 and finite, got -1"),
        (("--alpha", "nan"), "--alpha must be above 0 and finite, got nan"),
        (("--tracking-index", "inf"), "--tracking-index must be above 0 and finite, got inf"),
        (("--lag", "3", "--jerk", "1"), "--jerk belongs to 3 states; lags of 2 states take"),
        (("--lag", "3", "--interval", "0"), "--interval must be above 0 and finite, got 0"),
        (("--lag", "3", "--plot", "x.pdf"), "ends in .svg, .png or .csv, got 'x.pdf'"),
        (("--lag", "0.1", "--plot", "x.csv"), "no named filter exists there"),
    ],
)
def test_bad_input_is_named(
    capsys: Capture,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: tuple[str, ...],
    told: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert cli.main(["design", *arguments]) == 2
    assert told in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
