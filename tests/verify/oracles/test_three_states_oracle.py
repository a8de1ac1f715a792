"""The oracles on three states, position measured: four noises, any index, nearly equal poles."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import flint
import pytest
from float_rounding import allowance
from hypothesis import given, settings
from hypothesis import strategies as st
from one_of_each import cases
from samples import samples

from gainproof.verify.oracles import ball, distance, doubling, noise, recursion, solver
from gainproof.verify.oracles.closed_loop import roots_of
from gainproof.verify.oracles.matrices import Matrix, matrix, product, transpose
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.spectrum import spectrum
from gainproof.verify.oracles.state_space import StateSpace, SteadyState, exact
from gainproof.verify.oracles.true_values import steady_state_truth

STEP = matrix([["1", "1", "1/2"], ["0", "1", "1"], ["0", "0", "1"]], exact)
INDICES = (Fraction(1, 30), Fraction(3, 10), Fraction(7), Fraction(10**5))


def outer(*entries: object) -> Matrix:
    """A column times itself."""
    column = matrix([[entry] for entry in entries], exact)
    return product(column, transpose(column))


NOISES: Mapping[str, Matrix] = {
    "acceleration increments": outer(0, 0, 1),
    "acceleration noise": outer("1/2", 1, 1),
    "jerk held": outer("1/6", "1/2", 1),
    "white jerk": matrix(
        [["1/20", "1/8", "1/6"], ["1/8", "1/3", "1/2"], ["1/6", "1/2", "1"]], exact
    ),
}


def model(which: str) -> StateSpace:
    """The scaled model with one of the noises."""
    position = matrix([[1, 0, 0]], exact)
    return StateSpace(STEP, NOISES[which], position, matrix([[1]], exact))


def relative(state: SteadyState, truth: SteadyState) -> float:
    """The largest relative error of any entry."""
    exactly = [x if isinstance(x, float) else fraction(x) for x in state.entries().values()]
    balls = truth.entries().values()
    return max(distance.relative_error(x, y) for x, y in zip(exactly, balls, strict=True))


def test_noises_integrated_from_the_motion() -> None:
    """A jump of the acceleration at the end of the interval, the same at its start, a jerk that is
    constant over it, white jerk all along it.
    """
    motion, entry = noise.chain(3)
    jump = noise.increment(entry)
    integrated = {
        "acceleration increments": jump,
        "acceleration noise": product(product(STEP, jump), transpose(STEP)),
        "jerk held": noise.held(motion, entry),
        "white jerk": noise.white(motion, entry),
    }
    for which, found in integrated.items():
        for row, wanted in zip(found, NOISES[which], strict=True):
            for x, y in zip(row, wanted, strict=True):
                exactly = x if isinstance(x, Fraction | int) else fraction(x)
                assert abs(exactly - y) < Fraction(1, 10**38), which


@pytest.mark.parametrize("which", cases(NOISES, lambda which: which in list(NOISES)[1:4:2]))
@pytest.mark.parametrize(
    "index",
    cases(
        [Fraction(1, 30), Fraction(3, 10), Fraction(7), Fraction(10**5)],
        lambda index: index in {Fraction(1, 30), Fraction(10**5)},
    ),
)
def test_oracles_agree(which: str, index: Fraction) -> None:
    own = model(which)
    truth = ball.enclose(spectrum(own), index)
    driven = StateSpace(
        own.transition,
        tuple(tuple(x * index**2 for x in row) for row in own.process_noise),
        own.measurement,
        own.measurement_noise,
    )
    assert relative(doubling.steady_state(driven, digits=200).state, truth.state) < 1e-39
    if index > 100:
        return  # a pole next to -1: too many samples for a test
    assert relative(recursion.run_multiprecision(driven, 30).state, truth.state) < 1e-28
    allowed = allowance(driven, truth)
    for run in (solver.steady_state(driven).state, recursion.run_float(driven).state):
        pairs = zip(run.entries().items(), truth.state.entries().values(), strict=True)
        for (name, x), y in pairs:
            assert abs(x - float(y.mid())) <= allowed[name.split("[")[0]], name


@pytest.mark.parametrize("which", NOISES)
def test_both_ends_of_the_index(which: str) -> None:
    """Next to 0 the filter is Butterworth's of third order; next to infinity it has limits."""
    truth = steady_state_truth(
        {
            "transition": STEP,
            "process_noise": NOISES[which],
            "measurement": [["1", "0", "0"]],
            "measurement_noise": [["1"]],
        }
    )
    low = truth.at("tracking_index", Fraction(1, 10**300))
    for name, wanted in (("alpha", 2e-100), ("beta", 2e-200), ("gamma", 1e-300)):
        assert abs(float(low[name].value.mid()) / wanted - 1) < 1e-12
    high, higher = (truth.at("tracking_index", Fraction(10**k)) for k in (290, 300))
    for name in ("alpha", "beta", "gamma"):
        assert abs(float((high[name].value / higher[name].value).mid()) - 1) < 1e-15
    assert abs(float(higher["alpha"].value.mid()) - 1) < 1e-15


@settings(max_examples=samples(80), deadline=None)
@given(st.lists(st.integers(-9, 9), min_size=3, max_size=3), st.sampled_from([-5, -1, 1, 2]))
def test_roots_of_cubics(low: list[int], leading: int) -> None:
    """Cardano's in balls and those that python-flint isolates."""
    cubic = flint.fmpz_poly([*low, leading])
    with flint.ctx.workprec(200):
        found = roots_of(cubic)
        isolated: list[tuple[flint.acb, int]] = cubic.complex_roots()  # type: ignore[assignment]  # as in the oracle
        assert sum(count for _, count in found) == 3
        for root, count in isolated:
            (own,) = [(r, c) for r, c in found if r.overlaps(root)]
            assert own[1] == count
            assert (own[0].imag == 0) == (root.imag == 0)
            assert float(own[0].rad()) < 1e-40


def test_roots_nearly_equal() -> None:
    """(v - 6)^2 (v - 1) - 10^-200: two real roots either side of 6, each to many digits."""
    small = flint.fmpz(10) ** 200
    cubic = flint.fmpz_poly([-36, 48, -13, 1]) * small - 1
    with flint.ctx.workprec(2000):
        found = sorted(roots_of(cubic), key=lambda pair: float(pair[0].real.mid()))
        gap = [root.real - 6 for root, _ in found[1:]]
        expected = 1 / flint.arb(5 * small).sqrt()
        assert gap[0] * gap[1] < 0
        for each in gap:
            assert abs(abs(each) / expected - 1) < flint.arb("1e-90")
