"""Matrices that fulfil the hypotheses of location from range and Doppler, drawn at random.

Nothing that the derivation says of them is used: where an equation is asked for, one side is drawn
or solved for by NumPy and the other follows.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

Matrix = NDArray[np.float64]
LINEAR = ("seen", "missed", "least", "null", "unbiased", "best", "whole")
LOCATION = ("seen", "clean", "none", "uncorrelated", "few", "common")
CORNERS = ("definite", "symmetric")
ORDER = ("ordered", "same", "eigen")


def matrices(tower: str) -> list[dict[str, Any]]:
    """Sets for the setting of that name."""
    kinds, made = {
        "linear": (LINEAR, linear),
        "location": (LOCATION, location),
        "selection": (("any", "other"), selection),
        "free": (("any", "few"), free),
        "corners": (CORNERS, corners),
        "order": (ORDER, order),
    }[tower]
    return [made(np.random.default_rng([seed, 7]), kind) for seed, kind in enumerate(kinds)]


def linear(rng: np.random.Generator, kind: str) -> dict[str, Any]:
    """Seven measurements of four unknowns; two chosen; three kept; two left out."""
    design, noise = rng.standard_normal((7, 4)), _definite(rng, 7)
    chosen = np.eye(4)[1:3]
    kept = rng.standard_normal((4, 4 if kind == "whole" else 3))
    weight = np.linalg.inv(noise)
    estimator = np.linalg.solve(design.T @ weight @ design, design.T @ weight)
    truth, error = rng.standard_normal((4, 1)), rng.standard_normal((7, 1))
    left_out, left_values = rng.standard_normal((7, 2)), rng.standard_normal((2, 1))
    observed = design @ truth + error + (left_out @ left_values if kind == "missed" else 0)
    free = np.eye(7) - design @ np.linalg.pinv(design)
    other = chosen @ estimator
    if kind == "unbiased":
        other = other + rng.standard_normal((2, 7)) @ free
    return {
        "design": design,
        "noise": noise,
        "observed": observed,
        "error": error,
        "unknown": truth,
        "mean_observed": design @ truth,
        "mean_error": np.zeros((7, 1)),
        "any_estimate": estimator @ observed if kind == "least" else rng.standard_normal((4, 1)),
        "null_vector": np.zeros((4, 1)) if kind == "null" else rng.standard_normal((4, 1)),
        "chosen": chosen,
        "other_estimator": other if kind != "seen" else rng.standard_normal((2, 7)),
        "kept_columns": kept,
        "left_out": left_out,
        "left_values": left_values,
        "row": np.eye(2)[:, :1],
    }


def location(rng: np.random.Generator, kind: str) -> dict[str, Any]:
    """Six stations in a plane, three clean; "few": eight in space; "common": one bias for all."""
    d, n, b = (3, 8, 2) if kind == "few" else (2, 6, 1 if kind == "common" else 3)
    noise = _definite(rng, 2 * n)
    if kind == "uncorrelated":
        noise[:n, n:] = noise[n:, :n] = 0
    columns = np.linalg.qr(rng.standard_normal((n, b)))[0]
    if kind == "common":
        columns = np.full((n, 1), 1 / np.sqrt(n))
    ranges, rates = rng.standard_normal((2, n, d))
    place, speed = rng.standard_normal((2, d, 1))
    unclean = rng.standard_normal((b, 1))
    biases = {"clean": columns @ unclean, "none": np.zeros((n, 1))}.get(
        kind, rng.standard_normal((n, 1))
    )
    error = rng.standard_normal((2 * n, 1))
    seen = np.vstack([ranges @ place + biases, rates @ place + ranges @ speed]) + error
    whole = {"m": 2 * n, "s": 2 * d + n, "q": 2 * d + b, "k": 2 * d}
    unit = {size: np.eye(number) for size, number in whole.items()}
    return {
        "range_rows": unit["m"][:, :n],
        "doppler_rows": unit["m"][:, n:],
        "full_position": unit["s"][:, :d],
        "full_velocity": unit["s"][:, d : 2 * d],
        "full_biases": unit["s"][:, 2 * d :],
        "kept_position": unit["q"][:, :d],
        "kept_velocity": unit["q"][:, d : 2 * d],
        "kept_biases": unit["q"][:, 2 * d :],
        "position": unit["k"][:, :d],
        "velocity": unit["k"][:, d:],
        "range_design": ranges,
        "rate_design": rates,
        "bias_columns": columns,
        "noise": noise,
        "observed": seen,
        "error": error,
        "place": place,
        "speed": speed,
        "biases": biases,
        "unclean": unclean,
        "station": np.eye(n)[:, 2:3],
    }


def selection(rng: np.random.Generator, kind: str) -> dict[str, Any]:
    """Two, one and three of six ranges, or one, two and two of five."""
    u, w, b = (2, 1, 3) if kind == "any" else (1, 2, 2)
    n, k = u + w + b, 4
    weight, share = _definite(rng, n), rng.standard_normal((n, k))
    large = np.zeros((n, n))
    large[u:, u:] = np.linalg.inv(weight[u:, u:])
    whole, kept = np.eye(n), np.eye(w + b)
    return {
        "always": whole[:, :u],
        "between": whole[:, u : u + w],
        "never": whole[:, u + w :],
        "kept_between": kept[:, :w],
        "kept_never": kept[:, w:],
        "G11": weight,
        "P": share,
        "K11": share.T @ large @ share + _definite(rng, k),
    }


def free(rng: np.random.Generator, kind: str) -> dict[str, Any]:
    """Seven measurements, three of them with an unknown of their own, or five of nine."""
    m, b = (7, 3) if kind == "any" else (9, 5)
    rows, unknowns = np.eye(m), np.eye(2 + b)
    return {
        "heard_rows": rows[:, b:],
        "alone_rows": rows[:, :b],
        "shared_columns": unknowns[:, :2],
        "own_columns": unknowns[:, 2:],
        "shared_design": rng.standard_normal((m, 2)),
        "noise": _definite(rng, m),
    }


def corners(rng: np.random.Generator, kind: str) -> dict[str, Any]:
    """A matrix of size 5 in blocks of sizes 3 and 2."""
    whole = _definite(rng, 5)
    if kind == "symmetric":
        whole = whole - 1.3 * np.eye(5)
    unit = np.eye(5)
    return {"upper_rows": unit[:, :3], "lower_rows": unit[:, 3:], "blocked": whole}


def order(rng: np.random.Generator, kind: str) -> dict[str, Any]:
    """Three matrices of size 4, each above the next; "same": the first two are one."""
    third, matrix = _definite(rng, 4), _definite(rng, 4)
    second = third + _definite(rng, 4)
    first = second if kind == "same" else second + _definite(rng, 4)
    values, vectors = np.linalg.eigh(matrix)
    return {
        "D": matrix,
        "D1": first,
        "D2": second,
        "D3": third,
        "eigenvectors": vectors,
        "eigenvalues": np.diag(values),
        "eigenvalue": float(values[0]),
        "eigenvector": vectors[:, :1],
        "any_factor": rng.standard_normal((4, 2)),
        "direction": np.eye(4)[:, :1],
    }


def _definite(rng: np.random.Generator, size: int) -> Matrix:
    root = rng.standard_normal((size, size))
    return np.asarray(root @ root.T / size + 0.3 * np.eye(size))
