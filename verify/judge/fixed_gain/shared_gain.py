"""Which single gain filters share that have a quantity in common, such as their lag."""

from __future__ import annotations

from dataclasses import replace

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.kinds.claim_domain import Frame, strictly


def shared_gain(
    expr: Expr, gains: tuple[str, ...], stable: tuple[Rel, ...], frame: Frame
) -> str | None:
    """The one gain that an expression fixes, being strictly monotone in it over all positive values
    where stability asks for these; None where it fixes no single one.
    """
    names = symbols_of(expr) & set(gains)
    if len(names) != 1:
        return None
    (name,) = names
    if expr == symbol(name):
        return name
    moving = [n for n in symbols_of(expr) if n.startswith("target_motion.")]
    nonzero = [Rel("!=", symbol(n), number(0)) for n in moving]
    if Rel(">", symbol(name), number(0)) not in stable:
        return None
    boxes = {**frame.boxes, name: Box(lower=number(0).fraction)}
    around = strictly(replace(frame, boxes=boxes, conditions=tuple(nonzero)))
    slope = differentiated(expr, name)
    one_way = around.holds(Rel("=", expr, expr)) and around.holds(Rel("!=", slope, number(0)))
    return name if one_way else None
