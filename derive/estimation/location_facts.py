"""What proofs on location use again and again: inverses of the noise, of its blocks, of gram."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, TypeVar

from gainproof.derive.estimation.location_setting import (
    DOPPLER,
    LOCATION,
    POSITIVE,
    RANGE,
    V,
)
from gainproof.derive.words.expression import ZERO, Expression, symbol
from gainproof.derive.words.search import Search
from gainproof.derive.words.statement import (
    Square,
    Statement,
    prove_equal,
    prove_invertible,
    prove_order,
)

Kept = TypeVar("Kept")


@dataclass(frozen=True)
class Found:
    """What several steps rest on, each proof found once."""

    made: dict[Callable[[Found], Any], Any] = field(default_factory=dict)

    def of(self, find: Callable[[Found], Kept]) -> Kept:
        """What this function finds."""
        if find not in self.made:
            self.made[find] = find(self)
        kept: Kept = self.made[find]
        return kept


@dataclass(frozen=True)
class Known:
    """A symmetric positive definite letter, its inverse, and that this is symmetric."""

    positive: Statement
    regular: Statement
    symmetric: Statement

    @property
    def equations(self) -> list[Statement]:
        """What rewriting uses."""
        return [self.regular, self.symmetric]

    @property
    def all(self) -> list[Statement]:
        """In their order."""
        return [self.positive, self.regular, self.symmetric]


def weight(_: Found) -> list[Statement]:
    """V^-1 exists, is symmetric and positive definite."""
    regular = prove_invertible(
        "location-noise-regular", Search(LOCATION, [POSITIVE]), "noise", POSITIVE
    )
    turned = prove_equal(
        "location-weight-symmetric",
        Search(LOCATION, [POSITIVE], [regular], rounds=1),
        V.inverse.T,
        V.inverse,
    )
    positive = prove_order(
        "location-weight-definite",
        Search(LOCATION, [POSITIVE], [regular, turned]),
        V.inverse,
        ZERO,
        [Square(V.inverse, POSITIVE, left_inverse=V)],
        strict=True,
    )
    return [regular, turned, positive]


def known(
    letter: str,
    squares: list[Square],
    search: Search,
    symmetric_by: list[Statement] | None = None,
) -> Known:
    """The letter is positive definite by these squares; its inverse."""
    name = letter.replace("_", "-").lower()
    positive = prove_order(f"{name}-definite", search, symbol(letter), ZERO, squares, strict=True)
    regular = prove_invertible(
        f"{name}-regular", Search(LOCATION, using=[positive]), letter, positive
    )
    using = [*(symmetric_by or []), regular]
    turned = prove_equal(
        f"{name}-inverse-symmetric",
        Search(LOCATION, [POSITIVE], using, rounds=1),
        symbol(letter).inverse.T,
        symbol(letter).inverse,
    )
    return Known(positive, regular, turned)


def block(letter: str, rows: Expression, middle: object, using: list[Statement]) -> Known:
    """A block on the diagonal of V or V^-1."""
    squares = [Square(rows, middle, left_inverse=rows.T)]
    symmetric = [s for s in using if s.kind == "matrix_equal"]
    return known(letter, squares, Search(LOCATION, [POSITIVE], using), symmetric)


def noise_blocks(found: Found) -> dict[str, Known]:
    """V_l, V_d and G11, positive definite."""
    made = found.of(weight)
    return {
        "range": block("range_noise", RANGE, POSITIVE, []),
        "doppler": block("doppler_noise", DOPPLER, POSITIVE, []),
        "G11": block("G11", RANGE, made[2], made),
    }
