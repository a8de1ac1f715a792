"""Where a limit or an expansion goes: its variable, its point, the sides from which it comes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    neg,
    number,
    power,
    symbol,
    symbols_of,
    walk,
)
from gainproof.verify.judge.exact.limit import decide_limit
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.formula import Graph, Reading, Relation
from gainproof.verify.judge.kinds.framing import Frame
from gainproof.verify.judge.meaning.domains import is_whole
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.series.of_expression import expanded
from gainproof.verify.judge.series.series import leading
from gainproof.verify.judge.setting.environment import INDEX

SMALL = "distance to the limit"
End = Expr | str
"""A point, or "infinity" or "-infinity"."""


@dataclass(frozen=True)
class Approach:
    """A base variable and where it goes; `text` is the condition as printed, for messages."""

    name: str
    point: End
    box: Box
    label: str

    @property
    def text(self) -> str:
        """Readable."""
        value = self.point if isinstance(self.point, str) else constant_value(self.point)
        return f"-> {'the point' if value is None else value}"

    def sides(self) -> tuple[int, ...]:
        """1 for from above, -1 for from below. Raises Undecided for a point outside the domain."""
        if isinstance(self.point, str):
            return (1,)
        value = constant_value(self.point)
        if value is None:
            return (1, -1)
        below = self.box.lower is None or self.box.lower < value
        above = self.box.upper is None or self.box.upper > value
        if not (above and below) and value not in (self.box.lower, self.box.upper):
            raise Undecided(f"{value} is not in the domain of {self.label}")
        return (*((1,) if above else ()), *((-1,) if below else ()))

    def moved(self, expr: Expr, side: int) -> Expr:
        """The expression in the small positive distance to the point."""
        u = symbol(SMALL)
        if isinstance(self.point, str):
            far = power(u, -1)
            return substituted(expr, {self.name: neg(far) if self.point[0] == "-" else far})
        return substituted(expr, {self.name: self.point + (u if side > 0 else neg(u))})

    def distance(self) -> Expr:
        """The distance itself, of the variable."""
        x = symbol(self.name)
        return power(x, -1) if isinstance(self.point, str) else x - self.point


def refuse_real_powers(expr: Expr, frame: Frame) -> None:
    """Raises Undecided for b^x with a base that may be negative and an x that is no integer."""
    for node in walk(expr):
        if node.kind == "call" and node.name == "power":
            base, exponent = node.parts
            if not is_whole(exponent, frame.boxes) and not frame.holds(Rel(">", base, number(0))):
                raise Undecided("a power with a base that may be negative, exponent not whole")


def arrow_of(reading: Reading) -> tuple[Relation, tuple[Relation, ...]]:
    """The one condition with an arrow, and the others. Raises Undecided."""
    arrows = [r for r in reading.conditions if r.operator == "->"]
    if len(arrows) != 1 or len(reading.relations) != 1:
        raise Undecided("wanted: one relation and one condition with an arrow")
    return arrows[0], tuple(r for r in reading.conditions if r is not arrows[0])


def end_of(graph: Graph, scope: Scope) -> End:
    """A point or an infinity."""
    nodes = [list(n) for n in graph["nodes"]]
    if ["symbol", "infinity"] in nodes:
        if len(nodes) == 1:
            return "infinity"
        if len(nodes) == 2 and nodes[1][0] == "neg":
            return "-infinity"
        raise Undecided("infinity inside an expression")
    return scope.expression(graph)


def approach_of(variable: Expr, point: End, frame: Frame) -> Approach:
    """How the base variable goes when `variable` goes to the point.

    A variable that is an expression of one base variable must be strictly monotone in it; then it
    goes to the point as the base variable goes to one of its ends. Raises Undecided.
    """
    environment = frame.environment
    if variable.kind == "symbol" and environment.moves_with(variable.name):
        raise Undecided("a limit in a symbol with which the tracking index changes")
    if environment.intensity and variable == environment.assigned[environment.intensity]:
        if point != "infinity" and point != number(0):
            raise Undecided("a limit in the intensity of the noise other than zero and infinity")
        # the source's other symbols stay, so the index alone goes
        variable = environment.quantities[INDEX]
    if variable.kind == "symbol":
        name = variable.name
        if not isinstance(point, str) and name in symbols_of(point):
            raise Undecided("a variable that tends to something that holds it")
        return Approach(name, point, frame.boxes[name], frame.labels.get(name, name))
    names = symbols_of(variable)
    if len(names) != 1 or not (isinstance(point, str) or not symbols_of(point)):
        raise Undecided("a limit in a quantity that depends on several variables")
    (name,) = names
    slope = differentiated(variable, name)
    if not any(frame.holds(Rel(op, slope, number(0))) for op in (">", "<")):
        raise Undecided("a limit in a quantity that is not strictly monotone")
    label, box = frame.labels.get(name, name), frame.boxes[name]
    ends: list[Fraction | str] = [
        "-infinity" if box.lower is None else box.lower,
        "infinity" if box.upper is None else box.upper,
    ]
    for end in ends:
        try:
            found = decide_limit(variable, name, box, end, point, label)
        except Undecided:
            continue
        if found.verdict == "proved":
            return Approach(name, end if isinstance(end, str) else number(end), box, label)
    raise Undecided("a limit in a quantity that does not tend to its point at an end")


def others_frame(frame: Frame, approach: Approach) -> tuple[Frame, bool]:
    """The frame without the variable of the limit; whether a condition on it was left out that does
    not just say from which side it comes.
    """
    on_it = [c for c in frame.conditions if approach.name in symbols_of(c.left, c.right)]
    kept = tuple(c for c in frame.conditions if c not in on_it)
    boxes: Mapping[str, Box] = {n: b for n, b in frame.boxes.items() if n != approach.name}
    around = replace(frame, boxes=boxes, conditions=kept)
    return around, any(None in _near(c, approach, around).values() for c in on_it)


def open_sides(approach: Approach, frame: Frame, around: Frame) -> list[int]:
    """The sides on which no condition excludes points close to the limit. Raises Undecided."""
    on_it = [c for c in frame.conditions if approach.name in symbols_of(c.left, c.right)]
    shut = {s for c in on_it for s, holds in _near(c, approach, around).items() if holds is False}
    sides = [side for side in approach.sides() if side not in shut]
    if not sides:
        raise Undecided("the conditions hold nowhere close to the limit")
    return sides


def _near(rel: Rel, approach: Approach, around: Frame) -> dict[int, bool | None]:
    """For each side whether a condition holds close to the limit; None where that is not known."""
    oracle = Coefficients(around)
    found: dict[int, bool | None] = {}
    for side in approach.sides():
        try:
            difference = approach.moved(rel.left - rel.right, side)
            first = leading(expanded(difference, SMALL, oracle, Fraction(4)), oracle)
        except Undecided:
            first = None
        found[side] = None
        for sign, operators in ((1, (">", ">=", "!=")), (-1, ("<", "<=", "!="))):
            if first is not None and oracle.is_positive(first[1] if sign > 0 else -first[1]):
                found[side] = rel.operator in operators
    return found


class Coefficients:
    """What a frame knows of coefficients: the oracle of expansions."""

    def __init__(self, frame: Frame) -> None:
        self._frame = frame
        self._known: dict[tuple[str, Expr], bool] = {}

    def is_zero(self, coefficient: Expr) -> bool:
        """Zero always, or never. Raises Undecided."""
        value = constant_value(coefficient)
        if value is not None:
            return value == 0
        if self._holds("=", coefficient):
            return True
        if self._holds("!=", coefficient):
            return False
        raise Undecided(
            "a coefficient of the expansion may be zero for some values of the other symbols"
        )

    def is_positive(self, coefficient: Expr) -> bool:
        """Positive always; False also where that is not known."""
        value = constant_value(coefficient)
        return self._holds(">", coefficient) if value is None else value > 0

    def _holds(self, operator: str, coefficient: Expr) -> bool:
        key = (operator, coefficient)
        if key not in self._known:
            self._known[key] = self._frame.holds(Rel(operator, coefficient, number(0)))
        return self._known[key]


def equal(left: Expr, right: Expr) -> Statement:
    """That two expressions are equal."""
    return Statement((Rel("=", left, right),))
