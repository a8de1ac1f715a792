"""Steps on what the kernels in space compute: the formulas as papers and libraries print them."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from gainproof.derive.derivation import Step
from gainproof.derive.expression import column, real
from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation, equal
from gainproof.derive.sensors.converted_graphs import KERNELS
from gainproof.derive.sensors.converted_names import COS_A, KEPT, SIGMA_A, SIGMA_R, SIN_A, G, K, R
from gainproof.derive.sensors.converted_space_names import (
    BOTH,
    COS_E,
    KEPT_E,
    LA,
    LE,
    SIGMA_E,
    SIN_E,
    WHOLE,
    WIDER,
    A,
    squares,
)

PLACE = (R * COS_E * COS_A, R * COS_E * SIN_A, R * SIN_E)
PAIRS = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))
Matrix = sp.ImmutableDenseMatrix


def space_kernel_steps(graphs: Mapping[str, Graph]) -> list[Step]:
    """Each kernel computes what it says; `graphs` are without calls."""
    below = (1 + G**2) * (1 + K**2)
    angles = equal(
        column(COS_A, SIN_A, COS_E, SIN_E),
        column(
            (4 * G * K - (1 - G**2) * (1 - K**2)) / below,
            -(2 * G * (1 - K**2) + 2 * K * (1 - G**2)) / below,
            2 * A / (1 + A**2),
            (A**2 - 1) / (1 + A**2),
        ),
    )
    kept = equal(column(real("change_azimuth"), real("change_elevation")), column(LA - 1, LE - 1))
    return [
        _quiet("turned-angles", angles),
        _quiet("turned-kept", kept),
        *(_kernel(name, graphs[KERNELS[name]]) for name in KERNELS),
    ]


def _quiet(name: str, relation: Relation) -> Step:
    return Step(name, "What the names mean.", relation, "As before.", tower="turned", shown=False)


def moments(noises: int, square: sp.Expr) -> sp.Matrix:
    """Mean products of the places of what one or two noises have turned; `square` is the mean
    squared range. Each noise leaves of the azimuth `KEPT`, of its double the fourth power.
    """
    c, s, m = squares(LE ** (2 * noises))
    kept_a, one = LA ** (2 * noises), KEPT**noises
    twice = COS_A**2 - SIN_A**2
    return square * Matrix(
        [
            [c * (1 + kept_a * twice) / 2, c * kept_a * SIN_A * COS_A, one * m * COS_A],
            [c * kept_a * SIN_A * COS_A, c * (1 - kept_a * twice) / 2, one * m * SIN_A],
            [one * m * COS_A, one * m * SIN_A, s],
        ]
    )


def printed(name: str) -> tuple[tuple[sp.Expr, sp.Expr], sp.Matrix]:
    """The factors of a conversion, level and upwards, and its covariance."""
    place = Matrix([[each] for each in PLACE])
    given = moments(1, WHOLE)
    match name:
        case "classical":
            slopes = _jacobian()
            noise = sp.diag(SIGMA_R**2, SIGMA_E**2, SIGMA_A**2)
            return (sp.Integer(1), sp.Integer(1)), slopes * noise * slopes.T
        case "debiased":
            shrunk = sp.diag(BOTH, BOTH, KEPT_E)
            mean = moments(2, WIDER) - shrunk * given * shrunk
            return (1 + BOTH - BOTH**2, 1 + KEPT_E - LE), mean
        case "unbiased":
            grown, shrunk = sp.diag(1 / BOTH, 1 / BOTH, 1 / KEPT_E), sp.diag(BOTH, BOTH, KEPT_E)
            raw = place * place.T
            crossed = grown * raw * shrunk
            return (1 / BOTH, 1 / KEPT_E), grown * raw * grown - crossed - crossed.T + given
    shrunk = sp.diag(BOTH, BOTH, KEPT_E)
    return (BOTH, KEPT_E), given - shrunk * place * place.T * shrunk


def _jacobian() -> sp.Matrix:
    return Matrix(
        [
            [COS_E * COS_A, -R * SIN_E * COS_A, -R * COS_E * SIN_A],
            [COS_E * SIN_A, -R * SIN_E * SIN_A, R * COS_E * COS_A],
            [SIN_E, R * COS_E, 0],
        ]
    )


def _kernel(name: str, graph: Graph) -> Step:
    kernel = KERNELS[name]
    (level, upwards), covariance = printed(name)
    meant = {"x": level * PLACE[0], "y": level * PLACE[1], "z": upwards * PLACE[2]}
    meant |= {f"covariance_{'xyz'[i]}{'xyz'[j]}": covariance[i, j] for i, j in PAIRS}
    for angle, deviation in (("azimuth", SIGMA_A), ("elevation", SIGMA_E)):
        meant[f"kept_{angle}_of"] = -(deviation**2) / 2
        meant[f"change_{angle}_of"] = -(deviation**2)
    return Step(
        f"kernel-{kernel.replace('_', '-')}",
        f"The kernel {kernel} computes what it says.",
        Relation(
            "program",
            {"program": kernel, "outputs": {each: meant[each] for each in graph["outputs"]}},
        ),
        "The moments as papers print them, turned by the azimuth.",
        tower="turned",
        hint={"graph": graph},
        shown=False,
    )
