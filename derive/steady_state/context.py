"""What all groups of steps of one two-state family share."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from gainproof.derive.algebra.limits import End
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.model import Model, ModelError, ScaledModel, scale
from gainproof.derive.steady_state.spectrum import Spectrum, factorise
from gainproof.derive.steady_state.towers import end, main_tower, start


@dataclass(frozen=True)
class Context:
    """A scaled model with its spectrum and tower."""

    original: Model
    model: ScaledModel
    spectrum: Spectrum
    e: Fraction
    n: Fraction
    tower: Tower

    @property
    def ends(self) -> Mapping[str, End]:
        """Behaviour of the tower at both ends of the index."""
        return {"0": start(self.e), "infinity": end(self.e)}

    @property
    def model_data(self) -> dict[str, Any]:
        """The scaled model as plain data."""
        return self.model.data()


def context(model: Model) -> Context:
    """Scale and factorise a two-state model with measured position.

    Raises ModelError, naming the reason, outside the method's reach: noise(4)/noise(0) between 0
    and 1, Q12/Q22 between 0 and 1/2.
    """
    scaled = scale(model)
    spectrum = factorise(scaled)
    e = Fraction(str(spectrum.ratio))
    n = Fraction(str(scaled.process_noise[0, 1] / scaled.process_noise[1, 1]))
    if not 0 <= e <= 1 or not 0 <= n <= Fraction(1, 2):
        raise ModelError(
            f"model {model.name}: noise(4)/noise(0) in [0, 1] and Q12/Q22 in [0, 1/2] are wanted, "
            f"they are {e} and {n}"
        )
    return Context(model, scaled, spectrum, e, n, main_tower(e, n))
