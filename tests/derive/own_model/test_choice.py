"""Which method a model goes to."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import sympy as sp
from one_of_each import cases
from own_models import DEVIATION, SHAKE, T, free_number, own_model

from gainproof.derive.any_two_state import proved_module
from gainproof.derive.derivation import PageError
from gainproof.derive.expression import real
from gainproof.derive.families.random_acceleration import STRENGTH
from gainproof.derive.model import Model, ModelError
from gainproof.derive.own_model import choice
from gainproof.derive.own_model.choice import derive_own_model
from gainproof.derive.pages.derivation import FOLDER
from gainproof.derive.quantity import METRE
from gainproof.derive.subject import Subject
from gainproof.derive.three_state.three_state import PAGE, derive_three_state
from gainproof.derive.vector_measurement.model import measured_model

KINEMATIC = [[1, 1], [0, 1]]
HALF = sp.Rational(1, 2)
KINEMATIC_3 = [[1, 1, HALF], [0, 1, 1], [0, 0, 1]]
SQUARE = sp.Matrix([HALF / 2, HALF, 1])


def kernels(subject: Subject) -> set[str]:
    return {kernel.name for kernel in subject.module.kernels}


def both_measured(number: sp.Expr | int = 1) -> Model:
    """Acceleration constant over each half of an interval, position and velocity measured."""
    shape = sp.sympify(number) * sp.ImmutableDenseMatrix(
        [[5 * T**4 / 16, T**3 / 2], [T**3 / 2, T**2]]
    )
    noise = sp.ImmutableDenseMatrix(STRENGTH.symbol**2 * shape)
    return measured_model("both", "Both measured", noise, STRENGTH)


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bounds of kernels are not looked at here."""
    monkeypatch.setattr(proved_module, "prove", lambda _kernel, _form: None)


def test_kinematic_models_keep_poles_and_inverses() -> None:
    found = kernels(derive_own_model(own_model(KINEMATIC, [[HALF / 2, HALF], [HALF, 1]])))
    assert {"closed_loop_poles", "index_from_alpha", "gains"} <= found


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize(
    "model",
    [
        own_model(KINEMATIC, [[3, HALF], [HALF, 1]]),
        own_model([[1, 2], [0, 1]], [[0, 0], [0, 1]]),
        own_model(KINEMATIC, [[real("r"), 0], [0, 1]], parameters=(free_number("r"),)),
    ],
    ids=["much position noise", "two intervals", "a free ratio"],
)
def test_what_that_method_does_not_reach_goes_to_the_other(model: Model) -> None:
    found = kernels(derive_own_model(model))
    assert {"gains", "gain_second_derivatives"} <= found
    assert "index_from_alpha" not in found


@pytest.mark.parametrize(
    "noise",
    [
        pytest.param(sp.eye(3), id="poles that may turn twice"),
        pytest.param(sp.diag(1, 0, 1), id="a start that is not near", marks=pytest.mark.thorough),
        pytest.param(
            sp.Matrix([[HALF / 2, HALF, 0], [HALF, 1, 0], [0, 0, 1]]),
            id="no bend by its form",
            marks=pytest.mark.thorough,
        ),
    ],
)
def test_three_states_whose_narrow_method_fails_late_go_to_the_other(noise: sp.Matrix) -> None:
    subject = derive_own_model(own_model(KINEMATIC_3, noise.tolist()))
    assert kernels(subject) >= {"gains", "predicted_covariance", "gain_derivatives"}
    assert "pole_product" not in kernels(subject)
    assert subject.certificate()["statements"]


@pytest.mark.parametrize(
    ("right", "wrong", "said"),
    [
        ("    equation-xi: xi^2 = a1 + 2 eta\n", "    equation-xi: xi^2 = a1 + 2 eat\n", "'eat'"),
        ("{end_of_gamma} as", "{end_of_gama} as", "no slot 'end_of_gama'"),
    ],
)
def test_a_mistake_of_the_page_is_told_and_hides_behind_no_other_method(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, right: str, wrong: str, said: str
) -> None:
    text = (FOLDER / f"{PAGE}.md").read_text(encoding="utf-8")
    assert text.count(right) == 1
    for path in FOLDER.glob("*.md"):
        shutil.copy(path, tmp_path)
    (tmp_path / f"{PAGE}.md").write_text(text.replace(right, wrong), encoding="utf-8")
    monkeypatch.setattr(
        choice,
        "derive_three_state",
        lambda model, keys: derive_three_state(model, keys, folder=tmp_path),
    )
    third = sp.Rational(1, 6), HALF, sp.Integer(1)
    model = own_model([[1, 1, HALF], [0, 1, 1], [0, 0, 1]], [[a * b for a in third] for b in third])
    with pytest.raises(PageError, match=said) as caught:
        derive_own_model(model)
    line = text[: text.index(right)].count("\n") + 1
    assert f"/{PAGE}.md, line {line}: " in str(caught.value)


