"""The method beyond the families of the catalogue: another noise, and noises out of its reach."""

from __future__ import annotations

import pytest
import sympy as sp
from catalogue_subjects import subject
from one_of_each import cases

from gainproof.derive.families.kinematic_acceleration import position_velocity_acceleration_model
from gainproof.derive.model import Model, ModelError
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.quantity import METRE, SAMPLING_INTERVAL, SECOND, Quantity
from gainproof.derive.steady_state.spectrum import V
from gainproof.derive.three_state.context import context
from gainproof.derive.three_state.kernels import KERNELS
from gainproof.derive.three_state.spectrum import factorise
from gainproof.derive.three_state.three_state import derive_three_state
from gainproof.verify.certificate import check

STRENGTH = Quantity("strength", r"\sigma_w", "size of the noise", METRE / SECOND**2)


def model(*column: sp.Rational) -> Model:
    """Noise of rank one through (position T^2, velocity T, acceleration)."""
    step = SAMPLING_INTERVAL.symbol
    entries = [entry * step ** (2 - n) for n, entry in enumerate(column)]
    shape = sp.ImmutableDenseMatrix([[entry] for entry in entries])
    noise = sp.ImmutableDenseMatrix(STRENGTH.symbol**2 * shape * shape.T)
    return position_velocity_acceleration_model("fifth", "Fifth", noise, STRENGTH)


@pytest.mark.parametrize(
    "column",
    [
        (sp.Rational(1, 4), sp.Rational(3, 4)),
        # xi/2 - Q23 is the quotient of two sums of positive terms, one of them a quotient itself
        (sp.Rational(2, 5), sp.Rational(9, 10)),
    ],
)
def test_a_fifth_noise_needs_its_process_noise_only(column: tuple[sp.Rational, ...]) -> None:
    fifth = derive_three_state(model(*column, sp.Integer(1)), ())
    report = check(
        fifth.certificate(),
        claims=fifth.claims(),
        model=fifth.model_data,
        domain=fifth.domains(),
    )
    assert report.accepted, report.reason
    assert len(report.statements) > 120
    assert set(KERNELS) <= {kernel.name for kernel in fifth.module.kernels}
    for bounds in prove_all(fifth.module.kernels):
        assert all(0 < output.bound < 100 for form in bounds for output in form.outputs)


def test_numbers_of_the_spectrum_come_out_of_the_model() -> None:
    found = context(model(sp.Rational(1, 6), sp.Rational(1, 2), sp.Integer(1))).spectrum
    assert (found.m1, found.m2) == (sp.Rational(2, 3), sp.Rational(1, 9))
    assert (found.a1, found.a2, found.e) == (
        sp.Rational(5, 3),
        sp.Rational(7, 9),
        sp.Rational(1, 9),
    )


@pytest.mark.parametrize(
    ("name", "noise"),
    cases(
        [
            ("acceleration-increments", (4 - V) / 4),
            ("wiener-acceleration", (4 - V) / 4),
            ("random-jerk", (6 - V) ** 2 / 36),
            ("continuous-white-jerk", (V**2 - 30 * V + 120) / 120),
        ],
        lambda case: case[0] in ("wiener-acceleration", "random-jerk"),
    ),
)
def test_noise_polynomial_is_that_of_the_literature(name: str, noise: sp.Expr) -> None:
    found = subject(name).model
    assert found is not None
    assert sp.expand(factorise(found).noise - noise) == 0


def test_a_noise_with_a_negative_coefficient_is_refused() -> None:
    # its spectrum dips between the ends of the unit circle
    with pytest.raises(ModelError, match="no negative coefficient is wanted; it is"):
        context(model(sp.Integer(1), sp.Rational(1, 2), sp.Integer(1)))


def test_a_noise_whose_updated_velocity_bends_no_more_is_refused_by_name() -> None:
    # a double zero at z = -1: eta tends to 0 for a large index
    with pytest.raises(ModelError, match="no double zero at z = -1"):
        derive_three_state(model(sp.Rational(1, 4), sp.Rational(1, 2), sp.Integer(1)), ())


def test_another_transition_is_refused() -> None:
    kinematic = model(sp.Integer(0), sp.Integer(0), sp.Integer(1))
    step = SAMPLING_INTERVAL.symbol
    slow = sp.ImmutableDenseMatrix(
        [[1, step, step**2 / 2], [0, 1, step], [0, 0, sp.Rational(1, 2)]]
    )
    changed = Model(**{**vars(kinematic), "transition": slow})
    with pytest.raises(ModelError):
        context(changed)
