"""The matrices of a model file at values of its symbols: exact numbers, or balls round those that
are not rational.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from math import ceil, log10

import flint

from gainproof.verify.check_enclosure import Box
from gainproof.verify.enclosure.structure import Model, bits_of, rounded
from gainproof.verify.judge.claim.model_file import ModelFile
from gainproof.verify.judge.claim.models import Rows
from gainproof.verify.judge.exact.balls import Balls, NoValue, Unresolved, compared
from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.constant_value import constant_value
from gainproof.verify.judge.exact.expression import Expr, number
from gainproof.verify.judge.exact.free_names import free_name
from gainproof.verify.judge.exact.work_limits import Malformed, Undecided
from gainproof.verify.judge.formula import Graph, Relation
from gainproof.verify.judge.reader.latex_printer import relations_to_latex
from gainproof.verify.judge.scope import Scope
from gainproof.verify.judge.setting.environment import algebra

PRECISION = 320
DIGITS = 70
"""Of a centre."""
MOST_BITS = 1000
"""Before and behind the point, of a number that is not rational."""


class NoNumberError(ValueError):
    """A model has no value at these values; the message says where."""


def model_at(file: ModelFile, values: Mapping[str, Fraction]) -> tuple[Model, Box | None]:
    """The model where its free symbols have these values, by token, and the covariance of its first
    prediction, if it says one.

    Raises NoNumberError where a symbol is missing, unknown or outside of its domain, and where an
    entry has no value.
    """
    reading = _Reading(file, values)
    own, n, m = file.model, len(file.states), len(file.measurements)
    f, h = reading.box("transition", own.transition), reading.box("measurement", own.measurement)
    q = _even(reading.box("process_noise", own.process_noise))
    r = _even(reading.box("measurement_noise", own.measurement_noise))
    none = Box([[Fraction(0)] * m for _ in range(n)])
    s = reading.box("cross_noise", file.cross) if file.cross else none
    start = _even(reading.box("start", file.start)) if file.start else None
    reading.require_domains()
    names = tuple(c.name for c in file.states), tuple(c.name for c in file.measurements)
    return Model(f, h, q, r, s, names), start


class _Reading:
    def __init__(self, file: ModelFile, values: Mapping[str, Fraction]) -> None:
        self.scope = Scope(file.setting, algebra())
        self.values = {free_name(token): number(x) for token, x in values.items()}
        self.given = dict(values)
        free = {token for token, entry in file.symbols.items() if entry.role == "free"}
        for token in values:
            if token not in free:
                known = ", ".join(sorted(free)) or "none"
                raise NoNumberError(f"{token} is no free symbol of the model; these are: {known}")
            if file.symbols[token].integer and values[token].denominator > 1:
                raise NoNumberError(f"{token} = {values[token]}: it is declared as a whole number")

    def box(self, name: str, rows: Rows) -> Box:
        pairs = [
            [self.entry(f"{name}, row {i}, column {j}", graph) for j, graph in enumerate(row, 1)]
            for i, row in enumerate(rows, 1)
        ]
        return Box([[c for c, _ in row] for row in pairs], [[r for _, r in row] for row in pairs])

    def entry(self, where: str, graph: Graph) -> tuple[Fraction, Fraction]:
        """The centre and the radius of an entry."""
        try:
            found = self.at(graph)
            value = constant_value(found)
            if value is not None:
                return value, Fraction(0)
            ball = Balls({}, PRECISION).round(found)
        except (Undecided, Malformed, NoValue, Unresolved) as error:
            raise NoNumberError(f"{where}: {error}") from None
        if not ball.is_finite():
            raise NoNumberError(f"{where}: no finite value")
        bits = bits_of(ball)
        if abs(bits) > MOST_BITS:
            raise NoNumberError(f"{where}: a number of about 2^{bits}")
        centre, radius = rounded(ball, bits - 2 * PRECISION)
        # decimals, outwards, so that certificates stay short
        grid = Fraction(10) ** (ceil(bits * log10(2)) - DIGITS)
        near = round(centre / grid) * grid
        return near, ceil((radius + abs(centre - near)) / grid) * grid

    def at(self, graph: Graph) -> Expr:
        found = self.scope.expression(graph)
        for token, entry in self.scope.setting.symbols.items():
            if entry.role == "free" and token in self.scope.used and token not in self.given:
                raise NoNumberError(f"{token} has no value: say it with --at {token}=...")
        return substituted(found, self.values)

    def require_domains(self) -> None:
        """Raises NoNumberError for a value outside of the domain of a symbol that is used."""
        for token in tuple(self.scope.used):
            for relation in self.scope.setting.symbols[token].domain:
                if not self.holds(relation):
                    said = relations_to_latex([relation])
                    raise NoNumberError(f"{token} is outside of its domain, {said}")

    def holds(self, relation: Relation) -> bool:
        left, right = self.at(relation.left), self.at(relation.right)
        a, b = (Balls({}, PRECISION).round(side) for side in (left, right))
        exact = constant_value(left - right)
        if exact is not None:
            a, b = flint.arb(flint.fmpq(exact.numerator, exact.denominator)), flint.arb(0)
        if a.is_exact() and b.is_exact() and a == b:
            return relation.operator in ("=", "<=", ">=")
        return compared(relation.operator, a, b) is True


def _even(box: Box) -> Box:
    """The box, with balls across the diagonal made one: a covariance is symmetric."""
    c, r = [list(row) for row in box.c], [list(row) for row in box.radius]
    for i in range(len(c)):
        for j in range(i):
            apart = abs(c[i][j] - c[j][i])
            if c[i][j] != c[j][i] and apart <= r[i][j] + r[j][i]:
                r[i][j] = r[j][i] = apart + max(r[i][j], r[j][i])
                c[j][i] = c[i][j]
            elif c[i][j] == c[j][i]:
                r[i][j] = r[j][i] = max(r[i][j], r[j][i])
    return Box(c, r)
