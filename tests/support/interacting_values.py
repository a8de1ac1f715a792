"""Matrices that fulfil the hypotheses of filters with matrix gains: drawn, and solved for.

Steady covariances come from SciPy's discrete Lyapunov equation, adjoints likewise, lags from a
linear system; what the derivation says of them is not used.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import solve_discrete_lyapunov, sqrtm

Matrix = NDArray[np.float64]
KINDS = (
    *("any", "diagonal", "own", "followed", "root", "smoothing", "quiet", "scaled", "filter"),
    "grown",
)


def matrices(kind: str, seed: int, size: int = 2) -> dict[str, Any]:
    """One set for the setting "blocks": two coordinates or more, all of them stable filters.

    "any": full gains; "diagonal": diagonal ones with a row u'; "own", "followed": K1 is the gain of
    the position that is Kalman's, or that of the predicted position; "root", "smoothing": K1 from
    the square root of T K2, best for the predicted or updated position; "quiet": a left vector that
    hears no noise; "scaled": A commutes with K2; "filter": truth and estimates of one step;
    "grown": on the border, where a covariance goes on without noise.
    """
    rng = np.random.default_rng([seed, KINDS.index(kind), size])
    unit, zero = np.eye(size), np.zeros((size, size))
    first, second = np.vstack([unit, zero]), np.vstack([zero, unit])
    t, z = float(rng.uniform(0.5, 2)), float(rng.uniform(-2, 2))
    alphas, betas = rng.uniform(0.2, 0.6, size), rng.uniform(0.1, 0.4, size)
    noise, prior = _definite(rng, size), _definite(rng, 2 * size)
    k1: Any = np.diag(alphas)
    if kind != "diagonal":
        k1 = k1 + 0.1 * rng.standard_normal((size, size))
    k2 = np.diag(betas) / t
    if kind in ("any", "own", "followed", "filter"):
        k2 = k2 + 0.02 * rng.standard_normal((size, size))
    if kind == "quiet":
        k2[:, 0] = k2[0, :] = 0
        k2[0, 0] = 0.0
    innovation = np.linalg.inv(prior[:size, :size] + noise)
    if kind == "own":
        k1 = prior[:size, :size] @ innovation
    if kind == "followed":
        k1 = (prior[:size, :size] + t * prior[size:, :size]) @ innovation - t * k2
    square_root = np.real(sqrtm(t * k2)) if kind == "root" else rng.standard_normal((size, size))
    if kind == "root":
        k1 = square_root - square_root @ square_root / 2
    if kind == "smoothing":
        square_root = np.real(sqrtm(t * k2))
        k1 = (square_root + square_root @ square_root / 2) @ np.linalg.inv(unit + square_root)
    grown = np.zeros((2 * size, 2 * size))
    if kind == "grown":
        k1, k2 = unit, 2 * unit / t
        on = t * first + second
        grown = on @ _definite(rng, size) @ on.T
    scale = np.diag(rng.uniform(0.5, 2, size))
    changed = k1 + 0.02 * rng.standard_normal((size, size))
    phi = np.block([[unit, t * unit], [zero, unit]])

    def steady(position: Matrix, variance: Matrix) -> tuple[Matrix, Matrix]:
        gain = np.vstack([position, k2])
        loop = phi @ (np.eye(2 * size) - gain @ first.T)
        if kind == "quiet" or max(abs(np.linalg.eigvals(loop))) >= 1:
            return loop, np.zeros((2 * size, 2 * size))
        found = solve_discrete_lyapunov(loop, phi @ gain @ variance @ gain.T @ phi.T)
        return loop, (found + found.T) / 2

    loop, covariance = steady(k1, noise)
    other_noise = _definite(rng, size)
    weight = _definite(rng, 2 * size)
    acceleration = rng.standard_normal((size, 1))
    drive = first @ acceleration * t**2 / 2 + second @ acceleration * t
    moved, moved_covariance = steady(changed, noise)
    adjoint = np.asarray(solve_discrete_lyapunov(moved.T, weight) if kind == "any" else weight)
    truth, predicted = rng.standard_normal((2, 2 * size, 1))
    heard = rng.standard_normal((size, 1))
    return {
        "t": t,
        "z": z,
        "alpha": float(alphas[0]),
        "beta": float(betas[0]),
        "root": float(np.sqrt(betas[0])),
        "E1": first,
        "E2": second,
        "K1": k1,
        "K2": k2,
        "B": noise,
        "W": covariance,
        "P": prior,
        "error": np.linalg.solve(np.eye(2 * size) - loop, drive)
        if kind != "quiet"
        else np.zeros_like(drive),
        "acceleration": acceleration,
        "noise": heard,
        "truth": truth,
        "next_truth": phi @ truth + drive,
        "observed": first.T @ truth + heard,
        "predicted": predicted,
        "coordinate": np.eye(size)[:, :1],
        "state": second[:, :1],
        "change": changed - k1,
        "weight": weight,
        "adjoint": adjoint,
        "other": moved_covariance if kind != "scaled" else steady(k1, other_noise)[1],
        "second_noise": other_noise,
        "scale": scale,
        "scaled": scale @ k1 @ np.linalg.inv(scale),
        "square_root": square_root,
        "limit": grown,
    }


def update_matrices(seed: int, best: bool) -> dict[str, Any]:
    """One set for the setting "update": four states, two measurements; `best`: Kalman's gain."""
    rng = np.random.default_rng([seed, best])
    prior, noise, added = _definite(rng, 4), _definite(rng, 2), _definite(rng, 4)
    seen, transition = rng.standard_normal((2, 4)), rng.standard_normal((4, 4))
    gain: Any = rng.standard_normal((4, 2))
    if best:
        gain = np.linalg.solve(seen @ prior @ seen.T + noise, seen @ prior).T
    return {"P": prior, "R": noise, "H": seen, "K": gain, "transition": transition, "Q": added}


def row_matrices(seed: int, chained: bool) -> dict[str, Any]:
    """One set for the setting "rows": four states, an eigenvalue c + i s; `chained`: the rows are
    those after an eigenvector's.
    """
    rng = np.random.default_rng([seed, chained, 4])
    rows, loop = rng.standard_normal((4, 4)), rng.standard_normal((4, 4))
    real, imaginary = rng.standard_normal(2)
    loop[:2] = [[real, -imaginary, chained, 0], [imaginary, real, 0, chained]]
    matrix = np.linalg.solve(rows, loop @ rows)
    tails = chained * rows[2:]
    free = np.eye(4) - np.linalg.pinv(tails) @ tails
    carried = free @ _definite(rng, 4) @ free
    carried = (carried + carried.T) / 2
    return {
        "loop_matrix": matrix,
        "carried": carried,
        "brought": carried - matrix @ carried @ matrix.T,
        "first_row": rows[:1].T,
        "second_row": rows[1:2].T,
        "first_tail": tails[:1].T,
        "second_tail": tails[1:].T,
        "real_part": float(real),
        "imaginary_part": float(imaginary),
    }


def _definite(rng: np.random.Generator, size: int) -> Matrix:
    root = rng.standard_normal((size, size))
    return np.asarray(root @ root.T / size + 0.3 * np.eye(size))
