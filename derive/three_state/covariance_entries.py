"""Covariances of the three-state steady state over xi, eta and delta.

All are q = Lambda^2 times a polynomial: S beta gamma = q xi/2, S alpha gamma = q (eta + 1)/4,
S alpha beta = q xi (eta + 1)/8 with S = q nu^2/64. The first column is K S (or K, R being 1); the
others follow from M = F X F' + q Q0 entry by entry.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.three_state.names import ALPHA, BETA, ETA, GAMMA, INDEX, NU, TAU, XI

Entries = dict[str, sp.Expr]


def _rate(noise: sp.MatrixBase) -> sp.Expr:
    """What Q0 adds to 22: Q22 - Q12 - Q13/2 - Q23/4."""
    return noise[1, 1] - noise[0, 1] - noise[0, 2] / 2 - noise[1, 2] / 4


def predicted(noise: sp.MatrixBase) -> Entries:
    """The predicted covariance."""
    q = INDEX**2
    return {
        "predicted_11": q * NU * (ETA + 1) / 32,
        "predicted_12": q * NU * XI / 16,
        "predicted_13": q * NU / 8,
        "predicted_22": q * ((TAU + XI + 2 * ETA + 2) / 8 + _rate(noise)),
        "predicted_23": q * ((ETA + 1 + XI) / 4 + noise[1, 2] / 2 - noise[0, 2]),
        "predicted_33": q * (XI / 2 + noise[2, 2] - noise[1, 2]),
    }


def updated(noise: sp.MatrixBase, a1: sp.Rational) -> Entries:
    """The updated covariance."""
    q = INDEX**2
    return {
        "updated_11": ALPHA,
        "updated_12": BETA,
        "updated_13": GAMMA,
        "updated_22": q * ((TAU + XI - 2 * ETA + 2 - 2 * a1) / 8 + _rate(noise)),
        "updated_23": q * ((ETA + 1 - XI) / 4 + noise[1, 2] / 2 - noise[0, 2]),
        "updated_33": q * (XI / 2 - noise[1, 2]),
    }
