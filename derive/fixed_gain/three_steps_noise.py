"""Steps on what the process noises of three states add to covariances of filters with any gains."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.algebra.variables import above_zero
from gainproof.derive.derivation import Step
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain import three_noise_forms as forms
from gainproof.derive.fixed_gain.loop import pairs, product, row, shift, symmetric, total
from gainproof.derive.fixed_gain.three_noise_forms import ONE, After, Place
from gainproof.derive.fixed_gain.three_noise_kernels import NOISES, kernel_of
from gainproof.derive.fixed_gain.three_towers import LOOP, D, M, X, gain_elements
from gainproof.derive.fixed_gain.two_kernels import SCALE
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import equal

TOWER = "noise"
Y = (D + M) / X
HERE = Place(ONE, X, Y, D, M, 1 + Y, 1 + X + Y, 1 + X + Y + D)
ALPHA = 2 * (1 + Y) / HERE.n
THERE = After(X - 1, (1 - ALPHA) * HERE.n, sp.Integer(1))
WORDS = {
    "acceleration": "an acceleration noise that acts all through the interval, by `(1/2, 1, 1)`",
    "jerk": "a jerk that is constant over each interval",
    "white_jerk": "a white jerk",
}


def noise_tower() -> Tower:
    """Every stable filter, with what each noise adds before the update."""
    added = {
        f"{name}_{ij}": value
        for name, noise in NOISES.items()
        for ij, value in forms.predicted(noise, HERE).items()
    }
    gains = {**gain_elements(X, Y, D), "share": (D + X) / (D + X + M)}
    return Tower(TOWER, above_zero("x", "d", "m"), (), {**gains, **added})


def covariance(name: str) -> sp.ImmutableDenseMatrix:
    """Q of noise ratio 1, from how the target answers to an impulse of its third derivative."""
    s = real("s")
    answer = shift(3, s) * sp.ImmutableDenseMatrix([0, 0, 1])
    if name == "acceleration":
        column = answer.subs(s, 1)
        return sp.ImmutableDenseMatrix(column * column.T)
    if name == "jerk":
        column = answer.applyfunc(lambda entry: sp.integrate(entry, (s, 0, 1)))
        return sp.ImmutableDenseMatrix(column * column.T)
    spread = (answer * answer.T).applyfunc(lambda entry: sp.integrate(entry, (s, 0, 1)))
    return sp.ImmutableDenseMatrix(spread)


def noise_steps() -> list[Step]:
    """The noises of the catalogue."""
    steps = []
    for name in NOISES:
        known = symmetric(name, 3)
        solved = total(product(LOOP.closed, known, LOOP.closed.T), covariance(name))
        steps.append(
            Step(
                f"noise-{name.replace('_', '-')}",
                "",
                equal(known, solved),
                "Insert; step @unique.",
                tower=TOWER,
                shown=False,
            )
        )
    shown = [forms.predicted(noise, HERE)["11"] for noise in NOISES.values()]
    first = Step(
        "noises",
        "Of noise ratio 1, "
        + ", ".join(WORDS.values())
        + " add to the variance of the predicted position",
        equal(row(*(real(f"{name}_11") for name in NOISES)), row(*shown)),
        "Solve step @superposition for each; no entry has a minus sign in the coordinates. "
        "Acceleration increments that act at the next sample differ in the variance of the "
        "acceleration alone, which has 1 more before the update and the same after it.",
        tower=TOWER,
    )
    increments = sp.diag(0, 0, 1).as_immutable()
    known = symmetric("acceleration", 3) + increments
    more = Step(
        "noise-increments",
        "",
        equal(known, total(product(LOOP.closed, known, LOOP.closed.T), increments)),
        "Insert.",
        tower=TOWER,
        shown=False,
    )
    return [first, *steps, more]


def noise_meanings(kernel: str, graph: Graph) -> dict[str, sp.Expr]:
    """What the outputs of a kernel stand for: the steps' entries, and (I - K H) D (I - K H)'."""
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
