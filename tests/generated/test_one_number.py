"""Kernels called with single numbers: the bits, types and messages that arrays have, and no other
way to be told that it is another path than the time.
"""

from __future__ import annotations

import itertools
import pkgutil
import warnings
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from samples import times

import gainproof.generated
from gainproof.bench.arguments import fitting, sample
from gainproof.generated._numbers import of_numbers

POINTS = 20_000 if times() > 1 else 40
MODULES = [m.name for m in pkgutil.iter_modules(gainproof.generated.__path__) if m.name[0] != "_"]
KINDS: tuple[type[Any], ...] = (np.float64, np.float32)
LEFT = 0.02
"""Of the points at the ends of domains, how many may go the way of arrays all the same: those at
which Python's operators raise where NumPy has infinity, which the results are then made of.
"""


@dataclass(frozen=True)
class Called:
    """A kernel, or a kernel in double-words."""

    id: str
    function: Callable[..., Any]
    signature: Any
    options: dict[str, bool]


def kernels(module: str) -> Iterator[Called]:
    loaded = import_module(f"gainproof.generated.{module}")
    for name in loaded.__all__:
        if name[0].islower():
            function, own = getattr(loaded, name), f"_{name.upper()}"
            yield Called(f"{module}.{name}", function, vars(loaded)[own], {})
            if accurate := vars(loaded).get(f"_ACCURATE{own}"):
                yield Called(f"{module}.{name} accurate", function, accurate, {"accurate": True})


def points(signature: Any, kind: type[Any], count: int, seed: int) -> list[Any]:
    """Columns of numbers of the kind inside the domains: ordinary ones, magnitudes of all sizes,
    ends, numbers next to them, and zeros.
    """
    generator = np.random.default_rng(seed)
    columns = []
    for domain, usual in zip(signature.inputs, sample(signature, count), strict=True):
        low, high = domain.double if kind is np.float64 else domain.single
        least = max(low, float(np.finfo(kind).smallest_subnormal))
        with np.errstate(all="ignore"):
            wide = np.exp(generator.uniform(np.log(least), np.log(high), count))
            ends = np.array([least, np.nextafter(kind(least), kind(1)), high], kind)
            ends = np.append(ends, np.nextafter(kind(high), kind(0)))
        wide = np.where(generator.random(count) < 0.1, generator.choice(ends, count), wide)
        column = np.where(generator.random(count) < 0.5, usual, wide)
        if domain.whole:
            column = np.round(column)
        column = np.clip(np.abs(column), low, high)
        if domain.signed:
            column *= generator.choice([-1.0, 1.0], count)
        if domain.zero or not low:
            column = np.where(generator.random(count) < 0.1, low * 0.0, column)
        with np.errstate(all="ignore"):
            columns.append(column.astype(kind))
    return list(fitting(signature, columns))


def as_bytes(values: Any, kind: type[Any]) -> bytes:
    return np.array(values, kind).tobytes()


@pytest.mark.sampled
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("module", MODULES)
def test_the_bits_are_those_of_arrays(module: str, kind: type[Any]) -> None:
    """Of each kernel at each point; nearly everywhere the path of numbers is taken."""
    for called in kernels(module):
        count = min(POINTS, 200) if called.options else POINTS
        columns = points(called.signature, kind, count, seed=3)
        whole = called.function(*columns, **called.options)
        python = kind is np.float64
        rows = list(zip(*(c.tolist() if python else c for c in columns), strict=True))
        assert len(rows) > count / 4, called.id
        left = 0
        for row, *wanted in zip(rows, *whole, strict=True):
            found = called.function(*row, **called.options)
            assert as_bytes(found, kind) == as_bytes(wanted, kind), (called.id, row)
            assert {type(each) for each in found} == {float if python else kind}
            left += of_numbers(called.signature, row) is None
        assert left <= LEFT * len(rows), called.id


def inside(called: Called) -> list[float]:
    return [float(column[0]) for column in fitting(called.signature, sample(called.signature, 40))]


def answer(called: Called, row: Sequence[Any], **options: Any) -> Any:
    """What comes back, with its types, or what is raised."""
    try:
        found = called.function(*row, **called.options, **options)
    except (TypeError, ValueError) as error:
        return type(error), str(error)
    return type(found), [(type(each), np.asarray(each).tobytes()) for each in found]


