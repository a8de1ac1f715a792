"""Formulas of a claim file as expressions of the base variables of its setting."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from gainproof.verify.judge.claim_record import Setting, SymbolEntry
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated, rebuilt, substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, add, number, symbol, symbols_of, walk
from gainproof.verify.judge.exact.graph import read_graph
from gainproof.verify.judge.exact.limits import Undecided
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.formula import Formula, Graph, Relation
from gainproof.verify.judge.setting.environment import Environment

MOST_NODES = 5_000
MOST_TERMS = 200
MOST_CALLS = 500
"""Functions put in, all together: calls inside calls double with every definition."""


class UndefinedSymbol(Exception):
    """The formula uses a symbol that the source never defines."""

    def __init__(self, token: str) -> None:
        super().__init__(f"{token} is never defined by the source")
        self.token = token


@dataclass
class Scope:
    """The symbols of a setting in one environment. `choice` says which reading of each definition
    is taken.

    `needed` collects what was differentiated: a derivative has a value only where its function has
    one.
    """

    setting: Setting
    environment: Environment
    choice: Mapping[str, int] = field(default_factory=dict)
    needed: list[Expr] = field(default_factory=list)
    used: dict[str, Expr] = field(default_factory=dict)
    _open: list[str] = field(default_factory=list)
    _calls: int = 0

    def expression(self, graph: Graph) -> Expr:
        """A graph in base variables. Raises Malformed, Undecided, UndefinedSymbol."""
        return self._resolved(read_graph(graph))

    def relation(self, relation: Relation) -> Rel:
        """A relation with both sides resolved."""
        return Rel(
            relation.operator, self.expression(relation.left), self.expression(relation.right)
        )

    def _resolved(self, expr: Expr, local: Mapping[str, Expr] | None = None) -> Expr:
        local = local or {}

        def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
            match node.kind:
                case "symbol":
                    return local[node.name] if node.name in local else self.symbol(node.name)
                case "derivative":
                    return self._derivative(parts[0], node.name)
                case "at":
                    target = self.symbol(node.name)
                    if target.kind != "symbol":
                        raise Undecided(f"substitution for {node.name}, which is no free symbol")
                    return substituted(parts[0], {target.name: parts[1]})
                case "call":
                    return self._call(node, parts)
                case _:
                    return None

        if any(node.kind == "call" and node.name == "sum" for node in walk(expr)):
            expr = self._with_sums(expr)
        result = rebuilt(expr, change)
        if sum(1 for _ in walk(result)) > MOST_NODES:
            raise Undecided(
                f"a formula of more than {MOST_NODES} parts once its definitions are put in"
            )
        return result

    def symbol(self, token: str) -> Expr:
        """What a declared symbol stands for."""
        if token in self.used:
            return self.used[token]
        entry = self.setting.symbols.get(token)
        if entry is None:
            raise Undecided(f"the symbol {token} is not declared")
        if token in self._open:
            raise Undecided(f"the definition of {token} uses itself")
        self._open.append(token)
        try:
            found = self._meaning(token, entry)
        finally:
            self._open.pop()
        self.used[token] = found
        return found

    def _meaning(self, token: str, entry: SymbolEntry) -> Expr:
        if entry.shape is not None:
            # as a number it would commute with everything
            raise Undecided(f"{token} is a matrix, and claims about matrices are not covered")
        match entry.role:
            case "quantity":
                name = entry.quantity or ""
                known = self.environment.quantities
                if name in known:
                    return known[name]
                why = self.environment.missing.get(
                    name, f"{name} is not known in {self.environment.name}"
                )
                if not known and name in ("sampling_interval", "sample_number"):
                    return symbol(name)
                raise Undecided(why)
            case "free":
                return symbol(free_name(token))
            case "definition" if entry.definition is not None and not entry.arguments:
                return self.expression(self._defining(token, entry.definition).right)
            case "undefined":
                raise UndefinedSymbol(token)
            case _:
                raise Undecided(f"{token} is a function; it stands here without arguments")

    def _defining(self, token: str, definition: Formula) -> Relation:
        readings = definition.readings
        reading = readings[min(self.choice.get(token, 0), len(readings) - 1)]
        if reading.conditions:
            raise Undecided(f"the definition of {token} holds under conditions only")
        return reading.relations[0]

    def _call(self, node: Expr, parts: tuple[Expr, ...]) -> Expr:
        entry = self.setting.symbols.get(node.name)
        if entry is None or entry.definition is None or len(entry.arguments) != len(parts):
            raise Undecided(f"the function {node.name} is not covered")
        if node.name in self._open:
            raise Undecided(f"the definition of {node.name} uses itself")
        self._calls += 1
        if self._calls > MOST_CALLS:
            raise Undecided(f"a formula with more than {MOST_CALLS} functions put in")
        body = read_graph(self._defining(node.name, entry.definition).right)
        # What binds a name inside the body would meet the argument's value instead of its name.
        if any(part.kind in ("derivative", "at") or _is_sum(part) for part in walk(body)):
            raise Undecided(f"the definition of {node.name} differentiates, substitutes or sums")
        for name in entry.arguments:
            if self._reaches(body, name, set()):
                raise Undecided(f"a definition inside {node.name} uses {name}, its argument")
        self._open.append(node.name)
        try:
            return self._resolved(body, dict(zip(entry.arguments, parts, strict=True)))
        finally:
            self._open.pop()

    def _with_sums(self, expr: Expr) -> Expr:
        """Sums with numbers as bounds written out. Raises Undecided for others."""

        def change(node: Expr, parts: tuple[Expr, ...]) -> Expr | None:
            if node.kind != "call" or node.name != "sum":
                return None
            if len(parts) != 4 or parts[1].kind != "symbol":
                raise Undecided("a sum needs summand, index and both bounds")
            low, high = constant_value(parts[2]), constant_value(parts[3])
            if low is None or high is None or low.denominator != 1 or high.denominator != 1:
                raise Undecided("a sum with symbols as bounds is not covered")
            if not 0 <= high - low < MOST_TERMS:
                raise Undecided(f"a sum of more than {MOST_TERMS} terms or of none")
            index = parts[1].name
            others = symbols_of(parts[0]) - {index}
            if any(index in name for name in others):
                raise Undecided("a sum over indexed symbols is not covered")
            if self._reaches(parts[0], index, set()):
                raise Undecided(f"a sum over {index}, which a definition in it uses")
            return add(
                *[substituted(parts[0], {index: number(n)}) for n in range(int(low), int(high) + 1)]
            )

        return rebuilt(expr, change)

    def _reaches(self, expr: Expr, name: str, seen: set[str]) -> bool:
        """Whether a name stands in a definition that an expression uses; `seen` collects those
        looked into, so that each is once, however often it is used.
        """
        for node in walk(expr):
            if node.kind not in ("symbol", "call") or node.name in seen:
                continue
            seen.add(node.name)
            entry = self.setting.symbols.get(node.name)
            if entry is None or entry.definition is None or name in entry.arguments:
                continue
            for reading in entry.definition.readings:
                for relation in reading.relations:
                    body = read_graph(relation.right)
                    if name in symbols_of(body) or self._reaches(body, name, seen):
                        return True
        return False

    def _derivative(self, expr: Expr, token: str) -> Expr:
        """Total derivative: partial with respect to a base variable, else the quotient of two
        derivatives.
        """
        self.needed.append(expr)
        target = self.symbol(token)
        if target.kind == "symbol":
            return differentiated(expr, target.name)
        variables = symbols_of(target)
        if len(variables) != 1 or not symbols_of(expr) <= variables:
            raise Undecided(
                f"a derivative with respect to {token}, which depends on several variables"
            )
        name = variables.pop()
        return differentiated(expr, name) / differentiated(target, name)

    def labels(self) -> dict[str, str]:
        """Base variables in the source's own symbols, as far as it has them."""
        found = {name: name.removeprefix("free ") for name in self.boxes()}
        for token, entry in self.setting.symbols.items():
            if entry.role == "quantity" and entry.quantity in found:
                found[entry.quantity] = token
        return found

    def boxes(self) -> dict[str, Box]:
        """The domains of the base variables as the setting has them."""
        found = dict(self.environment.boxes)
        for token, entry in self.setting.symbols.items():
            if entry.role == "free":
                found[free_name(token)] = Box(stated=False, integer=entry.integer)
            elif entry.role == "quantity" and entry.quantity == "sampling_interval":
                found.setdefault(entry.quantity, Box(lower=Fraction(0)))
            elif entry.role == "quantity" and entry.quantity == "sample_number":
                found.setdefault(
                    entry.quantity, Box(lower=Fraction(0), lower_open=False, integer=True)
                )
        return found


def _is_sum(node: Expr) -> bool:
    return node.kind == "call" and node.name == "sum"


def free_name(token: str) -> str:
    """The name of the variable that a free symbol stands for; no quantity is named like that."""
    return f"free {token}"
