"""Draws of converted measurements: normalised errors of every conversion under each condition.

The mean of e' P^-1 e over the number of coordinates is 1 where P is the covariance of an error e
of mean 0. Given the measurement its expectation is that of the oracle's moments; given the truth,
where P is drawn too, a sum over nodes of the noises, in floats.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from converted_truth import NAMES
from numpy.typing import NDArray

from gainproof.generated import converted_measurements
from gainproof.verify.oracles import converted_enclosure

Floats = NDArray[np.float64]
CONDITIONS = ("truth", "measurement")


@dataclass(frozen=True)
class Scene:
    """Range, elevation, azimuth and deviations; in the plane the second of both is 0."""

    place: tuple[float, float, float]
    deviations: tuple[float, float, float]

    @property
    def size(self) -> int:
        """The number of coordinates."""
        return 3 if self.deviations[1] else 2


@dataclass(frozen=True)
class Normalised:
    """Of one conversion under one condition: mean error along the line of sight, in m; normalised
    squared error, its deviation in the mean of all draws, and what it should be.
    """

    name: str
    condition: str
    bias: float
    found: float
    deviation: float
    expected: float

    @property
    def off(self) -> float:
        """How many deviations found and expected are apart."""
        return abs(self.found - self.expected) / self.deviation


def converted_by(
    name: str, size: int, polar: Floats, deviations: Sequence[float]
) -> tuple[Floats, Floats]:
    """Places and covariances of measurements; rows of `polar` are ranges, elevations, azimuths."""
    kernel = getattr(converted_measurements, f"{name}_conversion{'' if size == 3 else '_in_plane'}")
    keep = [0, 1, 2] if size == 3 else [0, 2]
    found = kernel(*polar[keep], *(deviations[each] for each in keep))
    places = np.stack([getattr(found, each) for each in "xyz"[:size]], axis=-1)
    matrices = np.empty((*places.shape, size))
    for i, j in product(range(size), repeat=2):
        a, b = sorted((i, j))
        matrices[..., i, j] = getattr(found, f"covariance_{'xyz'[a]}{'xyz'[b]}")
    return places, matrices


def cartesian(polar: Floats, size: int) -> Floats:
    """Places of ranges, elevations and azimuths."""
    r, e, a = polar
    level = r * np.cos(e)
    return np.stack([level * np.cos(a), level * np.sin(a), r * np.sin(e)][:size], axis=-1)


def squares(errors: Floats, matrices: Floats) -> Floats:
    """e' P^-1 e over the number of coordinates."""
    solved = np.linalg.solve(matrices, errors[..., None])[..., 0]
    found: Floats = np.einsum("...i,...i->...", errors, solved) / errors.shape[-1]
    return found


def normalised(scene: Scene, draws: int, seed: int) -> list[Normalised]:
    """Every conversion under both conditions, from the same draws of noise."""
    generator = np.random.default_rng(seed)
    noise = generator.standard_normal((3, draws)) * np.array(scene.deviations)[:, None]
    at = np.array(scene.place)[:, None]
    here = cartesian(at, scene.size)
    sight = here / np.linalg.norm(here)
    found = []
    for name, condition in product(NAMES, CONDITIONS):
        if condition == "truth":
            places, matrices = converted_by(name, scene.size, at + noise, scene.deviations)
            errors = places - here
            expected = _given_truth(scene, name)
        else:
            places, matrices = converted_by(name, scene.size, at, scene.deviations)
            errors = places - cartesian(at - noise, scene.size)
            matrices = np.broadcast_to(matrices, (draws, *matrices.shape[1:]))
            expected = _given_measurement(scene, name)
        each = squares(errors, matrices)
        bias = float((errors @ sight[0]).mean())
        spread = float(each.std() / np.sqrt(draws))
        found.append(Normalised(name, condition, bias, float(each.mean()), spread, expected))
    return found


def _given_measurement(scene: Scene, name: str) -> float:
    """From mean and covariance of the truth."""
    true = converted_enclosure.given_measurement(scene.place, scene.deviations)
    size = scene.size
    places, matrices = converted_by(name, size, np.array(scene.place)[:, None], scene.deviations)
    off = places[0] - np.array([float(value) for value in true.mean[:size]])
    spread = np.array([[float(value) for value in row[:size]] for row in true.covariance[:size]])
    return float(np.trace(np.linalg.solve(matrices[0], spread + np.outer(off, off))) / size)


def _given_truth(scene: Scene, name: str) -> float:
    """A sum over nodes of the noises."""
    counts = [12, 24 if scene.size == 3 else 1, 60]
    rules = [np.polynomial.hermite_e.hermegauss(count) for count in counts]
    axes = [nodes * size for (nodes, _), size in zip(rules, scene.deviations, strict=True)]
    grid = np.stack([each.ravel() for each in np.meshgrid(*axes, indexing="ij")])
    weights = np.prod(np.meshgrid(*(w / w.sum() for _, w in rules), indexing="ij"), axis=0).ravel()
    at = np.array(scene.place)[:, None]
    places, matrices = converted_by(name, scene.size, at + grid, scene.deviations)
    return float(weights @ squares(places - cartesian(at, scene.size), matrices))
