"""What is decided: relations between expression trees, under conditions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, symbols_of
from gainproof.verify.judge.exact.places import Place
from gainproof.verify.judge.verdict_words import NOT_COMPARED, Shown

ORDERS = ("<", "<=", ">", ">=")
STRICT = ("<", ">", "!=")
"""Of two equal numbers none of these holds."""
TURNED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
"""The same orders of sides exchanged."""
NEGATED = {"<": ">=", "<=": ">", ">": "<=", ">=": "<"}
"""Which order holds of two numbers where another does not."""
ALLOWED: Mapping[str, tuple[int, ...]] = {
    ">": (1,),
    ">=": (1, 0),
    "=": (0,),
    "<=": (-1, 0),
    "<": (-1,),
    "!=": (1, -1),
}
"""For each relation the signs that the difference of its sides may have."""
NOT_EVALUATED = "not evaluated"
"""Of a side of which balls do not tell whether it has a value."""


@dataclass(frozen=True)
class Rel:
    """left operator right, with operator =, !=, <, <=, > or >=."""

    operator: str
    left: Expr
    right: Expr


@dataclass(frozen=True)
class Statement:
    """All relations hold where all conditions do (`if`); or relations <=> conditions (`iff`),
    relations => conditions.

    `needed` are expressions that must have a value too, for example what was differentiated.
    `given` are conditions on the domain, whatever the connective.
    """

    relations: tuple[Rel, ...]
    conditions: tuple[Rel, ...] = ()
    connective: str = "if"
    needed: tuple[Expr, ...] = ()
    given: tuple[Rel, ...] = ()

    @property
    def domain(self) -> tuple[Rel, ...]:
        """The conditions without which nothing is said."""
        return (*self.given, *self.conditions) if self.connective == "if" else self.given

    @property
    def asked(self) -> tuple[Rel, ...]:
        """The relations of which values are asked for on the whole domain."""
        return self.relations if self.connective == "if" else (*self.relations, *self.conditions)

    def all_relations(self) -> tuple[Rel, ...]:
        """Relations, conditions, given."""
        return (*self.relations, *self.conditions, *self.given)

    def exprs(self) -> tuple[Expr, ...]:
        """All expressions."""
        sides = [side for r in self.all_relations() for side in (r.left, r.right)]
        return (*sides, *self.needed)

    def symbols(self) -> set[str]:
        """All symbols."""
        return symbols_of(*self.exprs())

    def mapped(self, change: Callable[[Expr], Expr]) -> Statement:
        """The same statement with every expression changed."""

        def each(rels: tuple[Rel, ...]) -> tuple[Rel, ...]:
            return tuple(Rel(r.operator, change(r.left), change(r.right)) for r in rels)

        return Statement(
            each(self.relations),
            each(self.conditions),
            self.connective,
            tuple(change(e) for e in self.needed),
            each(self.given),
        )


@dataclass(frozen=True)
class Enclosure:
    """A real number between midpoint - radius and midpoint + radius, both decimal text; or why
    there is none.
    """

    midpoint: str
    radius: str
    undefined: str | None = None

    def to_json(self) -> dict[str, Any]:
        """Plain data."""
        if self.undefined is not None:
            return {"undefined": self.undefined}
        return {"midpoint": self.midpoint, "radius": self.radius}

    def text(self) -> str:
        """Readable."""
        return (
            f"no value ({self.undefined})"
            if self.undefined
            else f"{self.midpoint} +/- {self.radius}"
        )


@dataclass(frozen=True)
class Witness:
    """A point of the domain where a relation fails, and both sides there, in balls that do not
    overlap.

    `exact` says that the sides were shown equal exactly (a strict inequality that is an equality
    there).
    """

    point: Mapping[str, str]
    operator: str
    left: Enclosure
    right: Enclosure
    values: Mapping[str, Enclosure] = field(default_factory=dict)
    exact: bool = False
    note: str = ""
    shows: Shown = Shown.SIDES

    def to_json(self) -> dict[str, Any]:
        """Plain data."""
        found: dict[str, Any] = {
            "point": dict(self.point),
            "left": self.left.to_json(),
            "operator": self.operator,
            "right": self.right.to_json(),
        }
        if self.exact:
            found["exact"] = True
        if self.values:
            found["values"] = {name: value.to_json() for name, value in self.values.items()}
        if self.note:
            found["note"] = self.note
        if self.shows != Shown.SIDES:
            found["shows"] = str(self.shows)
        return found

    def text(self) -> str:
        """Readable."""
        where = ", ".join(
            f"{name} {'' if value.startswith('->') else '= '}{value}"
            for name, value in self.point.items()
        )
        place = f"at {where}:" if where else "with"
        if self.left.undefined == self.right.undefined == NOT_COMPARED:
            return f"{place} {self.note}"
        return f"{place} left {self.left.text()}, right {self.right.text()}" + (
            f" ({self.note})" if self.note else ""
        )


@dataclass(frozen=True)
class Outcome:
    """What was found out: `proved`, `refuted` or `conditional`, where, and how."""

    verdict: str
    domain: str
    reason: str
    method: str
    witness: Witness | None = None
    certificate: Mapping[str, Any] = field(default_factory=dict)
    reach: int = 0  # how many points were tried before the witness; 1 means that the first one did
    region: tuple[Place, ...] = ()  # of one parameter, where `domain` tells of it


def refuted(witness: Witness, method: str, tried: int = 1) -> Outcome:
    """What fails at a point, whatever it is elsewhere, found after so many points."""
    reason = f"fails {witness.text()}; where it may hold is not determined"
    return Outcome("refuted", "", reason, method, witness, {}, tried)


def unstated() -> Box:
    """The domain of a symbol about which nothing was said."""
    return Box(stated=False)
