"""What the kernels of converted measurements should return, by the oracle; and their sums of terms.

In the plane the elevation and its noise are 0.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from typing import Any

import flint
from polar_points import signature
from signed_graphs import with_terms

from gainproof.derive.sensors.converted_measurements import graphs
from gainproof.generated import converted_measurements
from gainproof.verify.oracles import converted_enclosure
from gainproof.verify.oracles.converted_enclosure import BITS, Moments

Values = Mapping[str, flint.arb]
Vector = list[flint.arb]
PLANE = "_in_plane"
NAMES = ("classical", "debiased", "unbiased", "modified_unbiased")
KERNELS = [f"{name}_conversion{where}" for name in NAMES for where in ("", PLANE)]
CORRELATED = [f"correlated_{name}_conversion_in_plane" for name in NAMES[2:]]
PAIRS = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))


def arguments(kernel: str) -> list[str]:
    """The names of a kernel's arguments in order."""
    return [domain.name for domain in signature(getattr(converted_measurements, kernel)).inputs]


def conversion(name: str, polar: Vector, deviations: Vector) -> Moments:
    """Place and covariance that a conversion should state for a measurement."""
    if name == "classical":
        return converted_enclosure.first_order(polar, deviations)
    with flint.ctx.workprec(BITS):
        given = converted_enclosure.given_measurement(polar, deviations)
        if name == "modified_unbiased":
            return given
        measured = converted_enclosure.place_of(polar)
        if name == "debiased":
            found = converted_enclosure.averaged(polar, deviations)
            place = [a - b for a, b in zip(measured, found.mean, strict=True)]
            return Moments(place, found.covariance)
        # what noise leaves of any place ahead and of its height
        at = [flint.arb(1), flint.arb(1), flint.arb(0)]
        (ahead, _, up), mean = (
            converted_enclosure.place_of(at),
            converted_enclosure.given_truth(at, deviations).mean,
        )
        shares = mean[0] / ahead, mean[0] / ahead, mean[2] / up
        place = [value / share for value, share in zip(measured, shares, strict=True)]
        bias = [a - b for a, b in zip(place, given.mean, strict=True)]
        return Moments(
            place,
            [[given.covariance[i][j] + bias[i] * bias[j] for j in range(3)] for i in range(3)],
        )


def truth(kernel: str) -> Callable[..., Values]:
    """The outputs of a kernel, from its arguments."""
    name, plane = kernel.removesuffix(PLANE).removesuffix("_conversion"), kernel.endswith(PLANE)

    def found(*given: float) -> Values:
        values = {
            entry: flint.arb(value) for entry, value in zip(arguments(kernel), given, strict=True)
        }
        zero = flint.arb(0)
        polar = [values.get(entry, zero) for entry in ("slant_range", "elevation", "azimuth")]
        noise = ("range_deviation", "elevation_deviation", "azimuth_deviation")
        deviations = [values.get(entry, zero) for entry in noise]
        here = conversion(name, polar, deviations)
        outputs = dict(zip("xyz", here.mean, strict=True))
        outputs |= {f"covariance_{'xyz'[i]}{'xyz'[j]}": here.covariance[i][j] for i, j in PAIRS}
        if plane:
            ahead = conversion(name, [polar[0], zero, zero], deviations).covariance
            outputs |= {"radial_variance": ahead[0][0], "cross_variance": ahead[1][1]}
        return outputs

    return found


def correlated(kernel: str) -> Callable[..., Values]:
    """The same of a kernel of correlated noises, which are to be of at most half a radian."""

    def found(*given: float) -> Values:
        r, a, sr, sa, rho = (flint.arb(value) for value in given)
        count = 30
        here = converted_enclosure.correlated((r, a), (sr, sa), rho, -1, count)
        if kernel.startswith("correlated_modified"):
            place, off = here.mean, [flint.arb(0), flint.arb(0)]
        else:
            # at azimuth 0 the mean of the measured place should be moved to the true one
            with flint.ctx.workprec(BITS):
                there = converted_enclosure.correlated((r, 0), (sr, sa), rho, 1, count).mean
                kept, beside = there[0] / r, there[1]
                turn = flint.acb(0, a).exp() * flint.acb(r, -beside / kept) / kept
                place = [turn.real, turn.imag]
                off = [p - m for p, m in zip(place, here.mean, strict=True)]
        (xx, xy), (_, yy) = here.covariance
        with flint.ctx.workprec(BITS):
            return {
                "x": place[0],
                "y": place[1],
                "covariance_xx": xx + off[0] ** 2,
                "covariance_xy": xy + off[0] * off[1],
                "covariance_yy": yy + off[1] ** 2,
            }

    return found


def terms(kernel: str) -> Callable[..., Values]:
    """The sums of terms taken positive: every sum in the graph over the magnitudes of its terms."""
    graph = graph_of(kernel)

    def found(*given: float) -> Values:
        point = dict(zip(arguments(kernel), given, strict=True))
        return {name: total for name, (_, total) in with_terms(graph, point).items()}

    return found


@cache
def graph_of(kernel: str) -> Any:
    """The graph from which a kernel is printed."""
    return graphs()[kernel]
