"""What the kernels of alpha-beta-gamma filters say of themselves."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.fixed_gain.three_noise_words import NOISE_EQUATIONS, NOISE_SUMMARIES
from gainproof.derive.fixed_gain.three_pole_kernels import EQUATIONS as POLE_EQUATIONS
from gainproof.derive.fixed_gain.three_pole_kernels import POLES
from gainproof.derive.fixed_gain.three_pole_kernels import SUMMARY as POLE_SUMMARY

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
