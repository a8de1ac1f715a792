"""The operations of a kernel that one value of it needs, as they are printed."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import ceil

from gainproof.certify.expression import NotExportedError
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.printer.program import Step

KINDS = ("sqrt", "mul", "div", "add", "sub", "neg")
WORDS = {"near_cbrt": "iterated roots", "select": "choices", "abs": "magnitudes"}


@dataclass(frozen=True)
class Operation:
    """`input`, `constant`, `scale` (times 2^k), or one of KINDS, of earlier operations.

    `factor` is the number printed for a constant, or 2^k. `rounded`: whether its value is rounded
    (a constant: whether the printed number is not the exact one, and `off` how far, over 2^-53).
    """

    number: int
    kind: str
    parts: tuple[int, ...] = ()
    factor: Fraction = Fraction(1)
    rounded: bool = False
    off: Fraction = Fraction(1)


def operations(
    steps: Sequence[Step], end: int, given: Collection[int] = ()
) -> tuple[Operation, ...]:
    """What the value of step `end` needs, in order; steps that are `given` count as inputs.

    NotExportedError for what is no sum, difference, product, quotient or square root.
    """
    found: dict[int, Operation] = {}
    wanted = [end]
    while wanted:
        number = wanted.pop()
        if number not in found:
            found[number] = _operation(number, steps[number], number in given)
            wanted += found[number].parts
    for each in found.values():
        if each.kind in ("add", "sub"):
            _require_whole_constants(each, [found[part] for part in each.parts])
    return tuple(found[number] for number in sorted(found))


def _require_whole_constants(each: Operation, parts: Sequence[Operation]) -> None:
    """The printer subtracts a constant that is no number of the format in two parts."""
    signs = [part.factor > 0 or part.kind != "constant" for part in parts]
    minus = each.kind == "sub" or not all(signs)
    if minus and any(part.kind == "constant" and part.rounded for part in parts):
        raise NotExportedError("kernels with constants in two parts")


def _operation(number: int, step: Step, given: bool) -> Operation:
    if given or step.operation == "input":
        return Operation(number, "input")
    if step.constant is not None:
        nearest = Fraction(step.constant.nearest(FLOAT64))
        if not nearest:
            raise NotExportedError("kernels with a constant 0")
        off = max(abs(nearest / end - 1) for end in step.constant.between()) * 2**53
        off = ceil(off * 2**30) * Fraction(1, 2**30)
        return Operation(number, "constant", (), nearest, nearest != step.constant.rational, off)
    if step.scale is not None:
        return Operation(number, "scale", step.operands, Fraction(step.scale))
    if step.operation not in KINDS:
        raise NotExportedError(f"kernels with {WORDS.get(step.operation, step.operation)}")
    return Operation(number, step.operation, step.operands, rounded=step.operation != "neg")
