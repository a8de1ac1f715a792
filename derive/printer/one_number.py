"""The arithmetic of a kernel as Python statements on single numbers, rounded as its block's.

One text serves float64 and float32: operators and literals take the type of the inputs, and what
else differs is asked of `form`, `Double` or `Single` of `shipped/_numbers.py`.
"""

from __future__ import annotations

import keyword
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import ClassVar

from gainproof.derive.printer.arithmetic import literal
from gainproof.derive.printer.bound import KernelBound
from gainproof.derive.printer.emitter import Body, Language, emitted, named, unlike
from gainproof.derive.printer.formats import FLOAT32, FORMATS, Format
from gainproof.derive.printer.kernel import Input, Kernel, least_admitted
from gainproof.derive.printer.layout import WIDTH, listed, row
from gainproof.derive.printer.printed_program import plain
from gainproof.derive.printer.program import FUNCTIONS

FORM = "form"
TAKEN = frozenset((*keyword.kwlist, "abs", FORM))
"""What no argument is called."""


@dataclass(frozen=True)
class Python(Language):
    """Python's operators, for numbers of either format."""

    nested: ClassVar[int] = 36  # a sum of two such texts fits on a line

    def constant(self, value: Callable[[Format], float]) -> str:
        double, single = (value(form) for form in FORMATS)
        if FLOAT32.nearest(Fraction(double)) == single:
            return literal(double)
        return f"({literal(single)} if {FORM}.single else {literal(double)})"

    def call(self, name: str, parts: Sequence[str]) -> str:
        if name == "neg":
            return super().call(name, parts)
        return super().call(name if name == "abs" else f"{FORM}.{name}", [*map(_bare, parts)])

    def choice(self, less: str, more: str, yes: str, no: str) -> str:
        condition = f"{less} < {more}" if less.isidentifier() else f"{more} > {less}"
        return self.chosen(condition, _typed(yes), _typed(no))

    def chosen(self, condition: str, yes: str, no: str) -> str:
        """`yes` where the condition holds, else `no`."""
        return f"{yes} if {condition} else {no}"

    def statement(self, name: str, text: str) -> str:
        return f"{name} = {text}"


def _bare(text: str) -> str:
    """Without the brackets around the whole, which are where a text begins with one."""
    return text[1:-1] if text.startswith("(") else text


def _typed(text: str) -> str:
    """A value that is chosen: a literal would be a Python float among numbers of another type."""
    literal = re.fullmatch(r"-?\d\S*", text) or f"{FORM}.single" in text
    return f"{FORM}.of({_bare(text)})" if literal else text


def function_name(kernel: Kernel) -> str:
    """Of the function of numbers."""
    return f"_{kernel.name}_of_numbers"


def function(kernel: Kernel) -> Iterator[str]:
    """The function of numbers that lie in their domains: it refuses, without a word, what they are
    not together, and returns the values of the outputs.
    """
    given = [f"{name}: float" for name in names(kernel).values()]
    made = required_and_outputs(kernel, Python())
    lines = [part for line in made.lines for part in fitted(line)]
    count = len(kernel.requirements)
    for each, value in zip(kernel.requirements, made.outputs, strict=False):
        least = Python().constant(partial(least_admitted, each))
        lines += [f"if not {value} >= {least}:", "    raise ValueError"]
    lines += row("return ", made.outputs[count:])
    form = FORM if any(f"{FORM}." in line for line in lines) else f"_{FORM}"
    arguments = [*given, f"{form}: Form = Double"]
    yield from ('@errstate(all="ignore")',) if calls_functions(kernel) else ()
    yield from listed(f"def {function_name(kernel)}(", arguments, ") -> tuple[float, ...]:")
    yield from (f"    {line}" for line in lines)


def calls_functions(kernel: Kernel) -> bool:
    """Whether the function calls some of NumPy's library, which may warn."""
    return bool(required_and_outputs(kernel, Python()).operations & frozenset(FUNCTIONS))


