"""Discs of the closed-loop poles against exact roots.

The oracle is python-flint: the characteristic polynomial of the floats in integers, its roots with
their multiplicities isolated in balls. It shares no arithmetic with what is tested.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import permutations
from math import lcm
from typing import Any

import numpy as np
import pytest
from flint import acb, arb, ctx, fmpz_poly
from numpy.typing import NDArray
from samples import samples

from gainproof.fixed_gain import cubic_discs, cubic_roots
from gainproof.fixed_gain.pole_discs import BLOCK, PoleDiscs, pole_discs
from gainproof.fixed_gain.twofold import Twofold

Gains = tuple[NDArray[Any], ...]
DIGITS = 2600
"""Binary ones: 1 and the smallest float side by side."""


def steps_of_poles(gains: tuple[float, ...]) -> list[acb]:
    """z - 1 of the true poles: roots of u^3 + (a + b + c/2) u^2 + (b + 3 c/2) u + c."""
    a, b, c = map(Fraction, gains)
    exact = [c, b + 3 * c / 2, a + b + c / 2, Fraction(1)]
    common = lcm(*(x.denominator for x in exact))
    whole = fmpz_poly([int(x * common) for x in exact])
    found: Any = whole.complex_roots()  # pairs of a root and how many times it stands
    return [root for root, times in found for _ in range(times)]


def held(true: list[acb], centres: Any, radii: Any) -> bool:
    """Whether one numbering puts each true root into its disc, for certain."""
    inside = [
        [bool(abs(z - acb(c.real, c.imag)) <= arb(float(r))) for z in true]
        for c, r in zip(centres, radii, strict=True)
    ]
    return any(all(inside[i][k] for i, k in enumerate(order)) for order in permutations(range(3)))


def outside(gains: Gains, found: PoleDiscs) -> list[tuple[float, ...]]:
    """Gains of which a pole is not in its disc."""
    missed = []
    before = ctx.prec
    ctx.prec = DIGITS
    try:
        for i, each in enumerate(zip(*(gain.tolist() for gain in gains), strict=True)):
            steps = steps_of_poles(each)
            fine = held(steps, found.less_one[i], found.less_one_radii[i])
            if not (fine and held([u + 1 for u in steps], found.poles[i], found.radii[i])):
                missed.append(each)
    finally:
        ctx.prec = before
    return missed


def of_steps(x: Any, y: Any, z: Any) -> Gains:
    """Gains with the roots x, y, z of u, as float64 rounds them."""
    gamma = -x * y * z
    beta = x * y + y * z + z * x - 1.5 * gamma
    return -(x + y + z) - beta - gamma / 2, beta, gamma


def kinds(count: int) -> Iterator[tuple[str, float, Gains]]:
    """Name, largest share of the largest |z - 1| (or of 1) that a radius may be, gains."""
    rng = np.random.default_rng(6)
    plain, double, triple = 2.0**-52, 4e-14, 1e-9

    def sign() -> NDArray[np.float64]:
        return rng.choice([-1.0, 1.0], count)

    def power(low: float, high: float) -> NDArray[np.float64]:
        return np.asarray(10 ** rng.uniform(low, high, count))

    yield "stable and not", plain, tuple(rng.uniform(0, most, count) for most in (2, 4, 8))
    yield "of both signs", plain, tuple(rng.normal(0, 3, count) for _ in range(3))
    yield "tiny", plain, tuple(power(-12, 0) ** k for k in (1, 2, 3))
    yield "of any size", plain, tuple(power(-30, 2) for _ in range(3))
    yield "huge and least", plain, tuple(sign() * power(-300, 100) for _ in range(3))
    yield "subnormal", triple, tuple(sign() * power(-323, -290) for _ in range(3))
    alpha = rng.uniform(0, 2, count)
    beta = (4 - 2 * alpha) * rng.uniform(0, 1, count)
    yield "border at -1", plain, (alpha, 4 - 2 * alpha, alpha * rng.uniform(0, 2, count))
    yield "border of gamma", plain, (alpha, beta, alpha * beta / (1 - alpha / 2))
    yield "whole numbers", double, tuple(rng.integers(-4, 5, count) + 0.0 for _ in range(3))
    u, v = -rng.uniform(0, 1, count), rng.uniform(-2, 0, count)
    near = power(-17, -1)
    yield "threefold, rounded", 1e-14, of_steps(u, u, u)
    yield "nearly threefold", 1e-14, of_steps(u, u * (1 + near), u * (1 - near))
    yield "twofold, rounded", double, of_steps(u, u, v)
    k, w = -rng.integers(1, 65, count) / 64, rng.integers(-64, 65, count) / 32
    yield "threefold", triple, of_steps(k, k, k)
    few = [x + rng.integers(-3, 4, count) * 2.0 ** -rng.integers(45, 56) for x in of_steps(k, k, k)]
    yield "a few units from threefold", triple, tuple(few)
    split = 2.0 ** -rng.integers(1, 27, count)
    yield "split threefold", double, of_steps(k, k - split, k + split)
    yield "between twofold and threefold", triple, of_steps(k, k, k + split * split)
    yield "twofold", triple, of_steps(k, k, w)
    yield "one at 1", double, of_steps(k, 0 * k, w)
    yield "of unlike sizes", plain, of_steps(*(-power(-40, 0) for _ in range(3)))


KINDS = {name: (limit, gains) for name, limit, gains in kinds(samples(12))}


@pytest.mark.sampled
@pytest.mark.parametrize("name", KINDS)
def test_true_poles_are_in_their_discs(name: str) -> None:
    limit, gains = KINDS[name]
    found = pole_discs(*gains)
    assert outside(gains, found) == []
    size = np.abs(found.less_one).max(axis=-1, keepdims=True)
    allowed = np.where(size > 0, limit * size + 2.0**-1060, 1e-100)
    assert (found.less_one_radii <= allowed).all()
    assert (found.radii <= limit * np.maximum(size, 1)).all()


def test_smaller_discs_are_seen_to_miss() -> None:
    gains = KINDS["stable and not"][1]
    found = pole_discs(*gains)
    less = found._replace(radii=found.radii * 0.98)
    assert len(outside(gains, less)) > len(gains[0]) // 2
    less = found._replace(less_one_radii=found.less_one_radii * 0.98)
    assert len(outside(gains, less)) > len(gains[0]) // 2


@pytest.mark.parametrize("shift", [0.0, 1e-30, 1e-16, 1e-9, 1e-3, 1.0, 1e300, np.nan, np.inf])
def test_radii_hold_whatever_stands_for_the_roots(
    shift: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The proof uses nothing of how roots were found: also roots that are spoilt are enclosed."""

    def spoilt(cubic: cubic_roots.Cubic) -> cubic_roots.Roots:
        found = cubic_roots.roots(cubic)
        moved = (found.single + shift, found.first + shift * 0.7, found.second + shift * -0.3)
        single, first, second = map(cubic_roots._finite, moved)
        return cubic_roots.Roots(single, found.real, first, second)

    monkeypatch.setattr("gainproof.fixed_gain.pole_discs.roots", spoilt)
    with np.errstate(all="ignore"):
        for name in ("stable and not", "threefold", "one at 1"):
            gains = KINDS[name][1]
            found = pole_discs(*gains)
            assert np.isfinite(found.radii).all()
            assert outside(gains, found) == []


