"""The records of a claim file: source, symbols, settings, claims. `claim_file` makes them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction

from gainproof.verify.judge.formula import Formula, Graph, Reading, Relation

CLAIM_KINDS = (
    "identity",
    "inequality",
    "definition",
    "recursion",
    "limit",
    "implication",
    "equivalence",
    "determines",
    "remark",
)
"""What a claim may be.

* `identity`, `inequality`: the relations hold on the domain, given the setting and its definitions;
* `definition`: nothing to decide but dimensions;
* `recursion`: holds for every sample of the setting's filter, whose states are those of the batch;
* `limit`: what the left side tends to where the one condition with an arrow says;
* `implication`: the relations printed first imply those of the trailing parenthesis (or of the
  right of an arrow);
* `equivalence`: the same in both directions;
* `determines`: each symbol of `about` fixes the others in this setting;
* `remark`: a sentence without decidable content; its note says why.
"""


@dataclass(frozen=True)
class SourceRecord:
    """Bibliographic record; `key` is the short name by which the source is cited."""

    key: str
    title: str
    authors: tuple[str, ...]
    publication: str
    year: int | None = None
    url: str | None = None
    doi: str | None = None
    note: str | None = None


@dataclass(frozen=True)
class Unit:
    """Powers of metre and second. Angles are labels of dimension one."""

    metre: Fraction = Fraction(0)
    second: Fraction = Fraction(0)


@dataclass(frozen=True)
class SymbolEntry:
    """One declared symbol.

    `latex` is the canonical token and the name of the symbol in expression graphs. `role` is

    * `quantity`: the quantity of the setting's model that `quantity` names (see `quantity_names`);
    * `free`: any real number of `unit` for which `domain` holds;
    * `definition`: short for `definition` (one reading or more; each reading has one relation,
      `token = formula`); with `arguments` it is a function, called in graphs as `["call", latex,
      ...]`;
    * `undefined`: printed by the source and never defined by it.
    """

    latex: str
    meaning: str
    role: str
    quantity: str | None = None
    unit: Unit | None = None
    domain: tuple[Relation, ...] = ()
    definition: Formula | None = None
    arguments: tuple[str, ...] = ()
    integer: bool = False


@dataclass(frozen=True)
class OwnModel:
    """Matrices of a user's model, each entry a graph over declared symbols: F, Q, H, R."""

    transition: tuple[tuple[Graph, ...], ...]
    process_noise: tuple[tuple[Graph, ...], ...]
    measurement: tuple[tuple[Graph, ...], ...]
    measurement_noise: tuple[tuple[Graph, ...], ...]


@dataclass(frozen=True)
class Setting:
    """What claims are about.

    `kind` is `steady_state` (`model` is a catalogue name, `search`, or None with `own_model`),
    `growing_memory` (least squares over all samples with a polynomial of `degree`), or `algebra`
    (no model: identities that follow from the definitions). `gain` is `filter`, `predictor` or
    `search` (the source does not say). `symbols` holds every symbol of the file with this setting's
    own declarations put over the file's.
    """

    name: str
    kind: str
    title: str
    symbols: Mapping[str, SymbolEntry]
    model: str | None = None
    own_model: OwnModel | None = None
    degree: int | None = None
    gain: str = "search"
    note: str | None = None


@dataclass(frozen=True)
class Claim:
    """One claim in the order of the source.

    `formula` is None for a claim in words, which `text` paraphrases (`latex` is then empty);
    `about` lists the symbols that a claim of kind `determines` speaks of. `domain` holds the
    relations of the field `domain` (conditions printed in the formula itself stay with the
    readings). `given` are relations taken as hypotheses. `line` is the line of the claim's id in
    the file, 1 for the first.
    """

    id: str
    place: str
    kind: str
    setting: str
    latex: str
    formula: Formula | None
    domain: tuple[Relation, ...] = ()
    domain_text: str | None = None
    given: tuple[Formula, ...] = ()
    about: tuple[str, ...] = ()
    text: str | None = None
    note: str | None = None
    line: int = 1


@dataclass(frozen=True)
class ClaimFile:
    """A whole claim file, checked."""

    path: str
    source: SourceRecord
    symbols: Mapping[str, SymbolEntry]
    settings: Mapping[str, Setting]
    claims: tuple[Claim, ...]


__all__ = [
    "Claim",
    "ClaimFile",
    "Formula",
    "Graph",
    "OwnModel",
    "Reading",
    "Relation",
    "Setting",
    "SourceRecord",
    "SymbolEntry",
    "Unit",
]
