"""The process noises and graphs of the recursion: what is read off, what is refused."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
import sympy as sp

from gainproof.derive.recursion import kernels, two_states
from gainproof.derive.recursion.noise import NoiseError, T, noises, through

NUMBERS: dict[str, tuple[Any, ...]] = {
    "random_velocity": (0, 0, 0, 1),
    "random_acceleration": ("1/2", 2, 0, "1/4"),
    "continuous_white_acceleration": ("1/2", 1, "1/12", "1/3"),
}


def test_numbers_of_the_noises() -> None:
    found = {each.name: (each.share, each.power, each.floor, each.chord) for each in noises()}
    wanted: dict[str, object] = {
        name: tuple(Fraction(x) for x in each) for name, each in NUMBERS.items()
    }
    assert found == wanted


@pytest.mark.parametrize("shape", [[T, 1], [1, T], [T**2 / 3, T], [T**2, T], [T / 2, 1 + T]])
def test_other_noises_are_refused(shape: list[Any]) -> None:
    with pytest.raises(NoiseError, match="no shear of 0 or half the interval"):
        through("other", "", "", sp.ImmutableDenseMatrix([[x] for x in shape]))


def test_no_kernel_subtracts_what_was_computed() -> None:
    """hand_over has the exact difference 1 - alpha; the others have no minus sign at all."""
    for name, graph in kernels.graphs(noises()).items():
        negated = [node for node in graph["nodes"] if node[0] == "neg"]
        numbers = [node for node in graph["nodes"] if node[0] == "number"]
        assert len(negated) == (name == "hand_over"), name
        assert not any(str(node[1]).startswith("-") for node in numbers)


def test_every_step_of_the_page_is_of_a_tower() -> None:
    subject = two_states.build()
    assert {step.tower for step in subject.derivation.steps} == set(subject.towers)
    assert [kernel.name for kernel in subject.module.kernels] == list(subject.programs)
