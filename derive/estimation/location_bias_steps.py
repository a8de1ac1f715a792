"""Steps on the covariance of the estimated biases: property 15, (122)-(127), (138)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.location_facts import Found, noise_blocks, weight
from gainproof.derive.estimation.location_noise_steps import (
    cross,
    doppler_information,
    given_doppler,
    rest,
)
from gainproof.derive.estimation.location_setting import (
    A_L,
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
    POSITION,
    REST,
    ROW,
    UNIT_K,
    V_L,
    V_LD,
    L,
    P,
)
from gainproof.derive.estimation.location_solvable_steps import full_information
from gainproof.derive.estimation.spoken import known_inverse, meanings, together
from gainproof.derive.words.expression import ZERO, Expression
from gainproof.derive.words.hypotheses import equation
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Statement, prove_equal

UNIT, COURSE = Expression("unit", "n"), Expression("unit", "k")
UNCORRELATED = equation(V_LD, ZERO)


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


def bias_steps(found: Found) -> list[Step]:
    """What the biases are known by: the noise of the range, and how well the course is known."""
    inverse, course, biases = (
        found.of(rest_inverse),
        found.of(course_covariance),
        found.of(bias_covariance),
    )
    short = biases[-1]
    position = A_L @ POSITION.T @ DOPPLER_M.inverse @ POSITION @ A_L.T
    uncorrelated = prove_equal(
        "bias-covariance-uncorrelated",
        Search(
            LOCATION,
            [UNCORRELATED],
            aside=[short],
            taken=[(UNIT, short, UNIT)],
        ),
        BIAS_C,
        V_L + position,
    )
    return [
        biases[0].step(
            "(126), (127) and with the above (122): the covariance of the biases is the noise of "
            "the ranges given the Doppler, and what is not known of the course.",
            "Multiply (126) by its inverse and eliminate; insert (133), (136) and (137).",
        ),
        *together([*inverse, *biases[1:]]),
        *meanings(LOCATION, "bias_covariance"),
        course[0].step(
            "The covariance of position and velocity is `(B' V_d^-1 B)^-1`, as the paper says "
            "below (138): that of the Doppler alone, also where the noises are correlated.",
            "(136) is its inverse.",
        ),
        *together(course[1:]),
        *meanings(LOCATION, "full_covariance"),
        uncorrelated.step(
            "(125) and (138): if range and Doppler are uncorrelated, the variance of a bias is "
            "that of its range and that of the range to the estimated position.",
            "`V_ld = 0` in (122); `e` is a column of the unit matrix.",
        ),
        *together(
            [
                prove_equal(
                    "bias-variance",
                    Search(
                        LOCATION,
                        aside=[uncorrelated, course[-1]],
                        taken=[
                            (ROW.T, uncorrelated, ROW),
                            (-ROW.T @ A_L @ POSITION.T, course[-1], POSITION @ A_L.T @ ROW),
                        ],
                    ),
                    ROW.T @ BIAS_C @ ROW,
                    ROW.T @ V_L @ ROW
                    + ROW.T @ A_L @ (POSITION.T @ FULL_C @ POSITION) @ A_L.T @ ROW,
                )
            ]
        ),
    ]
