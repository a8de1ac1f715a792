"""Formulas, and after them the definitions that they use, directly or through others."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from gainproof.verify.judge.matrices.letters import Letter, MatrixSetting
from gainproof.verify.judge.matrices.tree import Node


def opened(
    nodes: Iterable[Node], letters: Mapping[str, Letter], variances: bool = False
) -> Iterator[Node]:
    """All parts of formulas, then of the definitions of letters among them, each letter's once;
    with `variances` those of random letters too.
    """
    for formula in formulas(nodes, letters, variances):
        yield from formula.walk()


def formulas(
    nodes: Iterable[Node], letters: Mapping[str, Letter], variances: bool = False
) -> Iterator[Node]:
    """Formulas, then the definitions that they use."""
    waiting, seen, at = list(nodes), set[str](), 0
    while at < len(waiting):
        yield waiting[at]
        for part in waiting[at].walk():
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
    names = (part.name for part in parts if part.kind == "name")
    return list(dict.fromkeys(setting.letters[name].scalar or name for name in names))


def outside_means(nodes: Iterable[Node], setting: MatrixSetting) -> set[str]:
    """The letters on whose values formulas depend elsewhere than under a mean."""
    waiting, found = list(nodes), set[str]()
    while waiting:
        node = waiting.pop()
        if node.kind == "name" and node.name not in found:
            found.add(node.name)
            definition = setting.letters[node.name].definition
            waiting += [] if definition is None else [definition]
        waiting += [] if node.kind == "expectation" else node.parts
    return found


def within(nodes: Iterable[Node], setting: MatrixSetting) -> MatrixSetting:
    """Only the letters that formulas depend on, in the order of the setting."""
    found = set(names_in(nodes, setting))
    found |= {name for name, letter in setting.letters.items() if letter.scalar in found}
    letters = {name: letter for name, letter in setting.letters.items() if name in found}
    return MatrixSetting(setting.sizes, letters)


def inverted(nodes: Sequence[Node], setting: MatrixSetting) -> list[Node]:
    """What stands under an inverse: in definitions first, from left to right, inner ones first."""
    every = list(formulas(nodes, setting.letters))
    ordered = [*every[len(nodes) :][::-1], *every[: len(nodes)]]
    return list(dict.fromkeys(node for formula in ordered for node in _inverted(formula)))


def _inverted(node: Node) -> Iterator[Node]:
    for part in node.parts:
        yield from _inverted(part)
    if node.kind == "inverse":
        yield node.parts[0]


def is_block(node: Node) -> bool:
    """Whether a definition picks rows and columns of one letter."""
    return (
        node.kind == "product"
        and [part.kind for part in node.parts] == ["transpose", "name", "matrix"]
        and node.parts[0].parts[0].kind == "matrix"
    )


def is_random(name: str, setting: MatrixSetting) -> bool:
    """Whether a letter is random or its definition depends on one that is."""
    waiting, seen = [name], set[str]()
    while waiting:
        letter = setting.letters[waiting.pop()]
        if letter.variance is not None:
            return True
        if letter.definition is not None and letter.name not in seen:
            waiting += [p.name for p in letter.definition.walk() if p.kind == "name"]
        seen.add(letter.name)
    return False
