"""What claims of each kind say besides their formula, and how the formula must look."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from gainproof.verify.judge.claim.fields import Fields
from gainproof.verify.judge.claim.formulas import Symbols, formula_of, graph_in, token_in
from gainproof.verify.judge.claim.record import Claim
from gainproof.verify.judge.claim.vocabulary import LOCATIONS, SENSES, TRENDS
from gainproof.verify.judge.formula import Formula, Graph, Reading

MOST_ABOUT = 20
MOST_ORDER = 64
MOST_FIXED = 3
MOST_SOLUTIONS = 64

WITHOUT_FORMULA = frozenset(
    ("determines", "monotone", "location", "stability", "ordering", "remark")
)
"""Kinds of claims that need no formula: what they say is in their fields, or in words."""

OWN_FIELDS: Mapping[str, tuple[str, ...]] = {
    "determines": ("about",),
    "monotone": ("about", "trend"),
    "asymptotics": ("order",),
    "location": ("polynomial", "variable", "where"),
    "solutions": ("variable", "number"),
    "steady_state": ("recursion", "previous"),
    "stability": ("sense",),
    "optimum": ("minimised", "fixed"),
    "ordering": ("compared", "ascending", "fixed"),
}
"""Fields that only claims of one kind take."""

INEQUALITIES = frozenset(("<", "<=", ">", ">=", "!="))
_OPERATORS = {
    "identity": frozenset(("=",)),
    "definition": frozenset(("=",)),
    "recursion": frozenset(("=",)),
    "steady_state": frozenset(("=",)),
    "location": frozenset(("=",)),
    "solutions": frozenset(("=",)),
    "value": frozenset(("=", "approx")),
    "asymptotics": frozenset(("=", "approx", "sim")),
    "inequality": INEQUALITIES,
    "limit": frozenset(("->", "=")),
}


def kind_of(formula: Formula) -> str:
    """The kind of claim that a formula is, as far as its relations say it."""
    reading = formula.readings[0]
    operators = {relation.operator for relation in reading.relations}
    if reading.connective in ("iff", "implies"):
        return "equivalence" if reading.connective == "iff" else "implication"
    if "->" in operators or any(each.operator == "->" for each in reading.conditions):
        orders = any(
            node[:2] == ["call", "order"]
            for relation in reading.relations
            for node in relation.right["nodes"]
        )
        return "asymptotics" if orders or "sim" in operators else "limit"
    if "approx" in operators:
        return "value"
    return "inequality" if operators & INEQUALITIES else "identity"


def with_own_fields(claim: Claim, fields: Fields, symbols: Symbols) -> Claim:
    """The claim with the fields of its kind. Raises ClaimFileError."""
    allowed = OWN_FIELDS.get(claim.kind, ())
    for names in OWN_FIELDS.values():
        for name in names:
            if fields.has(name) and name not in allowed:
                raise fields.fail(name, f"a claim of kind {claim.kind} does not take this field")
    complete = replace(claim, **_own(claim, fields, symbols))
    if complete.formula is not None:
        _check_formula(fields, complete, complete.formula.readings[0])
    return complete


def _own(claim: Claim, fields: Fields, symbols: Symbols) -> dict[str, Any]:
    match claim.kind:
        case "determines":
            return {"about": _determines(fields, symbols)}
        case "monotone":
            return _monotone(fields, symbols)
        case "asymptotics":
            return {"order": fields.whole_number("order", 0, MOST_ORDER)}
        case "location":
            return _location(claim, fields, symbols)
        case "solutions":
            token = fields.required_text("variable")
            count = fields.whole_number("number", 0, MOST_SOLUTIONS)
            if count is None:
                raise fields.fail("number", "this field is missing: how many real solutions")
            return {"variable": token_in(fields, "variable", token, symbols), "number": count}
        case "steady_state":
            previous = fields.required_text("previous")
            return {
                "recursion": _recursion(fields, symbols),
                "previous": token_in(fields, "previous", previous, symbols),
            }
        case "stability":
            return {"sense": fields.choice("sense", SENSES, SENSES[0])}
        case "optimum":
            return {
                "minimised": _one(fields, "minimised", symbols),
                "fixed": _fixed(fields, symbols),
            }
        case "ordering":
            return _ordering(fields, symbols)
        case _:
            return {}


def _one(fields: Fields, name: str, symbols: Symbols) -> Graph:
    return graph_in(fields, name, fields.required_text(name), symbols)


def _fixed(fields: Fields, symbols: Symbols) -> tuple[Graph, ...]:
    found = fields.texts("fixed", MOST_FIXED)
    if not found:
        raise fields.fail("fixed", "this field is missing: a list of what is the same")
    return tuple(graph_in(fields, "fixed", text, symbols) for text in found)


def _ordering(fields: Fields, symbols: Symbols) -> dict[str, Any]:
    names = fields.texts("ascending", MOST_ABOUT)
    if len(names) < 2 or len(set(names)) < len(names):
        raise fields.fail("ascending", "two or more different filters of the setting are wanted")
    return {
        "minimised": _one(fields, "compared", symbols),
        "ascending": names,
        "fixed": _fixed(fields, symbols),
    }


def _determines(fields: Fields, symbols: Symbols) -> tuple[str, ...]:
    about = tuple(
        token_in(fields, "about", token, symbols) for token in fields.texts("about", MOST_ABOUT)
    )
    if len(set(about)) < 2:
        raise fields.fail("about", "two symbols or more are wanted, each of which fixes the rest")
    return about


def _monotone(fields: Fields, symbols: Symbols) -> dict[str, Any]:
    about = fields.texts("about", 2)
    if len(about) != 2:
        raise fields.fail("about", "wanted: what changes, and the symbol with which it does")
    return {
        "about": (about[0], token_in(fields, "about", about[1], symbols)),
        "subject": graph_in(fields, "about", about[0], symbols),
        "trend": fields.choice("trend", TRENDS),
    }


def _location(claim: Claim, fields: Fields, symbols: Symbols) -> dict[str, Any]:
    polynomial, variable = fields.text_or_none("polynomial"), fields.text_or_none("variable")
    where = fields.choice("where", LOCATIONS) if fields.has("where") else None
    if polynomial is None and claim.formula is None:
        raise fields.fail("polynomial", "wanted: a polynomial, or a formula that lists the roots")
    if (polynomial is None) != (variable is None):
        raise fields.fail("variable", "a polynomial and its variable are wanted together")
    if where is None and (polynomial is None or claim.formula is None):
        raise fields.fail("where", f"this field is missing: one of {', '.join(LOCATIONS)}")
    return {
        "polynomial": polynomial and graph_in(fields, "polynomial", polynomial, symbols),
        "variable": variable and token_in(fields, "variable", variable, symbols),
        "where": where,
    }


def _recursion(fields: Fields, symbols: Symbols) -> Formula:
    formula = formula_of(fields, "recursion", fields.required_text("recursion"), symbols)
    reading = formula.readings[0]
    if len(reading.relations) != 1 or reading.relations[0].operator != "=" or reading.conditions:
        raise fields.fail("recursion", "one equation is wanted: next value = ...")
    return formula


def _check_formula(fields: Fields, claim: Claim, reading: Reading) -> None:
    """The relations of the formula must be such as the kind speaks of."""
    field = "latex" if claim.plain is None else "plain"
    wanted = _OPERATORS.get(claim.kind)
    for relation in reading.relations:
        if wanted is not None and relation.operator not in wanted:
            others = [kind for kind, has in _OPERATORS.items() if relation.operator in has]
            more = f"; kinds that have it: {', '.join(others)}" if others else ""
            problem = f"a claim of kind {claim.kind} has no relation {relation.operator}{more}"
            raise fields.fail(field, problem)
    arrows = [relation for relation in reading.conditions if relation.operator == "->"]
    if claim.kind in ("limit", "asymptotics") and len(arrows) != 1:
        raise fields.fail(
            field, f"a claim of kind {claim.kind} says once where to, such as (k \\to \\infty)"
        )
    if claim.kind in ("implication", "equivalence") and not reading.conditions:
        raise fields.fail(field, f"a claim of kind {claim.kind} has two parts")
    first = reading.relations[0]
    if claim.kind == "value" and first.left_decimals is None and first.right_decimals is None:
        raise fields.fail(
            field, "a claim of kind value has a number on one side, or a matrix of numbers"
        )
