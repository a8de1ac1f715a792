"""One claim solved for an undefined symbol, and the solution proved to satisfy it."""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from gainproof.verify.judge.attempt import judge_claim
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.convention import Convention, conventions
from gainproof.verify.judge.dimensions.claim import fitting_readings
from gainproof.verify.judge.exact.expression import Expr, number, symbol
from gainproof.verify.judge.exact.graph import read_graph
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.limits import Malformed, Undecided
from gainproof.verify.judge.formula import Formula, Reading, Relation
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.latex import reading_to_latex
from gainproof.verify.judge.reader.reader import read_formula
from gainproof.verify.judge.scope import UndefinedSymbol
from gainproof.verify.judge.setting.environment import NotEstablished
from gainproof.verify.judge.task import Models, Solved
from gainproof.verify.judge.trial import Trial
from gainproof.verify.judge.undefined.opened import opened
from gainproof.verify.judge.undefined.polynomial import as_polynomial
from gainproof.verify.judge.undefined.recognised import recognised
from gainproof.verify.judge.undefined.solve import Solution, shortened, solutions

MOST_SECONDS = 20.0


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
