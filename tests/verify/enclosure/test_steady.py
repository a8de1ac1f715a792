"""Steady states with proof: known ones by hand, drawn ones against the filter's own recursion, and
refusals by their real reason.
"""

from __future__ import annotations

import random
from fractions import Fraction
from itertools import product

import pytest
from riccati_recursion import Grid, boxed, drawn, limit, model
from samples import samples

from gainproof.verify.check_enclosure import Box
from gainproof.verify.enclosure.steady import steady
from gainproof.verify.enclosure.structure import Model, NoSteadyState
from gainproof.verify.oracles import doubling
from gainproof.verify.oracles.multiprecision import fraction
from gainproof.verify.oracles.state_space import StateSpace

HALF = Fraction(1, 2**54)
Rows = list[list[int | str]]


def assert_encloses(of: Model, true: dict[str, Grid]) -> None:
    """Within the half widths that are asked for, of the deviations that belong to each entry."""
    found = steady(of).enclosures
    n, m = len(of.f.c), len(of.h.c)
    p = true["predicted"]
    moved = (of.f @ Box(p) @ of.f.turned()).c
    seen = (of.h @ Box(p) @ of.h.turned() + of.r).c
    for name, box in found.items():
        columns = m if name in ("filter", "predictor") else n
        for i, j in product(range(n), range(columns)):
            size = moved[i][i] if name == "predictor" else p[i][i]
            other = 1 / seen[j][j] if columns == m and name in ("filter", "predictor") else p[j][j]
            error, e = abs(box.c[i][j] - true[name][i][j]), box.radius[i][j]
            # the true values have 80 digits of the deviations
            assert max(error - e, Fraction(0)) ** 2 <= size * other / 10**120, (name, i, j)
            assert e**2 <= HALF**2 * size * other * (1 + Fraction(1, 10**9)), (name, i, j)


def test_of_two_solutions_the_one_whose_filter_is_stable() -> None:
    """F = 2 without process noise: P = 3 by hand, and not 0, which solves the equation too."""
    found = steady(model([[2]], [[1]], [[0]], [[1]])).enclosures
    assert abs(found["predicted"].c[0][0] - 3) <= found["predicted"].radius[0][0] <= 3 * HALF


def test_a_measurement_without_noise() -> None:
    """g = (1, 3), H = (1 0), R = 0: P = ((4, 6), (6, 12)) by hand, whose poles are 0 and -1/2; g g'
    solves the equation too, with a pole at -2.
    """
    of = model([[1, 1], [0, 1]], [[1, 0]], [[1, 3], [3, 9]], [[0]])
    true = {
        "predicted": boxed([[4, 6], [6, 12]]).c,
        "updated": boxed([[0, 0], [0, 3]]).c,
        "filter": boxed([[1], ["3/2"]]).c,
        "predictor": boxed([["5/2"], ["3/2"]]).c,
    }
    assert_encloses(of, true)
    found = steady(of).enclosures
    assert found["updated"].radius[0] == [0, 0]
    assert found["updated"].c[0] == [0, 0]
    assert found["filter"].c[0] == [1]
    assert found["filter"].radius[0] == [0]


def test_a_clock_in_seconds() -> None:
    """Variances of 1e-20 beside 1e-25, against doubling in multiprecision."""
    of = model([[1, 1], [0, 1]], [[1, 0]], [["1e-22", 0], [0, "1e-28"]], [["1e-18"]])
    clock = StateSpace(*(tuple(map(tuple, box.c)) for box in (of.f, of.q, of.h, of.r)))
    state = doubling.steady_state(clock, 80).state
    grids = {"predicted": state.predicted, "updated": state.updated, "filter": state.gain}
    true = {name: [[fraction(x) for x in row] for row in grid] for name, grid in grids.items()}
    true["predictor"] = (of.f @ Box(true["filter"])).c
    assert_encloses(of, true)


