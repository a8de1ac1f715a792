"""What the symbols of a setting stand for in one environment."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field

from gainproof.verify.judge.claim.record import Setting, SymbolEntry
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, number, symbol, symbols_of
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Formula, Graph, Relation
from gainproof.verify.judge.meaning.base_variables import entry_names
from gainproof.verify.judge.meaning.bindings import Bindings
from gainproof.verify.judge.meaning.definition_names import Reach
from gainproof.verify.judge.meaning.derivatives import Slope, rate_of_parameter
from gainproof.verify.judge.meaning.two_parameters import Pair, pair_of
from gainproof.verify.judge.meaning.value import (
    Value,
    matrix,
    shape,
    shape_text,
)
from gainproof.verify.judge.setting.environment import Environment


class UndefinedSymbol(Exception):
    """The formula uses a symbol that the source never defines."""

    def __init__(self, token: str) -> None:
        super().__init__(f"{token} is never defined by the source")
        self.token = token


@dataclass
class Symbols(ABC):
    """The symbols of a setting in one environment. `choice` says which reading of each definition
    is taken; `held` are symbols that stay while T or the deviation of the noise changes. `plain` is
    the environment in the parameters themselves, where this one is a chart of them.

    `needed` collects what was differentiated: a derivative has a value only where its function has
    one; `slopes` the derivatives themselves. `required` collects what sums and integrals rest on:
    bounds in order, convergence; `whole` what must be a whole number. `supposed` is that symbols
    declared to be variances are at least 0. `bound_domains` are the domains of bound names that
    occur in these.
    """

    setting: Setting
    environment: Environment
    choice: Mapping[str, int] = field(default_factory=dict)
    held: tuple[str, ...] = ()
    plain: Environment | None = None
    needed: list[Expr] = field(default_factory=list)
    slopes: list[Slope] = field(default_factory=list)
    required: list[Rel] = field(default_factory=list)
    whole: list[Expr] = field(default_factory=list)
    supposed: list[Rel] = field(default_factory=list)
    bound_domains: dict[str, Box] = field(default_factory=dict)
    used: dict[str, Value] = field(default_factory=dict)
    root: Bindings = field(default_factory=Bindings)
    opened: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        """The definitions' mutual use is worked out as it is asked for."""
        self.reach = Reach(self.setting.symbols)

    def symbol(self, token: str, bindings: Bindings | None = None) -> Value:
        """What a declared symbol stands for."""
        bindings = self.root if bindings is None else bindings
        if token in bindings.names:
            return bindings.names[token]
        if not self.reach.meets(token, bindings.names):
            bindings = self.root
        known = self.used if bindings is self.root else bindings.symbols
        if token in known:
            return known[token]
        entry = self.setting.symbols.get(token)
        if entry is None:
            raise Undecided(f"the symbol {token} is not declared")
        if token in self.opened:
            raise Undecided(f"the definition of {token} uses itself")
        if known is not self.used and entry.domain:
            raise Undecided(f"{token} has a domain of its own and uses a bound name")
        self.opened.append(token)
        try:
            found = self._meaning(token, entry, bindings)
        finally:
            self.opened.pop()
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
                found = self.under(self.defining(token, entry.definition).right, bindings)
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

    def defining(self, token: str, definition: Formula) -> Relation:
        readings = definition.readings
        reading = readings[min(self.choice.get(token, 0), len(readings) - 1)]
        if reading.conditions:
            raise Undecided(f"the definition of {token} holds under conditions only")
        return reading.relations[0]

    @abstractmethod
    def under(self, graph: Graph, bindings: Bindings) -> Value:
        """What a graph stands for under the bindings."""

    def is_declared(self, token: str) -> bool:
        """Whether the table of symbols has it."""
        return token in self.setting.symbols

    def is_shared(self, name: str, *of: Expr) -> bool:
        """Whether expressions change with a base variable in a way that they do not show."""
        if not self.environment.moves_with(name, *of):
            return False
        if self.environment.pair:
            return self.pair().moves(name)
        return self.rate(name) != number(0)

    def plain_value(self, token: str) -> Expr:
        """What a symbol that is a number stands for in the parameters themselves."""
        scope = self if self.plain is None else self.there(self.plain)
        found = scope.symbol(token)
        if not isinstance(found, Expr):
            raise Undecided(f"{token} is a matrix, not a number")
        return found

    def there(self, environment: Environment) -> Symbols:
        """The same symbols in another environment."""
        return type(self)(self.setting, environment, self.choice, self.held)

    def pair(self, wanted: str | None = None) -> Pair:
        """How two parameters go with T, the deviation and what stays. Raises Undecided."""
        held = {token: self.plain_value(token) for token in self.held}
        return pair_of(held, self.plain or self.environment, wanted)

    def rate(self, name: str) -> Expr:
        """How the model's parameter changes with T or the deviation. Raises Undecided."""
        return rate_of_parameter(self.staying(), self.environment, name)

    def staying(self) -> dict[str, Expr]:
        """The symbols that stay while T or the deviation changes, as far as they are numbers."""
        held = {token: self.symbol(token) for token in self.held}
        return {token: value for token, value in held.items() if isinstance(value, Expr)}

    def refuse_moving(self, variable: Expr, *of: Expr) -> None:
        """Raises Undecided where the tracking index in expressions goes with a variable of a limit,
        and not as they show.
        """
        names = symbols_of(variable)
        if names.isdisjoint(self.environment.own_variables()):
            for name in names:
                if self.is_shared(name, *of):
                    raise Undecided("a limit in a symbol with which the tracking index changes")
