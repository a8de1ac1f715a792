"""The certificate as a whole, read strictly: towers, programs, statements."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from gainproof.verify.certificate import schema
from gainproof.verify.certificate.checked_statement import Case, Program
from gainproof.verify.certificate.graph import (
    AtNode,
    DerivativeNode,
    Graph,
    Symbol,
    read_expression,
    read_graph,
)
from gainproof.verify.certificate.kinds import KINDS
from gainproof.verify.certificate.matrix_words import (
    KINDS as WORD_KINDS,
)
from gainproof.verify.certificate.matrix_words import (
    STATED,
    Setting,
    is_setting,
    prove,
    read_setting,
    stated,
)
from gainproof.verify.certificate.plain_data import Plain
from gainproof.verify.certificate.program_fixed_points import require_bound
from gainproof.verify.certificate.rejection import (
    MAXIMUM_STATEMENTS,
    MalformedError,
    Meter,
    RejectedError,
)
from gainproof.verify.certificate.tower import Tower, read_tower

FORMAT = "gainproof certificate 1"

_FIELDS = ("format", "subject", "towers", "programs", "statements")
_MAXIMUM_TOWERS = 50
_MAXIMUM_PROGRAMS = 200


@dataclass(frozen=True, slots=True)
class Statement:
    """One statement; claim and evidence are read by its kind."""

    id: str
    kind: str
    tower: str
    claim: Plain
    evidence: Plain


@dataclass(frozen=True, slots=True)
class Document:
    """A well-formed certificate whose statements are still to be decided."""

    subject: str
    towers: Mapping[str, Tower | Setting]
    programs: Mapping[str, Program]
    statements: tuple[Statement, ...]

    def decide(self, statement: Statement) -> str:
        """The status "proved", "cited" or "definition". Raises RejectedError otherwise."""
        place = self.towers[statement.tower]
        if isinstance(place, Setting):
            return self._decide_in(place, statement)
        if statement.kind in WORD_KINDS:
            raise RejectedError(f"{statement.id}: a setting of matrices is wanted, not a tower")
        case = Case(
            statement.id,
            statement.claim,
            statement.evidence,
            place,
            self.programs,
        )
        return KINDS[statement.kind](case)

    def _decide_in(self, setting: Setting, statement: Statement) -> str:
        """In a setting of matrices: what stands before the statement may be used, and no more."""
        if statement.kind in STATED:
            return stated(
                setting, statement.kind, statement.id, statement.claim, statement.evidence
            )
        here = [s.id for s in self.statements].index(statement.id)
        earlier = [s for s in self.statements[:here] if s.tower == statement.tower]
        prove(setting, statement, earlier)
        return "proved"

    def require_coherent(self) -> None:
        """Reject two different models, and what no statement depends on."""
        models = [
            (s.id, s.claim["model"])
            for s in self.statements
            if isinstance(s.claim, dict) and "model" in s.claim
        ]
        for identifier, model in models:
            if model != models[0][1]:
                raise RejectedError(f"{identifier}: another model than in {models[0][0]}")
        schema.unused(set(self.towers) - {s.tower for s in self.statements}, "towers", "towers")
        for name, tower in self.towers.items():
            schema.unused(tower.unused(), "names", f"towers.{name}")
        named = [
            s.claim.get("program")
            for s in self.statements
            if s.kind == "program" and isinstance(s.claim, dict)
        ]
        schema.unused({n for n in self.programs if n not in named}, "programs", "programs")


def read_document(value: Plain, meter: Meter) -> Document:
    """Read a certificate. Raises RejectedError where it is not as the format wants it."""
    fields = schema.record(value, _FIELDS, "certificate")
    if fields["format"] != FORMAT:
        raise MalformedError(f"certificate.format: {FORMAT!r} is wanted")
    subject = schema.text(fields["subject"], "certificate.subject")
    towers = read_towers(fields["towers"], meter)
    programs = read_programs(fields["programs"])
    entries = schema.items(fields["statements"], "statements")
    if not 1 <= len(entries) <= MAXIMUM_STATEMENTS:
        raise MalformedError(f"statements: between 1 and {MAXIMUM_STATEMENTS} are wanted")
    statements: list[Statement] = []
    known: set[str] = set()
    for number, entry in enumerate(entries):
        statement = read_statement(entry, towers, f"statements[{number}]")
        if statement.id in known:
            raise MalformedError(f"statements[{number}].id: {statement.id!r} is given twice")
        known.add(statement.id)
        statements.append(statement)
    return Document(subject, towers, programs, tuple(statements))


def read_towers(value: Plain, meter: Meter) -> dict[str, Tower | Setting]:
    """All towers and settings by name."""
    entries = schema.table(value, "towers")
    if len(entries) > _MAXIMUM_TOWERS:
        raise MalformedError(f"towers: more than {_MAXIMUM_TOWERS}")
    return {
        schema.name(name, "towers"): read_place(entry, meter, f"towers.{name}")
        for name, entry in entries.items()
    }


def read_place(value: Plain, meter: Meter, place: str) -> Tower | Setting:
    """A tower, or a setting of matrices."""
    reader = read_setting if is_setting(value) else read_tower
    return reader(value, meter, place)


def read_programs(value: Plain) -> dict[str, Program]:
    """All programs by name; each input must be a symbol of its graph, and each symbol an input."""
    entries = schema.table(value, "programs")
    if len(entries) > _MAXIMUM_PROGRAMS:
        raise MalformedError(f"programs: more than {_MAXIMUM_PROGRAMS}")
    programs: dict[str, Program] = {}
    for name, entry in entries.items():
        place = f"programs.{schema.name(name, 'programs')}"
        fields = schema.record(entry, ("inputs", "graph"), place)
        graph = read_graph(fields["graph"], f"{place}.graph")
        inputs = {
            schema.name(symbol, f"{place}.inputs"): _input(meaning, f"{place}.inputs.{symbol}")
            for symbol, meaning in schema.table(fields["inputs"], f"{place}.inputs").items()
        }
        if any(isinstance(node, DerivativeNode | AtNode) for node in graph.nodes):
            raise MalformedError(f"{place}: a program computes, it does not differentiate")
        require_bound(graph, place)
        symbols = {node.name for node in graph.nodes if isinstance(node, Symbol)}
        schema.unused(set(inputs) - symbols, "inputs", place)
        if symbols - set(inputs):
            raise MalformedError(f"{place}: {sorted(symbols - set(inputs))} are not inputs")
        programs[name] = Program(inputs, graph)
    return programs


def read_statement(value: Plain, towers: Mapping[str, Tower | Setting], place: str) -> Statement:
    """One statement; its kind and its tower must be known."""
    fields = schema.record(value, ("id", "kind", "tower", "claim", "evidence"), place)
    identifier = schema.text(fields["id"], f"{place}.id")
    kind = schema.text(fields["kind"], f"{place}.kind")
    if kind not in KINDS and kind not in WORD_KINDS:
        raise MalformedError(f"{place}.kind: {kind!r} is not a kind of statement")
    tower = schema.name(fields["tower"], f"{place}.tower")
    if tower not in towers:
        raise MalformedError(f"{place}.tower: there is no tower {tower!r}")
    return Statement(identifier, kind, tower, fields["claim"], fields["evidence"])


def _input(value: Plain, place: str) -> str | Graph:
    if isinstance(value, str):
        return schema.name(value, place)
    return read_expression(value, place)
