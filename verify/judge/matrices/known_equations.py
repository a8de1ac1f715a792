"""The equations known so far in a proof, and the search for what follows from them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from gainproof.verify.judge.matrices.equation import Cofactor, Equation
from gainproof.verify.judge.matrices.ideal_membership import (
    MOST_PRODUCTS,
    UnprovedError,
    products_for,
)
from gainproof.verify.judge.matrices.normal_form import NormalForm
from gainproof.verify.judge.matrices.polynomial import Polynomial

MOST_PARTED = 60
"""Terms of an equation of which parts between blocks are taken too."""


@dataclass
class Book(NormalForm):
    """A proof that is being found."""

    _contracted: list[Equation] = field(default_factory=list)
    _contracted_so_far: int = 0

    def vanishing(
        self, residual: Polynomial, more: Sequence[Equation] = (), most: int = MOST_PRODUCTS
    ) -> list[Cofactor]:
        """Cofactors whose sum the residual is, of at most so many products. Raises UnprovedError if
        none are found.
        """
        most = min(most, self.most)
        residual, replaced = self.without_elements(residual)
        self.budget.charge(sum(map(len, residual.terms)))
        value, trace = self.traced(residual)
        short = self.short(value)
        if not short.terms:
            return [*replaced, *trace, *self.contracted(value)[1]]
        if not most:
            raise UnprovedError("no proof was found")
        found = self._found(short, [*self._contracted_equations(), *more], most)
        return [*replaced, *trace, *self.contracted(value)[1], *found]

    def _contracted_equations(self) -> list[Equation]:
        """Every equation, and times the blocks with which its words begin or end."""
        alphabet = self.alphabet
        while self._contracted_so_far < len(self.equations):
            equation = self.equations[self._contracted_so_far]
            self._contracted_so_far += 1
            fresh = [self.contracted_equation(equation), *self._between_blocks(equation)]
            rows, columns = (alphabet.unit(size) for size in equation.value.shape)
            if len(equation.value.terms) > MOST_PARTED:
                fresh = fresh[:1]
            for number in sorted({w[0] // 2 for w in equation.value.terms if w and w[0] % 2}):
                if number in alphabet.place:
                    block = alphabet.letter(number)
                    fresh.append(equation.inside(block, columns))
            for number in sorted({w[-1] // 2 for w in equation.value.terms if w and not w[-1] % 2}):
                if number in alphabet.place:
                    block = alphabet.letter(number).T
                    fresh.append(equation.inside(rows, block))
            known = {e.value.key for e in self._contracted}
            for one in fresh:
                short = self.contracted_equation(self.normal(one))
                if short.value.terms and short.value.key not in known:
                    self._contracted.append(short)
        return self._contracted

    def _between_blocks(self, equation: Equation) -> list[Equation]:
        """The equation between blocks of the sizes with which its words begin or end."""
        alphabet, value = self.alphabet, equation.value
        rows, columns = value.shape
        begins = any(w and not w[0] % 2 and w[0] // 2 in alphabet.place for w in value.terms)
        ends = any(w and w[-1] % 2 and w[-1] // 2 in alphabet.place for w in value.terms)
        left = [alphabet.letter(n).T for n in alphabet.blocks.get(rows, ())] if begins else []
        right = [alphabet.letter(n) for n in alphabet.blocks.get(columns, ())] if ends else []
        one, two = alphabet.unit(rows), alphabet.unit(columns)
        pairs = [(a, two) for a in left] + [(one, b) for b in right]
        pairs += [(a, b) for a in left for b in right]
        return [equation.inside(a, b) for a, b in pairs]

    def _found(self, value: Polynomial, equations: Sequence[Equation], most: int) -> list[Cofactor]:
        values = [e.value for e in equations]
        found = products_for(value, values, self.alphabet, most, self.budget)
        if found is None:
            raise UnprovedError("no proof was found")
        cofactors, rest = list[Cofactor](), value
        for factor, (before, number, after) in found:
            equation = equations[number]
            left = Polynomial({before: factor}, (value.shape[0], equation.value.shape[0]))
            right = Polynomial({after: 1}, (equation.value.shape[1], value.shape[1]))
            cofactors += [c.inside(left, right) for c in equation.proof]
            rest = rest - left @ equation.value @ right
        left_over, trace = self.traced(rest)
        left_over, more = self.contracted(left_over)
        if left_over.terms:
            raise UnprovedError("the numbers found are not the right ones")
        return [*cofactors, *trace, *more]
