"""What is kept of a decision: statement, tower, candidates, places and balls."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from gainproof.verify.judge.exact.box import Box
from gainproof.verify.judge.exact.expression import Expr, walk
from gainproof.verify.judge.exact.expression_graph import rational, read_graph
from gainproof.verify.judge.exact.graph_writing import graph_of
from gainproof.verify.judge.exact.statement import Rel, Statement
from gainproof.verify.judge.exact.truth_survey import Judged, Work
from gainproof.verify.judge.exact.work_limits import Malformed

Data = dict[str, Any]
MOST_STEPS = 20


def certificate_of(work: Work, judged: Sequence[Judged]) -> Data:
    """Everything another program needs to go through the same steps."""
    tower, labels = work.tower, work.labels
    names = {tower.names[i]: n for i, n in zip(tower.free_indices, tower.free, strict=True)}
    if tower.parameter is not None:
        names["x"] = tower.parameter
    label = labels.get(tower.parameter or "", tower.parameter or "")
    return {
        "checked": "replayed",
        "statement": statement_data(work.statement, work.boxes, tower.parameter, labels),
        "variables": {short: labels.get(full, full) for short, full in names.items()},
        "tower": tower.relations_text(),
        "roots": roots_text(work.statement),
        "candidates": [str(factor) for factor in work.factors],
        "places": [
            {
                "place": j.place.text(label),
                "samples": [str(s) for s in j.place.samples[:3]],
                "found": j.truth,
                "balls": list(dict.fromkeys(j.local.steps))[:MOST_STEPS],
            }
            for j in judged
        ],
    }


def roots_text(statement: Statement) -> str:
    """Which root is meant, where that is a convention."""
    exponents = {
        node.fraction.denominator for node in walk(*statement.exprs()) if node.kind == "pow"
    }
    square = "square roots are not negative"
    return f"{square}, cube roots are real, also of negative numbers" if 3 in exponents else square


def statement_data(
    statement: Statement, boxes: Mapping[str, Box], parameter: str | None, labels: Mapping[str, str]
) -> Data:
    """The statement and its domain as plain data."""

    def side(expr: Expr) -> Data:
        return graph_of(expr)

    def relations(rels: Sequence[Rel]) -> list[Data]:
        return [
            {"left": side(r.left), "operator": r.operator, "right": side(r.right)} for r in rels
        ]

    return {
        "relations": relations(statement.relations),
        "conditions": relations(statement.conditions),
        "given": relations(statement.given),
        "connective": statement.connective,
        "needed": [side(e) for e in statement.needed],
        "parameter": parameter,
        "domain": {name: _box_data(box) for name, box in sorted(boxes.items())},
        "labels": {name: labels[name] for name in sorted(boxes) if name in labels},
    }


def _box_data(box: Box) -> Data:
    return {
        "lower": None if box.lower is None else str(box.lower),
        "upper": None if box.upper is None else str(box.upper),
        "lower_open": box.lower_open,
        "upper_open": box.upper_open,
        "integer": box.integer,
        "stated": box.stated,
    }


def statement_from(
    data: Mapping[str, Any],
) -> tuple[Statement, dict[str, Box], str | None, dict[str, str]]:
    """Statement, domain, parameter and labels from plain data. Raises Malformed, KeyError,
    TypeError.
    """

    def relations(entries: Any) -> tuple[Rel, ...]:
        return tuple(
            Rel(e["operator"], read_graph(e["left"]), read_graph(e["right"])) for e in entries
        )

    if data["connective"] not in ("if", "iff"):
        raise Malformed(f"unknown connective {data['connective']!r}")
    statement = Statement(
        relations(data["relations"]),
        relations(data["conditions"]),
        data["connective"],
        tuple(read_graph(e) for e in data["needed"]),
        relations(data["given"]),
    )
    boxes = boxes_from(data["domain"])
    return statement, boxes, data["parameter"], dict(data["labels"])


def boxes_from(data: Mapping[str, Any]) -> dict[str, Box]:
    """Domains by name. Raises Malformed, KeyError, TypeError."""
    return {name: _box(entry) for name, entry in data.items()}


def _box(entry: Mapping[str, Any]) -> Box:
    lower, upper = (None if entry[k] is None else rational(entry[k]) for k in ("lower", "upper"))
    flags = {k: bool(entry[k]) for k in ("lower_open", "upper_open", "integer", "stated")}
    return Box(lower=lower, upper=upper, **flags)
