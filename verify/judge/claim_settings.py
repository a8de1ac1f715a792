"""Settings of a claim file: which model and which convention claims are about."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.verify.judge.claim_errors import FileText
from gainproof.verify.judge.claim_fields import Fields
from gainproof.verify.judge.claim_formulas import graph_in
from gainproof.verify.judge.claim_record import OwnModel, Setting, SymbolEntry
from gainproof.verify.judge.claim_symbols import complete_symbols, read_declarations
from gainproof.verify.judge.formula import Graph

MOST_SETTINGS = 100
MOST_STATES = 12
MOST_DEGREE = 8
SETTING_KINDS = ("steady_state", "growing_memory", "algebra")
CONVENTIONS: Mapping[str, tuple[str, ...]] = {
    "gain": ("filter", "predictor", "search"),
    "third_gain": ("1", "1/2", "2", "search"),
    "power_of_T": ("0", "1", "2", "search"),
    "noise": ("deviation", "variance", "ratio", "search"),
    "index_origin": ("0", "1", "search"),
    "covariance": ("predicted", "updated", "search"),
}
"""What a source may mean by its symbols; `search` where it does not say."""
_MATRICES = ("transition", "process_noise", "measurement", "measurement_noise")
FIELDS = ("kind", "title", "model", "degree", "note", "symbols", *_MATRICES, *CONVENTIONS)
"""Fields of a setting."""


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
    fields = Fields(text, where, content, FIELDS, text.line_of_table(where))
    kind = fields.choice("kind", SETTING_KINDS)
    title = fields.required_text("title")
    model = fields.text_or_none("model")
    degree = fields.whole_number("degree", 0, MOST_DEGREE)
    note = fields.text_or_none("note")
    matrices = {matrix: fields.take(matrix) for matrix in _MATRICES}
    own_symbols = fields.take("symbols")
    _check_kind(fields, kind, model, degree, matrices)
    symbols = _symbols(text, where, own_symbols, shared)
    _check_gain(fields, symbols)
    return Setting(
        name=name,
        kind=kind,
        title=title,
        symbols=symbols,
        model=model,
        own_model=_own_model(fields, matrices, symbols),
        degree=degree,
        note=note,
        **_conventions(fields, symbols),
    )


def _conventions(fields: Fields, symbols: Mapping[str, SymbolEntry]) -> dict[str, str]:
    """The conventions that the setting states, as texts; whole numbers may stand without quotes.

    One that is not stated is not searched for either, unless a symbol depends on it.
    """
    quantities = {entry.quantity for entry in symbols.values() if entry.quantity}
    found = {
        name: CONVENTIONS[name][0]
        for name in ("gain", "covariance")
        if not any(quantity.startswith(f"{name}.") for quantity in quantities)
    }
    for name, choices in CONVENTIONS.items():
        if not fields.has(name):
            continue
        value = fields.take(name)
        if type(value) is int and str(value) in choices:
            found[name] = str(value)
        else:
            found[name] = fields.choice(name, choices)
    return found


def _check_gain(fields: Fields, symbols: Mapping[str, SymbolEntry]) -> None:
    """A convention of gains says what `gain.i` is; beside names that say it themselves it would
    have no effect, or contradict them.
    """
    said = fields.take("gain")
    quantities = {entry.quantity: entry.latex for entry in symbols.values() if entry.quantity}
    if said not in ("predictor", "search") or any(q.startswith("gain.") for q in quantities):
        return
    for quantity, token in quantities.items():
        if quantity.startswith("filter_gain."):
            problem = (
                f"{said!r} does not reach {token}, declared as {quantity}, which is always the "
                f"gain of the filter: declare it as {quantity.removeprefix('filter_')}"
            )
            raise fields.fail("gain", problem)


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
        rows.append(tuple(graph_in(fields, name, entry, symbols) for entry in row))
    return tuple(rows)
