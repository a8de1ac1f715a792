"""Error bounds of kernels whose inputs have signs, or which call functions of a library.

No boxes: every step has a bound that holds on the whole domain. Of each step is known

- its reference, at least the magnitude of the true value: that of an input is its magnitude, of a
  product the product, of a sum the sum of the terms' references. `tight`: it is the magnitude;
- `count` n and `stray`: the error is at most the reference times (1 - u)^-n - 1, and `stray` more.
  Where tight and without stray, computed/true lies in [(1 - u)^n, (1 - u)^-n]. A rounding is 1; n
  of a product is a sum, of a sum the larger one (each of both then 1 more), of a square root half
  (Stewart's counters, Higham, chapter 3). A result that may be subnormal leaves a stray;
- `low` and `high`: what is computed is 0 or at least `low`, and at most `high`, but for a factor of
  1 + 2^-10; and so is the true value where tight and without stray: then 0 comes as 0.

A sum that is not tight may be any number down to the rounding of its smaller term: two numbers of a
format that are not equal differ by a unit in the last place of the smaller one at least.
"""

from __future__ import annotations

from dataclasses import dataclass

LARGER = 1.0 + 2.0**-40  # than a few roundings of these bounds themselves


@dataclass(frozen=True)
class Reference:
    """What is known of one step; `sign` 1: never negative, -1: never positive, 0: either.

    `zero`: it may be 0.
    """

    count: float
    low: float
    high: float
    sign: int
    zero: bool
    tight: bool = True
    stray: float = 0.0

    @property
    def clean(self) -> bool:
        """Whether its relative error is bounded."""
        return self.tight and not self.stray
