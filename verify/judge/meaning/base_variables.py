"""Base variables of a setting: their names and where they live."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from fractions import Fraction

from gainproof.verify.judge.claim.record import Setting
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import Environment


def entry_names(token: str, shape: tuple[int, int]) -> list[list[str]]:
    """The names of the entries of a free matrix, counted from 1."""
    rows, columns = shape
    return [[f"{token}[{r + 1},{c + 1}]" for c in range(columns)] for r in range(rows)]


def domains(setting: Setting, environment: Environment) -> dict[str, Box]:
    """The domains of the base variables as the setting has them."""
    found = dict(environment.boxes)
    for token, entry in setting.symbols.items():
        if entry.role == "free" and token not in environment.assigned:
            rows = [[token]] if entry.shape is None else entry_names(token, entry.shape)
            box = Box(stated=False, integer=entry.integer)
            found |= {free_name(name): box for row in rows for name in row}
        elif entry.role == "quantity" and entry.quantity == "sampling_interval":
            found.setdefault(entry.quantity, Box(lower=Fraction(0)))
        elif entry.role == "quantity" and entry.quantity == "sample_number":
            found.setdefault(entry.quantity, Box(lower=Fraction(0), lower_open=False, integer=True))
    return found


def is_whole(expr: Expr, boxes: Mapping[str, Box]) -> bool:
    """Whether it is a whole number for all values of its symbols, at a glance."""
    for node in walk(expr):
        match node.kind:
            case "number":
                whole = node.fraction.denominator == 1
            case "symbol":
                whole = node.name in boxes and boxes[node.name].integer
            case "pow":
                whole = node.fraction.denominator == 1 and node.fraction >= 0
            case _:
                whole = node.kind in ("add", "mul", "neg")
        if not whole:
            return False
    return True


def refuse_fractions(bounds: Iterable[Expr], boxes: Mapping[str, Box]) -> None:
    """Raises Undecided unless all bounds of sums are whole numbers."""
    if not all(is_whole(bound, boxes) for bound in bounds):
        raise Undecided(
            "a bound of a sum that may be no whole number: its symbols need integer = true"
        )