ODD: tuple[Any, ...] = (
    *(float("nan"), float("inf"), -float("inf"), 0.0, -0.0, 0, 5e-324, -5e-324, 1e308, -1e308),
    *(1, 2, -1, 3, 2**53 + 1, 2**63, 2**64 - 1, 2**64, 10**400, -(2**63), -(2**63) - 1, 0.5, 2.5),
    *(True, False, None, "1", "x", b"1", 1j, Decimal(1), Fraction(1, 2), object, [1.0], [], ()),
    *(np.bool_(True), np.float16(1), np.longdouble(1), np.complex128(1), np.timedelta64(1, "s")),
    *(np.int8(1), np.uint64(2**64 - 1), np.int64(2**62 + 1), np.float32(0.5), np.float64(0.5)),
    *(np.float32("nan"), np.float64("inf"), np.array(0.5), np.array([0.5]), np.ma.masked),
    *(np.ma.array(0.5, mask=True), np.str_("x"), np.datetime64("nat")),
)


SIZES = (1e-45, 1e-38, -1e-30, 1e-20, 1e-6, 1e-3, 0.9, 1.0, 1.5, 1e3, -1e5, 1e9, 1e17, 1e30, 3e38)
"""Of float32 numbers, whose domains have other ends."""


class Own(float):
    """A type of a user's own."""


@pytest.mark.parametrize("module", MODULES)
def test_what_is_odd_is_answered_as_arrays_answer(module: str) -> None:
    """With a second thread nothing goes the way of numbers."""
    for called in kernels(module):
        row = inside(called)
        for place, odd in itertools.product(range(len(row)), (*ODD, Own(row[0]), Own(-1.0))):
            given = [*row[:place], odd, *row[place + 1 :]]
            assert answer(called, given) == answer(called, given, workers=2), (called.id, given)
        rows = [[odd] * len(row) for odd in ODD]
        with np.errstate(over="ignore"):
            single = [np.float32(x) for x in row]
        for place, size in itertools.product(range(len(row)), SIZES):
            rows.append([*single[:place], np.float32(size), *single[place + 1 :]])
        for given in rows:
            assert answer(called, given) == answer(called, given, workers=2), (called.id, given)


@pytest.mark.parametrize("module", MODULES)
def test_options_are_looked_at(module: str) -> None:
    for called in kernels(module):
        row = inside(called)
        for wrong in (0, -1, 1.0, "1", None, 1.5):
            said = answer(called, row, workers=wrong)
            assert said[0] is ValueError
            assert "workers must be a whole number of threads" in said[1]
        for fine in (True, 1, 3, np.int64(1)):
            assert answer(called, row, workers=fine) == answer(called, row)
        assert answer(called, row, out=())[0] is ValueError
        out = tuple(np.empty(()) for _ in called.signature.outputs)
        found = called.function(*row, out=out, **called.options)
        assert all(a is b for a, b in zip(found, out, strict=True))
        plain = called.function(*row, **called.options)
        assert as_bytes(found, np.float64) == as_bytes(plain, np.float64)


@pytest.mark.parametrize("module", MODULES)
def test_types(module: str) -> None:
    """Python's numbers give Python's; one of NumPy's among them makes all NumPy's."""
    for called in kernels(module):
        row = inside(called)
        several = len(row) > 1
        for first, rest, kind in (
            (float, float, float),
            (np.float64, float, np.float64),
            (np.float64, np.float64, np.float64),
            (np.float32, np.float32, np.float32),
            (np.float32, float, np.float64 if several else np.float32),
            (lambda x: np.array(x, np.float32), np.float32, np.float32),
        ):
            given = [first(row[0]), *map(rest, row[1:])]
            try:
                found = called.function(*given, **called.options)
            except ValueError:  # not in the domain of float32
                assert kind is not float
                continue
            assert {type(each) for each in found} == {kind}, (called.id, given)


def test_integers_are_rounded_once_as_arrays_round_them() -> None:
    from gainproof.generated.random_acceleration import gains

    for whole in (1, 2**53 + 1, 2**62 + 2**9 + 1, 2**63 - 1, 2**63 + 2**10 + 1, 2**64 - 1):
        for other in (np.array(whole), np.array([whole]), float(whole)):
            assert as_bytes(gains(whole), np.float64) == as_bytes(gains(other), np.float64)
    with pytest.raises(TypeError, match="integers of at most 64 bits, got a larger one"):
        gains(2**64)


@pytest.mark.parametrize("module", MODULES)
def test_no_warning_of_numpy_escapes(module: str) -> None:
    """Whatever its user has asked NumPy for, and what was asked is as it was."""
    for called, kind in itertools.product(kernels(module), KINDS):
        columns = points(called.signature, kind, 40, seed=9)
        for state in ("warn", "raise"):
            with warnings.catch_warnings(), np.errstate(all=state):
                warnings.simplefilter("error")
                before = np.geterr()
                for row in zip(*columns, strict=True):
                    found = called.function(*row, **called.options)
                    assert not np.isnan(found).any()
                    if kind is np.float64:
                        called.function(*map(float, row), **called.options)
                assert np.geterr() == before
