"""What the quantities of a setting are, as expressions of a few base variables."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr

INTERVAL = "sampling_interval"
DEVIATION = "measurement_noise_deviation"
INDEX = "tracking_index"
SAMPLE = "sample_number"
POSITIVE = Box(lower=Fraction(0))
ANY_REAL = Box(stated=False)


class NotEstablished(ValueError):
    """The judge could not show that its own solution is the setting's; the text says which step
    failed.
    """


@dataclass(frozen=True)
class Fact:
    """Something the judge established about the setting before it used it, with its certificate."""

    sentence: str
    method: str
    certificate: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Environment:
    """`quantities` maps names of quantities to expressions over the base variables in `boxes`.

    `missing` says why a quantity that has a name is not determined by the setting. `continued` are
    rational functions equal to quantities wherever these have a value, and defined where their
    formula still is. `assigned` are free symbols of the source that the setting's model fixes, and
    `intensity` is the one among them that changes with the parameter while all others stay.
    """

    name: str
    quantities: Mapping[str, Expr] = field(default_factory=dict)
    boxes: Mapping[str, Box] = field(default_factory=dict)
    parameter: str | None = None
    facts: tuple[Fact, ...] = ()
    missing: Mapping[str, str] = field(default_factory=dict)
    continued: Mapping[str, Expr] = field(default_factory=dict)
    assigned: Mapping[str, Expr] = field(default_factory=dict)
    intensity: str | None = None

    def moves_with(self, name: str) -> bool:
        """Whether quantities hide a base variable: with the source's other symbols kept, the
        parameter changes too when that variable does.
        """
        return bool(self.assigned) and name in self.boxes and name != self.parameter


def algebra() -> Environment:
    """No model: every symbol is free or defined by the source."""
    return Environment("no model")
