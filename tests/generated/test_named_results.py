"""Results of kernels offer what `typing.NamedTuple` does, of which type checkers think them."""

from __future__ import annotations

import copy
import pickle
from typing import Any, NamedTuple

import numpy as np
import pytest

from gainproof.generated.updated_gains import FirstOrderGains, first_order_gains

ONE, TWO, THREE = np.float64(1), np.float64(2), np.float64(3)


class Wanted(NamedTuple):
    """The same fields, by the standard library."""

    alpha: float
    beta: float


def test_they_are_tuples_with_names() -> None:
    ours = FirstOrderGains(ONE, TWO)
    theirs: Any = Wanted(ONE, TWO)  # a class of its own, which type checkers think never equal
    assert tuple(ours) == tuple(theirs) == (ONE, TWO)
    assert (ours.alpha, ours.beta) == (theirs.alpha, theirs.beta)
    assert repr(ours) == repr(theirs).replace("Wanted", "FirstOrderGains")
    assert ours._fields == theirs._fields == FirstOrderGains._fields
    assert FirstOrderGains.__match_args__ == Wanted.__match_args__
    assert ours._asdict() == theirs._asdict()
    assert ours._replace(beta=THREE) == theirs._replace(beta=THREE)
    assert FirstOrderGains._make([ONE, TWO]) == ours == FirstOrderGains(ONE, beta=TWO)
    assert hash(ours) == hash(theirs)


def test_they_come_back_from_pickles_and_copies() -> None:
    result = first_order_gains(0.5, 0.6)
    for again in (pickle.loads(pickle.dumps(result)), copy.copy(result), copy.deepcopy(result)):
        assert type(again) is FirstOrderGains
        assert again == result


def test_they_cannot_be_changed() -> None:
    result = FirstOrderGains(ONE, TWO)
    for name in ("alpha", "gamma"):
        with pytest.raises(AttributeError):
            setattr(result, name, 3.0)


def test_a_pattern_takes_them_apart() -> None:
    match first_order_gains(0.5, 0.5):
        case FirstOrderGains(alpha=alpha, beta=beta):
            assert 0 < beta < alpha < 1
        case _:
            pytest.fail("no match")


@pytest.mark.parametrize(
    ("values", "named"),
    [((1.0,), {}), ((1.0, 2.0, 3.0), {}), ((1.0,), {"alpha": 2.0}), ((1.0,), {"gamma": 2.0})],
)
def test_values_that_do_not_fit(values: Any, named: Any) -> None:
    with pytest.raises(TypeError, match="FirstOrderGains takes one value for each of alpha, beta"):
        FirstOrderGains(*values, **named)
    with pytest.raises(TypeError):
        Wanted(*values, **named)
