"""Steps on the least covariance: Gauss and Markov, and what fewer unknowns do (property 14)."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.linear_facts import Facts
from gainproof.derive.estimation.linear_setting import (
    COVARIANCE,
    FEWER,
    FEWER_COVARIANCE,
    FEWER_M,
    FEWER_N,
    GAIN,
    LINEAR,
    OTHER,
    POSITIVE,
    SOLVABLE,
    A,
    M,
    N,
    U,
    V,
)
from gainproof.derive.estimation.solvable_steps import KEPT, fewer_information
from gainproof.derive.estimation.spoken import meanings, together
from gainproof.derive.words.expression import Expression
from gainproof.derive.words.hypotheses import equation
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_equal_by_definite,
    prove_order,
)

UNBIASED = equation(OTHER @ A, N)


def fewer_steps(known: Facts) -> list[Step]:
    """No unbiased linear estimate is better, so neither is one with more unknowns."""
    return [*_best(known), *_property(known)]


def _best(known: Facts) -> list[Step]:
    change = OTHER - N @ GAIN
    same = equation(OTHER @ V @ OTHER.T, COVARIANCE)
    given = [POSITIVE, SOLVABLE, UNBIASED]
    return [
        prove_order(
            "least-covariance",
            Search(LINEAR, given, known.equations),
            OTHER @ V @ OTHER.T,
            COVARIANCE,
            [Square(change.T, POSITIVE)],
        ).step(
            "No linear estimate `K_x z` of `N a` that is unbiased, `K_x A = N`, has a smaller "
            "covariance, and no other has the same (Gauss and Markov). A wider model can only "
            "gain: an estimate from ranges alone is one from ranges and Doppler, with zeros for "
            "the Doppler.",
            "The difference is the square of `(K_x - N K)'` around `V`.",
            heading="More measurements, fewer unknowns",
        ),
        *together(
            [
                prove_equal_by_definite(
                    "only-least",
                    Search(LINEAR, [*given, same], known.equations),
                    OTHER,
                    N @ GAIN,
                    POSITIVE,
                    "right",
                )
            ]
        ),
    ]


def _property(known: Facts) -> list[Step]:
    fewer = _fewer_facts(known)
    part = M.inverse - U @ FEWER_M.inverse @ U.T
    given = [POSITIVE, SOLVABLE, KEPT]
    same = equation(COVARIANCE, FEWER_COVARIANCE)
    response = FEWER_N @ FEWER_M.inverse @ FEWER.T @ V.inverse
    everything = [*known.equations, *fewer]
    return [
        prove_order(
            "fewer-whole",
            Search(LINEAR, given, [*everything, known.definite]),
            M.inverse,
            U @ FEWER_M.inverse @ U.T,
            [Square(part, known.definite)],
        ).step(
            "Property 14, (112), in general: with fewer unknowns the covariance of what is asked "
            "for is not larger, whatever the unknowns and the correlations: `C_U <= C`.",
            "`M^-1 - U M_U^-1 U'` is the square of itself around `M`.",
        ),
        *together(fewer[1:]),
        *together(
            [
                prove_order(
                    "fewer-unknowns",
                    Search(LINEAR, given, [*everything, known.definite]),
                    COVARIANCE,
                    FEWER_COVARIANCE,
                    [Square(part @ N.T, known.definite)],
                )
            ]
        ),
        *meanings(LINEAR, "fewer_chosen fewer_covariance"),
        prove_equal_by_definite(
            "fewer-equal",
            Search(LINEAR, [*given, same], everything),
            N @ GAIN,
            response,
            POSITIVE,
            "right",
        ).step(
            "Equality: the covariances are the same if and only if the estimates are, for every "
            "`z`; then the unknowns that were left out did no harm.",
            "Step @only-least: with more unknowns the estimate is unbiased for fewer. Back: the "
            "same estimator has the same covariance.",
        ),
        *together(_equal_back(known, fewer, response)),
    ]


def _equal_back(known: Facts, fewer: list[Statement], response: Expression) -> list[Statement]:
    """The covariances are the same if the estimators are."""
    unit, spread = Expression("unit", "k"), N @ GAIN @ V @ GAIN.T @ N.T
    other = response @ V @ response.T
    same = prove_equal("same-spread", Search(LINEAR, [equation(N @ GAIN, response)]), spread, other)
    own = prove_equal("own-spread", Search(LINEAR, [POSITIVE], known.equations), spread, COVARIANCE)
    short = prove_equal(
        "fewer-spread",
        Search(LINEAR, [POSITIVE], [*known.noise, *fewer]),
        other,
        FEWER_COVARIANCE,
    )
    taken = [(-unit, own, unit), (unit, same, unit), (unit, short, unit)]
    whole = Search(LINEAR, aside=[own, same, short], taken=taken)
    return [same, own, short, prove_equal("equal-back", whole, COVARIANCE, FEWER_COVARIANCE)]


def _fewer_facts(known: Facts) -> list[Statement]:
    """M_U^-1 is, and is symmetric."""
    regular = fewer_information(known)[-1]
    turned = prove_equal(
        "fewer-symmetric",
        Search(LINEAR, [POSITIVE], [known.noise_symmetric, regular], rounds=1),
        FEWER_M.inverse.T,
        FEWER_M.inverse,
    )
    return [regular, turned]
