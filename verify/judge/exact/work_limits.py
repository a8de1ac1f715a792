"""How much work the judge accepts, and the errors that say why it stopped."""

from __future__ import annotations

from dataclasses import dataclass


class Undecided(Exception):
    """The method met a limit or a case it does not cover; the text says which."""


class Nowhere(Undecided):
    """The conditions contradict each other: there is no point to say anything of."""

    def __init__(self, why: str = "the conditions hold nowhere on the domain") -> None:
        super().__init__(why)


class Malformed(ValueError):
    """Data that are no expression graph; the text says what was wanted and what came."""


@dataclass(frozen=True)
class Limits:
    """Bounds on size. `precision` is in bits, `tower_degree` the product of the orders of all
    roots; `seconds` are for all cells of several parameters.
    """

    nodes: int = 20_000
    depth: int = 150
    exponent: int = 64
    digits: int = 200
    terms: int = 50_000
    tower_degree: int = 512
    root_count: int = 16
    norm_degree: int = 600
    symbols: int = 40
    precision: int = 4096
    parameters: int = 8
    projection_degree: int = 400
    projection_factors: int = 400
    cells: int = 10_000
    borders: int = 400
    seconds: float = 30.0


DEFAULT_LIMITS = Limits()
