"""Steps on example 1: the variances of table 1 as rational numbers, in m^2 and (m/s)^2."""

from __future__ import annotations

from functools import cached_property

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import Generator
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal, positive

NAME = "example"
ROOT = real("root_two")
STATIONS = 4
RANGE_DEVIATION, DOPPLER_DEVIATION = sp.Integer(10), sp.Rational(1, 10)
LATEX = {"root_two": r"\sqrt{2}"}

HALF = ROOT / 2
A_L = sp.ImmutableDenseMatrix([[HALF, HALF], [0, 1], [1, 0], [-HALF, -HALF]])
A_LD = sp.ImmutableDenseMatrix([[ROOT / 4, -ROOT / 4], [1, 0], [0, 0], [ROOT / 4, -ROOT / 4]]) / 50


def tower() -> Tower:
    """The numbers, with the root of 2."""
    return Tower(NAME, (), (Generator("root_two", sp.Integer(2)),), {})


class Choice:
    """The first `clean` ranges without a bias."""

    def __init__(self, clean: int) -> None:
        self.clean = clean

    @cached_property
    def design(self) -> sp.ImmutableDenseMatrix:
        """(144) to (146), each row over the deviation of its noise."""
        columns = sp.eye(STATIONS)[:, self.clean :]
        ranges = A_L.row_join(sp.zeros(STATIONS, 2)).row_join(columns) / RANGE_DEVIATION
        doppler = A_LD.row_join(A_L).row_join(sp.zeros(STATIONS, STATIONS - self.clean))
        return sp.ImmutableDenseMatrix(ranges.col_join(doppler / DOPPLER_DEVIATION))

    @cached_property
    def covariance(self) -> sp.ImmutableDenseMatrix:
        """The inverse of A' V^-1 A, with the symbol of the root of 2."""
        design = self.design.subs(ROOT, sp.sqrt(2))
        found = (design.T * design).inv().applyfunc(sp.radsimp)
        return sp.ImmutableDenseMatrix(found.subs(sp.sqrt(2), ROOT))

    @property
    def course(self) -> sp.ImmutableDenseMatrix:
        """Its corner of position and velocity."""
        return sp.ImmutableDenseMatrix(self.covariance[:4, :4])

    @property
    def course_design(self) -> sp.ImmutableDenseMatrix:
        """The rows of clean ranges and of Doppler, without biases."""
        rows = [*range(self.clean), *range(STATIONS, 2 * STATIONS)]
        return sp.ImmutableDenseMatrix(self.design.extract(rows, range(4)))

    def steps(self, sentence: str, reason: str) -> list[Step]:
        """The covariance, from the rows that count and from all of them."""
        rows, whole = self.course_design, self.design
        size = whole.cols
        return [
            Step(
                f"example-{self.clean}",
                sentence,
                equal(_product(rows.T, rows, self.course), sp.eye(4).as_immutable()),
                reason,
                NAME,
                heading="" if self.clean else "Example 1 and table 1",
            ),
            Step(
                f"example-{self.clean}-whole",
                "",
                equal(_product(whole.T, whole, self.covariance), sp.eye(size).as_immutable()),
                "",
                NAME,
                shown=False,
            ),
        ]


def _product(*factors: sp.MatrixBase) -> sp.MatMul:
    return sp.MatMul(*(sp.ImmutableDenseMatrix(factor) for factor in factors))


def _difference(left: sp.Expr, right: sp.Expr) -> sp.Expr:
    return sp.Add(left, -right, evaluate=False)


def example_steps() -> list[Step]:
    """Table 1, exactly; one of its numbers is not rounded."""
    last = Choice(4)
    variance = last.course[3, 3]
    return [
        *Choice(0).steps(
            "Example 1, (139) to (147), in a plane: four stations at rest, ranges to 10 m, Doppler "
            "to 0.1 m/s, uncorrelated; metres and seconds. With every row of (142) and (143) over "
            "the deviation of its noise, `n_b = 0` leaves the Doppler, and its covariance of `x, "
            "y, x', y'` is the third matrix: the variances `75`, `175` m^2, `1/100`, `1/50` "
            "(m/s)^2.",
            "Multiply: it is the inverse. The same corner has the inverse with all biases.",
        ),
        *Choice(2).steps(
            "With the first two ranges clean, `n_b = 2`, the variances are `1500/41`, `1700/41` "
            "m^2, `17/2050`, `27/2050` (m/s)^2:",
            "Likewise.",
        ),
        *last.steps(
            "And with all four, `n_b = 4`, they are `300/13`, `100/3` m^2, `1/130`, `7/650` "
            "(m/s)^2:",
            "Likewise.",
        ),
        Step(
            "table-last",
            "Their roots are table 1, each number but one rounded: the last, `0.1037...` m/s, is "
            "printed as 0.103 and rounds to 0.104.",
            positive(_difference(variance, sp.Rational(1035, 10000) ** 2)),
            "The square of 0.1035 is below `7/650`, that of 0.1045 above.",
            NAME,
        ),
        joined(
            "table-last-below",
            positive(_difference(sp.Rational(1045, 10000) ** 2, variance)),
            NAME,
        ),
    ]
