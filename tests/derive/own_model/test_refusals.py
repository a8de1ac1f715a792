"""Models that have no steady state, or are not written well: what each refusal names."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp
from own_models import DEVIATION, SHAKE, T, free_number, own_model

from gainproof.derive.expression import real
from gainproof.derive.model import Model, ModelError
from gainproof.derive.model_checks import require_written_well
from gainproof.derive.own_model.choice import derive_own_model
from gainproof.derive.quantity import (
    MEASUREMENT_DEVIATION,
    METRE,
    SAMPLING_INTERVAL,
    SECOND,
    Quantity,
    Unit,
)

KINEMATIC = [[1, 1], [0, 1]]
LAST = [[0, 0], [0, 1]]
HALF = sp.Rational(1, 2)
FADING = [[1, 1, HALF], [0, 1, 1], [0, 0, HALF]]
R = real("r")


def _matrix(*rows: list[Any]) -> sp.ImmutableDenseMatrix:
    return sp.ImmutableDenseMatrix(rows)


REFUSED: list[tuple[Model, str]] = [
    (
        own_model(KINEMATIC, LAST, process_noise=_matrix([0, SHAKE.symbol**2], [0, 0])),
        r"process_noise should be symmetric, its entry 1,2 is shake\*\*2 and its entry 2,1 is 0",
    ),
    (
        own_model(KINEMATIC, [[0, 1], [1, 1]]),
        "process_noise should be positive semidefinite; .* its minor of rows 1, 2 is -1",
    ),
    (
        own_model(KINEMATIC, LAST, measurement_noise=_matrix([-(DEVIATION**2)])),
        "measurement_noise should be positive definite; .* its minor of rows 1 is -1",
    ),
    (
        own_model(KINEMATIC, LAST, measurement=_matrix([1, 0, 0])),
        r"measurement should have the shape \(1, 2\), it has \(1, 3\)",
    ),
    (
        own_model(KINEMATIC, LAST, transition=_matrix([1, T])),
        r"transition should have the shape \(1, 1\), it has \(1, 2\)",
    ),
    *(
        (
            own_model([[1, 1], [0, real(name)]], LAST, parameters=(free_number(name),)),
            f"the parameter '{name}' should have the name of a Python variable, and not `out`",
        )
        for name in ("lambda", "out", "a b")
    ),
    (
        own_model(KINEMATIC, LAST, parameters=(free_number("r"),)),
        "the parameter r occurs in no matrix: leave it out, or use",
    ),
    *(
        (
            own_model([[1, 1], [0, R]], LAST, **{name: free_number("r")}),
            rf"{name} should be a tuple, it is of type Parameter; .* with a comma, \(x,\)",
        )
        for name in ("parameters", "quantities", "state_units")
    ),
    (
        own_model([[1, 1], [0, sp.sqrt(2) / 2]], LAST),
        r"transition should hold rational numbers, its entry 2,2 holds sqrt\(2\)",
    ),
    (
        own_model(KINEMATIC, [[0.5, 0.5], [0.5, 1]]),
        r"process_noise should hold rational numbers, its entry 1,1 holds 0\.50*",
    ),
    (
        own_model(
            [[1, 1], [0, R]],
            LAST,
            parameters=(free_number("r", below_one=True, kernel_to="999999999/1000000000"),),
        ),
        "kernels need r from a positive number to a greater one below 1",
    ),
    (
        own_model([[1, 0], [0, HALF]], [[1, 0], [0, 1]]),
        r"\(F, H\) should be observable, the rank of H, H F, ... is 1 of 2",
    ),
    (
        own_model([[1, 1], [0, 2]], [[1, 0], [0, 0]]),
        (
            r"should be stabilisable, the process noise never drives the mode 2 of F, which lies "
            "outside the unit circle"
        ),
    ),
    (
        own_model(KINEMATIC, [[1, 0], [0, 0]]),
        (
            "the process noise should drive every state, the process noise never drives the mode 1 "
            "of F, which lies on the unit circle: the Riccati equation has no stabilising solution"
        ),
    ),
    (
        own_model([[1, 1], [0, HALF]], [[1, 0], [0, 0]]),
        "never drives the mode 1/2 of F, which dies out",
    ),
    (
        own_model([[1, 1 - R], [0, R]], LAST),
        "transition holds the symbol r, which has no domain",
    ),
    (
        own_model(KINEMATIC, [[sp.Symbol("shake"), 0], [0, 1]]),
        "holds another symbol named shake",
    ),
    (
        own_model(KINEMATIC, [[R, 1], [1, 1]], parameters=(free_number("r"),)),
        (
            "process_noise should be positive semidefinite, and each minor of it 0 or of one sign "
            "for all parameters: of its minor of rows 1, 2, r - 1 is not shown to have one sign"
        ),
    ),
    (
        own_model([[1, R - 2], [0, HALF]], LAST, parameters=(free_number("r"),)),
        r"\(r - 2\)\*\*2 is not shown to be other than 0 for all parameters",
    ),
    (
        own_model(
            [[1, 1], [0, R]],
            LAST,
            parameters=(free_number("r", below_one=True, kernel_to="2"),),
        ),
        "kernels need r from a positive number to a greater one below 1, the range is 1/1024 to 2",
    ),
    (own_model(KINEMATIC, [[0, 0], [0, 0]]), "all its entries are 0"),
    (
        own_model(KINEMATIC, LAST, process_noise=_matrix([0, 0], [0, DEVIATION**2 / T**2])),
        "which fixes the tracking index",
    ),
    (
        own_model(
            KINEMATIC,
            LAST,
            process_noise=_matrix([SHAKE.symbol**2, 0], [0, DEVIATION**2 / T**2]),
        ),
        "one strength times a matrix",
    ),
    (
        own_model(KINEMATIC, LAST, measurement=_matrix([2, 0])),
        r"H = \[\[1, 0\]\] and R = \[\[1\]\] are wanted, they are \[\[2, 0\]\]",
    ),
    (own_model(KINEMATIC, LAST, name="My model"), "a name of lower-case letters"),
    (
        own_model(KINEMATIC, LAST, state_units=(METRE,)),
        "a unit for each of 2 entries of the state is wanted, there are 1",
    ),
    (
        own_model([[1, 1, 0], [0, 1, 0], [0, 0, HALF]], sp.eye(3).tolist()),
        r"\(F, H\) should be observable, the rank of H, H F, ... is 2 of 3: a state is never seen",
    ),
    (
        own_model(FADING, [[0, 0, 1], [0, 0, 0], [1, 0, 1]]),
        "process_noise should be positive semidefinite; .* its minor of rows 1, 3 is -1",
    ),
    (
        own_model(FADING, sp.diag(0, 1, 0).tolist()),
        "drive every state, the process noise never drives the mode 1/2 of F, which dies out",
    ),
    (
        own_model([[1, 1, HALF], [0, 1, 1], [0, 0, 1]], sp.diag(1, 1, 0).tolist()),
        (
            "should drive every state, the process noise never drives the mode 1 of F, which lies "
            "on the unit circle"
        ),
    ),
    (
        own_model([[0, 1, 0], [-1, 0, 1], [0, 0, 1]], sp.diag(0, 0, 1).tolist()),
        (
            "of three states coefficients of the spectrum that are not negative are in reach, f2 = "
            "-32: poles off the real axis"
        ),
    ),
    (
        own_model([[1, 1, HALF], [0, 1, 1], [0, 0, 0]], sp.diag(0, 0, 1).tolist()),
        "of three states a transition with an inverse is in reach, det F = 0",
    ),
    (
        own_model(
            [[1, 1, 0, 0], [0, 1, 1, 0], [0, 0, 1, 1], [0, 0, 0, 1]],
            sp.diag(0, 0, 0, 1).tolist(),
        ),
        "4 states and 1 measurements came: of several axes .* each is a model of its own",
    ),
    (
        own_model(
            [[1, 1, 0, 0], [0, 1, 0, 0], [0, 0, 1, 1], [0, 0, 0, 1]],
            sp.diag(0, 1, 0, 1).tolist(),
            measurement=_matrix([1, 0, 0, 0], [0, 0, 1, 0]),
            measurement_noise=_matrix([DEVIATION**2, 0], [0, DEVIATION**2]),
            measurement_units=(METRE, METRE),
        ),
        "4 states and 2 measurements came: of several axes .* each is a model of its own",
    ),
    (
        own_model(
            [[1, 1], [0, R]],
            LAST,
            parameters=(free_number("r"),),
            measurement=_matrix([1, 0], [0, 1]),
            measurement_noise=_matrix([DEVIATION**2, 0], [0, DEVIATION**2]),
            measurement_units=(METRE, METRE),
        ),
        "with two measurements free numbers are out of reach, r came",
    ),
    (
        own_model(KINEMATIC, LAST, measurement=_matrix([1, T])),
        "a sum of states, as the first state: with the new states C x, F becomes C F C.-1",
    ),
    (
        own_model(
            KINEMATIC,
            LAST,
            process_noise=SHAKE.symbol**2 * _matrix([1, 0], [0, T**-2])
            + MEASUREMENT_DEVIATION.symbol**2 * _matrix([1, 0], [0, 0]),
        ),
        "of several strengths keep one and write the others over it as parameters",
    ),
    *(
        (
            own_model([[1, entry], [0, R]], LAST, parameters=(free_number("r", below_one=True),)),
            rf"its entry 1,2 holds {shown}, which is out of reach as a function; make {shown} a",
        )
        for entry, shown in (
            (sp.log(R), r"log\(r\)"),
            ((1 - R) / sp.log(R), r"log\(r\)"),
            (sp.exp(-R), r"exp\(-r\)"),
            (sp.sqrt(R), r"sqrt\(r\)"),
            (R**R, r"r\*\*r"),
            (sp.Max(R, 1), r"Max\(1, r\)"),
        )
    ),
    (
        own_model([[1, 1], [0, sp.Rational(1, 10**5000)]], LAST),
        "transition should hold numbers of at most 300 digits, its entry 2,2 holds a longer one",
    ),
    (own_model([[1, sp.I], [0, 1]], LAST), "should hold rational numbers, its entry 1,2 holds"),
    (
        own_model(KINEMATIC, LAST, transition=_matrix([1, sp.oo], [0, 1])),
        "should hold rational numbers, its entry 1,2 holds",
    ),
    (
        own_model(KINEMATIC, LAST, transition=_matrix([1, sp.zoo], [0, 1])),
        "should hold rational numbers, its entry 1,2 holds",
    ),
]
ANGLE = Quantity("heading_deviation", "h", "deviation of a heading", Unit())


REFUSED_FIELDS: list[tuple[Model, str]] = [
    (
        own_model(KINEMATIC, LAST, process_noise=_matrix([0, 0], [0, SHAKE.symbol / T**2])),
        "entry 2,2 of process_noise should have the unit m.2 s.-2, .* has m s.-2",
    ),
    (
        own_model(KINEMATIC, LAST, process_noise=_matrix([0, 0], [0, SHAKE.symbol**2 + T])),
        "entry 2,2 of process_noise: .* has the unit",
    ),
    (
        own_model(KINEMATIC, LAST, state_units=(METRE, "m/s")),
        "state 2 should have a unit made of METRE, SECOND .* it has 'm/s'",
    ),
    (
        own_model(KINEMATIC, LAST, quantities=(SAMPLING_INTERVAL, SHAKE)),
        "quantities should hold measurement_deviation, they hold sampling_interval, shake",
    ),
    (
        own_model(KINEMATIC, LAST, quantities=(SAMPLING_INTERVAL, MEASUREMENT_DEVIATION, T)),
        "quantities are of the type Quantity, sampling_interval is not",
    ),
    (
        own_model(
            KINEMATIC,
            LAST,
            deviation=ANGLE,
            measurement_noise=_matrix([ANGLE.symbol**2]),
            process_noise=_matrix([0, 0], [0, SHAKE.symbol**2]),
            quantities=(SAMPLING_INTERVAL, ANGLE, SHAKE),
            state_units=(Unit(), SECOND**-1),
        ),
        "should be a length, .* has the unit 1; of an angle or anything else write METRE",
    ),
    (
        own_model(KINEMATIC, LAST, transition=[[1, T], [0, 1]]),
        r"transition should be a matrix of SymPy, .* it is of type list",
    ),
]


@pytest.mark.parametrize(("model", "message"), [*REFUSED, *REFUSED_FIELDS])
def test_each_refusal_names_the_entry_or_property(model: Model, message: str) -> None:
    with pytest.raises(ModelError, match=message) as raised:
        derive_own_model(model)
    assert isinstance(raised.value, ValueError)
    assert "\n" not in str(raised.value)


def test_a_reason_that_several_kernels_have_is_said_once() -> None:
    """c^2 + h^2 may be 1: no form of a kernel holds for all numbers."""
    c, h = real("c"), real("h")
    numbers = (free_number("c", below_one=True), free_number("h", below_one=True))
    with pytest.raises(
        ModelError, match=r"4\*\(c\*\*2 \+ h\*\*2 - 1\)\*\*2 is not shown"
    ) as raised:
        derive_own_model(own_model([[c, h], [-h, c]], LAST, parameters=numbers))
    assert str(raised.value).count("is not shown to be other than 0") == 1
    assert "model trial" not in str(raised.value).removeprefix("model trial")


@pytest.mark.parametrize("name", ["s", "p", "d1", "alpha", "predicted_22", "tracking_index"])
@pytest.mark.parametrize("states", [2, 3])
def test_a_parameter_is_not_called_like_a_quantity_of_the_derivation(
    name: str, states: int
) -> None:
    motion = [[1, 1, sp.Rational(1, 2)], [0, 1, 1], [0, 0, 1]]
    noise = sp.diag(*[real(name)] * (states - 1), 1).tolist()
    transition = [row[:states] for row in motion[:states]]
    model = own_model(transition, noise, parameters=(free_number(name),))
    with pytest.raises(ModelError, match=f"the parameter {name} should have another name"):
        derive_own_model(model)


def test_a_parameter_has_no_unit() -> None:
    parameter = free_number("r")
    length = Quantity("r", "r", "a length", METRE)
    wrong = type(parameter)(length)
    with pytest.raises(ModelError, match="the parameter r should have no unit, it has m"):
        derive_own_model(own_model([[1, 1], [0, R]], LAST, parameters=(wrong,)))


@pytest.mark.parametrize("number", [0.953, 1e-20, -0.1, 123456.7])
def test_a_decimal_that_came_through_a_float_is_refused_with_its_text(number: float) -> None:
    model = own_model([[1, 1], [sp.Rational(number), 1]], LAST)
    with pytest.raises(ModelError, match="a float in binary") as raised:
        derive_own_model(model)
    text = str(raised.value).partition('sp.Rational("')[2].partition('"')[0]
    assert float(text) == abs(number) or float(text) == number


@pytest.mark.parametrize("number", [sp.Rational("0.953"), sp.Rational(1, 2**50), sp.Rational(0.75)])
def test_quotients_that_somebody_wrote_are_not_taken_for_floats(number: sp.Rational) -> None:
    require_written_well(own_model([[1, 1], [0, number]], LAST))


def test_a_noise_in_numbers_alone_is_told_what_to_do() -> None:
    noise = sp.ImmutableDenseMatrix([[sp.Rational("0.004"), 0], [0, sp.Rational("0.012")]])
    with pytest.raises(ModelError, match=r"entry 1,1 of process_noise .* a strength in front"):
        derive_own_model(own_model([[1, 1], [0, 1]], LAST, process_noise=noise))


@pytest.mark.parametrize("noise", [[[1, 0], [0, (R - 1) ** 2]], [[(R - 1) ** 2, 0], [0, R]]])
def test_a_square_that_may_be_zero_is_not_told_as_indefinite(noise: list[list[sp.Expr]]) -> None:
    model = own_model([[1, 2], [0, 0]], noise, parameters=(free_number("r"),))
    with pytest.raises(
        ModelError, match=r"minor of rows \d, \(r - 1\)\*\*2 is not shown to be other"
    ):
        derive_own_model(model)


@pytest.mark.parametrize("power", [4, 6])
def test_no_message_is_longer_than_is_read(power: int) -> None:
    """A polynomial of many terms is told by how it begins and what it holds."""
    odd = sp.expand((R**2 - 3 * R + sp.Rational(1, 7)) * (R + 2) ** (4 * power) - 1)
    model = own_model([[1, odd], [0, HALF]], LAST, parameters=(free_number("r"),))
    with pytest.raises(ModelError, match=r"\.\.\. \(\d+ characters in r\) is not shown") as raised:
        derive_own_model(model)
    assert len(str(raised.value)) < 500


def test_a_sign_within_a_derivation_is_told_with_its_meaning() -> None:
    """det F changes its sign within the domain."""
    model = own_model(
        [[1, 1 / R], [2, 1]], [[R**2, 0], [0, 0]], parameters=(free_number("r", below_one=True),)
    )
    with pytest.raises(ModelError, match=r"2\*r - 1.*and the formulas depend on its sign"):
        derive_own_model(model)
