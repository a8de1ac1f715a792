"""Steps on the covariance of the estimated biases: property 15, (122)-(127), (138)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.location_bias_facts import (
    bias_covariance,
    course_covariance,
    rest_inverse,
)
from gainproof.derive.estimation.location_facts import Found
from gainproof.derive.estimation.location_setting import (
    A_L,
    BIAS_C,
    DOPPLER_M,
    FULL_C,
    LOCATION,
    POSITION,
    ROW,
    V_L,
    V_LD,
)
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.words.expression import ZERO, Expression
from gainproof.derive.words.hypotheses import equation
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import prove_equal

UNIT, COURSE = Expression("unit", "n"), Expression("unit", "k")
UNCORRELATED = equation(V_LD, ZERO)


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
