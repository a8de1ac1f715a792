"""Letters of location from range and Doppler: n stations, d coordinates, b biases unknown."""

from __future__ import annotations

from gainproof.derive.words.expression import symbol, symbols
from gainproof.derive.words.hypotheses import definite, equation
from gainproof.derive.words.setting import Setting

NAME = "location"
RANGE, DOPPLER = symbols("range_rows doppler_rows")
FULL_L, FULL_D, FULL_B = symbols("full_position full_velocity full_biases")
KEPT_L, KEPT_D, KEPT_B = symbols("kept_position kept_velocity kept_biases")
POSITION, VELOCITY = symbols("position velocity")
A_L, A_LD, H, V = symbols("range_design rate_design bias_columns noise")
A, A_KEPT, A_CLEAN = symbols("full_design kept_design clean_design")
Z, ERROR, UNKNOWN, KEPT, BOTH = symbols("observed error unknown kept_unknown course")
PLACE, SPEED, BIASES, UNCLEAN = symbols("place speed biases unclean")
N_FULL, N_KEPT, TO_BIASES = symbols("full_course kept_course bias_part")
V_L, V_LD, V_D = symbols("range_noise cross_noise doppler_noise")
G11, G12, G22 = symbols("G11 G12 G22")
D11, D12, F12 = symbols("D11 D12 F12")
J11, J12, K11, K12, P, Q = symbols("J11 J12 K11 K12 P Q")
BIAS_M, KEPT_M, FULL_M = symbols("bias_information kept_information full_information")
CLEAN_M = symbol("clean_information")
KEPT_C, FULL_C, BIAS_C = symbols("kept_covariance full_covariance bias_covariance")
B, S, L, GIVEN_DOPPLER = symbols("B S L range_given_doppler")
DOPPLER_M, REST = symbols("doppler_information rest")
GRAM, KEPT_GRAM, DOPPLER_GRAM = symbols("gram kept_gram doppler_gram")
RANGE_M = symbol("range_information")
KEPT_MAP, BENT = symbols("kept_map bent")
UNIT_N, UNIT_K, UNIT_B = symbols("I_n I_k I_b")
ROW, ESTIMATOR = symbols("station estimator")

SIDES = RANGE @ A_L, DOPPLER @ A_LD, DOPPLER @ A_L


