"""What towers are made of: indices, gains, errors and covariances over e, n and the index.

Lambda = 2 e^2/(1 + e) runs through all indices once, and the gains have no root left.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.updated_gains.names import ENTRIES, FIRST_ALPHA, FIRST_BETA, INDEX

Elements = dict[str, sp.Expr]


def index_of(e: sp.Expr) -> sp.Expr:
    """The tracking index."""
    return 2 * e**2 / (1 + e)


def gains_of(e: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """alpha and beta."""
    return e * (2 + e) / (1 + e) ** 2, 2 * e**2 / (1 + e) ** 2


def slopes_of(e: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Their derivatives by the index."""
    return 1 / (e * (1 + e) * (2 + e)), 2 / ((1 + e) * (2 + e))


def excesses(n: sp.Expr, e: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """First-order gains from n less those of e."""
    square = (e - n) ** 2 / ((1 + e) * (1 + n)) ** 2
    alpha = square * (2 * (1 + n) * (1 + e) + n * (2 + n)) / (n * (2 + n))
    return alpha, 2 * square * (n + 2 * e + 2 * n * e) / (2 + n)


def drifts(n: sp.Expr, e: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """What a cycle of two indices adds to recursive gains."""
    size = 2 * (e - n) ** 2 * (e + n + e * n) / ((1 + e) * (1 + n))
    alpha = (n**2 + n * e + e**2 + 3 * (n + e) + 2) / (
        n * (n + 1) * (n + 2) * e * (e + 1) * (e + 2)
    )
    return size * alpha, size * 2 * (n + e + 3) / ((1 + n) * (2 + n) * (1 + e) * (2 + e))


def steady_covariances(e: sp.Expr) -> Elements:
    """Predicted and updated covariance of the best filter."""
    predicted = (e * (2 + e), 2 * e**2, 4 * e**3 / (1 + e))
    updated = (*gains_of(e), 4 * e**3 / (1 + e) ** 2)
    return dict(zip((f"predicted_{ij}" for ij in ENTRIES), predicted, strict=True)) | dict(
        zip((f"updated_{ij}" for ij in ENTRIES), updated, strict=True)
    )


def held_covariances(n: sp.Expr, ratio: sp.Expr) -> Elements:
    """With the gains of n at `ratio` times its index; linear in the square of the ratio."""
    square, below = ratio**2, 2 + n
    wide = below * (1 + n) ** 2
    velocity = 2 * n**3 * (1 + n + square * (n + 3)) / wide
    predicted = (
        n * (2 * n + 3 + square * (1 + n) ** 2) / below,
        2 * n**2 * (1 + square * (1 + n)) / below,
        velocity + square * index_of(n) ** 2,
    )
    updated = (
        n * ((n + 3) * (n + 1) + square) / wide,
        2 * n**2 * (1 + n + square) / wide,
        velocity,
    )
    return dict(zip((f"held_predicted_{ij}" for ij in ENTRIES), predicted, strict=True)) | dict(
        zip((f"held_updated_{ij}" for ij in ENTRIES), updated, strict=True)
    )


def followed_covariances() -> Elements:
    """Of any gains, here of those to first order, under a manoeuvre of the index."""
    a, b, square = FIRST_ALPHA, FIRST_BETA, INDEX**2
    below = 4 - 2 * a - b
    ratio = b / a
    first = (2 * a + 2 * ratio + b + square * ((2 - a) / (a * b) - 1 / (2 * a))) / below
    cross = (2 * b + ratio * b + square * ((2 - a) / b + (1 - a) / a - ratio / 4)) / below
    p, q, r = (sp.Symbol(f"followed_predicted_{ij}", real=True) for ij in ENTRIES)
    last = 2 * ratio * b + square * (
        ratio * (2 - a) / 4 - (2 - a) - ratio * (1 - a) + (a * (2 - a) + 2 * ratio * (1 - a)) / b
    )
    return {
        "followed_predicted_11": first,
        "followed_predicted_12": cross,
        "followed_predicted_22": last / below + square,
        "followed_updated_11": (1 - a) ** 2 * p + a**2,
        "followed_updated_12": (1 - a) * (q - b * p) + a * b,
        "followed_updated_22": r - square,
    }
