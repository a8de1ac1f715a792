"""The covariances with all biases, of position and velocity and of the biases: (122)-(127)."""

from __future__ import annotations

from gainproof.derive.estimation.location_facts import Found, noise_blocks, weight
from gainproof.derive.estimation.location_noise_steps import (
    cross,
    doppler_information,
    given_doppler,
    rest,
)
from gainproof.derive.estimation.location_setting import (
    BIAS_C,
    DOPPLER_M,
    FULL_B,
    FULL_C,
    FULL_M,
    G11,
    GIVEN_DOPPLER,
    K11,
    LOCATION,
    N_FULL,
    REST,
    UNIT_K,
    L,
    P,
)
from gainproof.derive.estimation.location_solvable_steps import full_information
from gainproof.derive.estimation.spoken import known_inverse
from gainproof.derive.words.expression import Expression
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Statement, prove_equal

UNIT, COURSE = Expression("unit", "n"), Expression("unit", "k")


def rest_inverse(found: Found) -> list[Statement]:
    """K11 - P' G11^-1 P has the inverse of B' V_d^-1 B."""
    information, same = found.of(doppler_information), found.of(rest)[3]
    product = prove_equal(
        "rest-product",
        Search(
            LOCATION,
            aside=[same, information.regular],
            taken=[
                (DOPPLER_M.inverse, same, COURSE),
                (COURSE, ("inverse", information.regular.id, "left"), COURSE),
            ],
        ),
        DOPPLER_M.inverse @ REST,
        UNIT_K,
    )
    return [product, *known_inverse("rest-inverse", REST, DOPPLER_M.inverse, product)]


def course_covariance(found: Found) -> list[Statement]:
    """The covariance of position and velocity with all biases is (B' V_d^-1 B)^-1."""
    full, information, same = (
        found.of(full_information),
        found.of(doppler_information),
        found.of(rest)[3],
    )
    g11 = found.of(noise_blocks)["G11"]
    inverse = ("inverse", full.regular.id, "right")
    product = prove_equal(
        "course-covariance-product",
        Search(
            LOCATION,
            [],
            [*found.of(weight)[1:2], *g11.equations],
            aside=[full.regular, same],
            taken=[
                (N_FULL - P.T @ G11.inverse @ FULL_B.T, inverse, N_FULL.T),
                (-COURSE, same, FULL_C),
            ],
        ),
        DOPPLER_M @ FULL_C,
        UNIT_K,
    )
    value = prove_equal(
        "course-covariance",
        Search(
            LOCATION,
            aside=[product, information.regular],
            taken=[
                (DOPPLER_M.inverse, product, COURSE),
                (-COURSE, ("inverse", information.regular.id, "left"), FULL_C),
            ],
        ),
        FULL_C,
        DOPPLER_M.inverse,
    )
    return [product, value]


def bias_covariance(found: Found) -> list[Statement]:
    """(126), (127), (122)."""
    made, full = found.of(weight), found.of(full_information)
    blocks = found.of(noise_blocks)
    g11, inverse = blocks["G11"], found.of(rest_inverse)
    in_blocks = (
        N_FULL.T @ K11 @ N_FULL + N_FULL.T @ P.T @ FULL_B.T + FULL_B @ P @ N_FULL
    ) + FULL_B @ G11 @ FULL_B.T
    split = prove_equal(
        "full-information-blocks", Search(LOCATION, [], made[1:2]), FULL_M, in_blocks
    )
    share = G11.inverse @ P @ REST.inverse
    long = prove_equal(
        "bias-covariance-blocks",
        Search(
            LOCATION,
            [],
            [*made[1:2], *g11.equations],
            aside=[full.regular, inverse[1]],
            taken=[
                (
                    G11.inverse @ FULL_B.T + share @ (P.T @ G11.inverse @ FULL_B.T - N_FULL),
                    ("inverse", full.regular.id, "right"),
                    FULL_B,
                ),
                (
                    G11.inverse @ P,
                    ("inverse", inverse[1].id, "left"),
                    N_FULL @ FULL_M.inverse @ FULL_B,
                ),
            ],
        ),
        BIAS_C,
        G11.inverse + share @ P.T @ G11.inverse,
    )
    back = found.of(given_doppler)[-1]
    short = prove_equal(
        "bias-covariance",
        Search(
            LOCATION,
            [],
            [
                *made[1:2],
                *g11.equations,
                *blocks["doppler"].equations,
                found.of(cross)[1],
                inverse[2],
            ],
            aside=[long, back],
            taken=[(UNIT, long, UNIT), (UNIT, back, UNIT)],
        ),
        BIAS_C,
        GIVEN_DOPPLER + L.T @ DOPPLER_M.inverse @ L,
    )
    return [split, long, short]
