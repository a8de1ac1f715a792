"""Steps on the covariances, and on the forms that kernels compute."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.derive.any_two_state import covariance_forms, forms
from gainproof.derive.any_two_state.context import Context
from gainproof.derive.any_two_state.names import (
    ALPHA,
    BETA,
    DEVIATION,
    PREDICTED,
    UPDATED,
    row,
)
from gainproof.derive.any_two_state.signed import Signed
from gainproof.derive.derivation import Step, joined
from gainproof.derive.expression import real
from gainproof.derive.relation import equal


def covariance_steps(c: Context) -> list[Step]:
    """Both covariances over the gains."""
    m11, m12, m22 = map(real, PREDICTED)
    x11, x12, x22 = map(real, UPDATED)
    square = DEVIATION**2
    return [
        Step(
            "covariances",
            "The covariance of the predicted state's error is `M`, that of the updated state's "
            "error `X`. Their first rows hold the gains. The last entry of `M` follows from that "
            "of `X`, which step @stable-updated-22 gives.",
            equal(
                row(m11, m12, x11, x12, m22),
                row(square - 1, BETA * square, ALPHA, BETA, x22 + BETA**2 * square),
            ),
            "`K = M H'/(H M H' + R)`, where `H M H' + R = sigma^2`, gives the first column of `M`, "
            "and `X = (I - K H) M`.",
            heading="The covariances",
        ),
        *_form_steps(c),
    ]


def _form_steps(c: Context) -> list[Step]:
    """The forms without a subtraction, or with both parts of one that is left."""
    found: Mapping[str, Signed] = {
        **forms.gains(c.basis),
        **covariance_forms.predicted_covariance(c.basis),
        "updated_22": covariance_forms.updated_22(c.basis),
    }
    left = sorted(name for name, value in found.items() if value.cancels)
    text = (
        "No two computed numbers are subtracted, so no digit cancels in a computer."
        if not left
        else "Where a subtraction is left, both parts are positive: "
        + ", ".join(f"`{_written(name)}`" for name in left)
        + "."
    )
    (first, relation), *others = (
        (f"stable-{name.replace('_', '-')}", equal(real(name), value.value))
        for name, value in found.items()
    )
    return [
        Step(
            first,
            f"Gains and covariances in forms for a computer. {text}",
            relation,
            "Let `f_i` be the coefficients of step @open-loop. Step @roots gives `d_i^2 - f_i^2`, "
            "and `d_i - f_i` is that over a sum. The second gain comes from the spectrum at "
            "`z = F22`, where the second state's own motion cancels.",
        ),
        *(joined(name, entry) for name, entry in others),
    ]


def _written(name: str) -> str:
    kind, _, place = name.partition("_")
    return {"predicted": "M", "updated": "X"}[kind] + place if place else kind
