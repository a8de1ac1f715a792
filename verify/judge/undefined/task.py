"""One claim solved for an undefined symbol, and the solution proved to satisfy it.

What a symbol must be at generic points is recognised as a monomial of the source's symbols.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace

import flint

from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.claim_decision import judge_claim
from gainproof.verify.judge.claim_symbols import closure, reached
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.dimensions.claim import fitting_readings
from gainproof.verify.judge.exact.calculus import rebuilt, substituted
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.exact.expression_graph import read_graph
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.polynomial import Ball
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.formula import Formula, Graph, Reading, Relation
from gainproof.verify.judge.hypotheses import settle
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.latex_printer import reading_to_latex
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.repair.formula_values import Values
from gainproof.verify.judge.repair.generic_points import generic_points
from gainproof.verify.judge.repair.number_recognition import monomial
from gainproof.verify.judge.repair.solved_changes import root
from gainproof.verify.judge.repair.tree_construction import (
    Path,
    opposite,
    places,
    product,
    quotient,
    raised,
    total,
    without,
)
from gainproof.verify.judge.scope import Scope, UndefinedSymbol
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.undefined.recognised_polynomial import as_polynomial

MOST_SECONDS = 20.0
Change = Callable[[Expr, tuple[Expr, ...]], Expr | None]
POINTS = 5


@dataclass(frozen=True)
class SolveTask:
    """A claim that contains an undefined symbol `token`."""

    claim: Claim
    setting: Setting
    token: str
    most: float = MOST_SECONDS

    def run(self, models: Models, solved: Solved) -> Trial:
        """A trial without findings; `repair` holds "definition" (LaTeX), "unique" and "how" of the
        first solution that is proved to satisfy the claim on its whole domain, if there is one.
        """
        start = time.perf_counter()
        found = None
        for solution in self._solutions(models, solved):
            # as it came, it has a value only where the equation says what the symbol is
            formula = self._proved(solution.value, models, solved)
            if formula is not None:
                short = self._shorter(solution, models, solved) or formula
                how = {"unique": solution.unique, "how": solution.how}
                found = {"definition": short.latex, **how}
                break
        return Trial(self.claim, {}, (), False, time.perf_counter() - start, repair=found)

    def _solutions(self, models: Models, solved: Solved) -> Iterator[Solution]:
        positive = _is_positive(self.setting, self.token)
        for relation in self._relations():
            try:
                shown = opened(relation, self.setting, self.token)
                left, right = read_graph(shown.left), read_graph(shown.right)
            except Malformed:
                continue
            yield from solutions(left, right, self.token, positive=positive)
        yield from self._recognised(models, solved)

    def _shorter(self, solution: Solution, models: Models, solved: Solved) -> Formula | None:
        """The only solution as a polynomial of two symbols, or with its terms put together: what
        satisfies the claim is the same.
        """
        for convention in _conventions(self.setting, models, solved) if solution.unique else ():
            try:
                value = as_polynomial(self.claim, solution.value, convention)
            except (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError):
                continue
            formula = None if value is None else self._proved(value, models, solved)
            if formula is not None:
                return formula
        return self._proved(shortened(solution.value), models, solved)

    def _relations(self) -> Sequence[Relation]:
        """The one equation of each reading."""
        if self.claim.formula is None or self.claim.kind != "identity":
            return []
        readings, _ = fitting_readings(self.claim.formula, self.setting)
        plain = [r for r in readings if r.connective == "if" and len(r.relations) == 1]
        return [r.relations[0] for r in plain if r.relations[0].operator == "="]

    def _recognised(self, models: Models, solved: Solved) -> Iterator[Solution]:
        relations = self._relations()
        if not relations:
            return
        for convention in _conventions(self.setting, models, solved):
            try:
                value = recognised(self.claim, relations[0], self.token, convention)
            except (Undecided, Malformed, NotEstablished, UndefinedSymbol, ArithmeticError):
                continue
            if value is not None:
                yield Solution(value, unique=False, how="recognised from its values")

    def _proved(self, value: Expr, models: Models, solved: Solved) -> Formula | None:
        """The definition by a value if with it the claim is proved under some convention."""
        formula = definition(self.token, value, self.setting)
        if formula is None:
            return None
        changed = with_definition(self.setting, self.token, formula)
        proved = any(
            judge_claim(self.claim, c.setting, c.environment).verdict == "proved"
            for c in _conventions(changed, models, solved)
        )
        return formula if proved else None


def _is_positive(setting: Setting, token: str) -> bool:
    """Whether the source says that the symbol is greater than zero."""
    name, zero = graph_of(symbol(token)), graph_of(number(0))
    said = (Relation(">", name, zero), Relation("<", zero, name))
    return any(relation in said for relation in setting.symbols[token].domain)


def _conventions(setting: Setting, models: Models, solved: Solved) -> Iterator[Convention]:
    try:
        found = list(conventions(setting, models, solved))
    except (Undecided, Malformed, NotEstablished):
        return
    yield from (c for c in found if isinstance(c, Convention))


def definition(token: str, value: Expr, setting: Setting) -> Formula | None:
    """`token = value` as read from its own print, or None if it has no print of one reading."""
    relation = Relation("=", graph_of(symbol(token)), graph_of(value))
    try:
        latex = reading_to_latex(Reading((relation,)))
        formula = read_formula(latex, setting.symbols)
    except (ReaderError, ValueError, KeyError):
        return None
    names = set(formula.symbols) - {token}
    plain = all(setting.symbols[name].role != "undefined" for name in names)
    alone = formula.symbols.count(token) == 1 and len(formula.readings) == 1
    return formula if plain and alone else None


def with_definition(setting: Setting, token: str, formula: Formula) -> Setting:
    """The setting in which the symbol is short for what the formula says."""
    entry = replace(setting.symbols[token], role="definition", definition=formula)
    return replace(setting, symbols={**setting.symbols, token: entry})


def opened(relation: Relation, setting: Setting, token: str) -> Relation:
    """The relation in which the symbol stands wherever a definition would hide it. Definitions with
    arguments or several readings stay. Raises Malformed.
    """
    left, right = (_opened(side, setting, token) for side in (relation.left, relation.right))
    return replace(relation, left=left, right=right)


def _opened(graph: Graph, setting: Setting, token: str) -> Graph:
    known: dict[str, Expr | None] = {}

    def change(node: Expr, _: tuple[Expr, ...]) -> Expr | None:
        if node.kind != "symbol" or node.name == token or node.name not in setting.symbols:
            return None
        if node.name not in known:
            known[node.name] = None
            known[node.name] = _meaning(node.name, setting, token, change)
        return known[node.name]

    tree = read_graph(graph)
    made = rebuilt(tree, change)
    return graph if made == tree else graph_of(made)


def _meaning(name: str, setting: Setting, token: str, change: Change) -> Expr | None:
    entry = setting.symbols[name]
    if entry.definition is None or entry.arguments or len(entry.definition.readings) != 1:
        return None
    if token not in closure({name}, setting.symbols):
        return None
    reading = entry.definition.readings[0]
    if reading.conditions:
        return None
    return rebuilt(read_graph(reading.relations[0].right), change)


def recognised(claim: Claim, relation: Relation, token: str, convention: Convention) -> Expr | None:
    """c * product of powers of up to two symbols that solves an equation for a symbol at every
    point, or None. Raises Undecided, UndefinedSymbol.
    """
    setting = convention.setting
    scope = Scope(setting, convention.environment)
    names = []
    for name in sorted(reached(claim, setting) | set(setting.symbols)):
        try:
            scope.symbol(name)
        except (Undecided, Malformed, UndefinedSymbol):
            continue
        names.append(name)
    assert claim.formula is not None
    points, put_in = generic_points(claim, claim.formula.readings[0].conditions, scope, POINTS)
    left, right = read_graph(relation.left), read_graph(relation.right)
    solved: list[Ball] = []
    for point in points:
        base = Values(scope, point, put_in)
        with flint.ctx.workprec(base.precision):
            value = root(_difference(left, right, token, base))
        if value is None:
            return None
        solved.append(value)
    known = [Values(scope, point, put_in) for point in points]
    at = [[values.symbol(name) for values in known] for name in names]
    usable = [(n, column) for n, column in zip(names, at, strict=True) if None not in column]
    if len(solved) < POINTS:
        return None
    return monomial(solved, [n for n, _ in usable], [column for _, column in usable])


def _difference(left: Expr, right: Expr, token: str, base: Values) -> Callable[[Ball], Ball | None]:
    def difference(h: Ball) -> Ball | None:
        values = Values(base.scope, base.point, base.put_in, overriding={token: h})
        a, b = values.ball(left), values.ball(right)
        return None if a is None or b is None else (a - b).mid()

    return difference


@dataclass(frozen=True)
class Solution:
    """What the symbol is; `unique` says that nothing else satisfies the equation where this has a
    value, and `how` on what ground.
    """

    value: Expr
    unique: bool
    how: str


def solutions(left: Expr, right: Expr, name: str, *, positive: bool) -> Iterator[Solution]:
    """Solutions of left = right for a symbol; `positive` says that the symbol is a positive number.
    The equation is undone step by step if the symbol occurs once, or is linear in it.
    """
    occurrences = [
        (side, path)
        for side, expr in enumerate((left, right))
        for path, node in places(expr)
        if node.kind == "symbol" and node.value == name
    ]
    if len(occurrences) == 1:
        side, path = occurrences[0]
        sides = (left, right) if side == 0 else (right, left)
        found = _undone(*sides, path, positive=positive)
        if found is not None:
            yield found
            return
    found = _linear(left, right, name)
    if found is not None:
        yield found


def _undone(expr: Expr, other: Expr, path: Path, *, positive: bool) -> Solution | None:
    """Operations taken off the side that holds the symbol, from outside to inside."""
    unique = True
    for k in path:
        inner = expr.parts[k]
        match expr.kind:
            case "add":
                other = total(other, *[opposite(t) for t in without(expr.parts, k)])
            case "neg":
                other = opposite(other)
            case "mul":
                other = quotient(other, product(*without(expr.parts, k)))
            case "div":
                other = product(other, expr.parts[1]) if k == 0 else quotient(expr.parts[0], other)
            case "pow":
                # of two opposite roots the positive one, if the base is known to be positive
                is_even = expr.fraction.numerator % 2 == 0
                unique = unique and (not is_even or (positive and inner.kind == "symbol"))
                other = raised(other, 1 / expr.fraction)
            case _:
                return None
        expr = inner
    how = "the equation undone step by step" + ("" if unique else "; of two roots one was taken")
    return Solution(other, unique, how)


def _linear(left: Expr, right: Expr, name: str) -> Solution | None:
    difference = left - right
    at_zero = substituted(difference, {name: number(0)})
    slope = substituted(difference, {name: number(1)}) - at_zero
    line = at_zero + symbol(name) * slope
    try:
        outcome = settle(Statement((Rel("=", difference, line),)), {}, None, {})
    except (Undecided, Malformed):
        return None
    if outcome.verdict != "proved" or name in symbols_of(tidied(at_zero / slope)):
        return None
    return Solution(
        opposite(quotient(at_zero, slope)), unique=True, how="the equation is linear in it"
    )


def shortened(expr: Expr) -> Expr:
    """Multiplied out and cancelled, if that is shorter."""
    made = tidied(expr)
    return made if _size(made) < _size(expr) else expr


def _size(expr: Expr) -> int:
    return sum(1 for _ in places(expr))
