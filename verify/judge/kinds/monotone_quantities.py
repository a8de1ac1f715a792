"""Quantities that rise or fall with a base variable throughout, so that one fixes the other."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from gainproof.verify.judge.exact.calculus import differentiated
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.kinds.claim_domain import Frame


def is_one_way(quantity: Expr, names: Iterable[str], frame: Frame) -> bool:
    """Whether a quantity of one base variable is strictly monotone over all of its interval, which
    the conditions of the frame must not divide; False also where that is not known.

    A slope of one sign is not enough: 1/x falls on both sides of its pole, and rises from -1 to 1
    on its way from x = -1 to x = 1. With a value throughout, it needs no slope at the ends.
    """
    if len(found := set(names)) != 1:
        return False
    (name,) = found
    box = replace(frame.boxes[name], stated=True)
    whole = replace(frame, boxes={**frame.boxes, name: box})
    if not whole.holds(Rel("=", quantity, quantity)):
        return False
    inside = replace(box, lower_open=True, upper_open=True)
    slope = differentiated(quantity, name)
    within = replace(frame, boxes={**frame.boxes, name: inside})
    return any(within.holds(Rel(op, slope, number(0))) for op in (">", "<"))
