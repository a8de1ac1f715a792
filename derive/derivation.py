"""Derivations: ordered steps, each a sentence, a relation and the reason that makes it follow."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from gainproof.derive.printer.graph import Graph
from gainproof.derive.relation import Relation


class PageError(ValueError):
    """A page that cannot be read; says file, line, what was wanted and what came."""


@dataclass(frozen=True)
class Step:
    """One step.

    `hint` is what the certificate writer needs besides the relation (a form that shows a sign,
    roots, boundary values); it carries no authority: the checker decides from the evidence alone.

    `heading` opens a part of the derivation under this title. A step that `joins` is shown with the
    one before it, whose sentence and reason speak for both. In sentences and reasons a formula
    stands between backticks and `@id` is the number of another step. `essential`: belongs to the
    short way through the page.
    """

    id: str
    sentence: str
    relation: Relation
    reason: str
    tower: str = "main"
    hint: Mapping[str, Any] = field(default_factory=dict)
    shown: bool = True
    heading: str = ""
    joins: bool = False
    essential: bool = False


def joined(
    name: str, relation: Relation, tower: str = "main", hint: Mapping[str, Any] | None = None
) -> Step:
    """A step that is shown with the one before it and shares its sentence and reason."""
    return Step(name, "", relation, "", tower, hint or {}, joins=True)


def kernel_step(
    kernel: str,
    graph: Graph,
    outputs: Mapping[str, Any],
    tower: str = "main",
    name: str = "",
    nodes: Mapping[str, Any] | None = None,
    **hint: Any,
) -> Step:
    """That the outputs of a kernel's graph are what they stand for, checked and not shown.

    `name`: in the id that of the kernel, unless several steps are on one. `nodes`: what nodes of
    the graph stand for besides, by number. `hint`: roots, branches and gaps of named nodes, see
    `algebra.evidence`.
    """
    return Step(
        f"kernel-{name or kernel}".replace("_", "-"),
        f"The kernel {kernel} computes what it says.",
        Relation(
            "program", {"program": kernel, "outputs": outputs} | ({"nodes": nodes} if nodes else {})
        ),
        "Evaluate the kernel's graph as rational functions of the tower.",
        tower,
        {"graph": graph, **hint},
        shown=False,
    )


@dataclass(frozen=True)
class Derivation:
    """The steps of one subject, in order, with the keys of the works they rest on.

    `left_out`: what of a model like this is not here, why, and what to do.
    """

    opening: str
    steps: tuple[Step, ...]
    sources: tuple[str, ...]
    latex: Mapping[str, str] = field(default_factory=dict)
    left_out: str = ""
