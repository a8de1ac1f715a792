"""Which definitions a proof leaves closed, and what takes their place."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from gainproof.verify.judge.matrices.letter import MatrixSetting
from gainproof.verify.judge.matrices.opened import is_block, is_random, names_in
from gainproof.verify.judge.matrices.prove import Question, links
from gainproof.verify.judge.matrices.tree import Node

Closing = dict[str, Node | None]
"""What takes the place of definitions; nothing where a letter is closed."""


def closings(question: Question, setting: MatrixSetting) -> Iterator[Closing]:
    """What definitions become: with premises a letter what one of them says it is, and all others
    closed, or all but such as only pick rows; then those of blocks closed; then none.
    """
    letters = setting.letters
    # what depends on a random vector is not any matrix to a mean
    defined = {
        name: letter.definition
        for name, letter in letters.items()
        if letter.definition is not None and not is_random(name, setting)
    }
    picks = {name for name, node in defined.items() if is_block(node)}
    blocks = {n for n, node in defined.items() if node.kind == "matrix" and not _selects(node)}
    ways: list[Closing] = [dict.fromkeys(blocks | picks), {}]
    if question.premises:
        small = {n for n, node in defined.items() if node.kind == "matrix" and _selects(node)}
        said = _said(question, setting)
        every = {**dict.fromkeys(defined), **said}
        # an equation may follow from others word by word, an order rests on what is picked
        equations = all(chain.operators == ("=",) for chain in question.chains)
        ways.insert(0, {name: node for name, node in every.items() if name not in small})
        if said and equations:
            ways.insert(0, every)
    seen: list[Closing] = []
    for way in ways:
        reached = set(names_in(question.nodes(), with_closed(setting, way)))
        used = {name: node for name, node in way.items() if name in reached}
        if used not in seen:
            seen.append(used)
            yield used


def _selects(node: Node) -> bool:
    """Whether a matrix has no blocks but units and zeros."""
    return all(part.kind in ("unit", "zero") for part in node.parts)


def _said(question: Question, setting: MatrixSetting) -> Closing:
    """Letters with a definition that a premise says to be something made of other letters."""
    found: Closing = {}
    for premise in question.premises:
        for left, operator, right in links(premise.chains):
            for own, other in ((left, right), (right, left)):
                if (
                    operator == "="
                    and own.kind == "name"
                    and setting.letters[own.name].definition is not None
                    and not is_block(setting.letters[own.name].definition)  # type: ignore[arg-type]
                    and other.kind != "name"
                    and own.name not in found
                    and own.name not in names_in((other,), with_closed(setting, found))
                ):
                    found[own.name] = other
                    break
    return found


def with_closed(setting: MatrixSetting, closed: Closing) -> MatrixSetting:
    """The setting with definitions replaced."""
    letters = {
        name: replace(letter, definition=closed[name]) if name in closed else letter
        for name, letter in setting.letters.items()
    }
    return MatrixSetting(setting.sizes, letters)
