"""Letters of weighted least squares: any linear model, any number of measurements and unknowns."""

from __future__ import annotations

from gainproof.derive.words.expression import symbols
from gainproof.derive.words.hypotheses import definite, equation, invertible
from gainproof.derive.words.setting import Setting

NAME = "linear"
A, V, M, GAIN, GRAM = symbols("design noise information estimator gram")
Z, NOISE, TRUTH, ANY, ESTIMATE = symbols("observed error unknown any_estimate estimate")
COST, LEAST = symbols("cost least_cost")
MEAN_Z, MEAN_V = symbols("mean_observed mean_error")
N, OTHER, COVARIANCE = symbols("chosen other_estimator chosen_covariance")
U, FEWER, FEWER_M = symbols("kept_columns fewer_design fewer_information")
FEWER_N, FEWER_COVARIANCE = symbols("fewer_chosen fewer_covariance")
LEFT_OUT, LEFT_VALUES, X = symbols("left_out left_values null_vector")
ROW, UNIT, ONE, PART = symbols("row unit_unknown unit_one unit_chosen")

LINEAR = Setting(
    NAME,
    {
        **dict.fromkeys(("design",), "m q"),
        "noise": "m m",
        **dict.fromkeys(("information", "gram"), "q q"),
        "estimator": "q m",
        **dict.fromkeys(("observed", "error", "mean_observed", "mean_error"), "m 1"),
        **dict.fromkeys(("unknown", "any_estimate", "estimate", "null_vector"), "q 1"),
        **dict.fromkeys(("cost", "least_cost"), "1 1"),
        **dict.fromkeys(("chosen",), "k q"),
        "other_estimator": "k m",
        **dict.fromkeys(("chosen_covariance", "fewer_covariance"), "k k"),
        "kept_columns": "q p",
        "fewer_design": "m p",
        "fewer_information": "p p",
        "fewer_chosen": "k p",
        "left_out": "m g",
        "left_values": "g 1",
        "row": "k 1",
    },
    units={"unit_unknown": "q", "unit_one": "1", "unit_chosen": "k", "unit_fewer": "p"},
    elements={
        "information": A.T @ V.inverse @ A,
        "gram": A.T @ A,
        "estimator": M.inverse @ A.T @ V.inverse,
        "estimate": GAIN @ Z,
        "cost": (Z - A @ ANY).T @ V.inverse @ (Z - A @ ANY),
        "least_cost": (Z - A @ ESTIMATE).T @ V.inverse @ (Z - A @ ESTIMATE),
        "chosen_covariance": N @ M.inverse @ N.T,
        "fewer_design": A @ U,
        "fewer_information": U.T @ M @ U,
        "fewer_chosen": N @ U,
        "fewer_covariance": FEWER_N @ FEWER_M.inverse @ FEWER_N.T,
    },
    inverses=("noise", "information", "gram", "fewer_information"),
)

POSITIVE = definite("noise")
SOLVABLE = invertible("information")
MODEL = equation(Z, A @ TRUTH + NOISE)

LATEX = {
    "design": "A",
    "noise": "V",
    "information": "M",
    "gram": "A_2",
    "estimator": "K",
    "observed": "z",
    "error": "v",
    "unknown": "a",
    "any_estimate": "x",
    "estimate": "a_e",
    "null_vector": "w",
    "cost": "J",
    "least_cost": "J_e",
    "mean_observed": "z_m",
    "mean_error": "v_m",
    "chosen": "N",
    "other_estimator": "K_x",
    "chosen_covariance": "C",
    "kept_columns": "U",
    "fewer_design": "A_U",
    "fewer_information": "M_U",
    "fewer_chosen": "N_U",
    "fewer_covariance": "C_U",
    "left_out": "T",
    "left_values": "c",
    "row": "e",
    "unit_unknown": "I_q",
    "unit_one": "1",
    "unit_chosen": "I_k",
    "unit_fewer": "I_p",
}
