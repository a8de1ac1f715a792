"""The printed error bounds of kernels of one input put before Gappa, box by box.

A step of the kernel is `t`, rounded to 53 bits with exponents without ends; its counterpart `T` is
exact. Gappa first encloses the counterparts, then, with these enclosures, the relative errors.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from fractions import Fraction
from itertools import pairwise
from time import perf_counter
from typing import Any

from gainproof.certify import external
from gainproof.certify.expression import NotExportedError
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.plain import plain
from gainproof.derive.printer.program import Program, Step, program
from gainproof.derive.printer.registers import plan

PROGRAM = "gappa"
EPSILON = Fraction(1, 2**52)
HEAD = "@rnd = float<53,-20000,ne>;\n"
ENDS = (-64, -16, -8, -4, -3, -2, -1, 0, 1, 2, 3, 4, 8, 16, 64)
"""Powers of two at which the domain is cut: terms of a sum share errors by their sizes there."""
SIGN = {"add": "+", "mul": "*", "div": "/"}
_NUMBER = r"([-0-9b]+)(?: \{[^}]*\})?"
_EXACT = re.compile(rf"^  (T\d+) in \[{_NUMBER}, {_NUMBER}\]", re.MULTILINE)
_ERROR = re.compile(rf"^  (t\d+) -/ T\d+ in \[{_NUMBER}, {_NUMBER}\]", re.MULTILINE)


class OutOfTimeError(Exception):
    """No answer in time."""


def largest_error(
    graph: Mapping[str, Any], output: str, domain: tuple[Fraction, Fraction], limit: float
) -> Fraction | None:
    """A bound of an output's relative error on the domain, in units of 2^-52; None: there is none.

    NotExportedError for a kernel that is not made of + * / and roots of positive numbers.
    OutOfTimeError after `limit` seconds.
    """
    script = _Script(plain(program(graph)), output)  # type: ignore[arg-type]
    low, high = domain
    inner = [Fraction(2) ** end for end in ENDS if low < Fraction(2) ** end < high]
    largest, stop = Fraction(0), perf_counter() + limit
    for box in pairwise([low, *inner, high]):
        error = script.error(*box, stop)
        if error is None:
            return None
        largest = max(largest, error)
    return largest


class _Script:
    """The steps of one output as definitions of Gappa."""

    def __init__(self, steps: Program, output: str) -> None:
        self.steps, self.end = steps.steps, steps.outputs[output]
        order = plan(steps, [self.end]).order
        if len(steps.inputs) != 1:
            raise NotExportedError("kernels of several inputs")
        self.inner = [i for i in order if self.steps[i].operation != "input"]
        lines = [line for number in order for line in self._lines(number, self.steps[number])]
        self.definitions = HEAD + "".join(f"{line}\n" for line in lines)

    def _lines(self, number: int, step: Step) -> Iterator[str]:
        if step.operation == "sqrt":
            (part,) = step.operands
            yield f"t{number} = rnd(sqrt({self._name('t', part)}));"
            yield f"T{number} = sqrt({self._name('T', part)});"
        elif step.scale is not None:
            for letter in "tT":
                value = _dyadic(Fraction(step.scale))
                yield f"{letter}{number} = {self._name(letter, step.operands[0])} * {value};"
        elif step.operation in SIGN:
            for letter in "tT":
                text = f" {SIGN[step.operation]} ".join(
                    self._name(letter, part) for part in step.operands
                )
                yield f"{letter}{number} = {f'rnd({text})' if letter == 't' else text};"
        else:
            what = {"sub": "differences", "neg": "differences"}
            raise NotExportedError(f"kernels with {what.get(step.operation, step.operation)}")

    def _name(self, letter: str, number: int) -> str:
        step = self.steps[number]
        if step.operation == "input":
            return "x"
        if step.constant is None:
            return f"{letter}{number}"
        exact = step.constant.rational
        if exact is None:
            raise NotExportedError("kernels with irrational constants")
        if exact <= 0:
            raise NotExportedError("kernels with differences")
        nearest = Fraction(step.constant.nearest(FLOAT64))
        if letter == "t" or nearest == exact:
            return _dyadic(nearest)
        return f"({exact.numerator} / {exact.denominator})"

    def error(self, low: Fraction, high: Fraction, stop: float) -> Fraction | None:
        """The largest relative error that Gappa finds in a box, in units of 2^-52."""
        given = f"x in [{_dyadic(low)},{_dyadic(high)}]"
        asked = " /\\ ".join(f"T{number} in ?" for number in self.inner)
        for name, least, most in _EXACT.findall(self._ask(f"{{ {given} -> {asked} }}", stop)):
            given += f" /\\ |{name}| in [{least},{most}]"
        said = self._ask(f"{{ {given} -> t{self.end} -/ T{self.end} in ? }}", stop)
        found = _ERROR.search(said)
        if found is None:
            return None
        return max(abs(_fraction(found[2])), abs(_fraction(found[3]))) / EPSILON

    def _ask(self, question: str, stop: float) -> str:
        limit = stop - perf_counter()
        text = self.definitions + question + "\n"
        answer = external.ask([PROGRAM], "kernel.g", text, limit) if limit > 0 else None
        if answer is None or answer.status is None:
            raise OutOfTimeError
        return answer.text if answer.status == 0 else ""


def _dyadic(value: Fraction) -> str:
    """A number m * 2^e as Gappa writes it."""
    return f"{value.numerator}b{-(value.denominator.bit_length() - 1)}"


def _fraction(text: str) -> Fraction:
    whole, _, power = text.partition("b")
    return Fraction(int(whole)) * Fraction(2) ** int(power or "0")
