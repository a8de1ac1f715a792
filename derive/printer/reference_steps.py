"""References of all steps of a program, one after another."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from gainproof.derive.printer.affine import affine_sum
from gainproof.derive.printer.formats import Format
from gainproof.derive.printer.kernel import Requirement, least_admitted
from gainproof.derive.printer.library_functions import ULP
from gainproof.derive.printer.program import FUNCTIONS, Program, Step
from gainproof.derive.printer.reference import LARGER, Reference, required, settled
from gainproof.derive.printer.reference_calls import called, turned
from gainproof.derive.printer.step_ranges import Box, PrintingError
from gainproof.derive.printer.step_text import formula, unsure, zeros

ROOM = 2.0  # of `low` and `high` to the ends of the normal numbers
GREATEST_COUNT = 1000.0  # roundings: (1 - 2^-24)^-1000 is below 1 + 2^-10
SECOND = 1.0 + 2.0**-8  # of strays: what relative errors make of them


class References:
    """The steps of a program whose inputs have these magnitudes, signs, and zeros."""

    def __init__(
        self,
        program: Program,
        form: Format,
        box: Box,
        signs: Sequence[int],
        zeros: Sequence[bool],
    ) -> None:
        self.program, self.form = program, form
        self.box, self.signs, self.zeros = box, signs, zeros
        self.steps: list[Reference] = []
        self.least: Mapping[int, float] = {}
        self.radicands: dict[int, float] = {}

    def run(self, requirements: Sequence[Requirement]) -> None:
        """All steps; PrintingError, naming the formula, where one has no bound."""
        self.least = least = self._required(requirements)
        for number, step in enumerate(self.program.steps):
            try:
                parts = [self.steps[part] for part in step.operands]
                if number in least and step.operation == "sqrt":
                    parts = [settled(parts[0], least[number], self.form)]
                found = self._step(number, step, parts)
            except PrintingError as error:
                text = formula(self.program, number)
                raise PrintingError(f"{text}: {error}{self._reason(step)}") from None
            if number in least:
                try:
                    found = required(found, least[number], self.form)
                except PrintingError as error:
                    raise PrintingError(f"{formula(self.program, number)}: {error}") from None
            elif number in self.radicands and found.clean:
                found = replace(found, low=max(found.low, self.radicands[number]), zero=False)
            self.steps.append(found)

    def _reason(self, step: Step) -> str:
        """What of the operands is in the way, over the inputs."""
        under = step.operands[-1]
        if step.operation == "div" and self.steps[under].zero and self._vanishes(under):
            where = zeros(self.program, under, self.steps)
            divisor = formula(self.program, under)
            return (
                f": {divisor} is 0 where {where}, and the domain admits that; wanted: a domain "
                f"without it, such as an input that is not signed, or the condition {divisor} > 0"
            )
        if step.operation in ("sin", "cos"):
            argument = formula(self.program, step.operands[0])
            return (
                f": next to its zeros an error that {argument} already has is no small part of "
                f"it; wanted: {argument} as an input of its own"
            )
        parts = [part for part in dict.fromkeys(step.operands) if not self.steps[part].clean]
        if not parts:
            return ""
        why = dict.fromkeys(unsure(self.program, part, self.steps) for part in parts)
        text = f": {' and '.join(why)}, so that no digit is sure"
        if step.operation == "atan2":
            text += "; wanted: the condition that the sum of their squares is above a number"
        return text

    def _vanishes(self, number: int) -> bool:
        """Whether a step may be 0 by its inputs, and not by an underflow alone."""
        step = self.program.steps[number]
        if step.operation == "input":
            return self.zeros[self.program.axis(number)]
        if step.operation in ("add", "sub") and not self.steps[number].tight:
            return True
        return any(self._vanishes(part) for part in step.operands)

    def _required(self, requirements: Sequence[Requirement]) -> dict[int, float]:
        """What steps are at least, a little below what is required of them; a requirement that
        something is not above a number says nothing here.
        """
        found: dict[int, float] = {}
        for each in requirements:
            least = least_admitted(each, self.form)
            if least > 0:
                found[self.program.outputs[each.name]] = least * (1.0 - 2.0**-10)
        for number, least in found.items():
            step = self.program.steps[number]
            if step.operation == "sqrt":
                self.radicands[step.operands[0]] = least * least / LARGER
        return found

    def apart(self, over: int, under: int) -> float:
        """What the root of the sum of two steps' squares is required to be at least, or 0."""
        wanted = sorted([*self._squares(over), *self._squares(under)])
        for number, least in self.least.items():
            root = self.program.steps[number].operation == "sqrt"
            found = self._squares(number) if root else self._terms(number)
            if sorted(found) == wanted:
                # as it is computed: the true one is as large, but for a factor
                return (least if root else math.sqrt(least)) / (1.0 + 2.0**-9)
        return 0.0

    def _squares(self, number: int) -> Iterator[int]:
        """The steps the sum of whose squares is the square of a step."""
        step = self.program.steps[number]
        if step.operation == "sqrt":
            yield from self._terms(step.operands[0])
        elif step.operation in ("neg", "abs"):
            yield from self._squares(step.operands[0])
        else:
            yield number

    def _terms(self, number: int) -> Iterator[int]:
        """The steps the sum of whose squares is a step; a term that is no square as -1 - number."""
        step = self.program.steps[number]
        if step.operation == "add":
            for part in step.operands:
                yield from self._terms(part)
        elif step.operation == "mul" and step.operands == (step.operands[0],) * 2:
            yield from self._squares(step.operands[0])
        else:
            yield -1 - number

    def _step(self, number: int, step: Step, parts: list[Reference]) -> Reference:
        if step.operation == "input":
            axis = self.program.axis(number)
            low, high = self.box[axis]
            low = low or self.form.least  # from 0 on
            return Reference(0.0, low, high, self.signs[axis], self.zeros[axis])
        if step.operation == "constant":
            return self._constant(step)
        if step.operation in ("add", "sub"):
            return self._sum(number, step, *parts)
        if step.operation in ("neg", "abs"):
            (part,) = parts
            return replace(part, sign=-part.sign if step.operation == "neg" else 1)
        if step.operation == "atan2" and not all(part.clean for part in parts):
            over, under = parts
            return self._normal(turned(over, under, self.apart(*step.operands)))
        found = _result(step, parts, self.form)
        if step.operation == "div" and self._is_leg(*step.operands):
            found = replace(found, high=min(found.high, 1.0 + 2.0**-10))
        return self._normal(found)

    def _is_leg(self, part: int, whole: int) -> bool:
        """Whether `whole` is the root of a sum of terms, none negative, one of them the square of
        `part` or of what `part` is a leg of.
        """
        root = self.program.steps[whole]
        if root.operation != "sqrt" or not self.steps[part].clean:
            return False
        terms, seen = [root.operands[0]], False
        while terms:
            number = terms.pop()
            step = self.program.steps[number]
            if step.operation == "add":
                terms += step.operands
            elif self.steps[number].sign <= 0:
                return False
            else:
                side = step.operands[0] if step.operands else number
                squared = step.operation == "mul" and step.operands == (side, side)
                seen |= squared and (side == part or self._is_leg(part, side))
        return seen

    def _constant(self, step: Step) -> Reference:
        assert step.constant is not None
        exact = step.constant.is_exact(self.form)
        value = step.constant.nearest(self.form)
        if value == 0:
            return Reference(0.0, math.inf, 0.0, 1, True)
        size = abs(value)
        return Reference(0.0 if exact else 1.0, size, size, 1 if value > 0 else -1, False)

    def _sum(self, number: int, step: Step, a: Reference, b: Reference) -> Reference:
        affine = affine_sum(self.program, number, self.form)
        if affine is not None and affine.parts > 1:
            raise PrintingError("a sum with a constant that the format does not hold")
        turned = -b.sign if step.operation == "sub" else b.sign
        alike = a.sign * turned > 0
        exact = a.count == 0 and b.count == 0 and a.clean and b.clean
        high = (a.high + b.high) * LARGER
        low, sign = min(a.low, b.low), a.sign if alike else 0
        # where one is always the larger no difference is 0
        larger, smaller = (a, b) if a.low > b.high else (b, a)
        gap, weight = _gap(larger, smaller)
        if not alike and gap > 0:
            low, sign = gap, a.sign if larger is a else turned
        elif not alike:
            low *= self.form.unit_roundoff
        elif not (a.zero and b.zero):
            low = max(part.low for part in (a, b) if not part.zero)
        count = 1.0 if exact else max(a.count, b.count) + 1.0
        tight = exact or (alike and a.tight and b.tight)
        if not alike and gap > 0:
            count, tight = weight + 1.0, True
        zero = (not alike and gap <= 0) or (a.zero and b.zero)
        stray = (a.stray + b.stray) * SECOND
        found = Reference(count, low, high, sign, zero, tight, stray)
        return self._bounded(found)

    def _normal(self, found: Reference) -> Reference:
        """The step, with the error of a result that may be subnormal."""
        if found.low < self.form.least_normal * ROOM:
            least = self.form.least
            # a function may err by its units in the last place, others by half of one
            stray = found.stray + least * (ULP + 1)
            found = replace(found, low=least, stray=stray, zero=True)
        return self._bounded(found)

    def _bounded(self, found: Reference) -> Reference:
        if not found.high + found.stray <= self.form.largest / ROOM:
            raise PrintingError(f"it may overflow: {found.high:.3g}")
        if found.count > GREATEST_COUNT:
            raise PrintingError("too many roundings to bound")
        return found


