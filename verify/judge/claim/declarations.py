"""Declarations of symbols as a claim file has them, each one thing: a quantity of a model, a free
number, short for a formula, or undefined.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from gainproof.verify.judge.claim.errors import FileText
from gainproof.verify.judge.claim.fields import Fields, nearest_hint
from gainproof.verify.judge.claim.record import SymbolEntry, Unit
from gainproof.verify.judge.claim.units import read_unit, unit_text_of
from gainproof.verify.judge.quantity_names import quantity_names
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.printed_names import canonical_token
from gainproof.verify.judge.reader.words import MADE_BY_READER, function_of

MOST_SYMBOLS = 500
MOST_ARGUMENTS = 8
MOST_SIZE = 12
FIELDS = (
    "meaning",
    "quantity",
    "definition",
    "undefined",
    "unit",
    "domain",
    "arguments",
    "integer",
    "shape",
    "variance",
    "distribution",
)
"""Fields of a symbol."""
NORMAL = "normal"
"""The distribution that a noise may be said to have."""
RESERVED = frozenset(("infinity", "select", "and")) | MADE_BY_READER


@dataclass(frozen=True)
class Declaration:
    """A symbol as declared, before the formulas in it are read, since these may use any symbol.
    One that is `broken` has errors: formulas that use it are read with what is known of it, so that
    their own errors are found.
    """

    entry: SymbolEntry
    where: str
    line: int | None
    definition: str | None
    domain: str | None
    variance: str | None
    broken: bool = False


def read_declarations(
    text: FileText, where: str, table: object, start: int = 1
) -> dict[str, Declaration]:
    """The table `where`, whose keys are LaTeX tokens, by canonical token."""
    if not isinstance(table, Mapping):
        raise text.error(where, "a table of symbols is wanted", start)
    if len(table) > MOST_SYMBOLS:
        raise text.error(where, f"{len(table)} symbols, but at most {MOST_SYMBOLS} are read", start)
    found: dict[str, Declaration] = {}
    for token, content in table.items():
        line = text.line_of_key(token, start)
        _read_one(text, f"{where}.{token[:80]}", token, content, line, found)
    return found


def _read_one(
    text: FileText,
    place: str,
    token: str,
    content: object,
    line: int | None,
    found: dict[str, Declaration],
) -> None:
    """Put the declaration of one symbol to those `found`."""
    name = text.attempt(lambda: _canonical(text, place, token, line), "")
    if name in found or name in RESERVED or _is_function(name):
        problem = "is a reserved word" if name in RESERVED else "is the name of a function"
        problem = "is declared twice" if name in found else problem
        text.note(text.error(place, f"the symbol {name} {problem}", line))
        if name in found:
            found[name] = replace(found[name], broken=True)
            return
    if not name or name in RESERVED or _is_function(name):
        text.doubtful.update((token, *token.split()))
        return
    noted = text.noted
    declared = text.attempt(
        lambda: _declaration(Fields(text, place, content, FIELDS, line), name), None
    )
    if declared is None:
        text.doubtful.add(name)
        declared = Declaration(SymbolEntry(name, "", "free"), place, line, None, None, None)
    found[name] = replace(declared, broken=text.noted > noted)


def _is_function(name: str) -> bool:
    """Whether a formula could not tell the symbol from a function, as printed or in plain text."""
    return name == "sqrt" or function_of(name) is not None


def _canonical(text: FileText, place: str, token: str, line: int | None) -> str:
    try:
        return canonical_token(token)
    except ReaderError as error:
        raise text.error(place, f"not a symbol: {error.problem}", line) from error


def _declaration(fields: Fields, name: str) -> Declaration:
    text = fields.text
    meaning = text.attempt(lambda: fields.required_text("meaning"), "")
    roles = [role for role in ("quantity", "definition", "undefined") if fields.has(role)]
    if len(roles) > 1:
        raise fields.fail("", f"both {roles[0]} and {roles[1]}: a symbol is one thing")
    role = roles[0] if roles else "free"
    quantity = fields.text_or_none("quantity")
    definition = fields.text_or_none("definition")
    if fields.has("undefined") and not fields.flag("undefined"):
        raise fields.fail("undefined", "only true can be said here")
    unit_text, domain = fields.text_or_none("unit"), fields.text_or_none("domain")
    arguments = fields.texts("arguments", MOST_ARGUMENTS)
    integer = fields.flag("integer")
    variance = fields.text_or_none("variance")
    if variance is not None and role != "free":
        raise fields.fail("variance", "only a free symbol can be a noise")
    if variance is not None and (integer or domain is not None or fields.has("shape")):
        raise fields.fail(
            "variance", "a noise is any real number: no `domain`, no `integer`, no `shape`"
        )
    normal = _normal(fields, variance)
    if arguments and role != "definition":
        raise fields.fail("arguments", "only a definition can have arguments")
    if role == "free" and unit_text is None:
        text.note(fields.fail("unit", "a free symbol needs a unit, `1` if it has none"))
    entry = SymbolEntry(
        latex=name,
        meaning=meaning,
        role=role,
        quantity=quantity,
        unit=text.attempt(lambda: _unit(fields, unit_text, quantity), None),
        arguments=tuple(
            _canonical(fields.text, f"{fields.where}.arguments", argument, fields.line)
            for argument in arguments
        ),
        integer=integer or quantity == "sample_number",
        shape=_shape(fields),
        normal=normal,
    )
    return Declaration(entry, fields.where, fields.line, definition, domain, variance)


def _normal(fields: Fields, variance: str | None) -> bool:
    said = fields.text_or_none("distribution")
    if said is not None and variance is None:
        raise fields.fail("distribution", "only a noise has one: its variance is missing")
    if said not in (None, NORMAL):
        raise fields.fail("distribution", f"{said[:80]!r} is not known, only {NORMAL!r} is")
    return said is not None


def _shape(fields: Fields) -> tuple[int, int] | None:
    value = fields.take("shape")
    if value is None:
        return None
    whole = isinstance(value, list) and all(type(n) is int and 1 <= n <= MOST_SIZE for n in value)
    if not whole or len(value) != 2:
        problem = f"wanted [rows, columns], whole numbers from 1 to {MOST_SIZE}"
        raise fields.fail("shape", problem)
    return value[0], value[1]


def _unit(fields: Fields, unit_text: str | None, quantity: str | None) -> Unit | None:
    """The unit said, or that of the quantity, which must not contradict it."""
    try:
        said = read_unit(unit_text) if unit_text is not None else None
    except ValueError as error:
        raise fields.fail("unit", str(error)) from error
    if quantity is None:
        return said
    known = quantity_names()
    if quantity not in known:
        hint = nearest_hint(quantity, list(known))
        raise fields.fail("quantity", f"{quantity[:80]!r} is no quantity of a model{hint}")
    unit = known[quantity].unit
    if said is not None and said != unit:
        problem = f"{unit_text!r} contradicts {quantity}, whose unit is {unit_text_of(unit)!r}"
        raise fields.fail("unit", problem)
    return unit
