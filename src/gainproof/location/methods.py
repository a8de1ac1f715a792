"""The methods: which observations each uses, and which unknowns it has. One table."""

from __future__ import annotations

from dataclasses import dataclass

from gainproof.bad_input import unknown_name
from gainproof.location.errors import TooFewError

NONE, EACH, COMMON, CHOSEN = "none", "each", "common", "chosen"
"""Biases of the ranges: none, one for each, one common one, one for each that a test chooses."""


@dataclass(frozen=True)
class Method:
    """One method: the observations that it uses and its biases.

    Its unknowns are position, with range rates velocity, and the biases. source: the equations of
    kosuge-doppler.
    """

    name: str
    title: str
    uses_ranges: bool
    uses_rates: bool
    bias: str
    source: str

    def unknowns(self, dimension: int) -> int:
        """Of position and velocity."""
        return dimension * (2 if self.uses_rates else 1)


METHODS = (
    Method(
        "unknown-reduction",
        "bias detection, then only the biases that a test finds",
        True,
        True,
        CHOSEN,
        "(57)-(67)",
    ),
    Method(
        "bias-detection", "every range has a bias of its own", True, True, EACH, "(30)-(34), (40)"
    ),
    Method("doppler-only", "range rates alone", False, True, NONE, "(26)-(29)"),
    Method("range-doppler", "ranges and range rates, no bias", True, True, NONE, "(62)-(63)"),
    Method("common-bias", "ranges with one common bias, range rates", True, True, COMMON, "[14]"),
    Method("range-only", "ranges alone: position without velocity", True, False, NONE, "(11)"),
)


def method_of(name: str) -> Method:
    """BadInputError, with the nearest names, for one there is not."""
    known = {method.name: method for method in METHODS}
    if name not in known:
        raise unknown_name("method", name, known)
    return known[name]


def require_counts(method: Method, dimension: int, ranges: int, rates: int) -> None:
    """TooFewError where the observations are fewer than the unknowns, whatever the geometry.

    A range with a bias of its own says nothing of position and velocity: it is not counted, nor is
    its bias.
    """
    free = method.bias in (EACH, CHOSEN)
    have = (ranges if method.uses_ranges and not free else 0) + (rates if method.uses_rates else 0)
    need = method.unknowns(dimension) + (1 if method.bias == COMMON else 0)
    if method.uses_ranges and not ranges:
        raise TooFewError(f"{method.name} needs ranges, there are none", need, have)
    if method.uses_rates and not rates:
        raise TooFewError(f"{method.name} needs range rates, there are none", need, have)
    # ranges say nothing of the velocity
    few_rates = method.uses_rates and rates < dimension
    if have >= need and not few_rates:
        return
    what = "position and velocity" if method.uses_rates else "position"
    what += " and the common bias" if method.bias == COMMON else ""
    if few_rates and have >= need:
        need, have = dimension, rates
        what = "velocity, of which ranges say nothing"
    kinds = _counted(method, free)
    raise TooFewError(
        f"{method.name} in {dimension} dimensions needs at least {need} {kinds} for {what}, "
        f"there are {have}"
        + (" (a range whose bias is unknown does not count)" if free and ranges else ""),
        need,
        have,
    )


def _counted(method: Method, free: bool) -> str:
    if not method.uses_rates:
        return "ranges"
    return "range rates" if free or not method.uses_ranges else "ranges and range rates"
