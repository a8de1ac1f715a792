"""Relations of a certificate as lines of text or LaTeX, by their kind."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.formula_term import Graph

Claim = Mapping[str, Any]


@dataclass(frozen=True)
class Writer:
    """How formulas are written: `formula(graph, names, output)` with these names."""

    names: Mapping[str, str]
    formula: Callable[[Graph, Mapping[str, str], str], str]
    equals: str = "="
    greater: str = ">"
    tends: str = "->"
    infinity: str = "infinity"

    def value(self, graph: Graph | str, output: str = "value") -> str:
        """A graph, or the word for infinity."""
        if isinstance(graph, str):
            return self.infinity if graph == "infinity" else graph
        return self.formula(graph, self.names, output)

    def name(self, symbol: str) -> str:
        """A symbol of the certificate as people write it."""
        return self.value({"nodes": [["symbol", symbol]], "outputs": {"value": 0}})


def relation_lines(kind: str, claim: Claim, writer: Writer) -> list[str]:
    """One line for each formula of a relation; unknown kinds name themselves."""
    return _KINDS.get(kind, _unknown(kind))(claim, writer)


def matrix_rows(rows: Any) -> list[str]:
    """Rows of a matrix of number texts, columns aligned."""
    widths = [max(len(row[j]) for row in rows) for j in range(len(rows[0]))]
    return [
        "[ " + "  ".join(f"{entry:>{w}}" for entry, w in zip(row, widths, strict=True)) + " ]"
        for row in rows
    ]


def _equal(claim: Claim, w: Writer) -> list[str]:
    left, right = claim["left"], claim["right"]
    pairs = _entries(left, right)
    if pairs is not None:
        return [f"{w.value(a)} {w.equals} {w.value(b)}" for a, b in pairs]
    return [f"{w.value(left)} {w.equals} {w.value(right)}"]


def _entries(left: Graph, right: Graph) -> list[tuple[Graph, Graph]] | None:
    """Pairs of entries, where both sides are matrices written out; else None."""
    tops = [graph["nodes"][graph["outputs"]["value"]] for graph in (left, right)]
    if any(top[0] != "matrix" for top in tops):
        return None
    return [
        (_part(left, i), _part(right, j)) for i, j in zip(tops[0][3:], tops[1][3:], strict=True)
    ]


def _part(graph: Graph, number: int) -> Graph:
    return {"nodes": graph["nodes"], "outputs": {"value": number}}


def _positive(claim: Claim, w: Writer) -> list[str]:
    return [f"{w.value(claim['expression'])} {w.greater} 0"]


def _same_sign(claim: Claim, w: Writer) -> list[str]:
    return [f"sign of {w.value(claim['left'])} {w.equals} sign of {w.value(claim['right'])}"]


def _limit(claim: Claim, w: Writer) -> list[str]:
    variable, point = w.name(claim["variable"]), w.value(claim["point"])
    value = w.value(claim["value"])
    return [f"{w.value(claim['expression'])} {w.tends} {value} as {variable} {w.tends} {point}"]


def _increasing_onto(claim: Claim, w: Writer) -> list[str]:
    start, end = w.value(claim["from"]), w.value(claim["to"])
    return [
        f"{w.value(claim['expression'])} increases from {start} to {end} "
        f"as {w.name(claim['variable'])} goes from 0 to {w.infinity}"
    ]


def _names(rows: Sequence[Sequence[str]], w: Writer) -> str:
    return "[" + "; ".join(", ".join(w.name(name) for name in row) for row in rows) + "]"


def _riccati(claim: Claim, w: Writer) -> list[str]:
    gain = ", ".join(w.name(name) for name in claim["gain"])
    return [
        f"M = F X F' + {w.name(claim['index'])}^2 Q0, X = (I - K H) M, K = M H'/(H M H' + R)",
        f"with K = [{gain}]', M = {_names(claim['predicted'], w)}, "
        f"X = {_names(claim['updated'], w)}",
    ]


def _stable(claim: Claim, w: Writer) -> list[str]:
    gain = ", ".join(w.name(name) for name in claim["gain"])
    return [f"det(zI - F (I - K H)) = 0 only for |z| < 1, K = [{gain}]'"]


def _definite(claim: Claim, w: Writer) -> list[str]:
    return [f"{_names(claim['matrix'], w)} is positive definite"]


def _program(claim: Claim, w: Writer) -> list[str]:
    return [
        f"kernel {claim['program']}: {output} {w.equals} {w.value(graph)}"
        for output, graph in claim["outputs"].items()
    ]


def _sum(claim: Claim, w: Writer) -> list[str]:
    index, upper = w.name(claim["index"]), w.name(claim["upper"])
    return [
        f"sum of {w.value(claim['summand'])} over {index} {w.equals} {claim['start']}..{upper} "
        f"{w.equals} {w.value(claim['closed'])}"
    ]


def _definition(claim: Claim, w: Writer) -> list[str]:
    if "text" in claim:
        return [str(claim["text"])]
    return _equal(claim, w)


def _cited(claim: Claim, w: Writer) -> list[str]:
    return [str(claim["theorem"]), f"({claim['reference']})"]


def _unknown(kind: str) -> Callable[[Claim, Writer], list[str]]:
    return lambda claim, w: [f"({kind})"]


_KINDS: Mapping[str, Callable[[Claim, Writer], list[str]]] = {
    "equal": _equal,
    "positive": _positive,
    "same_sign": _same_sign,
    "limit": _limit,
    "increasing_onto": _increasing_onto,
    "riccati": _riccati,
    "stable": _stable,
    "positive_definite": _definite,
    "program": _program,
    "sum": _sum,
    "definition": _definition,
    "cited": _cited,
}
