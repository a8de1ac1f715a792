"""A derived subject as plain data: crosses from the process that derives to the one that shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

Plain = dict[str, Any]


@dataclass(frozen=True, repr=False)
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

    def __repr__(self) -> str:
        return f"<step {self.id}: {self.kind} in {self.tower}>"

    def __str__(self) -> str:
        """The sentence and the relations, names as the certificate has them."""
        from gainproof.formulas.formula_text import formula_text
        from gainproof.formulas.prose import plain_prose
        from gainproof.formulas.relation_text import Writer, relation_lines

        writer = Writer({}, formula_text, plain=plain_prose)
        shown = [f"    {line}" for line in relation_lines(self.kind, self.claim, writer)]
        # a step that joins the one before it has no sentence of its own
        return "\n".join([plain_prose(self.sentence), *shown] if self.sentence else shown)


@dataclass(frozen=True, repr=False)
class Derived:
    """One subject of the catalogue; `repr` is one line.

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

    def __repr__(self) -> str:
        return f"<derivation {self.name}: {len(self.steps)} steps>"

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
