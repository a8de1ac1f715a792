"""What the docstring of a kernel of one input promises of each output, read as users read it."""

from __future__ import annotations

import re
from dataclasses import dataclass

import numpy as np

PROMISE = re.compile(
    r"(\w+): [^:]*?(?:Relative error|Error over (?:the (sum of its terms' sizes)|(\w+))) "
    r"at most (\S+) \* 2\^-52 \(float64\), "
    r"(\S+) \* 2\^-23 \(float32\), proved for (\S+) <= \w+ <= (\S+) \(float64\) "
    r"and (\S+) <= \w+ <= (\S+) \(float32\)"
)
DOUBLE_UNIT = 2.0**-29
"""2^-52 in units of 2^-23."""


@dataclass(frozen=True)
class Stated:
    """One output: its error over its true value, or over that of `scale`, is at most
    `bound` * 2^-23 in float32 for inputs from `lowest` to `highest`, and at most
    `double` * 2^-52 in float64, for these inputs too.
    """

    scale: str | None
    bound: float
    double: float
    lowest: float
    highest: float

    @property
    def doubt(self) -> float:
        """By how much an error measured against float64 may be too small, in units of 2^-23.

        With y the result in float32, t and s the true value and scale, t' and s' those computed in
        double precision: |t' - t| is at most double * 2^-52 s, and s' is off by a few 2^-52 of s.
        |y - t| / s is then at most |y - t'| / s' times 1 + a few 2^-52, and double * 2^-52 more.
        The few are less than 2^10, of errors below 2^-10: one unit of 2^-52 is more than they make.
        """
        return (self.double + 1) * DOUBLE_UNIT


def stated(docstring: str | None) -> tuple[Stated, ...]:
    """The promises in the order of the outputs.

    Raises ValueError where bounds in float64 do not hold for the inputs of those in float32.
    """
    found = []
    for output, own, scale, *texts in PROMISE.findall(" ".join(str(docstring).split())):
        double, bound, low, high = (float(text) for text in texts[:4])
        lowest, highest = (float(np.float32(text)) for text in texts[4:])
        if not low <= lowest <= highest <= high:
            raise ValueError(f"bounds hold for {low} to {high}, in float32 {lowest} to {highest}")
        measure = f"{output}_scale" if own else scale or None
        found.append(Stated(measure, bound, double, lowest, highest))
    return tuple(found)
