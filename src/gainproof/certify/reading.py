"""A certificate as statements with goals: read off the claims, and off the evidence what helps."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import Any

from gainproof.certify.expression import (
    Matrix,
    NotExportedError,
    Tree,
    fraction,
    graph,
    number,
    one,
    polynomial,
    product,
    symbol,
    total,
    transposed,
)
from gainproof.certify.goals import Goal, Relation, Statement, Tower

UNRELATED = "_unrelated"
"""Added to a tower's name: its letters are any positive numbers, no root obeys anything."""
KINDS = ("equal", "positive", "same_sign", "riccati", "stable", "positive_definite")


def towers(certificate: Mapping[str, Any]) -> dict[str, Tower]:
    """The towers by name whose statements are exported."""
    found = {}
    for name, entry in certificate["towers"].items():
        with suppress(NotExportedError):
            found[name] = tower = _tower(entry)
            found[name + UNRELATED] = Tower(tower.names, {}, (), {})
    return found


def _tower(entry: Mapping[str, Any]) -> Tower:
    if "matrices" in entry:
        raise NotExportedError("matrices of any size")
    parameters = tuple(record["symbol"] for record in entry["parameters"])
    if any("coupled" in record for record in entry["generators"]):
        raise NotExportedError("coupled roots")
    names = (*parameters, *(record["symbol"] for record in entry["generators"]))
    relations = [
        Relation(record["symbol"], record["power"], polynomial(record["radicand"], names))
        for record in entry["generators"]
    ]
    return Tower(
        parameters,
        {record["symbol"]: record["from"] for record in entry["parameters"] if "from" in record},
        tuple(relations),
        {name: fraction(value, names) for name, value in entry["elements"].items()},
    )


def statements(certificate: Mapping[str, Any]) -> Iterator[Statement]:
    """Every statement that is proved in it (not what is cited or defined)."""
    for record in certificate["statements"]:
        kind = record["kind"]
        if kind in ("definition", "cited"):
            continue
        statement = Statement(record["id"], kind, record["tower"])
        try:
            if kind not in KINDS:
                raise NotExportedError(kind)
            entry = certificate["towers"][record["tower"]]
            goals = _goals(kind, record["claim"], record["evidence"], _tower(entry))
            yield replace(statement, goals=tuple(goals))
            if kind == "riccati":
                goals = _cofactors(record["claim"], record["evidence"], entry, _tower(entry))
                tower = record["tower"] + UNRELATED
                yield Statement(f"{record['id']}: cofactors", "cofactors", tower, tuple(goals))
        except NotExportedError as reason:
            yield replace(statement, left_out=str(reason))


def _goals(
    kind: str, claim: Mapping[str, Any], evidence: Mapping[str, Any], tower: Tower
) -> Iterator[Goal]:
    names = tower.names
    listed = tuple(fraction(value, names) for value in evidence.get("nonzero", ()))
    match kind:
        case "equal":
            free = tuple(claim.get("free", ()))
            sides = graph(claim["left"]), graph(claim["right"])
            for rows in zip(*sides, strict=True):
                for left, right in zip(*rows, strict=True):
                    yield Goal(left, right, free=free, nonzero=listed)
        case "positive":
            left = one(graph(claim["expression"]))
            yield Goal(left, fraction(evidence["value"], names), True, nonzero=listed)
        case "same_sign":
            factor = fraction(evidence["factor"], names)
            yield Goal(factor, factor, True)
            left, right = one(graph(claim["left"])), one(graph(claim["right"]))
            yield Goal(left, factor * right, nonzero=listed)
        case "riccati":
            yield from _riccati(claim, evidence, names)
        case "stable":
            yield from _stable(claim, evidence, names)
        case "positive_definite":
            matrix = _symbols(claim["matrix"])
            for size, value in enumerate(evidence["minors"], 1):
                minor = _determinant(tuple(row[:size] for row in matrix[:size]))
                yield Goal(minor, fraction(value, names), True)


def _symbols(rows: Sequence[Sequence[str]]) -> Matrix:
    return tuple(tuple(symbol(name) for name in row) for row in rows)


def _numbers(rows: Sequence[Sequence[Any]]) -> Matrix:
    if any(not isinstance(entry, str) for row in rows for entry in row):
        raise NotExportedError("models that hold symbols")
    return tuple(tuple(number(entry) for entry in row) for row in rows)


def _gain(claim: Mapping[str, Any]) -> Matrix:
    if not isinstance(claim["gain"][0], str):
        raise NotExportedError("vector measurements")
    return tuple((symbol(name),) for name in claim["gain"])


def _minus(left: Matrix, right: Matrix) -> Matrix:
    return tuple(
        tuple(a - b for a, b in zip(*rows, strict=True)) for rows in zip(left, right, strict=True)
    )


