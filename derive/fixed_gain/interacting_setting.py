"""Letters of filters with matrix gains: position and velocity of d coordinates, for every d.

The state has the positions before the velocities; E1 and E2 are the first d and the last d columns
of the unit matrix of its size.
"""

from __future__ import annotations

from gainproof.derive.words.expression import Expression, symbol, symbols
from gainproof.derive.words.hypotheses import equation, symmetric
from gainproof.derive.words.setting import Setting

NAME = "blocks"
T, ALPHA, BETA, Z = symbols("t alpha beta z")
UNIT, J = symbols("I J")
E1, E2 = symbols("E1 E2")
PHI, H, K, F, K1, K2, B, W = symbols("Phi H K F K1 K2 B W")
F11, W11, W21, W22 = symbols("F11 W11 W21 W22")
X11 = symbol("X11")
ERROR, DRIVE, ACCELERATION, NOISE = symbols("error drive acceleration noise")
TRUTH, NEXT_TRUTH, OBSERVED = symbols("truth next_truth observed")
PREDICTED, UPDATED, NEXT_PREDICTED = symbols("predicted updated next_predicted")
COORDINATE = symbol("coordinate")
S, P, BEST = symbols("S P best")
P11, P21 = symbols("P11 P21")
FOLLOWED = symbol("followed")
CHANGE, OTHER, WEIGHT, ADJOINT, MISFIT = symbols("change other weight adjoint misfit")
SCALE, SCALED = symbols("scale scaled")
SECOND_NOISE = symbol("second_noise")
EVERYWHERE, SCALED_GAIN = symbols("everywhere scaled_gain")
UPDATE, LEAST, AHEAD = symbols("update smoothed_update followed_update")
NEAR, NEAR_GAIN = symbols("near_update near_gain")
OWN_GAIN, FOLLOWED_GAIN = symbols("smoothed_gain followed_gain")
SQUARE_ROOT, ROOT, SHIFTED = symbols("square_root root shifted")
CHANGED, PENCIL, COLUMNS, REST = symbols("changed pencil columns rest")
LIMIT, LIMIT22 = symbols("limit limit22")
STATE = symbol("state")


def gain(position: Expression) -> Expression:
    """The gain of both blocks with this gain of the position."""
    return E1 @ position + E2 @ K2


def closed(gains: Expression) -> Expression:
    """How errors of the prediction go on under these gains."""
    return PHI @ (J - gains @ H)


def noisy(gains: Expression, covariance: Expression) -> Expression:
    """The covariance one interval later under measurement noise alone."""
    loop = closed(gains) if gains != K else F
    return loop @ covariance @ loop.T + PHI @ gains @ B @ gains.T @ PHI.T


def updated_covariance(gains: Expression, covariance: Expression) -> Expression:
    """The covariance of the update for any gain (Joseph's form)."""
    rest = J - gains @ H
    return rest @ covariance @ rest.T + gains @ B @ gains.T


STEADY = equation(W, noisy(K, W))
SYMMETRIC = symmetric("W")
HELD = equation(ERROR, F @ ERROR + DRIVE)

