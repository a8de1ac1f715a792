"""Sizes of matrices: whole numbers of names, such as 6 + n - n_b."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Size:
    """constant + sum of factor * name; `terms` are sorted by name and have no factor 0."""

    constant: int = 0
    terms: tuple[tuple[str, int], ...] = ()

    def __add__(self, other: Size) -> Size:
        total = dict(self.terms)
        for name, factor in other.terms:
            total[name] = total.get(name, 0) + factor
        kept = tuple(sorted((name, factor) for name, factor in total.items() if factor))
        return Size(self.constant + other.constant, kept)

    def __sub__(self, other: Size) -> Size:
        return self + other.times(-1)

    def times(self, factor: int) -> Size:
        """So many times the size."""
        terms = tuple((name, factor * each) for name, each in self.terms if factor)
        return Size(factor * self.constant, terms)

    @property
    def is_never_negative(self) -> bool:
        """Whether it is at least 0 whatever numbers from 0 on the names stand for."""
        return self.constant >= 0 and all(factor >= 0 for _, factor in self.terms)

    def value(self, names: Mapping[str, int]) -> int:
        """The number for these values of the names."""
        return self.constant + sum(factor * names[name] for name, factor in self.terms)

    def __str__(self) -> str:
        parts = [
            ("-" if factor < 0 else "+", name if abs(factor) == 1 else f"{abs(factor)} {name}")
            for name, factor in self.terms
        ]
        if self.constant or not parts:
            parts.insert(0, ("-" if self.constant < 0 else "+", str(abs(self.constant))))
        first = ("-" if parts[0][0] == "-" else "") + parts[0][1]
        return first + "".join(f" {sign} {text}" for sign, text in parts[1:])


ZERO, ONE = Size(), Size(1)
Shape = tuple[Size, Size]


@dataclass(frozen=True)
class Sizes:
    """The names of sizes in terms of steps, which are any numbers from 0 on: with n_b <= n the
    steps are n_b and n - n_b. `names`: each name in steps; `steps`: each step in names.
    """

    names: Mapping[str, Size] = field(default_factory=dict)
    steps: Mapping[str, Size] = field(default_factory=dict)

    def shown(self, size: Size) -> str:
        """A size over steps, in names."""
        total = Size(size.constant)
        for step, factor in size.terms:
            total = total + self.steps[step].times(factor)
        return str(total)


def sizes_of(chains: tuple[tuple[str, ...], ...]) -> Sizes:
    """Sizes of which each chain is ascending; no name is in two of them."""
    names: dict[str, Size] = {}
    steps: dict[str, Size] = {}
    for chain in chains:
        before, at_most = ZERO, ZERO
        for name in chain:
            own = Size(0, ((name, 1),))
            step = str(own - before) if before.terms else name
            steps[step] = own - before
            at_most = at_most + Size(0, ((step, 1),))
            names[name] = at_most
            before = own
    return Sizes(names, steps)