def _riccati(
    claim: Mapping[str, Any], evidence: Mapping[str, Any], names: Sequence[str]
) -> Iterator[Goal]:
    """S = H M H' + R > 0, K S = M H', X = M - K H M and M = F X F' + q Q0."""
    gain, model = _gain(claim), claim["model"]
    transition, noise = _numbers(model["transition"]), _numbers(model["process_noise"])
    measurement, deviation = (
        _numbers(model["measurement"]),
        one(_numbers(model["measurement_noise"])),
    )
    predicted, updated = _symbols(claim["predicted"]), _symbols(claim["updated"])
    seen = product(predicted, transposed(measurement))
    innovation = one(product(measurement, seen)) + deviation
    first = [[polynomial(entry, names) for entry in row] for row in evidence["numerators"]]
    below = polynomial(evidence["denominator"], names)
    inner = product(measurement, product(tuple(map(tuple, first)), transposed(measurement)))
    yield Goal(innovation, Tree("div", (one(inner) + deviation * below, below)), True)
    for row, product_row in zip(gain, seen, strict=True):
        yield Goal(row[0] * innovation, product_row[0])
    left = _minus(predicted, product(gain, product(measurement, predicted)))
    yield from _entries(updated, left)
    square = Tree("pow", (symbol(claim["index"]),), exponent=2)
    through = product(product(transition, updated), transposed(transition))
    scaled = tuple(tuple(square * entry for entry in row) for row in noise)
    right = tuple(
        tuple(total(pair) for pair in zip(*rows, strict=True))
        for rows in zip(through, scaled, strict=True)
    )
    yield from _entries(predicted, right)


def _cofactors(
    claim: Mapping[str, Any],
    evidence: Mapping[str, Any],
    entry: Mapping[str, Any],
    tower: Tower,
) -> Iterator[Goal]:
    """D^2 (s (F A F' - A) - F a a' F') + s d N^2 Q0 is the sum of cofactor times relation.

    With M = A/d, a = A H', s = H a + R d and the index N/D; identities of polynomials in letters.
    """
    model = claim["model"]
    names, index = tower.names, entry["elements"][claim["index"]]
    transition, noise = _numbers(model["transition"]), _numbers(model["process_noise"])
    measurement = _numbers(model["measurement"])
    first = tuple(
        tuple(polynomial(terms, names) for terms in row) for row in evidence["numerators"]
    )
    below = polynomial(evidence["denominator"], names)
    seen = product(first, transposed(measurement))
    deviation = one(_numbers(model["measurement_noise"]))
    innovation = one(product(measurement, seen)) + deviation * below
    above, under = (polynomial(index[part], names) for part in ("num", "den"))
    through = product(product(transition, first), transposed(transition))
    moved = product(transition, seen)
    relations = [
        Tree("pow", (symbol(relation.symbol),), exponent=relation.power) - relation.radicand
        for relation in tower.relations
    ]
    for place, written in evidence["cofactors"].items():
        i, j = (int(part) - 1 for part in place.split(","))
        inner = innovation * (through[i][j] - first[i][j]) - moved[i][0] * moved[j][0]
        left = under * under * inner + innovation * below * above * above * noise[i][j]
        pairs = zip(written, relations, strict=True)
        yield Goal(left, total([polynomial(terms, names) * rule for terms, rule in pairs]))


def _entries(left: Matrix, right: Matrix) -> Iterator[Goal]:
    for rows in zip(left, right, strict=True):
        for pair in zip(*rows, strict=True):
            yield Goal(*pair)


def _stable(
    claim: Mapping[str, Any], evidence: Mapping[str, Any], names: Sequence[str]
) -> Iterator[Goal]:
    """The rows of Schur and Cohn of det(z I - F (I - K H)): a_n - a_0 > 0 and a_n + a_0 > 0."""
    gain, model = _gain(claim), claim["model"]
    transition, measurement = _numbers(model["transition"]), _numbers(model["measurement"])
    loop = _minus(transition, product(product(transition, gain), measurement))
    row = _characteristic(loop)
    values = iter(evidence["values"])
    while len(row) > 1:
        for end in (row[-1] - row[0], row[-1] + row[0]):
            yield Goal(end, fraction(next(values), names), True)
        degree = len(row) - 1
        row = [row[-1] * row[k + 1] - row[0] * row[degree - k - 1] for k in range(degree)]


def _determinant(matrix: Matrix) -> Tree:
    """By the first row."""
    if len(matrix) == 1:
        return matrix[0][0]
    terms = []
    for column, entry in enumerate(matrix[0]):
        rest = tuple(row[:column] + row[column + 1 :] for row in matrix[1:])
        terms.append(number((-1) ** column) * entry * _determinant(rest))
    return total(terms)


def _characteristic(matrix: Matrix) -> list[Tree]:
    """Coefficients a_0, ..., a_n = 1 of det(z I - matrix): sums of principal minors with signs."""
    size = len(matrix)
    sums: list[list[Tree]] = [[] for _ in range(size + 1)]
    for chosen in range(1, 2**size):
        places = [place for place in range(size) if chosen >> place & 1]
        minor = _determinant(tuple(tuple(matrix[i][j] for j in places) for i in places))
        sums[size - len(places)].append(number((-1) ** len(places)) * minor)
    return [*(total(terms) for terms in sums[:size]), number(1)]