def test_threefold_poles_that_floats_hold_are_exact() -> None:
    for pole in (0.0, 0.5, 0.75):
        step = pole - 1
        found = pole_discs(*of_steps(step, step, step))
        assert (found.poles == pole).all()
        assert (found.less_one == step).all()
        assert (found.radii < 3e-10 * -step).all()


@pytest.mark.parametrize(
    "gains",
    [
        (1.0, 1.4999999999999996, 0.9999999999999991),
        (0.999176025390609, 1.3474273681630065, 0.7442932128891311),
    ],
)
def test_no_step_of_newton_leaves_roots_that_agree(gains: tuple[float, float, float]) -> None:
    """Poles apart by less than a cube root of the last digit: slope and residual are noise."""
    found = pole_discs(*gains)
    assert (found.radii < 1e-9).all()
    assert (
        outside(tuple(np.array([gain]) for gain in gains), pole_discs(*([gain] for gain in gains)))
        == []
    )


def test_gains_of_nothing_have_three_poles_at_1() -> None:
    found = pole_discs(0, 0, 0)
    assert (found.poles == 1).all()
    assert (found.less_one == 0).all()
    assert (found.less_one_radii < 1e-100).all()


def test_blocks_shapes_and_order() -> None:
    rng = np.random.default_rng(1)
    gamma = rng.uniform(0, 1, (3, BLOCK // 2))
    found = pole_discs(0.5, 0.25, gamma)
    assert found.poles.shape == found.radii.shape == (3, BLOCK // 2, 3)
    single = pole_discs(0.5, 0.25, gamma[2, 5])
    for whole, each in zip(found, single, strict=True):
        assert (whole[2, 5] == each).all()
    moduli = np.abs(found.poles)
    assert (np.diff(moduli, axis=-1) <= 0).all()
    assert [each.shape for each in pole_discs(np.empty(0), 1, 1)] == [(0, 3)] * 4
    assert not np.signbit(pole_discs(2, 1, 0.0).poles.imag).any()


def test_double_roots_at_zero_are_no_division_by_zero() -> None:
    cubic = cubic_roots.Cubic(*(Twofold.of(np.array([x])) for x in (0.5, 0.0, 0.0)))
    with np.errstate(all="ignore"):
        found = cubic_roots.roots(cubic)
        radii = cubic_discs.radii(cubic, found)
    assert float(found.single.high[0]) == -0.5
    assert all(np.isfinite(radius).all() for radius in radii)


@pytest.mark.parametrize(
    ("gains", "error", "told"),
    [
        ((0.5, np.nan, 0.1), ValueError, "beta must be finite"),
        ((0.5, 0.1, 1e101), ValueError, "poles are computed for gains from -1e100 to 1e100"),
        (([0.5, 1.0], [0.1] * 3, 0.1), ValueError, "shapes do not fit"),
        (("a", 0.1, 0.1), TypeError, "alpha must be real numbers"),
    ],
)
def test_what_is_no_filter_is_refused(gains: Any, error: type[Exception], told: str) -> None:
    with pytest.raises(error, match=told):
        pole_discs(*gains)
