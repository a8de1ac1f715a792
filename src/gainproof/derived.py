"""A derived subject as plain data: crosses from the process that derives to the one that shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

Plain = dict[str, Any]


@dataclass(frozen=True)
class DerivedStep:
    """One step: what is said, why it follows, and the relation as plain data.

    `shown`: false for steps that are checked like all others and would only repeat on a page.
    `heading`: the title of the part that the step opens. `joins`: shown with the step before it,
    whose sentence and reason speak for both.
    """

    id: str
    kind: str
    tower: str
    sentence: str
    reason: str
    claim: Plain
    shown: bool = True
    heading: str = ""
    joins: bool = False


@dataclass(frozen=True)
class Derived:
    """One subject of the catalogue.

    `symbols`: LaTeX of the names that occur. `model`: the scaled model, or None. `sources`: records
    of the works this rests on (key, text, rests_on). `kernels`: name, summary, module and
    programs, graph and outputs (with what their errors are relative to) of each.

    What the certificate is expected to prove: `claims`; for the parameters in `domains`, by tower;
    of the `programs`, whose graphs are those that the kernels are printed from; and of what the
    names mean in the towers of its own `certificate`.
    """

    name: str
    title: str
    opening: str
    model: Plain | None
    steps: tuple[DerivedStep, ...]
    symbols: Mapping[str, str]
    sources: tuple[Mapping[str, str], ...]
    kernels: tuple[Mapping[str, Any], ...]
    certificate: Plain
    claims: tuple[Plain, ...]
    domains: Mapping[str, Any]
    programs: Mapping[str, Any]

    def plain(self) -> Plain:
        """As plain data for a JSON file, of which parts are this one's own.

        `dataclasses.asdict` would copy every number of the certificate.
        """
        return {**vars(self), "steps": tuple(dict(vars(step)) for step in self.steps)}


def derived_from(data: Mapping[str, Any]) -> Derived:
    """The inverse of `Derived.plain`. Raises KeyError or TypeError for data of another shape."""
    values = {field.name: data[field.name] for field in fields(Derived)}
    for name in ("sources", "kernels", "claims"):
        values[name] = tuple(values[name])
    values["steps"] = tuple(DerivedStep(**step) for step in values["steps"])
    return Derived(**values)
