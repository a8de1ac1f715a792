"""Letters of measurements of which some have an unknown of their own, any of the others."""

from __future__ import annotations

from gainproof.derive.words.expression import symbols
from gainproof.derive.words.hypotheses import definite, invertible
from gainproof.derive.words.setting import Setting

NAME = "free"
HEARD, ALONE = symbols("heard_rows alone_rows")
COURSE, OWN = symbols("shared_columns own_columns")
SHARED, A, V, M = symbols("shared_design design_with_own noise information_with_own")
ESTIMATOR, C = symbols("shared_estimator shared_covariance")
SEEN, V_HEARD, M_HEARD = symbols("heard_design heard_noise heard_information")
UNIT_K = symbols("I_k")[0]

FREE = Setting(
    NAME,
    {
        "heard_rows": "m r",
        "alone_rows": "m b",
        "shared_columns": "q k",
        "own_columns": "q b",
        "shared_design": "m k",
        "design_with_own": "m q",
        "noise": "m m",
        "information_with_own": "q q",
        "shared_estimator": "k m",
        **dict.fromkeys(("shared_covariance", "heard_information"), "k k"),
        "heard_design": "r k",
        "heard_noise": "r r",
    },
    units={"I_k": "k", "I_r": "r"},
    blocks={"m": ("heard_rows", "alone_rows"), "q": ("shared_columns", "own_columns")},
    elements={
        "design_with_own": SHARED @ COURSE.T + ALONE @ OWN.T,
        "information_with_own": A.T @ V.inverse @ A,
        "shared_estimator": COURSE.T @ M.inverse @ A.T @ V.inverse,
        "shared_covariance": COURSE.T @ M.inverse @ COURSE,
        "heard_design": HEARD.T @ SHARED,
        "heard_noise": HEARD.T @ V @ HEARD,
        "heard_information": SEEN.T @ V_HEARD.inverse @ SEEN,
    },
    inverses=("noise", "information_with_own", "heard_noise", "heard_information"),
)

POSITIVE = definite("noise")
SOLVABLE = invertible("information_with_own")

LATEX = {
    "heard_rows": "E_h",
    "alone_rows": "E_f",
    "shared_columns": "S_x",
    "own_columns": "S_f",
    "shared_design": "A_x",
    "design_with_own": "A",
    "information_with_own": "M",
    "shared_estimator": "K",
    "shared_covariance": "C",
    "heard_design": "A_h",
    "heard_noise": "V_h",
    "heard_information": "M_h",
    "I_k": "I_k",
    "I_r": "I_r",
}
