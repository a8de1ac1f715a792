"""Expressions as plain text, shared parts named once."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of, walk
from gainproof.verify.judge.exact.free_names import token_of
from gainproof.verify.judge.reader.printing import case_texts
from gainproof.verify.judge.reader.words import CASES, OF_CASES

LONG = 60
TERM = "term "
"""Begins the name of calls that stand for terms of sequences."""
HOLE = "*"
"""Stands for the index in the name of a term."""
SERIES = ("sum", "product")
"""Calls over an index, which is bound in their first part."""


def is_series(node: Expr) -> bool:
    """Whether a sum or product over an index."""
    return node.kind == "call" and node.name in SERIES


def written(*exprs: Expr, names: Mapping[Expr, str] | None = None) -> tuple[list[str], list[str]]:
    """`a = ...` lines, and each expression in terms of their left sides.

    A line is written for each part that has a name, and for long parts that occur more than once.
    """
    named = names or {}
    uses = Counter(part.key for node in walk(*exprs) for part in node.parts)
    texts: dict[bytes, tuple[str, int]] = {}
    lines: list[str] = []
    short = 0
    for node in walk(*exprs):
        text, strength = _text(node, texts)
        name = named.get(node)
        if name is None and uses[node.key] > 1 and len(text) > LONG:
            short += 1
            name = f"e{short}"
        if name is not None:
            lines.append(f"{name} = {text}")
            text, strength = name, 4
        texts[node.key] = text, strength
    return lines, [texts[e.key][0] for e in exprs]


def labelled(expr: Expr, labels: Mapping[str, str]) -> str:
    """The expression in the source's own symbols, on one line."""
    names = {name: symbol(labels.get(name, name)) for name in symbols_of(expr)}
    lines, (text,) = written(substituted(expr, names))
    return f"{text} with {', '.join(lines)}" if lines else text


def _text(node: Expr, texts: dict[bytes, tuple[str, int]]) -> tuple[str, int]:
    def part(k: int, least: int) -> str:
        text, strength = texts[node.parts[k].key]
        return text if strength >= least else f"({text})"

    count = range(len(node.parts))
    match node.kind:
        case "number":
            whole = node.fraction.denominator == 1 and node.fraction >= 0
            return str(node.fraction), 4 if whole else 1
        case "symbol":
            return token_of(node.name), 4
        case "add":
            joined = " + ".join(part(k, 1) for k in count).replace("+ -", "- ")
            return joined, 1
        case "mul":
            return " ".join(part(k, 3 if k else 2) for k in count), 2
        case "div":
            return f"{part(0, 2)} / {part(1, 3)}", 1
        case "neg":
            return f"-{part(0, 2)}", 1
        case "pow":
            if str(node.value) == "1/2":
                return f"sqrt({texts[node.parts[0].key][0]})", 4
            exponent = str(node.value)
            return f"{part(0, 4)}^{exponent if exponent.isdigit() else f'({exponent})'}", 3
        case "call":
            return _call(node.name, [texts[p.key][0] for p in node.parts]), 4
        case _:
            inner = ", ".join(texts[p.key][0] for p in node.parts)
            return f"{node.kind} {node.value}({inner})", 4


def _call(name: str, inner: list[str]) -> str:
    """A function as one writes it: sums and products with their index, terms of a sequence too."""
    if name in SERIES:
        body, index, first, last = inner
        return f"{name}({body}, {index} = {first}..{last})"
    if name.startswith(TERM):
        (index,) = inner
        plain = index.isalnum()
        return name.removeprefix(TERM).replace(HOLE, index if plain else "{" + index + "}")
    if name.startswith(OF_CASES):
        return f"{CASES}({'; '.join(case_texts(name, inner, ', ', ' and ', {}))})"
    return f"{name}({', '.join(inner)})" if inner else name
