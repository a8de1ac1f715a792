"""The three entries of the updated covariance that no gain shows, from the Riccati equation.

M = F X F' + q Q0 and X = M - S K K', where the first row of X is K' and that of M is S K'.
"""

from __future__ import annotations

from itertools import combinations

import sympy as sp

from gainproof.derive.any_three_state.model_numbers import Shape
from gainproof.derive.any_three_state.names import AREA, DEVIATION, GAINS, INDEX, symmetric
from gainproof.derive.expression import real
from gainproof.derive.model import ModelError

HIDDEN = ("22", "23", "33")


def hidden_entries(shape: Shape) -> dict[str, sp.Expr]:
    """Updated entries 22, 23, 33 over the gains, the first row of M and the index.

    Raises ModelError where no three equations have a determinant of known sign.
    """
    unknown = [real(f"updated_{place}") for place in HIDDEN]
    matrix = shape.model.transition
    first = {real(f"updated_1{k}"): gain for k, gain in enumerate(GAINS, 1)}
    updated = symmetric("updated").subs(first)
    moved = matrix * updated * matrix.T + AREA * shape.model.process_noise
    equations = []
    for i in range(3):
        for j in range(i, 3):
            known = real(f"predicted_1{j + 1}")
            if i:
                known = updated[i, j] + GAINS[i] * GAINS[j] * DEVIATION**2
            equations.append(sp.expand(moved[i, j] - known))
    for chosen in sorted(combinations(range(6), 3), key=lambda places: -sum(places)):
        rows = sp.Matrix([[equations[k].coeff(entry) for entry in unknown] for k in chosen])
        below = sp.factor(rows.det())
        if below == 0 or not _has_sign(shape, below):
            continue
        rest = sp.Matrix([sp.expand(equations[k].subs(dict.fromkeys(unknown, 0))) for k in chosen])
        solved = (-rows.adjugate() * rest / below).applyfunc(_collected)
        return dict(zip(HIDDEN, solved, strict=True))
    raise ModelError(
        f"model {shape.model.name}: no three equations of sure sign give the covariances that no "
        "gain shows"
    )


def _has_sign(shape: Shape, expression: sp.Expr) -> bool:
    try:
        return shape.sign(expression) != 0
    except ModelError:
        return False


def _collected(value: sp.Expr) -> sp.Expr:
    """A sum of products of the named quantities, their numbers in factors."""
    names = [*GAINS, DEVIATION, INDEX, *(real(f"predicted_1{k}") for k in (1, 2, 3))]
    whole = sp.Poly(sp.expand(value), *names)
    return sp.Add(
        *(
            sp.factor(number) * sp.Mul(*(n**e for n, e in zip(names, powers, strict=True)))
            for powers, number in whole.terms()
        )
    )
