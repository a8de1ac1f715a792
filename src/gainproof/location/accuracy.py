"""The covariance of all unknowns, and the biases with theirs."""

from __future__ import annotations

import numpy as np

from gainproof.fixed_gain.arguments import Reals
from gainproof.location.problem import Problem, jacobian, linearised, predicted
from gainproof.location.result import Bias


def accuracy(asked: Problem, unknowns: Reals) -> tuple[Reals, tuple[Bias, ...]]:
    """Covariance (k + q, k + q) of position, velocity and q biases at a target (k,), which has to
    be observable, and the biases. (42), (67).

    With white columns W C = Q U of the biases and the triangle R of what they leave of W J, a root
    of the covariance is [[1/R, 0], [-U^-1 Q' W J /R, U^-1]]: no normal equations are formed.
    """
    observed = asked.used.values[None, :]
    linear = linearised(asked, unknowns[None, :], observed)
    triangle = np.linalg.qr(linear.jacobian[0])[1]
    k, q = asked.unknowns, asked.columns.shape[1]
    root = np.zeros((k + q, k + q))
    root[:k, :k] = np.linalg.solve(triangle, np.eye(k)) / linear.scale[0][:, None]
    values, found = predicted(asked, unknowns[None, :])
    biases: tuple[Bias, ...] = ()
    if q:
        upper = asked.base.T @ asked.white @ asked.columns
        along = asked.base.T @ jacobian(asked, found)[0]
        root[k:, k:] = np.linalg.solve(upper, np.eye(q))
        root[k:, :k] = -root[k:, k:] @ along @ root[:k, :k]
        estimate = root[k:, k:] @ (asked.base.T @ (asked.white @ (observed - values)[0]))
        deviations = np.sqrt(np.square(root[k:]).sum(axis=1))
        names = [asked.stations.names[i] for i in asked.biases] or ["all"]
        told = zip(names, estimate.tolist(), deviations.tolist(), strict=True)
        biases = tuple(Bias(*each) for each in told)
    return np.asarray(root @ root.T), biases


def cost_without_bias(asked: Problem, unknowns: Reals) -> float:
    """The cost at a target (k,) if no range had a bias."""
    values, _ = predicted(asked, unknowns[None, :])
    rest = asked.white @ (asked.used.values - values[0])
    return float(rest @ rest)


def all_accuracies(asked: Problem, unknowns: Reals, observed: Reals) -> tuple[Reals, Reals]:
    """Biases (N, q) and their deviations at targets (N, k) for observations (N, m)."""
    linear = linearised(asked, unknowns, observed)
    triangle = np.linalg.qr(linear.jacobian)[1]
    k, q = asked.unknowns, asked.columns.shape[1]
    root = np.linalg.solve(triangle, np.broadcast_to(np.eye(k), triangle.shape))
    root = root / linear.scale[:, :, None]
    values, found = predicted(asked, unknowns)
    inverse = np.linalg.solve(asked.base.T @ asked.white @ asked.columns, np.eye(q))
    along = (inverse @ asked.base.T) @ jacobian(asked, found) @ root
    variances = np.square(along).sum(axis=2) + np.square(inverse).sum(axis=1)
    rest = (observed - values) @ asked.white.T
    return np.asarray(rest @ (inverse @ asked.base.T).T), np.sqrt(variances)
