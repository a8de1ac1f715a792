"""What the kernels of gains that follow the index say of themselves."""

from __future__ import annotations

MEANINGS = {
    "tracking_index": "tracking index Lambda",
    "nominal_index": "nominal index L, at which the gains are exact",
    "next_index": "tracking index of the next scan",
    "acceleration_deviation": "standard deviation of the acceleration, m/s^2",
    "interval": "time between two scans, s",
    "variance": "variance of the measurement along the axis, m^2",
    "alpha": "position gain",
    "beta": "velocity gain times the sampling interval",
    "next_alpha": "position gain for the next index",
    "next_beta": "velocity gain times the sampling interval for the next index",
    "alpha_one_ratio": "Lambda/L beyond which the position gain exceeds 1",
    "unstable_ratio": "Lambda/L from which on the filter is not stable",
    "variance_ratio": "Lambda/L up to which the update lowers all variances, over those of L",
    "alpha_gain_ratio": "Lambda/L beyond which alpha is farther from the exact one than that of L",
    "beta_gain_ratio": "Lambda/L beyond which beta is farther from the exact one than that of L",
    "alpha_excess_over_square": "first-order position gain less the exact one, over (Lambda - L)^2",
    "beta_excess_over_square": "first-order velocity gain times T less the exact one, over "
    "(Lambda - L)^2",
    "alpha_drift_over_square": "what the cycle adds to the position gain, over (Lambda - L)^2",
    "beta_drift_over_square": "what the cycle adds to the velocity gain times T, over "
    "(Lambda - L)^2",
    **{
        f"{kind}_{ij}{end}": f"variance of the {kind} {word} {over}"
        for kind in ("predicted", "updated")
        for ij, word, unit in (
            ("11", "position", "over sigma_v^2"),
            ("22", "velocity", "times T^2/sigma_v^2"),
        )
        for end, over in (("", unit), ("_ratio", "over the least one, at least 1"))
    },
    "along": "gain along the line of sight",
    "across": "gain across it",
    "cosine": "cosine of the angle from the x axis to the line of sight",
    "sine": "its sine",
    "gain_xx": "gain of x by the innovation of x",
    "gain_xy": "gain of x by the innovation of y, and of y by that of x",
    "gain_yy": "gain of y by the innovation of y",
}
SUMMARIES = {
    "tracking_index": "The tracking index of an axis from the variance of its measurement.",
    "first_order_gains": "Gains updated to first order from a nominal index, constant derivatives.",
    "recursive_gains": "Gains updated to first order from those of the last scan.",
    "update_limits": "How far from its nominal index a first-order update is of use.",
    "first_order_errors": "By how much first-order gains are too large.",
    "cycle_drift": "What recursive updates add to gains from L to Lambda and back.",
    "mismatch_variances": "Steady variances with the gains of a nominal index.",
    "line_of_sight_gains": "Gains along and across the line of sight, turned into x and y.",
}
ROOT = "n = L (1 + sqrt(1 + 8/L))/4"
BOTH = f"{ROOT}, e the same of Lambda,"
EQUATIONS: dict[str, tuple[str, ...]] = {
    "tracking_index": ("Lambda = sigma_w T^2/sqrt(R)",),
    "first_order_gains": (
        "alpha(L) + alpha'(L) (Lambda - L), beta likewise, as sums of positive terms:",
        "alpha = (n (n^2 + 4 n + 2)/(1 + n) + Lambda/n)/((1 + n) (2 + n)),",
        f"beta = 2 (n^3/(1 + n) + Lambda)/((1 + n) (2 + n)), {ROOT};",
        "never below the exact gains; alpha > 1 and unstable filters as `update_limits` has it",
    ),
    "recursive_gains": (
        "next_alpha = alpha + alpha'(Lambda) (next_index - Lambda), next_beta likewise, with",
        "alpha' = 1/(e (1 + e) (2 + e)), beta' = 2/((1 + e) (2 + e)),",
        "e = Lambda (1 + sqrt(1 + 8/Lambda))/4; errors of all steps add up (`cycle_drift`)",
    ),
    "update_limits": (
        "of `first_order_gains`: alpha_one_ratio = 3/2 + 1/n, unstable_ratio = 2 + 2/n,",
        "variance_ratio = (n + 2 + sqrt(5 n^2 + 4 n + 4))/(2 n), the c with c - 1/c = 1 + 2/n,",
        "alpha_gain_ratio: Lambda/L at e = (s + n - 1)/2, s = sqrt(5 n^2 + 10 n + 1),",
        "beta_gain_ratio: at e = (u + 2 n + 1)/2, u = sqrt(4 n^2 + 8 n + 1);",
        f"{ROOT}, Lambda = 2 e^2/(1 + e).",
        "Below L the update is always nearer than the gains of L",
    ),
    "first_order_errors": (
        "Gains of `first_order_gains` less the exact ones, over the square of the step: with",
        f"{BOTH} b = 2 (n + e + n e):",
        "alpha: (2 (1 + n) (1 + e) + n (2 + n))/(n (2 + n) b^2),",
        "beta: 2 (n + 2 e + 2 n e)/((2 + n) b^2). Never negative",
    ),
    "cycle_drift": (
        "(alpha'(L) - alpha'(Lambda)) (Lambda - L) and its like of beta, over the square of the",
        f"step: with {BOTH} b = 2 (n + e + n e):",
        "alpha: (n^2 + n e + e^2 + 3 n + 3 e + 2)/(n (2 + n) e (2 + e) b),",
        "beta: 2 (n + e + 3)/((2 + n) (2 + e) b). Never negative, and the same every cycle",
    ),
    "mismatch_variances": (
        f"{BOTH} c = Lambda/L:",
        "predicted_11 = n (2 n + 3 + c^2 (1 + n)^2)/(2 + n),",
        "updated_11 = n ((3 + n) (1 + n) + c^2)/((1 + n)^2 (2 + n)),",
        "updated_22 = 2 n^3 (1 + n + c^2 (3 + n))/((1 + n)^2 (2 + n)),",
        "predicted_22 = updated_22 + Lambda^2; terms without c are the measurement's noise.",
        "The least variances are those of the gains of Lambda",
    ),
    "line_of_sight_gains": (
        "gain_xx = along cosine^2 + across sine^2, gain_xy = (along - across) cosine sine,",
        "gain_yy = along sine^2 + across cosine^2: once with both alpha, once with both beta",
    ),
}
