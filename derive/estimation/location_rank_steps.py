"""Steps on the rank of B: what the detection of biases takes of the Doppler."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.location_facts import Found
from gainproof.derive.estimation.location_setting import (
    BENT,
    DOPPLER,
    DOPPLER_GRAM,
    FULL,
    FULL_B,
    GRAM,
    LOCATION,
    N_FULL,
    RANGE,
    A,
    B,
)
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.relation import cited
from gainproof.derive.source import MATRICES
from gainproof.derive.words.expression import ZERO
from gainproof.derive.words.hypotheses import definite
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)


def doppler_gram(_: Found) -> list[Statement]:
    """B' B > 0 under A' A > 0, and its inverse."""
    positive = prove_order(
        "doppler-gram-definite",
        Search(LOCATION, [FULL]),
        DOPPLER_GRAM,
        ZERO,
        [Square(BENT, FULL, left_inverse=N_FULL)],
        strict=True,
    )
    regular = prove_invertible(
        "doppler-gram-regular", Search(LOCATION, using=[positive]), "doppler_gram", positive
    )
    return [positive, regular]


def rank_steps(found: Found) -> list[Step]:
    given = definite("doppler_gram")
    return [
        prove_equal("bent-columns", Search(LOCATION), A @ BENT, DOPPLER @ B).step(
            "(68) is a statement on the Doppler alone: `A' A > 0` if and only if `B' B > 0` for "
            "the `n` by `2 d` matrix `B` of (123). The columns of `W` are "
            "position and velocity with the biases that undo them in every range: they leave the "
            "Doppler.",
            "`A' A` is the sum of the squares of `E_l' A` and of `B N_a`; `[W, S_b]` is "
            "invertible.",
        ),
        *meanings(LOCATION, "B bent doppler_gram"),
        *together(
            [
                found.of(doppler_gram)[0],
                prove_order(
                    "gram-from-doppler",
                    Search(LOCATION, [given]),
                    GRAM,
                    ZERO,
                    [
                        Square(RANGE.T @ A, ("unit", "n"), left_inverse=FULL_B),
                        Square(N_FULL, given, left_inverse=BENT),
                    ],
                    strict=True,
                ),
            ]
        ),
        Step(
            "station-count",
            "So the detection of biases, and Doppler alone, take at least as many stations as "
            "there are unknowns of the course, 6 in space and 4 in a plane, however many ranges. "
            "With `n_b` clean ranges the rows that count are these and the Doppler, since those "
            "with a bias of their own may be left out (below): `n + n_b` of them, at least "
            "`2 d`. That many need not do.",
            cited(
                "A matrix with fewer rows than columns takes some column other than 0 to 0.",
                MATRICES.text(),
            ),
            "`B' B > 0` needs independent columns of `B`, and `B` has `n` rows.",
            LOCATION.name,
        ),
    ]