def call(kernel: Kernel, bound: KernelBound) -> Iterator[str]:
    """Statements of the public function that return the result where all inputs are Python floats
    inside their domains and no option is given.
    """
    given_names = [given.name for given in kernel.inputs]
    conditions = [f"type({name}) is float" for name in given_names]
    for given, ends in zip(kernel.inputs, bound.inputs, strict=True):
        conditions += _within(given, ends)
    conditions += ["out is None", "workers is ONE"]
    conditions += ["not accurate"] if kernel.accurate else []
    line = f"if {' and '.join(conditions)}:"
    if len(line) + 4 <= WIDTH:
        yield line
    else:
        yield "if ("
        yield f"    {conditions[0]}"
        yield from (f"    and {each}" for each in conditions[1:])
        yield "):"
    yield "    try:"
    computed = _call(f"{function_name(kernel)}(", [[name] for name in given_names], ")", 16)
    made = _call("return named(", [[kernel.result], computed], ")", 12)
    yield from (f"        {line}" for line in made)
    yield "    except (ArithmeticError, ValueError):"
    yield "        pass  # arrays say what is wrong"


def _call(head: str, parts: Sequence[Sequence[str]], tail: str, indent: int) -> list[str]:
    """A call on as many lines as the formatter gives it; so are the parts."""
    text = ", ".join(part[0] for part in parts)
    if all(len(part) == 1 for part in parts):
        if indent + len(head) + len(text) + len(tail) <= WIDTH:
            return [f"{head}{text}{tail}"]
        if indent + 4 + len(text) <= WIDTH:
            return [head, f"    {text}", tail]
    lines = [line for part in parts for line in (*part[:-1], f"{part[-1]},")]
    return [head, *(f"    {line}" for line in lines), tail]


def names(kernel: Kernel) -> dict[str, str]:
    """Of the arguments, by inputs."""
    given = [given.name for given in kernel.inputs]
    return dict(zip(given, unlike(given, TAKEN), strict=True))


def required_and_outputs(kernel: Kernel, language: Language) -> Body:
    """The steps of what is required and of the outputs, whose texts come in this order."""
    steps = plain(kernel.program)
    wanted = [each.name for each in kernel.requirements] + [each.name for each in kernel.outputs]
    ends = [steps.outputs[name] for name in wanted]
    return emitted(steps, ends, language, named(names(kernel)))


def fitted(line: str) -> list[str]:
    """A statement on as many lines as the formatter gives it, inside an indentation."""
    if len(line) + 4 <= WIDTH:
        return [line]
    name, _, text = line.partition(" = ")
    if len(parts := _branches(text)) == 1:  # a sum with a constant of two formats
        front, _, last = text.rpartition(" + (")
        return [f"{name} = {front} + (", f"    {last[:-1]}", ")"]
    inner = [text] if len(text) + 8 <= WIDTH else parts
    return [f"{name} = (", *(f"    {part}" for part in inner), ")"]


def _branches(text: str) -> list[str]:
    """The value, condition and other value of a choice; of anything else the whole."""
    parts, depth = [""], 0
    for word in text.split(" "):
        if not depth and word in ("if", "else"):
            parts.append("")
        parts[-1] = f"{parts[-1]} {word}".lstrip()
        depth += word.count("(") - word.count(")")
    return parts


def _within(given: Input, ends: tuple[float, float]) -> Iterator[str]:
    """Conditions for an input to lie in its domain; comparisons with NaN are false."""
    name, (low, high) = given.name, (literal(end) for end in ends)
    if not given.signed:
        inside = f"{low} <= {name} <= {high}"
        yield f"({inside} or {name} == 0)" if given.zero and ends[0] else inside
    else:
        yield f"-{high} <= {name} <= {high}"
        if ends[0]:
            yield (
                f"(abs({name}) >= {low} or {name} == 0)" if given.zero else f"abs({name}) >= {low}"
            )
    if given.integer:
        yield f"{name}.is_integer()"
