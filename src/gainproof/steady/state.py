"""A steady state as doubles with proved errors, its enclosures and its certificate."""

from __future__ import annotations

import re
import reprlib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from math import floor, inf, log2, nextafter
from operator import index
from typing import Any

from gainproof.bad_input import BadInputError
from gainproof.verify.check_enclosure import Box, decide, definite, diagonal
from gainproof.verify.enclosure.poles import Pole, poles
from gainproof.verify.enclosure.samples import NoGain, gains_by_sample
from gainproof.verify.enclosure.steady import steady
from gainproof.verify.enclosure.structure import Model, NoSteadyState

MOST_SIZE, MOST_SAMPLES = 40, 1000
MOST_DIGITS = 1200
"""Of a number in a certificate."""
MOST_NUMBER_BITS = floor(MOST_DIGITS * log2(10))
ROUNDING = Fraction(1, 1 << 40)
"""Of entries: less is taken for what computing in doubles does."""
Matrix = Iterable[Iterable[Any]]
NUMBER = re.compile(r"[+-]?\d{1,300}(\.\d{1,300})?(/0*[1-9]\d{0,300}|[eE][+-]?\d{1,3})?", re.ASCII)
MATRICES = ("filter_gain", "predictor_gain", "predicted_covariance", "updated_covariance")


@dataclass(frozen=True)
class Enclosed:
    """A matrix: every entry differs from that of `values` by at most that of `errors`, and from
    that of `centre` by at most that of `radius`, which are exact. An error of 0 says that the value
    is exact.
    """

    values: tuple[tuple[float, ...], ...]
    errors: tuple[tuple[float, ...], ...]
    centre: tuple[tuple[Fraction, ...], ...]
    radius: tuple[tuple[Fraction, ...], ...]


@dataclass(frozen=True)
class SteadyState:
    """The stabilising steady state of a Kalman filter.

    The filter gain is K = P H' (H P H' + R)^-1, that of the predictor F K; where the noises are
    correlated, (F P H' + S) (H P H' + R)^-1. `certificate` proves all matrices: as JSON it is
    decided by `gainproof.verify.check_enclosure`, a file that needs Python alone. `poles` are the
    eigenvalues of F - (predictor gain) H.
    """

    filter_gain: Enclosed
    predictor_gain: Enclosed
    predicted_covariance: Enclosed
    updated_covariance: Enclosed
    poles: tuple[Pole, ...]
    certificate: Mapping[str, Any]

    def check(self) -> None:
        """Decide the certificate anew. Raises ValueError where it proves nothing."""
        decide(self.certificate)


@dataclass(frozen=True)
class Sample:
    """Covariances and gains of one sample, as those of a `SteadyState`."""

    filter_gain: Enclosed
    predictor_gain: Enclosed
    predicted_covariance: Enclosed
    updated_covariance: Enclosed


def steady_state(
    transition: Matrix,
    measurement: Matrix,
    process_noise: Matrix,
    measurement_noise: Matrix,
    cross_noise: Matrix | None = None,
) -> SteadyState:
    """See `gainproof.steady_state`."""
    return steady_state_of(
        _model(transition, measurement, process_noise, measurement_noise, cross_noise)
    )


def first_samples(
    transition: Matrix,
    measurement: Matrix,
    process_noise: Matrix,
    measurement_noise: Matrix,
    start: Matrix,
    count: int,
    cross_noise: Matrix | None = None,
) -> tuple[Sample, ...]:
    """Covariances and gains of the first `count` samples, with errors that are proved.

    The matrices are those of `gainproof.steady_state`; `start` is the covariance of the prediction
    of the first sample. There need be no steady state. Raises BadInputError.
    """
    model = _model(transition, measurement, process_noise, measurement_noise, cross_noise)
    return samples_of(model, _box("start", start), count)


