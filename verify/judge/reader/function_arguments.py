"""What a named function without brackets acts on, and from which side a variable comes.

`\\sin 2\\theta \\cos\\theta` is read; `\\sin \\omega t` is refused: whether t stands under the
sine, only its author knows. The message has both forms with brackets.
"""

from __future__ import annotations

from collections.abc import Sequence

from gainproof.verify.judge.reader.errors import ReaderError
from gainproof.verify.judge.reader.tokens import TAKES_ARGUMENTS, FormulaToken

_PAIRS = {
    "OPEN": "CLOSE",
    "LEFT_BRACE": "RIGHT_BRACE",
    "OVER_OPEN": "OVER_CLOSE",
    "ROW_OPEN": "ROW_CLOSE",
    "BAR_OPEN": "BAR_CLOSE",
    "EMPTY_OPEN": "BAR_CLOSE",
    "ROOT_OPEN": "ROOT_CLOSE",
    "MATRIX_OPEN": "MATRIX_CLOSE",
    "CASES_OPEN": "CASES_CLOSE",
    "CONDITION_OPEN": "CONDITION_CLOSE",
}
_CLOSES = frozenset(_PAIRS.values())
_ARGUMENTS = frozenset(
    ("SYMBOL", "CONSTANT", "FRAC", "SQRT", "LEFT_BRACE", "BAR_OPEN", "MATRIX_OPEN")
)
"""What an argument without brackets may be."""
_OF_MATRICES = frozenset(("det", "trace"))
"""Functions of a matrix that give a number."""
_UNCLEAR_AFTER = frozenset(
    (
        *("SYMBOL", "NUMBER", "CONSTANT", "FUNCTION", "FRAC", "SQRT"),
        *("SLASH", "TRANSPOSE", "AT", "UNDER"),
        *("OPEN", "LEFT_BRACE", "OVER_OPEN", "ROW_OPEN", "BAR_OPEN", "MATRIX_OPEN"),
    )
)

_FACTORS = _ARGUMENTS | {"NUMBER", "FUNCTION", "OPEN"}
_BETWEEN_FACTORS = frozenset(("DOT", "DOT_BEFORE_BIG", "SLASH"))


def settle_arguments(text: str, tokens: Sequence[FormulaToken]) -> list[FormulaToken]:
    """The tokens again, the argument of each named function between `ARGUMENT_OPEN` and
    `ARGUMENT_CLOSE` unless it has brackets of its own.
    """
    opens: dict[int, list[str]] = {}
    ends = _ends(tokens)
    for number, token in enumerate(tokens):
        if token.kind != "NAMED":
            continue
        start = _after_power(tokens, number + 1, ends)
        if start < len(tokens) and tokens[start].kind == "OPEN":
            continue
        end = _argument_end(tokens, start, ends)
        if end == start:
            raise ReaderError(_without_argument(text, tokens, number, ends), text, token.end)
        if _is_unclear(tokens, end):
            forms = " or ".join(_forms(text, tokens, number, end, ends))
            name = text[token.start : token.end]
            problem = f"what {name} acts on is not clear: write {forms}"
            raise ReaderError(problem, text, tokens[end].start, tokens[end].value)
        opens.setdefault(start, []).append("ARGUMENT_OPEN")
        opens.setdefault(end, []).insert(0, "ARGUMENT_CLOSE")
    result: list[FormulaToken] = []
    for number in range(len(tokens) + 1):
        place = tokens[number].start if number < len(tokens) else tokens[-1].end if tokens else 0
        result += [FormulaToken(kind, "", place, place) for kind in opens.get(number, ())]
        result += tokens[number : number + 1]
    return result


def _is_unclear(tokens: Sequence[FormulaToken], end: int) -> bool:
    """Whether what follows an argument without brackets may belong to it: `\\sin \\omega \\cdot t`,
    but not `\\sin\\theta \\cdot \\cos\\theta`.
    """
    if end >= len(tokens):
        return False
    dotted = tokens[end].kind in ("DOT", "DOT_BEFORE_BIG")
    before_function = [token.kind for token in tokens[end + 1 : end + 2]] == ["NAMED"]
    return tokens[end].kind in _UNCLEAR_AFTER or (dotted and not before_function)


def _without_argument(
    text: str, tokens: Sequence[FormulaToken], number: int, ends: dict[int, int]
) -> str:
    """What to say of a function that is followed by nothing that can be its argument; another
    function can, but only in brackets.
    """
    name = text[tokens[number].start : tokens[number].end]
    inner = _after_power(tokens, number + 1, ends)
    if inner >= len(tokens) or tokens[inner].kind != "NAMED":
        return f"{name} of what?"
    start = _after_power(tokens, inner + 1, ends)
    end = _factors_end(tokens, start, ends) if start < len(tokens) else start
    if end == start:
        return f"{name} of what?"
    return f"{name} of another function: write {_bracketed(text, tokens, number, inner, end)}"


def _forms(
    text: str, tokens: Sequence[FormulaToken], number: int, end: int, ends: dict[int, int]
) -> list[str]:
    """The function with all that may be its argument in brackets, and with no more than what has
    to be.
    """
    start = _after_power(tokens, number + 1, ends)
    last = _factors_end(tokens, start, ends)
    wide = _bracketed(text, tokens, number, start, last) if last > end else ""
    narrow = _bracketed(text, tokens, number, start, end)
    rest = text[tokens[end - 1].end : tokens[max(last, end + 1) - 1].end]
    return [form for form in (wide, narrow + rest) if form]


