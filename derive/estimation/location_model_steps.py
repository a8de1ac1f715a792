"""Steps on the linear model of range and Doppler in blocks: (11), (26), (30)-(63)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.location_facts import Found, noise_blocks, weight
from gainproof.derive.estimation.location_setting import (
    A_CLEAN,
    A_KEPT,
    A_L,
    A_LD,
    BIASES,
    BOTH,
    DOPPLER,
    ERROR,
    KEPT,
    LOCATION,
    N_FULL,
    N_KEPT,
    PLACE,
    RANGE,
    SPEED,
    TO_BIASES,
    UNCLEAN,
    UNKNOWN,
    V_D,
    V_L,
    V_LD,
    A,
    H,
    V,
    Z,
)
from gainproof.derive.estimation.spoken import meanings, said, together
from gainproof.derive.words.expression import Expression
from gainproof.derive.words.hypotheses import Hypothesis, equation, symmetric
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Statement, prove_equal

SEEN = equation(Z, A @ UNKNOWN + ERROR)
CLEAN = equation(BIASES, H @ UNCLEAN)
NONE = equation(BIASES, Expression("number", "0"))


def equal(name: str, left: Expression, right: Expression, *given: Hypothesis) -> Statement:
    """An equation that the blocks give."""
    heavy = ("observed", "biases")
    return prove_equal(name, Search(LOCATION, given, heavy=heavy), left, right)


def model_steps(found: Found) -> list[Step]:
    """The observations, their noise, and what is taken out of the unknowns."""
    return [*_observations(), *_noise(found), *_parts(), *_fewer()]


def _observations() -> list[Step]:
    return [
        said(
            LOCATION,
            "stations",
            "Location from ranges and Doppler of `n` stations in `d` coordinates, three in space, "
            "each range with a bias of its own; linear about a start. The block letters `E_l`, "
            "`E_d` hold the columns of the unit matrix for ranges and for Doppler, `S` those of "
            "the unknowns of (33): position, velocity and biases; `T` those of position and "
            "velocity alone.",
            "A_l (13), A_ld (28): the derivatives of range by position, and of Doppler by "
            "position; a_l, a_d: corrections of position and velocity; a_b: the biases",
            "The model after the properties 1 to 3, which are those of range-doppler.",
            heading="Range and Doppler of n stations",
        ),
        equal(
            "range-model",
            RANGE.T @ Z,
            A_L @ PLACE + BIASES + RANGE.T @ ERROR,
            SEEN,
        ).step(
            "(30) to (34) say what (11) and (26) do: the ranges have the derivatives `A_l` and "
            "their biases, the Doppler has `A_ld` and, as the derivatives by the velocity, `A_l`.",
            "Rows of ranges and of Doppler.",
        ),
        *together(
            [
                equal(
                    "doppler-model",
                    DOPPLER.T @ Z,
                    A_LD @ PLACE + A_L @ SPEED + DOPPLER.T @ ERROR,
                    SEEN,
                )
            ]
        ),
        *meanings(LOCATION, "full_design unknown"),
    ]


def _noise(found: Found) -> list[Step]:
    made = found.of(weight)
    blocks = found.of(noise_blocks)
    split = (
        RANGE @ V_L @ RANGE.T
        + RANGE @ V_LD @ DOPPLER.T
        + DOPPLER @ V_LD.T @ RANGE.T
        + DOPPLER @ V_D @ DOPPLER.T
    )
    return [
        prove_equal("noise-blocks", Search(LOCATION, [symmetric("noise")]), V, split).step(
            "(36) to (39): the noise in blocks; `V > 0` makes `V_l` and `V_d` positive definite, "
            "whatever the correlation `V_ld`, and `V^-1` and its block `G11`, (96).",
            "`E_l E_l' + E_d E_d' = I` on both sides; a block on the diagonal is a square.",
        ),
        *meanings(LOCATION, "range_noise cross_noise doppler_noise G11"),
        *together([*made, *(s for entry in blocks.values() for s in entry.all)]),
    ]


def _parts() -> list[Step]:
    return [
        equal("course-part", N_FULL @ UNKNOWN, BOTH).step(
            "(43) to (46) and (49) to (51): position and velocity, and the biases, are parts of "
            "the unknowns, and (91), (92) of those of the method with fewer.",
            "`S_l' S_l = I`, `S_l' S_d = 0` and so on.",
        ),
        *together(
            [
                equal("bias-part", TO_BIASES @ UNKNOWN, BIASES),
                equal("kept-course-part", N_KEPT @ KEPT, BOTH),
                equal("course-rows", N_FULL @ N_FULL.T, Expression("symbol", "I_k")),
                equal("bias-rows", TO_BIASES @ TO_BIASES.T, Expression("symbol", "I_n")),
                equal("kept-rows", N_KEPT @ N_KEPT.T, Expression("symbol", "I_k")),
            ]
        ),
        *meanings(LOCATION, "course full_course bias_part kept_course kept_unknown"),
    ]


def _fewer() -> list[Step]:
    return [
        equal("fewer-biases", A @ UNKNOWN, A_KEPT @ KEPT, CLEAN).step(
            "(57) to (63): let the biases be `H a_bnb`, with `H` of (59) if the first `n_b` ranges "
            "are clean, or of ones if one bias is common to all. Then the model is the same with "
            "`A_nb`, (61); and with none it is that with `A_n`, (63).",
            "Insert.",
        ),
        *together([equal("no-biases", A @ UNKNOWN, A_CLEAN @ BOTH, NONE)]),
        *meanings(LOCATION, "kept_design clean_design"),
    ]
