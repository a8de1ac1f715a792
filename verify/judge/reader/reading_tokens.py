"""From text to the tokens that the grammar takes: every pass in its order."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from gainproof.verify.judge.reader.bracket_contents import settle_brackets
from gainproof.verify.judge.reader.brackets import pair_brackets
from gainproof.verify.judge.reader.characters import refuse_characters
from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.function_arguments import settle_arguments, settle_sides
from gainproof.verify.judge.reader.lexer import scan_tokens
from gainproof.verify.judge.reader.lines import settle_lines, settle_wide_spaces
from gainproof.verify.judge.reader.plain_lexer import scan_plain_tokens
from gainproof.verify.judge.reader.tokens import FormulaToken
from gainproof.verify.judge.reader.vocabulary import Vocabulary


def read_tokens(text: str, vocabulary: Vocabulary, plain: bool = False) -> list[FormulaToken]:
    """The tokens of `text`, written in LaTeX or in plain text, brackets paired and named by what
    they hold.
    """
    refuse_characters(text)
    tokens: Sequence[FormulaToken] = (
        scan_plain_tokens(text, vocabulary) if plain else scan_tokens(text, vocabulary)
    )
    pairing = pair_brackets(text, tokens)
    tokens = settle_brackets(text, tokens, pairing)
    tokens = settle_lines(text, tokens, pairing)
    tokens = settle_lists(text, settle_wide_spaces(tokens), vocabulary)
    return settle_arguments(text, settle_sides(tokens))


def settle_lists(
    text: str, tokens: Sequence[FormulaToken], vocabulary: Vocabulary
) -> list[FormulaToken]:
    """The tokens again; a list of consecutive numbers behind a whole number becomes `0 \\leq k` or
    `1 \\leq i \\leq n`. ReaderError where the symbol is not declared as a whole number.
    """
    result: list[FormulaToken] = []
    number = 0
    while number < len(tokens):
        end = _list_end(tokens, number)
        if end is None:
            result.append(tokens[number])
            number += 1
            continue
        symbol, first = tokens[number], tokens[number + 2]
        if not vocabulary.is_integer(symbol.value):
            problem = f"a list of whole numbers, but {symbol.value} is not declared as an integer"
            raise ReaderError(problem, text, symbol.start, symbol.value)
        at_most = FormulaToken("RELATION", "<=", first.start, first.start)
        result += [first, at_most, symbol]
        if end < len(tokens) and tokens[end].kind == "COMMA":
            result.append(at_most)
            end += 1
        number = end
    return result


def _list_end(tokens: Sequence[FormulaToken], number: int) -> int | None:
    """The number after the dots of a list that begins at a symbol, or None: consecutive numbers, at
    least two of them if the list does not end.
    """
    kinds = [token.kind for token in tokens[number : number + 3]]
    if kinds != ["SYMBOL", "EQUAL", "NUMBER"]:
        return None
    values = [tokens[number + 2].value]
    place = number + 3
    while [token.kind for token in tokens[place : place + 2]] == ["COMMA", "NUMBER"]:
        values.append(tokens[place + 1].value)
        place += 2
    if [token.kind for token in tokens[place : place + 2]] != ["COMMA", "DOTS"]:
        return None
    if not all(value.isdigit() for value in values):
        return None
    steps = {int(b) - int(a) for a, b in pairwise(values)}
    ends = place + 2 < len(tokens) and tokens[place + 2].kind == "COMMA"
    return place + 2 if steps == {1} or (ends and not steps) else None