def _bracketed(text: str, tokens: Sequence[FormulaToken], number: int, start: int, end: int) -> str:
    """The function from its name on, the tokens from `start` to before `end` in brackets."""
    before = text[tokens[number].start : tokens[start - 1].end]
    return f"{before}({text[tokens[start].start : tokens[end - 1].end]})"


def _factors_end(tokens: Sequence[FormulaToken], start: int, ends: dict[int, int]) -> int:
    """The number after the factors from `start` on, up to a sum, a relation or a function."""
    number = start
    while number < len(tokens):
        begin = number + (number > start and tokens[number].kind in _BETWEEN_FACTORS)
        if begin >= len(tokens) or tokens[begin].kind not in _FACTORS:
            break
        number = _after_power(tokens, _after_one(tokens, begin, ends), ends)
    return number


def _ends(tokens: Sequence[FormulaToken]) -> dict[int, int]:
    """The number after the closing bracket for that of each opening one."""
    found: dict[int, int] = {}
    stack: list[int] = []
    for number, token in enumerate(tokens):
        if token.kind in _PAIRS:
            stack.append(number)
        elif token.kind in _CLOSES:
            found[stack.pop()] = number + 1
    return found


def _after_power(tokens: Sequence[FormulaToken], number: int, ends: dict[int, int]) -> int:
    if number < len(tokens) and tokens[number].kind == "POWER":
        return _after_one(tokens, number + 1, ends)
    return number


def _after_one(tokens: Sequence[FormulaToken], number: int, ends: dict[int, int]) -> int:
    """The number after one argument of a command."""
    if number >= len(tokens):
        return number
    kind, number = tokens[number].kind, number + 1
    if kind == "SQRT" and number < len(tokens) and tokens[number].kind == "ROOT_OPEN":
        number = ends[number]
    if kind in ("FRAC", "SQRT"):
        for _ in range(TAKES_ARGUMENTS[kind]):
            number = _after_one(tokens, number, ends)
        return number
    return ends.get(number - 1, number)


def _argument_end(tokens: Sequence[FormulaToken], start: int, ends: dict[int, int]) -> int:
    """The number after a number, or after what `_ARGUMENTS` begin, be it after a number; after a
    determinant or a trace of one: `\\ln \\det A`.
    """
    first = tokens[start] if start < len(tokens) else None
    if first is not None and first.kind == "NAMED" and first.value in _OF_MATRICES:
        inner = _after_power(tokens, start + 1, ends)
        if inner < len(tokens) and tokens[inner].kind == "OPEN":
            return ends[inner]
        end = _argument_end(tokens, inner, ends)
        return start if end == inner else end
    number = start
    if number < len(tokens) and tokens[number].kind == "NUMBER":
        number = _after_power(tokens, number + 1, ends)
    if number < len(tokens) and tokens[number].kind in _ARGUMENTS:
        number = _after_power(tokens, _after_one(tokens, number, ends), ends)
    return number


def settle_sides(tokens: Sequence[FormulaToken]) -> list[FormulaToken]:
    """The tokens again; after an arrow `0+`, `0^+`, `0^{+}` and `+0` end with `ONE_SIDED`."""
    result: list[FormulaToken] = []
    number, relation = 0, ""
    while number < len(tokens):
        if tokens[number].kind in ("EQUAL", "RELATION", "COMMA", "AND", "CONNECTIVE", "IF"):
            relation = tokens[number].value
        if relation != "->":
            result.append(tokens[number])
            number += 1
            continue
        kinds = [token.kind for token in tokens[number : number + 4]]
        signed = [token for token in tokens[number : number + 4] if token.kind in ("PLUS", "MINUS")]
        before = result[-1] if result else None
        length = 0
        if before is not None and before.value == "->" and kinds[:2] in _SIGNS_FIRST:
            if tokens[number + 1].value == "0":
                result.append(tokens[number + 1])
                length = 2
        elif kinds[:2] in _SIGNS_ABOVE:
            length = 2
        elif kinds[:4] in _SIGNS_BRACED:
            length = 4
        elif kinds[:1] in _SIGNS and (len(kinds) == 1 or kinds[1] in _ENDS_SIDE):
            length = 1
        if length:
            sign = signed[0]
            result.append(FormulaToken("ONE_SIDED", sign.value, sign.start, sign.end))
            number += length
            continue
        result.append(tokens[number])
        number += 1
    return result


_SIGNS = (["PLUS"], ["MINUS"])
_SIGNS_FIRST = (["PLUS", "NUMBER"], ["MINUS", "NUMBER"])
_SIGNS_ABOVE = (["POWER", "PLUS"], ["POWER", "MINUS"])
_SIGNS_BRACED = tuple(["POWER", "LEFT_BRACE", sign, "RIGHT_BRACE"] for sign in ("PLUS", "MINUS"))
_ENDS_SIDE = frozenset(("CLOSE", "CONDITION_CLOSE", "RIGHT_BRACE", "COMMA", "AND"))
