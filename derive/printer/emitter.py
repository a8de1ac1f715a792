"""The steps of a kernel as statements of a language, every operation rounded as in the NumPy
module. What a language writes otherwise than most is a method of its `Language`.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial
from typing import ClassVar

from gainproof.derive.printer.affine import in_two_parts
from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.formats import FLOAT64, Format
from gainproof.derive.printer.kernel import Input, Kernel, least_admitted
from gainproof.derive.printer.printed_program import plain
from gainproof.derive.printer.program import Program, Step
from gainproof.derive.printer.register_plan import late
from gainproof.derive.printer.select_conditions import threshold

SIGN = {"add": "+", "sub": "-", "mul": "*", "div": "/"}


@dataclass(frozen=True)
class Language:
    """How a language writes numbers of a format, operations and statements."""

    form: Format = FLOAT64
    nested: ClassVar[int] = 0
    """How long the text of an operation may be that stands where its result is used, if that is at
    one place; else it gets a name.
    """
    words: ClassVar[tuple[str, str]] = ("&&", "||")
    """And, or."""

    def number(self, value: float) -> str:
        """A literal that is read as just that number."""
        return literal(value)

    def constant(self, value: Callable[[Format], float]) -> str:
        """A constant's number in the format."""
        return self.number(value(self.form))

    def operation(self, sign: str, first: str, second: str) -> str:
        """One of + - * /."""
        return f"{first} {sign} {second}"

    def sum_in_two_parts(self, text: str, rest: str) -> str:
        """A sum with a constant's nearest number, and what that leaves of it."""
        return f"({text}) + {rest}"

    def call(self, name: str, parts: Sequence[str]) -> str:
        """neg, abs, sqrt, near_cbrt or one of `program.FUNCTIONS`."""
        return f"-{parts[0]}" if name == "neg" else f"{name}({', '.join(parts)})"

    def choice(self, less: str, more: str, yes: str, no: str) -> str:
        """`yes` where less < more, else `no`."""
        return f"{less} < {more} ? {yes} : {no}"

    def within(self, given: Input, name: str, ends: tuple[float, float]) -> str:
        """Whether an input lies in its domain; comparisons with NaN are false."""
        both, either = self.words
        size = self.call("abs", [name]) if given.signed else name
        text = f"{size} >= {self.number(ends[0])} {both} {size} <= {self.number(ends[1])}"
        text += f" {both} {name} == {self.call('floor', [name])}" if given.integer else ""
        return f"{name} == {self.number(0.0)} {either} ({text})" if given.zero else text

    def statement(self, name: str, text: str) -> str:
        """A step that gets its name."""
        raise NotImplementedError

    def remark(self, label: str) -> str:  # noqa: ARG002 (most languages say nothing)
        """What follows a statement whose step the graph calls `label`."""
        return ""


@dataclass(frozen=True)
class Body:
    """Statements in order, the texts of the outputs' values, and the operations that they take."""

    lines: tuple[str, ...]
    outputs: tuple[str, ...]
    operations: frozenset[str]


def body(kernel: Kernel, language: Language, name: Callable[[int, Step], str]) -> Body:
    """The steps that a kernel's outputs need; `name` of an input or a step."""
    steps = plain(kernel.program)
    return emitted(steps, [steps.outputs[each.name] for each in kernel.outputs], language, name)


def required(
    kernel: Kernel, language: Language, name: Callable[[int, Step], str]
) -> list[tuple[Body, str]]:
    """Of each requirement the steps of what it asks about, and the least number that it admits."""
    steps = plain(kernel.program)
    return [
        (
            emitted(steps, [steps.outputs[each.name]], language, name),
            language.constant(partial(least_admitted, each)),
        )
        for each in kernel.requirements
    ]


def named(names: Mapping[str, str]) -> Callable[[int, Step], str]:
    """Names of inputs as they are, of steps by their numbers."""
    return lambda number, step: names[step.label] if step.operation == "input" else f"t{number}"


def unlike(names: Sequence[str], taken: Collection[str]) -> list[str]:
    """The names with underscores behind them until none is like another, like a step's or taken."""
    found: list[str] = []
    for name in names:
        while name in taken or name in found or re.fullmatch(r"t\d+", name):
            name += "_"
        found.append(name)
    return found


def emitted(
    steps: Program, ends: Sequence[int], language: Language, name: Callable[[int, Step], str]
) -> Body:
    """The steps that some need, in the order in which the kernel computes them."""
    order = late(steps, ends)
    uses = Counter([*ends, *ends, *(part for each in order for part in steps.steps[each].operands)])
    printer = _Emitter(steps, language, name, frozenset(n for n in order if uses[n] == 1))
    lines = tuple(printer.lines(order))
    operations = frozenset(steps.steps[number].operation for number in order)
    return Body(lines, tuple(printer.operand(end) for end in ends), operations)


@dataclass(frozen=True)
class _Emitter:
    steps: Program
    language: Language
    name: Callable[[int, Step], str]
    used_once: frozenset[int]
    placed: dict[int, str] = field(default_factory=dict)
    """Texts of operations that stand where their results are used."""

    def lines(self, order: Sequence[int]) -> Iterator[str]:
        for number in order:
            step = self.steps.steps[number]
            text = self._expression(number, step)
            if number in self.used_once and len(text) <= self.language.nested:
                operator = step.operation in (*SIGN, "select")
                self.placed[number] = f"({text})" if operator else text
                continue
            line = self.language.statement(self.name(number, step), text)
            yield line + (self.language.remark(step.label) if step.label else "")

    def operand(self, number: int) -> str:
        step = self.steps.steps[number]
        if step.constant is not None:
            return self.language.constant(step.constant.nearest)
        return self.placed.get(number) or self.name(number, step)

    def _expression(self, number: int, step: Step) -> str:
        language = self.language
        parts = [self.operand(part) for part in step.operands]
        if step.scale is not None:
            return language.operation("*", parts[0], language.number(step.scale))
        if step.operation == "select":
            limit = threshold(self.steps, step, language.form)
            value = language.constant(lambda form: threshold(self.steps, step, form).value)
            pair = (parts[0], value) if limit.input_first else (value, parts[1])
            return language.choice(*pair, *parts[2:])
        if step.operation not in SIGN:
            return language.call(step.operation, parts)
        text = language.operation(SIGN[step.operation], *parts)
        found = in_two_parts(self.steps, number)
        if found is None:
            return text
        sign, whole = found[0].sign, found[0].constant
        rest = language.constant(lambda form: sign * whole.remainder(form))
        return language.sum_in_two_parts(text, rest)
