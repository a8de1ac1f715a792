"""Model files: one linear model as text, with the keys of a setting of a claim file.

`docs/steady.md` says what may stand in one. It is untrusted input like a claim file, read by the
same reader: nothing in it is evaluated.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from gainproof.verify.judge.claim.declarations import read_declarations
from gainproof.verify.judge.claim.errors import ClaimFileError, FileText, TooManyError
from gainproof.verify.judge.claim.fields import Fields
from gainproof.verify.judge.claim.file import toml_of
from gainproof.verify.judge.claim.models import MATRICES, Rows, read_matrix, read_own_model
from gainproof.verify.judge.claim.record import OwnModel, Setting, SymbolEntry, Unit
from gainproof.verify.judge.claim.symbols import complete_symbols
from gainproof.verify.judge.claim.units import read_unit, unit_text_of
from gainproof.verify.judge.dimensions.declarations import shared_fault
from gainproof.verify.judge.dimensions.formula import dimension_of, graph_fault, names_of
from gainproof.verify.judge.exact.expression import symbols_of
from gainproof.verify.judge.exact.formula_tree import read_tree

FORMAT = "gainproof model 1"
MOST_NAME = 40
CROSS, START = "cross_noise", "start"
TABLES = ("format", "title", "note", "states", "measurements", "symbols", *MATRICES, CROSS, START)


@dataclass(frozen=True)
class Component:
    """A state or a measurement; `unit` is None where the file says none."""

    name: str
    unit: Unit | None


@dataclass(frozen=True)
class ModelFile:
    """F, H, Q, R as `model`, with the covariance of process and measurement noise as `cross`, None
    where they are not correlated; `start` is that of the first prediction, if the file says it.
    Symbols are free numbers or definitions.
    """

    path: str
    title: str
    symbols: Mapping[str, SymbolEntry]
    model: OwnModel
    cross: Rows | None
    start: Rows | None
    states: tuple[Component, ...]
    measurements: tuple[Component, ...]

    @property
    def setting(self) -> Setting:
        """For the meaning of formulas."""
        return Setting("model", "algebra", self.title, self.symbols)


def read_model_text(text: str, path: str = "model") -> ModelFile:
    """The model file with this text; `path` is used in messages only. Raises ClaimFileError for the
    first error, with all others that were found.
    """
    file_text, parsed = toml_of(text, path)
    found = None
    try:
        found = _model(file_text, Fields(file_text, "model", parsed, TABLES, 1))
    except ClaimFileError as error:
        file_text.found.append(error)
    except TooManyError:
        pass
    if found is None or file_text.found:
        raise file_text.refusal()
    return found


def _model(text: FileText, fields: Fields) -> ModelFile | None:
    version = fields.required_text("format")
    if version != FORMAT:
        raise fields.fail("format", f"wanted {FORMAT!r}, but it is {version[:80]!r}")
    title = fields.required_text("title")
    fields.text_or_none("note")
    line = text.line_of_table("symbols") or 1
    declared = read_declarations(text, "symbols", fields.take("symbols") or {}, line)
    table = complete_symbols(text, declared)
    fault = shared_fault(table.sound)
    if fault is not None:
        raise text.error(f"symbols.{fault.token}.{fault.field}", f"dimensions: {fault.problem}")
    symbols = {token: _number(text, token, entry) for token, entry in table.symbols.items()}
    model = read_own_model(fields, symbols)
    if model is None:
        raise fields.fail(MATRICES[0], "this matrix is missing: a model has four")
    n, m = len(model.transition), len(model.measurement)
    cross, start = (
        read_matrix(fields, name, symbols) if fields.has(name) else None for name in (CROSS, START)
    )
    for name, rows, columns in ((CROSS, cross, m), (START, start, n)):
        if rows is not None and (len(rows), len(rows[0])) != (n, columns):
            shape = f"{len(rows)} by {len(rows[0])}"
            raise fields.fail(name, f"wanted {n} by {columns}, but it is {shape}")
    states = _components(fields, "states", "state", n)
    found = ModelFile(
        text.path,
        title,
        symbols,
        model,
        cross,
        start,
        states,
        _components(fields, "measurements", "measurement", m),
    )
    _check_units(fields, found)
    return None if text.found else found


def _number(text: FileText, token: str, entry: SymbolEntry) -> SymbolEntry:
    """A quantity of a filter is given as a number here, like all others."""
    if entry.role == "undefined" or entry.shape or entry.arguments or entry.variance:
        raise text.error(f"symbols.{token}", "a number or a definition is wanted in a model")
    return replace(entry, role="free", quantity=None) if entry.role == "quantity" else entry


def _components(fields: Fields, field: str, what: str, count: int) -> tuple[Component, ...]:
    """The table `field` of names with units, in the order of the rows; numbered without one."""
    table = fields.take(field)
    if table is None:
        return tuple(Component(f"{what} {i + 1}", None) for i in range(count))
    if not isinstance(table, Mapping) or len(table) != count:
        raise fields.fail(field, f"a table of {count} names with units is wanted, one a {what}")
    found = []
    for name, unit in table.items():
        if not isinstance(unit, str) or len(name) > MOST_NAME or not name.strip():
            raise fields.fail(field, f"{name[:MOST_NAME]!r}: a short name and a unit are wanted")
        try:
            found.append(Component(name, read_unit(unit)))
        except ValueError as error:
            raise fields.fail(field, f"{name}: {error}") from error
    return tuple(found)


def _check_units(fields: Fields, found: ModelFile) -> None:
    """Entries with symbols have the units that their row and column ask for; numbers count in
    them. Raises ClaimFileError.
    """
    own, setting = found.model, found.setting
    z, x = found.measurements, found.states
    shapes = {
        "transition": (own.transition, x, x, -1),
        "measurement": (own.measurement, z, x, -1),
        "process_noise": (own.process_noise, x, x, 1),
        "measurement_noise": (own.measurement_noise, z, z, 1),
        CROSS: (found.cross or (), x, z, 1),
        START: (found.start or (), x, x, 1),
    }
    for name, (rows, left, right, power) in shapes.items():
        for i, row in enumerate(rows):
            for j, entry in enumerate(row):
                place = f"row {i + 1}, column {j + 1}"
                if fault := graph_fault(entry, names_of(setting)):
                    raise fields.fail(name, f"{place}: {fault}")
                unit = dimension_of(entry, setting) if symbols_of(read_tree(entry)) else None
                a, b = left[i].unit, right[j].unit
                if unit is not None and a is not None and b is not None and unit != a * b**power:
                    said, wanted = unit_text_of(unit), unit_text_of(a * b**power)
                    raise fields.fail(name, f"{place} has the unit {said}, wanted is {wanted}")
