"""The kernels of position and velocity measured against enclosed truth, which knows no formula.

The balls are proved to contain the steady state, so that the kernels' own stated bound is the
tolerance: nothing is added to it.
"""

from __future__ import annotations

import importlib
import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cache
from itertools import product
from typing import Any

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from kernel_truth import STEADY_STATES
from one_of_each import cases
from samples import samples

from gainproof.position_velocity.process_noise import PROCESS_NOISES
from gainproof.verify.oracles import distance, enclosure
from gainproof.verify.oracles import position_velocity as oracle

NAMES = ("gains", "predicted_covariance", "updated_covariance")
EPSILON = {"float64": Fraction(1, 2**52), "float32": Fraction(1, 2**23)}
WHITE = "continuous-white-acceleration"
HALF_DECADES = [10.0 ** (step / 2) for step in range(-12, 13)]
ORDINARY = st.floats(-6, 6).map(lambda e: 10.0**e)
SHARE = st.floats(0, 1)


@cache
def promises(module: Any, name: str, dtype: str) -> Mapping[str, Fraction]:
    """The relative error that the docstring of a kernel states for each output."""
    text = re.sub(r"\s+", " ", getattr(module, name).__doc__)
    digits = {"float64": 52, "float32": 23}[dtype]
    stated = {}
    for output in getattr(module, f"_{name.upper()}").outputs:
        found = re.search(
            rf" {output}: [^:]*?Relative error at most [^:]*?([.\d]+) \* 2\^-{digits} \({dtype}\)"
            r"[^:]*? proved for every input\.",
            text,
        )
        assert found is not None, f"{name} states no error of {output} in {dtype}"
        stated[output] = Fraction(found.group(1)) * EPSILON[dtype]
    return stated


def printed(process_noise: str) -> Any:
    return importlib.import_module(f"gainproof.generated.{PROCESS_NOISES[process_noise].both}")


def truth(process_noise: str, index: float, ratio: float) -> Mapping[str, Any]:
    noise = STEADY_STATES[process_noise.replace("-", "_")]["process_noise"]
    return oracle.named(enclosure.enclose(oracle.model(noise, index, ratio), 30))


def broken(process_noise: str, index: Any, ratio: Any, dtype: str = "float64") -> Iterator[str]:
    """What is not certain to be within the stated bound, in words."""
    module, true = printed(process_noise), truth(process_noise, float(index), float(ratio))
    for name in NAMES:
        stated = promises(module, name, dtype)
        for output, value in getattr(module, name)(index, ratio)._asdict().items():
            assert np.asarray(value).dtype == dtype
            if not distance.within(float(value), true[output], stated[output]):
                error = distance.relative_error(float(value), true[output])
                yield f"{name}.{output} at {index!r}, {ratio!r}: {error}"


@pytest.mark.parametrize("process_noise", sorted(PROCESS_NOISES))
@settings(max_examples=samples(4), deadline=None)
@given(index=ORDINARY, ratio=ORDINARY)
def test_within_the_stated_bound(process_noise: str, index: float, ratio: float) -> None:
    assert not list(broken(process_noise, index, ratio))


@pytest.mark.parametrize(
    ("process_noise", "dtype"),
    cases(
        product(sorted(PROCESS_NOISES), sorted(EPSILON)),
        lambda case: case[0] == WHITE or case[1] == "float64",
    ),
)
@settings(max_examples=samples(4), deadline=None)
@given(shares=st.tuples(SHARE, SHARE))
@example(shares=(0.0, 0.0))
@example(shares=(0.0, 1.0))
@example(shares=(1.0, 0.0))
@example(shares=(1.0, 1.0))
def test_within_the_stated_bound_over_the_whole_domain(
    process_noise: str, dtype: str, shares: tuple[float, float]
) -> None:
    index, ratio = (
        within(ends, share, dtype)
        for ends, share in zip(domain(process_noise, dtype), shares, strict=True)
    )
    assert not list(broken(process_noise, index, ratio, dtype))


def domain(process_noise: str, dtype: str) -> list[tuple[float, float]]:
    """The ends of both inputs that every kernel takes."""
    signatures = [getattr(printed(process_noise), f"_{name.upper()}") for name in NAMES]
    sides = [
        [given.double if dtype == "float64" else given.single for given in signature.inputs]
        for signature in signatures
    ]
    return [
        (max(low for low, _ in each), min(high for _, high in each))
        for each in zip(*sides, strict=True)
    ]


def within(ends: tuple[float, float], share: float, dtype: str) -> Any:
    """A number of the format so far on the logarithmic way between two ends."""
    low, high = ends
    kind = np.dtype(dtype).type
    return kind(np.clip(kind(low * (high / low) ** share), kind(low), kind(high)))


@pytest.mark.parametrize(
    "process_noise", cases(sorted(PROCESS_NOISES), lambda noise: noise == WHITE)
)
def test_within_the_stated_bound_on_the_half_decade_grid(process_noise: str) -> None:
    """25 x 25 points from 1e-6 to 1e6; every third of them each way, the ends included."""
    every_third = HALF_DECADES[::3]
    assert every_third[0] == 1e-6
    assert every_third[-1] == 1e6
    assert not [
        text
        for index in every_third
        for ratio in every_third
        for text in broken(process_noise, index, ratio)
    ]


def test_a_kernel_of_another_noise_is_refuted(monkeypatch: pytest.MonkeyPatch) -> None:
    wrong = dict.fromkeys(PROCESS_NOISES, PROCESS_NOISES["random-acceleration"])
    monkeypatch.setattr(f"{__name__}.PROCESS_NOISES", wrong)
    assert len(list(broken("continuous-white-acceleration", 1.0, 1.0))) == 10


def test_an_argument_off_by_its_last_places_is_refuted(monkeypatch: pytest.MonkeyPatch) -> None:
    """The bound is that tight: 40 units in the last place of the index are seen."""
    true = truth("continuous-white-acceleration", 1.0, 1.0)
    monkeypatch.setattr(f"{__name__}.truth", lambda *_: true)
    found = list(broken("continuous-white-acceleration", 1.0 + 40 * 2.0**-52, 1.0))
    assert any("predicted_22" in text for text in found)


@pytest.mark.parametrize("process_noise", sorted(PROCESS_NOISES))
def test_the_domain_holds_what_the_figures_ask(process_noise: str) -> None:
    for low, high in domain(process_noise, "float64"):
        assert low <= 1e-6
        assert high >= 1e6
