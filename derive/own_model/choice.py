"""Which method derives a user's model."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import sympy as sp

from gainproof.derive.any_three_state import names as three_states
from gainproof.derive.any_three_state.any_three_state import derive_any_three_state
from gainproof.derive.any_two_state import names as two_states
from gainproof.derive.any_two_state.any_two_state import derive_any_two_state
from gainproof.derive.any_two_state.model_numbers import require_first_measured
from gainproof.derive.any_two_state.scaling import scale_free
from gainproof.derive.derivation import PageError
from gainproof.derive.model import Model, ModelError, ScaledModel, scale
from gainproof.derive.model_checks import require_written_well
from gainproof.derive.own_model.checks import require_steady_state
from gainproof.derive.own_model.one_state import derive_one_state
from gainproof.derive.printer.module_bounds import prove_all
from gainproof.derive.quantity import METRE, SECOND
from gainproof.derive.steady_state.two_state import derive_two_state
from gainproof.derive.subject import Subject
from gainproof.derive.three_state.three_state import derive_three_state
from gainproof.derive.vector_measurement.position_velocity import derive_position_velocity

KINEMATIC_3 = sp.ImmutableDenseMatrix([[1, 1, sp.Rational(1, 2)], [0, 1, 1], [0, 0, 1]])
KINEMATIC = sp.ImmutableDenseMatrix([[1, 1], [0, 1]])
RATES = (METRE, METRE / SECOND, METRE / SECOND**2)
"""The units of a position and its rates: the powers of T that the catalogue's kernels speak of."""
TAKEN = frozenset({*two_states.LATEX, *three_states.LATEX})


def derive_own_model(model: Model) -> Subject:
    """Derive a model with the narrowest method that has it in reach.

    Raises ModelError, naming the entry or property, for a model that has no steady state or is
    outside the reach of all methods.
    """
    require_written_well(model)
    require_names_of_their_own(model)
    states, measured = model.transition.rows, model.measurement.rows
    if (states, measured) not in ((1, 1), (2, 1), (3, 1), (2, 2)):
        raise ModelError(
            f"model {model.name}: one to three states with one measured, or two with both "
            f"measured, are in reach; {states} states and {measured} measurements came: of several "
            "axes that share nothing each is a model of its own"
        )
    if measured > 1 and model.parameters:
        raise ModelError(
            f"model {model.name}: with two measurements free numbers are out of reach, "
            f"{', '.join(each.quantity.name for each in model.parameters)} came"
        )
    scaled = scale(model) if measured > 1 else scale_free(model)
    require_steady_state(model, scaled)
    if measured == 2:
        return _both_measured(model, scaled)
    if states == 1:
        return derive_one_state(model)
    return _two_states(model, scaled) if states == 2 else _three_states(model, scaled)


def _is_as_written(scaled: ScaledModel) -> bool:
    """Whether the strength that `scale` takes out is the product of quantities alone that the model
    is written with: only then its index is that of the model.
    """
    return bool(scaled.noise_ratio.as_coeff_Mul()[0] == 1)


def _counts_rates(model: Model) -> bool:
    """Whether states and measurements are a position and its rates by their units too."""
    several = (model.state_units, model.measurement_units)
    return all(units == RATES[: len(units)] for units in several)


def _both_measured(model: Model, scaled: ScaledModel) -> Subject:
    """A position and its rate by the method of the catalogue."""
    try:
        subject = derive_position_velocity(model, ())
        if not _counts_rates(model):
            reason = "the states, and the measurements, should have the units m and m s^-1"
        elif _is_as_written(scaled):
            return subject
        else:
            reason = (
                f"the matrix behind the strength has Q22 = {scaled.noise_ratio.as_coeff_Mul()[0]}; "
                "take that number into the quantity of the strength"
            )
    except ModelError as error:
        reason = str(error).removeprefix(f"model {model.name}: ")
    except (ValueError, TypeError, ArithmeticError):
        reason = f"it is {scaled.process_noise.tolist()}"
    raise ModelError(
        f"model {model.name}: of two states that are both measured, a position and its rate with a "
        "process noise Q12 = Q22/2, Q11 from Q22/4 to below Q22/2, or Q11 = Q12 = 0, with Q22 = 1 "
        f"behind the strength (in units T = 1) is in reach: {reason}"
    )


def _two_states(model: Model, scaled: ScaledModel) -> Subject:
    """Kinematic ones by the method of the catalogue where that reaches."""
    require_first_measured(model, scaled)
    if scaled.transition == KINEMATIC and _counts_rates(model) and not model.parameters:
        with suppress(ModelError):
            if _is_as_written(found := scale(model)):
                return derive_two_state(model, ())
            return _with_left_out(derive_any_two_state(model), found)
    return derive_any_two_state(model)


def _with_left_out(subject: Subject, scaled: ScaledModel) -> Subject:
    """The subject, with what the number behind the strength costs."""
    number = scaled.noise_ratio.as_coeff_Mul()[0]
    said = (
        "There are no kernels of poles and none that give the index for a gain: these have their "
        f"forms where Q22 is 1 behind the strength (in units T = 1), and here it is {number}. Take "
        "that number into the quantity of the strength to have them."
    )
    return replace(subject, derivation=replace(subject.derivation, left_out=said))


def _three_states(model: Model, scaled: ScaledModel) -> Subject:
    """Kinematic ones by the method of the catalogue where that reaches."""
    require_first_measured(model, scaled)
    if scaled.transition == KINEMATIC_3 and _counts_rates(model) and not model.parameters:
        subject = _kinematic(model)
        if subject is not None:
            return subject
    return derive_any_three_state(model)


def _kinematic(model: Model) -> Subject | None:
    """By the method of the catalogue; none where it refuses, the other method names the reason.

    It is tried whole, evidence and bounds too: it refuses late, with errors of several kinds.
    """
    subject = None
    try:
        if _is_as_written(scale(model)):
            subject = derive_three_state(model, ())
    except PageError:
        raise  # a mistake of the page, which is none of the model
    except (ValueError, ArithmeticError, TypeError):
        return None
    with suppress(ValueError, ArithmeticError, TypeError):
        if subject is not None:
            subject.certificate()
            prove_all(subject.module.kernels)
            return subject
    return None


def require_names_of_their_own(model: Model) -> None:
    """Raises ModelError for a free number with the name of a root, a gain, an entry, the index.

    Two symbols of one name are one symbol: what is proved of the one would be said of the other.
    """
    for entry in model.parameters:
        name = entry.quantity.name
        if name in TAKEN:
            raise ModelError(
                f"model {model.name}: the parameter {name} should have another name, a quantity "
                f"of the derivation is called {name}"
            )
