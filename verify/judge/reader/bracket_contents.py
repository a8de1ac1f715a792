"""What brackets hold: a condition, the entries of a row, the entries of a matrix, a quotient."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby, pairwise

from gainproof.verify.judge.reader.brackets import Pairing
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.formula_limits import MOST_ENTRIES
from gainproof.verify.judge.reader.tokens import FormulaToken

_RELATIONS = frozenset(("EQUAL", "RELATION"))
_SEPARATORS = frozenset(("COMMA", "WIDE", "GAP"))
_SINGLE = frozenset(("SYMBOL", "NUMBER", "CONSTANT", "GAP"))


def settle_brackets(
    text: str, tokens: Sequence[FormulaToken], pairing: Pairing
) -> list[FormulaToken]:
    """The tokens again, their number unchanged: brackets renamed by what stands directly in them,
    and what separates entries by `CELL` and `ROW`; `NOTHING` for what says nothing.
    """
    result = list(tokens)
    arguments = _argument_brackets(tokens, pairing)
    entries = 0
    for opening, closing in pairing.closing.items():
        held, kind = pairing.directly[opening], tokens[opening].kind
        inner = (
            [number for number in range(opening + 1, closing) if pairing.inside[number] == opening]
            if held & (_SEPARATORS | {"CELL", "LINE"})
            else []
        )
        if kind == "MATRIX_OPEN":
            _settle_matrix(result, inner, closing)
        elif kind == "CASES_OPEN":
            _settle_matrix(result, inner, closing)
            _settle_cases(result, opening, closing)
        elif kind == "OPEN" and held & _RELATIONS:
            _rename(result, opening, closing, "CONDITION")
        elif kind == "OPEN" and (ends := [n for n in inner if tokens[n].value == ";"]):
            # MATLAB ends a row with it, others separate arguments
            problem = "a semicolon in brackets may end a row: write a matrix, or a comma"
            raise ReaderError(problem, text, tokens[ends[0]].start, ";")
        elif kind == "OPEN" and opening not in arguments and _is_row(held):
            _rename(result, opening, closing, "ROW")
            _settle_row(result, inner)
        elif kind == "LEFT_BRACE" and "OVER" in held:
            _rename(result, opening, closing, "OVER")
        entries += sum(result[number].kind in ("CELL", "ROW") for number in inner)
        if entries > MOST_ENTRIES:
            problem = f"more than {MOST_ENTRIES} entries of matrices"
            raise ReaderError(problem, text, tokens[opening].start, tokens[opening].value)
    return result


def _rename(tokens: list[FormulaToken], opening: int, closing: int, what: str) -> None:
    tokens[opening] = replace(tokens[opening], kind=f"{what}_OPEN")
    tokens[closing] = replace(tokens[closing], kind=f"{what}_CLOSE")


def _is_row(held: frozenset[str]) -> bool:
    """Whether a bracket holds separate entries: a mere blank separates single letters and numbers
    only, as in `[1\\ 0]`.
    """
    return bool(held & {"COMMA", "WIDE"}) or ("GAP" in held and held <= _SINGLE)


def _settle_row(tokens: list[FormulaToken], inner: Sequence[int]) -> None:
    """One separator between two entries, however many are printed; none beside the brackets."""
    only_gaps = all(tokens[number].kind not in ("COMMA", "WIDE") for number in inner)
    for is_blank, group in groupby(inner, lambda number: tokens[number].kind in _SEPARATORS):
        run = list(group)
        if not is_blank:
            continue
        commas = [number for number in run if tokens[number].kind == "COMMA"]
        wide = [number for number in run if tokens[number].kind == "WIDE"]
        at_edge = run[0] == inner[0] or run[-1] == inner[-1]
        blanks = [] if at_edge else wide or (run if only_gaps else [])
        kept = commas or blanks[:1]
        for number in run:
            kind = "CELL" if number in kept else "NOTHING"
            tokens[number] = replace(tokens[number], kind=kind)


def _settle_matrix(tokens: list[FormulaToken], inner: Sequence[int], closing: int) -> None:
    for number in inner:
        if tokens[number].kind == "LINE":
            last = number + 1 == closing
            tokens[number] = replace(tokens[number], kind="NOTHING" if last else "ROW")
        elif tokens[number].kind in ("WIDE", "GAP"):
            tokens[number] = replace(tokens[number], kind="NOTHING")


def _settle_cases(tokens: list[FormulaToken], opening: int, closing: int) -> None:
    """Commas behind a value or a condition and the `if` before one say nothing."""
    said = [n for n in range(opening, closing + 1) if tokens[n].kind != "NOTHING"]
    for before, number in pairwise(said):
        kinds = tokens[before].kind, tokens[number].kind
        if kinds[0] == "COMMA" and kinds[1] in ("CELL", "ROW", "CASES_CLOSE", "OTHERWISE"):
            tokens[before] = replace(tokens[before], kind="NOTHING")
        if kinds == ("CELL", "IF"):
            tokens[number] = replace(tokens[number], kind="NOTHING")


def _argument_brackets(tokens: Sequence[FormulaToken], pairing: Pairing) -> set[int]:
    """The brackets that hold arguments of a function, in which a comma separates these."""
    found: set[int] = set()
    for number, token in enumerate(tokens):
        if token.kind in ("FUNCTION", "NAMED", "WORD", "EXPECT", "ORDER"):
            after = number + 1
            if after < len(tokens) and tokens[after].kind == "POWER":
                after += 1
                after = pairing.closing.get(after, after) + 1
            elif after < len(tokens) and tokens[after].kind == "TRANSPOSE":
                after += 1
            elif [t.kind for t in tokens[after : after + 2]] == ["RIGHT_BRACE", "LEFT_BRACE"]:
                # the derivative of a function, behind which its arguments may stand
                after = pairing.closing[after + 1] + 1
            if after < len(tokens) and tokens[after].kind == "OPEN":
                found.add(after)
    return found
