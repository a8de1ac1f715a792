"""Letters of the order of symmetric matrices, and of a matrix in four blocks (theorem 1)."""

from __future__ import annotations

from gainproof.derive.words.expression import symbols
from gainproof.derive.words.setting import Setting

ORDER_NAME, BLOCKS_NAME = "order", "corners"
D, D1, D2, D3, F, X, U = symbols("D D1 D2 D3 any_factor direction eigenvector")
FIRST, SECOND, BACK = symbols("first_gap second_gap back_gap")
EIGENVALUE, VECTORS, VALUES = symbols("eigenvalue eigenvectors eigenvalues")

ORDER = Setting(
    ORDER_NAME,
    {
        **dict.fromkeys(("D", "D1", "D2", "D3", "first_gap", "second_gap", "back_gap"), "n n"),
        **dict.fromkeys(("eigenvectors", "eigenvalues"), "n n"),
        "any_factor": "n r",
        **dict.fromkeys(("direction", "eigenvector"), "n 1"),
    },
    free=("eigenvalue",),
    units={"one": "1"},
    elements={"first_gap": D1 - D2, "second_gap": D2 - D3, "back_gap": D2 - D1},
    inverses=("D1", "D2"),
)

E1, E2, WHOLE = symbols("upper_rows lower_rows blocked")
UPPER, LOWER, CORNER, BOTH = symbols("unit_upper unit_lower unit_corner unit_both")
B11, B12, B22, H1, H2 = symbols("D11 D12 D22 H1 H2")

BLOCKS = Setting(
    BLOCKS_NAME,
    {
        "upper_rows": "t m",
        "lower_rows": "t n",
        "blocked": "t t",
        **dict.fromkeys(("D11", "H1"), "m m"),
        **dict.fromkeys(("D22", "H2"), "n n"),
        "D12": "m n",
    },
    units={"unit_upper": "m", "unit_lower": "n", "unit_both": "t"},
    blocks={"t": ("upper_rows", "lower_rows")},
    elements={
        "D11": E1.T @ WHOLE @ E1,
        "D12": E1.T @ WHOLE @ E2,
        "D22": E2.T @ WHOLE @ E2,
        "H1": B11 - B12 @ B22.inverse @ B12.T,
        "H2": B22 - B12.T @ B11.inverse @ B12,
    },
    inverses=("blocked", "D11", "D22", "H1", "H2"),
)

LATEX = {
    "D": "D",
    "D1": "D_1",
    "D2": "D_2",
    "D3": "D_3",
    "any_factor": "F",
    "direction": "x",
    "eigenvector": "u",
    "eigenvalue": r"\lambda",
    "eigenvectors": "U",
    "eigenvalues": r"\Lambda",
    "first_gap": r"\Delta_{12}",
    "second_gap": r"\Delta_{23}",
    "back_gap": r"\Delta_{21}",
    "one": "1",
    "upper_rows": "E_1",
    "lower_rows": "E_2",
    "blocked": "D",
    "D11": "D_{11}",
    "D12": "D_{12}",
    "D22": "D_{22}",
    "H1": "H_1",
    "H2": "H_2",
    "unit_upper": "I_m",
    "unit_lower": "I_n",
    "unit_both": "I_{m+n}",
}
