"""Settings of a claim file: which model and which convention claims are about."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.claim_errors import FileText
from gainproof.verify.judge.claim_fields import Fields
from gainproof.verify.judge.claim_record import OwnModel, Setting, SymbolEntry
from gainproof.verify.judge.claim_symbols import complete_symbols, read_declarations
from gainproof.verify.judge.formula import Graph
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.reader import read_expression

MOST_SETTINGS = 100
MOST_STATES = 12
MOST_DEGREE = 8
SETTING_KINDS = ("steady_state", "growing_memory", "algebra")
GAIN_CONVENTIONS = ("filter", "predictor", "search")
_MATRICES = ("transition", "process_noise", "measurement", "measurement_noise")


def read_settings(
    text: FileText, table: object, shared: Mapping[str, SymbolEntry]
) -> dict[str, Setting]:
    """All settings by name; `shared` are the symbols of the file's own table."""
    if not isinstance(table, Mapping) or not table:
        raise text.error("settings", "at least one table [settings.NAME] is wanted")
    if len(table) > MOST_SETTINGS:
        raise text.error("settings", f"more than {MOST_SETTINGS} settings")
    return {name: _setting(text, name, content, shared) for name, content in table.items()}


def _setting(
    text: FileText, name: str, content: object, shared: Mapping[str, SymbolEntry]
) -> Setting:
    where = f"settings.{name[:80]}"
    fields = Fields(text, where, content, text.line_of_table(where))
    kind = fields.choice("kind", SETTING_KINDS)
    title = fields.required_text("title")
    model = fields.text_or_none("model")
    degree = fields.whole_number("degree", 0, MOST_DEGREE)
    gain = fields.choice("gain", GAIN_CONVENTIONS, default="search")
    note = fields.text_or_none("note")
    matrices = {matrix: fields.take(matrix) for matrix in _MATRICES}
    own_symbols = fields.take("symbols")
    fields.finish()
    _check_kind(fields, kind, model, degree, matrices)
    symbols = _symbols(text, where, own_symbols, shared)
    return Setting(
        name=name,
        kind=kind,
        title=title,
        symbols=symbols,
        model=model,
        own_model=_own_model(fields, matrices, symbols),
        degree=degree,
        gain=gain,
        note=note,
    )


def _check_kind(
    fields: Fields,
    kind: str,
    model: str | None,
    degree: int | None,
    matrices: Mapping[str, object],
) -> None:
    given = [name for name, matrix in matrices.items() if matrix is not None]
    if given and len(given) < len(_MATRICES):
        missing = next(name for name in _MATRICES if name not in given)
        raise fields.fail(missing, "this matrix is missing: a model has four")
    if kind == "steady_state" and (model is None) == (not given):
        raise fields.fail("model", "wanted: either `model` or the four matrices of a model")
    if kind != "steady_state" and (model is not None or given):
        raise fields.fail("model", f"a setting of kind {kind} has no model")
    if kind == "growing_memory" and degree is None:
        raise fields.fail("degree", "this field is missing: the degree of the polynomial")
    if kind != "growing_memory" and degree is not None:
        raise fields.fail("degree", f"a setting of kind {kind} has no degree")


def _symbols(
    text: FileText, where: str, table: object, shared: Mapping[str, SymbolEntry]
) -> dict[str, SymbolEntry]:
    place = f"{where}.symbols"
    if table is None:
        return dict(shared)
    own = read_declarations(text, place, table, text.line_of_table(place) or 1)
    return complete_symbols(text, own, shared)


def _own_model(
    fields: Fields, matrices: Mapping[str, object], symbols: Mapping[str, SymbolEntry]
) -> OwnModel | None:
    if matrices["transition"] is None:
        return None
    read: dict[str, tuple[tuple[Graph, ...], ...]]
    read = {name: _matrix(fields, name, matrices[name], symbols) for name in _MATRICES}
    states, measured = len(read["transition"]), len(read["measurement"])
    wanted = {
        "transition": (states, states),
        "process_noise": (states, states),
        "measurement": (measured, states),
        "measurement_noise": (measured, measured),
    }
    for name, (rows, columns) in wanted.items():
        found = (len(read[name]), min(map(len, read[name])))
        if found != (rows, columns):
            shape = f"{found[0]} by {found[1]}"
            raise fields.fail(name, f"wanted {rows} by {columns}, but it is {shape}")
    return OwnModel(**read)


def _matrix(
    fields: Fields, name: str, value: object, symbols: Mapping[str, SymbolEntry]
) -> tuple[tuple[Graph, ...], ...]:
    problem = f"a list of 1 to {MOST_STATES} rows of formulas, all of one length, is wanted"
    if not isinstance(value, list) or not 1 <= len(value) <= MOST_STATES:
        raise fields.fail(name, problem)
    rows: list[tuple[Graph, ...]] = []
    for row in value:
        if not isinstance(row, list) or not 1 <= len(row) <= MOST_STATES:
            raise fields.fail(name, problem)
        if len(row) != len(value[0]) or not all(isinstance(entry, str) for entry in row):
            raise fields.fail(name, problem)
        rows.append(tuple(_entry(fields, name, entry, symbols) for entry in row))
    return tuple(rows)


def _entry(fields: Fields, name: str, entry: str, symbols: Mapping[str, SymbolEntry]) -> Graph:
    try:
        graph, *others = read_expression(entry, symbols)
    except ReaderError as error:
        where = f"{fields.where}.{name}"
        raise fields.text.formula_error(where, entry, error, fields.line) from error
    if others:
        raise fields.fail(name, f"{entry[:80]!r} has two readings: write \\frac")
    return graph
