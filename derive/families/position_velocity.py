"""Position and velocity measured, acceleration noise acting all through each interval."""

from __future__ import annotations

import sympy as sp

from gainproof.derive.algebra.tower import Tower
from gainproof.derive.expression import real
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.source import RICCATI, SPECTRAL, SUZUKI
from gainproof.derive.subject import Subject
from gainproof.derive.vector_measurement.model import measured_model
from gainproof.derive.vector_measurement.names import CROSS, DELTA, INDEX, MEAN, RATIO, ROOT
from gainproof.derive.vector_measurement.position_velocity import Printed, derive_position_velocity

NAME = "position-velocity"
TITLE = "Position and velocity measured, continuous white acceleration"

STRENGTH = Quantity(
    "acceleration_deviation",
    r"\sigma_a",
    "standard deviation of the acceleration noise, averaged over one interval",
    METRE / SECOND**2,
)


def build() -> Subject:
    """Derive the family; noise of density sigma_a^2 T, integrated over one interval, is (7)."""
    step, density = SAMPLING_INTERVAL.symbol, STRENGTH.symbol**2 * SAMPLING_INTERVAL.symbol
    time = sp.Symbol("time", real=True)
    response = sp.ImmutableDenseMatrix([[time], [1]])
    noise = (density * response * response.T).applyfunc(
        lambda entry: sp.integrate(entry, (time, 0, step))
    )
    model = measured_model(NAME, TITLE, sp.ImmutableDenseMatrix(noise), STRENGTH)
    printed = Printed(source_elements, source_slots, REMARKS)
    return derive_position_velocity(model, (SUZUKI.key, SPECTRAL.key, RICCATI.key), printed)


SYMBOLS = ("a", "x", "k", "b", "c", "q1", "q2", "p1", "p2", "p3", "root")
A, X, K, B, C, Q1, Q2, P1, P2, P3, RHO = (real(f"source_{name}") for name in SYMBOLS)
SQUARE = RATIO**2


def source_elements(tower: Tower) -> dict[str, sp.Expr]:
    """The source's symbols over the derived quantities, by name.

    K is what X^2 + S^2 h^2 turns out to be, B what Q1 = 2 K S^2 P12 asks for: the source leaves B
    undefined.
    """
    difference = DELTA * CROSS
    constant = INDEX**2 * K * (1 + SQUARE / 6)
    shape = _computed(tower, difference**2 + SQUARE * CROSS**2)
    needed = ((MEAN * CROSS * K * SQUARE - constant) / difference**2).subs(K, shape)
    return {
        "position_ratio": 4 / INDEX,
        "source_a": INDEX**2,
        "source_x": difference,
        "source_k": shape,
        "source_b": _computed(tower, needed),
        "source_c": constant,
        "source_q1": B * X**2 + SQUARE * K * X + C,
        "source_q2": B * X**2 - SQUARE * K * X + C,
        "source_p1": B**2,
        "source_p2": 2 * B * C - SQUARE * K**2 * (SQUARE - 4),
        "source_p3": C**2 - 4 * SQUARE * K**3,
        "source_root": P2 + 2 * P1 * X**2,
    }


def _computed(tower: Tower, expression: sp.Expr) -> sp.Expr:
    """An expression of the tower that is a polynomial in Lambda^2 and S, over the latter."""
    found = sp.factor(tower.expression(tower.fraction(expression)))
    return sp.factor(found.subs(ROOT, A ** sp.Rational(1, 4))).subs(A, INDEX**2)


def source_slots(tower: Tower) -> dict[str, object]:
    """What the page's steps on the source leave open: B as it depends on A and S."""
    return {
        "source": "yes",
        "b_in_a": sp.factor(tower.expressions["source_b"].subs(INDEX, sp.sqrt(A))),
    }


REMARKS = {
    "model": "These are the source's (1) to (8); it writes `Phi` for `F`, and its `sigma_a` is the "
    "standard deviation of an acceleration.",
    "index": "The source's `A` (14a) is `Lambda^2`.",
    "ratio": "This is the source's `S` (15).",
    "filter": "These are the source's (9) to (11), held still; its `P` with a tilde (12) is our "
    "`P`, its `P` with a hat (13) our `U`, with the indices 1, 2, 3 for 11, 12, 22.",
    "position": "`P11` in these units is the source's `G1`.",
    "gain": "The four entries are those of the source's (18).",
    "velocity-absent-innovation-ratio": "The limit of `P11` is the subject of the source's (20).",
    "velocity-known-updated-11": "The limit of `P11` is the subject of the source's (21).",
    "improvement": "The source draws it in figure 3.",
    "width-range": "The source draws `S1` in figure 2.",
}
"""What the source says at a step of the derivation, by the step's id."""
