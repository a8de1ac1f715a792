"""From text to the tokens that the grammar takes: every pass in its order."""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.reader.arguments import settle_arguments, settle_sides
from gainproof.verify.judge.reader.brackets import pair_brackets
from gainproof.verify.judge.reader.characters import refuse_characters
from gainproof.verify.judge.reader.layout import settle_brackets
from gainproof.verify.judge.reader.lexer import scan_tokens
from gainproof.verify.judge.reader.lines import settle_lines, settle_wide_spaces
from gainproof.verify.judge.reader.lists import settle_lists
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
