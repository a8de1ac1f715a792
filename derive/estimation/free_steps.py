"""Steps on measurements with an unknown of their own: they tell nothing of what is shared."""

from __future__ import annotations

from gainproof.derive.derivation import Step
from gainproof.derive.estimation.free_setting import (
    ALONE,
    COURSE,
    ESTIMATOR,
    FREE,
    HEARD,
    M_HEARD,
    OWN,
    POSITIVE,
    SEEN,
    SHARED,
    SOLVABLE,
    UNIT_K,
    V_HEARD,
    C,
    V,
)
from gainproof.derive.estimation.spoken import known_inverse, meanings, together
from gainproof.derive.words.expression import ZERO, Expression
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)

WHOLE, ROWS = Expression("unit", "k"), Expression("unit", "m")


def _facts() -> list[Statement]:
    """V^-1 and M^-1 are; V_h > 0 has an inverse."""
    noise = prove_invertible("free-noise-regular", Search(FREE, [POSITIVE]), "noise", POSITIVE)
    regular = prove_invertible(
        "free-regular", Search(FREE, [SOLVABLE]), "information_with_own", SOLVABLE
    )
    heard = prove_order(
        "heard-noise-definite",
        Search(FREE, [POSITIVE]),
        V_HEARD,
        ZERO,
        [Square(HEARD, POSITIVE, left_inverse=HEARD.T)],
        strict=True,
    )
    return [
        noise,
        regular,
        heard,
        prove_invertible("heard-noise-regular", Search(FREE, using=[heard]), "heard_noise", heard),
    ]


def _weights(facts: list[Statement]) -> list[Statement]:
    """The weights of both kinds of rows."""
    noise, regular, _, heard = facts
    unheard = prove_equal(
        "alone-unheard",
        Search(
            FREE,
            aside=[regular],
            taken=[(COURSE.T, ("inverse", regular.id, "left"), OWN)],
        ),
        ESTIMATOR @ ALONE,
        ZERO,
    )
    between = prove_equal(
        "heard-between",
        Search(
            FREE,
            [],
            [noise],
            heavy=("heard_rows",),
            aside=[unheard],
            taken=[(-WHOLE, unheard, ALONE.T @ V @ HEARD)],
        ),
        ESTIMATOR @ HEARD @ V_HEARD,
        C @ SEEN.T,
    )
    weights = prove_equal(
        "heard-weights",
        Search(
            FREE,
            aside=[between, heard],
            taken=[
                (WHOLE, between, V_HEARD.inverse),
                (
                    -ESTIMATOR @ HEARD,
                    ("inverse", heard.id, "right"),
                    Expression("unit", "r"),
                ),
            ],
        ),
        ESTIMATOR @ HEARD,
        C @ SEEN.T @ V_HEARD.inverse,
    )
    return [unheard, between, weights]


def _covariance(facts: list[Statement], found: list[Statement]) -> list[Statement]:
    """C M_h = I, so that C^-1 = M_h; and the estimator is that of the heard rows."""
    regular, (unheard, _, weights) = facts[1], found
    product = prove_equal(
        "heard-product",
        Search(
            FREE,
            aside=[regular, unheard, weights],
            heavy=("alone_rows",),
            taken=[
                (-WHOLE, weights, SEEN),
                (COURSE.T, ("inverse", regular.id, "left"), COURSE),
                (-WHOLE, unheard, ALONE.T @ SHARED),
            ],
        ),
        C @ M_HEARD,
        UNIT_K,
    )
    inverse = known_inverse("heard-covariance", M_HEARD, C, product)
    same = M_HEARD.inverse @ SEEN.T @ V_HEARD.inverse
    whole = prove_equal(
        "heard-alone",
        Search(
            FREE,
            aside=[unheard, weights, inverse[-1]],
            taken=[
                (-(ESTIMATOR - same @ HEARD.T), ("blocks", "m"), ROWS),
                (WHOLE, unheard, ALONE.T),
                (WHOLE, weights, HEARD.T),
                (-WHOLE, inverse[-1], SEEN.T @ V_HEARD.inverse @ HEARD.T),
            ],
        ),
        ESTIMATOR,
        same @ HEARD.T,
    )
    return [product, *inverse, whole]


def free_steps() -> list[Step]:
    """Rows with an unknown of their own may be left out: estimate and covariance are the same."""
    facts = _facts()
    found = _weights(facts)
    last = _covariance(facts, found)

    return [
        facts[0].step(
            "The same in general: of any measurements let some, `E_f`, each have an unknown of its "
            "own, `A = A_x S_x' + E_f S_f'`. What is shared, as position and velocity, is "
            "estimated by the others, `E_h`, alone, with the part `V_h` of the noise, and with the "
            "same covariance. So the detection of biases is Doppler alone; and with fewer biases "
            "the estimate is that of the clean ranges and the Doppler, the other ranges left out, "
            "whatever the noise of these is correlated with.",
            "The column of an own unknown is that of its row, so the weight of the row vanishes; "
            "`K V = S_x' M^-1 A'` gives those of the others.",
        ),
        *meanings(
            FREE,
            "design_with_own information_with_own shared_estimator shared_covariance heard_design "
            "heard_noise heard_information",
        ),
        *together([*facts[1:], *found, *last]),
    ]
