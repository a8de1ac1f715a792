"""Stability of matrix gains on and next to the border, against Routh's test after a bilinear map.

The oracle shares nothing with the front: characteristic polynomials of rational matrices by FLINT,
z = (1 + s)/(1 - s), and signs in Routh's table; the front runs Faddeev-LeVerrier and Schur-Cohn.
"""

from __future__ import annotations

import warnings
from fractions import Fraction

import flint
import numpy as np
import pytest

from gainproof.fixed_gain import interacting
from gainproof.fixed_gain.arguments import Reals
from gainproof.fixed_gain.exact_stability import schur


def closed_loop(first: Reals, second: Reals, interval: float) -> flint.fmpq_mat:
    size, step = len(first), Fraction(interval)
    rows = []
    for i in range(2 * size):
        row = []
        for j in range(2 * size):
            one = Fraction(i % size == j % size)
            if j >= size:
                row.append(step * one if i < size else one)
                continue
            gain = Fraction(float(second[i % size, j]))
            if i < size:
                row.append(one - Fraction(float(first[i, j])) - step * gain)
            else:
                row.append(-gain)
        rows.append([flint.fmpq(x.numerator, x.denominator) for x in row])
    return flint.fmpq_mat(rows)


def routh(polynomial: list[Fraction]) -> bool:
    """All roots inside the unit circle. Coefficients, constant term first."""
    plus, minus = flint.fmpq_poly([1, 1]), flint.fmpq_poly([1, -1])
    degree = len(polynomial) - 1
    mapped = sum(
        (
            plus**k * minus ** (degree - k) * flint.fmpq(c.numerator, c.denominator)
            for k, c in enumerate(polynomial)
        ),
        flint.fmpq_poly([0]),
    )
    if mapped.degree() < degree:
        return False  # a root at z = -1
    terms = [Fraction(int(c.p), int(c.q)) for c in reversed(mapped.coeffs())]
    above, below = terms[0::2], terms[1::2]
    while below:
        if above[0] == 0 or below[0] * above[0] <= 0:
            return False
        ratio = above[0] / below[0]
        padded = [*below[1:], *[Fraction(0)] * (len(above) - len(below))]
        above, below = below, [x - ratio * y for x, y in zip(above[1:], padded, strict=True)]
    return True


def truth(first: Reals, second: Reals, interval: float) -> bool:
    coefficients = closed_loop(first, second, interval).charpoly().coeffs()
    return routh([Fraction(int(c.p), int(c.q)) for c in coefficients])


BORDER = [
    ([[0.0]], [[0.1]]),
    ([[-1e-17]], [[0.1]]),
    ([[-1e-17]], [[1e-3]]),
    ([[1e-18]], [[0.1]]),
    ([[0.5]], [[-1e-18]]),
    ([[0.5]], [[3.0]]),
    ([[0.5]], [[2.9999999999999996]]),
    ([[0.5]], [[3.0000000000000004]]),
    ([[2.0]], [[1e-18]]),
    ([[1e-18]], [[4.0]]),
    ([[1e-300]], [[1e-300]]),
    ([[1.0]], [[1.0]]),
]


@pytest.mark.parametrize(("first", "second"), BORDER)
def test_one_coordinate_is_decided_by_its_inequalities(
    first: list[list[float]], second: list[list[float]]
) -> None:
    """0 < alpha, 0 < beta < 4 - 2 alpha, in fractions; and so does the oracle."""
    alpha, beta = Fraction(first[0][0]), Fraction(second[0][0])
    wanted = alpha > 0 and 0 < beta < 4 - 2 * alpha
    assert interacting.is_stable(first, second, 1.0) == wanted
    assert truth(np.array(first), np.array(second), 1.0) == wanted
    if not wanted:
        with pytest.raises(ValueError, match="not a stable filter"):
            interacting.covariances(first, second, 1.0, [[1.0]])
        with pytest.raises(ValueError, match=r"stable|singular"):
            interacting.lag(second, 1.0, [1.0], first)


