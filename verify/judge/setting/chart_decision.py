"""Statements decided over a chart: identities by a zero of the field, orders by signs on it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.certificate import statement_data
from gainproof.verify.judge.exact.polynomial import text
from gainproof.verify.judge.exact.statement import ALLOWED, ORDERS, Outcome, Rel, Statement
from gainproof.verify.judge.exact.work_limits import Undecided
from gainproof.verify.judge.setting.chart_field import HIGH, LOW, ChartField, SignInside, field_over
from gainproof.verify.judge.setting.quadrant_chart import sign_on_quadrant
from gainproof.verify.judge.setting.triangle_signs import sign_on_triangle

METHOD = "zero in a field of functions on a chart of all values of the two parameters"
SIGNS = "signs of polynomials on a chart of all values of the two parameters"
EQUAL = "the sides are equal everywhere"
INSIDE: Mapping[str, SignInside] = MappingProxyType(
    {"triangle": sign_on_triangle, "quadrant": sign_on_quadrant}
)
"""What is known of signs inside a chart, by its shape."""


@dataclass(frozen=True)
class Plane:
    """Decides statements whose base variables are those of the chart and free symbols; `names`
    are the parameters of which it is a chart.
    """

    names: tuple[str, str]
    sign_inside: SignInside = sign_on_triangle

    def decide(
        self, statement: Statement, boxes: Mapping[str, Box], labels: Mapping[str, str]
    ) -> Outcome:
        """`proved`; `refuted` if some relation fails on a dense set; `conditional` if all hold
        wherever the statement has a value. Neither has a witness. Raises Undecided.
        """
        if statement.connective != "if":
            raise Undecided("an equivalence over a chart")
        positive = {n: box.is_positive for n, box in boxes.items()}
        over = field_over(statement.symbols(), positive, self.sign_inside)
        for condition in statement.domain:
            if not _always(over, condition):
                raise Undecided("a condition that does not hold on the whole chart")
        for expr in statement.needed:
            over.element(expr)
        found = [(rel, _sign(over, rel)) for rel in statement.relations]
        wrong = [rel for rel, sign in found if sign not in ALLOWED[rel.operator]]
        orders = any(rel.operator in ORDERS for rel in statement.relations)
        method = SIGNS if orders else METHOD
        domain = ", ".join(f"{labels.get(name, name)} > 0" for name in self.names)
        own = {name: box for name, box in boxes.items() if name in statement.symbols()}
        certificate = {
            "chart": [LOW, HIGH],
            "roots": [text(p) for p in over.squares],
            "engine": "chart",
            "names": list(self.names),
            "signs": next(name for name, signs in INSIDE.items() if signs is self.sign_inside),
            "statement": statement_data(statement, own, None, labels),
        }
        if wrong:
            reason = "the sides differ on a dense set"
            if len(found) == 1 and found[0][1] == 0:
                reason = EQUAL
            return Outcome("refuted", "nowhere", reason, method, None, certificate)
        if over.gaps:
            if not all(gap.exact for gap in over.gaps.values()):
                raise Undecided("a divisor with roots that may vanish on the chart")
            return Outcome("conditional", domain, "", method, None, certificate)
        reason = "holds on the whole domain"
        return Outcome("proved", f"for {domain}", reason, method, None, certificate)


def _always(over: ChartField, rel: Rel) -> bool:
    return _sign(over, rel) in ALLOWED[rel.operator] and not over.gaps


def _sign(over: ChartField, rel: Rel) -> int:
    """The sign of the difference; 1 stands for any that is not zero where only that is asked.
    Raises Undecided.
    """
    left, right = over.element(rel.left), over.element(rel.right)
    minus = type(right)(-right.num, right.den)
    gap = over.sum(left, minus)
    if gap.num.is_zero():
        return 0
    if rel.operator == "=":
        return 1
    top, bottom = over.sign(gap.num), over.sign(gap.den)
    if top is None or bottom is None:
        raise Undecided("a sign that is not known on the chart")
    return top * bottom
