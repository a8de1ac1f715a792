"""The grammar, LALR(1) without conflicts, and its parser.

Not Earley: it finds many printed formulas ambiguous and settles them silently. The one ambiguity
that is meant to be kept, a slash before juxtaposed factors, is left to `build`, which makes every
reading of a flat product.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from typing import Any

from lark import Lark, Token, Tree, UnexpectedInput, UnexpectedToken
from lark.lexer import Lexer

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.tokens import FormulaToken

GRAMMAR = r"""
formula: statements condition* | statements CONNECTIVE statements | statements IF statements
conditions: statements
single: expression

statements: chain ((COMMA | AND) chain)*
condition: CONDITION_OPEN statements CONDITION_CLOSE
chain: side ((EQUAL | RELATION) side)+
side: expression | expression ONE_SIDED | infinity | limit
infinity: INFINITY | MINUS INFINITY | PLUS INFINITY
limit: LIM UNDER LEFT_BRACE chain RIGHT_BRACE term

expression: term ((PLUS | MINUS) term)* -> sum
          | MINUS term ((PLUS | MINUS) term)* -> minus_sum
          | PLUS term ((PLUS | MINUS) term)* -> plus_sum
?term: product | product big -> times_big | product DOT_BEFORE_BIG big -> times_big | big
     | product MOD product -> modulo
?big: PARTIAL_OPERATOR LEFT_BRACE PARTIAL order? RIGHT_BRACE below term -> derivative_operator
    | SUM UNDER index_range POWER bound term -> big_sum
    | SUM POWER bound UNDER index_range term -> big_sum_from_above
index_range: LEFT_BRACE SYMBOL EQUAL expression RIGHT_BRACE
bound: argument | INFINITY | LEFT_BRACE infinity RIGHT_BRACE
below: LEFT_BRACE over_symbol+ RIGHT_BRACE
over_symbol: PARTIAL SYMBOL order?
order: POWER argument
product: power (juxtaposed | dotted | divided | crossed | evaluated)*
juxtaposed: power
dotted: DOT power
divided: SLASH power
crossed: KRON power
evaluated: AT LEFT_BRACE statements RIGHT_BRACE
?power: atom
      | atom POWER argument -> raised
      | atom TRANSPOSE -> transposed
      | NAMED arguments -> named
      | NAMED POWER argument arguments -> named_raised
      | INTEGRAL UNDER bound POWER bound expression DIFFERENTIAL SYMBOL -> integral
      | INTEGRAL POWER bound UNDER bound expression DIFFERENTIAL SYMBOL -> integral_from_above
?atom: NUMBER -> number
     | SYMBOL -> symbol
     | CONSTANT -> constant
     | OPEN expression CLOSE -> group
     | OPEN expression CLOSE UNDER index_range POWER bound -> family
     | DOTS -> dots
     | LEFT_BRACE atom RIGHT_BRACE -> braced
     | OVER_OPEN expression OVER expression OVER_CLOSE -> over
     | BAR_OPEN expression BAR_CLOSE -> absolute
     | EMPTY_OPEN expression BAR_CLOSE UNDER LEFT_BRACE statements RIGHT_BRACE -> evaluated_group
     | FRAC argument argument -> fraction
     | FRAC_PARTIAL LEFT_BRACE PARTIAL order? product RIGHT_BRACE below -> derivative
     | FRAC_PARTIAL LEFT_BRACE PARTIAL order? FUNCTION RIGHT_BRACE below places -> derivative_there
     | SQRT argument -> root
     | SQRT ROOT_OPEN NUMBER ROOT_CLOSE argument -> root
     | FUNCTION OPEN expression (COMMA expression)* CLOSE -> call
     | FUNCTION POWER argument OPEN expression (COMMA expression)* CLOSE -> call_raised
     | FUNCTION TRANSPOSE OPEN expression (COMMA expression)* CLOSE -> call_transposed
     | WORD OPEN listed (COMMA listed)* CLOSE -> word_call
     | EXPECT OPEN expression CLOSE -> expectation
     | ORDER OPEN expression CLOSE -> order_of
     | EULER POWER argument -> euler
     | MATRIX_OPEN row (ROW row)* MATRIX_CLOSE -> matrix
     | ROW_OPEN row ROW_CLOSE -> matrix
     | CASES_OPEN case (ROW case)* CASES_CLOSE -> cases
