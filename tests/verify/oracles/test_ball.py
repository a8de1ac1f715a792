"""The balls: they satisfy the Riccati equation, hold known values, and refuse what has none."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import flint
import pytest
from one_of_each import further

from gainproof.verify.oracles import ball, differences, distance, doubling
from gainproof.verify.oracles.matrices import matrix
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.riccati import in_numbers, residual, update
from gainproof.verify.oracles.spectrum import characteristic_and_adjugate, spectrum
from gainproof.verify.oracles.state_space import NotConverged, StateSpace, state_space

F2 = [["1", "1"], ["0", "1"]]
NOISES = {
    "velocity increments": [["0", "0"], ["0", "1"]],
    "constant over the interval": [["1/4", "1/2"], ["1/2", "1"]],
    "continuous white": [["1/3", "1/2"], ["1/2", "1"]],
}
EXTREMES = [5e-324, 1e-300, 1e-160, 1e-20, 0.3, 4.0, 7.9, 1e15, 1e154, 1e300, 1.7e308]


def two_states(noise: str) -> dict[str, Any]:
    return {
        "transition": F2,
        "process_noise": NOISES[noise],
        "measurement": [["1", "0"]],
        "measurement_noise": [["1"]],
    }


def in_balls(model: StateSpace) -> StateSpace:
    return in_numbers(model, lambda x: flint.arb(flint.fmpq(x.numerator, x.denominator)))


@pytest.mark.parametrize("index", EXTREMES)
@pytest.mark.parametrize("noise", list(NOISES))
def test_the_riccati_equation_holds_in_balls_over_all_floats(noise: str, index: float) -> None:
    found = ball.enclose(spectrum(state_space(two_states(noise))), index)
    model = state_space(two_states(noise), index)
    with flint.ctx.workprec(2 * found.bits):
        left = residual(in_balls(model), found.state.predicted)
        assert all(x.contains(0) for row in left for x in row)
        # and the check has teeth: a predicted covariance off by 1e-30 is not a solution
        off = flint.arb(1) + flint.arb(10) ** -30
        moved = tuple(tuple(x * off for x in row) for row in found.state.predicted)
        assert not all(x.contains(0) for row in residual(in_balls(model), moved) for x in row)
        again = update(in_balls(model), found.state.predicted)
        for name, entry in again.entries().items():
            assert entry.overlaps(found.state.entries()[name]), name


@pytest.mark.parametrize("index", EXTREMES)
@pytest.mark.parametrize("noise", list(NOISES))
def test_every_ball_has_the_radius_asked_for(noise: str, index: float) -> None:
    found = ball.enclose(spectrum(state_space(two_states(noise))), index, digits=40)
    balls = [*found.state.entries().values(), *found.slope.entries().values()]
    balls += [row[0] for row in (*found.predictor_gain, *found.predictor_slope)]
    for entry in balls:
        assert float(entry.rad() / abs(entry.mid())) <= 1e-40


@pytest.mark.alike
@pytest.mark.parametrize("index", [1e-100, 1e-3, further(1.0), 4.0, further(30.0), 1e40])
@pytest.mark.parametrize("noise", list(NOISES))
def test_balls_and_doubling_agree(noise: str, index: float) -> None:
    found = ball.enclose(spectrum(state_space(two_states(noise))), index)
    run = doubling.steady_state(state_space(two_states(noise), index))
    for name, entry in run.state.entries().items():
        assert distance.relative_error(fraction(entry), found.state.entries()[name]) < 1e-39


@pytest.mark.parametrize(
    ("noise", "index"),
    [("velocity increments", 5e-324), further("continuous white", 1.7e308)],
)
def test_doubling_reaches_the_smallest_and_the_largest_floats(noise: str, index: float) -> None:
    found = ball.enclose(spectrum(state_space(two_states(noise))), index)
    run = doubling.steady_state(state_space(two_states(noise), index))
    for name, entry in run.state.entries().items():
        assert distance.relative_error(fraction(entry), found.state.entries()[name]) < 1e-39


@pytest.mark.parametrize("index", ["1/1000", "3", "40"])
def test_slopes_agree_with_differences_of_the_doubling(index: str) -> None:
    data = two_states("constant over the interval")
    found = ball.enclose(spectrum(state_space(data)), index)

    def values(at: Fraction) -> list[Any]:
        return list(doubling.steady_state(state_space(data, at), 70).state.entries().values())

    slopes = differences.derivatives(values, Fraction(index), step=Fraction(1, 4096), digits=70)
    for slope, (name, enclosed) in zip(slopes, found.slope.entries().items(), strict=True):
        error = distance.relative_error(fraction(slope.value), enclosed)
        assert error < 1e-25, name
        assert error * float(abs(enclosed.mid())) < 10 * float(slope.error) + 1e-40, name


def test_scalar_random_walk_has_the_golden_ratio() -> None:
    one = [["1"]]
    model = {
        "transition": one,
        "process_noise": one,
        "measurement": one,
        "measurement_noise": one,
    }
    state = ball.enclose(spectrum(state_space(model)), 1).state
    with flint.ctx.workprec(200):
        golden = (1 + flint.arb(5).sqrt()) / 2
        assert state.predicted[0][0].overlaps(golden)
        assert state.gain[0][0].overlaps(1 / golden)
        assert state.updated[0][0].overlaps(1 / golden)
        assert state.innovation[0][0].overlaps(golden + 1)


def test_a_double_pole_is_found_twice() -> None:
    # the two poles meet where the spectrum's quadratic in v has a double root: q = 64
    found = ball.enclose(spectrum(state_space(two_states("constant over the interval"))), 8)
    assert len(found.poles) == 2
    assert found.poles[0].overlaps(found.poles[1])
    near = ball.enclose(spectrum(state_space(two_states("constant over the interval"))), 8 + 2**-44)
    assert not near.poles[0].overlaps(near.poles[1])
    assert all(pole.imag == 0 for pole in near.poles)


def test_a_singular_transition_has_its_pole_at_zero() -> None:
    # one combination of the states is forgotten at once; one closed-loop pole is exactly 0
    model = StateSpace(
        matrix([[1, 1], [1, 1]], Fraction),
        matrix([[1, Fraction(1, 2)], [Fraction(1, 2), 2]], Fraction),
        matrix([[1, 0]], Fraction),
        matrix([[1]], Fraction),
    )
    found = ball.enclose(spectrum(model), 1)
    assert any(pole == 0 for pole in found.poles)
    run = doubling.steady_state(model)
    for name, entry in run.state.entries().items():
        assert distance.relative_error(fraction(entry), found.state.entries()[name]) < 1e-39


def test_adjugate_times_matrix_is_the_determinant() -> None:
    f = matrix([[1, 2, 3], [0, 1, 4], [5, 6, 0]], Fraction)
    polynomial, adjugate = characteristic_and_adjugate(f)
    assert polynomial == [-1, -38, -2, 1][:1] + polynomial[1:]  # det(-F) = -det F = -1
    for power in range(4):
        for i in range(3):
            for j in range(3):
                shifted = adjugate[power - 1][i][j] if power else 0
                carried = sum(f[i][k] * adjugate[power][k][j] for k in range(3)) if power < 3 else 0
                assert shifted - carried == (polynomial[power] if i == j else 0)


@pytest.mark.parametrize("index", [0, -1.0, float("nan"), float("inf")])
def test_an_index_outside_the_domain_is_refused(index: float) -> None:
    prepared = spectrum(state_space(two_states("continuous white")))
    with pytest.raises(ValueError, match=r"positive|finite"):
        ball.enclose(prepared, index)
    with pytest.raises(ValueError, match=r"positive|finite"):
        state_space(two_states("continuous white"), index)


def test_models_without_an_answer_are_refused() -> None:
    data = two_states("continuous white")
    with pytest.raises(ValueError, match="not observable"):
        spectrum(state_space({**data, "measurement": [["0", "1"]]}))
    with pytest.raises(ValueError, match="one measured"):
        spectrum(
            state_space({**data, "measurement": F2, "measurement_noise": [["1", "0"], ["0", "1"]]})
        )
    still = state_space({**data, "process_noise": [["0", "0"], ["0", "0"]]})
    with pytest.raises(NotConverged):  # the poles stay on the unit circle
        ball.enclose(spectrum(still), 1)
    with pytest.raises(ValueError, match="process noise"):
        doubling.steady_state(still)
    with pytest.raises(ValueError, match="symmetric"):
        state_space({**data, "process_noise": [["1", "0"], ["1", "1"]]})
    with pytest.raises(ValueError, match="must be 2x2"):
        state_space({**data, "process_noise": [["1"]]})


def test_an_unstable_state_without_noise_stops_the_doubling() -> None:
    # the second state lies on the unit circle, no noise drives it: nothing stabilises it
    model = StateSpace(
        matrix([[Fraction(1, 2), 0], [0, 1]], Fraction),
        matrix([[1, 0], [0, 0]], Fraction),
        matrix([[1, 1]], Fraction),
        matrix([[1]], Fraction),
    )
    with pytest.raises(NotConverged):
        doubling.steady_state(model)
