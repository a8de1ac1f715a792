"""The source's closed form (16) to (19), operation by operation as it is printed.

The equations are those of the claim file, which holds them as printed. They are evaluated as anyone
would who copies the paper: nothing is rearranged, so that it shows where the printed form loses its
digits. Numbers may be arrays of float64 or multiprecision floats; the tests evaluate it with many
digits and compare it with a Riccati solver, which shows that it is copied rightly.

The symbol B of (17b) to (17e) is never defined in the source. The value taken here,
S^4 + A(S^2/3 - 1), is the one that the source's equations fix.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from typing import Any

from gainproof.files import places
from gainproof.verify.judge.claim.file import read_claim_file
from gainproof.verify.judge.formula import Relation

Root = Callable[[Any], Any]

PARAMETERS = ("14a", "17g", "17h", "B", "17d", "17e", "17f", "17a", "17b", "17c")
"""What is computed first, in this order; B has no number."""
ENTRIES = ("16a", "16b", "16c", "18a", "18b", "18c", "18d", "19a", "19b", "19c")
GAINS = ("18a",)
"""Entries that later ones use by their symbol."""


def printed_form(r: Any, s: Any, sqrt: Root) -> Mapping[str, Any]:
    """The ten quantities by equation number, in units sigma_o = T = 1; ``sqrt`` of the numbers."""
    equations = _equations()
    known = {"r": r, "S": s, "T": 1}
    for number in PARAMETERS:
        if number == "B":
            known["B"] = s**4 + known["A"] * (s**2 / 3 - 1)
        else:
            known[_symbol(equations[number])] = _value(equations[number], known, sqrt)
    found = {}
    for number in ENTRIES:
        found[number] = _value(equations[number], known, sqrt)
        if number in GAINS:
            known[_symbol(equations[number])] = found[number]
    return found


@cache
def _equations() -> Mapping[str, Relation]:
    """The equations by number."""
    (path,) = (path for path in places.claim_files() if path.stem == "suzuki")
    claims = {claim.id: claim for claim in read_claim_file(path).claims}
    equations = {}
    for number in (*PARAMETERS, *ENTRIES):
        if number != "B":
            formula = claims[number].formula
            assert formula is not None
            ((equations[number],),) = (reading.relations for reading in formula.readings)
    return equations


def _symbol(equation: Relation) -> str:
    """What stands alone on the left."""
    ((kind, name),) = equation.left["nodes"]
    assert kind == "symbol"
    return str(name)


def _value(equation: Relation, known: Mapping[str, Any], sqrt: Root) -> Any:
    """The right side, from the left to the right as it is printed."""
    values: list[Any] = []
    for kind, *parts in equation.right["nodes"]:
        if kind == "number":
            values.append(int(parts[0]))
        elif kind == "symbol":
            values.append(known[parts[0]])
        elif kind == "pow":
            base, power = values[parts[0]], Fraction(parts[1])
            values.append(sqrt(base) if power == Fraction(1, 2) else base ** int(power))
        else:
            values.append(_operation(kind, [values[part] for part in parts]))
    return values[equation.right["outputs"]["value"]]


def _operation(kind: str, operands: list[Any]) -> Any:
    first, *others = operands
    match kind:
        case "neg":
            return -first
        case "add":
            return sum(others, first)
        case "mul":
            for other in others:
                first = first * other
            return first
        case "div":
            return first / others[0]
    raise ValueError(f"{kind} is not among the operations of the printed form")
