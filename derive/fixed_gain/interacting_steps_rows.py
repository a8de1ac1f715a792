"""A step on what a covariance equation says along the eigenvectors of its matrix."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.relation import cited
from gainproof.derive.source import MATRICES
from gainproof.derive.words.expression import ZERO, Expression, symbols
from gainproof.derive.words.hypotheses import equation, symmetric
from gainproof.derive.words.search import Search
from gainproof.derive.words.setting import Setting
from gainproof.derive.words.statement import prove_equal

NAME = "rows"
LOOP, CARRIED, BROUGHT = symbols("loop_matrix carried brought")
FIRST, SECOND, TAIL, SECOND_TAIL = symbols("first_row second_row first_tail second_tail")
REAL, IMAGINARY = symbols("real_part imaginary_part")
SETTING = Setting(
    NAME,
    {
        **dict.fromkeys(("loop_matrix", "carried", "brought"), "n n"),
        **dict.fromkeys(("first_row", "second_row", "first_tail", "second_tail"), "n 1"),
    },
    free=("real_part", "imaginary_part"),
)
LATEX = {
    "loop_matrix": "M",
    "carried": "X",
    "brought": "Q",
    "first_row": "p",
    "second_row": "q",
    "first_tail": "m",
    "second_tail": "n",
    "real_part": "c",
    "imaginary_part": "s",
}


def row_steps() -> list[Step]:
    """X = M X M' + Q along the real and the imaginary part of a left eigenvector of M."""
    kept = equation(CARRIED, LOOP @ CARRIED @ LOOP.T + BROUGHT)
    given = [
        symmetric("carried"),
        kept,
        equation(FIRST.T @ LOOP, REAL * FIRST.T - IMAGINARY * SECOND.T + TAIL.T),
        equation(SECOND.T @ LOOP, IMAGINARY * FIRST.T + REAL * SECOND.T + SECOND_TAIL.T),
        equation(TAIL.T @ CARRIED, ZERO),
        equation(SECOND_TAIL.T @ CARRIED, ZERO),
    ]

    def both(matrix: Expression) -> Expression:
        return FIRST.T @ matrix @ FIRST + SECOND.T @ matrix @ SECOND

    found = prove_equal(
        "along-rows",
        Search(SETTING, given, heavy=("brought",)),
        (1 - REAL**2 - IMAGINARY**2) * both(CARRIED),
        both(BROUGHT),
    )
    return [
        found.step(
            "First any real matrix `M`. To an eigenvalue `c + i s` belong real rows `p'` and "
            "`q'`, not both 0, the real and the imaginary part of a left eigenvector, with `m' = "
            "n' = 0`; for further rows of a chain `m'` and `n'` are those before them:",
            "Insert the equation of `X`, then the rows; the mixed terms cancel.",
        ),
        Step(
            "chains",
            "",
            cited(
                "Every row is a sum of real and imaginary parts of the rows of Jordan chains.",
                MATRICES.text(),
            ),
            "",
            NAME,
            joins=True,
        ),
    ]
