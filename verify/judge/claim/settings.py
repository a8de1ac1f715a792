"""Settings of a claim file: which model and which convention claims are about."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

from gainproof.verify.judge.claim.declarations import read_declarations
from gainproof.verify.judge.claim.empty_domains import contradiction, relations_of
from gainproof.verify.judge.claim.errors import ClaimFileError, FileText
from gainproof.verify.judge.claim.fields import Fields, nearest_hint
from gainproof.verify.judge.claim.formulas import formula_of
from gainproof.verify.judge.claim.models import (
    GAIN_MATRICES,
    MATRICES,
    Rows,
    read_gain_matrices,
    read_own_model,
)
from gainproof.verify.judge.claim.record import Formula, Setting, SymbolEntry
from gainproof.verify.judge.claim.symbols import SymbolTable, complete_symbols
from gainproof.verify.judge.claim.usual_letters import usual_letters
from gainproof.verify.judge.claim.usual_meanings import USUAL, usual_entries
from gainproof.verify.judge.dimensions.declarations import (
    Fault,
    numbers_count,
    says_units,
    setting_fault,
)
from gainproof.verify.judge.matrices.declarations import read_letters, read_sizes

MOST_SETTINGS = 100
MOST_DEGREE = 8
SETTING_KINDS = (
    "steady_state",
    "growing_memory",
    "fading_memory",
    "kalman_bucy",
    "fixed_gain",
    "algebra",
    "matrices",
)
OWN = ("steady_state", "kalman_bucy")
"""The kinds that may have four matrices of their own."""
FITTED = ("growing_memory", "fading_memory")
"""The kinds of a polynomial fitted to all samples, which has a degree."""
MOST_STATES = 3
MOST_FILTERS = 20
MOST_EQUATIONS = 3
MOST_NAME = 80
CONVENTIONS: Mapping[str, tuple[str, ...]] = {
    "gain": ("filter", "predictor", "search"),
    "third_gain": ("1", "1/2", "2", "search"),
    "power_of_T": ("1", "0", "2", "search"),
    "noise": ("deviation", "variance", "ratio", "search"),
    "index_origin": ("0", "1", "search"),
    "covariance": ("predicted", "updated", "search"),
}
"""What a source may mean by its symbols, the usual first; `search` where it does not say."""
FIXED_NAMES: Mapping[str, tuple[str, tuple[str, ...]]] = {
    "gain": ("gain.", ("filter_gain.",)),
    "third_gain": ("gain.3", ("filter_gain.3", "predictor_gain.3")),
    "power_of_T": ("gain.2", ("filter_gain.2", "predictor_gain.2")),
    "covariance": ("covariance.", ("predicted_covariance.", "updated_covariance.")),
}
"""What a convention acts on, and the quantities beside them on which it never does."""
FIELDS = (
    "kind",
    "title",
    "model",
    "degree",
    "states",
    "filters",
    "note",
    "symbols",
    "sizes",
    *MATRICES,
    *CONVENTIONS,
)
"""Fields of a setting."""


@dataclass(frozen=True)
class ReadSetting:
    """A setting with whose symbols claims are read, and the one in which they can be judged:
    without the symbols that have errors, and None where without them it is none. The symbols
    `usual` are letters that the file does not declare.
    """

    setting: Setting
    judged: Setting | None
    usual: frozenset[str] = frozenset()


def read_settings(
    text: FileText,
    table: object,
    shared: SymbolTable,
    models: Sequence[str] | None = None,
    *,
    usual: bool = False,
) -> dict[str, ReadSetting | None]:
    """All settings by name, None for one that cannot be read; `shared` are the symbols of the
    file's own table, `models` the names of the catalogue, if they are known; `usual` says that
    letters mean what they usually do in all of them. Errors are noted.
    """
    if not isinstance(table, Mapping) or not table:
        raise text.error("settings", "at least one table [settings.NAME] is wanted")
    if len(table) > MOST_SETTINGS:
        raise text.error("settings", f"more than {MOST_SETTINGS} settings")
    found: dict[str, ReadSetting | None] = {}
    for name, content in table.items():
        read = partial(_setting, text, name, content, shared, models, usual)
        found[name] = text.attempt(read, None)
    return found


def _setting(
    text: FileText,
    name: str,
    content: object,
    shared: SymbolTable,
    models: Sequence[str] | None,
    usual: bool,
) -> ReadSetting | None:
    where = f"settings.{name[:80]}"
    noted = text.noted
    fields = Fields(text, where, content, FIELDS, text.line_of_table(where))
    kind = text.attempt(lambda: fields.choice("kind", SETTING_KINDS), "")
    if not kind and fields.has("sizes"):
        return None
    title = text.attempt(lambda: fields.required_text("title"), "")
    model = text.attempt(lambda: fields.text_or_none("model"), None)
    degree = text.attempt(lambda: fields.whole_number("degree", 0, MOST_DEGREE), None)
    note = text.attempt(lambda: fields.text_or_none("note"), None)
    own_symbols = fields.take("symbols")
    if kind == "matrices":
        of_matrices = _of_matrices(fields, name, title, note)
        return ReadSetting(of_matrices, of_matrices if text.noted == noted else None)
    if text.noted == noted:
        text.attempt(lambda: _check_kind(fields, kind, model, degree, models), None)
    errors = text.noted - noted
    letters = usual or own_symbols == USUAL
    symbols, unsaid = _symbols(text, where, own_symbols, shared, (kind, model) if letters else None)
    if own_symbols == USUAL and not errors and not usual_letters(kind, model):
        problem = f"a setting of kind {kind} has no usual letters: declare its symbols"
        text.note(fields.fail("symbols", problem))
        errors = 1
    noted = text.noted

    def built(symbols: Mapping[str, SymbolEntry]) -> Setting:
        return _built(fields, name, kind, title, model, degree, note, symbols)

    def checked(setting: Setting) -> Setting:
        _check(fields, setting, shared.sound)
        return setting

    bare = Setting(name=name, kind=kind or "algebra", title=title, symbols=symbols.symbols)
    setting = bare if errors else text.attempt(lambda: built(symbols.symbols), bare)
    if errors or text.noted > noted:
        return ReadSetting(setting, None)
    if symbols.unsound:
        judged = text.unsaid(lambda: checked(built(symbols.sound)))
        return ReadSetting(setting, judged, unsaid)
    return ReadSetting(setting, text.attempt(lambda: checked(setting), None), unsaid)


def _built(
    fields: Fields,
    name: str,
    kind: str,
    title: str,
    model: str | None,
    degree: int | None,
    note: str | None,
    symbols: Mapping[str, SymbolEntry],
) -> Setting:
    """The setting with these symbols, before it is checked that they agree."""
    is_free = kind == "fixed_gain"
    own_model = None if is_free else read_own_model(fields, symbols)
    gain_matrices = read_gain_matrices(fields, symbols) if is_free else {}
    states = fields.whole_number("states", 1, MOST_STATES)
    _check_noise_size(fields, states, gain_matrices)
    setting = Setting(
        name=name,
        kind=kind,
        title=title,
        symbols=symbols,
        model=model,
        own_model=own_model,
        degree=degree,
        states=states,
        gain_matrices=gain_matrices,
        filters=_filters(fields, symbols),
        note=note,
        matrices=None,
        **_conventions(fields, kind, symbols),
    )
    counted = numbers_count(setting)
    if says_units(setting) and not counted:
        return setting
    free = {t: replace(e, unit=None) if counted or e.quantity else e for t, e in symbols.items()}
    return replace(setting, symbols=free)


def _check(fields: Fields, setting: Setting, shared: Mapping[str, SymbolEntry]) -> None:
    """Domains, conventions and dimensions agree."""
    symbols = setting.symbols
    fault = contradiction(relations_of(symbols, symbols), symbols)
    if fault is not None:
        raise fields.fail("", f"the domains of its symbols contradict one another: {fault}")
    _check_conventions(fields, symbols)
    _check_dimensions(fields, setting, shared)


def _check_dimensions(fields: Fields, setting: Setting, shared: Mapping[str, SymbolEntry]) -> None:
    """What the file declares itself agrees in dimension under some convention that it admits."""
    fault = setting_fault(setting, [token for token in setting.symbols if token not in shared])
    if fault is None:
        return
    if fault.token is None:
        raise fields.fail(fault.field, f"dimensions: {fault.problem}")
    raise symbol_error(fields.text, f"{fields.where}.symbols", fault)


def symbol_error(text: FileText, table: str, fault: Fault) -> ClaimFileError:
    """The error for a symbol of a table whose dimensions contradict one another."""
    token = fault.token or ""
    line = text.line_of_key(token, text.line_of_table(table) or 1)
    return text.error(f"{table}.{token}.{fault.field}", f"dimensions: {fault.problem}", line)


def _of_matrices(fields: Fields, name: str, title: str, note: str | None) -> Setting:
    """A setting of letters that are matrices; no symbol of the file's own table is seen in it."""
    for other in fields.given():
        if other not in ("kind", "title", "note", "symbols", "sizes"):
            raise fields.fail(other, "a setting of kind matrices does not take this field")
    where = f"{fields.where}.symbols"
    letters = read_letters(fields.text, where, fields.take("symbols"), read_sizes(fields))
    return Setting(name, "matrices", title, {}, note=note, matrices=letters)


