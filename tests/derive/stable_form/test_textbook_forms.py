"""Gains and covariances as textbooks print them: forms that are found, beside those by hand.

The textbook's forms subtract computed values; the kernels' forms were ordered by hand.
"""

from __future__ import annotations

import pytest
from catalogue_subjects import subject
from one_of_each import cases

from gainproof.derive.printer.bound import prove
from gainproof.derive.printer.formats import FLOAT64
from gainproof.derive.stable_form import stable
from gainproof.verify.certificate import check

FAMILIES = ("random-acceleration", "random-velocity")
OUTPUTS = (
    ("gains", "alpha"),
    ("gains", "beta"),
    ("predictor_gains", "position"),
    ("gain_derivatives", "alpha"),
    ("gain_derivatives", "beta"),
    ("predicted_covariance", "predicted_11"),
    ("predicted_covariance", "predicted_12"),
    ("predicted_covariance", "predicted_22"),
    ("updated_covariance", "updated_22"),
    ("index_from_alpha", "tracking_index"),
    ("index_from_beta", "tracking_index"),
    ("beta_from_alpha", "beta"),
    ("alpha_from_beta", "alpha"),
)
BY_HAND = 2.2  # times the bound of the kernel: no form that is found is worse


@pytest.mark.parametrize(
    ("family", "kernel", "output"),
    cases(
        [(family, *each) for family in FAMILIES for each in OUTPUTS],
        lambda case: case == ("random-acceleration", "index_from_beta", "tracking_index"),
    ),
)
def test_a_form_without_subtraction(family: str, kernel: str, output: str) -> None:
    """Proved equal to what the textbook prints, with a bound near that of the kernel."""
    made = subject(family)
    (own,) = [each for each in made.module.kernels if each.name == kernel]
    form = stable({output: made.textbook()[kernel][output]}, own.inputs)
    found, bound = form.bounds[output], {b.name: b for b in prove(own, FLOAT64).outputs}[output]
    assert not form.cancellations
    assert check(form.certificate, claims=form.claims).accepted
    assert found is not None
    assert found.bound <= BY_HAND * float(bound.bound)
    # derivatives come near the ends of the format on the way to values that do not
    assert found.lowest <= max(bound.lowest, 2.0**-500)
    assert found.highest >= min(bound.highest, 2.0**500) * (1 - 2.0**-40)
