"""True claims written in other ways: both sides expanded, factored, brought over one denominator,
freed of roots below the line, swapped; definitions put in; all symbols renamed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy
from mutation.tree import Tree, parts, symbols, to_graph, to_tree

from claim_campaign.renamed import renamed
from claim_campaign.subject import Subject
from gainproof.verify.judge.claim.record import Claim, Setting
from gainproof.verify.judge.formula import Reading
from gainproof.verify.judge.formula import Relation as Printed

Change = Callable[[Any], Any]
CHANGES: Mapping[str, Change] = {
    "expanded": sympy.expand,
    "factored": sympy.factor,
    "one fraction": sympy.together,
    "rationalised": sympy.radsimp,
}
SWAPPED = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
MOST_PARTS = 400
"""Of a formula after a change."""
PLAIN_KINDS = {"number", "symbol", "add", "mul", "div", "neg", "pow"}


class NotPlain(Exception):
    """A formula with more than arithmetic in it, which is not given to SymPy."""


def rewrites(subject: Subject) -> Iterator[tuple[str, Claim, Setting]]:
    """Name, claim and setting of every rewriting that changes something."""
    claim, setting = subject.claim, subject.printed
    yield "symbols renamed", *renamed(claim, setting)
    if claim.formula is None:
        return
    (reading,) = claim.formula.readings
    for name, change in CHANGES.items():
        try:
            other = _each(reading, lambda tree, c=change: _through_sympy(tree, c))  # type: ignore[misc]
        except NotPlain:
            continue
        if other != reading:
            yield name, _with(claim, other), setting
    if all(r.operator != "->" for r in reading.relations):
        yield "sides swapped", _with(claim, _turned(reading)), setting
    other = _each(reading, lambda tree: _inlined(tree, subject))
    if other != reading:
        yield "definitions put in", _with(claim, other), setting


def _with(claim: Claim, reading: Reading) -> Claim:
    assert claim.formula is not None
    return replace(claim, formula=replace(claim.formula, readings=(reading,)))


def _each(reading: Reading, change: Callable[[Tree], Tree]) -> Reading:
    def side(graph: Any) -> Any:
        tree = to_tree(graph)
        other = change(tree)
        return graph if other == tree else to_graph(other)

    relations = tuple(
        r if _is_end(r) else replace(r, left=side(r.left), right=side(r.right))
        for r in reading.relations
    )
    return replace(reading, relations=relations)


def _is_end(relation: Printed) -> bool:
    """Whether the relation says where something tends to, and it is no number."""
    return "infinity" in symbols(to_tree(relation.right))


def _turned(reading: Reading) -> Reading:
    relations = tuple(
        replace(
            r,
            operator=SWAPPED.get(r.operator, r.operator),
            left=r.right,
            right=r.left,
            left_decimals=r.right_decimals,
            right_decimals=r.left_decimals,
        )
        for r in reading.relations
    )
    return replace(reading, relations=relations)


def _inlined(tree: Tree, subject: Subject) -> Tree:
    definitions = subject.definitions()
    for part, graft in parts(tree):
        if part[0] in ("derivative", "at") or part[:2] == ("call", "sum"):
            return tree  # these bind names
        if part[0] == "symbol" and part[1] in definitions and not definitions[part[1]].arguments:
            made = graft(definitions[part[1]].body)
            if sum(1 for _ in parts(made)) > MOST_PARTS:
                return tree
            return _inlined(made, subject)
    return tree


def _through_sympy(tree: Tree, change: Change) -> Tree:
    if any(part[0] not in PLAIN_KINDS for part, _ in parts(tree)):
        raise NotPlain
    names = {name: f"v{number}" for number, name in enumerate(sorted(symbols(tree)))}
    back = {plain: name for name, plain in names.items()}
    result = change(_to_sympy(tree, names))
    if sympy.count_ops(result) > MOST_PARTS or result.has(sympy.nan, sympy.zoo, sympy.I):
        raise NotPlain
    return _from_sympy(result, back)


def _to_sympy(tree: Tree, names: Mapping[str, str]) -> Any:
    match tree[0]:
        case "number":
            return sympy.Rational(tree[1].numerator, tree[1].denominator)
        case "symbol":
            return sympy.Symbol(names[tree[1]], real=True)
        case "pow":
            power = sympy.Rational(tree[2].numerator, tree[2].denominator)
            return _to_sympy(tree[1], names) ** power
    inner = [_to_sympy(part, names) for part in tree[1:]]
    match tree[0]:
        case "add":
            return sympy.Add(*inner)
        case "mul":
            return sympy.Mul(*inner)
        case "div":
            return inner[0] / inner[1]
        case _:
            return -inner[0]


def _from_sympy(expr: Any, names: Mapping[str, str]) -> Tree:
    if expr.is_Rational:
        return ("number", Fraction(int(expr.p), int(expr.q)))
    if expr.is_Symbol:
        return ("symbol", names[expr.name])
    if expr.is_Pow and expr.exp.is_Rational:
        return ("pow", _from_sympy(expr.base, names), Fraction(int(expr.exp.p), int(expr.exp.q)))
    inner = [_from_sympy(part, names) for part in expr.args]
    if expr.is_Add:
        return ("add", *inner)
    if expr.is_Mul:
        return ("mul", *inner)
    if isinstance(expr, sympy.Abs):
        return ("call", "abs", *inner)
    raise NotPlain