def near_the_border(place: int, generator: np.random.Generator) -> tuple[Reals, Reals]:
    """Rotated triangular matrices, far from normal, with one coordinate next to the border."""
    size = 2 + place % 2
    spread = 10.0 ** generator.uniform(0, 8)
    alpha, beta = generator.uniform(0.1, 0.9, size), generator.uniform(0.05, 0.5, size)
    off = 10.0 ** generator.uniform(-16, -3) * generator.choice([-1, 1])
    if place % 3 == 0:
        alpha[0] = off
    elif place % 3 == 1:
        beta[0] = off
    else:
        beta[0] = 4 - 2 * alpha[0] + off
    upper = np.triu(generator.normal(size=(size, size)) * spread, 1)
    turned = np.linalg.qr(generator.normal(size=(size, size)))[0]
    return turned @ (np.diag(alpha) + upper) @ turned.T, turned @ np.diag(beta) @ turned.T


def test_filters_far_from_normal_next_to_the_border() -> None:
    generator = np.random.default_rng(1)
    stable = rounded = 0
    for place in range(300):
        first, second = near_the_border(place, generator)
        interval = float(generator.choice([1.0, 0.25]))
        wanted = truth(first, second / interval, interval)
        assert interacting.is_stable(first, second / interval, interval) == wanted
        stable += wanted
        largest = np.abs(interacting.poles(first, second / interval, interval)[0])
        rounded += (largest < 1) != wanted
    assert 50 < stable < 250
    assert rounded > 10, "eigenvalues as rounded would have done: the cases are too easy"


def test_away_from_the_border_eigenvalues_decide() -> None:
    generator = np.random.default_rng(2)
    found = []
    for _ in range(200):
        first = np.diag(generator.uniform(0, 1.5, 3)) + generator.uniform(-0.2, 0.2, (3, 3))
        second = np.diag(generator.uniform(0, 1.5, 3)) + generator.uniform(-0.2, 0.2, (3, 3))
        largest = np.abs(interacting.poles(first, second, 1.0)[0])
        if abs(largest - 1) > 1e-6:
            assert interacting.is_stable(first, second, 1.0) == (largest < 1)
            found.append(largest < 1)
    assert len(found) > 190
    assert 30 < sum(found) < 170


def test_polynomials_with_known_roots() -> None:
    assert schur([1, 0, 0])
    assert schur([4, 0, -1])
    assert not schur([1, -1])
    assert not schur([1, 0, 1])
    assert not schur([1, 0, 0, 0, -2])
    assert not schur([1, -2, 0])


HUGE: list[tuple[object, tuple[object, ...], str]] = [
    (interacting.poles, ([[1e155]], [[1.0]], 1.0), "position_gain must have no entry beyond 1e"),
    (interacting.poles, ([[1.0]], [[1e200]], 1e200), "interval times velocity_gain must have no"),
    (interacting.covariances, ([[0.5]], [[1e-299]], 1e300, [[1e300]]), "stable filter"),
    (interacting.covariances, ([[0.5]], [[1e299]], 1e-300, [[1e300]]), "beyond float64 in these"),
    (interacting.covariances, ([[1e-15]], [[1e-15]], 1.0, [[1.0]]), "too near the border"),
    (interacting.lag, ([[-0.5]], 1.0, [1.0]), "its determinant must be above 0, got -0.5"),
    (interacting.lag, (np.eye(2) * 1e-320, 1.0, [1.0, 1.0]), "lag T K2.* is beyond float64"),
    (interacting.lag, ([[3.5]], 1.0, [1.0], [[0.5]]), "not a stable filter"),
]


@pytest.mark.parametrize(("function", "given", "told"), HUGE)
def test_numbers_beyond_reach_are_refused_without_a_warning(
    function: object, given: tuple[object, ...], told: str
) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        with pytest.raises(ValueError, match=told):
            function(*given)  # type: ignore[operator]


def test_units_of_any_size_change_no_digit() -> None:
    """Powers of two of T and B are exact, and of accelerations."""
    first, second = np.array([[0.5, 0.1], [0.0, 0.4]]), np.array([[0.2, 0.0], [0.1, 0.3]])
    noise = np.eye(2)
    plain = interacting.covariances(first, second, 1.0, noise).predicted
    small = interacting.covariances(first, second * 2.0**300, 2.0**-300, noise).predicted
    assert (small[:2, :2] == plain[:2, :2]).all()
    assert (small[2:, 2:] == plain[2:, 2:] * 2.0**600).all()
    tiny = interacting.covariances(first, second, 1.0, noise * 2.0**-900).predicted
    assert (tiny == plain * 2.0**-900).all()
    assert (
        interacting.lag(second * 2.0**-900, 1.0, [2.0**-900, 0])
        == interacting.lag(second, 1.0, [1, 0])
    ).all()
