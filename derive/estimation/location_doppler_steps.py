"""Steps on ranges that add nothing, each with a free bias, and on Doppler beside clean ranges."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.location_bias_facts import course_covariance
from gainproof.derive.estimation.location_facts import Found, noise_blocks, weight
from gainproof.derive.estimation.location_setting import (
    A_CLEAN,
    A_L,
    CLEAN_M,
    DOPPLER,
    DOPPLER_M,
    ESTIMATOR,
    FULL_B,
    FULL_C,
    LOCATION,
    N_FULL,
    POSITION,
    POSITIVE,
    RANGE,
    RANGE_M,
    V_D,
    V_L,
    B,
    V,
)
from gainproof.derive.estimation.location_solvable_steps import full_information
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.words.expression import ZERO, Expression, symbol
from gainproof.derive.words.hypotheses import invertible
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)

COURSE = Expression("unit", "k")


def same_estimate(found: Found) -> list[Statement]:
    """The detection of biases estimates position and velocity as Doppler alone does."""
    made, full, covariance = (
        found.of(weight),
        found.of(full_information),
        found.of(course_covariance)[-1],
    )
    doppler = found.of(noise_blocks)["doppler"]
    unheard = prove_equal(
        "ranges-unheard",
        Search(
            LOCATION,
            aside=[full.regular],
            taken=[(N_FULL, ("inverse", full.regular.id, "left"), FULL_B)],
        ),
        ESTIMATOR @ RANGE,
        ZERO,
    )
    heard = prove_equal(
        "doppler-heard",
        Search(
            LOCATION,
            [],
            made[:2],
            heavy=("doppler_rows",),
            aside=[unheard],
            taken=[(-COURSE, unheard, RANGE.T @ V @ DOPPLER)],
        ),
        ESTIMATOR @ DOPPLER @ V_D,
        FULL_C @ B.T,
    )
    alone = DOPPLER_M.inverse @ B.T @ V_D.inverse
    weights = prove_equal(
        "doppler-weights",
        Search(
            LOCATION,
            aside=[heard, covariance, doppler.regular],
            taken=[
                (COURSE, heard, V_D.inverse),
                (COURSE, covariance, B.T @ V_D.inverse),
                (
                    -ESTIMATOR @ DOPPLER,
                    ("inverse", doppler.regular.id, "right"),
                    Expression("unit", "n"),
                ),
            ],
        ),
        ESTIMATOR @ DOPPLER,
        alone,
    )
    same = prove_equal(
        "doppler-alone",
        Search(
            LOCATION,
            aside=[unheard, weights],
            taken=[
                (-(ESTIMATOR - alone @ DOPPLER.T), ("blocks", "m"), Expression("unit", "m")),
                (COURSE, unheard, RANGE.T),
                (COURSE, weights, DOPPLER.T),
            ],
        ),
        ESTIMATOR,
        alone @ DOPPLER.T,
    )
    return [unheard, heard, weights, same]


def clean_order(found: Found) -> list[Statement]:
    """Position from clean ranges and Doppler is known no worse than from the ranges alone."""
    made = found.of(weight)
    ranges = found.of(noise_blocks)["range"]
    given = [POSITIVE, invertible("range_information"), invertible("clean_information")]
    regular = [
        prove_invertible(f"{name.replace('_', '-')}-given", Search(LOCATION, [known]), name, known)
        for name, known in (
            ("range_information", given[1]),
            ("clean_information", given[2]),
        )
    ]
    turned = [
        prove_equal(
            f"{name.replace('_', '-')}-turned",
            Search(LOCATION, [], [*by, base], rounds=1),
            symbol(name).inverse.T,
            symbol(name).inverse,
        )
        for name, base, by in (
            ("range_information", regular[0], ranges.equations),
            ("clean_information", regular[1], made[1:2]),
        )
    ]
    alone = RANGE_M.inverse @ A_L.T @ V_L.inverse @ RANGE.T
    both = POSITION.T @ CLEAN_M.inverse @ A_CLEAN.T @ V.inverse
    order = prove_order(
        "doppler-helps",
        Search(LOCATION, given, [*made[:2], *ranges.equations, *regular, *turned]),
        RANGE_M.inverse,
        POSITION.T @ CLEAN_M.inverse @ POSITION,
        [Square((alone - both).T, POSITIVE)],
    )
    return [*regular, *turned, order]


def doppler_steps(found: Found) -> list[Step]:
    """Ranges that each have a bias of their own tell nothing of the course."""
    same, order = found.of(same_estimate), found.of(clean_order)
    return [
        same[0].step(
            "The detection of biases and Doppler alone give the same position and velocity, for "
            "every `z` and also where the noises are correlated: a range with a free bias does not "
            "count. The estimator has zeros for the ranges, and its part for the Doppler is that "
            "of Doppler alone, the weight being `V_d^-1` and not the block `G22` of `V^-1`.",
            "The column of a bias is that of its range; `K V = N_a M_a^-1 A'`.",
            heading="What ranges and Doppler add",
        ),
        *meanings(LOCATION, "estimator"),
        *together(same[1:]),
        order[0].step(
            "With clean ranges Doppler can only help: the covariance of the position from both is "
            "not above that from the ranges alone, correlated or not.",
            "The estimate from ranges is unbiased for both (step @least-covariance).",
        ),
        *meanings(LOCATION, "range_information"),
        *together(order[1:]),
    ]
