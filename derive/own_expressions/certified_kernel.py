"""One kernel with what a certificate says of it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from typing import Any

from gainproof.derive.derivation import Step
from gainproof.derive.own_expressions.expressions import ExpressionKernel
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Kernel
from gainproof.derive.relation import described
from gainproof.derive.subject import Program


@dataclass(frozen=True)
class Ready:
    """A tower as plain data, for statements whose evidence is plain data too."""

    plain: Mapping[str, Any]

    def data(self, _spoken: Collection[str] | None = None, /) -> dict[str, Any]:
        """All of it, whatever is spoken of."""
        return dict(self.plain)


@dataclass(frozen=True)
class Formed:
    """The kernel that is printed; towers and programs by name, and the steps over them, each with
    its evidence. `held` are those of the programs that are the kernel's graph, or parts of it.
    """

    kernel: Kernel
    towers: Mapping[str, Ready]
    programs: Mapping[str, Program]
    steps: tuple[Step, ...]
    held: Callable[[Kernel], Mapping[str, Graph]]


def first_step(given: ExpressionKernel, tower: str) -> Step:
    """What is to be computed."""
    formulas = "; ".join(f"{each.quantity.name} = {each.expression}" for each in given.outputs)
    return Step(
        f"given-{given.name.replace('_', '-')}",
        f"{given.title.removesuffix('.')}, as its author writes it.",
        described(formulas),
        "This is the definition. The units of what is added agree, and those of both sides.",
        tower=tower,
        hint={"evidence": {}},
        heading=given.name,
    )