def samples_of(model: Model, start: Box, count: int) -> tuple[Sample, ...]:
    """The same of a model that was read. Raises BadInputError."""
    n = len(model.f.c)
    if not 1 <= count <= MOST_SAMPLES:
        raise BadInputError(f"samples: 1 to {MOST_SAMPLES} are wanted, got {count}")
    if (len(start.c), len(start.c[0])) != (n, n):
        found = f"{len(start.c)} by {len(start.c[0])}"
        raise BadInputError(f"start: wanted {n} by {n}, but it is {found}")
    _require_covariances(model, start)
    try:
        found_samples = gains_by_sample(model, start, count)
    except NoGain as reason:
        raise BadInputError(str(reason)) from None
    return tuple(
        Sample(*(_enclosed(of[x]) for x in ("filter", "predictor", "predicted", "updated")))
        for of in found_samples
    )


def _model(
    transition: Matrix,
    measurement: Matrix,
    process_noise: Matrix,
    measurement_noise: Matrix,
    cross_noise: Matrix | None,
) -> Model:
    f = _box("F", transition)
    h = _box("H", measurement)
    n, m = len(f.c), len(h.c)
    q, r = _box("Q", process_noise), _box("R", measurement_noise)
    s = (
        Box([[Fraction(0)] * m for _ in range(n)])
        if cross_noise is None
        else _box("S", cross_noise)
    )
    shapes = {"F": (f, n, n), "H": (h, m, n), "Q": (q, n, n), "R": (r, m, m), "S": (s, n, m)}
    for name, (box, rows, columns) in shapes.items():
        if (len(box.c), len(box.c[0])) != (rows, columns):
            found = f"{len(box.c)} by {len(box.c[0])}"
            raise BadInputError(f"{name}: wanted {rows} by {columns}, but it is {found}")
    names = _numbered("state", n), _numbered("measurement", m)
    return Model(f, h, q, r, s, names)


def steady_state_of(model: Model) -> SteadyState:
    """The same of a model that was read. Raises BadInputError."""
    _require_covariances(model)
    try:
        found = steady(model)
    except NoSteadyState as reason:
        raise BadInputError(f"no steady state: {reason}") from None
    of = found.enclosures
    return SteadyState(
        _enclosed(of["filter"]),
        _enclosed(of["predictor"]),
        _enclosed(of["predicted"]),
        _enclosed(of["updated"]),
        poles(model, of, found.certificate["parts"][0]),
        found.certificate,
    )


def _numbered(what: str, count: int) -> tuple[str, ...]:
    return tuple(f"{what} {i + 1}" for i in range(count))


def _require_sizes(model: Model, start: Box | None) -> None:
    """Raises BadInputError for a number that no certificate can say."""
    boxes = {"F": model.f, "H": model.h, "Q": model.q, "R": model.r, "S": model.s}
    for name, box in (boxes | ({"start": start} if start else {})).items():
        for i, row in enumerate(box.c, 1):
            for j, x in enumerate(row, 1):
                if max(map(int.bit_length, x.as_integer_ratio())) > MOST_NUMBER_BITS:
                    problem = f"row {i}, column {j}: a number has at most {MOST_DIGITS} digits"
                    raise BadInputError(f"{name}: {problem}")


def _require_covariances(model: Model, start: Box | None = None) -> None:
    _require_sizes(model, start)
    said = {"Q": model.q, "R": model.r} | ({"start": start} if start else {})
    for name, box in said.items():
        for i, row in enumerate(box.c):
            for j in range(i):
                if row[j] != box.c[j][i]:
                    here, there = (_shown(x) for x in (row[j], box.c[j][i]))
                    near = abs(row[j] - box.c[j][i]) <= ROUNDING * abs(row[j])
                    hint = f"; by rounding: take ({name} + {name}.T)/2" if near else ""
                    raise BadInputError(
                        f"{name}: row {i + 1}, column {j + 1} is {here}, and row {j + 1}, column "
                        f"{i + 1} is {there}: a covariance is symmetric{hint}"
                    )
            if row[i] + box.radius[i][i] < 0:
                raise BadInputError(
                    f"{name}: row {i + 1}, column {i + 1} is {_shown(row[i])}: a variance is not "
                    "negative"
                )
        if fault := _indefinite(box):
            raise BadInputError(f"{name}: no covariance, as it is {fault}")
    whole = model.r.over(model.s).turned().over(model.s.turned().over(model.q).turned())
    if fault := _indefinite(whole):
        raise BadInputError(
            f"S: more than Q and R allow, as the covariance of both noises together is {fault}"
        )


