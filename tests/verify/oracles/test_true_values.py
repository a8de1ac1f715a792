"""Truth by name: the right number under every name, whatever the argument."""

from __future__ import annotations

from fractions import Fraction

import flint
import pytest

from gainproof.verify.oracles import distance, least_squares, true_values

MODEL = true_values.steady_state_truth(
    {
        "transition": [["1", "1"], ["0", "1"]],
        "process_noise": [["1/4", "1/2"], ["1/2", "1"]],
        "measurement": [["1", "0"]],
        "measurement_noise": [["1"]],
    }
)


def test_by_index_and_by_gain_the_same() -> None:
    by_index = MODEL.at("tracking_index", 1.0)
    assert by_index["alpha"].value.contains(flint.arb(0.75))
    for argument, value in (("alpha", 0.75), ("beta", 0.5)):
        for near in (None, 1.0, 3.0):
            by_gain = MODEL.at(argument, value, near)
            assert by_gain["tracking_index"].value.contains(1)
            for name, found in by_gain.items():
                if name != "tracking_index":
                    assert found.value.overlaps(by_index[name].value), name


def test_poles_are_measured_by_their_modulus() -> None:
    named = MODEL.at("tracking_index", 1.0)
    with flint.ctx.workprec(300):
        size = named["first_real"].value ** 2 + named["first_imaginary"].value ** 2
        assert size.sqrt().overlaps(named["first_real"].scale)
    assert distance.relative_error(0.5, named["first_real"].scale) < 1e-30  # sqrt(1 - alpha)


def test_derivatives_have_their_own_names() -> None:
    named = MODEL.at("tracking_index", 1.0)
    above = MODEL.at("tracking_index", 1 + Fraction(1, 10**12))
    with flint.ctx.workprec(300):
        slope = (above["beta"].value - named["beta"].value) * 10**12
        assert abs(slope / named["d_beta"].value - 1) < 1e-11


def test_fits_by_sample_number() -> None:
    line = true_values.FitTruth(1)
    assert set(line.at("sample_number", 1)) == {
        "alpha", "beta", "updated_11", "updated_12", "updated_22"
    }  # fmt: skip
    named = line.at("sample_number", 7.0)
    assert distance.middle(named["beta"].value) - least_squares.gains(1, 7)[1] < Fraction(1, 2**300)
    # the prediction's variance and the newest sample's make that of the updated fit
    with flint.ctx.workprec(300):
        m, x = named["predicted_11"].value, named["updated_11"].value
        assert (m / (m + 1)).overlaps(x)
        assert named["alpha"].value.overlaps(x)


def test_wrong_arguments_are_refused() -> None:
    with pytest.raises(ValueError, match="whole sample_number"):
        true_values.FitTruth(1).at("sample_number", 2.5)
    with pytest.raises(ValueError, match="whole sample_number"):
        true_values.FitTruth(1).at("tracking_index", 2)
    with pytest.raises(KeyError):
        MODEL.at("delta", 0.5)
