"""What the kernels of two stations should return, from what one station sees; and their terms."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial

import flint
from sight_truth import Values, axes_of, terms, truth

from gainproof.verify.oracles import range_and_rate

PAIRS = ("bistatic_range_doppler", "range_doppler_difference")


def is_pair(kernel: str) -> bool:
    """Whether a kernel has two stations."""
    return kernel.startswith(PAIRS)


def pair_truth(kernel: str) -> Callable[..., Mapping[str, flint.arb]]:
    """Sums or differences of what the two stations see."""
    return partial(_combined, kernel, -1 if "difference" in kernel else 1)


def _combined(kernel: str, sign: int, *given: float) -> Values:
    single = truth(_single(kernel))
    one, other = (single(*motion) for motion in _sights(kernel, given))
    with flint.ctx.workprec(range_and_rate.BITS):
        return {_named(kernel, name): value + sign * other[name] for name, value in one.items()}


def pair_terms(kernel: str) -> Callable[..., Mapping[str, flint.arb]]:
    """The terms of the printed formulas, taken positive, from the oracle's values."""
    return partial(_difference_terms if "difference" in kernel else _sum_terms, kernel)


def _sum_terms(kernel: str, *given: float) -> Values:
    values, sizes = truth(_single(kernel)), terms(_single(kernel))
    found: Values = {}
    with flint.ctx.workprec(range_and_rate.BITS):
        for motion in _sights(kernel, given):
            one = {name: abs(value) for name, value in values(*motion).items()}
            for name, size in (one | dict(sizes(*motion))).items():
                found[_named(kernel, name)] = found.get(_named(kernel, name), flint.arb(0)) + size
    return found


def _difference_terms(kernel: str, *given: float) -> Values:
    axes = axes_of(kernel)
    first, second = _sights(kernel, given)
    single, sizes = truth(_single(kernel)), terms(_single(kernel))
    one, other, bent = single(*first), single(*second), sizes(*second)
    with flint.ctx.workprec(range_and_rate.BITS):
        (baseline, drift), (near, _), (far, fast) = (
            _apart(a, b, len(axes))
            for a, b in (
                (second[2 * len(axes) :], first[2 * len(axes) :]),
                (first[: 2 * len(axes)], first[2 * len(axes) :]),
                (second[: 2 * len(axes)], second[2 * len(axes) :]),
            )
        )
        reach = [a + b for a, b in zip(near, far, strict=True)]
        size = one["slant_range"]
        apart = _dot(baseline, reach) / (size + other["slant_range"])
        u, v = ([abs(each[f"range_D_{axis}"]) for axis in axes] for each in (one, other))
        units = [(s + apart * b) / size for s, b in zip(baseline, v, strict=True)]
        rates = _dot(u, drift) + _dot(units, fast)
        found = {"range_difference": apart, "range_rate_difference": rates}
        for axis, d, a, e in zip(axes, drift, u, units, strict=True):
            found[f"range_difference_D_{axis}"] = e
            turned = bent["range_rate"] * e + apart * bent[f"range_rate_D_{axis}"]
            found[f"range_rate_difference_D_{axis}"] = (d + rates * a + turned) / size
    return found


def _apart(
    one: Sequence[float], other: Sequence[float], count: int
) -> tuple[list[flint.arb], list[flint.arb]]:
    """Magnitudes of the differences of positions and of velocities."""
    entries = [abs(flint.arb(a) - flint.arb(b)) for a, b in zip(one, other, strict=True)]
    return entries[:count], entries[count:]


def _dot(one: Sequence[flint.arb], other: Sequence[flint.arb]) -> flint.arb:
    return sum((a * b for a, b in zip(one, other, strict=True)), flint.arb(0))


def _sights(kernel: str, given: Sequence[float]) -> list[tuple[float, ...]]:
    """The arguments of a kernel of one station, for each of the two."""
    part = 2 * len(axes_of(kernel))
    target, first, second = (tuple(given[part * n : part * (n + 1)]) for n in range(3))
    return [target + first, target + second]


def _single(kernel: str) -> str:
    return "range_doppler_in_plane" if kernel.endswith("_in_plane") else "range_doppler"


def _named(kernel: str, name: str) -> str:
    """The sum or the difference of a quantity."""
    what, mark, by = name.partition("_D_")
    if "difference" in kernel:
        word = {"slant_range": "range", "range": "range", "range_rate": "range_rate"}[what]
        return f"{word}_difference{mark}{by}"
    rate = "_rate" if what == "range_rate" else ""
    return f"bistatic_range{rate}{mark}{by}"