def _indefinite(box: Box) -> str:
    """What is wrong with a covariance, or nothing. Singular ones in doubles miss being covariances
    by their rounding, the centres of boxes by their radius: these are let pass.
    """
    more = diagonal([ROUNDING * row[i] for i, row in enumerate(box.c)])
    if not _semidefinite(box + more):
        return "not positive semidefinite"
    if _semidefinite(box + diagonal([sum(row, Fraction(0)) for row in box.radius])):
        return ""
    return (
        "not positive semidefinite, by rounding alone: write its numbers exactly, as fractions or "
        "texts ('1/400'), or add 1e-12 of its diagonal"
    )


def _semidefinite(box: Box) -> bool:
    try:
        definite(Box(box.c), "")
    except ValueError:
        return False
    return True


def _shown(x: Fraction) -> str:
    if len(str(x)) <= 20:
        return str(x)
    is_double = Fraction(1, 10**300) < abs(x) < 10**300
    return repr(float(x)) if is_double else f"{Decimal(x.numerator) / x.denominator:.6g}"


def _box(name: str, rows: Any) -> Box:
    try:
        grid = [list(row) for row in rows]
    except TypeError:
        got = reprlib.repr(rows)
        raise BadInputError(
            f"{name}: a matrix is wanted, as a list of rows, such as [[9]]; got {got}"
        ) from None
    if not grid or not grid[0] or any(len(row) != len(grid[0]) for row in grid):
        raise BadInputError(f"{name}: rows of one length are wanted, at least one")
    if len(grid) > MOST_SIZE or len(grid[0]) > MOST_SIZE:
        raise BadInputError(f"{name}: at most {MOST_SIZE} rows and columns are covered")
    return Box([[_number(name, i, j, x) for j, x in enumerate(row)] for i, row in enumerate(grid)])


def _number(name: str, i: int, j: int, x: Any) -> Fraction:
    try:
        return exact_number(x)
    except (ValueError, TypeError, OverflowError):
        raise BadInputError(
            f"{name}: row {i + 1}, column {j + 1}: a finite number is wanted, got {str(x)[:40]!r}"
        ) from None


def exact_number(x: Any) -> Fraction:
    """A whole number, a fraction, a decimal or a text as it stands; a float as the binary number
    that it is. Raises ValueError, TypeError, OverflowError.
    """
    if isinstance(x, str):
        if not NUMBER.fullmatch(x):
            raise ValueError(x)
        return Fraction(x)
    if hasattr(x, "as_integer_ratio"):
        return Fraction(*x.as_integer_ratio())
    return Fraction(index(x))


def _enclosed(box: Box) -> Enclosed:
    pairs = [
        [_double(c, e) for c, e in zip(*row, strict=True)]
        for row in zip(box.c, box.radius, strict=True)
    ]
    return Enclosed(
        tuple(tuple(value for value, _ in row) for row in pairs),
        tuple(tuple(error for _, error in row) for row in pairs),
        tuple(map(tuple, box.c)),
        tuple(map(tuple, box.radius)),
    )


def _double(centre: Fraction, radius: Fraction) -> tuple[float, float]:
    """The nearest double and a bound of its error."""
    try:
        value = float(centre)
        error = radius + abs(centre - Fraction(value))
        bound = float(error)
    except OverflowError:
        raise BadInputError(
            "a number of the steady state is beyond float64: scale the units"
        ) from None
    return value, bound if Fraction(bound) >= error else nextafter(bound, inf)
