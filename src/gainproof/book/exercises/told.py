"""A planted error and its witness in words."""

from __future__ import annotations

from collections.abc import Mapping

from gainproof.book.exercises.planting import Planted
from gainproof.book.exercises.refutation import Witness
from gainproof.formulas.formula_text import plain_name
from gainproof.verdicts.witness_text import at_point, ball


def witness_sentence(witness: Witness, symbols: Mapping[str, str]) -> str:
    """`At Lambda = 1 the left side is 0.5, the right side is 0.75.`, with the radius of each
    enclosure where a number is not exact. `symbols`: LaTeX of the names.
    """
    names = {name: plain_name(latex) for name, latex in symbols.items()}
    point = {names.get(name, name): value for name, value in witness.point.items()}
    where = at_point({"point": point})
    if witness.names:
        known = [f"{names.get(name, name)} = {ball(v)}" for name, v in witness.names.items()]
        where = f"{where}, where {', '.join(known)}," if where else f"With {', '.join(known)}"
    left, right = ball(witness.left), ball(witness.right)
    match witness.shape:
        case "equal":
            entry = f", in row and column {witness.entry}," if witness.entry else ""
            told = f"the left side{entry} is {left}, the right side is {right}"
        case "positive":
            told = f"the expression is {left}, which is not above 0"
        case "limit":
            told = f"the limit is {left}, not {right}"
        case "sum":
            told = f"the terms add up to {left}, the closed form is {right}"
        case "monotone increasing":
            told = f"the derivative is {left}: it falls there"
        case _:
            told = f"the derivative is {left}: it rises there"
    sentence = f"{where} {told}.".strip()
    return sentence[0].upper() + sentence[1:]


def error_sentence(planted: Planted) -> str:
    """What was done to which line."""
    return f"Line {planted.line} is wrong ({planted.slip}; step {planted.id})."
