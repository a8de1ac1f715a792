"""A subject: one derivation with its towers, the programs of its kernels and its certificate."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Protocol

import sympy as sp

from gainproof.derive.algebra.evidence import evidence
from gainproof.derive.algebra.plain_data import tower_data
from gainproof.derive.algebra.positive_forms import NoPlainSign
from gainproof.derive.algebra.tower import NoValue, Tower
from gainproof.derive.derivation import Derivation, PageError, Step
from gainproof.derive.model import ScaledModel
from gainproof.derive.printer.graph import Graph, symbols_of
from gainproof.derive.printer.kernel import Kernel, Module
from gainproof.derive.sensors.algebraic_graphs import algebraic

if TYPE_CHECKING:
    from gainproof.derive.pages.derivation import Written

FORMAT = "gainproof certificate 1"


class Spoken(Protocol):
    """What statements speak of, as plain data; `spoken` are the names that occur."""

    def data(self, spoken: Collection[str] | None = None, /) -> dict[str, Any]: ...


def held_whole(kernel: Kernel) -> Mapping[str, Graph]:
    """One program of the kernel's name; of sines and the like what `algebraic` leaves of them.

    A second one where another graph is computed in double-words.
    """
    found = {kernel.name: algebraic(kernel.graph)}
    if kernel.accurate_graph is not None:
        found[in_double_words(kernel.name)] = kernel.accurate_graph
    return found


def in_double_words(kernel: str) -> str:
    """The name of the program that a kernel computes with `accurate=True`."""
    return f"{kernel}_in_double_words"


@dataclass(frozen=True)
class Program:
    """A kernel's graph and the named quantities that its inputs stand for."""

    inputs: Mapping[str, str]
    graph: Graph


@dataclass(frozen=True)
class Subject:
    """What one catalogue entry derives; `model` is None where there is no state-space model.

    `textbook` gives the kernels' outputs as textbooks print them, over the kernel's argument;
    kernels are compared with these forms, never printed from them. `settings`: what statements
    speak of whose evidence is ready, each in place of a tower, such as matrices of every size.
    `held`: what a certificate holds of a kernel's graph, programs by name.
    """

    name: str
    title: str
    model: ScaledModel | None
    derivation: Derivation
    towers: Mapping[str, Tower]
    programs: Mapping[str, Program]
    module: Module
    textbook: Callable[[], Mapping[str, Mapping[str, sp.Expr]]]
    settings: Mapping[str, Spoken] = field(default_factory=dict)
    held: Callable[[Kernel], Mapping[str, Graph]] = held_whole

    @property
    def model_data(self) -> dict[str, Any] | None:
        """The scaled model as plain data."""
        return self.model.data() if self.model else None

    def claims(self) -> list[dict[str, Any]]:
        """What the certificate is expected to prove, in order."""
        return [
            {
                "id": step.id,
                "kind": step.relation.kind,
                "tower": step.tower,
                "claim": step.relation.claim(),
            }
            for step in self.derivation.steps
        ]

    def domains(self) -> dict[str, list[dict[str, Any]]]:
        """The domain of the parameters of each tower."""
        towers = {name: tower_data(tower)["parameters"] for name, tower in self.towers.items()}
        return towers | {name: entry.data()["parameters"] for name, entry in self.settings.items()}

    def certificate(self) -> dict[str, Any]:
        """Towers, programs, and every step's claim with its evidence.

        Raises PageError for a sign that none of the forms tried shows, and for what has no value.
        """
        claims = self.claims()
        return {
            "format": FORMAT,
            "subject": self.name,
            "towers": {
                name: _with_elements(tower_data(tower), self._names(claims, name))
                for name, tower in self.towers.items()
                if any(claim["tower"] == name for claim in claims)
            }
            | {
                name: setting.data(self._names(claims, name))
                for name, setting in self.settings.items()
            },
            "programs": {
                name: {"inputs": dict(program.inputs), "graph": _unnamed(program.graph)}
                for name, program in self.programs.items()
            },
            "statements": [
                {**claim, "evidence": self._evidence(step)}
                for claim, step in zip(claims, self.derivation.steps, strict=True)
            ],
        }

    def _evidence(self, step: Step) -> dict[str, Any]:
        if step.tower in self.settings:
            return dict(step.hint.get("evidence", {}))
        try:
            return evidence(step, self.towers[step.tower])
        except (NoPlainSign, NoValue, ZeroDivisionError) as error:
            raise PageError(
                f"{self.name}, step {step.id}: nothing shows that this is so: {error}"
            ) from error

    def _names(self, claims: list[dict[str, Any]], tower: str) -> set[str]:
        """Every text in the claims of one tower and in the inputs of their programs."""
        found: set[str] = set()
        for claim in claims:
            if claim["tower"] == tower:
                found |= set(_texts(claim["claim"]))
                if claim["kind"] == "program":
                    found |= set(self.programs[claim["claim"]["program"]].inputs.values())
        return found


def page_subject(
    name: str,
    page: Written,
    module: Module,
    graphs: Mapping[str, Graph],
    sources: tuple[str, ...],
    latex: Mapping[str, str] = MappingProxyType({}),
    symbols: Mapping[str, str] = MappingProxyType({}),
) -> Subject:
    """The subject of a page without a model, with what certificates hold of its kernels' graphs.

    `latex`: of names that are no letters. `symbols`: what inputs of kernels stand for that have
    another name.
    """
    return Subject(
        name=name,
        title=page.title,
        model=None,
        derivation=Derivation(page.opening, page.steps, sources, {**page.latex, **latex}),
        towers=page.towers,
        programs={
            kernel: Program({x: symbols.get(x, x) for x in symbols_of(graph)}, graph)
            for kernel, graph in graphs.items()
        },
        module=module,
        textbook=dict,
        settings=page.settings,
    )


def _texts(value: Any) -> Iterator[str]:
    if isinstance(value, str):
        yield value
    elif isinstance(value, Mapping):
        for entry in value.values():
            yield from _texts(entry)
    elif isinstance(value, (list, tuple)):
        for entry in value:
            yield from _texts(entry)


def _with_elements(data: dict[str, Any], names: set[str]) -> dict[str, Any]:
    """Only the elements that a statement names: what proves nothing is not kept."""
    kept = {name: value for name, value in data["elements"].items() if name in names}
    return {**data, "elements": kept}


def _unnamed(graph: Graph) -> dict[str, Any]:
    """The graph without the names of temporaries, which prove nothing."""
    return {"nodes": graph["nodes"], "outputs": graph["outputs"]}
