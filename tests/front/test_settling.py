"""Runs of gains that come near, leave again and come back: how far such a run has to go.

The gains are a list written here; that they are looked at as long as is said is all that is tested.
"""

from __future__ import annotations

import numpy as np
import pytest

from gainproof.time_varying import settling
from gainproof.time_varying.covariance import Reals
from gainproof.time_varying.settling import last_outside, least_run

STEADY = (np.ones(()),)


def advance(count: int) -> tuple[int, list[Reals]]:
    """Off at samples 1 to 3, near at 4 and 5, off at 6, near for ever."""
    return count + 1, [np.asarray(1.0 if count in (3, 4) or count > 5 else 1.5)]


def test_a_run_goes_on_for_as_long_as_gains_were_off() -> None:
    assert last_outside(advance, 0, STEADY, 0.1, 1, ()) == 6


def test_a_run_goes_on_for_the_least_number_of_samples() -> None:
    def late(count: int) -> tuple[int, list[Reals]]:
        return count + 1, [np.asarray(1.5 if count == 19 else 1.0)]

    assert last_outside(late, 0, STEADY, 0.1, 5, ()) == 0
    assert last_outside(late, 0, STEADY, 0.1, 20, ()) == 20


def test_the_least_run_leaves_a_thousandth_of_the_share() -> None:
    for share, ratio in ((0.1, 0.5), (1e-3, 0.9), (0.5, 0.01)):
        count = least_run(share, np.float64(ratio))
        assert ratio**count <= share / 1000 < ratio ** (count - 2)
    assert least_run(0.1, np.array([0.5, 0.9])) == least_run(0.1, np.float64(0.9))


def test_gains_that_stay_off_are_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(settling, "MOST", 50)
    with pytest.raises(ValueError, match=r"not within 0\.1 of the steady ones after 50 samples"):
        last_outside(lambda count: (count + 1, [np.asarray(1.5)]), 0, STEADY, 0.1, 1, ())