case: expression (CELL (statements | OTHERWISE)?)?
row: expression (CELL expression)*
places: OPEN expression (COMMA expression)* CLOSE
arguments: OPEN listed (COMMA listed)* CLOSE | ARGUMENT_OPEN product ARGUMENT_CLOSE
?listed: expression | infinity
?argument: NUMBER -> number
         | SYMBOL -> symbol
         | CONSTANT -> constant
         | LEFT_BRACE expression RIGHT_BRACE -> group
         | OVER_OPEN expression OVER expression OVER_CLOSE -> over
         | FRAC argument argument -> fraction

%declare NUMBER SYMBOL CONSTANT FUNCTION NAMED WORD EXPECT ORDER EULER FRAC FRAC_PARTIAL
%declare PARTIAL_OPERATOR PARTIAL SQRT ROOT_OPEN ROOT_CLOSE SUM INTEGRAL DIFFERENTIAL LIM UNDER
%declare OVER AT TRANSPOSE ONE_SIDED DOTS
%declare PLUS MINUS DOT DOT_BEFORE_BIG KRON SLASH POWER COMMA AND IF CONNECTIVE EQUAL RELATION
%declare INFINITY OPEN CLOSE CONDITION_OPEN CONDITION_CLOSE LEFT_BRACE RIGHT_BRACE BAR_OPEN
%declare BAR_CLOSE EMPTY_OPEN OVER_OPEN OVER_CLOSE ROW_OPEN ROW_CLOSE MATRIX_OPEN MATRIX_CLOSE
%declare MOD CASES_OPEN CASES_CLOSE OTHERWISE
%declare CELL ROW ARGUMENT_OPEN ARGUMENT_CLOSE
"""

_WANTED = {
    "NUMBER": "a number",
    "SYMBOL": "a symbol",
    "OPEN": "(",
    "CLOSE": ")",
    "LEFT_BRACE": "{",
    "RIGHT_BRACE": "}",
    "EQUAL": "=",
    "RELATION": "a relation",
    "DIFFERENTIAL": "\\mathrm{d}",
    "UNDER": "_",
    "$END": "the end",
}


class _TokensGiven(Lexer):
    """Hands lark the tokens that `lexer` made."""

    def __init__(self, lexer_conf: Any) -> None:
        """Lark gives its configuration; nothing of it is needed."""

    def lex(self, data: Any) -> Iterator[Token]:  # type: ignore[override]  # lark hands over what parse() was given
        for token in data:
            yield Token(token.kind, token.value, token.start, end_pos=token.end)


@lru_cache(maxsize=1)
def _parser() -> Lark:
    return Lark(
        GRAMMAR,
        parser="lalr",
        lexer=_TokensGiven,
        start=["formula", "conditions", "single"],
        propagate_positions=True,
        maybe_placeholders=False,
        keep_all_tokens=True,
        strict=False,
    )


def parse_tokens(text: str, tokens: Sequence[FormulaToken], start: str) -> Tree[Token]:
    """The syntax tree of `tokens`, from the rule `start`; ReaderError where the grammar stops."""
    if not tokens:
        raise ReaderError("an empty formula", text, 0)
    try:
        return _parser().parse(tokens, start=start)
    except UnexpectedToken as error:
        raise _unexpected(text, tokens, error) from None
    except UnexpectedInput as error:  # pragma: no cover - the own lexer raises nothing else
        raise ReaderError("not read by the grammar", text, error.pos_in_stream or 0) from None


def _unexpected(text: str, tokens: Sequence[FormulaToken], error: UnexpectedToken) -> ReaderError:
    token = error.token
    wanted = ", ".join(
        sorted(_WANTED[kind] for kind in error.accepts | error.expected if kind in _WANTED)
    )
    wanted = f"; wanted: {wanted}" if wanted else ""
    if token.type == "$END":
        return ReaderError(f"the formula ends too early{wanted}", text, tokens[-1].end)
    position = token.start_pos or 0
    if token.type == "CONDITION_OPEN":
        problem = "a bracket that holds a relation may only stand at the end, after a relation"
        return ReaderError(problem, text, position, token.value)
    if token.type == "INFINITY":
        return ReaderError(
            "\\infty may only stand alone on the right of an arrow", text, position, token.value
        )
    under = next((t for t in reversed(tokens) if t.start < position), None)
    if token.type == "UNDER" or (under is not None and under.kind == "UNDER"):
        place = position if token.type == "UNDER" or under is None else under.start
        return ReaderError("this subscript belongs to no symbol", text, place, "_")
    shown = text[position : token.end_pos]
    if token.type == "AND" and shown.startswith("\\"):
        problem = f"{shown} separates relations and cannot stand within one{wanted}"
        return ReaderError(problem, text, position, shown)
    return ReaderError(f"{shown} cannot stand here{wanted}", text, position, shown)
