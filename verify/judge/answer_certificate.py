"""Certificates of answers, which `gainproof.verify.check_answer` decides: one file, without judge.

The evidence of a verdict names its statement in base variables, and what symbols of the source are.
Both are written here as that file reads them, and it decides: what it does not accept is not given
out.
"""

from __future__ import annotations

import contextlib
import re
from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from typing import Any

from gainproof.verify import check_answer
from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.calculus import rebuilt
from gainproof.verify.judge.exact.certificate import boxes_from, statement_from
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of, walk
from gainproof.verify.judge.exact.graph import read_graph
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.limits import Malformed
from gainproof.verify.judge.exact.statement import TURNED, Rel
from gainproof.verify.judge.exact.witness import free_values

Data = dict[str, Any]
Graph = Mapping[str, Any]
UNITS = (1, 2, 6)
"""Parts of angles and exponents that are tried: x/2 beside x needs halves."""
OF_MODEL = re.compile(r"[PKSX]\[\d,\d\]")
"""Entries of a filter's matrices, as the file names them."""


KINDS = ("identity", "inequality", "recursion", "value", "monotone")
"""Claims whose statement is what they say, a slope's sign for `monotone`."""


class NoCertificateError(ValueError):
    """Why there is no certificate."""


def answer_certificate(claim: Mapping[str, Any]) -> Data:
    """The certificate of a claim of `check --json`. Raises NoCertificateError."""
    if claim["verdict"] not in ("proved", "refuted", "conditional"):
        raise NoCertificateError(f"the verdict is {claim['verdict']}")
    if claim["kind"] not in KINDS:
        raise NoCertificateError(f"the claim is of kind {claim['kind']}")
    evidence = claim["evidence"]["certificate"] or {}
    statement = evidence.get("asked", evidence.get("statement"))
    if statement is None:
        method = claim["evidence"]["method"]
        raise NoCertificateError(f"no statement about numbers is kept of what rests on: {method}")
    reason = "no point was found at which it fails"
    try:
        for candidate in _candidates(claim, evidence, statement):
            weaker = candidate["verdict"] == "proved" and not candidate["everywhere"]
            if weaker and reason != check_answer.NO_VALUES:
                continue  # it failed for another reason, and would again
            said = rejected(candidate)
            if said is None:
                return candidate
            reason = said
    except (Malformed, KeyError, TypeError) as error:
        reason = str(error)
    raise NoCertificateError(reason)


def rejected(certificate: Mapping[str, Any]) -> str | None:
    """Why the file does not accept it; None if it does."""
    try:
        check_answer.Certificate(certificate).decide(lambda _: None)
    except Exception as reason:  # noqa: BLE001  as in the file itself
        return str(reason)
    return None


