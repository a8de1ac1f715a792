"""The variables of a tower below its roots, and polynomials of them that are plainly positive."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.verify.judge.exact.polynomial import Poly, fraction, terms


@dataclass(frozen=True)
class Variables:
    """Which variables of the ring are what: names and positions of free symbols and parameters.

    Those named in `positive` are greater than zero, those in `nonnegative` not less.
    """

    free: tuple[str, ...]
    free_indices: tuple[int, ...]
    parameters: tuple[str, ...]
    parameter_indices: tuple[int, ...]
    positive: frozenset[str]
    nonnegative: frozenset[str] = frozenset()

    @property
    def above_zero(self) -> frozenset[int]:
        """Positions of the parameters that are greater than zero."""
        return self._named(self.positive)

    @property
    def from_zero(self) -> frozenset[int]:
        """Positions of the parameters that are not less than zero."""
        return self._named(self.positive | self.nonnegative)

    def _named(self, names: frozenset[str]) -> frozenset[int]:
        pairs = zip(self.parameter_indices, self.parameters, strict=True)
        return frozenset(i for i, name in pairs if name in names)

    def not_below_zero(self, p: Poly) -> bool:
        """Whether p has only parameters that are not negative, and only positive coefficients."""
        return not p.is_zero() and all(
            fraction(c) > 0 and all(i in self.from_zero for i, e in enumerate(exponents) if e)
            for exponents, c in terms(p)
        )

    def over_zero(self, p: Poly) -> bool:
        """The same, with one term at least that cannot be zero: then p is positive."""
        return self.not_below_zero(p) and any(
            all(i in self.above_zero for i, e in enumerate(exponents) if e)
            for exponents, _ in terms(p)
        )
