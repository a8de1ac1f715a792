"""The table of symbols of a setting as an evaluation sees it: functions, derivatives, sums,
integrals, expectations.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TypeVar

from gainproof.verify.judge.claim.record import Setting, SymbolEntry
from gainproof.verify.judge.dimensions.dimension import ONE, Dimension, Dimensions, Mismatch
from gainproof.verify.judge.dimensions.formula import DEGREE, ONE_OVER_DEGREE, dimension, names_of
from gainproof.verify.judge.dimensions.symbol_dimensions import has_degrees
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, neg, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.formula_tree import read_tree
from gainproof.verify.judge.exact.free_names import free_name, is_free
from gainproof.verify.judge.exact.simplification import tidied
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.total_expressions import is_total
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.meaning.bindings import Bindings
from gainproof.verify.judge.meaning.definition_names import names_in
from gainproof.verify.judge.meaning.derivatives import (
    along_pair,
    partial_derivative,
    slope_of,
    total_derivative,
)
from gainproof.verify.judge.meaning.evaluation import evaluated, number_of
from gainproof.verify.judge.meaning.expectation import expectation_of
from gainproof.verify.judge.meaning.integrals import integral_of
from gainproof.verify.judge.meaning.noises import holds_noise, noises_in, refuse_bound
from gainproof.verify.judge.meaning.sequences import indexed
from gainproof.verify.judge.meaning.sums import INFINITE, product_of, range_of, sum_of
from gainproof.verify.judge.meaning.symbol_lookup import Marks
from gainproof.verify.judge.meaning.symbols import Symbols
from gainproof.verify.judge.meaning.value import Value, entries, mapped, multiplied, put_in
from gainproof.verify.judge.setting.environment import SAMPLE

MOST_CALLS = 500
"""Functions put in, all together: calls inside calls double with every definition."""
_Item = TypeVar("_Item")
PI = Expr("call", "pi", ())


@dataclass
class Table(Symbols):
    """Everything that an evaluation asks for.

    `averages` counts expectations, `outside` holds what else in the formulas has noises.
    """

    sequences: set[str] = field(default_factory=set)
    averages: int = 0
    outside: list[Expr] = field(default_factory=list)
    _count: int = 0
    _calls: int = 0

    def under(self, graph: Graph, bindings: Bindings) -> Value:
        """What a graph stands for under the bindings."""
        return evaluated(read_tree(graph), self, bindings)

    def angle(self, argument: Expr, value: Expr) -> Expr:
        """The value of an argument of a sine or the like in radians. Raises Undecided."""
        return in_radians(argument, value, self.setting)

    def function(self, name: str, arguments: Sequence[Value], bindings: Bindings) -> Value:
        """The value of a declared function: its body with fresh names for the arguments, into which
        these are then put, so that the body may differentiate or sum.
        """
        entry = self.setting.symbols[name]
        if entry.definition is None or len(entry.arguments) != len(arguments):
            raise Undecided(f"the function {name} is not covered")
        if name in self.opened:
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
        marks = self._marks()
        body = self.defining(name, entry.definition).right
        for token in entry.arguments:
            self.reach.refuse_free_index(read_tree(body), token)
        before = self.averages
        self.opened.append(name)
        try:
            found = self.under(body, bindings.having(inner))
        finally:
            self.opened.pop()
        if self.averages > before:
            self._refuse_noise(*given.values())
        for token in entry.arguments:
            self.refuse_own_terms(found, token)
        self._put_in(given, marks)
        return mapped(found, lambda entry: substituted(entry, given))

    def _fresh(self, token: str) -> Expr:
        self._count += 1
        return symbol(f"bound {token} {self._count}")

    def marks_alone(self, body: Expr) -> Marks | None:
        """How much is collected before a body of free symbols alone; None for any other, of which
        something may be known before.
        """
        entries = [self.setting.symbols.get(token) for token in names_in(body)]
        is_free = all(entry is None or entry.role == "free" for entry in entries)
        return self._marks() if is_free else None

    def _marks(self) -> Marks:
        return len(self.needed), len(self.required), len(self.whole), len(self.slopes)

    def _put_in(self, values: Mapping[str, Expr], marks: Marks) -> None:
        """Bound names replaced in what was collected since the marks."""
        needed, required, whole, slopes = marks
        self.slopes[slopes:] = [slope.put_in(values) for slope in self.slopes[slopes:]]
        self.needed[needed:] = [substituted(e, values) for e in self.needed[needed:]]
        self.required[required:] = [
            Rel(r.operator, substituted(r.left, values), substituted(r.right, values))
            for r in self.required[required:]
        ]
        self.whole[whole:] = [substituted(e, values) for e in self.whole[whole:]]

    def require_at(self, token: str, values: Mapping[str, Expr], since: Marks | None) -> None:
        """Notes that sums and integrals must have values where a symbol is replaced: their closed
        forms have values beyond, as that of a geometric series at 2. There alone, if it is known
        since when they were collected.
        """
        marks = self._marks() if since is None else since
        if since is None:
            self.needed += self.needed
            self.required += self.required
            self.whole += self.whole
            self.slopes += self.slopes
        self._put_in(values, marks)
        # what does not hold the symbol stays as it is, and is asked once
        _without_repeated(self.needed, marks[0])
        _without_repeated(self.required, marks[1])
        _without_repeated(self.whole, marks[2])
        _without_repeated(self.slopes, marks[3])
        self._refuse_noise(symbol(free_name(token)), *values.values())
        if max(self._marks()) > MOST_CALLS:
            raise Undecided("a formula with too many sums in which a symbol is replaced")
        if self.setting.symbols[token].integer:
            self.whole += values.values()

    def refuse_free_index(self, body: Expr, token: str) -> None:
        """Raises Undecided if a free symbol below has the token, a whole number, as its index."""
        self.reach.refuse_free_index(body, token)

    def refuse_own_terms(self, value: Value, token: str) -> None:
        """Raises Undecided if a symbol that changes or is replaced is a term of a sequence in the
        value, where it stands as a term and not as the symbol.
        """
        parsed = indexed(token)
        if parsed is None:
            return
        own = parsed.term(number(0)).name
        if any(node.kind == "call" and node.name == own for node in walk(*entries(value))):
            raise Undecided(f"{token} is a term of a sequence that is summed here")

    def bound(
        self, kind: str, body: Expr, token: str, low: Value, high: Value, bindings: Bindings
    ) -> Value:
        """A sum, a product or an integral of `body` over the bound name `token`."""
        first, last = number_of(low), number_of(high)
        if first == INFINITE or (kind != "integral" and first == neg(INFINITE)):
            raise Undecided(f"{kind} from infinity")
        fresh = self._fresh(token)
        inner = {token: fresh, **self._terms(body, token, fresh)}
        lower, upper = constant_value(first), constant_value(last)
        self.bound_domains[fresh.name] = Box(lower, upper, False, False, kind != "integral")
        if kind != "integral":
            self.whole += [bound for bound in (first, last) if bound != INFINITE]
        mark = len(self.needed)
        value = evaluated(body, self, bindings.having(inner))
        if any(fresh.name in symbols_of(e) for e in self.needed[mark:]):
            raise Undecided(f"a {kind} of derivatives over {token}")
        self.refuse_own_terms(value, token)
        if kind == "product" and not isinstance(value, Expr):
            factors = [put_in(value, {fresh.name: n}) for n in range_of(first, last)]
            return multiplied(factors) if factors else number(1)
        work = {"sum": sum_of, "product": product_of, "integral": integral_of}[kind]

        def each(entry: Expr) -> Expr:
            found, required = work(entry, fresh.name, first, last)
            self.required += required
            return found

        return mapped(value, each)

    def _terms(self, body: Expr, index: str, fresh: Expr) -> dict[str, Expr]:
        """Free symbols of a body that have the bound name as their index, as terms of sequences."""
        found: dict[str, Expr] = {}
        for token in set(names_in(body)):
            parsed, entry = indexed(token), self.setting.symbols.get(token)
            if parsed and parsed.base == index and entry is not None and entry.role == "free":
                if entry.variance is not None or entry.domain or entry.shape is not None:
                    raise Undecided(
                        f"a sum of {token}, a noise, a matrix or with a domain of its own"
                    )
                at = fresh + parsed.offset if parsed.offset else fresh
                found[token] = parsed.term(at)
                self.sequences.add(parsed.stem)
        self.reach.refuse_indexed(body, index, found)
        return found

    def derivative(self, value: Value, token: str, bindings: Bindings) -> Value:
        """Total derivative: partial with respect to a base variable, else the quotient of two
        derivatives.
        """
        target = number_of(self.symbol(token, bindings), "the variable of a derivative")
        entry = self.setting.symbols.get(token)
        if entry is not None and (entry.integer or entry.quantity == SAMPLE):
            # what is said of whole numbers alone, such as a sum of n terms, has no one slope
            raise Undecided(f"a derivative with respect to {token}, which is a whole number")
        self._refuse_noise(target)
        self.refuse_own_terms(value, token)
        environment, own = self.environment, self.environment.parameter or ""
        self.needed += entries(value)
        if environment.pair and token not in bindings.names:
            known, rates = self._rates(token, *entries(value))
            if known is not None or rates:
                return mapped(value, lambda entry: along_pair(entry, known, rates, environment))
        if target.kind == "symbol" and environment.moves_with(target.name, *entries(value)):
            rate = self.rate(target.name)
            return mapped(value, lambda entry: total_derivative(entry, target.name, own, rate))
        if token == environment.intensity and token not in bindings.names:
            below = differentiated(target, own)
            return mapped(value, lambda entry: differentiated(entry, own) / below)

        def partial(entry: Expr) -> Expr:
            found = partial_derivative(entry, target, token, environment)
            if target.kind == "symbol" and not environment.is_coordinate(target):
                self.slopes.append(slope_of(entry, target, found))
            return found

        return mapped(value, partial)

    def _rates(self, token: str, *of: Expr) -> tuple[str | None, Mapping[str, Expr]]:
        """How two parameters change with a symbol, and the base variable that it is, if they may
        change with it; nothing for any other.
        """
        target = self.plain_value(token)
        if token in self.environment.fixing:
            return None, self.pair(token).rates(token, target)
        if target.kind == "symbol":
            if not self.environment.moves_with(target.name, *of):
                return None, {}
            return target.name, self.pair().rates(target.name, target)
        plain = tidied(target)
        names = symbols_of(plain)
        if len(names) != 1 or not names <= set(self.environment.pair):
            return None, {}
        # a parameter changes alone: everything else stays
        (name,) = names
        return None, {name: number(1) / differentiated(plain, name)}

    def expectation(self, value: Value, bindings: Bindings) -> Value:
        """The expectation over the symbols that are declared noises, with variances under the
        bindings: a function's argument or an index may stand in them. Raises Undecided.
        """
        found = noises_in(value, self.setting.symbols)
        refuse_bound(found, bindings)
        variances = {
            token: self._variance(token, entry, bindings) for token, entry in found.items()
        }
        self.averages += 1
        known = {free_name(token): variance for token, variance in variances.items()}
        normal = {free_name(token) for token, entry in found.items() if entry.normal}
        return mapped(value, lambda entry: expectation_of(entry, known, normal, self.needed))

    def _variance(self, token: str, entry: SymbolEntry, bindings: Bindings) -> Expr:
        """The variance of a noise, at least 0: a symbol is supposed to be, else it is required."""
        if entry.variance is None or "variance" in self.opened:
            raise Undecided("a variance that is an expectation itself")
        self.opened.append("variance")
        try:
            variance = number_of(self.under(entry.variance, bindings), f"the variance of {token}")
        finally:
            self.opened.pop()
        if holds_noise([variance], self.setting.symbols):
            raise Undecided(f"the variance of {token} is random itself")
        at_least_0 = Rel(">=", variance, number(0))
        if is_free(variance):
            self.supposed.append(at_least_0)
        elif at_least_0 not in self.required:
            self.required.append(at_least_0)
        if not is_total(variance):
            self.needed.append(variance)
        return variance

    def _refuse_noise(self, *outside: Expr) -> None:
        """Raises Undecided for a noise that stands outside of an expectation, beside one."""
        if self.averages and holds_noise(outside, self.setting.symbols):
            raise Undecided("a noise outside of an expectation, beside one: no fixed number")


def _without_repeated(found: list[_Item], start: int) -> None:
    """Leaves out what stands in a list from a place on and before too, or twice."""
    before = set(found[:start])
    found[start:] = [item for item in dict.fromkeys(found[start:]) if item not in before]


def in_radians(argument: Expr, value: Expr, setting: Setting) -> Expr:
    """The `value` of the `argument` of a sine or the like, in radians: one in degrees is turned,
    one that a print turns itself, `\\pi \\theta/180`, is left. Raises Undecided where nobody can
    tell.
    """
    if not has_degrees(setting) or not symbols_of(value):
        return value
    as_number = _dimension(argument, setting, ONE)
    if as_number == ONE:
        return value
    if not any(node == PI for node in walk(value)):
        if as_number == DEGREE:
            return PI * value / 180
    elif _dimension(argument, setting, ONE_OVER_DEGREE) == ONE:
        return value
    raise Undecided(
        "whether an angle is in degrees or in radians: write a sine of degrees without the number "
        "pi, or turn all of its angle, \\pi \\theta/180, and say the unit of every symbol"
    )


def _dimension(argument: Expr, setting: Setting, circle: Dimension) -> Dimensions | None:
    """The dimension where pi has that of the `circle`; None where dimensions are mixed."""
    try:
        return dimension(argument, names_of(setting).with_circle(circle))
    except Mismatch:
        return None
