"""What the quantities of a setting are, as expressions of a few base variables."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import differentiated
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of
from gainproof.verify.judge.exact.statement import Outcome, Rel, Statement
from gainproof.verify.judge.setting.stable_region import StableRegion

INTERVAL = "sampling_interval"
DEVIATION = "measurement_noise_deviation"
INDEX = "tracking_index"
RATIO = "velocity_deviation_ratio"
SAMPLE = "sample_number"
WEIGHT = "forgetting_factor"
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


Decide = Callable[[Statement, Mapping[str, Box], Mapping[str, str]], Outcome | None]
"""Decides a statement on domains, with labels for its witness; None for one that is decided as
usual. Raises Undecided.
"""


@dataclass(frozen=True)
class Environment:
    """`quantities` maps names of quantities to expressions over the base variables in `boxes`.

    `missing` says why a quantity that has a name is not determined by the setting. `continued` are
    rational functions equal to quantities wherever these have a value, and defined where their
    formula still is. `assigned` are free symbols of the source that the setting's model fixes, and
    `intensity` is the one among them that changes with the parameter while all others stay.
    Of a filter in numbers `conditions` leave the parameter, if it has one, a single value.
    With two parameters `fixing` are two that fix these, and each may change while the other stays.

    `rests` are relations of free symbols without which the model has no quantities: what is told of
    these is told where the relations hold.

    Where two parameters are needed they are `coordinates`, and `chart` may be the same setting in
    other base variables, in which more is decided: there `decide` is what decides, `charted` are
    the coordinates, whatever a source calls them, and `squares` those of these.

    With free gains `region` is where the filter is stable.

    Where the model has free numbers or several strengths, gains are the base variables, `hidden`
    ones: everything else that the model holds changes them, in a way that no formula shows.

    `model` holds the matrices F, H, Q, R of a steady state with its covariance P and gain K, in the
    source's units.
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
    conditions: tuple[Rel, ...] = ()
    rests: tuple[Rel, ...] = ()
    fixing: tuple[str, ...] = ()
    coordinates: tuple[str, ...] = ()
    chart: Environment | None = None
    decide: Decide | None = None
    charted: Mapping[str, Expr] = field(default_factory=dict)
    squares: Mapping[str, Expr] = field(default_factory=dict)
    region: StableRegion | None = None
    hidden: frozenset[str] = frozenset()
    model: Mapping[str, Sequence[Sequence[Expr]]] = field(default_factory=dict)

    def own_variables(self) -> frozenset[str]:
        """The base variables that stand for the tracking index and other parameters of a model."""
        if self.parameter in (SAMPLE, WEIGHT):
            return frozenset()
        known = (self.parameter, *self.coordinates, *symbols_of(*self.squares.values()))
        return frozenset(name for name in known if name is not None)

    @property
    def pair(self) -> tuple[str, ...]:
        """The names of two parameters, if there are two."""
        return self.coordinates or tuple(self.charted)

    def coordinate(self, name: str) -> Expr:
        """One of two parameters in base variables."""
        return self.charted[name] if self.charted else symbol(name)

    def moves_with(self, name: str, *of: Expr) -> bool:
        """Whether these expressions hide a base variable, of which the parameter that they hold is
        made: it changes too when that variable does and the noises of the source stay.
        """
        if not self.hidden.isdisjoint(symbols_of(*of)):
            model = symbols_of(*self.assigned.values(), *self.quantities.values())
            # one gain alone tells no change where there are several
            return name in (model if len(self.hidden) > 1 else model - self.hidden)
        if name not in (INTERVAL, DEVIATION):
            return False
        return not self.own_variables().isdisjoint(symbols_of(*of))

    def is_coordinate(self, expr: Expr) -> bool:
        """Whether it is one of the coordinates in other base variables."""
        return any(coordinate == expr for coordinate in self.charted.values())

    def change(self, expr: Expr, name: str) -> Expr:
        """The partial derivative with respect to one of two parameters, the other being kept."""
        if self.charted:
            return self.slope(expr, self.charted[name])
        return differentiated(expr, name)

    def slope(self, expr: Expr, along: Expr) -> Expr:
        """The partial derivative with respect to one coordinate, the other being kept: by that of
        its square, from the derivatives with respect to the base variables of the squares.
        """
        (name,) = (n for n, coordinate in self.charted.items() if coordinate == along)
        (kept,) = (square for n, square in self.squares.items() if n != name)
        low, high = sorted(symbols_of(kept))

        def turned(of: Expr) -> Expr:
            first = differentiated(of, low) * differentiated(kept, high)
            return first - differentiated(of, high) * differentiated(kept, low)

        return 2 * along * turned(expr) / turned(self.squares[name])


def algebra() -> Environment:
    """No model: every symbol is free or defined by the source."""
    return Environment("no model")
