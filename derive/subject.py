"""A subject: one derivation with its towers, the programs of its kernels and its certificate."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from gainproof.derive.algebra.evidence import evidence
from gainproof.derive.algebra.plain import tower_data
from gainproof.derive.algebra.tower import Tower
from gainproof.derive.derivation import Derivation
from gainproof.derive.model import ScaledModel
from gainproof.derive.printer.graph import Graph
from gainproof.derive.printer.kernel import Module

FORMAT = "gainproof certificate 1"


@dataclass(frozen=True)
class Program:
    """A kernel's graph and the named quantities that its inputs stand for."""

    inputs: Mapping[str, str]
    graph: Graph


@dataclass(frozen=True)
class Subject:
    """What one catalogue entry derives. `model` is None for subjects without a state-space model."""

    name: str
    title: str
    model: ScaledModel | None
    derivation: Derivation
    towers: Mapping[str, Tower]
    programs: Mapping[str, Program]
    module: Module

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
        return {name: tower_data(tower)["parameters"] for name, tower in self.towers.items()}

    def certificate(self) -> dict[str, Any]:
        """Towers, programs, and every step's claim with its evidence."""
        used = {step.tower for step in self.derivation.steps}
        return {
            "format": FORMAT,
            "subject": self.name,
            "towers": {
                name: tower_data(tower) for name, tower in self.towers.items() if name in used
            },
            "programs": {
                name: {"inputs": dict(program.inputs), "graph": program.graph}
                for name, program in self.programs.items()
            },
            "statements": [
                {**claim, "evidence": evidence(step, self.towers[step.tower])}
                for claim, step in zip(self.claims(), self.derivation.steps, strict=True)
            ],
        }
