"""The named quantities of filters with fixed gains: how they are printed, what kernels say."""

from __future__ import annotations

from gainproof.derive.fixed_gain.loop import WORDS, pairs

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

_FILTERS = {
    "minimum_variance": "minimum variance",
    "slow_minimum_variance": "the minimum variance filter of smaller beta",
    "fast_minimum_variance": "the minimum variance filter of larger beta",
    "minimum_smoothed_variance": "minimum smoothed variance",
    "random_acceleration": "random acceleration",
    "random_velocity": "random velocity",
    "random_jerk": "random jerk",
}
_GAINS = {
    f"{name}_{gain}": f"gain of the {word}{('', ' times T', ' times T^2')[n]}, {words}"
    for name, words in _FILTERS.items()
    for n, (gain, word) in enumerate(zip(("alpha", "beta", "gamma"), WORDS, strict=True))
}


def _entry(kind: str, ij: str) -> str:
    first, second = (WORDS[int(digit) - 1] for digit in ij)
    power = int(ij[0]) + int(ij[1]) - 2
    times = ("", ", times T", *(f", times T^{n}" for n in (2, 3, 4)))[power]
    unit = f"over sigma_v^2{times}"
    if first == second:
        return f"variance of the {kind} {first} {unit}"
    return f"covariance of {kind} {first} and {second} {unit}"


MEANINGS: dict[str, str] = {
    **{
        f"{kind}_{ij}_by_q_{kl}": f"what q{kl} adds to {kind}_{ij}, over q{kl}"
        for kind in ("predicted", "updated")
        for ij in pairs(3)
        for kl in pairs(3)
    },
    "alpha": "gain of the position",
    "beta": "gain of the velocity times T",
    "gamma": "gain of the acceleration times T^2",
    "margin": "4 - 2 alpha - beta, positive inside",
    "linear_coefficient": "x, the coefficient of s in c(z) = 0 under z = (1 + s)/(1 - s), over "
    "the constant one",
    "quadratic_coefficient": "y, that of s^2",
    "half_sum": "half the sum of the poles",
    "modulus": "square root of the product of the poles, the modulus of a complex pair",
    "lag": "1/beta: lag of the predicted position behind a constant acceleration a over a T^2",
    "quarter_discriminant": "the square of half their difference, negative where they are complex",
    **{
        f"{kind}_{word}_lag": f"truth less {kind} {word}"
        for kind in ("predicted", "updated")
        for word in WORDS
    },
    **{f"{kind}_{ij}": _entry(kind, ij) for kind in ("predicted", "updated") for ij in pairs(3)},
    **_GAINS,
    **{
        f"{name}_predicted_11": f"variance of the predicted position over sigma_v^2, {words}"
        for name, words in _FILTERS.items()
    },
    "minimum_smoothed_variance_updated_11": "variance of the smoothed position over sigma_v^2, "
    "minimum smoothed variance",
}
