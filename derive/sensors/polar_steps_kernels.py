"""Steps on what the kernels compute, in space and in the plane, over towers of their own.

There a quantity is defined anew, by its meaning: derivatives are those of the place, covariances
are J D J', and on a straight uniform course the place's second derivatives vanish.
"""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import column, real
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation, equal
from gainproof.derive.sensors.polar_motion import POLAR, Coordinate, acceleration, by, rate, second
from gainproof.derive.sensors.polar_names import (
    COS_B,
    COS_E,
    KEPT_B,
    LOSS_B,
    OF_BEARING,
    SIGMA_B,
    SIGMA_R,
    SIN_B,
    SIN_E,
    VELOCITY,
    A,
    G,
    H,
    K,
    R,
    X,
    Y,
    Z,
)
from gainproof.derive.sensors.polar_steps_map import BELOW
from gainproof.derive.sensors.polar_towers import LEFT, RIGHT
from gainproof.derive.sensors.polar_words import PLANE

Matrix = sp.ImmutableDenseMatrix
Symbols = tuple[sp.Symbol, ...]
ZERO = sp.Integer(0)


def definition_steps() -> list[Step]:
    """What the names mean in the towers of courses and of the plane."""
    circle = equal(
        column(COS_B, SIN_B),
        column(
            (4 * G * K - (1 - G**2) * (1 - K**2)) / BELOW,
            -(2 * G * (1 - K**2) + 2 * K * (1 - G**2)) / BELOW,
        ),
    )
    elevation = equal(column(COS_E, SIN_E), column(2 * A / (1 + A**2), (A**2 - 1) / (1 + A**2)))
    place = equal(
        column(X, Y, Z, H), column(R * COS_E * SIN_B, R * COS_E * COS_B, R * SIN_E, R * COS_E)
    )
    return [
        quiet("course-bearing", circle, "course"),
        quiet("course-elevation", elevation, "course"),
        quiet("course-place", place, "course"),
        quiet("course-velocity", _sides("xyz"), "course"),
        *_rates("course", POLAR, (X, Y, Z)),
        quiet("plane-bearing", circle, "plane"),
        quiet("plane-place", equal(column(X, Y), column(R * SIN_B, R * COS_B)), "plane"),
        quiet("plane-velocity", _sides("xy"), "plane"),
        *_rates("plane", (POLAR[0], POLAR[2]), (X, Y)),
        *_uniform("plane", (POLAR[0], POLAR[2]), (X, Y)),
        *_plane_noise(),
    ]


def quiet(name: str, relation: Relation, tower: str) -> Step:
    """What names mean, not shown."""
    return Step(name, "What the names mean.", relation, "As before.", tower=tower, shown=False)


def _sides(places: str) -> Relation:
    """A velocity is the difference of two numbers from 0 on: any number."""
    return equal(
        column(*(VELOCITY[place] for place in places)),
        column(*(real(RIGHT[place]) - real(LEFT[place]) for place in places)),
    )


def _rates(tower: str, polar: tuple[Coordinate, ...], places: Symbols) -> list[Step]:
    """The rates give the velocity: chain rule."""
    named = column(*(VELOCITY[str(place)] for place in places))
    found = column(*(sp.Add(*(by(p, each) * rate(each) for each in polar)) for p in places))
    return [quiet(f"{tower}-rates", equal(found, named), tower)]


def _uniform(tower: str, polar: tuple[Coordinate, ...], places: Symbols) -> list[Step]:
    """With the second rates there is no acceleration: chain rule, twice."""
    return [
        quiet(
            f"{tower}-uniform-{place}",
            equal(acceleration(place, polar, {each[0]: second(each) for each in polar}), ZERO),
            tower,
        )
        for place in places
    ]


def _plane_noise() -> list[Step]:
    """Covariance and means in the plane."""
    slopes = Matrix([[sp.Derivative(p, R), sp.Derivative(p, G) * OF_BEARING] for p in (X, Y)])
    p = {name: real(f"covariance_{name}") for name in ("xx", "xy", "yy")}
    first_order = sp.MatMul(
        slopes,
        sp.diag(SIGMA_R**2, SIGMA_B**2).as_immutable(),
        slopes.T.as_immutable(),
        evaluate=False,
    )
    means = [real(f"{which}_{place}") for which in ("mean", "bias") for place in "xy"]
    return [
        quiet(
            "plane-covariance",
            equal(Matrix([[p["xx"], p["xy"]], [p["xy"], p["yy"]]]), first_order),
            "plane",
        ),
        quiet("plane-kept", equal(KEPT_B, 1 / (1 + LOSS_B)), "plane"),
        quiet(
            "plane-mean",
            equal(column(*means), column(KEPT_B * X, KEPT_B * Y, KEPT_B * X - X, KEPT_B * Y - Y)),
            "plane",
        ),
    ]


def kernel_steps(graphs: dict[str, Graph]) -> list[Step]:
    """Each kernel computes what it says; `graphs` are without calls."""
    return [_kernel(name, graph) for name, graph in graphs.items()]


def tower_of(kernel: str) -> str:
    """The tower in which a kernel's outputs are claimed."""
    if kernel.endswith(PLANE):
        return "plane"
    return "course" if kernel == "straight_course_rates" else "main"


def _kernel(name: str, graph: Graph) -> Step:
    roots = {"horizontal_distance": real("horizontal_distance"), "slant_range": R}
    return Step(
        f"kernel-{name.replace('_', '-')}",
        f"The kernel {name} computes what it says.",
        Relation(
            "program",
            {"program": name, "outputs": {each: _meant(name, each) for each in graph["outputs"]}},
        ),
        "Evaluate the kernel's graph; the value of a sine, cosine or exponential stands as the "
        "quantity that it is, and what an exponential or an atan2 is taken of is claimed too.",
        tower=tower_of(name),
        hint={"graph": graph, "roots": roots},
        shown=False,
    )


def _meant(kernel: str, output: str) -> sp.Expr:
    """The quantity of the tower that an output stands for."""
    if output in SIDES:
        return SIDES[output]
    if output.endswith("_of"):
        noises = ("bearing",) if kernel.endswith(PLANE) else ("elevation", "bearing")
        noises = ("elevation",) if "upwards" in output else noises
        return -sp.Add(*(real(f"{noise}_deviation") ** 2 for noise in noises)) / 2
    place, _, by = output.partition("_D_")
    if by and kernel.endswith(PLANE):
        return _plane_slope(place, by)
    return real(output)


SIDES = {
    "elevation_opposite": R * SIN_E,
    "elevation_adjacent": R * COS_E,
    "bearing_opposite": X,
    "bearing_adjacent": Y,
}
"""Opposite and adjacent sides of the angles; x : y as sin B : cos B by the steps on the place."""


def _plane_slope(value: str, by: str) -> sp.Expr:
    """A derivative in the plane: of the place directly; of the polar coordinates from it."""
    if value in ("x", "y"):
        slopes = {"slant_range": sp.Derivative(real(value), R)}
        slopes["bearing"] = sp.Derivative(real(value), G) * OF_BEARING
        return slopes[by]
    # the inverse of [[sin B, R cos B], [cos B, -R sin B]]
    inverse = {
        ("slant_range", "x"): SIN_B,
        ("slant_range", "y"): COS_B,
        ("bearing", "x"): COS_B / R,
        ("bearing", "y"): -SIN_B / R,
    }
    return inverse[value, by]
