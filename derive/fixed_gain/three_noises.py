"""What the process noises of three states add to covariances of filters with any gains."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.fixed_gain import three_noise_forms as forms
from gainproof.derive.fixed_gain.loop import pairs, row, symmetric
from gainproof.derive.fixed_gain.three_noise_forms import ONE, After, Place
from gainproof.derive.fixed_gain.three_noise_kernels import NOISES, kernel_of
from gainproof.derive.fixed_gain.three_towers import LOOP, D, M, X, gain_elements
from gainproof.derive.pages.kernel_formulas import SCALE
from gainproof.derive.printer.graph import Graph

TOWER = "noise"
Y = (D + M) / X
HERE = Place(ONE, X, Y, D, M, 1 + Y, 1 + X + Y, 1 + X + Y + D)
ALPHA = 2 * (1 + Y) / HERE.n
THERE = After(X - 1, (1 - ALPHA) * HERE.n, sp.Integer(1))


def noise_tower() -> Tower:
    """Every stable filter, with what each noise adds before the update."""
    added = {
        f"{name}_{ij}": value
        for name, noise in NOISES.items()
        for ij, value in forms.predicted(noise, HERE).items()
    }
    gains = {**gain_elements(X, Y, D), "share": (D + X) / (D + X + M)}
    return Tower(TOWER, above_zero("x", "d", "m"), (), {**gains, **added})


def noise_variances() -> sp.ImmutableDenseMatrix:
    """What each noise of ratio 1 adds to the variance of the predicted position."""
    return row(*(forms.predicted(noise, HERE)["11"] for noise in NOISES.values()))


def noise_meanings(kernel: str, graph: Graph) -> dict[str, sp.Expr]:
    """What kernels' outputs stand for: entries of the setting, and (I - K H) D (I - K H)'."""
    name = next(each for each in NOISES if kernel.startswith(kernel_of(each)))
    before = symmetric(name, 3)
    after = LOOP.rest * before * LOOP.rest.T
    places = {ij: (int(ij[0]) - 1, int(ij[1]) - 1) for ij in pairs(3)}
    known = {f"predicted_{ij}": before[place] for ij, place in places.items()}
    known |= {f"updated_{ij}": after[place] for ij, place in places.items()}
    for ij, (plus, minus) in forms.updated(NOISES[name], HERE, THERE).items():
        if minus is not None:
            known[f"updated_{ij}{SCALE}"] = plus + minus
    return {output: known[output] for output in graph["outputs"]}