def _candidates(
    claim: Mapping[str, Any], evidence: Mapping[str, Any], data: Mapping[str, Any]
) -> Iterator[Data]:
    """What the claim says, in ways of which one may be accepted, the strongest first."""
    statement, boxes, _, labels = statement_from(data)
    if statement.connective != "if":
        raise Malformed("an equivalence or implication")
    graphs = {**evidence.get("other symbols", {}), **evidence.get("quantities", {})}
    meanings = {t: read_graph(graph) for t, graph in graphs.items()}
    tokens = {e.key: symbol(t) for t, e in meanings.items() if e.kind not in ("symbol", "number")}

    def in_tokens(expr: Expr) -> Expr:
        return rebuilt(expr, lambda node, _: tokens.get(node.key))

    def told(expr: Expr) -> list[Any]:
        """The nodes of a graph, with variables as the source calls them."""
        names = {name: symbol(label) for name, label in labels.items()}
        change = rebuilt(
            expr, lambda node, _: names.get(str(node.value)) if _is_name(node) else None
        )
        return list(graph_of(change)["nodes"])

    def relation(rel: Rel) -> list[Any]:
        return [told(rel.left), rel.operator, told(rel.right)]

    relations = [
        Rel(r.operator, in_tokens(r.left), in_tokens(r.right)) for r in statement.relations
    ]
    needed = [in_tokens(expr) for expr in statement.needed]
    used = symbols_of(*needed, *(side for r in relations for side in (r.left, r.right)))
    letters = {**meanings, **{t: read_graph(g) for t, g in evidence.get("letters", {}).items()}}
    # symbols that stand for the same are one letter in the formula, and a line each
    keys = {meanings.get(name, symbol(name)).key for name in used}
    used |= {token for token, expr in meanings.items() if expr.key in keys}
    others = evidence.get("other symbols", ())
    used |= {token for token in others if symbols_of(meanings[token]) <= {*boxes}}
    letters = {
        token: expr
        for token, expr in letters.items()
        if token in used and labels.get(str(expr.value), expr.value) != token
    }
    for token in evidence.get("of the filter", ()):
        if token not in used:
            raise NoCertificateError(f"{token} of the filter is not kept in the statement")
        if not any(OF_MODEL.fullmatch(name) for name in symbols_of(letters[token])):
            raise NoCertificateError(f"that {token} is of the filter is not kept")
    of_filter = {meanings[token].key for token in evidence.get("of the filter", ())}
    sides = [side for r in statement.domain for side in (r.left, r.right)]
    if any(node.key in of_filter for node in walk(*sides)):
        raise NoCertificateError("a condition on quantities of the filter")
    model: dict[str, list[list[Expr]]] = {}
    if any(OF_MODEL.fullmatch(name) for name in symbols_of(*letters.values())):
        model = {
            name: [[read_graph(graph) for graph in row] for row in rows]
            for name, rows in evidence["model"].items()
        }
        boxes = {**boxes_from(evidence["domain of the model"]), **boxes}
    entries = [entry for rows in model.values() for row in rows for entry in row]
    spoken = symbols_of(*statement.exprs(), *letters.values(), *entries)
    boxes = {name: boxes[name] for name in sorted(spoken) if not OF_MODEL.fullmatch(name)}
    base: Data = {
        "format": check_answer.FORMAT,
        "verdict": "refuted" if claim["verdict"] == "refuted" else "proved",
        "typed": claim["latex"] or str(claim["id"]),
        "convention": claim["convention"],
        "domain": {labels.get(name, name): _interval(box) for name, box in boxes.items()},
        "given": [relation(_turned(r)) for r in statement.domain],
        "model": {n: [[told(e) for e in row] for row in rows] for n, rows in model.items()} or None,
        "letters": [[token, told(expr)] for token, expr in letters.items()],
        "relations": [relation(r) for r in relations],
        "needed": [told(expr) for expr in needed],
    }
    if base["verdict"] == "refuted":
        witness = (claim["evidence"]["witness"] or {}).get("point", {})
        for point in _points(witness, boxes, labels):
            yield {**base, "unit": 1, "everywhere": False, "point": point}
        return
    functions = {
        n[1] for r in base["relations"] for side in (r[0], r[2]) for n in side if n[0] == "call"
    } | {n[1] for _, graph in base["letters"] for n in graph if n[0] == "call"}
    for unit in UNITS if functions else UNITS[:1]:
        for everywhere in (True, False):
            yield {**base, "unit": unit, "everywhere": everywhere}


def _is_name(node: Expr) -> bool:
    return node.kind == "symbol"


def _points(
    witness: Mapping[str, str], boxes: Mapping[str, Box], labels: Mapping[str, str]
) -> Iterator[dict[str, str]]:
    """That of the witness if it is in these variables and rational, then simple ones."""
    names = [labels.get(name, name) for name in boxes]
    with contextlib.suppress(KeyError, ValueError):  # it may be told in other variables
        yield {name: str(Fraction(witness[name])) for name in names}
    for values in free_values(tuple(boxes), boxes):
        yield _named(names, values)


def _named(names: Iterable[str], values: Iterable[Fraction]) -> dict[str, str]:
    return {name: str(value) for name, value in zip(names, values, strict=True)}


def _turned(rel: Rel) -> Rel:
    """With a symbol that is alone on one side on the left."""
    if rel.right.kind == "symbol" and rel.left.kind != "symbol":
        return Rel(TURNED.get(rel.operator, rel.operator), rel.right, rel.left)
    return rel


def _interval(box: Box) -> list[Any]:
    low, high = (None if end is None else str(end) for end in (box.lower, box.upper))
    return [low, box.lower_open, high, box.upper_open, box.integer]
