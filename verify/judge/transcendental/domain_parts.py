"""Parts of a domain, told by the signs of differences."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial

from gainproof.verify.judge.domain import bounded, box_conditions
from gainproof.verify.judge.exact.box import Boxes
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import (
    Expr,
    div,
    neg,
    number,
    power,
    symbol,
    symbols_of,
    weighted,
)
from gainproof.verify.judge.exact.statement import ALLOWED, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.meaning.base_variables import is_whole
from gainproof.verify.judge.transcendental.monomials import (
    UNIT,
    Terms,
    monomial_expr,
    monomials,
    terms_expr,
)
from gainproof.verify.judge.transcendental.pi import PI, TURN

ZERO = number(0)
EVERY = frozenset((-1, 0, 1))
WHOLE, ABOVE = "whole part of ", "part above "
"""Begin the names of what replaces symbols."""

Sides = tuple[Expr, Expr]
Signs = frozenset[int]
Holds = Callable[[Rel, "Part"], bool]
"""Whether a relation is proved on a part."""


@dataclass(frozen=True)
class Part:
    """A part of the domain. `told` are the signs that differences of two sides have on it, `back`
    what symbols were that are replaced, by the whole parts of `steps` and what is above these.
    `lacks` says why a function has no value on it. With `only_values` the statement asks whether
    what decides on further parts has values on it.
    """

    statement: Statement
    boxes: Boxes
    labels: Mapping[str, str]
    told: Mapping[Sides, Signs] = field(default_factory=dict)
    back: Mapping[str, Expr] = field(default_factory=dict)
    steps: tuple[Expr, ...] = ()
    lacks: str = ""
    only_values: bool = False

    @property
    def conditions(self) -> tuple[Rel, ...]:
        """What says which part of the domain it is."""
        return tuple(Rel(operator_of(signs), *sides) for sides, signs in self.told.items())

    @property
    def fixed(self) -> dict[str, Expr]:
        """The symbols that equations of first degree give on it, by numbers and other symbols."""
        found: dict[str, Expr] = {}
        for (left, right), signs in self.told.items():
            if signs != {0}:
                continue
            over = substituted(left - right, found)
            for name in sorted(symbols_of(over)):
                factor, rest = line_in(over, name) or (ZERO, ZERO)
                value = constant_value(factor)
                if not value or (self.boxes[name].integer and symbols_of(rest)):
                    continue
                solved = {name: summed(monomials(div(neg(rest), factor)))}
                found = {n: substituted(e, solved) for n, e in found.items()} | solved
                break
        return found

    def within(self) -> tuple[Statement, Boxes]:
        """The statement under the conditions, bounds of symbols as those of their domains."""
        fixed = self.fixed
        boxes = {n: box for n, box in self.boxes.items() if n not in fixed}
        put_in = partial(substituted, values=fixed)
        relations = [Rel(r.operator, put_in(r.left), put_in(r.right)) for r in self.conditions]
        for name in fixed:
            relations += box_conditions(name, fixed[name], replace(self.boxes[name], integer=False))
        relations = [rel for rel in relations if plain(rel)[0] is not True]
        narrowed, left = bounded(boxes, relations)
        boxes = {n: replace(box, stated=boxes[n].stated) for n, box in narrowed.items()}
        statement = self.statement.mapped(put_in)
        statement = replace(
            statement,
            relations=tuple(map(signed, statement.relations)),
            conditions=tuple(map(signed, statement.conditions)),
        )
        given = tuple(r for r in (*statement.given, *left) if plain(r)[0] is not True)
        return replace(statement, given=given), boxes

    def under(self, *relations: Rel) -> Part | None:
        """Where these relations hold; None if that is nowhere, at a glance."""
        told = dict(self.told)
        for rel in relations:
            sides, signs = plain(rel)
            if isinstance(sides, bool):
                if not sides:
                    return None
                continue
            told[sides] = told.get(sides, self._known(sides)) & signs
            if not told[sides]:
                return None
        found = replace(self, told=told)
        put_in = partial(substituted, values=found.fixed)
        there = (Rel(r.operator, put_in(r.left), put_in(r.right)) for r in found.conditions)
        whole = (value for n, value in found.fixed.items() if self.boxes[n].integer)
        is_empty = any(plain(rel)[0] is False for rel in there)
        return None if is_empty or not all(is_whole(value, {}) for value in whole) else found

    def _known(self, sides: Sides) -> Signs:
        """The signs that the domain leaves to a difference, as far as it speaks of it alone."""
        found = EVERY
        for rel in self.statement.domain:
            same, signs = plain(rel)
            found &= signs if same == sides else EVERY
        box = self.boxes.get(str(sides[0].value)) if sides[0].kind == "symbol" else None
        if box is not None and sides[1].kind == "number":
            for end, is_open, beyond in (
                (box.lower, box.lower_open, 1),
                (box.upper, box.upper_open, -1),
            ):
                if end == sides[1].fraction:
                    found &= {beyond} if is_open else {beyond, 0}
        return found

    def put_in(self, node: Expr, value: Expr) -> Part:
        """With a value in the place of a node."""

        def change(expr: Expr) -> Expr:
            return rebuilt(expr, lambda each, _: value if each == node else None)

        return replace(self, statement=self.statement.mapped(change))


def is_above(expr: Expr) -> bool:
    """Whether it stands for what is above a whole part."""
    return expr.kind == "symbol" and expr.name.startswith(ABOVE)


def operator_of(signs: Signs) -> str:
    """The relation that is said by the signs of a difference."""
    return next(o for o, allowed in ALLOWED.items() if frozenset(allowed) == signs)


def plain(rel: Rel) -> tuple[Sides | bool, Signs]:
    """A relation as the signs of a difference, that of a symbol and a number where it is one; of
    numbers its truth.
    """
    signs = frozenset(ALLOWED[rel.operator])
    try:
        terms = monomials(rel.left - rel.right)
        least = min((dict(monomial).get(PI, 0) for monomial in terms), default=0)
        if least:
            terms = monomials(terms_expr(terms) * power(PI, -least))
    except Undecided:
        return (rel.left, rel.right), signs
    if len(terms) < 2 and set(terms) <= {UNIT, TURN}:
        c = sum(terms.values())
        return (c > 0) - (c < 0) in signs, signs
    if (inner := signed(rel)) != rel:
        return plain(inner)
    rest = {m: c for m, c in terms.items() if m not in (UNIT, TURN)}
    if not rest:
        return (rel.left, rel.right), signs
    if (whole := _whole_sides(terms, rest, signs)) is not None:
        return whole
    lead = rest[min(rest, key=lambda m: monomial_expr(m).key)]
    if lead < 0:
        signs = frozenset(-sign for sign in signs)
    return (
        summed({m: c / lead for m, c in rest.items()}),
        summed({m: -c / lead for m, c in terms.items() if m in (UNIT, TURN)}),
    ), signs


def _whole_sides(terms: Terms, rest: Terms, signs: Signs) -> tuple[Sides | bool, Signs] | None:
    """What compares n + t and a whole number, as what compares n; None for anything else."""
    pairs = {m: base for m in rest for base, k in m if len(m) == 1 and k == 1}
    names = {str(base.value) for base in pairs.values()}
    text = next((n.removeprefix(WHOLE) for n in sorted(names) if n.startswith(WHOLE)), None)
    over = terms.get(UNIT, Fraction(0)) / next(iter(rest.values()))
    # a whole part and what is above it, not the symbol itself of which it is one
    alike = len(rest) == 2 and names == {f"{WHOLE}{text}", f"{ABOVE}{text}"}
    if not alike or len(set(rest.values())) != 1 or TURN in terms or over.denominator > 1:
        return None
    if next(iter(rest.values())) < 0:
        signs = frozenset(-sign for sign in signs)
    n = next(base for base in pairs.values() if str(base.value).startswith(WHOLE))
    known = {(True, True): EVERY, (False, False): frozenset[int]()}
    kept = known.get(
        (1 in signs, -1 in signs), frozenset((0, 1)) if 1 in signs else frozenset((-1,))
    )
    return (bool(kept) if kept in known.values() else (n, number(-over))), kept


def signed(rel: Rel) -> Rel:
    """What compares a multiple of an arc tangent with 0 as what compares its argument; anything
    else as it is.
    """
    with suppress(Undecided):
        terms = monomials(rel.left - rel.right)
        ((monomial, c),) = terms.items() if len(terms) == 1 else [(UNIT, Fraction(1))]
        ((base, n),) = monomial if len(monomial) == 1 else [(ZERO, 1)]
        if base.kind == "call" and base.name == "atan" and n == 1:
            signs = frozenset(sign if c > 0 else -sign for sign in ALLOWED[rel.operator])
            return Rel(operator_of(signs), base.parts[0], ZERO)
    return rel


def summed(terms: Terms) -> Expr:
    """As one writes it: a - b, no a + (-1) b."""
    order = sorted(terms, key=lambda m: (terms[m] < 0, monomial_expr(m).key))
    return weighted([terms[m] for m in order], [monomial_expr(m) for m in order])


def opposite(rel: Rel) -> Rel:
    signs = EVERY - frozenset(ALLOWED[rel.operator])
    return replace(rel, operator=operator_of(signs))


def line_in(expr: Expr, name: str) -> tuple[Expr, Expr] | None:
    """a and b of `a x + b`; None for what is of no first degree in the symbol."""
    x = (symbol(name), 1)
    terms = monomials(expr)
    factor = {m - {x}: c for m, c in terms.items() if x in m}
    rest = {m: c for m, c in terms.items() if x not in m}
    a, b = terms_expr(factor), terms_expr(rest)
    return None if not factor or name in symbols_of(a, b) else (a, b)