def test_what_is_known_without_an_error_is_exactly_zero() -> None:
    """A state that decays and that no noise reaches; one read a step before without noise."""
    found = steady(model([["1/2", 0], [1, 1]], [[1, 1]], [[0, 0], [0, 1]], [[1]])).enclosures
    for name in ("predicted", "updated", "filter", "predictor"):
        assert not any(found[name].c[0]), name
        assert not any(found[name].radius[0]), name
    assert found["predicted"].c[1][1] > 1
    delayed = steady(model([[0, 0], [1, 0]], [[1, 0]], [[1, 0], [0, 0]], [[0]])).enclosures
    assert delayed["predicted"].c[1] == [0, 0]
    assert delayed["predictor"].c == [[0], [1]]
    assert not any(map(any, delayed["predictor"].radius))


def test_a_combination_is_known_though_no_state_is() -> None:
    """x1 - x2 halves itself at each step, and both are driven by the same noise."""
    f = [["3/4", "1/4"], ["1/4", "3/4"]]
    of = model(f, [[1, 0]], [[1, 1], [1, 1]], [[1]])
    found = steady(of).enclosures["predicted"]
    assert found.c[0][0] == found.c[0][1] == found.c[1][1]
    assert_encloses(of, limit(of))


def test_parts_that_do_not_meet_have_zeros_between_them() -> None:
    """Two axes, of which one is never measured, and a measurement of nothing."""
    f = [[1, 1, 0], [0, 1, 0], [0, 0, "1/2"]]
    q = [[1, 0, 0], [0, 1, 0], [0, 0, 3]]
    of = model(f, [[1, 0, 0], [0, 0, 0]], q, [[1, 0], [0, 2]])
    found = steady(of).enclosures
    assert found["predicted"].c[2][:2] == found["predicted"].radius[2][:2] == [0, 0]
    assert [row[1] for row in found["filter"].c] == [row[1] for row in found["filter"].radius]
    assert found["filter"].c[2] == found["filter"].radius[2] == [0, 0]
    # 3/(1 - 1/4)
    assert abs(found["predicted"].c[2][2] - 4) <= found["predicted"].radius[2][2] <= 4 * HALF
    assert_encloses(of, limit(of))


def test_an_unstable_motion_without_noise_beside_one_with() -> None:
    of = model([[2, 1], [0, "1/2"]], [[1, 1]], [[0, 0], [0, 1]], [["1/3"]])
    assert_encloses(of, limit(of))


KINDS = ("plain", "singular", "correlated", "unstable", "units")


@pytest.mark.sampled
@pytest.mark.parametrize("kind", KINDS)
def test_drawn_models_against_the_recursion(kind: str) -> None:
    draw = random.Random(kind)
    enclosed = 0
    for _ in range(samples(6)):
        of = drawn(draw, draw.randint(1, 6), draw.randint(1, 3), kind)
        if kind == "singular" and not has_one(of):
            continue
        assert_encloses(of, limit(of))
        enclosed += 1
    assert enclosed


def has_one(of: Model) -> bool:
    """Whether there is a steady state; a drawn model without noise may have none."""
    try:
        return bool(steady(of))
    except NoSteadyState:
        return False


def test_fifteen_states_and_six_measurements() -> None:
    of = drawn(random.Random(15), 15, 6, "correlated")
    assert_encloses(of, limit(of))


def test_correlated_noises_as_those_that_are_not() -> None:
    """With R^-1 the model is another one without correlation, of the same P: (F - S R^-1 H, Q -
    S R^-1 S').
    """
    s, r = Fraction(1, 2), Fraction(2)
    of = model([["9/10"]], [[1]], [[1]], [[r]], [[s]])
    other = model([[Fraction(9, 10) - s / r]], [[1]], [[1 - s * s / r]], [[r]])
    p, q = (steady(x).enclosures["predicted"] for x in (of, other))
    assert abs(p.c[0][0] - q.c[0][0]) <= p.radius[0][0] + q.radius[0][0]
    assert_encloses(of, limit(of))


REFUSED = [
    # a velocity is measured, and where the target is nobody sees
    ([[1, 1], [0, 1]], [[0, 1]], [[1, 0], [0, 1]], [[1]], "not seen|eigenvalue 1,|in state 1,"),
    ([[2, 0], [0, "1/2"]], [[0, 1]], [[1, 1], [1, 1]], [[1]], "not seen|eigenvalue 2,|in state 1,"),
    # a constant that no noise moves
    (
        [["1/2", 0], [0, 1]],
        [[1, 1]],
        [[1, 0], [0, 0]],
        [[1]],
        "not driven|eigenvalue 1,|in state 2,",
    ),
    # an oscillation that no noise drives: 3/5 and 4/5
    ([["0.6", "0.8"], ["-0.8", "0.6"]], [[1, 0]], [[0, 0], [0, 0]], [[1]], "not driven|0.6 + 0.8i"),
    # two numbers for one thing without noise
    ([[1]], [[1], [2]], [[1]], [[0, 0], [0, 0]], "measurement 1 and measurement 2|no variance"),
    ([["1/2"]], [[1]], [[0]], [[0]], "the innovation of measurement 1 has no variance"),
]


