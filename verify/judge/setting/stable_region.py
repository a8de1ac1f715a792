"""Where a filter with free gains is stable, as its environment carries it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from gainproof.verify.judge.exact.expression import Expr
from gainproof.verify.judge.exact.statement import Rel

if TYPE_CHECKING:
    from gainproof.verify.judge.setting.environment import Environment


@dataclass(frozen=True)
class StableRegion:
    """`relations` between the `gains` hold exactly where the filter is stable. Quantities whose
    names begin with one of `steady` have a value only there. `charted` is the same environment
    over `steps`: as these run through all positive numbers, the gains run through the region once;
    `back` are the steps over the gains.
    """

    relations: tuple[Rel, ...]
    steady: tuple[str, ...]
    gains: tuple[str, ...]
    steps: tuple[str, ...]
    back: Mapping[str, Expr]
    charted: Environment
