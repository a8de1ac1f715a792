"""What has to be positive, or other than 0, so that an expression is a real number.

Rewriting may cancel the place where it is none: log(x - 2) + log(x - 3) is not log((x - 2)(x - 3))
where both are negative, and tan(x) cos(x) is not sin(x) where cos(x) = 0. So this is asked of the
expression as it came, of each part.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import sympy as sp

from gainproof.derive.stable_form.root_tower import Reading

_DIVISORS: Mapping[Any, Callable[[sp.Expr], sp.Expr]] = {
    sp.tan: sp.cos,
    sp.sec: sp.cos,
    sp.cot: sp.sin,
    sp.csc: sp.sin,
    sp.coth: sp.sinh,
}


@dataclass(frozen=True)
class Requirement:
    """`value` is positive, or with `either` positive or negative everywhere; `reason` in words."""

    value: sp.Expr
    either: bool
    reason: str


@dataclass(frozen=True)
class Required:
    """A value that is positive over `reading`, which a rule rests on or what came: `reason`."""

    name: str
    value: sp.Expr
    reading: Reading
    reason: str


def requirements(expression: sp.Expr) -> Iterator[Requirement]:
    """Those of logarithms, roots, divisors and poles; functions that are not listed have none."""
    for part in sp.preorder_traversal(expression):
        if isinstance(part, sp.log):
            yield Requirement(part.args[0], False, "a logarithm is taken of it")
        elif type(part) in _DIVISORS:
            divisor = _DIVISORS[type(part)](part.args[0])
            yield Requirement(divisor, True, f"{part} is divided by it")
        elif isinstance(part, sp.Pow) and not part.exp.is_Integer:
            yield Requirement(part.base, False, "a root is taken of it")
        elif isinstance(part, sp.Pow) and part.exp < 0:
            yield Requirement(part.base, True, "it is a divisor")
