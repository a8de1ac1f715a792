"""The bracket of an index holds it, with a good guess, a bad one or none."""

from __future__ import annotations

from fractions import Fraction

import flint
import pytest

from gainproof.verify.oracles import ball, distance, inverse, quantities
from gainproof.verify.oracles.spectrum import spectrum
from gainproof.verify.oracles.state_space import NotConverged, state_space

MODEL = spectrum(
    state_space(
        {
            "transition": [["1", "1"], ["0", "1"]],
            "process_noise": [["1/4", "1/2"], ["1/2", "1"]],
            "measurement": [["1", "0"]],
            "measurement_noise": [["1"]],
        }
    )
)


def alpha(found: ball.Enclosure) -> tuple[flint.arb, flint.arb]:
    return quantities.values(found)["alpha"], quantities.slopes(found)["alpha"]


@pytest.mark.parametrize("near", [None, Fraction(1), Fraction(3, 2), Fraction(10**6)])
def test_position_gain_three_quarters_belongs_to_index_one(near: Fraction | None) -> None:
    found = inverse.bracket(MODEL, alpha, Fraction(3, 4), near)
    assert found.index.contains(1)
    assert not found.index.contains(1 + 1e-9)
    assert float(found.index.rad()) < 1e-33
    assert found.ball(lambda e: quantities.values(e)["beta"]).contains(flint.arb(1) / 2)


@pytest.mark.parametrize("index", [1e-120, 1e-3, 50.0, 1e30])
def test_there_and_back(index: float) -> None:
    value = distance.middle(alpha(ball.enclose(MODEL, index, digits=60))[0])
    found = inverse.bracket(MODEL, alpha, value)
    assert distance.relative_error(index, found.index) < 1e-20


def test_a_gain_that_no_index_gives_is_refused() -> None:
    with pytest.raises(NotConverged):
        inverse.bracket(MODEL, alpha, Fraction(11, 10))
