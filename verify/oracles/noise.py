"""Process noise integrated numerically from its physical description.

Independent because it starts from the differential equation x' = A x + B w of the motion and
from what w is said to be; the process noise matrices of the catalogue are never read. The
accuracy rests on Gauss-Legendre quadrature in multiprecision, repeated with twice the nodes:
for a motion whose exponential is a polynomial the rule is exact from a few nodes on, and what is
left is the rounding of the working precision.

Three descriptions of w over a sampling interval of length T:

- ``white``: white noise of unit density; Q is the integral of exp(A s) B B' exp(A s)' over 0..T.
- ``held``: a random constant of unit variance, drawn anew for each interval; Q = G G' with G the
  integral of exp(A s) B.
- ``increment``: a random jump of unit variance at the end of the interval, so that it has not
  yet moved the other states when the next sample is taken; Q = B B'.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from gainproof.verify.oracles.matrices import (
    Matrix,
    add,
    largest_ratio,
    matrix,
    product,
    scale,
    subtract,
    transpose,
)
from gainproof.verify.oracles.multiprecision import bits_for, context, number_in
from gainproof.verify.oracles.state_space import NotConverged, exact

Rows = Sequence[Sequence[object]]


def chain(states: int) -> tuple[Matrix, Matrix]:
    """A and B of a chain of integrators: each state is driven by the next one, the last by w.

    Two states: position and velocity driven by acceleration; three: driven by jerk.
    """
    a = tuple(tuple(int(j == i + 1) for j in range(states)) for i in range(states))
    return a, tuple((int(i == states - 1),) for i in range(states))


def white(a: Rows, b: Rows, interval: object = 1, digits: int = 40) -> Matrix:
    """Q of white noise of unit density entering through B, sampled every ``interval``."""
    return _settled(a, b, interval, digits, lambda state: product(state, transpose(state)))


def held(a: Rows, b: Rows, interval: object = 1, digits: int = 40) -> Matrix:
    """Q of a unit-variance input through B held constant over each ``interval``."""
    carried = _settled(a, b, interval, digits, lambda state: state)
    return product(carried, transpose(carried))


def increment(b: Rows) -> Matrix:
    """Q of a unit-variance jump through B at the end of each interval."""
    column = matrix(b, exact)
    return product(column, transpose(column))


def transition(a: Rows, interval: object = 1, digits: int = 40) -> Matrix:
    """The transition matrix exp(A T), by scaling, Taylor series and squaring."""
    own = context(bits_for(digits) + 40)
    number = number_in(own)
    return _exponential(matrix(a, lambda x: number(exact(x))), number(exact(interval)), own)


def _settled(
    a: Rows,
    b: Rows,
    interval: object,
    digits: int,
    integrand: Callable[[Matrix], Matrix],
) -> Matrix:
    own = context(bits_for(digits) + 40)
    number = number_in(own)
    motion = matrix(a, lambda x: number(exact(x)))
    entry = matrix(b, lambda x: number(exact(x)))
    length = number(exact(interval))
    wanted = own.mpf(10) ** -digits

    def rule(nodes: int) -> Matrix:
        total: Matrix | None = None
        for node, weight in _gauss_legendre(nodes, own):
            state = product(_exponential(motion, length * node, own), entry)
            term = scale(length * weight, integrand(state))
            total = term if total is None else add(total, term)
        assert total is not None
        return total

    nodes, before = 4, rule(4)
    while nodes <= 256:
        nodes *= 2
        now = rule(nodes)
        # entries that vanish are compared with the largest one
        largest = max(abs(x) for row in now for x in row)
        floor = tuple(tuple(max(abs(x), largest * wanted) for x in row) for row in now)
        if largest_ratio(subtract(now, before), floor) <= wanted:
            return now
        before = now
    raise NotConverged(f"quadrature: {digits} digits not reached with {nodes} nodes")


def _exponential(a: Matrix, time: Any, own: Any) -> Matrix:
    """exp(A t): Taylor series of the matrix halved until it is small, then squared."""
    size = len(a)
    norm = max(sum(abs(x * time) for x in row) for row in a)
    halvings = max(0, int(own.ceil(own.log(norm, 2))) + 4) if norm > 0 else 0
    small = scale(time / 2**halvings, a)
    term = tuple(tuple(own.mpf(int(i == j)) for j in range(size)) for i in range(size))
    total, k = term, 0
    while any(x != 0 for row in term for x in row) and k < own.prec:
        k += 1
        term = scale(1 / own.mpf(k), product(term, small))
        total = add(total, term)
    for _ in range(halvings):
        total = product(total, total)
    return total


def _gauss_legendre(nodes: int, own: Any) -> list[tuple[Any, Any]]:
    """Nodes and weights on 0..1: Newton's method on the Legendre polynomial by its recurrence."""
    rule = []
    for i in range(nodes):
        x = own.cos(own.pi * (own.mpf(4 * i + 3) / (4 * nodes + 2)))
        slope = own.mpf(1)
        for _ in range(own.prec.bit_length() + 4):
            p, before = own.mpf(1), own.mpf(0)
            for k in range(1, nodes + 1):
                p, before = ((2 * k - 1) * x * p - (k - 1) * before) / k, p
            slope = nodes * (x * p - before) / (x * x - 1)
            x -= p / slope
        rule.append(((1 + x) / 2, 1 / ((1 - x * x) * slope * slope)))
    return rule
