"""Newton's steps of a kernel: that they are alike, and how near a step comes to the root."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise

from gainproof.certify.expression import NotExportedError
from gainproof.certify.operations import Operation, operations
from gainproof.derive.printer.newton import Convergence
from gainproof.derive.printer.program import Step


def after_step(map_: Convergence, error: Fraction) -> Fraction:
    """How far a step N leads: X/(1 + e) <= N(x) <= X (1 + e).

    For all x from X/(1 + error) to X (1 + error): 4 of `derive.printer.newton`, in fractions.
    NotExportedError for a distance of which that does not speak.
    """
    most, bend, below = map_.slope, map_.curvature, 1 / (1 + error)
    if below > most:
        above = bend * error**2 / (2 * (1 - most))
        found = max(above, bend * (1 - below) ** 2 / (2 * below * (below - most)))
        if found < 1:
            return found / (1 - found)
    raise NotExportedError("kernels with iterated roots from far starts")


def require_like_steps(steps: Sequence[Step], iterates: Sequence[int]) -> None:
    """NotExportedError unless each iterate is made of the one before by the same operations.

    What is shown of one step, of the roundings in it too, is then shown of all.
    """
    forms = {_form(operations(steps, new, (old,)), old) for old, new in pairwise(iterates)}
    if len(forms) != 1:
        raise NotExportedError("kernels with iterated roots by unlike steps")


def _form(chosen: Sequence[Operation], before: int) -> tuple[object, ...]:
    """What is made of the iterate `before`, in order, with places in place of numbers."""
    place: dict[int, object] = {before: "iterate"}
    form: list[object] = []
    for each in chosen:
        if any(part in place for part in each.parts):
            parts = tuple(place.get(part, f"step {part}") for part in each.parts)
            place[each.number] = len(form)
            form.append((each.kind, parts, each.factor, each.rounded))
    return tuple(form)
