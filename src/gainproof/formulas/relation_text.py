"""Relations of a certificate as lines of text or LaTeX, by their kind; those on matrices of every
size with their hypotheses.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.formulas.formula_term import Graph

Claim = Mapping[str, Any]

# equations in a definition in words: `F = [1, T; 0, 1], H = [1, 0]`
_EQUATION = re.compile(r"[A-Za-z][\w^-]* = ")
_EQUATIONS = re.compile(rf", (?={_EQUATION.pattern})")


@dataclass(frozen=True)
class Writer:
    """How formulas are written: `formula(graph, names, output)` with these names.

    `words` sets words among formulas, `plain` a whole line without formulas, `math` a formula of
    plain letters.
    """

    names: Mapping[str, str]
    formula: Callable[[Graph, Mapping[str, str], str], str]
    words: Callable[[str], str] = str
    plain: Callable[[str], str] = str
    math: Callable[[str], str] = str
    tends: str = "->"
    infinity: str = "infinity"
    at_least: str = ">="

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


def _equal(claim: Claim, w: Writer) -> list[str]:
    left, right = claim["left"], claim["right"]
    pairs = [(w.value(a), w.value(b)) for a, b in _entries(left, right)]
    # entries that read alike on both sides say nothing to a reader
    telling = [(a, b) for a, b in pairs if a != b] or pairs[:1]
    return list(dict.fromkeys(f"{a} = {b}" for a, b in telling))


def _entries(left: Graph, right: Graph) -> list[tuple[Graph, Graph]]:
    """Pairs of entries where both sides are matrices written out, else the two sides."""
    tops = [graph["nodes"][graph["outputs"]["value"]] for graph in (left, right)]
    if any(top[0] != "matrix" for top in tops):
        return [(left, right)]
    return [
        (_part(left, i), _part(right, j)) for i, j in zip(tops[0][3:], tops[1][3:], strict=True)
    ]


def _part(graph: Graph, number: int) -> Graph:
    return {"nodes": graph["nodes"], "outputs": {"value": number}}


def _matrix(rows: Sequence[Sequence[str]], w: Writer) -> str:
    """A matrix of named quantities."""
    nodes: list[list[Any]] = [["symbol", name] for row in rows for name in row]
    nodes.append(["matrix", len(rows), len(rows[0]), *range(len(nodes))])
    return w.value({"nodes": nodes, "outputs": {"value": len(nodes) - 1}})


def _gain(names: Sequence[str] | Sequence[Sequence[str]], w: Writer) -> str:
    """A column for one measurement, given as names; rows of names for several."""
    return _matrix([[entry] if isinstance(entry, str) else entry for entry in names], w)


def _positive(claim: Claim, w: Writer) -> list[str]:
    return [f"{w.value(claim['expression'])} > 0"]


def _same_sign(claim: Claim, w: Writer) -> list[str]:
    sign = w.words("sign of ")
    return [f"{sign}{w.value(claim['left'])} = {sign}{w.value(claim['right'])}"]


def _limit(claim: Claim, w: Writer) -> list[str]:
    variable, point = w.name(claim["variable"]), w.value(claim["point"])
    value = w.value(claim["value"])
    where = f"{w.words(' as ')}{variable} {w.tends} {point}"
    return [f"{w.value(claim['expression'])} {w.tends} {value}{where}"]


def _increasing_onto(claim: Claim, w: Writer) -> list[str]:
    start, end = w.value(claim["from"]), w.value(claim["to"])
    value, variable = w.value(claim["expression"]), w.name(claim["variable"])
    rise = f"{value}{w.words(' increases from ')}{start}{w.words(' to ')}{end}"
    way = f"{w.words(' as ')}{variable}{w.words(' goes from ')}0{w.words(' to ')}{w.infinity}"
    return [rise + way]


def _monotone(claim: Claim, w: Writer) -> list[str]:
    value, variable = w.value(claim["expression"]), w.name(claim["variable"])
    verb = {"increasing": " increases with ", "decreasing": " decreases with "}[claim["trend"]]
    return [f"{value}{w.words(verb)}{variable}"]


def _riccati(claim: Claim, w: Writer) -> list[str]:
    first, second = _letter(claim["predicted"], w, "M"), _letter(claim["updated"], w, "X")
    noise = f"{w.name(claim['index'])}^2 {w.math('Q0')}"
    return [
        f"K = {_gain(claim['gain'], w)}",
        f"{first} = {_matrix(claim['predicted'], w)}",
        f"{second} = {_matrix(claim['updated'], w)}",
        f"{first} = F {second} F' + {noise}",
        f"{second} = (I - K H) {first}",
        f"K = {first} H' (H {first} H' + R){w.math('^-1')}",
    ]


def _letter(rows: Sequence[Sequence[str]], w: Writer, otherwise: str) -> str:
    """The letter of a matrix, from how its first entry is written."""
    found = re.match(r"[A-Za-z]+(?=\d|_)", w.name(rows[0][0]))
    return found[0] if found else otherwise


def _stable(_: Claim, w: Writer) -> list[str]:
    only = w.words(" only for ")
    polynomial = w.math("det(z I - F (I - K H))")
    return [f"{polynomial} = 0{only}|z| < 1"]


def _definite(claim: Claim, w: Writer) -> list[str]:
    return [f"{_matrix(claim['matrix'], w)}{w.words(' is positive definite')}"]


def _program(claim: Claim, w: Writer) -> list[str]:
    kernel = w.words(f"kernel {claim['program']}, ")
    return [
        f"{kernel}{w.words(output)} = {w.value(graph)}"
        for output, graph in claim["outputs"].items()
    ]


def _sum(claim: Claim, w: Writer) -> list[str]:
    index, upper = w.name(claim["index"]), w.name(claim["upper"])
    terms = f"{w.words('sum of ')}{w.value(claim['summand'])}"
    over = f"{w.words(' over ')}{index} = {claim['start']}..{upper}"
    return [f"{terms}{over}{w.words(' is ')}{w.value(claim['closed'])}"]


def _definition(claim: Claim, w: Writer) -> list[str]:
    if "text" not in claim:
        return _equal(claim, w)
    parts = _EQUATIONS.split(str(claim["text"]))
    return [w.math(_spaced(part)) if _EQUATION.match(part) else w.plain(part) for part in parts]


def _spaced(equation: str) -> str:
    """Factors side by side, as everywhere else."""
    return re.sub(r"(?<=[\w)])\*(?=[\w(])", " ", equation)


def _cited(claim: Claim, w: Writer) -> list[str]:
    return [w.plain(str(claim["theorem"])), w.plain(f"({claim['reference']})")]


def _matrix_equal(claim: Claim, w: Writer) -> list[str]:
    return [f"{w.value(claim['left'])} = {w.value(claim['right'])}", *_hypotheses(claim, w)]


def _matrix_order(claim: Claim, w: Writer) -> list[str]:
    sign = w.at_least if claim["relation"] == ">=" else ">"
    return [
        f"{w.value(claim['larger'])} {sign} {w.value(claim['smaller'])}",
        *_hypotheses(claim, w),
    ]


def _matrix_invertible(claim: Claim, w: Writer) -> list[str]:
    return [f"{w.name(claim['matrix'])}{w.words(' is invertible')}", *_hypotheses(claim, w)]


def _matrix_trace(claim: Claim, w: Writer) -> list[str]:
    left, right = (f"{w.words('tr ')}({w.value(claim[side])})" for side in ("left", "right"))
    return [f"{left} = {right}", *_hypotheses(claim, w)]


def _hypotheses(claim: Claim, w: Writer) -> list[str]:
    """The hypotheses of an implication on a line below it."""
    said = [_hypothesis(entry, w) for entry in claim["given"]]
    return [f"{w.words('    if ')}{', '.join(said)}"] if said else []


def _hypothesis(entry: Claim, w: Writer) -> str:
    if entry["kind"] == "equal":
        return f"{w.value(entry['left'])} = {w.value(entry['right'])}"
    name = w.name(entry["matrix"])
    said = {
        "symmetric": f"{name} = {name}'",
        "definite": f"{name} > 0",
        "semidefinite": f"{name} {w.at_least} 0",
        "invertible": f"{name}{w.words(' is invertible')}",
        "full_column_rank": f"{name}{w.words(' has full column rank')}",
    }
    return said[entry["kind"]]


def _unknown(kind: str) -> Callable[[Claim, Writer], list[str]]:
    return lambda _, w: [w.plain(f"({kind})")]


_KINDS: Mapping[str, Callable[[Claim, Writer], list[str]]] = {
    "equal": _equal,
    "positive": _positive,
    "same_sign": _same_sign,
    "limit": _limit,
    "increasing_onto": _increasing_onto,
    "monotone": _monotone,
    "riccati": _riccati,
    "stable": _stable,
    "positive_definite": _definite,
    "program": _program,
    "sum": _sum,
    "definition": _definition,
    "cited": _cited,
    "matrix_equal": _matrix_equal,
    "matrix_order": _matrix_order,
    "matrix_invertible": _matrix_invertible,
    "matrix_trace": _matrix_trace,
}