NUMBERS = [1, sp.Rational(1, 9), sp.Rational(1, 2), 7]
NOISES: list[tuple[list[list[Any]], list[list[Any]]]] = [
    (KINEMATIC, [[0, 0], [0, 1]]),
    (KINEMATIC, [[HALF / 2, HALF], [HALF, 1]]),
    (KINEMATIC, [[3, HALF], [HALF, 1]]),
    ([[1, 1], [0, HALF]], [[0, 0], [0, 1]]),
    (KINEMATIC_3, sp.diag(0, 0, 1).tolist()),
]


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize(
    ("number", "transition", "noise"),
    cases(
        [(number, *noise) for noise in NOISES for number in NUMBERS],
        lambda case: case[1:] == NOISES[0] or (case[0] == HALF and case[1] is not KINEMATIC_3),
    ),
)
def test_the_index_is_the_declared_strength_whatever_numbers_stand_behind_it(
    number: sp.Expr, transition: list[list[Any]], noise: list[list[Any]]
) -> None:
    written = sp.Matrix(noise) * number
    found = derive_own_model(own_model(transition, written.tolist())).model
    assert found is not None
    assert found.process_noise == written.as_immutable()
    assert found.noise_ratio == (SHAKE.symbol / DEVIATION) ** 2


@pytest.mark.parametrize("number", cases(NUMBERS[1:], lambda number: number == NUMBERS[1]))
def test_both_measured_behind_another_number_is_refused(number: sp.Expr) -> None:
    with pytest.raises(ModelError, match=f"Q22 = 1 behind the strength.*has Q22 = {number};"):
        derive_own_model(both_measured(number))


def test_both_measured() -> None:
    found = kernels(derive_own_model(both_measured()))
    assert "known_velocity" in found


@pytest.mark.parametrize(
    ("noise", "reason"),
    [
        ([[1, 1], [1, 1]], "they are 1 and 1"),
        ([[5, 1], [1, 1]], "they are 1 and 17"),
        ([[HALF, HALF], [HALF, 1]], r"it is \[\["),
    ],
)
def test_both_measured_with_other_noises_is_refused(noise: list[list[Any]], reason: str) -> None:
    """The last one lies on the border of what is in reach, where the method's numbers vanish."""
    (a, b), (_, c) = noise
    shape = sp.ImmutableDenseMatrix([[a * T**4, b * T**3], [b * T**3, c * T**2]])
    model = measured_model("both", "Both", STRENGTH.symbol**2 * shape, STRENGTH)
    with pytest.raises(
        ModelError, match=r"Q12 = Q22/2, Q11 from Q22/4 to below Q22/2, or.*" + reason
    ):
        derive_own_model(model)


def test_both_measured_and_not_kinematic_is_refused() -> None:
    fading = sp.ImmutableDenseMatrix([[1, T], [0, HALF]])
    with pytest.raises(ModelError, match="a position and its rate, both measured, are wanted"):
        derive_own_model(replace(both_measured(), transition=fading))


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize(
    ("transition", "noise", "options"),
    [
        ([[1, 1, HALF], [0, 1, 1], [0, 0, HALF]], sp.diag(0, 0, 1), {}),
        pytest.param(
            KINEMATIC_3,
            sp.diag(0, real("r"), 1),
            {"parameters": (free_number("r"),)},
            marks=pytest.mark.thorough,  # its certificate is checked among odd three states
        ),
        (KINEMATIC_3, SQUARE * SQUARE.T, {}),
    ],
    ids=["fading", "a free ratio", "a noise that the catalogue's method cannot hold"],
)
def test_three_states_of_the_general_method(
    transition: list[list[Any]], noise: sp.MatrixBase, options: dict[str, Any]
) -> None:
    found = kernels(derive_own_model(own_model(transition, noise.tolist(), **options)))
    assert found == {"gains", "predicted_covariance", "updated_covariance", "gain_derivatives"}


@pytest.mark.parametrize("velocity", cases([0, 5], lambda _: False))
def test_three_kinematic_states(velocity: int) -> None:
    model = own_model(KINEMATIC_3, sp.diag(0, velocity, 1).tolist())
    assert "gains" in kernels(derive_own_model(model))


def test_two_measurements_that_are_no_rates_by_their_units_are_refused() -> None:
    """The catalogue's kernels speak of a velocity and of T."""
    model = both_measured()
    noise = model.measurement_noise
    model = replace(
        model,
        measurement=sp.ImmutableDenseMatrix([[1, 0], [0, T]]),
        measurement_units=(METRE, METRE),
        measurement_noise=sp.ImmutableDenseMatrix([[noise[0, 0], 0], [0, T**2 * noise[1, 1]]]),
    )
    with pytest.raises(ModelError, match=r"should have the units m and m s\^-1"):
        derive_own_model(model)


@pytest.mark.usefixtures("quick")
@pytest.mark.parametrize(("number", "said"), [("0.982", "491/500"), ("2", "2"), ("1", "")])
def test_what_a_number_behind_the_strength_costs_is_said(number: str, said: str) -> None:
    shape = sp.Rational(number) * sp.Matrix([[HALF / 2, HALF], [HALF, 1]])
    subject = derive_own_model(own_model(KINEMATIC, shape.tolist()))
    assert ("closed_loop_poles" in kernels(subject)) == (not said)
    assert f"here it is {said}. Take" in subject.derivation.left_out or not said
    assert bool(subject.derivation.left_out) == bool(said)
