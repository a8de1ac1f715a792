"""`gainproof design` next to the border of stability and beyond the reach of a kernel.

Truths are characteristic polynomials and variances in balls of 400 bits, of gains that the lag's
own relation gives there: nothing of what the front computes with.
"""

from __future__ import annotations

import json
import re
from fractions import Fraction
from typing import Any

import flint
import pytest

from gainproof import cli
from gainproof.design import decay
from gainproof.verify.oracles.fixed_gain import ball, predicted

Capture = pytest.CaptureFixture[str]
pytestmark = pytest.mark.filterwarnings("error")


def data(capsys: Capture, *arguments: str) -> dict[str, Any]:
    assert cli.main(["design", *arguments, "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    filters = {each["name"]: each for each in reversed(found["filters"])}
    return {**filters, "belongs": {each["name"]: each for each in found.get("belongs", ())}}


def rest(gains: list[flint.arb]) -> flint.arb:
    """1 - |z| of the largest root of det(z I - F (I - K H)), in balls."""
    size = len(gains)
    half = Fraction(1, 2)
    moving: list[list[int | Fraction]] = [[1, 1, half], [0, 1, 1], [0, 0, 1]]
    transition = flint.arb_mat([[ball(Fraction(x)) for x in row[:size]] for row in moving[:size]])
    left = flint.arb_mat(size, size)
    for i in range(size):
        left[i, i] = 1
    for i in range(size):
        left[i, 0] -= gains[i]
    roots = flint.acb_mat(transition * left).eig(algorithm="rump", multiple=True)
    largest: flint.arb = max((abs(root) for root in roots), key=lambda size: float(size.mid()))
    return 1 - largest


@pytest.mark.parametrize(
    "gains",
    [
        (1e-16, 1.0),
        (0.5, 1e-31),
        (1.99, 0.01),
        (1.0, 1.9999999),
        (1e-15, 1e-30),
        (0.5, 0.01, 1e-8),
        (1.2, 1e-6, 1e-9),
    ],
)
def test_what_is_left_to_1_is_that_of_the_gains(gains: tuple[float, ...]) -> None:
    with flint.ctx.workprec(400):
        wanted = float(rest([ball(Fraction(gain)) for gain in gains]).mid())
    assert decay.distance(gains) == pytest.approx(wanted, rel=1e-11)
    count = decay.samples(wanted)
    assert count * wanted >= 4.6 * (1 - wanted)


@pytest.mark.parametrize("gains", [(0.5, 2.9999999999999996), (2 - 2e-16, 1e-16)])
def test_what_rounding_hides_is_not_told(capsys: Capture, gains: tuple[float, ...]) -> None:
    """Gains moved by 2^-51 of themselves are at another distance, or not stable."""
    assert decay.distance(gains) is None
    found = data(capsys, "--gains", *map(repr, gains))["given"]
    assert found["largest_modulus"] is None
    assert found["samples_to_one_per_cent"] is None
    assert "cannot be told" in found["not_told"]
    cli.main(["design", "--gains", *map(repr, gains), "--interval", "1"])
    text = capsys.readouterr().out
    assert "not told  not told" in text
    assert re.search("\ngiven +not told\n", text)


def test_lags_of_great_filters_settle_as_their_relations_say(capsys: Capture) -> None:
    """beta = 1e-30 and MV's alpha = sqrt(beta) - beta/2: both poles have modulus^2 1 - alpha."""
    found = data(capsys, "--lag", "1e30")
    assert found["MV"]["samples_to_one_per_cent"] == pytest.approx(2 * 4.605170186e15, rel=1e-9)
    assert found["RA"]["samples_to_one_per_cent"] == pytest.approx(
        2 * 4.605170186e15 / 2**0.5, rel=1e-9
    )


def test_the_variance_next_to_a_border_is_that_of_the_lag(capsys: Capture) -> None:
    """RA of three states at 1/2 + 2e-15, its gains solved in balls of the lecture's relations."""
    lag = Fraction(float("0.500000000000002"))
    with flint.ctx.workprec(400):
        gamma = 1 / ball(lag)
        # alpha = beta^2/(2 gamma); then alpha (alpha + beta + gamma/2) = 2 beta by bisection
        low, high = ball(Fraction(3, 2)), ball(Fraction(2))
        alpha = beta = low
        for _ in range(300):
            beta = (low + high) / 2
            alpha = beta**2 / (2 * gamma)
            above = float((alpha * (alpha + beta + gamma / 2) - 2 * beta).mid()) > 0
            low, high = (low, flint.arb(beta.mid())) if above else (flint.arb(beta.mid()), high)
        truth = float(predicted([alpha, beta, gamma])[0, 0].mid())
    found = data(capsys, "--states", "3", "--lag", "0.500000000000002")["RA"]
    assert found["predicted_variance"] == pytest.approx(truth, rel=1e-13)
    assert found["smoothed_variance"] == pytest.approx(1, rel=1e-9)


def test_named_filters_give_the_variance_of_their_gains_elsewhere(capsys: Capture) -> None:
    """The kernels by lag and (1 - alpha)^2 P + alpha^2 against the Lyapunov solution in balls."""
    for states, lag in (("2", "0.7"), ("2", "30"), ("3", "0.8"), ("3", "100")):
        for name, each in data(capsys, "--states", states, "--lag", lag).items():
            if name == "belongs":
                continue
            with flint.ctx.workprec(400):
                exact = [ball(Fraction(gain)) for gain in each["gains"].values()]
                before = predicted(exact)[0, 0]
                after = (1 - exact[0]) ** 2 * before + exact[0] ** 2
                assert each["predicted_variance"] == pytest.approx(float(before.mid()), rel=1e-12)
                assert each["smoothed_variance"] == pytest.approx(float(after.mid()), rel=1e-12)


def test_the_variance_next_to_a_border_is_that_of_the_alpha(capsys: Capture) -> None:
    """NP-S: 2 sqrt(beta) (1 - alpha) = 2 alpha - beta, in balls; MV's fast one too."""
    alpha = Fraction(1 - 2.0**-50)
    with flint.ctx.workprec(400):
        left = 1 - ball(alpha)
        root = (left**2 + 2 * ball(alpha)).sqrt() - left
        truth = float(predicted([ball(alpha), root**2])[0, 0].mid())
    found = data(capsys, "--alpha", repr(float(alpha)))["NP-S"]
    assert found["predicted_variance"] == pytest.approx(truth, rel=1e-13)
    with flint.ctx.workprec(400):
        small = ball(Fraction(1e-7))
        beta = (1 + (1 - 2 * small).sqrt()) ** 2
        truth = float(predicted([small, beta])[0, 0].mid())
    assert cli.main(["design", "--alpha", "1e-7", "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["filters"]
    (fast,) = (row for row in rows if "fast" in row.get("note", ""))
    assert fast["predicted_variance"] == pytest.approx(truth, rel=1e-13)


@pytest.mark.parametrize("index", ["0.5", "3", "1e9", "1e14", "1.8e15"])
def test_the_variance_next_to_a_border_is_that_of_the_index(capsys: Capture, index: str) -> None:
    """RA: w = sqrt(1 - alpha) by bisection of 2 (1 - w)^2 = index w, of three states of
    2 (1 - w)^3 = index w (1 + w), in balls.
    """
    for states in (2, 3):
        with flint.ctx.workprec(500):
            low, high = flint.arb(0), flint.arb(1)
            for _ in range(400):
                w = flint.arb(((low + high) / 2).mid())
                grows = w if states == 2 else w * (1 + w)
                below = float((2 * (1 - w) ** states - ball(Fraction(float(index))) * grows).mid())
                low, high = (w, high) if below > 0 else (low, w)
            gains = [1 - low**2, 2 * (1 - low) ** 2, 2 * (1 - low) ** 3 / (1 + low)][:states]
            truth = float(predicted(gains)[0, 0].mid())
        found = data(capsys, "--tracking-index", index, "--states", str(states))["RA"]
        assert found["predicted_variance"] == pytest.approx(truth, rel=1e-14)


def test_an_index_beyond_the_kernels_is_named(capsys: Capture) -> None:
    found = data(capsys, "--tracking-index", "1e30", "--states", "3")
    assert "variances are computed up to an index of 8e20" in found["RA"]["absent"]
    assert "gains" in found["RJ"]


def test_a_filter_beyond_its_kernel_takes_no_other_with_it(capsys: Capture) -> None:
    """1/1.6568 = 0.60357 lies between RV's border 0.60355 and its kernel's end."""
    found = data(capsys, "--gains", "1", "1.6568")
    assert "not computed: lags are computed from 0.6036" in found["RV"]["absent"]
    assert "gains" in found["given"]
    assert "gains" in found["RA"]
    assert "lags are computed from" in found["belongs"]["RV"]["not_compared"]
    assert found["belongs"]["RV"]["within_the_digits"] is None
    assert found["belongs"]["RA"]["within_the_digits"] is True
    for gains in (("0.5", "1e-31"), ("1e-20", "5e-14", "3e-34")):
        found = data(capsys, "--gains", *gains)
        assert found["given"]["stable"] is True
        assert all("not_compared" in each for each in found["belongs"].values())
        cli.main(["design", "--gains", *gains])
        text = capsys.readouterr().out
        assert "these are the gains of none of the named filters compared." in text
        assert "RA: not compared: lags are computed from" in text


def test_notes_are_decided_by_the_lag(capsys: Capture) -> None:
    """RA at 1/2 + 1e-11 has 1 - alpha = 1e-22, below 1; RV at lag 1 has alpha = 1."""
    assert "note" not in data(capsys, "--lag", "0.50000000001")["RA"]
    assert "alpha is not below 1" in data(capsys, "--lag", "1")["RV"]["note"]
    assert "note" not in data(capsys, "--lag", "1.0000000000000002")["RV"]


def test_gains_beyond_the_kernels_are_refused_with_the_coordinate(capsys: Capture) -> None:
    """8 (alpha beta - gamma (1 - alpha/2))/gamma^2 of gamma = 6e-11 is 4/3.6e-21."""
    assert cli.main(["design", "--gains", "1", "0.5", "6e-11"]) == 2
    told = capsys.readouterr().err
    assert "whose hurwitz determinant is 1.11111e+21, the kernels take 1e-20 to 1e+20" in told


def answer(capsys: Capture, *arguments: str, status: int = 0) -> str:
    assert cli.main(["design", *arguments]) == status
    return capsys.readouterr().out


def test_numbers_next_to_their_limits_are_told_apart(capsys: Capture) -> None:
    """0.5000001 is not 0.5, where RA does not exist; a modulus below 1 is not printed as 1."""
    text = answer(capsys, "--lag", "0.5000001")
    assert text.startswith("alpha-beta filters at lag 0.5000001\n")
    assert "1 - 4e-07" in text
    most = answer(capsys, "--tracking-index", "1e300")
    assert "RA, random acceleration, not computed, gains as rounded: not a stable filter" in most
    assert "MV of lag 1: has no tracking index: at the lag of RV" in most
    least = " ".join(answer(capsys, "--tracking-index", "1e-300", status=1).split())
    assert "beyond the reach of the kernels: alpha = 1.41421" in least
    assert "has no tracking index, and no filter before it has a lag to be shown at" in least
    assert "not computed: lags are computed from 0.6036 to 1e+30; got 1e+31" in answer(
        capsys, "--lag", "1e31", status=1
    )
