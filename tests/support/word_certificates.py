"""Small certificates on matrices of every size, written by hand: nothing of derive is used.

Formulas are nested tuples: a name, a number as text, ("add" | "mul", a, b, ...), ("neg", a),
("transpose", a), ("inverse", name), ("div", a, b).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from copy import deepcopy
from typing import Any

from gainproof.verify.certificate import check

Data = dict[str, Any]
Formula = str | tuple[Any, ...]


def graph(formula: Formula) -> Data:
    """The graph of a formula."""
    nodes: list[list[Any]] = []

    def put(part: Formula) -> int:
        if isinstance(part, str):
            number = part.lstrip("-")[:1].isdigit()
            nodes.append(["number" if number else "symbol", part])
        elif part[0] == "pow":
            nodes.append(["pow", put(part[1]), part[2]])
        else:
            nodes.append([part[0], *[put(argument) for argument in part[1:]]])
        return len(nodes) - 1

    return {"nodes": nodes, "outputs": {"value": put(formula)}}


def poly(*terms: str, powers: Sequence[int] = ()) -> list[Any]:
    """A polynomial of terms such as "-1/2 A B'", the coefficient first, in canonical order."""
    made = []
    for term in terms:
        coefficient, *letters = term.split()
        made.append([coefficient, list(powers), letters])
    return sorted(made, key=lambda entry: (entry[2], entry[1]))


def cofactor(source: list[Any], left: list[Any], right: list[Any], turned: bool = False) -> Data:
    """left * equation * right."""
    flag = {"transposed": "yes"} if turned else {}
    return {"source": source, **flag, "left": left, "right": right}


ONE = poly("1")


def setting(matrices: Mapping[str, str], **fields: Any) -> Data:
    """A setting with these letters, their shapes as "rows columns"."""
    return {
        "parameters": [],
        "matrices": {name: shape.split() for name, shape in matrices.items()},
        "units": {},
        "blocks": {},
        "elements": {},
        "inverses": {},
        **fields,
    }


def equal(name: str, left: Formula, right: Formula, cofactors: list[Data], *given: Data) -> Data:
    """A statement of equality."""
    claim = {"left": graph(left), "right": graph(right), "given": list(given)}
    return statement(name, "matrix_equal", claim, {"cofactors": cofactors})


def order(
    name: str,
    larger: Formula,
    smaller: Formula,
    squares: list[Data],
    *given: Data,
    cofactors: list[Data] | None = None,
    rank: Data | None = None,
) -> Data:
    """A statement of order, strict if it has a rank."""
    claim = {
        "larger": graph(larger),
        "smaller": graph(smaller),
        "relation": ">" if rank else ">=",
        "given": list(given),
    }
    evidence: Data = {"squares": squares, "cofactors": cofactors or []}
    return statement(name, "matrix_order", claim, evidence | ({"rank": rank} if rank else {}))


def square(factor: list[Any], definite: list[Any], weight: list[Any] = ONE) -> Data:
    """weight * factor' D factor."""
    return {"weight": weight, "factor": factor, "definite": definite}


def invertible(name: str, matrix: str, evidence: Data, *given: Data) -> Data:
    """A statement that a letter is invertible."""
    return statement(name, "matrix_invertible", {"matrix": matrix, "given": list(given)}, evidence)


def statement(name: str, kind: str, claim: Data, evidence: Data) -> Data:
    """Any statement about the setting "main"."""
    return {"id": name, "kind": kind, "tower": "main", "claim": claim, "evidence": evidence}


def known(kind: str, matrix: str) -> Data:
    """A hypothesis on a letter."""
    return {"kind": kind, "matrix": matrix}


def equation(left: Formula, right: Formula) -> Data:
    """A hypothesis that two formulas are equal."""
    return {"kind": "equal", "left": graph(left), "right": graph(right)}


def certificate(place: Data, *statements: Data) -> Data:
    """All of them about one setting."""
    return {
        "format": "gainproof certificate 1",
        "subject": "words",
        "towers": {"main": place},
        "programs": {},
        "statements": list(deepcopy(statements)),
    }


def reasons(data: Data) -> dict[str, str]:
    """Why each statement is rejected, by its id; under "" why the whole is, if it is."""
    report = check(data)
    found = {result.id: result.reason for result in report.statements if result.reason}
    return found if report.accepted or found else {"": report.reason}
