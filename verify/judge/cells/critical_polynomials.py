"""The polynomials at whose zeros the truth of a statement can change."""

from __future__ import annotations

from gainproof.verify.judge.cells.cell_statement import Task
from gainproof.verify.judge.cells.parameter_polynomials import irreducible, over
from gainproof.verify.judge.exact.expression import walk
from gainproof.verify.judge.exact.norm_factors import ground_factors, highest_root
from gainproof.verify.judge.exact.polynomial import Poly, Ring, ring
from gainproof.verify.judge.exact.statement import ALLOWED, STRICT, Rel
from gainproof.verify.judge.exact.truth import Question
from gainproof.verify.judge.exact.work_limits import Limits


class CellQuestion(Question):
    """The tower of a task over all its parameters, and the factors that cut its box into cells."""

    def __init__(self, task: Task, limits: Limits) -> None:
        super().__init__(task.statement, task.boxes, task.names, limits)
        self.task = task
        names = [self.tower.names[i] for i in self.tower.parameter_indices]
        self.ring: Ring = ring(names)

    def factors_of(self, p: Poly, *, careful: bool = False) -> list[Poly]:
        """Irreducible polynomials of the parameters, one of which is zero where p may change sign
        or begin to vanish.
        """
        found = ground_factors(self.tower, p, careful=careful)
        return irreducible(over(self.ring, f) for f in found)

    def careful_cuts(self) -> list[Poly]:
        """All of them for divisors, radicands and differences, on curves too."""
        elements = [check.poly for check in self.tower.checks]
        elements += [self.tower.element(d).num for d in self.differences.values()]
        return irreducible(f for p in elements for f in self.factors_of(p, careful=True))

    def of_relation(self, rel: Rel) -> list[Poly]:
        """The same for the difference of two sides."""
        return self.factors_of(self.tower.element(self.differences[rel]).num)

    def of_checks(self) -> list[Poly]:
        """The same for every divisor and radicand."""
        return irreducible(f for c in self.tower.checks for f in self.factors_of(c.poly))

    def cuts(self) -> list[Poly]:
        """All of them; an equation that should hold is compared in each cell and needs none."""
        found = self.of_checks()
        lazy = self.statement.relations if self.statement.connective == "if" else ()
        for rel in self.differences:
            if rel.operator != "=" or rel not in lazy:
                found += self.of_relation(rel)
        return irreducible(found)

    def borders(self) -> list[Poly]:
        """Those at which truth can differ from that of the cells near by.

        Elsewhere all parts are analytic and no condition changes; what then holds on a dense open
        set holds everywhere if it is =, <= or >=, and < and > cannot change where the difference is
        not zero.
        """
        found = self.of_checks()
        for rel in self.statement.domain:
            found += self.of_relation(rel)
        joined = self.statement.connective != "if"
        for rel in self.statement.all_relations() if joined else self.statement.relations:
            if joined or rel.operator in STRICT:
                found += self.of_relation(rel)
        return irreducible(found)

    def all_borders(self) -> list[Poly]:
        """Those and all at which two sides may be equal."""
        found = self.of_checks()
        for rel in self.statement.all_relations():
            found += self.of_relation(rel)
        return irreducible(found)

    def equation(self) -> Rel | None:
        """A condition that is an equation of polynomials, not satisfied identically: everything
        that matters lies where it holds.
        """
        for rel in self.statement.domain:
            num = self.tower.element(self.differences[rel]).num
            if rel.operator == "=" and not num.is_zero() and highest_root(self.tower, num) is None:
                return rel
        return None

    def never_has_value(self) -> bool:
        """Whether a divisor of a relation is identically zero."""
        below = {n.key for rel in self.statement.relations for n in walk(rel.left, rel.right)}
        return any(
            check.root is None and check.poly.is_zero() and check.node.key in below
            for check in self.tower.checks
        )

    def domain_polynomials(self) -> list[tuple[Poly, int]]:
        """Polynomials of the parameters, each with the sign it does not have where the conditions
        hold: as many as are plain.
        """
        found = []
        for rel in self.statement.domain:
            element = self.tower.element(self.differences[rel])
            plain = highest_root(self.tower, element.num) is None and element.den.is_constant()
            if plain and rel.operator in ("<", "<=", ">", ">="):
                found.append(
                    (
                        over(self.ring, element.num / element.den.leading_coefficient()),
                        1 if rel.operator in ("<", "<=") else -1,
                    )
                )
        return found

    def cannot_apply(self) -> bool:
        """Whether a condition is false wherever it has a value."""
        for rel in self.statement.domain:
            element = self.tower.element(self.differences[rel])
            if not (element.num.is_constant() and element.den.is_constant()):
                continue
            sign = element.num.leading_coefficient() / element.den.leading_coefficient()
            if (sign > 0) - (sign < 0) not in ALLOWED[rel.operator]:
                return True
        return False
