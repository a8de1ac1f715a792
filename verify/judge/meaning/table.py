"""The table of symbols of a setting as an evaluation sees it: what symbols stand for, functions,
derivatives, sums, integrals, expectations.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from gainproof.verify.judge.claim_record import Setting, SymbolEntry
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.exact.graph import read_tree
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.formula import Formula, Graph, Relation
from gainproof.verify.judge.meaning.bindings import Bindings
from gainproof.verify.judge.meaning.domains import entry_names, free_name
from gainproof.verify.judge.meaning.evaluation import evaluated, number_of
from gainproof.verify.judge.meaning.expectation import expectation_of
from gainproof.verify.judge.meaning.integrals import integral_of
from gainproof.verify.judge.meaning.reach import Reach
from gainproof.verify.judge.meaning.sums import INFINITE, range_of, sum_of
from gainproof.verify.judge.meaning.value import (
    Value,
    mapped,
    matrix,
    multiplied,
    put_in,
    shape,
    shape_text,
)
from gainproof.verify.judge.setting.environment import Environment

MOST_CALLS = 500
"""Functions put in, all together: calls inside calls double with every definition."""


class UndefinedSymbol(Exception):
    """The formula uses a symbol that the source never defines."""

    def __init__(self, token: str) -> None:
        super().__init__(f"{token} is never defined by the source")
        self.token = token


@dataclass
class Table:
    """The symbols of a setting in one environment. `choice` says which reading of each definition
    is taken.

    `needed` collects what was differentiated: a derivative has a value only where its function has
    one. `required` collects what sums and integrals rest on: bounds in order, convergence; `whole`
    what must be a whole number.
    `bound_domains` are the domains of bound names that occur in these.
    """

    setting: Setting
    environment: Environment
    choice: Mapping[str, int] = field(default_factory=dict)
    needed: list[Expr] = field(default_factory=list)
    required: list[Rel] = field(default_factory=list)
    whole: list[Expr] = field(default_factory=list)
    bound_domains: dict[str, Box] = field(default_factory=dict)
    used: dict[str, Value] = field(default_factory=dict)
    root: Bindings = field(default_factory=Bindings)
    _open: list[str] = field(default_factory=list)
    _count: int = 0
    _calls: int = 0

    def __post_init__(self) -> None:
        """The definitions' mutual use is worked out as it is asked for."""
        self._reach = Reach(self.setting.symbols)

    def symbol(self, token: str, bindings: Bindings | None = None) -> Value:
        """What a declared symbol stands for."""
        bindings = self.root if bindings is None else bindings
        if token in bindings.names:
            return bindings.names[token]
        if not self._reach.meets(token, bindings.names):
            bindings = self.root
        known = self.used if bindings is self.root else bindings.symbols
        if token in known:
            return known[token]
        entry = self.setting.symbols.get(token)
        if entry is None:
            raise Undecided(f"the symbol {token} is not declared")
        if token in self._open:
            raise Undecided(f"the definition of {token} uses itself")
        if known is not self.used and entry.domain:
            raise Undecided(f"{token} has a domain of its own and uses a bound name")
        self._open.append(token)
        try:
            found = self._meaning(token, entry, bindings)
        finally:
            self._open.pop()
        known[token] = found
        return found

    def _meaning(self, token: str, entry: SymbolEntry, bindings: Bindings) -> Value:
        match entry.role:
            case "quantity" if entry.shape is not None:
                raise Undecided(f"{token} is declared a matrix, its quantity is a number")
            case "quantity":
                return self._quantity(entry.quantity or "")
            case "free" if token in self.environment.assigned:
                return self.environment.assigned[token]
            case "free" if entry.shape is not None:
                names = entry_names(token, entry.shape)
                return matrix([[symbol(free_name(n)) for n in line] for line in names])
            case "free":
                return symbol(free_name(token))
            case "definition" if entry.definition is not None and not entry.arguments:
                found = self.under(self._defining(token, entry.definition).right, bindings)
                if entry.shape is not None and shape(found) != entry.shape:
                    raise Undecided(f"{token} is declared otherwise, it is {shape_text(found)}")
                return found
            case "undefined":
                raise UndefinedSymbol(token)
            case _:
                raise Undecided(f"{token} is a function; it stands here without arguments")

    def _quantity(self, name: str) -> Expr:
        known = self.environment.quantities
        if name in known:
            return known[name]
        if not known and name in ("sampling_interval", "sample_number"):
            return symbol(name)
        raise Undecided(
            self.environment.missing.get(name, f"{name} is not known in {self.environment.name}")
        )

    def _defining(self, token: str, definition: Formula) -> Relation:
        readings = definition.readings
        reading = readings[min(self.choice.get(token, 0), len(readings) - 1)]
        if reading.conditions:
            raise Undecided(f"the definition of {token} holds under conditions only")
        return reading.relations[0]

    def under(self, graph: Graph, bindings: Bindings) -> Value:
        """What a graph stands for under the bindings."""
        return evaluated(read_tree(graph), self, bindings)

    def is_declared(self, token: str) -> bool:
        """Whether the table of symbols has it."""
        return token in self.setting.symbols

    def function(self, name: str, arguments: Sequence[Value], bindings: Bindings) -> Value:
        """The value of a declared function: its body with fresh names for the arguments, into which
        these are then put, so that the body may differentiate or sum.
        """
        entry = self.setting.symbols[name]
        if entry.definition is None or len(entry.arguments) != len(arguments):
            raise Undecided(f"the function {name} is not covered")
        if name in self._open:
            raise Undecided(f"the definition of {name} uses itself")
        self._calls += 1
        if self._calls > MOST_CALLS:
            raise Undecided(f"a formula with more than {MOST_CALLS} functions put in")
        inner: dict[str, Value] = {}
        given: dict[str, Expr] = {}
        for token, value in zip(entry.arguments, arguments, strict=True):
            if isinstance(value, Expr):
                fresh = self._fresh(token)
                inner[token], given[fresh.name] = fresh, value
            else:
                inner[token] = value
        marks = len(self.needed), len(self.required), len(self.whole)
        self._open.append(name)
        try:
            body = self._defining(name, entry.definition).right
            found = self.under(body, bindings.having(inner))
        finally:
            self._open.pop()
        self._put_in(given, marks)
        return mapped(found, lambda entry: substituted(entry, given))

    def _fresh(self, token: str) -> Expr:
        self._count += 1
        return symbol(f"bound {token} {self._count}")

    def _put_in(self, values: Mapping[str, Expr], marks: tuple[int, int, int]) -> None:
        """Bound names replaced in what was collected since the marks."""
        needed, required, whole = marks
        self.needed[needed:] = [substituted(e, values) for e in self.needed[needed:]]
        self.required[required:] = [
            Rel(r.operator, substituted(r.left, values), substituted(r.right, values))
            for r in self.required[required:]
        ]
        self.whole[whole:] = [substituted(e, values) for e in self.whole[whole:]]

    def refuse_free_index(self, body: Expr, token: str) -> None:
        """Raises Undecided if a free symbol below has the token, a whole number, as its index."""
        self._reach.refuse_free_index(body, token)

    def bound(
        self, kind: str, body: Expr, token: str, low: Value, high: Value, bindings: Bindings
    ) -> Value:
        """A sum, a product or an integral of `body` over the bound name `token`."""
        first, last = number_of(low), number_of(high)
        self._reach.refuse_indexed(body, token)
        fresh = self._fresh(token)
        lower, upper = constant_value(first), constant_value(last)
        self.bound_domains[fresh.name] = Box(lower, upper, False, False, kind != "integral")
        if kind != "integral":
            self.whole += [bound for bound in (first, last) if bound != INFINITE]
        mark = len(self.needed)
        value = evaluated(body, self, bindings.having({token: fresh}))
        if any(fresh.name in symbols_of(e) for e in self.needed[mark:]):
            raise Undecided(f"a {kind} of derivatives over {token}")
        if kind == "product":
            factors = [put_in(value, {fresh.name: n}) for n in range_of(first, last)]
            return multiplied(factors) if factors else number(1)
        work = sum_of if kind == "sum" else integral_of

        def each(entry: Expr) -> Expr:
            found, required = work(entry, fresh.name, first, last)
            self.required += required
            return found

        return mapped(value, each)

    def derivative(self, value: Value, token: str, bindings: Bindings) -> Value:
        """Total derivative: partial with respect to a base variable, else the quotient of two
        derivatives.
        """
        target = number_of(self.symbol(token, bindings), "the variable of a derivative")

        def each(entry: Expr) -> Expr:
            self.needed.append(entry)
            if target.kind == "symbol":
                return differentiated(entry, target.name)
            variables = symbols_of(target)
            if len(variables) != 1 or not symbols_of(entry) <= variables:
                raise Undecided(
                    f"a derivative with respect to {token}, which depends on several variables"
                )
            name = next(iter(variables))
            return differentiated(entry, name) / differentiated(target, name)

        return mapped(value, each)

    def expectation(self, value: Value) -> Value:
        """The expectation over the symbols that are declared noises."""
        variances = {
            free_name(token): number_of(self.under(entry.variance, self.root))
            for token, entry in self.setting.symbols.items()
            if entry.variance is not None
        }
        return mapped(value, lambda entry: expectation_of(entry, variances))
