"""What a misprint may have made of a formula of matrices: single changes of its text."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

from gainproof.verify.judge.matrices.letters import Letter, MatrixSetting
from gainproof.verify.judge.matrices.lexer import Token, tokens_of
from gainproof.verify.judge.matrices.printed_names import skip_blanks
from gainproof.verify.judge.matrices.size_conditions import split_bounds
from gainproof.verify.judge.repair.edits import LARGE, PLAIN, SLIGHT

MOST_SLIPS = 800
_ENDS = frozenset(("name", ")", "]", "}"))
_BEGINS = frozenset(("(", "[", "{", "relation", ",", "&", "row", "wide", "arrow", "begin"))
_OPEN, _CLOSE = frozenset("([{"), frozenset(")]}")
_AFTER_A_TERM = frozenset(("+", "-", "relation", ",", "&", "row", "arrow", "end"))
_OPPOSITE = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}
_WEAKER = {"<": "<=", ">": ">=", "<=": "<", ">=": ">"}
_PRINTED = {"<": "<", ">": ">", "<=": r"\leq", ">=": r"\geq"}


@dataclass(frozen=True)
class Slip:
    """The text with one change, its weight, and the change in words."""

    latex: str
    weight: int
    what: str


def slips(latex: str, setting: MatrixSetting) -> list[Slip]:
    """All of them, the slight ones first; most of them say nothing that fits."""
    formula, _ = split_bounds(latex, setting.sizes)
    tokens = tokens_of(formula, setting.letters, setting.sizes)
    found = dict[str, Slip]()
    for one in _changes(latex, tokens, setting):
        if one.latex != latex and one.latex not in found:
            found[one.latex] = one
    return sorted(found.values(), key=lambda slip: slip.weight)[:MOST_SLIPS]


def _changes(latex: str, tokens: list[Token], setting: MatrixSetting) -> Iterator[Slip]:
    def put(start: int, end: int, text: str, weight: int, what: str) -> Slip:
        return Slip(_put(latex, start, end, text), weight, what)

    for at, token in enumerate(tokens):
        start, end, after = token.position, token.end, tokens[at + 1 : at + 2]
        before = tokens[at - 1] if at else None
        printed = latex[start:end].strip()
        if token.kind in ("+", "-"):
            other = "-" if token.kind == "+" else "+"
            if other == "-" or (before is not None and before.kind not in _BEGINS):
                yield put(start, end, other, SLIGHT, f"{token.kind} becomes {other}")
            else:
                yield put(start, skip_blanks(latex, end), "", SLIGHT, "the minus is left out")
        elif token.kind == "relation" and token.value in _OPPOSITE:
            for table in (_OPPOSITE, _WEAKER):
                other = _PRINTED[table[token.value]]
                yield put(start, end, other, SLIGHT, f"{printed} becomes {other}")
        elif token.kind == "power":
            yield put(start, end, "", SLIGHT, f"{printed} is left out")
            for other in ("^T", "^{-1}"):
                if other not in (printed, printed.replace("{T}", "T")):
                    yield put(start, end, other, SLIGHT, f"{printed} becomes {other}")
        if token.kind in _ENDS and not (after and after[0].kind == "power"):
            yield put(end, end, "^T", SLIGHT, f"{_end_of(printed)} is transposed")
            yield put(end, end, "^{-1}", PLAIN, f"{_end_of(printed)} is inverted")
        if token.kind in ("name", "(", "[", "unit") and (before is None or before.kind in _BEGINS):
            yield put(start, start, "-", LARGE, "a minus is put in front of a term")
        if token.kind == "name":
            yield from _letters(latex, token, setting)
    yield from _swapped(latex, tokens)
    yield from _reaching(latex, tokens)
    yield from _too_many(latex, tokens)
    yield from _missing(latex, tokens, setting)


def _reaching(latex: str, tokens: list[Token]) -> Iterator[Slip]:
    """A transposition or inverse of one factor that is one of the factor before it as well, or one
    of what is in brackets that is one of the last factor there.
    """
    begins: list[int] = []
    opened: list[int] = []
    for at, token in enumerate(tokens):
        if token.kind in ("(", "["):
            opened.append(at)
        if token.kind == "name":
            begins.append(at)
        elif token.kind in (")", "]") and opened:
            begins.append(opened.pop())
        elif token.kind == "power" and begins and at:
            factor = begins[-1]
            if tokens[factor].kind in ("(", "[") and tokens[at - 1].kind in (")", "]"):
                opening, closing = tokens[factor], tokens[at - 1]
                inside = latex[opening.end : closing.position].strip()
                bare = f"{latex[: opening.position]}{inside}{latex[closing.end :]}"
                what = f"{latex[token.position : token.end].strip()} reaches over the last factor"
                yield Slip(bare, SLIGHT, what)
            before = [b for b in begins if b < factor and _ends_before(tokens, b, factor)]
            if before:
                start, power = tokens[before[-1]].position, token.position
                inner = latex[start:power].strip()
                text = f"{latex[:start]}({inner}){latex[power:]}"
                what = f"{latex[power : token.end].strip()} reaches over {inner}"
                yield Slip(text, SLIGHT, what)


def _ends_before(tokens: list[Token], begin: int, following: int) -> bool:
    """Whether what begins at one token, powers included, ends where the other begins."""
    depth, at = 0, begin
    while at < following:
        depth += (tokens[at].kind in ("(", "[")) - (tokens[at].kind in (")", "]"))
        at += 1
        if depth == 0:
            break
    while at < following and tokens[at].kind == "power":
        at += 1
    return at == following


def _too_many(latex: str, tokens: list[Token]) -> Iterator[Slip]:
    """A term of a sum left out, that is not its first one."""
    for at, token in enumerate(tokens):
        if token.kind not in ("+", "-") or at == 0 or tokens[at - 1].kind in _BEGINS:
            continue
        depth, end = 0, token.end
        for other in tokens[at + 1 :]:
            depth += (other.kind in _OPEN) - (other.kind in _CLOSE)
            if depth < 0 or (depth == 0 and (other.kind in _AFTER_A_TERM)):
                break
            end = other.end
        term = latex[token.position : end].strip()
        text = f"{latex[: token.position].rstrip()}{latex[end:]}"
        yield Slip(text.strip(), LARGE, f"a term too many: {term}")


def _missing(latex: str, tokens: list[Token], setting: MatrixSetting) -> Iterator[Slip]:
    """A term X, X Y X^T or X^T Y X that is missing at the end of a side."""
    letters = [a for a in setting.letters.values() if a.variance is None and not a.scalar]
    squares = [a for a in letters if a.shape[0] == a.shape[1]]
    terms = [y.name for y in squares]
    terms += [f"{x.name} {y.name} {x.name}^T" for y in squares for x in letters if _fits(x, y, 1)]
    terms += [f"{x.name}^T {y.name} {x.name}" for y in squares for x in letters if _fits(x, y, 0)]
    depth = 0
    ends = []
    for token in tokens:
        depth += (token.kind in _OPEN) - (token.kind in _CLOSE)
        if token.kind in ("relation", ",", "arrow") and depth == 0:
            ends.append(token.position)
    for end in (*ends, max((token.end for token in tokens), default=0)):
        for term in terms:
            for sign in "+-":
                text = " ".join(_put(latex, end, end, f" {sign} {term} ").split())
                yield Slip(text, LARGE, f"a missing term: {sign} {term}")


def _fits(one: Letter, square: Letter, side: int) -> bool:
    return one.name != square.name and one.shape[side] == square.shape[0]


def _put(latex: str, start: int, end: int, text: str) -> str:
    """The text with another piece in a place, a blank where letters would run together."""
    before, after = latex[:start], latex[end:]
    if text[-1:].isalpha() and after[:1].isalpha():
        text += " "
    if text[:1].isalpha() and before[-1:].isalpha():
        text = " " + text
    return before + text + after


def _end_of(printed: str) -> str:
    return "what is in brackets" if printed in (")", "]", "}") else printed


def _letters(latex: str, token: Token, setting: MatrixSetting) -> Iterator[Slip]:
    """Another letter of this shape, or of that of the transpose, or with another index."""
    own = setting.letters[token.value]
    for name, letter in setting.letters.items():
        alike = name.partition("_")[0] == token.value.partition("_")[0]
        if letter.scalar or name == token.value:
            continue
        if alike or letter.shape in (own.shape, own.shape[::-1]):
            text = _put(latex, token.position, token.end, name)
            weight = SLIGHT if alike else PLAIN
            yield Slip(text, weight, f"{token.value} becomes {name}")


def _swapped(latex: str, tokens: list[Token]) -> Iterator[Slip]:
    """Two neighbouring factors exchanged, each a letter with its powers."""
    factors: list[tuple[int, int]] = []
    for token in tokens:
        if token.kind == "name":
            factors.append((token.position, token.end))
        elif (
            token.kind == "power" and factors and not latex[factors[-1][1] : token.position].strip()
        ):
            factors[-1] = (factors[-1][0], token.end)
    for one, other in pairwise(factors):
        between = latex[one[1] : other[0]]
        if not between.strip():
            first, second = latex[slice(*one)], latex[slice(*other)]
            text = f"{latex[: one[0]]}{second} {first}{latex[other[1] :]}"
            yield Slip(text, PLAIN, f"{first.strip()} and {second.strip()} are exchanged")