def _gap(larger: Reference, smaller: Reference) -> tuple[float, float]:
    """What two numbers differ by at least, if their ranges are apart, and roundings of their
    difference that theirs make: each counts as often as it is larger than the difference, and that
    is most where the larger is least and the smaller greatest.
    """
    if larger.zero or not (larger.clean and smaller.clean):
        return 0.0, 0.0
    exact = larger.count == 0 and smaller.count == 0
    # ends of what is rounded are known but for a factor
    room = 1.0 if exact else 1.0 + 2.0**-10
    low, high = larger.low / room, smaller.high * room
    gap = low - high
    if not gap > 0:
        return 0.0, 0.0
    weight = (larger.count * low + smaller.count * high) / gap * SECOND
    return (gap, weight) if weight < GREATEST_COUNT / 2 else (0.0, 0.0)


def _result(step: Step, parts: list[Reference], form: Format) -> Reference:
    """An operation that is rounded, but for its being normal."""
    first = parts[0]
    if step.scale is not None:
        low, high, stray = (size * step.scale for size in (first.low, first.high, first.stray))
        return replace(first, low=low, high=high, stray=stray)
    match step.operation:
        case "mul":
            a, b = parts
            square = step.operands[0] == step.operands[1]
            return Reference(
                a.count + b.count + 1.0,
                a.low * b.low / LARGER,
                a.high * b.high * LARGER,
                1 if square else a.sign * b.sign,
                a.zero or b.zero,
                a.tight and b.tight,
                (a.stray * b.high + b.stray * a.high + a.stray * b.stray) * SECOND,
            )
        case "div":
            a, b = parts
            if b.zero:
                also = "" if b.clean else " and is an uncertain value"
                raise PrintingError(f"a division by what may be 0{also}")
            if not b.clean:
                raise PrintingError("a division by an uncertain value")
            low, high = a.low / b.high / LARGER, a.high / b.low * LARGER
            count, stray = a.count + b.count + 1.0, a.stray / b.low * SECOND
            return Reference(count, low, high, a.sign * b.sign, a.zero, a.tight, stray)
        case "sqrt":
            if first.sign <= 0:
                raise PrintingError("the root of what may be negative")
            if not first.clean:
                raise PrintingError("the root of an uncertain value")
            low, high = math.sqrt(first.low) / LARGER, math.sqrt(first.high) * LARGER
            return Reference(first.count / 2 + 1.0, low, high, 1, first.zero)
        case name if name in FUNCTIONS:
            if not all(part.clean for part in parts):
                raise PrintingError(f"{name} of an uncertain value")
            return called(name, parts, form)
    raise PrintingError(f"{step.operation} is no operation of a kernel of signed inputs")
