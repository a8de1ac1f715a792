"""Gains and covariances against the Riccati equation itself, solved from F, Q, R and H alone.

The certificate of a steady state holds the model in units in which the sampling interval and the
deviation of the first measurement are 1, says which quantities are which entries of the steady
state, and which outputs of kernels are these quantities. Nothing else of it is used: doubling
(structure-preserving, as Chu, Fan, Lin and Wang have it) finds the covariance with 50 digits.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import mpmath
import numpy as np
import pytest

from gainproof.standalone.shipped._package import FORMATS, VALUES, certificate, function

DIGITS = 50
ORDINARY = 1e4
"""Inputs from its inverse up: the covariance is conditioned well enough for so many digits."""
KINDS = ("predicted", "updated", "gain")


def number(entry: Any, names: Mapping[str, Any]) -> Any:
    """An entry of a model: a number as text, or a graph over named numbers."""
    if isinstance(entry, str):
        above, _, below = entry.partition("/")
        return mpmath.mpf(above) / mpmath.mpf(below or 1)
    found: list[Any] = []
    for name, *parts in entry["nodes"]:
        values = [found[part] for part in parts if isinstance(part, int)]
        if name == "number":
            found.append(number(parts[0], names))
        elif name == "symbol":
            found.append(names[parts[0]])
        elif name == "add":
            found.append(mpmath.fsum(values))
        elif name == "mul":
            found.append(mpmath.fprod(values))
        elif name == "div":
            found.append(values[0] / values[1])
        elif name == "neg":
            found.append(-values[0])
        elif name == "pow":
            found.append(values[0] ** number(parts[1], names))
        else:
            raise LookupError(f"no entry of a model is made by {name}")
    return found[entry["outputs"]["value"]]


def matrix(rows: Any, names: Mapping[str, Any]) -> Any:
    return mpmath.matrix([[number(entry, names) for entry in row] for row in rows])


def steady_state(model: Mapping[str, Any], index: Any, names: Mapping[str, Any]) -> dict[str, Any]:
    """Predicted and updated covariance, and filter gain."""
    moving, seen = matrix(model["transition"], names), matrix(model["measurement"], names)
    noise = index**2 * matrix(model["process_noise"], names)
    spread = matrix(model["measurement_noise"], names)
    one = mpmath.eye(moving.rows)
    # of X = A' X (1 + G X)^-1 A + Q with A = F'
    a, g, x = moving.T, seen.T * spread**-1 * seen, noise
    for _ in range(100):
        inner = (one + g * x) ** -1
        a, g, x, before = a * inner * a, g + a * inner * g * a.T, x + a.T * x * inner * a, x
        if mpmath.mnorm(x - before, 1) <= mpmath.mnorm(x, 1) * mpmath.mpf(10) ** (10 - DIGITS):
            break
    gain = x * seen.T * (seen * x * seen.T + spread) ** -1
    return {"predicted": x, "updated": (one - gain * seen) * x, "gain": gain}


def entries(claim: Mapping[str, Any], found: Mapping[str, Any]) -> dict[str, Any]:
    """The entries of a steady state by the names that the claim gives them."""
    return {
        name: x for kind in KINDS for name, x in zip(flat(claim[kind]), found[kind], strict=True)
    }


def flat(rows: Any) -> list[str]:
    """The names of a matrix, or of a column, row by row."""
    return [name for row in rows for name in ([row] if isinstance(row, str) else row)]


def claim_of(held: Mapping[str, Any]) -> dict[str, Any] | None:
    """What a certificate says the steady state is; None where there is no model."""
    for each in held["statements"]:
        if (each["kind"], each["tower"]) == ("riccati", "main"):
            found: dict[str, Any] = each["claim"]
            return found
    return None


def symbol(graph: Mapping[str, Any]) -> str:
    """The quantity that a graph names, if it is nothing else."""
    name, *parts = graph["nodes"][graph["outputs"]["value"]]
    return str(parts[0]) if name == "symbol" else ""


def ordinary(at: Sequence[float]) -> bool:
    return all(1 / ORDINARY <= abs(x) <= ORDINARY for x in at)


def compared() -> list[tuple[str, str, dict[str, str]]]:
    """Module, kernel, and which of its outputs are named entries of a steady state."""
    found = []
    for module, kernels in VALUES.items():
        held = certificate(module)
        riccati = claim_of(held)
        if riccati is None:
            continue
        entries_named = {name for kind in KINDS for name in flat(riccati[kind])}
        for statement in held["statements"]:
            if (statement["kind"], statement["tower"]) != ("program", "main"):
                continue
            kernel, outputs = statement["claim"]["program"], statement["claim"]["outputs"]
            named = {output: symbol(graph) for output, graph in outputs.items()}
            named = {o: name for o, name in named.items() if name in entries_named}
            meant = held["programs"][kernel]["inputs"].values()
            known = kernel in kernels and all(isinstance(each, str) for each in meant)
            if named and known and riccati["index"] in meant:
                found.append((module, kernel, named))
    return found


@pytest.mark.parametrize(("module", "kernel", "named"), compared())
def test_steady_states_solve_the_riccati_equation(
    module: str, kernel: str, named: dict[str, str]
) -> None:
    held, described = certificate(module), VALUES[module][kernel]
    claim, meant = claim_of(held), held["programs"][kernel]["inputs"]
    assert claim is not None
    form = FORMATS[0]
    points = [p["at"] for p in described["points"][form] if ordinary(p["at"])]
    assert points
    for at in points:
        with mpmath.workdps(DIGITS):
            inputs = zip((each["name"] for each in described["inputs"]), at, strict=True)
            names = {meant[name]: mpmath.mpf(x) for name, x in inputs}
            exact = entries(claim, steady_state(claim["model"], names[claim["index"]], names))
            came = function(module, kernel)(*map(np.dtype(form).type, at))
            for output, value in zip(described["outputs"], came, strict=True):
                if output["name"] not in named:
                    continue
                true = exact[named[output["name"]]]
                error = abs(mpmath.mpf(float(value)) - true) / abs(true)
                bound = number(output[form]["bound"], {}) * float(np.finfo(form).eps)
                assert error <= bound + mpmath.mpf(10) ** -20, (output["name"], at)
