"""Letters of range and Doppler: a target and a station in any number d of dimensions.

Numbers of the geometry are parameters, with what they are taken for granted under `given`: the
range f is the positive number with f^2 = r'r, the range rate g that with f g = r'w. After the
target has moved by a, and changed its velocity by b, they are q and `new_rate`; from a second
station what is called `other_`.
"""

from __future__ import annotations

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import definition
from gainproof.derive.words.expression import symbol, symbols
from gainproof.derive.words.hypotheses import equation
from gainproof.derive.words.setting import Setting

NAME = "sight"
F, Q = symbols("f q")
G, NEW_G = symbols("g new_rate")
UNIT, ONE = symbols("I one")
TARGET, STATION = symbols("target station")
TARGET_VELOCITY, STATION_VELOCITY = symbols("target_velocity station_velocity")
R, W = symbols("place velocity")
U, H, P = symbols("unit turning across")
A, B = symbols("displacement change")
V, NEW_H = symbols("new_unit new_turning")
EXCESS, REST, BEND = symbols("excess rest bend")
DG, T = symbols("first_order t")
OTHER_F, OTHER_G = symbols("other_range other_rate")
OTHER_R, OTHER_W = symbols("other_place other_velocity")
OTHER_U, OTHER_H = symbols("other_unit other_turning")
S, DRIFT = symbols("baseline drift")

SEEN = equation(R, TARGET - STATION)
MOVING = equation(W, TARGET_VELOCITY - STATION_VELOCITY)
RANGE = equation(R.T @ R, F**2 * ONE)
RATE = equation(R.T @ W, F * G * ONE)
NEW_RANGE = equation((R + A).T @ (R + A), Q**2 * ONE)
NEW_RATE = equation((R + A).T @ (W + B), Q * NEW_G * ONE)
COURSE = equation(A, T * W)
OTHER_RANGE = equation(OTHER_R.T @ OTHER_R, OTHER_F**2 * ONE)
OTHER_RATE = equation(OTHER_R.T @ OTHER_W, OTHER_F * OTHER_G * ONE)

SETTING = Setting(
    NAME,
    {
        **dict.fromkeys(("target", "station", "target_velocity", "station_velocity"), "d 1"),
        **dict.fromkeys(("place", "velocity", "unit", "turning", "displacement", "change"), "d 1"),
        **dict.fromkeys(("new_unit", "new_turning", "baseline", "drift"), "d 1"),
        **dict.fromkeys(("other_place", "other_velocity", "other_unit", "other_turning"), "d 1"),
        **dict.fromkeys(("excess", "first_order", "rest"), "1 1"),
        **dict.fromkeys(("across", "bend"), "d d"),
    },
    parameters=("f", "q", "other_range"),
    free=("g", "new_rate", "other_rate", "t"),
    units={"I": "d", "one": "1"},
    elements={
        "unit": R / F,
        "turning": (W - G * U) / F,
        "across": UNIT - U @ U.T,
        "bend": -(U @ H.T + H @ U.T + (G / F) * P) / F,
        "new_unit": (R + A) / Q,
        "excess": (Q - F) * ONE - U.T @ A,
        "first_order": H.T @ A + U.T @ B,
        "rest": (NEW_G - G) * ONE - DG,
        "new_turning": (W + B - NEW_G * V) / Q,
        "other_unit": OTHER_R / OTHER_F,
        "other_turning": (OTHER_W - OTHER_G * OTHER_U) / OTHER_F,
        "baseline": R - OTHER_R,
        "drift": W - OTHER_W,
    },
)

LATEX = {
    "f": "f",
    "q": "f_+",
    "g": "g",
    "new_rate": "g_+",
    "I": "I",
    "one": "I_1",
    "target": "L",
    "station": "B",
    "target_velocity": "v_L",
    "station_velocity": "v_B",
    "place": "r",
    "velocity": "w",
    "unit": "u",
    "turning": "h",
    "across": "P",
    "displacement": "a",
    "change": "b",
    "new_unit": "u_+",
    "new_turning": "h_+",
    "excess": "e",
    "first_order": "m",
    "rest": "c",
    "bend": "M",
    "t": "t",
    "other_range": "f_2",
    "other_rate": "g_2",
    "other_place": "r_2",
    "other_velocity": "w_2",
    "other_unit": "u_2",
    "other_turning": "h_2",
    "baseline": "s",
    "drift": "s_v",
    # of Doppler shifts
    "carrier_frequency": "f_c",
    "speed_of_light": "c",
    "rate": "g",
}


def meaning(name: str) -> Step:
    """A definition shown with the step before it: what a letter of the setting stands for."""
    relation = definition(symbol(name).graph, SETTING.elements[name].graph)
    return joined(f"means-{name.replace('_', '-')}", relation, NAME)
