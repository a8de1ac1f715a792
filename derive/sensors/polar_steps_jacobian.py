"""Steps on the derivatives of the map and of its inverse."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.derivation import Step, joined
from gainproof.derive.relation import equal, positive
from gainproof.derive.sensors.polar_names import (
    COS_B,
    COS_E,
    INVERSE,
    JACOBIAN,
    PLACES,
    POLAR,
    SIN_B,
    SIN_E,
    H,
    R,
    X,
    Y,
    Z,
    by_angles,
)
from gainproof.derive.sensors.polar_towers import DIRECTION

Matrix = sp.ImmutableDenseMatrix


def jacobian() -> sp.ImmutableDenseMatrix:
    """The named derivatives of the place; z does not depend on the bearing."""
    return _named(JACOBIAN, PLACES, POLAR, ("z", "bearing"))


def inverse_jacobian() -> sp.ImmutableDenseMatrix:
    """The named derivatives of the polar coordinates; the bearing does not depend on z."""
    return _named(INVERSE, POLAR, PLACES, ("bearing", "z"))


def _named(
    names: dict[tuple[str, str], sp.Symbol],
    rows: tuple[str, ...],
    columns: tuple[str, ...],
    without: tuple[str, str],
) -> sp.ImmutableDenseMatrix:
    return Matrix(
        [[sp.Integer(0) if (a, b) == without else names[a, b] for b in columns] for a in rows]
    )


def frame() -> sp.ImmutableDenseMatrix:
    """The unit vectors u_R, u_E, u_B as columns."""
    across = (COS_B, -SIN_B, sp.Integer(0))
    return Matrix.hstack(*(Matrix(3, 1, each) for each in (*_sight(), across)))


def _sight() -> tuple[tuple[sp.Expr, ...], tuple[sp.Expr, ...]]:
    return DIRECTION.along, DIRECTION.upwards


def jacobian_steps() -> list[Step]:
    """Derivatives of the place, and what they say of the map."""
    slopes = Matrix([[sp.Derivative(each, R), *by_angles(each)] for each in (X, Y, Z)])
    j, u = jacobian(), frame()
    columns = sp.diag(1, R, H).as_immutable()
    return [
        Step(
            "jacobian",
            "The derivatives of the place by range, elevation and bearing, in this order, are "
            "called `J`.",
            equal(j, slopes),
            "Differentiate step @map; by an angle as in steps @elevation-slopes and "
            "@bearing-slopes. `z` does not depend on the bearing.",
            heading="Derivatives",
        ),
        Step(
            "jacobian-entries",
            "Written out:",
            equal(
                j,
                Matrix(
                    [
                        [COS_E * SIN_B, -R * SIN_E * SIN_B, R * COS_E * COS_B],
                        [COS_E * COS_B, -R * SIN_E * COS_B, -R * COS_E * SIN_B],
                        [SIN_E, R * COS_E, sp.Integer(0)],
                    ]
                ),
            ),
            "Each entry is a product: nothing is subtracted.",
        ),
        Step(
            "frame",
            "The columns are unit vectors `u_R`, `u_E`, `u_B`, the directions in which range, "
            "elevation and bearing grow, times 1, `R` and `h`.",
            equal(j, sp.MatMul(u, columns, evaluate=False)),
            "Compare with step @jacobian-entries.",
        ),
        Step(
            "orthonormal",
            "These are perpendicular to each other and of length 1.",
            equal(sp.MatMul(u.T, u, evaluate=False), sp.eye(3).as_immutable()),
            "Steps @elevation-circle and @bearing-circle.",
        ),
        joined("orthonormal-rows", equal(sp.MatMul(u, u.T, evaluate=False), sp.eye(3))),
        joined(
            "perpendicular",
            equal(sp.MatMul(j.T, j, evaluate=False), sp.diag(1, R**2, H**2).as_immutable()),
        ),
        Step(
            "determinant",
            "The determinant of `J` is `R^2 c_E`: above zero, so that range, elevation and "
            "bearing, in this order, are a right-handed system (with bearing before elevation it "
            "would be below zero).",
            equal(_determinant(j), R**2 * COS_E),
            "Expand along the last row of step @jacobian-entries.",
        ),
        joined("determinant-positive", positive(R**2 * COS_E)),
    ]


def inverse_steps() -> list[Step]:
    """Derivatives of the polar coordinates."""
    j, i = jacobian(), inverse_jacobian()
    one = sp.eye(3).as_immutable()
    return [
        Step(
            "inverse-jacobian",
            "The derivatives of range, elevation and bearing by the place are called `G`.",
            equal(
                i,
                Matrix(
                    [
                        [X / R, Y / R, Z / R],
                        [-X * Z / (H * R**2), -Y * Z / (H * R**2), H / R**2],
                        [Y / H**2, -X / H**2, sp.Integer(0)],
                    ]
                ),
            ),
            "By step @orthonormal they are the columns of step @frame, divided by 1, `R` and `h` "
            "instead of multiplied. They grow without limit near the vertical axis.",
        ),
        Step(
            "inverses",
            "The two matrices are inverses of each other.",
            equal(sp.MatMul(i, j, evaluate=False), one),
            "Multiply out; so the second holds the derivatives of the inverse map (chain rule).",
        ),
        joined("inverses-too", equal(sp.MatMul(j, i, evaluate=False), one)),
        Step(
            "frame-turns",
            "How the directions turn with the elevation:",
            equal(_turned(0), _columns("upwards", "-along", "nothing")),
            "Steps @elevation-slopes and @bearing-slopes.",
        ),
        Step(
            "frame-turns-too",
            "And with the bearing:",
            equal(_turned(1), _columns("across E", "-across E", "inwards")),
            "`u_R` turns towards `u_B` by `c_E`, `u_E` away from it by `s_E`; `u_B` turns "
            "towards the vertical axis.",
        ),
    ]


def _determinant(m: sp.ImmutableDenseMatrix) -> sp.Expr:
    """By the rule of Sarrus, unevaluated: nothing is simplified."""
    return sp.Add(
        *(
            sp.Mul(sign, m[0, a], m[1, b], m[2, c])
            for sign, (a, b, c) in (
                (1, (0, 1, 2)),
                (1, (1, 2, 0)),
                (1, (2, 0, 1)),
                (-1, (2, 1, 0)),
                (-1, (1, 0, 2)),
                (-1, (0, 2, 1)),
            )
        )
    )


def _turned(which: int) -> sp.ImmutableDenseMatrix:
    """The derivatives of the frame's columns by the elevation or the bearing."""
    return frame().applyfunc(lambda entry: by_angles(entry)[which])


def _columns(first: str, second: str, third: str) -> sp.ImmutableDenseMatrix:
    u = frame()
    known = {
        "upwards": u[:, 1],
        "-along": -u[:, 0],
        "nothing": sp.zeros(3, 1),
        "across E": COS_E * u[:, 2],
        "-across E": -SIN_E * u[:, 2],
        "inwards": sp.ImmutableDenseMatrix(3, 1, (-SIN_B, -COS_B, sp.Integer(0))),
    }
    return Matrix.hstack(*(Matrix(known[name]) for name in (first, second, third)))
