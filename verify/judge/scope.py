"""Formulas of a claim file as expressions of the base variables of its setting."""

from __future__ import annotations

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, symbol, walk
from gainproof.verify.judge.exact.free_names import token_of
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.formula import Graph, Relation
from gainproof.verify.judge.meaning.base_variables import domains, is_whole
from gainproof.verify.judge.meaning.bindings import Bindings
from gainproof.verify.judge.meaning.evaluation import number_of
from gainproof.verify.judge.meaning.noises import holds_noise
from gainproof.verify.judge.meaning.sequences import is_term, terms_of, with_variables
from gainproof.verify.judge.meaning.symbol_table import Table
from gainproof.verify.judge.meaning.symbols import UndefinedSymbol
from gainproof.verify.judge.meaning.value import (
    Value,
    entries,
    mapped,
    put_in,
    shape,
    shape_text,
    zeros_like,
)

MOST_NODES = 5_000

__all__ = ["Scope", "UndefinedSymbol"]


class Scope(Table):
    """The symbols of a setting in one environment, and the formulas of claims about it."""

    def value(self, graph: Graph, bindings: Bindings | None = None) -> Value:
        """A graph in base variables, a number or a matrix. Raises Malformed, Undecided,
        UndefinedSymbol.
        """
        found = self.under(graph, self.root if bindings is None else bindings)
        self.outside += [e for e in entries(found) if holds_noise([e], self.setting.symbols)]
        self._refuse_noise(*self.outside)
        if sum(1 for _ in walk(*entries(found))) > MOST_NODES:
            raise Undecided(
                f"a formula of more than {MOST_NODES} parts once its definitions are put in"
            )
        return found

    def expression(self, graph: Graph, bindings: Bindings | None = None) -> Expr:
        """A graph that stands for a number. Raises Undecided for terms of a sequence, of which only
        `relations` knows which symbols they are.
        """
        found = number_of(self.value(graph, bindings))
        if self.sequences and any(is_term(node) for node in walk(found)):
            raise Undecided("a sum over terms of a sequence is covered in relations only")
        return found

    def relation(self, relation: Relation) -> Rel:
        """A relation between numbers with both sides resolved."""
        return Rel(
            relation.operator, self.expression(relation.left), self.expression(relation.right)
        )

    def relations(self, relation: Relation) -> tuple[Rel, ...]:
        """A relation with both sides resolved; one between matrices entry by entry."""
        left, right = self.value(relation.left), self.value(relation.right)
        if self.sequences:
            terms = terms_of(self.sequences, self.setting.symbols, self._numbers())
            left, right = (mapped(put_in(v, terms), with_variables) for v in (left, right))
        operator = relation.operator
        if isinstance(left, Expr) and isinstance(right, Expr):
            return (Rel(operator, left, right),)
        if operator != "=":
            raise Undecided(f"the relation {operator} between matrices is not covered")
        left, right = zeros_like(left, right), zeros_like(right, left)
        if shape(left) != shape(right):
            raise Undecided(f"{shape_text(left)} on the left, {shape_text(right)} on the right")
        pairs = zip(entries(left), entries(right), strict=True)
        return tuple(Rel("=", a, b) for a, b in pairs)

    def _numbers(self) -> dict[str, Expr]:
        """The symbols that stand for whole numbers."""
        boxes = self.boxes()
        found = {t: self.symbol(t) for t, e in self.setting.symbols.items() if e.integer}
        return {
            token: value
            for token, value in found.items()
            if isinstance(value, Expr) and is_whole(value, boxes)
        }

    def uses_steady(self) -> bool:
        """Whether a symbol met so far stands for what only a stable filter has."""
        region = self.environment.region
        met = (self.setting.symbols[token].quantity or "" for token in self.used)
        return region is not None and any(name.startswith(region.steady) for name in met)

    def labels(self) -> dict[str, str]:
        """Base variables in the source's own symbols, as far as it has them."""
        found = {name: token_of(name) for name in self.boxes()}
        found |= {name: name.split()[1] for name in self.bound_domains}
        for token, entry in self.setting.symbols.items():
            value = self.environment.quantities.get(entry.quantity or "")
            if entry.role == "quantity" and entry.quantity in found:
                # a variance is no name for its deviation
                itself = value in (None, symbol(entry.quantity))
                if itself or entry.quantity in self.environment.charted:
                    found[entry.quantity] = token
            if self.environment.region is not None and value is not None:
                # a gain by the source's own name
                name = value.name if value.kind == "symbol" else ""
                if name in found:
                    found[name] = token
        return found

    def boxes(self) -> dict[str, Box]:
        """The domains of the base variables as the setting has them."""
        return domains(self.setting, self.environment)
