"""What depends on the index alone where position and velocity are measured."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction

import flint
from pole_places import ball, turning_places

from gainproof.verify.oracles.true_values import SteadyStateTruth, Truth, steady_state_truth


@dataclass(frozen=True)
class BothMeasuredTruth:
    """With the velocities known exactly the displacement in an interval has the variance that is
    left when both at its ends are given (`displacement`, None where it is 0), and the position is
    all there is to filter. The places where the poles turn real are those of `turning_places`.
    """

    noise: tuple[tuple[Fraction, ...], ...]
    displacement: SteadyStateTruth | None

    def at(self, argument: str, value: float) -> Mapping[str, Truth]:
        """Variances of the position, updated and predicted before the new velocity is known; and
        the inverse squares of the velocity ratios at which two poles meet.
        """
        with flint.ctx.workprec(400):
            predicted = ball(self.noise[0][0] * Fraction(value) ** 2)
            found = {}
            if self.displacement is not None:
                found["updated_11"] = self.displacement.at(argument, value)["updated_11"]
                predicted = predicted + found["updated_11"].value
            first, second = turning_places(self.noise, Fraction(value))
            return {
                **found,
                "predicted_11": Truth(predicted, predicted),
                "positive_from": Truth(first, first),
                "negative_up_to": Truth(second, first),
            }


def both_measured(noise: Sequence[Sequence[str]]) -> BothMeasuredTruth:
    """The truth for a process noise in units T = sigma_o = 1, for index 1."""
    entries = tuple(tuple(Fraction(entry) for entry in row) for row in noise)
    (own, cross), (_, last) = entries
    left = own - cross * cross / last
    one = [["1"]]
    data = {
        "transition": one,
        "process_noise": [[str(left)]],
        "measurement": one,
        "measurement_noise": one,
    }
    return BothMeasuredTruth(entries, steady_state_truth(data) if left else None)
