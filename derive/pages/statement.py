"""What a line of a step says: the forms of statements, read, printed back, and made relations.

A statement is one of the lines of `FORMS`, where L, R and the like stand for formulas and names.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from gainproof.derive.pages.evaluation import Meanings
from gainproof.derive.pages.formula import Formula, FormulaError, Reader, whole
from gainproof.derive.relation import (
    Relation,
    definition,
    equal,
    increasing_onto,
    limit,
    monotone,
    positive,
    same_sign,
)

FORMS: Mapping[str, str] = {
    "free": "L = R for any NAMES",
    "equal": "L = R",
    "positive": "L > R",
    "order": "L >= R",
    "definite": "M is positive definite",
    "semidefinite": "M is positive semidefinite",
    "symmetric": "M is symmetric",
    "invertible": "M is invertible",
    "full rank": "M has full column rank",
    "where": "where NAME",
    "stable": "gain K is stable in NAME",
    "steady": "gain K is steady in NAME with covariances M and X and index NAME",
    "same sign": "L has the sign of R",
    "onto": "L grows from B to B with NAME",
    "increasing": "L grows with NAME",
    "decreasing": "L falls with NAME",
    "limit": "L -> B as NAME -> B",
    "definition": "L stands for R",
    "sum": "sum of L over NAME from 0 to NAME is R",
}
"""By kind, the first that fits counts. NAMES: names apart by commas; B: a formula or `infinity`."""
CONDITIONS = ("equal", "definite", "semidefinite", "symmetric", "invertible", "full rank")
"""What may stand behind `if`, apart by commas."""


@dataclass(frozen=True)
class Statement:
    """One statement: its form, what stands in it, and the conditions behind `if`."""

    form: str
    parts: tuple[Formula, ...]
    given: tuple[Statement, ...] = ()

    def __str__(self) -> str:
        """As it is written."""
        parts = iter(self.parts)
        words = FORMS[self.form].split()
        text = " ".join(str(next(parts)) if word.isupper() else word for word in words)
        return text + (f" if {', '.join(map(str, self.given))}" if self.given else "")


def read_statement(text: str, primed: frozenset[str] = frozenset()) -> Statement:
    """The statement of a line. Raises FormulaError with what was wanted where no form goes on."""
    return whole(text, primed, _statement)


def _statement(reader: Reader) -> Statement:
    found = _of_forms(reader, tuple(FORMS), ("", "if"))
    given: list[Statement] = []
    while reader.next in ("if", ",") and (reader.next == "if") is not bool(given):
        reader.place += 1
        given.append(_of_forms(reader, CONDITIONS, ("", ",")))
    return replace(found, given=tuple(given))


def _of_forms(reader: Reader, forms: tuple[str, ...], ends: tuple[str, ...]) -> Statement:
    start = reader.place
    errors: list[tuple[int, FormulaError]] = []
    for form in forms:
        reader.place, reader.depth = start, 0
        try:
            return _of_form(reader, form, ends)
        except FormulaError as error:
            errors.append((reader.place, error))
    farthest = max(place for place, _ in errors)
    found = [error for place, error in errors if place == farthest]
    wanted = list(dict.fromkeys(error.wanted for error in found if error.wanted))
    if len(wanted) < 2:
        raise found[0]
    reader.place = farthest
    raise reader.error(" or ".join(wanted))


def _of_form(reader: Reader, form: str, ends: tuple[str, ...]) -> Statement:
    parts = []
    for word in FORMS[form].split():
        if word.isupper():
            parts.append(_part(reader, word))
        else:
            reader.take(word)
    if reader.next not in ends:
        raise reader.error("the end")
    return Statement(form, tuple(parts))


def _part(reader: Reader, word: str) -> Formula:
    if word == "B" and reader.next == "infinity":
        reader.place += 1
        return Formula("name", "infinity")
    if word == "NAME":
        return _name_or_slot(reader)
    if word == "NAMES":
        names = [_name_or_slot(reader)]
        while reader.next == ",":
            reader.place += 1
            names.append(_name_or_slot(reader))
        return Formula("names", "", tuple(names))
    return reader.formula()


def _name_or_slot(reader: Reader) -> Formula:
    return reader.slot() if reader.next == "{" else Formula("name", reader.name())


def relation_of(said: Statement, meanings: Meanings) -> Relation:
    """The relation that it stands for. Raises FormulaError for a name that has no meaning."""
    if said.given or said.form not in _MADE:
        raise FormulaError("only matrices of every size have such statements")
    return _MADE[said.form](meanings, *said.parts)


def _free(meanings: Meanings, left: Formula, right: Formula, names: Formula) -> Relation:
    free = tuple(name for each in names.parts for name in _free_names(meanings, each))
    return equal(meanings.value(left), meanings.value(right), free)


def _free_names(meanings: Meanings, each: Formula) -> list[str]:
    """Quantities by names of the page, or by symbols in a slot."""
    value = meanings.slot(each.text) if each.kind == "slot" else each.text
    if isinstance(value, str):
        return [meanings.symbol(name).name for name in value.split(", ")]
    return [symbol.name for symbol in value]


def _positive(meanings: Meanings, left: Formula, right: Formula) -> Relation:
    value = meanings.value(left)
    return positive(value if right == Formula("number", "0") else value - meanings.value(right))


def _definite(meanings: Meanings, matrix: Formula) -> Relation:
    return Relation("positive_definite", {"matrix": _names(meanings, matrix)})


def _stable(meanings: Meanings, gain: Formula, model: Formula) -> Relation:
    claim = {"model": meanings.model(model.text), "gain": _listed(meanings, gain)}
    return Relation("stable", claim)


def _steady(
    meanings: Meanings,
    gain: Formula,
    model: Formula,
    predicted: Formula,
    updated: Formula,
    index: Formula,
) -> Relation:
    claim = {
        "model": meanings.model(model.text),
        "predicted": _names(meanings, predicted),
        "updated": _names(meanings, updated),
        "gain": _listed(meanings, gain),
        "index": meanings.symbol(index.text).name,
    }
    return Relation("riccati", claim)


def _names(meanings: Meanings, matrix: Formula) -> list[list[str]]:
    """The names of a matrix whose entries are quantities."""
    value = meanings.value(matrix)
    if not isinstance(value, sp.MatrixBase) or not all(x.is_Symbol for x in value.flat()):
        raise FormulaError(f"a matrix of quantities is wanted, {str(matrix)!r} came")
    return [[entry.name for entry in line] for line in value.tolist()]


def _listed(meanings: Meanings, gain: Formula) -> list[Any]:
    """The names of a gain; of several measurements, row by row."""
    listed = _names(meanings, gain)
    if len(listed) > 1 and len(listed[0]) > 1:
        return listed
    return [name for line in listed for name in line]


def _monotone(trend: str) -> Callable[[Meanings, Formula, Formula], Relation]:
    def made(meanings: Meanings, value: Formula, name: Formula) -> Relation:
        return monotone(meanings.value(value), trend, _quantity(meanings, name))

    return made


def _limit(
    meanings: Meanings, value: Formula, at: Formula, name: Formula, point: Formula
) -> Relation:
    if str(point) not in ("0", "infinity"):
        raise FormulaError(f"0 or infinity is wanted behind {name} ->, {point} came")
    variable = _quantity(meanings, name)
    return limit(meanings.value(value), str(point), _end(meanings, at), variable)


def _onto(
    meanings: Meanings, value: Formula, start: Formula, end: Formula, name: Formula
) -> Relation:
    first, last = (_end(meanings, each) for each in (start, end))
    return increasing_onto(meanings.value(value), first, last, _quantity(meanings, name))


def _quantity(meanings: Meanings, name: Formula) -> str:
    """What certificates call a quantity, which a slot may name."""
    name_of = meanings.slot(name.text) if name.kind == "slot" else name.text
    return str(meanings.symbol(name_of))


def _sum(
    meanings: Meanings, summand: Formula, index: Formula, upper: Formula, closed: Formula
) -> Relation:
    claim = {
        "index": meanings.symbol(index.text).name,
        "start": "0",
        "upper": meanings.symbol(upper.text).name,
        "summand": meanings.value(summand),
        "closed": meanings.value(closed),
    }
    return Relation("sum", claim)


def _end(meanings: Meanings, value: Formula) -> Any:
    said = meanings.slot(value.text) if value.kind == "slot" else value.text
    return "infinity" if said == "infinity" else meanings.value(value)


_MADE: Mapping[str, Callable[..., Relation]] = {
    "free": _free,
    "equal": lambda meanings, left, right: equal(meanings.value(left), meanings.value(right)),
    "definition": lambda meanings, left, right: definition(
        meanings.value(left), meanings.value(right)
    ),
    "positive": _positive,
    "definite": _definite,
    "stable": _stable,
    "steady": _steady,
    "same sign": lambda meanings, left, right: same_sign(
        meanings.value(left), meanings.value(right)
    ),
    "onto": _onto,
    "sum": _sum,
    "increasing": _monotone("increasing"),
    "decreasing": _monotone("decreasing"),
    "limit": _limit,
}
