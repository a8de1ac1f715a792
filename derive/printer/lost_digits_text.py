"""What is said of digits that an output may lose, in words."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction

import flint
import numpy as np

from gainproof.derive.printer.formats import Format

FEW = 3  # ranges of one input that are listed; of more the hull is
Ends = tuple[tuple[float, ...], tuple[float, ...]]


@dataclass(frozen=True)
class Axis:
    """An input, or a product of powers of several, with the magnitudes that it takes."""

    text: str
    low: float
    high: float
    signed: bool
    zero: bool


@dataclass(frozen=True)
class Part:
    """A part of a domain: ranges on each axis, of one axis several. None at an end: the domain's.

    `empty`: nothing.
    """

    ranges: tuple[tuple[str, tuple[tuple[float | None, float | None], ...]], ...]
    empty: bool = False

    @staticmethod
    def of(axes: Sequence[Axis], boxes: Sequence[Ends]) -> Part:
        """The ranges of boxes: those that touch joined for one axis, for more their hull."""
        if not boxes:
            return Part((), empty=True)
        found = []
        for place, axis in enumerate(axes):
            spans = sorted((low[place], high[place]) for low, high in boxes)
            joined = list(_joined(spans))
            if len(axes) > 1 or len(joined) > FEW:
                joined = [(joined[0][0], max(high for _, high in joined))]
            least = 0.0 if axis.zero or axis.signed else axis.low
            ends = tuple(
                (None if low <= least * (1 + 1e-9) else low, None if high >= axis.high else high)
                for low, high in joined
            )
            if ends != ((None, None),):
                found.append((axis.text, ends))
        return Part(tuple(found))

    def text(self) -> str:
        """Such as "b*t <= 0.0021"."""
        return " and ".join(
            " or ".join(_range(text, *ends) for ends in spans) for text, spans in self.ranges
        )


def _joined(spans: Iterable[tuple[float, float]]) -> Iterable[tuple[float, float]]:
    current: tuple[float, float] | None = None
    for low, high in spans:
        # 0 and the least magnitude beside it are neighbours
        if current is not None and (low <= current[1] * (1 + 1e-9) or current[1] == 0):
            current = current[0], max(current[1], high)
        else:
            if current is not None:
                yield current
            current = low, high
    if current is not None:
        yield current


def _range(text: str, low: float | None, high: float | None) -> str:
    if low is not None and high is not None and high / low < 1.001:
        low_text, high_text = _rounded(low, 6, up=False), _rounded(high, 6, up=True)
    else:
        low_text = "" if low is None else _rounded(low, 2, up=False)
        high_text = "" if high is None else _rounded(high, 2, up=True)
    if low is None:
        return f"{text} <= {high_text}"
    return f"{text} >= {low_text}" if high is None else f"{low_text} <= {text} <= {high_text}"


def _rounded(value: float, digits: int, up: bool) -> str:
    """A number with so many digits, outward."""
    if value == 0:
        return "0"
    text = f"{value:.{digits - 1}e}"
    step = float(f"1e{int(text.partition('e')[2]) - digits + 1}")
    found = float(text)
    if up and found < value:
        found += step
    if not up and found > value:
        found -= step
    if 1e-4 <= found < 1e6:
        return np.format_float_positional(float(f"{found:.{digits}g}"), trim="-")
    return f"{found:.{digits}g}".replace("e+", "e").replace("e0", "e").replace("e-0", "e-")


@dataclass(frozen=True)
class Loss:
    """Of one output in one format.

    `digits`: at most so many of the format's are lost, in tenths, rounded up. `halved` and
    `quartered`: where a half and where a quarter may be lost; None where that was not looked for,
    or has no bounds, as near zeros that run through the domain. `share`: half are lost only where
    the value is below this part of what the error is relative to. `below`: smaller values are told
    nothing of, since an underflow on the way may take more; 0: none that are normal numbers.
    `terms`: what cancels.
    """

    form: Format
    digits: float
    halved: Part | None
    quartered: Part | None
    share: float
    below: float
    terms: str

    @property
    def half(self) -> bool:
        """Whether it may be half of the digits or more, by the number that is shown."""
        return 2 * self.digits >= self.form.decimals


def power(base: float, exponent: Fraction) -> float:
    """A power as a float, the same one whatever library of mathematics Python was built with:
    what is said of digits is compared byte for byte. Infinity beyond the largest float.
    """
    with flint.ctx.workprec(128):
        found = flint.arb(base) ** flint.arb(flint.fmpq(exponent.numerator, exponent.denominator))
        return float(found.mid())


def lost(rate: float, form: Format) -> float:
    """Digits that are lost where an error is up to `rate` of the value: tenths, rounded up."""
    found = math.log10(max(rate / form.unit_roundoff, 1.0))
    return min(math.ceil(10.0 * found - 1e-8) / 10.0, float(form.decimals))


def least_rate(form: Format, part: float) -> float:
    """An error over the value from which on `lost` may be this part of all digits or more."""
    return form.unit_roundoff * power(10.0, Fraction(part * form.decimals - 0.1))


def loss_text(found: Sequence[Loss]) -> str:
    """One sentence for all formats."""
    if all(loss.halved is None for loss in found):
        digits = _listed([f"{each.digits:g} of {each.form.decimals}" for each in found], found)
        shares = _listed([_rounded(each.share, 1, up=True) for each in found], found)
        text = f"up to {digits}; half or more only where the value is below {shares} of what its"
        text += " error is relative to"
    else:
        text = "; ".join(map(_one, found))
    below = [f"{_rounded(loss.below, 1, True)} ({loss.form.name})" for loss in found if loss.below]
    if below:
        text += f"; values below {' and '.join(below)} apart"
    terms = next((loss.terms for loss in found if loss.terms), "")
    if terms and any(loss.digits for loss in found):
        text += f"; what cancels: {terms}"
    return f"Digits that can be lost: {text}."


def _listed(texts: Sequence[str], found: Sequence[Loss]) -> str:
    return " and ".join(f"{t} in {each.form.name}" for t, each in zip(texts, found, strict=True))


def _one(loss: Loss) -> str:
    text = f"up to {loss.digits:g} of {loss.form.decimals} in {loss.form.name}"
    if loss.halved is None or not loss.halved.empty:
        return f"{text}, half or more only where {_place(loss)}"
    if loss.quartered is not None and not loss.quartered.empty and loss.quartered.ranges:
        return f"{text}, a quarter or more only where {loss.quartered.text()}"
    return text


def place_text(found: Sequence[Loss]) -> str:
    """Where half or more is lost, in each format that may lose it."""
    return ", ".join(f"{_place(loss)} ({loss.form.name})" for loss in found if loss.half)


def _place(loss: Loss) -> str:
    if loss.halved is not None:
        return loss.halved.text()
    share = _rounded(loss.share, 1, up=True)
    return f"the value is below {share} of what its error is relative to"
