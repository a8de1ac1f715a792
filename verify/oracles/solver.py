"""Steady state by SciPy's Riccati solver, polished by Newton steps, in float64.

Independent because SciPy finds the stable invariant subspace of a matrix pencil by a QZ
decomposition; nothing of it is ours. That answer alone can be wrong in the ninth digit, so it is
polished: each Newton step (Kleinman, 1971; Hewer, 1971) solves the Lyapunov equation of the
current gain, and the steps converge quadratically from any stabilising gain.

The accuracy rests on the last Lyapunov equation: its relative error is a few eps times its
condition number, which is returned. Useful for tracking indices from about 1e-3 to 1e3 if the
condition is to stay below 1e10; SciPy itself refuses extreme models (LinAlgError).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from gainproof.verify.oracles.matrices import matrix
from gainproof.verify.oracles.state_space import NotConverged, StateSpace, SteadyState


@dataclass(frozen=True)
class Solved:
    """A steady state in float64 and the Newton steps taken.

    ``condition`` is the condition number (2-norm) of the last Lyapunov equation.
    """

    state: SteadyState
    steps: int
    condition: float


def steady_state(model: StateSpace, most_steps: int = 30) -> Solved:
    """The stabilising steady state of ``model`` in float64.

    Raises ImportError when SciPy is missing, numpy.linalg.LinAlgError when SciPy finds no
    solution, NotConverged when the Newton steps do not settle.
    """
    try:
        import numpy as np
        from scipy import linalg
    except ImportError as missing:
        raise ImportError(
            "this oracle needs SciPy, which only the tests use: pip install 'gainproof[test]'"
        ) from missing

    f, q, h, r = (
        np.array([[float(x) for x in row] for row in rows])
        for rows in (
            model.transition,
            model.process_noise,
            model.measurement,
            model.measurement_noise,
        )
    )
    unit = np.eye(model.size)

    def gain_of(predicted: Any) -> tuple[Any, Any]:
        innovation = h @ predicted @ h.T + r
        return linalg.solve(innovation, h @ predicted, assume_a="pos").T, innovation

    predicted = linalg.solve_discrete_are(f.T, h.T, q, r)
    change = np.inf
    for step in range(1, most_steps + 1):
        gain, _ = gain_of(predicted)
        kept = unit - gain @ h
        loop = f @ kept
        left = np.eye(model.size**2) - np.kron(loop, loop)
        right = f @ gain @ r @ gain.T @ f.T + q
        new = linalg.solve(left, right.reshape(-1)).reshape(f.shape)
        new = (new + new.T) / 2
        previous, change = change, float(np.max(np.abs(new - predicted) / np.abs(new)))
        predicted = new
        # Newton steps shrink until rounding is all that moves; then they stop shrinking.
        if change == 0 or (step > 2 and change >= previous):
            break
    else:
        raise NotConverged(f"Newton steps still shrink after {most_steps}: last change {change}")
    gain, innovation = gain_of(predicted)
    kept = unit - gain @ h
    updated = kept @ predicted @ kept.T + gain @ r @ gain.T
    state = SteadyState(
        *(matrix(x.tolist()) for x in (predicted, (updated + updated.T) / 2, gain, innovation))
    )
    return Solved(state, step, float(np.linalg.cond(left)))
