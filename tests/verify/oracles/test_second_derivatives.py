"""Second derivatives of the enclosed steady state against differences of its first ones."""

from __future__ import annotations

from fractions import Fraction

import flint
import pytest
from kernel_truth import STEADY_STATES

from gainproof.verify.oracles import differences, quantities
from gainproof.verify.oracles.ball import enclose
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.second_derivatives import second_slopes
from gainproof.verify.oracles.spectrum import Spectrum, spectrum
from gainproof.verify.oracles.state_space import state_space

INDICES = (Fraction(1, 3000), Fraction(2, 3), Fraction(900))


def middle(ball: flint.arb) -> Fraction:
    mantissa, exponent = ball.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def by_differences(chosen: Spectrum, index: Fraction) -> dict[str, tuple[Fraction, Fraction]]:
    """Each second derivative with its estimated error."""

    def slopes(at: Fraction) -> list[Fraction]:
        return [middle(ball) for ball in quantities.slopes(enclose(chosen, at, 70)).values()]

    names = quantities.slopes(enclose(chosen, index))
    found = differences.derivatives(slopes, index, levels=5, digits=60)
    return {
        name: (fraction(slope.value), fraction(slope.error))
        for name, slope in zip(names, found, strict=True)
    }


@pytest.mark.parametrize("family", sorted(STEADY_STATES))
@pytest.mark.parametrize("index", INDICES, ids=str)
def test_they_are_the_slopes_of_the_slopes(family: str, index: Fraction) -> None:
    chosen = spectrum(state_space(STEADY_STATES[family]))
    expected, found = by_differences(chosen, index), second_slopes(chosen, index)
    assert set(found) == {*expected, "predicted_11_by_terms"}
    for name, (value, error) in expected.items():
        ball, scale = found[name]
        assert error < abs(value) / 10**15, name
        assert abs(middle(ball) - value) <= error + abs(value) / 10**35, name
        assert scale.contains(ball)
        assert ball.rel_accuracy_bits() > 130


@pytest.mark.parametrize("family", sorted(STEADY_STATES))
def test_the_terms_of_the_one_that_vanishes_are_added(family: str) -> None:
    """2 M11'^2/(1 + M11) - M11'' is -alpha''/(1 - alpha)^2, by another way."""
    chosen = spectrum(state_space(STEADY_STATES[family]))
    found, state = second_slopes(chosen, Fraction(1, 2)), enclose(chosen, Fraction(1, 2)).state
    value, scale = found["predicted_11_by_terms"]
    assert value.overlaps(found["predicted_11"][0])
    with flint.ctx.workprec(200):
        falls = -found["alpha"][0] * state.innovation[0][0] ** 2
    assert abs(middle(scale) - middle(falls)) < middle(falls) / 10**30
