"""Each model of the catalogue against its physical description, integrated numerically.

A wrong shared model would pass every other test, since kernels, proofs and oracles all start
from it.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from catalogue_subjects import derived

from gainproof.derive.catalogue import CATALOGUE
from gainproof.verify.oracles import noise
from gainproof.verify.oracles.matrices import Matrix, product, transpose
from gainproof.verify.oracles.multiprecision import fraction

Models = dict[str, dict[str, Any]]
MOTION, DRIVE = noise.chain(2)

# what each family's name says of the acceleration, in the words of the physical noise
DESCRIPTIONS: dict[str, Matrix] = {
    "random-velocity": noise.increment(DRIVE),
    "random-acceleration": noise.held(MOTION, DRIVE),
    "continuous-white-acceleration": noise.white(MOTION, DRIVE),
}
# the process noise does not know what is measured, nor how its gains are updated
DESCRIPTIONS |= {
    "updated-gains": DESCRIPTIONS["random-acceleration"],
    "position-velocity": DESCRIPTIONS["continuous-white-acceleration"],
    "position-velocity-random-acceleration": DESCRIPTIONS["random-acceleration"],
    "position-velocity-random-velocity": DESCRIPTIONS["random-velocity"],
}
TRIPLE_MOTION, TRIPLE_DRIVE = noise.chain(3)
# a jump before the state moves is carried through the interval
CARRY = noise.transition(TRIPLE_MOTION)
JUMP = noise.increment(TRIPLE_DRIVE)
# what each family's name says of the jerk, or of jumps of the acceleration
TRIPLE_DESCRIPTIONS: dict[str, Matrix] = {
    "acceleration-increments": JUMP,
    "wiener-acceleration": product(CARRY, JUMP, transpose(CARRY)),
    "random-jerk": noise.held(TRIPLE_MOTION, TRIPLE_DRIVE),
    "continuous-white-jerk": noise.white(TRIPLE_MOTION, TRIPLE_DRIVE),
}
DESCRIPTIONS |= TRIPLE_DESCRIPTIONS


@pytest.fixture(scope="module")
def models() -> Models:
    found = {entry.name: derived(entry.name).model for entry in CATALOGUE}
    return {name: model for name, model in found.items() if model is not None}


def test_every_model_of_the_catalogue_is_described(models: Models) -> None:
    assert set(models) == set(DESCRIPTIONS)


@pytest.mark.parametrize("name", sorted(DESCRIPTIONS))
def test_process_noise_is_the_integrated_one(name: str, models: Models) -> None:
    assert apart(models[name], DESCRIPTIONS[name]) < Fraction(1, 10**38)


@pytest.mark.parametrize("name", sorted(DESCRIPTIONS))
def test_no_other_description_fits(name: str, models: Models) -> None:
    for described in DESCRIPTIONS.values():
        if described is not DESCRIPTIONS[name] and len(described) == len(DESCRIPTIONS[name]):
            assert apart(models[name], described) > Fraction(1, 20)


@pytest.mark.parametrize("name", sorted(DESCRIPTIONS))
def test_the_transition_is_the_exponential_of_the_motion(name: str, models: Models) -> None:
    exponential = CARRY if name in TRIPLE_DESCRIPTIONS else noise.transition(MOTION)
    for row, known in zip(models[name]["transition"], exponential, strict=True):
        for text, value in zip(row, known, strict=True):
            assert abs(Fraction(text) - number(value)) < Fraction(1, 10**38)


def apart(model: dict[str, Any], described: Matrix) -> Fraction:
    return max(
        abs(Fraction(text) - number(value))
        for row, known in zip(model["process_noise"], described, strict=True)
        for text, value in zip(row, known, strict=True)
    )


def number(value: Any) -> Fraction:
    return value if isinstance(value, Fraction) else fraction(value)
