"""The oracles for the steady state agree with one another on models of every kind.

They share the matrices and nothing else: doubling, spectral factorisation in balls, the running
filter and SciPy's pencil. The models are random and mostly not kinematic.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction

import pytest
from float_rounding import allowance
from hypothesis import HealthCheck, assume, given, settings
from hypothesis import strategies as st
from one_of_each import further
from samples import samples

from gainproof.verify.oracles import ball, distance, doubling, recursion, solver
from gainproof.verify.oracles.matrices import Matrix, identity, matrix, product, scale, transpose
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.spectrum import Spectrum, spectrum
from gainproof.verify.oracles.state_space import NotConverged, StateSpace, SteadyState

QUARTERS = st.integers(-6, 6).map(lambda k: Fraction(k, 4))


@st.composite
def models(draw: st.DrawFn, sizes: tuple[int, ...] = (1, 2, 3)) -> StateSpace:
    """A model with definite process noise, so that a stabilising solution exists if observable."""
    n = draw(st.sampled_from(sizes))
    rows = st.lists(st.lists(QUARTERS, min_size=n, max_size=n), min_size=n, max_size=n)
    transition = matrix(draw(rows))
    root = matrix(draw(rows))
    noise = product(root, transpose(root))
    noise = tuple(
        tuple(x + Fraction(i == j, 8) for j, x in enumerate(row)) for i, row in enumerate(noise)
    )
    measured = draw(st.lists(QUARTERS, min_size=n, max_size=n).filter(any))
    sensor = draw(st.integers(1, 12).map(lambda k: Fraction(k, 4)))
    return StateSpace(transition, noise, (tuple(measured),), ((sensor,),))


def enclosed(model: StateSpace) -> ball.Enclosure:
    try:
        return ball.enclose(observable(model), 1)
    except NotConverged:
        assume(False)  # an entry is exactly zero: no relative enclosure exists
        raise


def observable(model: StateSpace) -> Spectrum:
    try:
        return spectrum(model)
    except ValueError:
        assume(False)
        raise


def relative(state: SteadyState, truth: SteadyState) -> float:
    """The largest relative error of any entry."""
    exactly = [x if isinstance(x, float) else fraction(x) for x in state.entries().values()]
    balls = truth.entries().values()
    return max(distance.relative_error(x, y) for x, y in zip(exactly, balls, strict=True))


PLENTY = settings(
    max_examples=samples(10), deadline=None, suppress_health_check=[HealthCheck.filter_too_much]
)


@PLENTY
@given(models())
def test_doubling_agrees_with_the_balls_to_forty_digits(model: StateSpace) -> None:
    truth = enclosed(model)
    assert relative(doubling.steady_state(model).state, truth.state) < 1e-39


@PLENTY
@given(models())
def test_recursion_in_float_and_multiprecision_agrees_with_the_balls(model: StateSpace) -> None:
    truth = enclosed(model)
    assume(forgetting(truth) < 10)  # a slower filter takes the recursion too long for a test
    in_float = recursion.run_float(model).state
    in_digits = recursion.run_multiprecision(model, 30).state
    assert relative(in_digits, truth.state) < 1e-28
    assert close(in_float, model, truth)


@PLENTY
@given(models())
def test_polished_solver_agrees_with_the_balls(model: StateSpace) -> None:
    truth = enclosed(model)
    solved = solver.steady_state(model)
    assert close(solved.state, model, truth)


def forgetting(truth: ball.Enclosure) -> float:
    """1 / (1 - |pole|^2) for the slowest pole: how many samples of the past are still felt."""
    slowest = max(float(pole.abs_upper()) for pole in truth.poles)
    return 1 / (1 - slowest * slowest)


def close(state: SteadyState, model: StateSpace, truth: ball.Enclosure) -> bool:
    """Within the rounding errors of a float64 run."""
    allowed = allowance(model, truth)
    pairs = zip(state.entries().items(), truth.state.entries().values(), strict=True)
    return all(abs(x - float(y.mid())) <= allowed[name.split("[")[0]] for (name, x), y in pairs)


@pytest.mark.parametrize("size", [2, 3])
def test_a_transposed_transition_is_detected(size: int) -> None:
    model = kinematic(size)
    # noise on every state and a measurement of all of them, so that both have a steady state
    everything = (identity(size, Fraction(1)), ((Fraction(1),) * size,), ((Fraction(1),),))
    right = StateSpace(model.transition, *everything)
    wrong = StateSpace(transpose(model.transition), *everything)
    truth = ball.enclose(spectrum(right), 1)
    assert relative(doubling.steady_state(right).state, truth.state) < 1e-39
    assert relative(doubling.steady_state(wrong).state, truth.state) > 1e-3


BREAKS: dict[str, Callable[[StateSpace], tuple[Matrix, Matrix, Matrix, Matrix]]] = {
    "transition entry": lambda m: (
        matrix([[x + Fraction(i == 0 and j == 1, 10**6) for j, x in enumerate(r)]
                for i, r in enumerate(m.transition)]),
        m.process_noise, m.measurement, m.measurement_noise,
    ),
    "process noise factor": lambda m: (
        m.transition, scale(1 + Fraction(1, 10**6), m.process_noise), m.measurement,
        m.measurement_noise,
    ),
    "measurement noise": lambda m: (
        m.transition, m.process_noise, m.measurement,
        scale(1 + Fraction(1, 10**6), m.measurement_noise),
    ),
    "measurement row": lambda m: (
        m.transition, m.process_noise, scale(1 + Fraction(1, 10**6), m.measurement),
        m.measurement_noise,
    ),
}  # fmt: skip


@pytest.mark.parametrize("size", [further(2), 3])
@pytest.mark.parametrize("name", list(BREAKS))
def test_a_model_broken_in_the_sixth_digit_is_detected_by_every_oracle(
    name: str, size: int
) -> None:
    model = kinematic(size)
    broken = StateSpace(*BREAKS[name](model))
    truth = ball.enclose(spectrum(model), 1).state
    runs: tuple[Callable[[StateSpace], SteadyState], ...] = (
        lambda m: doubling.steady_state(m).state,
        lambda m: recursion.run_float(m).state,
        lambda m: recursion.run_multiprecision(m, 25).state,
        lambda m: solver.steady_state(m).state,
    )
    for run in runs:
        assert relative(run(model), truth) < 1e-12
        assert relative(run(broken), truth) > 1e-8
    assert (
        not ball.enclose(spectrum(broken), 1).state.predicted[0][0].overlaps(truth.predicted[0][0])
    )


def kinematic(size: int) -> StateSpace:
    """Constant-velocity or constant-acceleration motion with increments of its last state."""
    chain = {
        2: [["1", "1"], ["0", "1"]],
        3: [["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]],
    }[size]
    noise = [[int(i == j == size - 1) for j in range(size)] for i in range(size)]
    return StateSpace(
        matrix(chain, Fraction),
        matrix(noise, Fraction),
        ((Fraction(1), *[Fraction(0)] * (size - 1)),),
        ((Fraction(1),),),
    )