SETTING = Setting(
    NAME,
    {
        **dict.fromkeys(("E1", "E2"), "s d"),
        **dict.fromkeys(
            ("K1", "K2", "B", "second_noise", "S", "F11", "X11", "W11", "W21", "W22", "P11", "P21"),
            "d d",
        ),
        **dict.fromkeys(("followed", "change", "pencil", "scale", "scaled"), "d d"),
        **dict.fromkeys(("Phi", "F", "W", "P", "other", "weight", "adjoint", "rest"), "s s"),
        **dict.fromkeys(("update", "smoothed_update", "followed_update"), "s s"),
        **dict.fromkeys(("near_update", "everywhere", "limit"), "s s"),
        **dict.fromkeys(("smoothed_gain", "followed_gain", "near_gain", "scaled_gain"), "s d"),
        **dict.fromkeys(("square_root", "shifted", "limit22"), "d d"),
        **dict.fromkeys(("K", "best", "misfit", "changed", "columns"), "s d"),
        "H": "d s",
        **dict.fromkeys(("truth", "next_truth", "predicted", "updated"), "s 1"),
        **dict.fromkeys(("next_predicted", "error", "drive", "state"), "s 1"),
        **dict.fromkeys(("observed", "noise", "acceleration", "coordinate"), "d 1"),
    },
    parameters=("t", "alpha", "beta"),
    free=("z", "root"),
    units={"I": "d", "J": "s"},
    blocks={"s": ("E1", "E2")},
    elements={
        "Phi": J + T * (E1 @ E2.T),
        "H": E1.T,
        "K": E1 @ K1 + E2 @ K2,
        "F": PHI @ (J - K @ H),
        "F11": UNIT - K1 - T * K2,
        "W11": E1.T @ W @ E1,
        "W21": E2.T @ W @ E1,
        "X11": (UNIT - K1) @ W11 @ (UNIT - K1).T + K1 @ B @ K1.T,
        "W22": E2.T @ W @ E2,
        "P11": E1.T @ P @ E1,
        "P21": E2.T @ P @ E1,
        "updated": PREDICTED + K @ (OBSERVED - H @ PREDICTED),
        "next_predicted": PHI @ UPDATED,
        "drive": E1 @ ACCELERATION * (T**2 / 2) + E2 @ ACCELERATION * T,
        "S": P11 + B,
        "best": P @ E1 @ S.inverse,
        "followed": (P11 + T * P21) @ S.inverse - T * K2,
        "smoothed_gain": gain(P11 @ S.inverse),
        "followed_gain": gain(FOLLOWED),
        "near_gain": gain(P11 @ S.inverse + CHANGE),
        "update": updated_covariance(K, P),
        "smoothed_update": updated_covariance(OWN_GAIN, P),
        "followed_update": updated_covariance(FOLLOWED_GAIN, P),
        "near_update": updated_covariance(NEAR_GAIN, P),
        "everywhere": E1 @ SCALE @ E1.T + E2 @ SCALE @ E2.T,
        "scaled_gain": gain(SCALED),
        "changed": gain(K1 + CHANGE),
        "misfit": PHI @ (K @ (W11 + B) - W @ E1),
        "pencil": Z**2 * UNIT + Z * (K1 + T * K2 - 2 * UNIT) + UNIT - K1,
        "columns": T * E1 + E2 @ ((Z - 1) * UNIT + K1 + T * K2),
        "rest": J - F,
        "shifted": UNIT + SQUARE_ROOT,
        "limit22": E2.T @ LIMIT @ E2,
    },
    inverses=("S", "K2", "rest", "shifted"),
)

LATEX = {
    "t": "T",
    "z": "z",
    "alpha": r"\alpha",
    "beta": r"\beta",
    "I": "I",
    "J": "J",
    "E1": "E_1",
    "E2": "E_2",
    "Phi": r"\Phi",
    "H": "H",
    "K": "K",
    "K1": "K_1",
    "K2": "K_2",
    "F": "F",
    "F11": "F_{11}",
    "X11": "X_{11}",
    "B": "B",
    "S": "S",
    "W": "W",
    "P": "P",
    **{f"{name}{ij}": f"{name}_{{{ij}}}" for name in "WP" for ij in (11, 21, 22)},
    "error": "e",
    "drive": "g",
    "acceleration": "a",
    "noise": "v",
    "second_noise": r"B_2",
    "state": "y",
    "limit": "Y",
    "limit22": "Y_{22}",
    "truth": "x",
    "next_truth": r"x_{+}",
    "observed": "z_o",
    "predicted": "x_p",
    "updated": "x_s",
    "next_predicted": r"x_{p+}",
    "coordinate": "u",
    "best": "K_o",
    "followed": "K_f",
    "change": "D",
    "scale": "A",
    "everywhere": "A_2",
    "scaled_gain": r"K_{A2}",
    "smoothed_gain": "K_s",
    "followed_gain": "K_p",
    "near_gain": "K_d",
    "update": "X",
    "smoothed_update": "X_s",
    "followed_update": "X_p",
    "near_update": "X_d",
    "square_root": r"\Gamma",
    "root": "r",
    "shifted": r"\Sigma",
    "scaled": "K_A",
    "changed": "K_D",
    "other": "V",
    "weight": "C",
    "adjoint": r"\Lambda",
    "misfit": "N",
    "pencil": "L",
    "columns": "U",
    "rest": "G",
    # only spoken of
    "first_part": "V_1",
    "second_part": "V_2",
    "velocities": "y_2",
}
