"""The named quantities of filters with fixed gains: how they are printed."""

from __future__ import annotations

from gainproof.derive.fixed_gain.loop import pairs

LATEX = {
    "t": "t",
    "z": "z",
    "s": "s",
    "k": "k",
    "x": "x",
    "y": "y",
    "n": "n",
    "a": "a",
    "b": "b",
    "e": "e",
    "g": "g",
    "f": "f",
    "c": "c",
    "r": "r",
    "v": "v",
    "alpha": r"\alpha",
    "beta": r"\beta",
    "gamma": r"\gamma",
    "observed": "z",
    "lag": "L",
    "innovation_variance": "S",
    "root_two": r"\sqrt{2}",
    "root_three": r"\sqrt{3}",
    "modulus": r"\rho",
    "first_root": "z_1",
    "second_root": "z_2",
    "third_root": "z_3",
    "share": r"\rho",
    "bound": "b",
    "bound_lag": "L_b",
    "bound_variance": "P_b",
    "d": "d",
    "m": "m",
    "p": "p",
    "w": "w",
    "rest": "v",
    "root_real": "u",
    "root_imaginary": "v",
    "slow_beta": r"\beta_s",
    "fast_beta": r"\beta_f",
    "slow_variance": r"P_s",
    "fast_variance": r"P_f",
    **{f"s{n}": f"s_{n}" for n in (1, 2, 3)},
    **{f"z{n}": f"z_{n}" for n in (1, 2, 3)},
    **{f"predicted_{ij}": f"P_{{{ij}}}" for ij in pairs(3)},
    **{f"updated_{ij}": f"X_{{{ij}}}" for ij in pairs(3)},
    **{f"q_{ij}": f"Q_{{{ij}}}" for ij in pairs(3)},
    **{
        f"{noise}_{ij}": f"D^{letter}_{{{ij}}}"
        for noise, letter in (("acceleration", "a"), ("jerk", "j"), ("white_jerk", "w"))
        for ij in pairs(3)
    },
    **{
        f"{name}_{what}": f"{tex}_{{{label}}}"
        for name, label in (
            ("velocity", "RV"),
            ("acceleration", "RA"),
            ("minimum", "MV"),
        )
        for what, tex in (("alpha", r"\alpha"), ("beta", r"\beta"), ("variance", "P"))
    },
}
