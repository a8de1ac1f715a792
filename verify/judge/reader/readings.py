"""What a formula was read as where its print has other sensible readings that the grammar has not:
each said in a few words, for a reader who meant another one.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from lark import Token

from gainproof.verify.judge.reader.tree import Branch, children, sole, start, tokens

_DEFINES = ("==", ":=", "\\coloneqq", "\\triangleq", "\\equiv")
"""Signs for = that some write in a definition, a test or an identity."""
_UP, _DOWN = ("<", "<="), (">", ">=")


def readings_taken(tree: Branch, text: str) -> tuple[str, ...]:
    """Clauses such as `f(x) is the product of f and x`, each once."""
    parts = sorted(tree.iter_subtrees(), key=start)
    return tuple(dict.fromkeys(words for part in parts for words in _taken(part, text)))


def chains(tree: Branch, text: str) -> tuple[str, ...]:
    """For each chain of three sides and more what it says: `a = b = c says a = b and b = c`."""
    parts = sorted(tree.iter_subtrees(), key=start)
    return tuple(_chain(part, text) for part in parts if _is_long(part))


def _taken(part: Branch, text: str) -> Iterator[str]:
    match part.data:
        case "chain":
            signs = [child for child in part.children if isinstance(child, Token)]
            shown = [text[sign.start_pos : sign.end_pos] for sign in signs]
            yield from (f"{sign} is an equation" for sign in shown if sign in _DEFINES)
            if _is_long(part) and not _is_transitive([str(sign) for sign in signs]):
                yield f"{_chain(part, text)} and nothing of other pairs"
        case "named" | "named_raised":
            (arguments,) = (child for child in children(part) if child.data == "arguments")
            inner = children(arguments)[0]
            if tokens(arguments, "ARGUMENT_OPEN") and len(inner.children) > 1:
                name = text[part.meta.start_pos : inner.meta.start_pos].rstrip()
                yield f"{_shown(part, text)} is {name}({_shown(inner, text)})"
        case "number" if (code := _shown(part, text))[-1:] in ("f", "F"):
            yield f"{code} is the number {code[:-1]}, single precision as in C"
        case "product":
            factors = children(part)
            for before, after in pairwise(factors):
                yield from _maybe_called(before, after, text)


def _maybe_called(before: Branch, after: Branch, text: str) -> Iterator[str]:
    """A symbol before another in brackets of its own, which do nothing in a product."""
    joined = before.data in ("juxtaposed", "dotted", "divided", "crossed")
    name = children(before)[-1] if joined else before
    base = children(name)[0] if name.data == "raised" else name
    group = children(after)[0] if after.data == "juxtaposed" else None
    if base.data != "symbol" or group is None or group.data != "group":
        return
    inner = sole(children(group)[0])
    if inner.data == "symbol" and tokens(group, "OPEN"):
        both = text[name.meta.start_pos : group.meta.end_pos]
        yield f"{both} is the product of {_shown(name, text)} and {_shown(inner, text)}"


def _is_long(part: Branch) -> bool:
    return part.data == "chain" and len(children(part)) > 2


def _is_transitive(signs: list[str]) -> bool:
    """Whether what a chain says of neighbours holds of all of its sides."""
    others = [sign for sign in signs if sign != "="]
    directions = (all(sign in signs for sign in others) for signs in (_UP, _DOWN))
    return len(others) < 2 or any(directions)


def _chain(part: Branch, text: str) -> str:
    sides = [_shown(side, text) for side in children(part)]
    signs = [child for child in part.children if isinstance(child, Token)]
    shown = [text[sign.start_pos : sign.end_pos] for sign in signs]
    links = [
        f"{left} {sign} {right}" for left, sign, right in zip(sides, shown, sides[1:], strict=False)
    ]
    return f"{_shown(part, text)} says {' and '.join(links)}"


def _shown(tree: Branch, text: str) -> str:
    return " ".join(text[tree.meta.start_pos : tree.meta.end_pos].split())
