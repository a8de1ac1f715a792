"""Single numbers put before Gappa, where a domain ends and a result may be just subnormal.

Of one number x Gappa rounds step by step as the kernel does, underflow included, and encloses the
exact value: what it says is the very error of the output, not a bound of possible ones.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import inf, nextafter

from gainproof.certify import gappa
from gainproof.certify.gappa import Enclosure, dyadic
from gainproof.certify.operations import Operation

MOST_NUMBERS = 24
SIGN = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


def numbers(low: Fraction, high: Fraction) -> list[float] | None:
    """The numbers of float64 from low to high; None if they are more than MOST_NUMBERS."""
    number = float(low)
    if Fraction(number) < low:
        number = nextafter(number, inf)
    found: list[float] = []
    while number <= high:
        if len(found) == MOST_NUMBERS:
            return None
        found.append(number)
        number = nextafter(number, inf)
    return found


def errors(
    operations: Sequence[Operation], low: Fraction, high: Fraction, stop: float
) -> Enclosure | None:
    """The largest relative error of the output at the numbers from low to high, over 2^-53, twice.

    None if they are too many, or Gappa does not find the error of one. OutOfTimeError when the
    clock (perf_counter) passes `stop`.
    """
    places = numbers(low, high)
    if places is None or any(each.kind == "constant" and each.rounded for each in operations):
        return None
    definitions = "@rnd = float<ieee_64,ne>;\n" + "".join(_lines(operations))
    end = operations[-1].number
    definitions += f"E = (t{end} - T{end}) / T{end};\n"
    found = [Fraction(0)]
    for place in places:
        at = dyadic(Fraction(place))
        said = gappa.enclosures(definitions, [f"x in [{at},{at}]"], ["E"], stop)
        if "E" not in said:
            return None
        found.append(max(abs(side) for side in said["E"]) * 2**53)
    return max(found), max(found)


def _lines(operations: Sequence[Operation]) -> Iterator[str]:
    """Each operation rounded (t) and exact (T)."""
    for each in operations:
        for letter, left, right in (("t", "rnd(", ")"), ("T", "", "")):
            parts = [f"{letter}{part}" for part in each.parts]
            match each.kind:
                case "input":
                    text = "x"
                case "constant":
                    text = dyadic(each.factor)
                case "neg":
                    text = f"-{parts[0]}"
                case "scale":
                    text = f"{left}{parts[0]} * {dyadic(each.factor)}{right}"
                case "sqrt":
                    text = f"{left}sqrt({parts[0]}){right}"
                case _:
                    text = f"{left}{parts[0]} {SIGN[each.kind]} {parts[1]}{right}"
            yield f"{letter}{each.number} = {text};\n"
