"""Models with a vector measurement: what scaling leaves, and what it refuses."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp

from gainproof.derive.model import Model, ModelError, Ratio, scale
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity, Unit

POSITION = Quantity("position_deviation", r"\sigma_o", "of a measured position", METRE)
VELOCITY = Quantity("velocity_deviation", r"\sigma_d", "of a measured velocity", METRE / SECOND)
SHAKE = Quantity("acceleration_deviation", r"\sigma_a", "of the acceleration", METRE / SECOND**2)
RATIO = Quantity("velocity_ratio", "S", "sigma_d T/sigma_o", Unit())

STEP = SAMPLING_INTERVAL.symbol
FIRST, SECOND_, STRENGTH = POSITION.symbol, VELOCITY.symbol, SHAKE.symbol


def model(**changes: Any) -> Model:
    """Position and velocity measured, acceleration constant over each interval."""
    fields: dict[str, Any] = {
        "name": "trial",
        "title": "Trial",
        "transition": sp.ImmutableDenseMatrix([[1, STEP], [0, 1]]),
        "process_noise": STRENGTH**2
        * sp.ImmutableDenseMatrix([[STEP**4 / 4, STEP**3 / 2], [STEP**3 / 2, STEP**2]]),
        "measurement": sp.ImmutableDenseMatrix([[1, 0], [0, 1]]),
        "measurement_noise": sp.ImmutableDenseMatrix([[FIRST**2, 0], [0, SECOND_**2]]),
        "quantities": (SAMPLING_INTERVAL, POSITION, VELOCITY, SHAKE),
        "state_units": (METRE, METRE / SECOND),
        "measurement_units": (METRE, METRE / SECOND),
        "deviation": POSITION,
        "ratios": (Ratio(RATIO, VELOCITY),),
    }
    return Model(**{**fields, **changes})


def test_two_parameters_are_left() -> None:
    scaled = scale(model())
    assert sp.simplify(scaled.noise_ratio - (STRENGTH * STEP**2 / FIRST) ** 2) == 0
    assert scaled.ratios == {"velocity_ratio": SECOND_ * STEP / FIRST}
    assert scaled.measurement_scale == (FIRST, FIRST / STEP)
    data = scaled.data()
    assert data["process_noise"] == [["1/4", "1/2"], ["1/2", "1"]]
    assert data["measurement"] == [["1", "0"], ["0", "1"]]
    assert data["measurement_noise"][0] == ["1", "0"]
    assert data["measurement_noise"][1][1] == {
        "nodes": [["symbol", "velocity_ratio"], ["pow", 0, "2"]],
        "outputs": {"value": 1},
    }


def test_one_measurement_is_scaled_as_ever() -> None:
    first = {
        "measurement": sp.ImmutableDenseMatrix([[1, 0]]),
        "measurement_noise": sp.ImmutableDenseMatrix([[FIRST**2]]),
        "measurement_units": (METRE,),
        "ratios": (),
    }
    scaled = scale(model(**first))
    assert scaled.data()["measurement_noise"] == [["1"]]
    assert scaled.ratios == {}


def test_correlated_measurements() -> None:
    cross = FIRST * SECOND_ / 2
    noise = sp.ImmutableDenseMatrix([[FIRST**2, cross], [cross, SECOND_**2]])
    scaled = scale(model(measurement_noise=noise)).measurement_noise
    ratio = RATIO.symbol
    assert scaled == sp.ImmutableDenseMatrix([[1, ratio / 2], [ratio / 2, ratio**2]])


def _noise(*rows: list[Any]) -> dict[str, Any]:
    return {"measurement_noise": sp.ImmutableDenseMatrix(rows)}


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"ratios": ()}, "name a ratio for each further deviation"),
        ({"measurement_units": (METRE, METRE)}, "the measurement should hold numbers"),
        ({"measurement_units": (METRE,)}, "a unit for each of 2 entries of the measurement"),
        ({"state_units": (METRE,)}, "a unit for each of 2 entries of the state"),
        ({"deviation": VELOCITY}, "should be a length, velocity_deviation has the unit m s\\^-1"),
        (_noise([FIRST**2, 0], [0, -(SECOND_**2)]), "covariances are wanted"),
        (_noise([FIRST**2, 0], [0, 0]), "do not occur"),
        (
            _noise([FIRST**2, FIRST * SECOND_], [FIRST * SECOND_, SECOND_**2]),
            "covariances are wanted",
        ),
        (_noise([FIRST**2, SECOND_ * FIRST / 2], [0, SECOND_**2]), "should be symmetric"),
        (_noise([FIRST**2, 0], [0, (FIRST / STEP) ** 2]), "do not occur"),
        (_noise([FIRST**2, 0], [0, SECOND_**2 * STEP]), "it holds"),
    ],
)
def test_what_does_not_fit_is_refused(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ModelError, match=message):
        scale(model(**changes))
