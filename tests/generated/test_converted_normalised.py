"""Normalised errors of conversions under each condition, and definite covariances: small draws."""

from __future__ import annotations

import math
from fractions import Fraction

import flint
import numpy as np
import pytest
import sympy as sp
from catalogue_subjects import subject
from converted_definite import definite, definite_correlated, is_definite
from converted_monte_carlo import Normalised, Scene, normalised
from samples import samples

from gainproof.verify.oracles import converted_enclosure

DEGREE = math.radians(1)
FLAT = Scene((400e3, 0.0, 0.7), (50.0, 0.0, DEGREE))
SPACE = Scene((100e3, 0.5, 0.7), (50.0, DEGREE, 2 * DEGREE))
NUMBERS = ((5000, 1), (2, 5), (120, 1), (1, 6), (1, 4), (3, 5), (-1, 2))
"""Range and elevation, deviations of range, elevation and azimuth, correlations with the range."""
ALLOWED = 5.0
"""Deviations: of sixteen comparisons one in 100,000 runs is beyond them."""


@pytest.mark.sampled
@pytest.mark.parametrize("scene", [FLAT, SPACE], ids=["flat", "space"])
def test_errors_are_as_large_as_expected(scene: Scene) -> None:
    for each in normalised(scene, samples(10_000), seed=3):
        assert each.off < ALLOWED, each


def expectations(scene: Scene) -> dict[tuple[str, str], Normalised]:
    return {(each.name, each.condition): each for each in normalised(scene, 4, seed=1)}


def test_what_is_expected() -> None:
    """Far away the classical covariance is by far too small; what the modified and the unbiased
    conversion state fits their squared errors, given the measurement exactly. In space the mean
    covariance of the debiased one lacks a product of both angles' noises.
    """
    flat, space = expectations(FLAT), expectations(SPACE)
    for found in (flat, space):
        for name in ("unbiased", "modified_unbiased"):
            assert found[name, "measurement"].expected == pytest.approx(1, abs=1e-9)
            assert found[name, "truth"].expected == pytest.approx(1, abs=1e-3)
    # to leading order a turn by t leaves -r t^2/2 along the line of sight: r^2 3/4 sigma^4 beside
    # sigma_r^2, of which the classical covariance knows nothing; across it is right
    radial = 0.75 * FLAT.place[0] ** 2 * DEGREE**4 / FLAT.deviations[0] ** 2
    for condition in ("truth", "measurement"):
        assert flat["classical", condition].expected == pytest.approx(1 + radial / 2, rel=1e-3)
        assert flat["debiased", condition].expected == pytest.approx(1, abs=1e-3)
        assert space["debiased", condition].expected == pytest.approx(1.1127, abs=1e-3)


@pytest.mark.sampled
def test_kernels_are_definite_where_printed_forms_are_not() -> None:
    for each in definite(samples(20_000), seed=4):
        assert each.axes == 1, each
        if each.name == "classical":  # no difference: ellipses that no entries can hold
            assert each.kernel == pytest.approx(each.printed, abs=0.005)
        else:
            assert each.kernel > 0.999, each
            assert each.printed < 0.98, each


@pytest.mark.sampled
def test_kernels_for_correlated_noises_are_definite() -> None:
    shares = definite_correlated(samples(20_000), seed=5)
    assert set(shares.values()) == {1.0}


def test_determinants_are_exact() -> None:
    """One more or less in the last place of one entry decides."""
    third = np.array([1 / 3])
    one, above = np.array([1.0]), np.array([1 / 3 + 2.0**-54])
    square = third * third  # 1/9 rounded down or up: not what xy^2 is
    assert is_definite((one, third, np.nextafter(square, 1))).all()
    assert not is_definite((one, third, np.nextafter(square, 0))).any()
    assert not is_definite((third, third, third)).any()
    assert is_definite((third, third, above)).all()
    assert not is_definite((-one, np.array([0.0]), -one)).any()


def test_moments_of_noises_correlated_in_space() -> None:
    """The derivation's closed forms at numbers, to 30 digits, and sums over all three noises."""
    r, e, sr, se, sa, up, around = (sp.Rational(*pair) for pair in NUMBERS)
    values = {
        "slant_range": r,
        "range_deviation": sr,
        "cos_elevation": sp.cos(e),
        "sin_elevation": sp.sin(e),
        "elevation_covariance": up * sr * se,
        "azimuth_covariance": around * sr * sa,
        "kept_azimuth": sp.exp(-(sa**2) / 2),
        "kept_elevation": sp.exp(-(se**2) / 2),
    }
    symbols = {sp.Symbol(name, real=True): value for name, value in values.items()}
    forms = subject("converted-measurements").towers["space_correlated"].expressions
    ahead, across, rising, aa, ac, cc, au, cu, uu = (
        forms[f"both_{entry}"].subs(symbols).n(60)
        for entry in ("ahead", "across", "up", "aa", "ac", "cc", "au", "cu", "uu")
    )
    wanted = [
        [aa - ahead * ahead, ac - ahead * across, au - ahead * rising],
        [ac - ahead * across, cc - across * across, cu - across * rising],
        [au - ahead * rising, cu - across * rising, uu - rising * rising],
    ]
    at, noises = [Fraction(*pair) for pair in NUMBERS[:2]], [Fraction(*p) for p in NUMBERS[2:5]]
    found = converted_enclosure.correlated_in_space(
        at, noises, [Fraction(*p) for p in NUMBERS[5:]], 24
    )
    with flint.ctx.workprec(300):
        for value, true in zip((ahead, across, rising), found.mean, strict=True):
            assert abs(flint.arb(str(value)) - true) < abs(true) * flint.arb(10) ** -30
        for row, true_row in zip(wanted, found.covariance, strict=True):
            for value, true in zip(row, true_row, strict=True):
                assert abs(flint.arb(str(value)) - true) < abs(true) * flint.arb(10) ** -30


def test_the_oracle_is_what_it_says() -> None:
    """Sums over one noise after the other are those over both at once, in the plane and in space;
    without noise nothing moves.
    """
    at, noises = (5000.0, 0.4, 0.0), (120.0, 0.2, 0.3)
    one = converted_enclosure.given_truth(at, noises)
    flat = converted_enclosure.given_truth((at[0], 0.0, 0.7), (noises[0], 0.0, noises[2]))
    plane = converted_enclosure.correlated((at[0], 0.7), (noises[0], noises[2]), 0.0, 1, 30)
    space = converted_enclosure.correlated_in_space(at[:2], noises, (0.0, 0.0), 24)
    still = converted_enclosure.given_measurement(at, (0.0, 0.0, 0.0))
    with flint.ctx.workprec(300):
        room = flint.arb(10) ** -25
        for first, second in ((flat, plane), (one, space)):
            size = len(second.mean)
            for i in range(size):
                assert abs(first.mean[i] - second.mean[i]) < room * at[0]
                for j in range(size):
                    off = first.covariance[i][j] - second.covariance[i][j]
                    assert abs(off) < room * at[0] ** 2
        for place, mean in zip(
            converted_enclosure.place_of([*map(flint.arb, at)]), still.mean, strict=True
        ):
            assert abs(place - mean) < room
        assert all(abs(value) < room for row in still.covariance for value in row)
