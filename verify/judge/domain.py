"""Domains: simple bounds go into the boxes of the variables, everything else stays a condition."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.statement import TURNED, Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.environment import SAMPLE


def bounded(
    boxes: Mapping[str, Box], relations: Iterable[Rel]
) -> tuple[dict[str, Box], tuple[Rel, ...]]:
    """Boxes narrowed by relations of the form `variable < number`; the relations that are left.

    A lower bound stated for the sample number replaces the setting's own: a source that says from
    which sample its formula holds is judged on just that domain.
    """
    found = dict(boxes)
    fresh = {SAMPLE}
    left: list[Rel] = []
    for rel in relations:
        simple = _simple(rel)
        if simple is None or simple[0] not in found:
            left.append(rel)
            continue
        name, operator, value = simple
        box = found[name]
        if operator in (">", ">=") and name in fresh:
            fresh.discard(name)
            # but no sample comes before number 0
            box = replace(box, lower=Fraction(0), lower_open=False)
        found[name] = _narrowed(box, operator, value)
    return found, tuple(left)


def _simple(rel: Rel) -> tuple[str, str, Fraction] | None:
    if rel.operator not in TURNED:
        return None
    sides: tuple[tuple[Expr, Expr, str], ...] = (
        (rel.left, rel.right, rel.operator),
        (rel.right, rel.left, TURNED[rel.operator]),
    )
    for variable, bound, operator in sides:
        value = constant_value(bound)
        if variable.kind == "symbol" and value is not None:
            return variable.name, operator, value
    return None


def _narrowed(box: Box, operator: str, value: Fraction) -> Box:
    is_open = operator in ("<", ">")
    box = replace(box, stated=True)
    if operator in (">", ">="):
        if box.lower is None or value > box.lower or (value == box.lower and is_open):
            return replace(box, lower=value, lower_open=is_open)
    elif box.upper is None or value < box.upper or (value == box.upper and is_open):
        return replace(box, upper=value, upper_open=is_open)
    return box


def box_conditions(name: str, value: Expr, box: Box) -> tuple[Rel, ...]:
    """That `value` lies in the box of a variable it replaces."""
    if box.integer:
        raise Undecided(f"{name} is an integer and would be replaced")
    found = []
    if box.lower is not None:
        found.append(Rel(">" if box.lower_open else ">=", value, number(box.lower)))
    if box.upper is not None:
        found.append(Rel("<" if box.upper_open else "<=", value, number(box.upper)))
    return tuple(found)
