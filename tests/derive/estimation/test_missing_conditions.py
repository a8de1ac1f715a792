"""Exact examples of what fails without a condition that statements on location have.

Each is small enough to be worked out by hand; FLINT multiplies and inverts rational matrices, and
nothing of derive or of the checker is used. A formula that needs no condition would have no example
here.
"""

from __future__ import annotations

from collections.abc import Sequence

import flint
import pytest

Rows = Sequence[Sequence[int | str]]


def matrix(rows: Rows) -> flint.fmpq_mat:
    """A matrix of rational numbers, "p/q" or whole."""
    entries = [[_number(str(entry)) for entry in row] for row in rows]
    return flint.fmpq_mat(len(entries), len(entries[0]), [e for row in entries for e in row])


def _number(text: str) -> flint.fmpq:
    numerator, _, denominator = text.partition("/")
    return flint.fmpq(int(numerator), int(denominator or 1))


def information(design: flint.fmpq_mat, noise: flint.fmpq_mat) -> flint.fmpq_mat:
    return design.transpose() * noise.inv() * design


def beside(left: flint.fmpq_mat, right: flint.fmpq_mat) -> flint.fmpq_mat:
    """Columns of one, then of the other."""
    rows = [[*a, *b] for a, b in zip(left.tolist(), right.tolist(), strict=True)]
    return flint.fmpq_mat(len(rows), len(rows[0]), [entry for row in rows for entry in row])


def above(upper: flint.fmpq_mat, lower: flint.fmpq_mat) -> flint.fmpq_mat:
    return beside(upper.transpose(), lower.transpose()).transpose()


def part(whole: flint.fmpq_mat, rows: range, columns: range) -> flint.fmpq_mat:
    entries = [whole[i, j] for i in rows for j in columns]
    return flint.fmpq_mat(len(rows), len(columns), entries)


INDEFINITE = matrix([[1, 0], [0, -1]])
"""Symmetric with an inverse, and no covariance."""


def test_property_10_needs_a_definite_noise() -> None:
    """A' A > 0, and A' V^-1 A has no inverse."""
    design = matrix([[1], [1]])
    assert (design.transpose() * design)[0, 0] == 2
    assert information(design, INDEFINITE)[0, 0] == 0


def test_a_form_that_vanishes_needs_a_definite_noise() -> None:
    """(86) does not give (88): the form vanishes at 1, and A x does not."""
    design, x = matrix([[1], [1]]), matrix([[1]])
    assert (x.transpose() * information(design, INDEFINITE) * x)[0, 0] == 0
    assert (design * x).tolist() != matrix([[0], [0]]).tolist()


def test_the_solution_is_a_minimum_for_a_definite_noise_only() -> None:
    """A' V^-1 A has an inverse, and the cost (64) falls without end; (54) is negative."""
    design, seen = matrix([[0], [1]]), matrix([[0], [0]])
    assert information(design, INDEFINITE)[0, 0] == -1
    costs = []
    for x in (0, 1, 2):
        rest = seen - design * matrix([[x]])
        costs.append((rest.transpose() * INDEFINITE.inv() * rest)[0, 0])
    assert costs == [0, -1, -4]
    assert information(design, INDEFINITE).inv()[0, 0] < 0


def test_the_converse_of_theorem_1_needs_a_semidefinite_matrix() -> None:
    """D22 and H1 have inverses, D11 has none: one form of (A.2) only."""
    whole = matrix([[0, 1], [1, 1]])
    complement = whole[0, 0] - whole[0, 1] * whole[1, 0] / whole[1, 1]
    assert whole[1, 1] == 1
    assert complement == -1
    assert whole[0, 0] == 0
    assert (whole * whole.inv()).tolist() == matrix([[1, 0], [0, 1]]).tolist()


def test_an_inverse_is_above_that_of_its_block_for_a_definite_matrix_only() -> None:
    """(A.3) and (118) fail for diag(-1, 1), whose lower block is positive definite."""
    whole = matrix([[-1, 0], [0, 1]])
    padded = matrix([[0, 0], [0, 1]])
    assert (whole.inv() - padded)[0, 0] == -1


@pytest.mark.parametrize(("scale", "sign"), [(1, 0), (2, -1)])
def test_a_projection_needs_columns_of_length_1(scale: int, sign: int) -> None:
    """(81) for one station and H' H = 1 or 4."""
    design, columns = matrix([[1]]), matrix([[scale]])
    rest = design.transpose() * design - (
        design.transpose() * columns * columns.transpose() * design
    )
    assert (rest[0, 0] > 0) - (rest[0, 0] < 0) == sign


def correlated() -> tuple[flint.fmpq_mat, flint.fmpq_mat, flint.fmpq_mat, flint.fmpq_mat]:
    """Two stations on a line: A_l, A_ld, V with V_ld = I/2, and A of (32)."""
    ranges, rates = matrix([[1], [-1]]), matrix([[0], [1]])
    unit, zero = matrix([[1, 0], [0, 1]]), matrix([[0, 0], [0, 0]])
    half = matrix([["1/2", 0], [0, "1/2"]])
    noise = above(beside(unit, half), beside(half, unit))
    upper = beside(beside(ranges, matrix([[0], [0]])), unit)
    return ranges, rates, noise, above(upper, beside(beside(rates, ranges), zero))


def test_the_variance_of_a_bias_is_a_sum_for_uncorrelated_noise_only() -> None:
    """(138) and (125); (122) is right for both."""
    ranges, rates, noise, design = correlated()
    covariance = information(design, noise).inv()
    biases = part(covariance, range(2, 4), range(2, 4))
    seen = beside(rates, ranges)
    course = (seen.transpose() * seen).inv()  # V_d = I
    padded = beside(ranges, matrix([[0], [0]]))
    unit = matrix([[1, 0], [0, 1]])
    sum_of_two = unit + padded * course * padded.transpose()
    assert biases.tolist() != sum_of_two.tolist()
    crossing = padded - matrix([["1/2", 0], [0, "1/2"]]) * seen  # L' of (124)
    right = matrix([["3/4", 0], [0, "3/4"]]) + crossing * course * crossing.transpose()
    assert biases.tolist() == right.tolist()


def test_doppler_alone_takes_its_own_weight() -> None:
    """As the detection of biases does: V_d^-1, and not the block G22 of V^-1."""
    ranges, rates, noise, design = correlated()
    seen = beside(rates, ranges)
    whole = part(information(design, noise).inv(), range(2), range(2))
    assert whole.tolist() == (seen.transpose() * seen).inv().tolist()
    block = part(noise.inv(), range(2, 4), range(2, 4))
    assert whole.tolist() != (seen.transpose() * block * seen).inv().tolist()


def test_a_bias_that_passes_as_clean_shifts_the_estimate() -> None:
    """(66) for a fixed choice of clean ranges takes their biases to be 0."""
    design, left_out = matrix([[1], [1]]), matrix([[1], [0]])
    unit = matrix([[1, 0], [0, 1]])
    estimator = information(design, unit).inv() * design.transpose()
    assert (estimator * left_out)[0, 0] == flint.fmpq(1, 2)


def test_five_stations_in_space_are_too_few_whatever_they_measure() -> None:
    """B has five rows and six columns: A' A > 0 fails."""
    primes = (2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37, 41, 43, 47)
    ranges = matrix([primes[3 * i : 3 * i + 3] for i in range(5)])
    rates = matrix([primes[::-1][3 * i : 3 * i + 3] for i in range(5)])
    seen = beside(rates, ranges)
    assert seen.rank() == 5
    assert (seen.transpose() * seen).det() == 0
