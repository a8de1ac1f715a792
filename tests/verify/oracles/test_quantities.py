"""Names belong to the right entries."""

from __future__ import annotations

from fractions import Fraction

import flint

from gainproof.verify.oracles import ball, quantities
from gainproof.verify.oracles.matrices import matrix
from gainproof.verify.oracles.spectrum import spectrum
from gainproof.verify.oracles.state_space import StateSpace

THREE = StateSpace(
    matrix([[1, 1, Fraction(1, 2)], [0, 1, 1], [0, 0, 1]], Fraction),
    matrix([[0, 0, 0], [0, 0, 0], [0, 0, 1]], Fraction),
    matrix([[1, 0, 0]], Fraction),
    matrix([[1]], Fraction),
)


def test_every_entry_has_its_name() -> None:
    found = ball.enclose(spectrum(THREE), 1)
    named = quantities.values(found)
    assert len(named) == 3 + 3 + 6 + 6
    with flint.ctx.workprec(300):
        assert named["predicted_23"].overlaps(found.state.predicted[2][1])
        assert named["updated_12"].overlaps(found.state.updated[1][0])
        # measured position of unit variance: the gain is the first column of the updated covariance
        assert named["alpha"].overlaps(named["updated_11"])
        assert named["gamma"].overlaps(named["updated_13"])
        carried = named["alpha"] + named["beta"] + named["gamma"] / 2
        assert named["position"].overlaps(carried)
        assert named["acceleration"].overlaps(named["gamma"])
        assert not named["velocity"].overlaps(named["beta"])
    assert set(quantities.slopes(found)) == set(named)


def test_poles_come_upper_one_first_or_larger_modulus_first() -> None:
    noise = matrix([[Fraction(1, 4), Fraction(1, 2)], [Fraction(1, 2), 1]])
    model = StateSpace(
        matrix([[1, 1], [0, 1]], Fraction), noise, matrix([[1, 0]], Fraction), ((Fraction(1),),)
    )
    first, second = quantities.poles(ball.enclose(spectrum(model), 1))
    assert first.imaginary > 0 > second.imaginary
    assert first.real.overlaps(second.real)
    first, second = quantities.poles(ball.enclose(spectrum(model), 100))
    assert first.imaginary == 0 == second.imaginary
    assert first.modulus > second.modulus
