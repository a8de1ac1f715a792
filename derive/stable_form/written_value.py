"""One way of writing a value that was read: its graph, and the same with functions as symbols."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

import sympy as sp

from gainproof.derive.printer.graph import Graph, GraphBuilder, Node
from gainproof.derive.stable_form.difference_polynomials import Letters
from gainproof.derive.stable_form.function_atoms import Atom, Sources
from gainproof.derive.stable_form.graph_nodes import Emission, Order
from gainproof.derive.stable_form.polynomial_products import Product
from gainproof.derive.stable_form.real_values import Required
from gainproof.derive.stable_form.root_tower import Reading

VALUE, SCALE = "value", "scale_"


@dataclass(frozen=True)
class Text:
    """An expression without functions, its value over the variables of a reading, the atoms, and
    what is required to be positive.
    """

    expression: sp.Expr
    reading: Reading
    value: sp.Expr
    atoms: Mapping[str, Atom]
    required: tuple[Required, ...]


@dataclass(frozen=True)
class Writing:
    """A product of a text's value, and how it is written."""

    text: Text
    product: Product
    place: Fraction
    scale: Fraction
    order: Order

    def graph(self, abstract: bool) -> tuple[Graph, tuple[str, ...]]:
        """The graph and the names of what is left of subtractions.

        Its outputs are `VALUE`, `SCALE` where such are left: the same with both sides added; and
        with `abstract`, where atoms are symbols, the argument of each by its name.
        """
        builder = GraphBuilder()
        sources = Sources(
            builder,
            self.text.atoms,
            lambda atom: self._emission(builder, atom.reading, sources).product(atom.argument),
            abstract,
        )
        emission = self._emission(builder, self.text.reading, sources)
        outputs: dict[str, Node] = {VALUE: emission.product(self.product)}
        if emission.differences:
            added = self._emission(builder, self.text.reading, sources, added=True)
            outputs[SCALE] = builder.absolute(added.product(self.product))
        if abstract:
            outputs |= {name: sources.argument(atom) for name, atom in self.text.atoms.items()}
        return builder.graph(outputs, emission.differences), tuple(emission.differences)

    def _emission(
        self, builder: GraphBuilder, reading: Reading, sources: Sources, added: bool = False
    ) -> Emission:
        letters = Letters(reading, self.place, self.scale)
        return Emission(builder, letters, sources, self.order, added)
