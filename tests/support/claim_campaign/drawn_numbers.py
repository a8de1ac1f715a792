"""Numbers drawn for a point: parameters of settings, and those of free symbols."""

from __future__ import annotations

from fractions import Fraction
from random import Random

from gainproof.verify.judge.claim.record import Setting

INDICES = tuple(
    map(Fraction, ["1/1000", "1/50", "1/7", "1/3", "1", "5/2", "17/3", "9", "50", "3000"])
)
LATER = (0, 1, 2, 3, 4, 5, 7, 9, 12, 17, 50, 1000, 12345)


def parameter(setting: Setting, random: Random) -> Fraction:
    """A tracking index, or the number of a sample."""
    match setting.kind:
        case "steady_state":
            return random.choice(INDICES)
        case "growing_memory":
            return Fraction((setting.degree or 0) + random.choice(LATER))
        case _:
            return Fraction(random.randrange(30))


def small(random: Random) -> Fraction:
    """A positive number of the size of one."""
    return Fraction(random.randrange(1, 12), random.randrange(1, 6))


def any_number(random: Random, integer: bool) -> Fraction:
    """Any number, most of them positive."""
    if integer:
        return Fraction(random.randrange(-3, 30))
    below = random.randrange(2, 40)
    match random.randrange(6):
        case 0:
            return Fraction(random.randrange(1, below), below)
        case 1:
            return Fraction(random.randrange(1, 5 * below), below)
        case 2:
            return Fraction(random.randrange(1, 10))
        case 3:
            return -Fraction(random.randrange(1, 5 * below), below)
        case 4:
            return Fraction(random.randrange(10, 1000))
        case _:
            return Fraction(1, random.randrange(10, 1000))
