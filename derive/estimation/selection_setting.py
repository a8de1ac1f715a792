"""Letters of two choices of clean ranges, the larger after the smaller: (111), (114)-(121)."""

from __future__ import annotations

from gainproof.derive.words.expression import symbols
from gainproof.derive.words.hypotheses import definite
from gainproof.derive.words.setting import Setting

NAME = "selection"
ALWAYS, BETWEEN, NEVER = symbols("always between never")
UPPER, LOWER = symbols("kept_between kept_never")
H_S, H_L, G11, P, K11 = symbols("H_small H_large G11 P K11")
C11, C12, C13, C22, C23, C33 = symbols("C11 C12 C13 C22 C23 C33")
F22, Q_S, Q_L, PADDED = symbols("F22 Q_small Q_large padded")
M_S, M_L = symbols("small_information large_information")
UNIT_N, UNIT_T, UNIT_B = symbols("I_n I_t I_b")

SELECTION = Setting(
    NAME,
    {
        "always": "n u",
        "between": "n w",
        "never": "n b",
        "kept_between": "t w",
        "kept_never": "t b",
        "H_small": "n t",
        "H_large": "n b",
        **dict.fromkeys(("G11", "Q_small", "Q_large"), "n n"),
        "P": "n k",
        **dict.fromkeys(("K11", "small_information", "large_information"), "k k"),
        "C11": "u u",
        "C12": "u w",
        "C13": "u b",
        "C22": "w w",
        "C23": "w b",
        "C33": "b b",
        **dict.fromkeys(("F22", "padded"), "t t"),
    },
    units={"I_n": "n", "I_t": "t", "I_b": "b", "I_k": "k"},
    blocks={"n": ("always", "between", "never"), "t": ("kept_between", "kept_never")},
    elements={
        "H_small": BETWEEN @ UPPER.T + NEVER @ LOWER.T,
        "H_large": NEVER,
        "C11": ALWAYS.T @ G11 @ ALWAYS,
        "C12": ALWAYS.T @ G11 @ BETWEEN,
        "C13": ALWAYS.T @ G11 @ NEVER,
        "C22": BETWEEN.T @ G11 @ BETWEEN,
        "C23": BETWEEN.T @ G11 @ NEVER,
        "C33": NEVER.T @ G11 @ NEVER,
        "F22": UPPER @ C22 @ UPPER.T
        + UPPER @ C23 @ LOWER.T
        + LOWER @ C23.T @ UPPER.T
        + LOWER @ C33 @ LOWER.T,
        "padded": LOWER @ C33.inverse @ LOWER.T,
        "Q_small": H_S @ F22.inverse @ H_S.T,
        "Q_large": H_L @ C33.inverse @ H_L.T,
        "small_information": K11 - P.T @ Q_S @ P,
        "large_information": K11 - P.T @ Q_L @ P,
    },
    inverses=("F22", "C33", "small_information", "large_information"),
)

WEIGHT = definite("G11")
SOLVABLE = definite("small_information")

LATEX = {
    "always": "E_1",
    "between": "E_2",
    "never": "E_3",
    "kept_between": "T_2",
    "kept_never": "T_3",
    "H_small": "H_S",
    "H_large": "H_L",
    **{f"C{ij}": f"C_{{{ij}}}" for ij in (11, 12, 13, 22, 23, 33)},
    "F22": "F_{22}",
    "Q_small": "Q_S",
    "Q_large": "Q_L",
    "padded": r"Q_t",
    "small_information": "M_S",
    "large_information": "M_L",
    "I_t": "I_t",
}