@pytest.mark.parametrize(("f", "h", "q", "r", "words"), REFUSED)
def test_a_refusal_names_the_real_reason(f: Rows, h: Rows, q: Rows, r: Rows, words: str) -> None:
    with pytest.raises(NoSteadyState) as raised:
        steady(model(f, h, q, r))
    for word in words.split("|"):
        assert word in str(raised.value)


def test_a_noise_that_is_both_that_of_the_motion_and_that_of_the_measurement() -> None:
    """x+ = w, y = x + w, so that x+ + x = y: nothing drives a mode with the eigenvalue -1."""
    with pytest.raises(NoSteadyState, match=r"not driven: .* eigenvalue -1,"):
        steady(model([[0]], [[1]], [[1]], [[1]], [[1]]))


def test_next_to_a_border_there_is_a_steady_state() -> None:
    """A constant driven by 1e-40, one that nearly does not decay, and one that nearly nobody sees:
    by hand P = r q + ... solves P^2 = q (P + 1).
    """
    q = Fraction(1, 10**40)
    p = steady(model([[1]], [[1]], [[q]], [[1]])).enclosures["predicted"]
    low, high = (p.c[0][0] + sign * p.radius[0][0] for sign in (-1, 1))
    assert low**2 - q * (low + 1) < 0 < high**2 - q * (high + 1)
    for of in (
        model([[1 - q]], [[1]], [[0]], [[1]]),
        model([[1, 0], [0, 2]], [[1, q]], [[1, 0], [0, 1]], [[1]]),
        model([[1 + q]], [[1]], [[0]], [[1]]),
    ):
        steady(of)


def test_entries_that_are_boxes() -> None:
    """Models with the entries anywhere in a box of 1e-40; a state that nothing reaches is known."""
    f, q = [["1/2", "0"], ["1", "0.9"]], [["0", "0"], ["0", "1"]]
    exact = model(f, [[1, 1]], q, [[1]])
    radius = Fraction(1, 10**40)
    wide = Box(exact.f.c, [[radius, Fraction(0)], [radius, radius]])
    found = steady(Model(wide, exact.h, exact.q, exact.r, exact.s, exact.names)).enclosures
    assert found["predicted"].c[0] == found["predicted"].radius[0] == [0, 0]
    for signs in product((-1, 1), repeat=3):
        moved = [[exact.f.c[0][0] + signs[0] * radius, Fraction(0)]]
        moved.append([exact.f.c[1][0] + signs[1] * radius, exact.f.c[1][1] + signs[2] * radius])
        true = limit(model(moved, [[1, 1]], q, [[1]]))
        for name, box in found.items():
            for row in zip(box.c, true[name], box.radius, strict=True):
                for x, y, e in zip(*row, strict=True):
                    assert abs(x - y) <= e + Fraction(1, 10**80)


def test_of_boxes_a_mode_that_is_not_driven_is_named_too() -> None:
    exact = model([[1, "1/3"], [0, "1/2"]], [[1, 0]], [[0, 0], [0, 0]], [[1]])
    wide = Box(exact.f.c, [[Fraction(0)] * 2, [Fraction(0), Fraction(1, 10**60)]])
    with pytest.raises(NoSteadyState, match=r"not driven: .* eigenvalue 1, in state 1 and "):
        steady(Model(wide, exact.h, exact.q, exact.r, exact.s, exact.names))


def test_boxes_too_wide_are_refused() -> None:
    exact = model([["0.9"]], [[1]], [[1]], [[1]])
    wide = Box(exact.f.c, [[Fraction(1, 10**6)]])
    with pytest.raises(NoSteadyState, match="none was found"):
        steady(Model(wide, exact.h, exact.q, exact.r, exact.s, exact.names))
