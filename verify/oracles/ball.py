"""A rigorous enclosure of the steady state: balls that contain the Riccati solution.

Independent because it starts from F, Q, H, R as rational numbers and goes by the theorem of
spectral factorisation: the innovation spectrum, an exact rational polynomial, has its roots in
pairs z, 1/z, and the n roots inside the unit circle are the closed-loop poles of the stabilising
solution, which is unique. From the poles follows the predictor gain (pole placement by one
output is unique for an observable model), from the gain the predicted covariance (the Lyapunov
equation of the closed loop), and from that the rest by definition. No radical expression of any
gain is used.

The accuracy is proved, not estimated: the roots are isolated by python-flint (certified), all
further steps are ball arithmetic, the roots are certified to lie inside the circle, and the
precision is doubled until every ball returned has the relative radius asked for.

Derivatives with respect to the tracking index are enclosed too: the derivative of the Riccati
equation is a Lyapunov equation with the same closed loop.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

import flint

from gainproof.verify.oracles.closed_loop import Unresolved, distances_from_one, expand
from gainproof.verify.oracles.matrices import Matrix
from gainproof.verify.oracles.spectrum import Spectrum
from gainproof.verify.oracles.state_space import Index, NotConverged, SteadyState, exact

LARGEST_PRECISION = 1 << 17


@dataclass(frozen=True)
class Enclosure:
    """The steady state in balls, for the model with process noise ``index**2`` times its own.

    ``state`` holds the quantities, ``slope`` their derivatives with respect to the index;
    ``predictor_gain`` and ``predictor_slope`` are F K and its derivative; ``poles`` are the
    closed-loop poles (complex balls, real ones with imaginary part exactly 0, multiple ones
    repeated) in no particular order; ``bits`` the working precision.
    """

    index: Fraction
    state: SteadyState
    slope: SteadyState
    predictor_gain: Matrix
    predictor_slope: Matrix
    poles: tuple[flint.acb, ...]
    bits: int


def _lost(index: Fraction) -> int:
    """A first guess of the bits that cancel; the precision is doubled if they are more.

    Poles are kept as distances from 1, where slow filters have them; those of fast ones end near
    0 and -1, and their distances from there are smaller than the inverse index.
    """
    size = int(index.numerator.bit_length() - index.denominator.bit_length())
    return 4 * size if size > 0 else -size


def enclose(spectrum: Spectrum, tracking_index: Index, digits: int = 40) -> Enclosure:
    """Balls of relative radius at most 10^-digits round every entry of the steady state.

    ``spectrum`` is that of the model with tracking index 1; the index is taken exactly and must
    be positive. Raises NotConverged when an entry does not separate from zero (it may be zero).
    """
    index = exact(tracking_index)
    if index <= 0:
        raise ValueError(f"the tracking index must be positive, got {tracking_index!r}")
    wanted = digits * 10 // 3 + 1
    bits = wanted + 64 + _lost(index)
    while bits <= LARGEST_PRECISION:
        with flint.ctx.workprec(bits):
            try:
                return _enclose(spectrum, index, wanted, bits)
            except (Unresolved, ZeroDivisionError):
                bits *= 2
    raise NotConverged(f"balls: {digits} digits of every entry not reached with {bits // 2} bits")


def _enclose(spectrum: Spectrum, index: Fraction, wanted: int, bits: int) -> Enclosure:
    model = spectrum.model
    n = model.size
    ratio = flint.fmpq(index.numerator, index.denominator)
    distances = distances_from_one(spectrum, ratio * ratio)
    loop_polynomial = expand(distances)
    apart = flint.arb_mat(
        n, 1, [c - d for c, d in zip(loop_polynomial, spectrum.characteristic, strict=False)][:n]
    )
    f = balls(model.transition)
    h = balls(model.measurement)
    r = _ball(model.measurement_noise[0][0])
    placed = flint.arb_mat(spectrum.gain_matrix) * apart
    loop = f - placed * h
    q0 = balls(model.process_noise)
    noise = q0 * flint.arb(ratio * ratio) + placed * placed.transpose() * r
    predicted, slope = lyapunov(loop, (noise, q0 * flint.arb(2 * ratio)))

    cross = predicted * h.transpose()
    innovation = (h * cross)[0, 0] + r
    gain = cross * (1 / innovation)
    unit = flint.arb_mat(n, n, [int(i == j) for i in range(n) for j in range(n)])
    kept = unit - gain * h
    updated = predicted - gain * cross.transpose()
    d_updated = kept * slope * kept.transpose()
    d_cross = slope * h.transpose()
    d_gain = kept * d_cross * (1 / innovation)
    enclosed = Enclosure(
        index,
        SteadyState(*map(rows, (predicted, updated, gain, flint.arb_mat([[innovation]])))),
        SteadyState(*map(rows, (slope, d_updated, d_gain, h * d_cross))),
        rows(placed),
        rows(f * d_gain),
        tuple(1 - x for x in distances),
        bits,
    )
    _require(enclosed, wanted)
    return enclosed


def lyapunov(loop: flint.arb_mat, rights: tuple[flint.arb_mat, ...]) -> tuple[flint.arb_mat, ...]:
    """Symmetric X with X = A X A' + C for each C, from one linear system in balls."""
    n = loop.nrows()
    pairs = [(i, j) for i in range(n) for j in range(i, n)]
    a = loop.tolist()
    left = flint.arb_mat(
        [
            [
                int((i, j) == (k, m))
                - (a[i][k] * a[j][m] if k == m else a[i][k] * a[j][m] + a[i][m] * a[j][k])
                for k, m in pairs
            ]
            for i, j in pairs
        ]
    )
    right = flint.arb_mat([[c[i, j] for c in rights] for i, j in pairs])
    flat = left.solve(right)
    place = {pair: number for number, pair in enumerate(pairs)}
    return tuple(
        flint.arb_mat([[flat[place[min(i, j), max(i, j)], c] for j in range(n)] for i in range(n)])
        for c in range(len(rights))
    )


def _require(enclosed: Enclosure, wanted: int) -> None:
    for state in (enclosed.state, enclosed.slope):
        for rows in (state.predicted, state.updated, state.gain, state.innovation):
            for row in rows:
                if any(entry.rel_accuracy_bits() < wanted for entry in row):
                    raise Unresolved
    for rows in (enclosed.predictor_gain, enclosed.predictor_slope):
        if any(row[0].rel_accuracy_bits() < wanted for row in rows):
            raise Unresolved
    if any(pole.rel_accuracy_bits() < wanted for pole in enclosed.poles):
        raise Unresolved


def _ball(value: Fraction) -> flint.arb:
    return flint.arb(flint.fmpq(value.numerator, value.denominator))


def balls(matrix: Matrix) -> flint.arb_mat:
    """A matrix of fractions in balls of the working precision."""
    return flint.arb_mat([[_ball(x) for x in row] for row in matrix])


def rows(matrix: flint.arb_mat) -> Matrix:
    """A matrix of balls as rows."""
    return tuple(tuple(row) for row in matrix.tolist())
