"""The printed module of alpha-beta-gamma filters: kernels, what they say, what they compute."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.catalogue_module import catalogue_module
from gainproof.derive.derivation import Step, kernel_step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.names import MEANINGS
from gainproof.derive.fixed_gain.three_kernels import UPDATED, graphs
from gainproof.derive.fixed_gain.three_noise_kernels import TURNING, kernel_of, noise_graphs
from gainproof.derive.fixed_gain.three_noises import TOWER as NOISE_TOWER
from gainproof.derive.fixed_gain.three_noises import noise_meanings
from gainproof.derive.fixed_gain.three_pole_kernels import EQUATIONS as POLE_EQUATIONS
from gainproof.derive.fixed_gain.three_pole_kernels import MEANINGS as POLE_MEANINGS
from gainproof.derive.fixed_gain.three_pole_kernels import POLES, pole_input, pole_meanings
from gainproof.derive.fixed_gain.three_pole_kernels import SUMMARY as POLE_SUMMARY
from gainproof.derive.fixed_gain.three_pole_kernels import TOWER as POLE_TOWER
from gainproof.derive.fixed_gain.three_pole_kernels import TURNING as POLE_TURNING
from gainproof.derive.fixed_gain.three_random_jerk_tower import BY_GAIN, BY_LAG, curve_roots
from gainproof.derive.fixed_gain.three_towers import ALPHA, BETA, GAMMA, MARGIN
from gainproof.derive.fixed_gain.two_kernels import SCALE, difference
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Input, Kernel, Module, Output, closed

SCALES = {
    "updated_12": "updated_12" + SCALE,
    "updated_13": "updated_13" + SCALE,
    "updated_23": "updated_23" + SCALE,
    "updated_velocity_lag": "predicted_velocity_lag",
    **{name: name + SCALE for name in POLE_TURNING},
}
NOISE_SCALES = {name: name + SCALE for name in TURNING}
REASON = "changes its sign"
NOISE_REASON = "terms of both signs"
TOWERS = {
    "minimum_variance_by_lag": "minimum_variance",
    "random_acceleration_by_lag": "stable_acceleration",
    "random_jerk_by_lag": BY_LAG,
    "random_jerk_by_gain": BY_GAIN,
    "random_acceleration_by_gain": "stable_acceleration",
    **dict.fromkeys(noise_graphs(), NOISE_TOWER),
    POLES: POLE_TOWER,
}
LEAST_LAGS = {
    "minimum_variance": "1/8",
    "random_acceleration": "1/2",
    "random_jerk": "69/128",  # x = 2, just inside
}
SYMBOLS = {"linear_coefficient": "x", "cubic_coefficient": "d", "hurwitz_determinant": "m"}
OWN_MEANINGS = {
    "lag": "1/gamma, lag of the predicted position behind a constant jerk j over j T^3",
    "share": "gamma over its largest stable value 2 alpha beta/(2 - alpha)",
    "cubic_coefficient": "d, that of s^3",
    "hurwitz_determinant": "m = x y - d with y the coefficient of s^2",
    **POLE_MEANINGS,
}
_BY = {
    "acceleration": "a process noise of the acceleration",
    "jerk": "a jerk that is constant over each interval",
    "white_jerk": "a white jerk",
}
_RATIO = {
    "acceleration": ("q = (sigma_w T^2/sigma_v)^2,", "Q = q (1/2, 1, 1)' (1/2, 1, 1);"),
    "jerk": ("q = (sigma_j T^3/sigma_v)^2,", "Q = q (1/6, 1/2, 1)' (1/6, 1/2, 1);"),
    "white_jerk": (
        "q = density T^5/sigma_v^2,",
        "Q = q (1/20, 1/8, 1/6; 1/8, 1/3, 1/2; 1/6, 1/2, 1);",
    ),
}
_ROOM = {
    "acceleration": ("N = 64, a = 1, f = 0, h = 0, K = 1 + y, V = (1 + y)^2,",),
    "jerk": (
        "N = 576, a = 9, f = 9, h = 18, K = 9 y + 6 + x/d,",
        "V = (1 + y) (9 y + 6) + 1 + x/d,",
    ),
    "white_jerk": (
        "N = 960, a = 15, f = 10, h = 30, K = 15 y + 15 + 2 x/d,",
        "V = 15 (1 + y)^2 + 2 + 2 x/d,",
    ),
}
_INCREMENTS = (
    "of increments that act at the next sample (acceleration increments) all is the same but",
    "predicted_33, 1 more, and updated_33, which is predicted_33 here;",
)


def kernel_module(name: str, title: str, made: Mapping[str, Graph]) -> Module:
    """The module of alpha-beta-gamma filters."""
    kernels = (_kernel(name, kernel, graph) for kernel, graph in made.items())
    return catalogue_module(name, title, kernels)


def _kernel(name: str, kernel: str, graph: Graph) -> Kernel:
    symbols = symbols_of(graph)
    named = graph.get("names", {})
    meanings, scales, reason = {**MEANINGS, **OWN_MEANINGS}, SCALES, REASON
    if TOWERS.get(kernel) == NOISE_TOWER:
        scales, reason = NOISE_SCALES, NOISE_REASON
        meanings |= {x: f"added to the {meanings[x]}" for x in meanings if x[-2:].isdigit()}
    return Kernel(
        name=kernel,
        result="".join(word.capitalize() for word in kernel.split("_")),
        summary=SUMMARIES[kernel],
        equations=EQUATIONS[kernel],
        inputs=tuple(_input(kernel, symbol, meanings[symbol]) for symbol in symbols),
        outputs=tuple(
            Output(entry, meanings[entry], scales[entry] if difference(entry) in named else None)
            for entry in graph["outputs"]
            if not entry.endswith(SCALE)
        ),
        graph=graph,
        source=f"derivation {name}",
        cancellations={difference(x): reason for x in scales if difference(x) in named},
    )


def _input(kernel: str, entry: str, meaning: str) -> Input:
    if kernel == POLES:
        return pole_input(entry, meaning)
    if entry == "lag":
        low = LEAST_LAGS[kernel.removesuffix("_by_lag")]
        return Input(entry, meaning, low, "1e30", True, False, single=(low, "1e9"))
    if kernel.endswith("_by_gain"):
        return Input(entry, meaning, "1e-15", "1", False, True, single=("1e-6", "1"))
    if entry in ("alpha", "share"):
        return closed(entry, meaning, "1e-20", "0.999999", ("1e-5", "0.99999"))
    if entry == "beta":
        return closed(entry, meaning, "1e-20", "1.9999999", ("1e-5", "1.99999"))
    return closed(entry, meaning, "1e-20", "1e20", ("1e-4", "1e4"))


def kernel_steps(made: Mapping[str, Graph]) -> list[Step]:
    """The kernels compute what they say."""
    e, cube = real("e"), real("cube")
    roots = {
        "minimum_variance_by_lag": {"root": cube, "root_of_map": cube**2},
        "random_acceleration_by_lag": {"root": 1 + e / 4, "root_of_map": (1 + e / 4) ** 2},
        "random_acceleration_by_gain": {"root": e / (4 + e)},
        **curve_roots(),
    }
    return [
        kernel_step(
            name,
            graph,
            _meant(name, graph),
            TOWERS.get(name, "main"),
            roots=roots.get(name, {}),
        )
        for name, graph in made.items()
    ]


def _meant(kernel: str, graph: Graph) -> dict[str, sp.Expr]:
    """What each output stands for, over the names of its tower."""
    if kernel == POLES:
        return pole_meanings()
    if TOWERS.get(kernel) == NOISE_TOWER:
        return noise_meanings(kernel, graph)
    if kernel == UPDATED:
        x, y, d, m = (real(name) for name in "xydm")
        parts = {"12": x * (x + 1) * (1 + y + x) / 4, "13": (m + x + x**2) / 2, "23": x * (x + 1)}
        scales = {f"updated_{ij}{SCALE}": 8 * part / (d * m) for ij, part in parts.items()}
        return {output: scales.get(output, real(output)) for output in graph["outputs"]}
    g = 2 * ALPHA * BETA - GAMMA * (2 - ALPHA)
    gap, below = 2 * BETA - GAMMA, g * MARGIN
    known: dict[str, sp.Expr] = {
        "margin": MARGIN,
        **{name: real(symbol) for name, symbol in SYMBOLS.items()},
        "predicted_position_lag": 1 / GAMMA,
        "predicted_velocity_lag": (12 * ALPHA + 6 * BETA + GAMMA) / (12 * GAMMA),
        "predicted_acceleration_lag": (2 * BETA + GAMMA) / (2 * GAMMA),
        "updated_position_lag": (1 - ALPHA) / GAMMA,
        "updated_velocity_lag": (12 * ALPHA - 6 * BETA + GAMMA) / (12 * GAMMA),
        "updated_acceleration_lag": gap / (2 * GAMMA),
        "updated_12" + SCALE: BETA * (2 * ALPHA + BETA) * gap / below,
        "updated_13" + SCALE: GAMMA * (2 * g + BETA * gap) / below,
    }

    def meaning(output: str) -> sp.Expr:
        for prefix in ("minimum_variance_", "random_acceleration_", "random_jerk_"):
            if output.startswith(prefix):
                return real(output.removeprefix(prefix))
        return known.get(output, real(output))

    return {output: meaning(output) for output in graph["outputs"]}


__all__ = ["graphs", "kernel_module", "kernel_steps"]


def _equations(noise: str) -> tuple[str, ...]:
    return (
        f"D = F (I - K H) D (F (I - K H))' + Q with {_RATIO[noise][0]}",
        _RATIO[noise][1],
        "times q sigma_v^2 the entries are what the noise adds to the variances;",
        *(_INCREMENTS if noise == "acceleration" else ()),
        "with n = 1 + x + y + d, y = (d + m)/x,",
        *_ROOM[noise],
        "predicted_11 = K n^2/(N m), predicted_13 = 4 n (a + K/m)/N,",
        "predicted_23 = 8 ((1 + x) V/m + a x + f)/N, predicted_33 = 16 (V/m + a x + h)/N",
    )


_AFTER = ("and after the update (I - K H) D (I - K H)'; x, d and m are those of `coordinates`",)
NOISE_SUMMARIES = {
    **{kernel_of(noise): f"What {by} adds to covariances." for noise, by in _BY.items()},
    **{
        f"{kernel_of(noise)}_of_coordinates": f"What {by} adds, any stable filter."
        for noise, by in _BY.items()
    },
}
NOISE_EQUATIONS: Mapping[str, tuple[str, ...]] = {
    **{kernel_of(noise): (*_equations(noise), *_AFTER) for noise in _BY},
    **{f"{kernel_of(noise)}_of_coordinates": _equations(noise) for noise in _BY},
}


SUMMARIES = {
    "coordinates": "How far gains are inside the region of stability.",
    "gains_of_coordinates": "Gains of any stable alpha-beta-gamma filter from its coordinates.",
    "variances": "Covariances under measurement noise alone, from the gains.",
    "variances_of_coordinates": "Covariance of the prediction, any stable filter.",
    "updated_variances_of_coordinates": "What the update leaves of it, any stable filter.",
    **NOISE_SUMMARIES,
    "lags": "Steady errors behind a constant jerk j, over j T^3 (positions), j T^2 and j T.",
    POLES: POLE_SUMMARY,
    "minimum_variance_by_lag": "The stable filter of least position variance at a lag (MV).",
    "random_acceleration_by_lag": "The stable random acceleration filter (RA) of a lag.",
    "random_jerk_by_lag": "The random jerk filter (RJ) of a lag.",
    "random_acceleration_by_gain": "The stable random acceleration filter (RA) of a position gain.",
    "random_jerk_by_gain": "The random jerk filter (RJ) of a position gain.",
}
SHARE = "gamma = 2 alpha beta share/(2 - alpha), margin = 4 - 2 alpha - beta,"
EQUATIONS: Mapping[str, tuple[str, ...]] = {
    "coordinates": (
        SHARE,
        "linear_coefficient = 2 beta/gamma, cubic_coefficient = 2 margin/gamma,",
        "hurwitz_determinant = 8 (alpha beta - gamma (1 - alpha/2))/gamma^2",
    ),
    "gains_of_coordinates": (
        "alpha = 2 (1 + y)/n, beta = 4 x/n, gamma = 8/n, n = 1 + x + y + d, y = (d + m)/x,",
        "all x > 0, d > 0 and m > 0 are stable",
    ),
    "variances": (
        SHARE,
        "g = 2 alpha beta - gamma (2 - alpha),",
        "predicted_11 = 8 beta^2/((2 - alpha) g margin) + alpha/(2 - alpha),",
        "predicted_12 = beta (2 alpha + beta) (2 beta + gamma)/(g margin),",
        "predicted_13 = gamma (2 g + beta (2 beta + gamma))/(g margin),",
        "predicted_22 = 2 (2 beta^2 (beta + gamma) + gamma^2 (2 - alpha))/(g margin),",
        "predicted_23 = 2 beta gamma (2 beta + gamma)/(g margin),",
        "predicted_33 = 4 beta gamma^2/(g margin), also after the update,",
        "updated_11 = (1 - alpha)^2 predicted_11 + alpha^2,",
        "updated_12 = beta (2 alpha - beta) (2 beta - gamma)/(g margin),",
        "updated_13 = gamma (2 g - beta (2 beta - gamma))/(g margin),",
        "updated_22 = (beta (2 beta - gamma)^2 + gamma^2 margin)/(g margin),",
        "updated_23 = 2 beta gamma (2 beta - gamma)/(g margin)",
    ),
    "variances_of_coordinates": (
        "predicted_11 = (1 + x + y + d) (x (1 + x) + m)/(d m) - 1, y = (d + m)/x,",
        "predicted_12 = 2 (1 + x) (x (1 + x) + d + m)/(d m),",
        "predicted_13 = 4 (x (1 + x) + m)/(d m),",
        "predicted_22 = 4 (d + x (1 + x)^2)/(d m), predicted_23 = 8 x (1 + x)/(d m),",
        "predicted_33 = 16 x/(d m)",
    ),
    "updated_variances_of_coordinates": (
        "updated_12 = 2 x (x - 1) (1 + y - x)/(d m),",
        "updated_13 = 4 (m + x - x^2)/(d m),",
        "updated_22 = 4 x (x - 1)^2/(d m) + 4/m, updated_23 = 8 x (x - 1)/(d m), y = (d + m)/x;",
        "updated_33 is predicted_33, updated_11 is (1 - alpha)^2 predicted_11 + alpha^2",
    ),
    **NOISE_EQUATIONS,
    "lags": (
        SHARE,
        "predicted_position_lag = 1/gamma, predicted_acceleration_lag = beta/gamma + 1/2,",
        "predicted_velocity_lag = (12 alpha + 6 beta + gamma)/(12 gamma),",
        "updated_position_lag = (1 - alpha)/gamma, updated_acceleration_lag = beta/gamma - 1/2,",
        "updated_velocity_lag = (12 alpha - 6 beta + gamma)/(12 gamma);",
        "none behind rest, constant velocity and constant acceleration",
    ),
    POLES: POLE_EQUATIONS,
    "minimum_variance_by_lag": (
        "with x = 2 lag^(1/3) - 1: alpha = 2 (2 x^2 + 2 x + 1)/(1 + x)^3, beta = 4 x/(1 + x)^3,",
        "gamma = 8/(1 + x)^3, minimum_variance_predicted_11 = (1 + 1/x)^3 - 1",
    ),
    "random_acceleration_by_lag": (
        "alpha (alpha + beta + gamma/2) = 2 beta, beta^2 = 2 alpha gamma, gamma = 1/lag; with",
        "x (x + 2)^2 = 64 lag: random_acceleration_predicted_11 =",
        "4 x (5 x + 6)/((x - 2) (3 x^2 - 4))",
    ),
    "random_jerk_by_lag": (
        "2 alpha gamma - beta^2 = gamma^2/12, gamma = 1/lag,",
        "2 alpha^2 + 2 alpha beta - 4 beta + alpha gamma = gamma^2/18; with x = 2 beta/gamma:",
        "192 lag x = 3 x^4 + 12 x^3 + 14 x^2 + 4 x - 1, alpha = (3 x^2 + 1)/(24 lag);",
        "alpha is below 1, as of a Kalman filter, for lags above (2 + sqrt(3))/6",
    ),
    "random_acceleration_by_gain": (
        "beta = 2 (1 - w)^2, gamma = beta^2/(2 alpha), w = sqrt(1 - alpha),",
        "random_acceleration_predicted_11 = alpha (4 + w)/(w (1 + 4 w + w^2))",
    ),
    "random_jerk_by_gain": (
        "2 alpha gamma - beta^2 = gamma^2/12,",
        "2 alpha^2 + 2 alpha beta - 4 beta + alpha gamma = gamma^2/18; with x = 2 beta/gamma:",
        "alpha = 8 x (3 x^2 + 1)/(3 x^4 + 12 x^3 + 14 x^2 + 4 x - 1),",
        "random_jerk_predicted_11 = (1 + x + y + d) (x (1 + x) + m)/(d m) - 1 with",
        "y = (d + m)/x, d = (3 x^4 - 10 x^2 - 1)/(24 x), m = (9 x^2 - 1) (x^2 - 1)/(24 x)",
    ),
}
