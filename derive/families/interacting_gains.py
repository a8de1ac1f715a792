"""Filters with matrix gains: what is true for every number of coordinates.

The derivation is the page `interacting-gains` of `derive/pages`.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import sympy as sp

import gainproof.derive.fixed_gain
from gainproof.derive.derivation import Derivation
from gainproof.derive.pages.derivation import Given, written
from gainproof.derive.pages.kernel_page import page_graphs, page_module
from gainproof.derive.source import LECTURE, MATRICES
from gainproof.derive.subject import Program, Subject

NAME = "interacting-gains"
FORMULAS = Path(gainproof.derive.fixed_gain.__path__[0]) / "interacting_kernels.md"
MODEL = {
    "name": "two-coordinates",
    "title": "Two coordinates at constant velocity",
    "transition": [list(row) for row in ("1010", "0101", "0010", "0001")],
    "process_noise": [["0"] * 4] * 4,
    "measurement": [list(row) for row in ("1000", "0100")],
    "measurement_noise": [list(row) for row in ("10", "01")],
}
SLOTS = {
    name: sp.Add(larger, smaller, evaluate=False)
    for name, larger, smaller in (
        ("prediction_smaller", sp.Integer(3), sp.Rational(-133, 45)),
        ("update_smaller", sp.Rational(7, 9), sp.Rational(-10, 13)),
    )
}
"""Differences of two numbers, for the checker to subtract."""
HINTS: dict[str, dict[str, Any]] = {
    "steady-11": {"multiples": [("E1'", 2, "E1")]},
    "steady-21": {"multiples": [("E2'", 2, "E1")]},
    "steady-22": {"multiples": [("E2'", 2, "E2")]},
    "innovation-from-cross": {"multiples": [("K2^-1 E2'", 2, "E2 (K2^-1)'")]},
    "noise-floor": {"squares": [("F'", 2)]},
    "position-floor": {"taken": [("E1'", 1, "E1")], "squares": [("F' E1", 2)]},
    "updated-floor": {"squares": [("E1 (I - K1)'", 1)]},
    "next-definite": {"squares": [("F'", 1), ("K' Phi'", 2)]},
    "row-of-velocity": {"multiples": [("E2'", 1, "unit(1)")]},
    "position-lag": {"multiples": [("K2^-1 E2'", 1, "unit(1)")]},
    "velocity-lag": {
        "using": ["velocity-gain-inverse", "position-lag"],
        "multiples": [("E1'", 1, "unit(1)")],
    },
    "updated-position-lag": {"using": ["position-lag"]},
    "updated-velocity-lag": {"using": ["velocity-gain-inverse", "position-lag", "velocity-lag"]},
    "velocity-gain-invertible": {
        "multiples": [("E1'", ("inverse", "rest-inverse", "left"), "E1 + E2 (K1 + T K2)/T")],
        "left_inverse": "E1' G^-1 E2",
    },
    "axis-cross": {"numbers": ["u' W21 u"], "multiples": [("T (u' E2'/beta)", 2, "E2 u")]},
    "axis-velocity": {
        "using": ["axis-cross"],
        "numbers": ["u' W21 u"],
        "multiples": [("u' E2'", 2, "E1 u")],
    },
    "axis-position": {"using": ["axis-cross", "axis-velocity"], "taken": [("2 u' E1'", 2, "E1 u")]},
    "axis-updated": {"taken": [("(1 - alpha)^2", "axis-position", "unit(1)")]},
    "innovation-definite": {"squares": [("H'", 1), ("unit(m)", 2, {"left_inverse": "unit(m)"})]},
    "least-update": {"squares": [("(K - K_o)'", "innovation-definite")]},
    "only-best": {"definite": "innovation-definite", "side": "right"},
    "least-prediction": {"squares": [("Phi'", "least-update")]},
    "inverse-definite": {"squares": [("S^-1", "innovation-definite", {"left_inverse": "S"})]},
    "never-worse": {"squares": [("H P", "inverse-definite")]},
    "update-definite": {
        "squares": [("(I - K H)'", 1, {"left_inverse": "I"}), ("K'", 2, {"left_inverse": "H'"})]
    },
    "position-innovation-definite": {"squares": [("E1", 1), ("I", 2, {"left_inverse": "I"})]},
    "smoothed-least": {"squares": [("(K1 - P11 S^-1)'", "position-innovation-definite")]},
    "smoothed-only": {"definite": "position-innovation-definite", "side": "right"},
    "predicted-least": {"squares": [("(K1 - K_f)'", "position-innovation-definite")]},
    "predicted-only": {"definite": "position-innovation-definite", "side": "right"},
    "trace-change": {"used": [("-J", 5, "V - W"), ("Lambda", "steady-change", "J")]},
    "smoothed-weight": {"taken": [("-(E1 - T E2)'", 1, "E1 - T E2")]},
    "first-order": {"used": [("N D' E1'", 1, "J")]},
    "along-rows": {"heavy": ["Q"]},
    "only-velocities": {"taken": [("unit(1)", 1, "E2")]},
    "heard": {"using": ["only-velocities"]},
    "grown-prediction": {"taken": [("-E1'", 2, "E1")]},
    "grown-turns": {"taken": [("E2'", 2, "E2")]},
    "sharing-gain": {"heavy": ["K1"]},
    "sharing-velocity": {"heavy": ["K2"]},
    "shifted-definite": {"squares": [("I", ("unit", "d"), {"left_inverse": "I"}), ("I", 1)]},
    "smoothing-gain": {
        "heavy": ["K1"],
        "taken": [("(r + r^2/2) u'", ("inverse", "shifted-inverse", "right"), "I")],
    },
    "scaled-steady": {"taken": [("A2", 1, "A2'")]},
}
"""What proofs use besides their conditions: see `pages.matrices`."""


def build() -> Subject:
    """Derive filters with matrix gains."""
    made = page_graphs(FORMULAS)
    given = Given(
        models={"two_coordinates": MODEL},
        slots={"": SLOTS},
        hints=HINTS,
        programs=made,
    )
    page = written(NAME, given)
    return Subject(
        name=NAME,
        title=page.title,
        model=None,
        derivation=Derivation(page.opening, page.steps, (LECTURE.key, MATRICES.key), page.latex),
        towers=page.towers,
        programs={name: Program({"variance_ratio": "variance_ratio"}, made[name]) for name in made},
        module=page_module(FORMULAS, made, NAME, f"{page.title}: the gain of one coordinate"),
        textbook=dict,
        settings=page.settings,
    )
