"""The point of a limit or an expansion: its variable, and the sides from which it comes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import substituted
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
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.limit import decide_limit, sides_of
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Graph, Reading, Relation
from gainproof.verify.judge.kinds.claim_domain import Frame
from gainproof.verify.judge.kinds.monotone_quantities import is_one_way
from gainproof.verify.judge.meaning.base_variables import is_whole
from gainproof.verify.judge.meaning.two_parameters import pair_of
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import INDEX, Environment

SMALL = "distance to the limit"
End = Expr | str
"""A point, or "infinity" or "-infinity"."""


@dataclass(frozen=True)
class Approach:
    """A base variable and where it goes; `text` is the condition as printed, for messages, with
    `labels` for the symbols of the point.
    """

    name: str
    point: End
    box: Box
    label: str
    labels: Mapping[str, str] = field(default_factory=dict)

    @property
    def text(self) -> str:
        """Readable."""
        if isinstance(self.point, str):
            return f"-> {self.point}"
        return f"-> {labelled(self.point, self.labels)}"

    def sides(self) -> tuple[int, ...]:
        """1 for from above, -1 for from below. Raises Undecided for a point outside the domain."""
        value = self.point if isinstance(self.point, str) else constant_value(self.point)
        if value is not None:
            return sides_of(self.box, value, self.label)
        if self.box.integer:
            raise Undecided(f"{self.label}, a whole number, does not come close to a point")
        return (1, -1)

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


def lacks_arrow(reading: Reading) -> str | None:
    """What is wrong with a formula that does not say once where its variable goes."""
    arrows = [relation for relation in reading.conditions if relation.operator == "->"]
    return None if len(arrows) == 1 else "says once where to, such as (k \\to \\infty)"


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
    if environment.intensity and variable == environment.assigned[environment.intensity]:
        if point != "infinity" and point != number(0):
            raise Undecided("a limit in the intensity of the noise other than zero and infinity")
        # the source's other symbols stay, so the index alone goes
        variable = environment.quantities[INDEX]
    alone = [t for t in environment.fixing if variable == environment.assigned[t]]
    if alone:
        variable, point = _of_one(alone[0], point, environment)
    variable = tidied(variable)
    if variable.kind == "symbol":
        name = variable.name
        if not isinstance(point, str) and name in symbols_of(point):
            raise Undecided("a variable that tends to something that holds it")
        label = frame.labels.get(name, name)
        return Approach(name, point, frame.boxes[name], label, frame.labels)
    names = symbols_of(variable)
    if len(names) != 1 or not (isinstance(point, str) or not symbols_of(point)):
        raise Undecided("a limit in a quantity that depends on several variables")
    (name,) = names
    # conditions may leave several intervals of it
    kept = tuple(c for c in frame.conditions if name not in symbols_of(c.left, c.right))
    if not is_one_way(variable, names, replace(frame, conditions=kept)):
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


def _of_one(token: str, point: End, environment: Environment) -> tuple[Expr, End]:
    """The parameter that goes where a symbol of the noises goes alone, and to which end."""
    if point != "infinity" and point != number(0):
        raise Undecided("a limit in a deviation of the model other than zero and infinity")
    powers = pair_of({}, environment, token).powers
    moving = {name: p[token] for name, p in powers.items() if p[token]}
    if len(moving) != 1:
        raise Undecided("a limit in a deviation with which both parameters of the model change")
    ((name, exponent),) = moving.items()
    if exponent < 0:
        point = number(0) if point == "infinity" else "infinity"
    return symbol(name), point
