"""Steps on gains that share their eigenvectors, where the scalar solution is the matrix one."""

from __future__ import annotations

from gainproof.derive.algebra.tower import Parameter, Tower
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.fixed_gain.interacting_setting import (
    COORDINATE,
    K1,
    K2,
    NAME,
    ROOT,
    SETTING,
    SHIFTED,
    SQUARE_ROOT,
    T,
)
from gainproof.derive.fixed_gain.interacting_steps_filter import meaning
from gainproof.derive.relation import cited, equal, positive
from gainproof.derive.source import MATRICES
from gainproof.derive.words.expression import ZERO, Expression, unit
from gainproof.derive.words.hypotheses import Hypothesis, equation, semidefinite
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    prove_equal,
    prove_invertible,
    prove_order,
)

AXIS, EXAMPLE = "axis", "example"
A, R = real("alpha"), real("root")
LEAST = R * (4 - R) / (2 - R) ** 2
MARGIN = 4 - 2 * A - R**2


def tower() -> Tower:
    """Every stable alpha-beta filter with beta = r^2: 0 < r < 2, 0 < alpha < 2 - r^2/2."""
    x, y = real("x"), real("y")
    root = 2 * y / (1 + y)
    alpha = 2 * (1 + 2 * y) / (1 + y) ** 2 * x / (1 + x)
    return Tower(AXIS, (Parameter("x"), Parameter("y")), (), {"root": root, "alpha": alpha})


def sharing_steps() -> list[Step]:
    """The explicit gain for commuting symmetric matrices: each direction is at its best."""
    row = COORDINATE.T
    square = equation(SQUARE_ROOT @ SQUARE_ROOT, T * K2)
    direction = equation(row @ SQUARE_ROOT, ROOT * row)
    chosen = equation(K1, SQUARE_ROOT - SQUARE_ROOT @ SQUARE_ROOT / 2)
    variance = (2 * A**2 + 2 * R**2 + A * R**2) / (A * MARGIN)
    return [
        Step(
            "common-eigenvectors",
            "If `K2` and `B` are symmetric and commute, there is an explicit answer among the "
            "`K1` that have their eigenvectors. In each of these, by step @axis-position, the "
            "filter is an alpha-beta filter with the noise `u' B u`, and `W11` has the same "
            "eigenvectors.",
            cited(
                "Symmetric matrices that commute have an orthonormal basis of common eigenvectors.",
                MATRICES.text(),
            ),
            "So the order of matrices is that of the variances along each of them.",
            NAME,
            heading="Gains that share their eigenvectors",
        ),
        prove_equal(
            "sharing-gain",
            Search(SETTING, [direction, chosen], heavy=("K1",)),
            row @ K1,
            (ROOT - ROOT**2 / 2) * row,
        ).step(
            "Let `T K2` be positive definite with eigenvalues below 4, and `Gamma` its positive "
            "definite square root, with the eigenvalue `r` where `T K2` has `beta = r^2`. The "
            "gain `K1 = Gamma - Gamma^2/2` has `alpha = r - r^2/2`:",
            "Insert.",
        ),
        prove_equal(
            "sharing-velocity",
            Search(SETTING, [square, direction], heavy=("K2",)),
            T * (row @ K2),
            ROOT**2 * row,
        ).step("", joins=True),
        Step(
            "sharing-least",
            "And that is the best `alpha` for this `beta`: in units of `u' B u` any other stable "
            "one has a larger variance of the predicted position. So among the gains that share "
            "the eigenvectors, `K1 = Gamma - Gamma^2/2` makes `W11` least in the order of "
            "matrices, whatever `B` is (NP-P). The minimum variance filter of the lecture is "
            "this, for `d = 1`.",
            equal(
                variance - LEAST,
                2 * (2 * A + R**2 - 2 * R) ** 2 / (A * (2 - R) ** 2 * MARGIN),
                free=("alpha", "root"),
            ),
            "Common denominator; the stable filters are `0 < r < 2`, `alpha > 0`, `4 - 2 alpha - "
            "r^2 > 0`, and `alpha = r - r^2/2` is one of them.",
            EXAMPLE,
        ),
        joined("sharing-margin", positive(MARGIN), AXIS),
        joined("sharing-chosen", positive(R - R**2 / 2), AXIS),
        joined("sharing-chosen-margin", positive(4 - 2 * (R - R**2 / 2) - R**2), AXIS),
        *_smoothing(row, direction),
    ]


def _smoothing(row: Expression, direction: Hypothesis) -> list[Step]:
    """The same for the updated position."""
    root = semidefinite("square_root")
    whole = unit("d")
    positive = prove_order(
        "shifted-definite",
        Search(SETTING, [root]),
        SHIFTED,
        ZERO,
        [Square(whole, ("unit", "d"), left_inverse=whole), Square(whole, root)],
        strict=True,
    )
    inverse = prove_invertible(
        "shifted-inverse", Search(SETTING, [root], [positive]), "shifted", positive
    )
    made = SQUARE_ROOT + SQUARE_ROOT @ SQUARE_ROOT / 2
    number = ROOT + ROOT**2 / 2
    best = R * (2 + R) / (2 * (1 + R))
    variance = (2 * A**2 + 2 * R**2 - 3 * A * R**2) / (A * MARGIN)
    return [
        positive.step(
            "For the updated position (NP-S) let the eigenvalues of `T K2` be below 2, and `Sigma "
            "= I + Gamma`. The gain `K1 = (Gamma + Gamma^2/2) Sigma^-1` has `alpha = r (2 + r)/(2 "
            "(1 + r))`:",
            "Insert, and multiply by `Sigma`.",
        ),
        meaning("shifted"),
        inverse.step("", joins=True),
        prove_equal(
            "smoothing-gain",
            Search(
                SETTING,
                [direction, equation(K1, made @ SHIFTED.inverse)],
                heavy=("K1",),
                aside=[inverse],
                taken=[(number * row, ("inverse", "shifted-inverse", "right"), whole)],
            ),
            (1 + ROOT) * (row @ K1),
            number * row,
        ).step("", joins=True),
        Step(
            "smoothing-least",
            "And that is the best `alpha` for this `beta`: by step @axis-updated any other stable "
            "one has a larger variance of the updated position. So this gain makes the covariance "
            "of the updated position least in the order of matrices, among those that share the "
            "eigenvectors and whatever `B` is.",
            equal(
                variance - R * (4 + 3 * R) / (2 + R) ** 2,
                2 * (2 * A * (1 + R) - R * (2 + R)) ** 2 / (A * (2 + R) ** 2 * MARGIN),
                free=("alpha", "root"),
            ),
            "Common denominator. The last line is the margin `4 - 2 alpha - r^2` of the chosen "
            "one: it is stable for `r^2 < 2` only. At `r^2 = 2` no `alpha` is best, above it "
            "another root of the same equation is.",
            EXAMPLE,
        ),
        joined(
            "smoothing-margin",
            equal(4 - 2 * best - R**2, (2 - R**2) * (2 + R) / (1 + R), free=("root",)),
            EXAMPLE,
        ),
    ]
