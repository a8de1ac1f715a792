"""Formulas with the definitions that they use."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from gainproof.verify.judge.matrices.letter import Letter, MatrixSetting
from gainproof.verify.judge.matrices.tree import Node


def opened(
    nodes: Iterable[Node], letters: Mapping[str, Letter], variances: bool = False
) -> Iterator[Node]:
    """All parts of formulas, then of the definitions of letters among them, each letter's once;
    with `variances` those of random letters too.
    """
    waiting, seen, at = list(nodes), set[str](), 0
    while at < len(waiting):
        for part in waiting[at].walk():
            yield part
            if part.kind == "name" and part.name not in seen:
                seen.add(part.name)
                letter = letters[part.name]
                if letter.definition is not None:
                    waiting.append(letter.definition)
                if variances and letter.variance is not None:
                    waiting.append(letter.variance)
        at += 1


def names_in(nodes: Iterable[Node], setting: MatrixSetting) -> list[str]:
    """The letters that formulas depend on, in the order in which they are met."""
    parts = opened(nodes, setting.letters, variances=True)
    return list(dict.fromkeys(part.name for part in parts if part.kind == "name"))


def within(nodes: Iterable[Node], setting: MatrixSetting) -> MatrixSetting:
    """Only the letters that formulas depend on, in the order of the setting."""
    found = set(names_in(nodes, setting))
    letters = {name: letter for name, letter in setting.letters.items() if name in found}
    return MatrixSetting(setting.sizes, letters)


def inverted(nodes: Iterable[Node], setting: MatrixSetting) -> list[Node]:
    """What stands under an inverse, what is met last first."""
    parts = opened(nodes, setting.letters)
    found = dict.fromkeys(part.parts[0] for part in parts if part.kind == "inverse")
    return list(found)[::-1]
