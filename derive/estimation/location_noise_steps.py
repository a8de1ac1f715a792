"""Steps on the blocks of the inverse of the noise: (128)-(137)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.location_facts import Found, Known, known, noise_blocks, weight
from gainproof.derive.estimation.location_rank_steps import doppler_gram
from gainproof.derive.estimation.location_setting import (
    A_L,
    A_LD,
    DOPPLER_GRAM,
    DOPPLER_M,
    FULL,
    G11,
    G12,
    GIVEN_DOPPLER,
    LOCATION,
    POSITION,
    REST,
    UNIT_N,
    V_D,
    V_LD,
    VELOCITY,
    B,
    L,
    P,
    S,
)
from gainproof.derive.estimation.spoken import known_inverse, meanings, together
from gainproof.derive.words.expression import ZERO, Expression
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import Square, Statement, prove_equal, prove_order

UNIT = Expression("unit", "n")


def known_blocks(found: Found) -> list[Statement]:
    """The equations of V^-1, V_d^-1 and G11^-1."""
    made = found.of(weight)
    blocks = found.of(noise_blocks)
    return [*made[:2], *blocks["doppler"].equations, *blocks["G11"].equations]


def given_doppler(found: Found) -> list[Statement]:
    """(133): G11 is the inverse of what Doppler leaves of the noise of the ranges."""
    product = prove_equal(
        "range-weight-product",
        Search(LOCATION, [], found.of(known_blocks)),
        G11 @ GIVEN_DOPPLER,
        UNIT_N,
    )
    made = known_inverse("range-weight", GIVEN_DOPPLER, G11, product)
    g11 = found.of(noise_blocks)["G11"].regular
    back = prove_equal(
        "range-weight-inverse",
        Search(
            LOCATION,
            aside=[product, g11],
            taken=[
                (G11.inverse, product, -UNIT),
                (UNIT, ("inverse", g11.id, "left"), GIVEN_DOPPLER),
            ],
        ),
        G11.inverse,
        GIVEN_DOPPLER,
    )
    return [product, *made, back]


def cross(found: Found) -> list[Statement]:
    """(134), (135)."""
    blocks = found.of(known_blocks)
    corner = prove_equal(
        "cross-weight", Search(LOCATION, [], blocks), G12.T, -V_D.inverse @ V_LD.T @ G11
    )
    g11 = found.of(noise_blocks)["G11"].regular
    ratio = prove_equal(
        "cross-ratio",
        Search(
            LOCATION,
            [],
            blocks,
            taken=[(V_D.inverse @ V_LD.T, ("inverse", g11.id, "right"), -UNIT)],
        ),
        G12.T @ G11.inverse,
        -V_D.inverse @ V_LD.T,
    )
    return [corner, ratio]


def doppler_weight(found: Found) -> Statement:
    """(132)."""
    ratio = found.of(cross)[1]
    return prove_equal(
        "doppler-weight",
        Search(LOCATION, [], found.of(known_blocks), aside=[ratio], taken=[(-UNIT, ratio, G12)]),
        S,
        V_D.inverse,
    )


def rest(found: Found) -> list[Statement]:
    """(128), (137), (131), (136)."""
    turned = [*found.of(weight)[1:2], *found.of(noise_blocks)["G11"].equations]
    ratio, schur = found.of(cross)[1], found.of(doppler_weight)
    reduced = POSITION @ (A_L.T + A_LD.T @ G12.T @ G11.inverse) + (
        VELOCITY @ A_L.T @ G12.T @ G11.inverse
    )
    mixed = prove_equal("mixed", Search(LOCATION, [], turned), P.T @ G11.inverse, reduced)
    crossing = prove_equal(
        "crossing",
        Search(
            LOCATION,
            aside=[mixed, ratio],
            taken=[
                (Expression("unit", "k"), mixed, UNIT),
                (POSITION @ A_LD.T + VELOCITY @ A_L.T, ratio, UNIT),
            ],
        ),
        P.T @ G11.inverse,
        L,
    )
    squared = prove_equal("rest-square", Search(LOCATION, [], turned), REST, B.T @ S @ B)
    doppler = prove_equal(
        "rest-doppler",
        Search(
            LOCATION,
            aside=[squared, schur],
            taken=[(Expression("unit", "k"), squared, Expression("unit", "k")), (B.T, schur, B)],
        ),
        REST,
        DOPPLER_M,
    )
    return [mixed, crossing, squared, doppler]


def weight_of_doppler(found: Found) -> Statement:
    """V_d^-1 > 0."""
    inner = found.of(noise_blocks)["doppler"]
    return prove_order(
        "doppler-weight-definite",
        Search(LOCATION, [], inner.all),
        V_D.inverse,
        ZERO,
        [Square(V_D.inverse, inner.positive, left_inverse=V_D)],
        strict=True,
    )


def doppler_information(found: Found) -> Known:
    """B' V_d^-1 B > 0 under V > 0 and A' A > 0; its inverse."""
    inner, made, gram = (
        found.of(noise_blocks)["doppler"],
        found.of(weight_of_doppler),
        found.of(doppler_gram),
    )
    squares = [Square(B, made, left_inverse=DOPPLER_GRAM.inverse @ B.T)]
    search = Search(LOCATION, [FULL], [*inner.all, made, *gram])
    return known("doppler_information", squares, search, inner.equations)


def noise_steps(found: Found) -> list[Step]:
    """What the Doppler says of the noise of the ranges, and of position and velocity."""
    given, corner = found.of(given_doppler), found.of(cross)
    schur, left = found.of(doppler_weight), found.of(rest)
    information = found.of(doppler_information)
    return [
        given[0].step(
            "Property 15. First the blocks of `V^-1` by those of `V`, (132) to (135), from "
            "theorem 1: `G11` is the inverse of the noise of the ranges given that of the Doppler.",
            "`V V^-1 = I`, block by block.",
            heading="Covariance of the biases",
        ),
        *meanings(LOCATION, "range_given_doppler S"),
        *together([*given[1:], *corner, schur]),
        left[0].step(
            "(128) and (137), then (129), (131) and (136): what all biases leave of `K11` is the "
            "information `B' V_d^-1 B` of the Doppler.",
            "Multiply out; insert (135) and (132).",
        ),
        *meanings(LOCATION, "L rest doppler_information"),
        *together(
            [*left[1:], found.of(weight_of_doppler), found.of(doppler_gram)[1], *information.all]
        ),
    ]
