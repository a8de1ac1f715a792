"""The arithmetic of a kernel as NumPy statements on blocks."""

from __future__ import annotations

import keyword
import re
from collections.abc import Collection, Iterator
from fractions import Fraction

from gainproof.derive.printer.affine import AffineSum, in_two_parts
from gainproof.derive.printer.formats import FLOAT32, FORMATS
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.printer.layout import WIDTH
from gainproof.derive.printer.library_functions import NUMPY
from gainproof.derive.printer.minimum_choices import is_least
from gainproof.derive.printer.printed_program import plain
from gainproof.derive.printer.program import Step
from gainproof.derive.printer.registers import plan
from gainproof.derive.printer.select_conditions import threshold

UFUNC = {
    "add": "add",
    "sub": "subtract",
    "mul": "multiply",
    "div": "divide",
    "sqrt": "sqrt",
    "neg": "negative",
    "abs": "absolute",
    **NUMPY,
}


NUMPYS = frozenset(UFUNC.values()) | {"square", "minimum", "less", "copyto"}
"""Functions of NumPy that blocks call by their bare names, which nothing else in a block may have:
looked up in NumPy they take longer at each call, a fiftieth of a kernel's time in all.
"""


class Arithmetic:
    """The body of a block function, its `lines` without indentation, and its `work` buffers; its
    numbers have names, as the runtime puts arrays in their place.

    The last argument of each NumPy call is the array that it fills: by position, since keywords
    are a good part of what compiling and calling a block costs. Functions of NumPy are called by
    their bare names, unless the module has something of its `own` by that name; `numpys` is what it
    has to import, with "np" for NumPy itself.
    """

    def __init__(self, kernel: Kernel, own: Collection[str] = ()) -> None:
        self.kernel, self.own = kernel, own
        self.program = plain(kernel.program)
        ends = [self.program.outputs[output.name] for output in kernel.outputs]
        self.plan = plan(self.program, ends)
        ours = {"given", "out", "work", "single", "choose", "mask_of", "near_cbrt"}
        self.taken = {"np", *ours, *NUMPYS}
        self.inputs = [self._fresh(given.name) for given in kernel.inputs]
        self.outputs = [self._fresh(output.name) for output in kernel.outputs]
        self.buffers = [self._fresh(f"w{i}") for i in range(self.plan.work)]
        self.names: dict[int, str] = {}
        self.masks: dict[str, str] = {}
        self.nears = False
        self.called: set[str] = set()
        self.numbers: dict[str, str] = {}
        statements = list(self._body())
        body = [*self._unpacking(statements), *statements]
        self.lines = [line for each in _without_unused_names(body) for line in fitted(each)]
        self.numpys = {"np" if name in own else name for name in self.called}
        self.chooses = bool(self.masks)
        self.uses_type = (
            self.chooses or self.nears or any(" if single else " in line for line in body)
        )

    @property
    def work(self) -> int:
        return self.plan.work

    def _numpy(self, name: str) -> str:
        self.called.add(name)
        return f"np.{name}" if name in self.own else name

    def head(self, block: str) -> list[str]:
        """The first line of a block function of this name, or lines; its numbers are defaults."""
        work = "work" if self.work else "_work"
        single = "single" if self.uses_type else "_single"
        arguments = ["given: Arrays", "out: Arrays", f"{work}: Arrays", f"{single}: bool"]
        arguments += [f"{name}: float = {text}" for text, name in self.numbers.items()]
        line = ", ".join(arguments)
        if len(f"def {block}({line}) -> None:") <= WIDTH:
            return [f"def {block}({line}) -> None:"]
        short = len(line) + 4 <= WIDTH
        inner = [f"    {line}"] if short else [f"    {each}," for each in arguments]
        return [f"def {block}(", *inner, ") -> None:"]

    def _number(self, value: float) -> str:
        text = literal(value)
        if text not in self.numbers:
            self.numbers[text] = self._fresh(f"n{len(self.numbers)}")
        return self.numbers[text]

    def _fresh(self, wanted: str) -> str:
        name = wanted
        while name in self.taken or keyword.iskeyword(name):
            name += "_"
        self.taken.add(name)
        return name

    def _unpacking(self, statements: list[str]) -> Iterator[str]:
        used = {word for line in statements for word in re.findall(r"\w+", line)}
        for names, source in (
            ([name if name in used else f"_{name}" for name in self.inputs], "given"),
            (self.outputs, "out"),
            (self.buffers, "work"),
        ):
            if len(names) == 1:
                yield f"({names[0]},) = {source}"
            elif names:
                yield f"{', '.join(names)} = {source}"

    def _register(self, number: int) -> str:
        return (self.outputs + self.buffers)[self.plan.register[number]]

    def _body(self) -> Iterator[str]:
        for number, step in enumerate(self.program.steps):
            if step.operation == "input":
                self.names[number] = self.inputs[
                    [given.name for given in self.kernel.inputs].index(step.label)
                ]
        final = set(self._ends())
        for number in self.plan.order:
            step = self.program.steps[number]
            if self.plan.register[number] < len(self.outputs) and number in final:
                yield from self._statements(number, step, "")
                self.names[number] = self._register(number)
                continue
            name = self._fresh(step.label or f"t{number}")
            yield from self._statements(number, step, f"{name} = ")
            self.names[number] = name
        for output, number in self.plan.copies:
            yield from self._prepared(number)
            yield f"{self._numpy('copyto')}({self.outputs[output]}, {self._operand(number)})"

    def _ends(self) -> list[int]:
        return [self.program.outputs[output.name] for output in self.kernel.outputs]

    def _statements(self, number: int, step: Step, target: str) -> Iterator[str]:
        register = self._register(number)
        if step.operation == "select":
            yield from self._select(number, step, target)
            return
        affine = in_two_parts(self.program, number)
        if affine is not None:
            yield from self._two_parts(number, step, target, affine[0])
            return
        if step.scale is not None:
            operands = [self._operand(step.operands[0]), self._number(step.scale)]
        else:
            operands = []
            for part in step.operands:
                yield from self._prepared(part)
                operands.append(self._operand(part))
        if step.operation == "near_cbrt":
            self.nears = True
            yield f"{target}near_cbrt({operands[0]}, {register}, single)"
            return
        name = UFUNC[step.operation]
        if step.operation == "mul" and operands[0] == operands[1]:
            name, operands = "square", operands[:1]  # the same product, read once
        yield f"{target}{self._numpy(name)}({', '.join(operands)}, {register})"

    def _two_parts(self, number: int, step: Step, target: str, affine: AffineSum) -> Iterator[str]:
        """A difference with a constant in two parts, the nearest number and the rest."""
        register = self._register(number)
        value, sign = affine.constant, affine.sign
        high, lines = self._by_type("high", [value.nearest(form) for form in FORMATS])
        yield from lines
        rest, lines = self._by_type("rest", [sign * value.remainder(form) for form in FORMATS])
        yield from lines
        constant = [self.program.steps[part].operation == "constant" for part in step.operands]
        operands = [
            high if fixed else self._operand(part)
            for part, fixed in zip(step.operands, constant, strict=True)
        ]
        yield f"{self._numpy(UFUNC[step.operation])}({', '.join(operands)}, {register})"
        yield f"{target}{self._numpy('add')}({register}, {rest}, {register})"

    def _select(self, number: int, step: Step, target: str) -> Iterator[str]:
        register = self._register(number)
        x, y = step.operands[2:]
        for part in (x, y):
            yield from self._prepared(part)
        if is_least(self.program, step):
            operands = f"{self._operand(x)}, {self._operand(y)}"
            least = self._numpy("minimum")
            yield f"{target}{least}({operands}, out={register})"  # NumPy wants it named
            return
        limits = [threshold(self.program, step, form) for form in FORMATS]
        value, lines = self._by_type("limit", [limit.value for limit in limits])
        yield from lines
        input_first = limits[0].input_first
        compared = self._operand(step.operands[0 if input_first else 1])
        first, second = (compared, value) if input_first else (value, compared)
        condition = f"{self._numpy('less')}({first}, {second})"
        if condition not in self.masks:
            self.masks[condition] = self._fresh("mask")
            yield f"{self.masks[condition]} = mask_of({condition}, single)"
        mask = self.masks[condition]
        yield f"{target}choose({mask}, {self._operand(x)}, {self._operand(y)}, out={register})"

    def _prepared(self, part: int) -> Iterator[str]:
        """What must be said before a constant is used whose two types need two literals."""
        constant = self.program.steps[part].constant
        if constant is not None and part not in self.names:
            label = self.program.steps[part].label or "constant"
            text, lines = self._by_type(label, [constant.nearest(form) for form in FORMATS])
            self.names[part] = text
            yield from lines

    def _operand(self, number: int) -> str:
        return self.names[number]

    def _by_type(self, wanted: str, values: list[float]) -> tuple[str, list[str]]:
        """The text of a number in both types, with the line that chooses where they differ."""
        double, single = values
        if FLOAT32.nearest(Fraction(double)) == single:
            return self._number(double), []
        name = self._fresh(wanted)
        of_types = f"{self._number(single)} if single else {self._number(double)}"
        return name, [f"{name} = {of_types}"]