def _conventions(fields: Fields, kind: str, symbols: Mapping[str, SymbolEntry]) -> dict[str, str]:
    """The conventions that the setting states, as texts; whole numbers may stand without quotes.

    One that is not stated is not searched for either, unless a symbol depends on it.
    """
    quantities = {entry.quantity for entry in symbols.values() if entry.quantity}
    found = {
        name: CONVENTIONS[name][0]
        for name in ("gain", "covariance")
        if kind == "kalman_bucy"
        or not any(quantity.startswith(f"{name}.") for quantity in quantities)
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


def _check_conventions(fields: Fields, symbols: Mapping[str, SymbolEntry]) -> None:
    """A convention says what `gain.i` and `covariance.i.j` are; beside names that say it themselves
    it would have no effect, or contradict them.
    """
    quantities = {entry.quantity: entry.latex for entry in symbols.values() if entry.quantity}
    for name, (reached, fixed) in FIXED_NAMES.items():
        said = fields.take(name)
        unusual = str(said) in CONVENTIONS[name][1:]
        if not unusual or any(quantity.startswith(reached) for quantity in quantities):
            continue
        for quantity, token in quantities.items():
            if quantity.startswith(fixed):
                problem = (
                    f"{said!r} does not reach {token}, declared as {quantity}, which is always "
                    f"that: declare it as {quantity[quantity.index(reached) :]}"
                )
                raise fields.fail(name, problem)


def _check_kind(
    fields: Fields,
    kind: str,
    model: str | None,
    degree: int | None,
    models: Sequence[str] | None,
) -> None:
    """The fields that say which filter it is are those of the kind; a model is one of `models`."""
    if fields.has("sizes"):
        raise fields.fail("sizes", f"a setting of kind {kind} does not take this field")
    if models is not None and model not in (None, "search", *models):
        hint = nearest_hint(str(model), models) or f"; known are {', '.join(models)}"
        raise fields.fail("model", f"no model is called {str(model)[:80]!r}{hint}")
    given = any(fields.has(name) for name in MATRICES)
    if kind == "fixed_gain":
        _check_free(fields, model, degree)
        return
    for name in ("states", "filters"):
        if fields.has(name):
            raise fields.fail(name, f"a setting of kind {kind} does not take this field")
    if kind == "steady_state" and (model is None) == (not given):
        raise fields.fail("model", "wanted: either `model` or the four matrices of a model")
    if kind == "kalman_bucy" and not given:
        problem = "this matrix is missing: a Kalman-Bucy filter has four"
        raise fields.fail(MATRICES[0], problem)
    for name in CONVENTIONS if kind == "kalman_bucy" else ():
        if fields.has(name):
            raise fields.fail(name, f"a setting of kind {kind} has no such convention")
    if (kind != "steady_state" and model is not None) or (given and kind not in OWN):
        raise fields.fail("model", f"a setting of kind {kind} has no model")
    if kind in FITTED and degree is None:
        raise fields.fail("degree", "this field is missing: the degree of the polynomial")
    if kind not in FITTED and degree is not None:
        raise fields.fail("degree", f"a setting of kind {kind} has no degree")


def _check_free(fields: Fields, model: str | None, degree: int | None) -> None:
    if model is not None or degree is not None or fields.has("measurement_noise"):
        name = "model" if model is not None else "degree" if degree is not None else MATRICES[-1]
        raise fields.fail(name, "a setting of kind fixed_gain does not take this field")
    own = [name for name in GAIN_MATRICES[:2] if fields.has(name)]
    if fields.has("states") == bool(own):
        raise fields.fail("states", "wanted: either `states` or `transition` and `measurement`")
    if len(own) == 1:
        missing = next(name for name in GAIN_MATRICES[:2] if name not in own)
        raise fields.fail(missing, "this matrix is missing")


def _check_noise_size(fields: Fields, states: int | None, matrices: Mapping[str, Rows]) -> None:
    noise = matrices.get("process_noise")
    if states is not None and noise is not None and len(noise) != states:
        raise fields.fail("process_noise", f"wanted {states} by {states}")


def _filters(fields: Fields, symbols: Mapping[str, SymbolEntry]) -> dict[str, tuple[Formula, ...]]:
    """Named filters with the equations between their gains."""
    table = fields.take("filters")
    if table is None:
        return {}
    if not isinstance(table, Mapping) or not 1 <= len(table) <= MOST_FILTERS:
        raise fields.fail("filters", f"a table of 1 to {MOST_FILTERS} named filters is wanted")
    found: dict[str, tuple[Formula, ...]] = {}
    own = Fields(fields.text, f"{fields.where}.filters", table, tuple(table), fields.line)
    for name in table:
        texts = own.texts(name, MOST_EQUATIONS)
        if not texts or len(name) > MOST_NAME:
            raise own.fail(name, "a list of equations between the gains is wanted")
        found[name] = tuple(formula_of(own, name, text, symbols) for text in texts)
        for formula in found[name]:
            relations = [r for reading in formula.readings for r in reading.relations]
            if len(formula.readings) != 1 or any(r.operator != "=" for r in relations):
                raise own.fail(name, "equations with one reading are wanted")
            if formula.readings[0].conditions:
                raise own.fail(name, "an equation without conditions is wanted")
    return found


def _symbols(
    text: FileText,
    where: str,
    table: object,
    shared: SymbolTable,
    filter_of: tuple[str, str | None] | None,
) -> tuple[SymbolTable, frozenset[str]]:
    """All symbols, and which of them are usual letters: none without the kind and the model of a
    filter.
    """
    place = f"{where}.symbols"
    if table is None and filter_of is None:
        return shared, frozenset()
    own = {}
    if table not in (None, USUAL):
        own = read_declarations(text, place, table, text.line_of_table(place) or 1)
    explicit = {**shared.symbols, **{name: one.entry for name, one in own.items()}}
    letters = usual_entries(*filter_of, explicit) if filter_of else {}
    return complete_symbols(text, own, shared, letters), frozenset(letters)
