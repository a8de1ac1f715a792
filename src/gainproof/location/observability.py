"""What a geometry leaves unobserved: the scaled rank of the model, and its null directions."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.errors import Direction
from gainproof.location.gauss_newton import rank_tolerance
from gainproof.location.geometry_words import listed
from gainproof.location.measurement import seen
from gainproof.location.problem import Linear, Problem, jacobian, linearised, residual

AXES = "xyz"
NOTHING = 1e-6
"""A part of a direction below this share of the whole is not told."""


@dataclass(frozen=True)
class Observability:
    """The scaled rank of `unknowns` of position and velocity, the ratio of the least to the largest
    singular value, and the directions that are free.
    """

    rank: int
    unknowns: int
    ratio: float
    directions: tuple[Direction, ...]


def observability(asked: Problem, unknowns: Reals) -> Observability:
    """At one target (k,)."""
    at = unknowns[None, :]
    linear = linearised(asked, at, np.zeros((1, len(asked.used.values))))
    _, singular, right = np.linalg.svd(linear.jacobian[0], full_matrices=True)
    k = asked.unknowns
    padded = np.concatenate([singular, np.zeros(k - len(singular))])
    top = float(padded[0])
    fine = padded > rank_tolerance(asked) * top if top > 0 else np.zeros(k, np.bool_)
    rank = int(fine.sum())
    free = _readable(right[rank:]) / linear.scale[0]
    told = tuple(_direction(asked, linear, unknowns, row) for row in free)
    return Observability(rank, k, float(padded[-1] / top) if top > 0 else 0.0, told)


def weakest(
    asked: Problem, unknowns: Reals, limit: float = np.inf
) -> tuple[tuple[Direction, ...], float]:
    """The directions of position whose 1-sigma is beyond the limit, or else the one known worst;
    and the largest 1-sigma, in m.
    """
    d = asked.stations.dimension
    covariance = position_velocity_covariance(asked, unknowns)[:d, :d]
    values, vectors = np.linalg.eigh(covariance)
    wide = max(int((values > limit**2).sum()), 1)
    rows = np.zeros((wide, asked.unknowns))
    rows[:, :d] = _readable(vectors[:, -wide:].T)
    linear = linearised(asked, unknowns[None, :], np.zeros((1, len(asked.used.values))))
    told = tuple(_direction(asked, linear, unknowns, row, alone=True) for row in rows)
    return told, float(np.sqrt(values[-1]))


def position_velocity_covariance(asked: Problem, unknowns: Reals) -> Reals:
    """(k, k) at one target, through the triangle of the QR factorisation."""
    at = linearised(asked, unknowns[None, :], np.zeros((1, len(asked.used.values))))
    triangle = np.linalg.qr(at.jacobian[0])[1]
    root = np.linalg.solve(triangle, np.eye(len(triangle))) / at.scale[0][:, None]
    return np.asarray(root @ root.T)


def bending(asked: Problem, unknowns: Reals) -> float:
    """How far residuals one deviation away along the axes of the covariance are from those of the
    linear model, in deviations: the largest. 0 where the model is linear.
    """
    observed = asked.used.values[None, :]
    linear = linearised(asked, unknowns[None, :], observed)
    _, singular, right = np.linalg.svd(linear.jacobian[0], full_matrices=False)
    steps = (right / singular[:, None]) / linear.scale[0]
    both = np.concatenate([steps, -steps])
    rows = np.broadcast_to(observed, (len(both), observed.shape[1]))
    with np.errstate(all="ignore"):
        moved = residual(asked, unknowns + both, rows)
    off = moved - linear.residual + (both * linear.scale[0]) @ linear.jacobian[0].T
    sizes = np.linalg.norm(off, axis=1)
    return float(sizes.max()) if np.isfinite(sizes).all() else float("inf")


def _readable(null: Reals) -> Reals:
    """Another basis of the rows' space: reduced row echelon form, each row of length one."""
    rows = np.array(null)
    taken: list[int] = []
    for i in range(len(rows)):
        left = np.abs(rows[i:])
        # the later component of equal ones: height before x, velocity before position
        best = left.max() * (1 - 1e-9)
        at, column = max(np.argwhere(left >= best).tolist(), key=lambda place: place[1])
        rows[[i, i + at]] = rows[[i + at, i]]
        rows[i] /= rows[i, column]
        for j in range(len(rows)):
            if j != i:
                rows[j] -= rows[j, column] * rows[i]
        taken.append(column)
    order = np.argsort(taken)
    rows = rows[order]
    return np.asarray(rows / np.linalg.norm(rows, axis=1)[:, None]) if len(rows) else rows


def _direction(
    asked: Problem, linear: Linear, unknowns: Reals, row: Reals, alone: bool = False
) -> Direction:
    d = asked.stations.dimension
    weight = np.abs(row * linear.scale[0])
    row = np.where(weight > NOTHING * weight.max(), row, 0.0)
    place, motion = row[:d], row[d:]
    size = float(np.linalg.norm(place)) or float(np.linalg.norm(motion))
    place, motion = place / size, motion / size
    biases = () if alone else _following(asked, unknowns, np.concatenate([place, motion]))
    said = " with ".join(
        words
        for words in (
            _words("position", place, ""),
            _words("velocity", motion, "" if not place.any() else " (m/s per m)"),
        )
        if words
    )
    if biases:
        said += (
            f" (and the bias{'es' if len(biases) > 1 else ''} of {listed([b[0] for b in biases])})"
        )
    return Direction(tuple(place.tolist()), tuple(motion.tolist()), biases, said)


def _words(what: str, part: Reals, unit: str) -> str:
    if not part.any():
        return ""
    (axes,) = np.nonzero(part)
    if len(axes) == 1 and not unit:
        return f"{what} along {AXES[axes[0]]}"
    return f"{what} along ({', '.join(f'{value:.4g}' for value in part.tolist())}){unit}"


def _following(asked: Problem, unknowns: Reals, row: Reals) -> tuple[tuple[str, float], ...]:
    """The biases that change with a free direction so that no range changes."""
    if not asked.columns.shape[1]:
        return ()
    found = seen(asked.stations, *asked.split(unknowns[None, :]))
    moved = jacobian(asked, found)[0] @ row
    change = -np.linalg.lstsq(asked.white @ asked.columns, moved, rcond=None)[0]
    names = [asked.stations.names[i] for i in asked.biases] or ["all stations"]
    return tuple(
        (name, value)
        for name, value in zip(names, change.tolist(), strict=True)
        if abs(value) > NOTHING * (1 + np.abs(change).max())
    )
