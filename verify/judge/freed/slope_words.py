"""A proof by slopes, line by line."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from gainproof.verify.judge.exact.calculus import substituted
from gainproof.verify.judge.exact.expression import Expr, symbol, symbols_of
from gainproof.verify.judge.exact.expression_text import written
from gainproof.verify.judge.exact.statement import Rel
from gainproof.verify.judge.freed.away import Rising
from gainproof.verify.judge.freed.parts import Part
from gainproof.verify.judge.freed.pieces import Pieces
from gainproof.verify.judge.readable import readable

LONGEST = 300


def slope_lines(
    found: Iterable[Part], told: Mapping[Rel, Sequence[Part]], labels: Mapping[str, str]
) -> list[str]:
    """What is above 0, then each slope on which it rests, if not all its signs are plain."""
    return list(dict.fromkeys(_lines(found, told, labels)))


def _lines(
    found: Iterable[Part], told: Mapping[Rel, Sequence[Part]], labels: Mapping[str, str]
) -> Iterator[str]:
    for each in found:
        if isinstance(each, Rising) and each.ratio is not None:
            first, second = (labels.get(n, n) for n in each.ratio)
            labels = {**labels, each.name: f"({first}/{second})"}
        name = labels.get(each.name, each.name)
        stated = f"{_text(each.relation.left, labels)} {each.relation.operator} 0"
        if isinstance(each, Pieces):
            reach = f"{each.lower} <= {name} <= {each.upper}"
            yield f"{reach}: {stated}: balls show it on pieces, {each.count} of them"
            continue
        where = f"{name} = {each.point}"
        value = _text(each.value, labels)
        known = " and ".join(
            f"{_text(rel.left, labels)} {rel.operator} 0" for rel in dict.fromkeys(each.slopes)
        )
        turned = f"with 1/{name} in the place of {name}, " if each.turned else ""
        within = "" if each.within is None else f"{each.within.text(name)}: "
        yield f"{within}{turned}{stated}: it is {value} at {where}; slope away from there: {known}"
        below = (part for rel in each.slopes for part in told.get(rel, ()))
        yield from _lines(below, told, labels)


def _text(expr: Expr, labels: Mapping[str, str]) -> str:
    names = {name: symbol(labels.get(name, name)) for name in symbols_of(expr)}
    lines, (text,) = written(readable(substituted(expr, names)))
    text = "; ".join([text, *lines])
    return text if len(text) <= LONGEST else "(a long formula)"
