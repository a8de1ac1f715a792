"""What the kernels of process noises say of themselves."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.fixed_gain.three_noise_kernels import kernel_of

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
