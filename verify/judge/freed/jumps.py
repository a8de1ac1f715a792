"""Functions with jumps: whole parts, angles of points and cases, on parts of the domain on each of
which they are something without a jump.

The angle of (x, y) is atan(y/x) right of x = 0 and half a turn from it on the left; the whole part
of a x + b is a whole number n where x is (n + t - b)/a with 0 <= t < 1, and of what is seen to lie
between whole numbers it is one of these.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import partial
from math import inf

from gainproof.verify.judge.domain import bounded, box_conditions
from gainproof.verify.judge.exact.box import Box, Boxes
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.enclose import Balls, NoValue, Unresolved, compared, enclosed
from gainproof.verify.judge.exact.expression import (
    Expr,
    add,
    div,
    neg,
    number,
    power,
    symbol,
    symbols_of,
    weighted,
)
from gainproof.verify.judge.exact.expression import walk as nodes
from gainproof.verify.judge.exact.expression_text import labelled
from gainproof.verify.judge.exact.functions import first_case, has_jumps
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.simple_points import simple_points
from gainproof.verify.judge.exact.statement import ALLOWED, Rel, Statement
from gainproof.verify.judge.exact.total import is_total
from gainproof.verify.judge.freed.circle import PI, TURN
from gainproof.verify.judge.freed.monomials import UNIT, Terms, monomial_expr, monomials, terms_expr
from gainproof.verify.judge.freed.rewriting import bound_names
from gainproof.verify.judge.meaning.domains import is_whole
from gainproof.verify.judge.reader.words import OF_CASES

MOST_PARTS = 300
MOST_STEPS = 4
"""Whole numbers that a whole part may be, for it to be looked at one by one."""
PRECISION = 128
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
                factor, rest = _line(over, name) or (ZERO, ZERO)
                value = constant_value(factor)
                if not value or (self.boxes[name].integer and symbols_of(rest)):
                    continue
                solved = {name: _sum(monomials(div(neg(rest), factor)))}
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
            relations=tuple(map(_signed, statement.relations)),
            conditions=tuple(map(_signed, statement.conditions)),
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
    if (inner := _signed(rel)) != rel:
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
        _sum({m: c / lead for m, c in rest.items()}),
        _sum({m: -c / lead for m, c in terms.items() if m in (UNIT, TURN)}),
    ), signs


def _whole_sides(terms: Terms, rest: Terms, signs: Signs) -> tuple[Sides | bool, Signs] | None:
    """What compares n + t and a whole number, as what compares n; None for anything else."""
    pairs = {m: base for m in rest for base, k in m if len(m) == 1 and k == 1}
    names = {str(base.value).removeprefix(WHOLE).removeprefix(ABOVE) for base in pairs.values()}
    over = terms.get(UNIT, Fraction(0)) / next(iter(rest.values()))
    alike = len(rest) == len(pairs) == 2 and len(names) == 1 and len(set(rest.values())) == 1
    if not alike or TURN in terms or over.denominator > 1:
        return None
    if next(iter(rest.values())) < 0:
        signs = frozenset(-sign for sign in signs)
    n = next(base for base in pairs.values() if str(base.value).startswith(WHOLE))
    known = {(True, True): EVERY, (False, False): frozenset[int]()}
    kept = known.get(
        (1 in signs, -1 in signs), frozenset((0, 1)) if 1 in signs else frozenset((-1,))
    )
    return (bool(kept) if kept in known.values() else (n, number(-over))), kept


def _signed(rel: Rel) -> Rel:
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


def _sum(terms: Terms) -> Expr:
    """As one writes it: a - b, no a + (-1) b."""
    order = sorted(terms, key=lambda m: (terms[m] < 0, monomial_expr(m).key))
    return weighted([terms[m] for m in order], [monomial_expr(m) for m in order])


def parts_of(
    statement: Statement, boxes: Boxes, labels: Mapping[str, str], holds: Holds
) -> list[Part]:
    """Parts that together are the domain, in which no function jumps. Raises Undecided."""
    waiting, done, tried = [Part(statement, boxes, labels)], list[Part](), 0
    while waiting:
        part = waiting.pop()
        put_in = partial(substituted, values=part.fixed)
        part = replace(part, statement=part.statement.mapped(put_in))
        claimed = first_jump(*_asked(part.statement))
        jump = claimed or first_jump(*part.statement.exprs())
        if jump is None or part.lacks:
            done.append(part)
            continue
        if symbols_of(jump) & bound_names(part.statement):
            raise Undecided("a function with jumps under a sum whose bounds are symbols")
        # on no further part is anything said where what decides on it has no value
        valued = tuple(Rel("<=", e, e) for e in _deciding(jump) if not is_total(e))
        new = [rel for rel in valued if rel.left not in part.statement.needed]
        if claimed is None:
            part = replace(part, statement=_given(part.statement, *valued))
        elif new:
            alone = Statement(tuple(new), given=part.statement.domain)
            waiting.append(replace(part, statement=alone, only_values=True))
            needed = (*part.statement.needed, *[rel.left for rel in new])
            part = replace(part, statement=replace(part.statement, needed=needed))
        for each in _split(part, jump, holds):
            tried += 1
            if tried > MOST_PARTS:
                raise Undecided(f"more than {MOST_PARTS} cases")
            waiting += [] if each is None else [each]
    return done


def _asked(statement: Statement) -> tuple[Expr, ...]:
    """Of what values are asked for on the whole domain."""
    return (*[e for rel in statement.asked for e in (rel.left, rel.right)], *statement.needed)


def _given(statement: Statement, *relations: Rel) -> Statement:
    """Under further conditions."""
    return replace(statement, given=tuple(dict.fromkeys((*statement.given, *relations))))


def first_jump(*exprs: Expr) -> Expr | None:
    """A function with jumps in whose arguments no other one is; of cases only what the first
    compares is looked at, since of the rest no value may be asked.
    """
    without: set[bytes] = set()

    def first(node: Expr) -> Expr | None:
        if node.key in without:
            return None
        inner = _deciding(node) if node.kind == "call" and has_jumps(node) else node.parts
        found = next((f for part in inner if (f := first(part)) is not None), None)
        if found is None and not has_jumps(node):
            without.add(node.key)
        return found or (node if has_jumps(node) else None)

    return next((f for expr in exprs if (f := first(expr)) is not None), None)


def _deciding(jump: Expr) -> tuple[Expr, ...]:
    """What tells where a function jumps."""
    if not jump.name.startswith(OF_CASES):
        return jump.parts
    return tuple(side for comparison in first_case(jump)[0] for side in comparison[1:])


def _split(part: Part, node: Expr, holds: Holds) -> Iterator[Part | None]:
    if node.name == "floor":
        yield from _whole_parts(part, node, holds)
        return
    if node.name == "atan2":
        branches = _angles(*node.parts)
    elif node.name == "no jump":
        branches = _slopes(part, *node.parts)
    else:
        branches = _cases(node)
    for relations, value, lack in branches:
        within = _narrowed(part, relations, holds)
        if within is None or value is not None:
            yield within and within.put_in(node, value or ZERO)
        elif part.statement.connective != "if":
            yield within.put_in(node, div(number(1), ZERO))
        else:
            # only conditions may ask for it: they say nothing where it has no value
            is_asked = first_jump(*_asked(part.statement)) == node
            yield replace(within, lacks=lack) if is_asked else None


def _narrowed(part: Part, relations: Iterable[Rel], holds: Holds) -> Part | None:
    """Where relations hold; None if that is seen to be nowhere."""
    found: Part | None = part
    for rel in relations:
        if found is None or holds(_opposite(rel), found):
            return None
        found = found.under(rel)
    return found


Branch = tuple[tuple[Rel, ...], Expr | None, str]


def _angles(y: Expr, x: Expr) -> Iterator[Branch]:
    def at(a: str, b: str = "") -> tuple[Rel, ...]:
        return (Rel(a, x, ZERO), *([Rel(b, y, ZERO)] if b else []))

    angle = Expr("call", "atan", (div(y, x),))
    yield at(">"), angle, ""
    yield at("<", ">"), add(angle, PI), ""
    yield at("<", "="), PI, ""
    yield at("<", "<"), add(angle, neg(PI)), ""
    yield at("=", ">"), div(PI, number(2)), ""
    yield at("=", "<"), neg(div(PI, number(2))), ""
    yield at("=", "="), None, "the angle of the origin"


def _slopes(part: Part, y: Expr, x: Expr, rise: Expr) -> Iterator[Branch]:
    yield (Rel(">", x, ZERO),), ZERO, ""
    yield (Rel("<=", x, ZERO), Rel("!=", y, ZERO)), ZERO, ""
    there = (Rel("<=", x, ZERO), Rel("=", y, ZERO))
    yield (*there, Rel("!=", rise, ZERO)), None, "an angle jumps by a whole turn"
    # where y is 0 to second order the angle may have a slope, and that is what the rules give
    stated = any(part.boxes.get(n, Box()).stated for n in symbols_of(y, x, rise))
    value = Expr("call", "slope of an angle where y is 0", ()) if stated else ZERO
    yield (*there, Rel("=", rise, ZERO)), value, ""


def _cases(node: Expr) -> Iterator[Branch]:
    comparisons, value, other = first_case(node)
    relations = tuple(Rel(*each) for each in comparisons)
    yield relations, value, ""
    for k, rel in enumerate(relations):
        yield (*relations[:k], _opposite(rel)), other, "none of the cases"


def _opposite(rel: Rel) -> Rel:
    signs = EVERY - frozenset(ALLOWED[rel.operator])
    return replace(rel, operator=operator_of(signs))


def _whole_parts(part: Part, node: Expr, holds: Holds) -> Iterator[Part | None]:
    terms = monomials(node.parts[0])
    whole = {
        m: c
        for m, c in terms.items()
        if c.denominator == 1 and is_whole(monomial_expr(m), part.boxes)
    }
    rest = {m: c for m, c in terms.items() if m not in whole}
    shift = terms.get(UNIT, Fraction(0)) % 1
    rest, whole = dict(rest), dict(whole)
    rest.pop(UNIT, None)
    whole[UNIT] = terms.get(UNIT, Fraction(0)) - shift
    if shift:
        rest[UNIT] = shift
    over, outside = _sum(rest), _sum({m: c for m, c in whole.items() if c})
    known = _floor_at(over, {})
    if known is not None:
        yield part.put_in(node, add(outside, number(known)))
        return
    steps = _steps(part, over, holds)
    for k in steps or ():
        kept = [
            rel
            for rel in (Rel(">=", over, number(k)), Rel("<", over, number(k + 1)))
            if not holds(rel, part)
        ]
        narrowed = part.under(*kept)
        if narrowed is not None and not any(holds(_opposite(rel), part) for rel in kept):
            yield narrowed.put_in(node, add(outside, number(k)))
    replaced = [] if steps else _in_steps(part, holds)
    yield from replaced
    if steps or replaced:
        return
    n = symbol(f"{WHOLE}{labelled(over, part.labels)}")
    boxes = {**part.boxes, n.name: Box(integer=True, stated=_is_stated(part, over))}
    labels = {**part.labels, n.name: f"floor({labelled(over, part.labels)})"}
    within = replace(part, boxes=boxes, labels=labels)
    for rel in (Rel("<=", n, over), Rel("<", over, n + 1)):
        given = (*within.statement.given, rel)
        within = replace(within, statement=replace(within.statement, given=given))
    yield within.put_in(node, add(outside, n))


def _is_stated(part: Part, expr: Expr) -> bool:
    return any(part.boxes.get(name, Box(stated=False)).stated for name in symbols_of(expr))


def _floor_at(expr: Expr, point: Mapping[str, Fraction]) -> int | None:
    """The whole part at a point; None where balls do not tell."""
    with suppress(NoValue, Unresolved):
        found = enclosed(Expr("call", "floor", (expr,)), point, PRECISION).unique_fmpz()
        return None if found is None else int(found)
    return None


def _steps(part: Part, over: Expr, holds: Holds) -> range | None:
    """The few whole numbers that its whole part may be; None where they are not few, or not seen to
    be all.
    """
    statement, boxes = part.within()
    seen = set[int]()
    for point in simple_points(sorted(statement.symbols()), boxes):
        balls = Balls(point, PRECISION)
        with suppress(NoValue, Unresolved):
            sides = (
                (r.operator, balls.round(r.left), balls.round(r.right)) for r in statement.domain
            )
            if all(compared(*each) for each in sides):
                known = _floor_at(over, point)
                seen |= set() if known is None else {known}
        if len(seen) > MOST_STEPS or (seen and max(seen) - min(seen) > MOST_STEPS):
            return None
    if not seen:
        return None
    first = next(
        (k for k in (min(seen), min(seen) - 1) if holds(Rel(">=", over, number(k)), part)), None
    )
    last = next(
        (k for k in (max(seen), max(seen) + 1) if holds(Rel("<", over, number(k + 1)), part)), None
    )
    return None if first is None or last is None else range(first, last + 1)


def _in_steps(part: Part, holds: Holds) -> list[Part | None]:
    """With a symbol replaced, in which the argument of a whole part is of first degree, by that
    whole part alone, and by it and what is above it; empty where there is none. Of several by those
    with the longest steps, which the others divide.
    """
    best: tuple[float, str, Expr, Expr, Expr] | None = None
    for node in nodes(*part.statement.exprs()):
        inner = any(has_jumps(each) for below in node.parts for each in nodes(below))
        if not has_jumps(node) or node.name != "floor" or inner:
            continue
        (over,) = node.parts
        for name in sorted(symbols_of(over)):
            line = _line(over, name)
            if (
                line is None
                or name.startswith((WHOLE, ABOVE))
                or part.boxes.get(name, Box()).integer
            ):
                continue
            factor, rest = line
            if any(holds(Rel(operator, factor, ZERO), part) for operator in (">", "<")):
                size = _size(factor)
                if best is None or size < best[0]:
                    best = size, name, over, factor, rest
    if best is None:
        return []
    _, name, over, factor, rest = best
    text = labelled(over, part.labels)
    n, t = symbol(f"{WHOLE}{text}"), symbol(f"{ABOVE}{text}")
    box = part.boxes.get(name, Box(stated=False))
    boxes = {k: b for k, b in part.boxes.items() if k != name}
    boxes[n.name] = Box(integer=True, stated=box.stated)
    boxes[t.name] = Box(Fraction(0), Fraction(1), lower_open=False, stated=box.stated)
    labels = {**part.labels, n.name: f"floor({text})", t.name: f"mod({text}, 1)"}
    found = []
    for letters, sign in (((n,), 0), ((n, t), 1)):
        value = terms_expr(monomials(div(add(*letters, neg(rest)), factor)))
        put_in = partial(substituted, values={name: value})
        within = replace(
            part,
            statement=part.statement.mapped(put_in),
            boxes=boxes,
            labels=labels,
            told={(t, ZERO): frozenset((sign,))},
            back={k: put_in(e) for k, e in {name: symbol(name), **part.back}.items()},
            steps=(*part.steps, over),
        )
        moved = [Rel(r.operator, put_in(r.left), put_in(r.right)) for r in part.conditions]
        found.append(within.under(*moved, *box_conditions(name, value, box)))
    return found


def _line(expr: Expr, name: str) -> tuple[Expr, Expr] | None:
    """a and b of `a x + b`; None for what is of no first degree in the symbol."""
    x = (symbol(name), 1)
    terms = monomials(expr)
    factor = {m - {x}: c for m, c in terms.items() if x in m}
    rest = {m: c for m, c in terms.items() if x not in m}
    a, b = terms_expr(factor), terms_expr(rest)
    return None if not factor or name in symbols_of(a, b) else (a, b)


def _size(factor: Expr) -> float:
    with suppress(NoValue, Unresolved):
        return abs(float(enclosed(factor, {}, PRECISION).mid()))
    return inf
