"""Steps of a program in words: formulas over its inputs, and where they are 0."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from fractions import Fraction

from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.program import Program
from gainproof.derive.printer.reference import Reference

GAP = "..."  # of a part that is left out
LENGTH = 140  # of a formula; of a longer one deep parts are left out
PART = re.compile(r"(part|under|over)_\d+")  # names that no user has given
SUM, PRODUCT, POWER, ATOM = range(4)


def formula(
    program: Program, number: int, known: Collection[str] | None = None, length: int = LENGTH
) -> str:
    """A step as a formula, of a length that can be read. `known`: the names that may stand for
    deep parts; None: all that its author gave, also for the whole of what is too long.
    """
    found = _Formula(program, known)
    text = found.text(number, 2)[0]
    for depth in range(3, 41):
        deeper = found.text(number, depth)[0]
        if (deeper == text and GAP not in text) or len(deeper) > 4 * length:
            break
        text = deeper if len(deeper) <= length else text
    label = program.steps[number].label
    return label if label and GAP in text and known is None else text


class _Formula:
    def __init__(self, program: Program, known: Collection[str] | None) -> None:
        self.program, self.known = program, known

    def _name(self, label: str) -> str:
        if not label or PART.match(label) or (self.known is not None and label not in self.known):
            return GAP
        return label

    def text(self, number: int, depth: int) -> tuple[str, int]:
        """The formula, and how tightly it holds together."""
        step = self.program.steps[number]
        if step.operation == "input":
            return step.label, ATOM
        if step.operation == "constant":
            assert step.constant is not None
            if step.constant.rational is None:
                pi = step.constant.nodes[step.constant.number] == ("call", "pi")
                return "pi" if pi else f"{step.constant.nearest(FLOAT64):.6g}", ATOM
            text = str(step.constant.rational)
            return text, ATOM if text.isdigit() else SUM
        if depth <= 0:
            return self._name(step.label), ATOM
        parts = [self.text(part, depth - 1) for part in step.operands]
        if self.known is not None and {text for text, _ in parts} == {GAP}:
            return GAP, ATOM
        if step.scale is not None:
            scale = Fraction(step.scale)
            held = _held(parts[0], PRODUCT)
            if scale < 1 and scale.numerator == 1:
                return f"{held}/{scale.denominator}", PRODUCT
            return f"{scale}*{held}", PRODUCT
        match step.operation:
            case "add":
                return f"{parts[0][0]} + {_held(parts[1], SUM)}".replace("+ -", "- "), SUM
            case "sub":
                return f"{parts[0][0]} - {_held(parts[1], PRODUCT)}", SUM
            case "mul" if "1" in (parts[0][0], parts[1][0]):
                return parts[parts[0][0] == "1"]
            case "mul" if step.operands[0] == step.operands[1]:
                return f"{_held(parts[0], ATOM)}**2", POWER
            case "mul":
                return f"{_held(parts[0], PRODUCT)}*{_held(parts[1], PRODUCT)}", PRODUCT
            case "div":
                return f"{_held(parts[0], PRODUCT)}/{_held(parts[1], POWER)}", PRODUCT
            case "neg":
                return f"-{_held(parts[0], PRODUCT)}", SUM
            case name:
                return f"{name}({', '.join(text for text, _ in parts)})", ATOM


def _held(part: tuple[str, int], least: int) -> str:
    """In brackets if it holds together less than is needed."""
    text, tight = part
    return text if tight >= least else f"({text})"


def zeros(program: Program, number: int, known: Sequence[Reference]) -> str:
    """Where a step is 0, such as "x = 0 and y = 0": a sum of terms of one sign where all are."""
    step = program.steps[number]
    parts = [part for part in step.operands if known[part].zero]
    match step.operation:
        case "sqrt" | "abs" | "neg":
            return zeros(program, step.operands[0], known)
        case "mul" if parts:
            return " or ".join(dict.fromkeys(zeros(program, part, known) for part in parts))
        case "div":
            return zeros(program, step.operands[0], known)
        case "add" if len(parts) == 2 and all(known[part].sign > 0 for part in parts):
            texts = [zeros(program, part, known) for part in parts]
            return " and ".join(f"({t})" if " or " in t else t for t in dict.fromkeys(texts))
    return f"{formula(program, number)} = 0"


def unsure(program: Program, number: int, known: Sequence[Reference]) -> str:
    """Why the relative error of a step has no bound: terms that may cancel, or an underflow."""
    step = program.steps[number]
    inner = [part for part in step.operands if not known[part].clean]
    if inner and step.operation not in ("add", "sub"):
        return unsure(program, inner[0], known)
    if known[number].tight:
        return f"{formula(program, number)} may underflow"
    return f"the terms of {formula(program, number)} may cancel"