def literal(value: float) -> str:
    """The shortest text of a number, as the formatter writes it."""
    return repr(value).replace("e+", "e")


def fitted(line: str, width: int = 96) -> list[str]:
    """An unpacking or a call on as many lines as the formatter gives it."""
    if len(line) <= width:
        return [line]
    if line.endswith((" = given", " = out", " = work")):
        names, _, source = line.partition(" = ")
        return ["(", *(f"    {name}," for name in names.split(", ")), f") = {source}"]
    opening, _, inner = line.partition("(")
    arguments = inner.removesuffix(")")
    if len(arguments) + 4 <= width:
        return [f"{opening}(", f"    {arguments}", ")"]
    return [f"{opening}(", *(f"    {part}," for part in arguments.split(", ")), ")"]


def _without_unused_names(lines: list[str]) -> list[str]:
    """Statements whose result lies where it is wanted need no name for it."""
    words = [set(re.findall(r"\w+", line.partition(" = ")[2] or line)) for line in lines]
    kept = []
    for at, line in enumerate(lines):
        name, equals, rest = line.partition(" = ")
        unused = name.isidentifier() and not any(name in later for later in words[at + 1 :])
        kept.append(rest if equals and unused and re.match(r"[\w.]+\(", rest) else line)
    return [line for line in kept if line]