LOCATION = Setting(
    NAME,
    {
        **dict.fromkeys(("range_rows", "doppler_rows"), "m n"),
        **dict.fromkeys(("full_position", "full_velocity"), "s d"),
        "full_biases": "s n",
        **dict.fromkeys(("kept_position", "kept_velocity"), "q d"),
        "kept_biases": "q b",
        **dict.fromkeys(("position", "velocity"), "k d"),
        **dict.fromkeys(("range_design", "rate_design"), "n d"),
        "bias_columns": "n b",
        "noise": "m m",
        "full_design": "m s",
        "kept_design": "m q",
        "clean_design": "m k",
        **dict.fromkeys(("observed", "error"), "m 1"),
        "unknown": "s 1",
        "kept_unknown": "q 1",
        "course": "k 1",
        **dict.fromkeys(("place", "speed"), "d 1"),
        "biases": "n 1",
        "unclean": "b 1",
        "station": "n 1",
        "estimator": "k m",
        "full_course": "k s",
        "kept_course": "k q",
        "bias_part": "n s",
        **dict.fromkeys(("range_noise", "cross_noise", "doppler_noise"), "n n"),
        **dict.fromkeys(("G11", "G12", "G22", "Q", "S"), "n n"),
        **dict.fromkeys(("bias_covariance", "range_given_doppler"), "n n"),
        **dict.fromkeys(("D11", "K11", "kept_covariance", "full_covariance"), "k k"),
        **dict.fromkeys(("doppler_information", "rest", "doppler_gram"), "k k"),
        "clean_information": "k k",
        **dict.fromkeys(("D12", "L"), "k n"),
        **dict.fromkeys(("F12", "K12"), "k b"),
        **dict.fromkeys(("J11", "J12", "range_information"), "d d"),
        **dict.fromkeys(("P", "B"), "n k"),
        "bias_information": "b b",
        **dict.fromkeys(("kept_information", "kept_gram"), "q q"),
        **dict.fromkeys(("full_information", "gram"), "s s"),
        "kept_map": "s q",
        "bent": "s k",
    },
    units={"I_n": "n", "I_k": "k", "I_b": "b", "I_q": "q", "I_s": "s", "I_d": "d", "one": "1"},
    blocks={
        "m": ("range_rows", "doppler_rows"),
        "s": ("full_position", "full_velocity", "full_biases"),
        "q": ("kept_position", "kept_velocity", "kept_biases"),
        "k": ("position", "velocity"),
    },
    elements={
        "full_design": SIDES[0] @ FULL_L.T
        + RANGE @ FULL_B.T
        + SIDES[1] @ FULL_L.T
        + SIDES[2] @ FULL_D.T,
        "kept_design": SIDES[0] @ KEPT_L.T
        + RANGE @ H @ KEPT_B.T
        + SIDES[1] @ KEPT_L.T
        + SIDES[2] @ KEPT_D.T,
        "clean_design": SIDES[0] @ POSITION.T + SIDES[1] @ POSITION.T + SIDES[2] @ VELOCITY.T,
        "unknown": FULL_L @ PLACE + FULL_D @ SPEED + FULL_B @ BIASES,
        "kept_unknown": KEPT_L @ PLACE + KEPT_D @ SPEED + KEPT_B @ UNCLEAN,
        "course": POSITION @ PLACE + VELOCITY @ SPEED,
        "full_course": POSITION @ FULL_L.T + VELOCITY @ FULL_D.T,
        "kept_course": POSITION @ KEPT_L.T + VELOCITY @ KEPT_D.T,
        "bias_part": FULL_B.T,
        "range_noise": RANGE.T @ V @ RANGE,
        "cross_noise": RANGE.T @ V @ DOPPLER,
        "doppler_noise": DOPPLER.T @ V @ DOPPLER,
        "G11": RANGE.T @ V.inverse @ RANGE,
        "G12": RANGE.T @ V.inverse @ DOPPLER,
        "G22": DOPPLER.T @ V.inverse @ DOPPLER,
        "D11": POSITION @ (A_L.T @ A_L + A_LD.T @ A_LD) @ POSITION.T
        + POSITION @ A_LD.T @ A_L @ VELOCITY.T
        + VELOCITY @ A_L.T @ A_LD @ POSITION.T
        + VELOCITY @ A_L.T @ A_L @ VELOCITY.T,
        "D12": POSITION @ A_L.T,
        "F12": POSITION @ A_L.T @ H,
        "J11": A_L.T @ G11 @ A_L + A_LD.T @ G12.T @ A_L + A_L.T @ G12 @ A_LD + A_LD.T @ G22 @ A_LD,
        "J12": A_L.T @ G12 @ A_L + A_LD.T @ G22 @ A_L,
        "K11": POSITION @ J11 @ POSITION.T
        + POSITION @ J12 @ VELOCITY.T
        + VELOCITY @ J12.T @ POSITION.T
        + VELOCITY @ A_L.T @ G22 @ A_L @ VELOCITY.T,
        "K12": POSITION @ (A_L.T @ G11 @ H + A_LD.T @ G12.T @ H) + VELOCITY @ A_L.T @ G12.T @ H,
        "P": (G11 @ A_L + G12 @ A_LD) @ POSITION.T + G12 @ A_L @ VELOCITY.T,
        "bias_information": H.T @ G11 @ H,
        "Q": H @ BIAS_M.inverse @ H.T,
        "kept_information": A_KEPT.T @ V.inverse @ A_KEPT,
        "full_information": A.T @ V.inverse @ A,
        "clean_information": A_CLEAN.T @ V.inverse @ A_CLEAN,
        "kept_covariance": N_KEPT @ KEPT_M.inverse @ N_KEPT.T,
        "full_covariance": N_FULL @ FULL_M.inverse @ N_FULL.T,
        "bias_covariance": TO_BIASES @ FULL_M.inverse @ TO_BIASES.T,
        "B": A_LD @ POSITION.T + A_L @ VELOCITY.T,
        "S": G22 - G12.T @ G11.inverse @ G12,
        "L": POSITION @ (A_L.T - A_LD.T @ V_D.inverse @ V_LD.T)
        - VELOCITY @ A_L.T @ V_D.inverse @ V_LD.T,
        "range_given_doppler": V_L - V_LD @ V_D.inverse @ V_LD.T,
        "doppler_information": B.T @ V_D.inverse @ B,
        "rest": K11 - P.T @ G11.inverse @ P,
        "gram": A.T @ A,
        "kept_gram": A_KEPT.T @ A_KEPT,
        "doppler_gram": B.T @ B,
        "range_information": A_L.T @ V_L.inverse @ A_L,
        "estimator": N_FULL @ FULL_M.inverse @ A.T @ V.inverse,
        "kept_map": N_FULL.T @ N_KEPT + FULL_B @ H @ KEPT_B.T,
        "bent": N_FULL.T - FULL_B @ A_L @ POSITION.T,
    },
    inverses=(
        "noise",
        "G11",
        "range_noise",
        "doppler_noise",
        "range_given_doppler",
        "bias_information",
        "kept_information",
        "full_information",
        "clean_information",
        "kept_covariance",
        "doppler_information",
        "rest",
        "gram",
        "doppler_gram",
        "range_information",
    ),
)

POSITIVE = definite("noise")
FULL = definite("gram")
ORTHONORMAL = equation(H.T @ H, UNIT_B)
