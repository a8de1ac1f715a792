"""The equations that proofs may use: of elements, blocks, hypotheses and single numbers."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from gainproof.derive.words.expression import Expression, symbol
from gainproof.derive.words.hypotheses import Hypothesis
from gainproof.derive.words.polynomial import Polynomial, Word
from gainproof.derive.words.rewriting import Cofactor, Rule, Source
from gainproof.derive.words.setting import Setting

SYMMETRIC = ("symmetric", "definite", "semidefinite")
Equations = list[tuple[Polynomial, Source]]


def element_rules(setting: Setting, name: str) -> list[Rule]:
    """A letter and its transpose are replaced by what they stand for."""
    meaning = setting.meanings[name]
    made = []
    for flag in (False, True):
        tail = meaning.T if flag else meaning
        word: Word = ((name, flag),)
        proof = Cofactor(("element", name), flag, *units(setting, tail))
        made.append(Rule(word, tail, (proof,)))
    return made


def equations(
    setting: Setting, pool: Sequence[Hypothesis], numbers: Sequence[Expression]
) -> tuple[Equations, Equations]:
    """Left less right of blocks and symmetric letters, and of single numbers and hypotheses."""
    plain, last = _blocks(setting), Equations()
    for entry in numbers:
        value = setting.expand(entry)
        last.append((value - value.T, ("number", Exact(value))))
    for number, hypothesis in enumerate(pool):
        if hypothesis["kind"] in SYMMETRIC:
            letter = setting.letter(hypothesis["matrix"])
            plain.append((letter.T - letter, ("given", number)))
        elif hypothesis["kind"] == "equal":
            left, right = setting.pair(_read(hypothesis["left"]), _read(hypothesis["right"]))
            last.append((left - right, ("given", number)))
    return plain, last


def units(setting: Setting, value: Polynomial) -> tuple[Polynomial, Polynomial]:
    """The unit matrices on both sides of a matrix."""
    assert value.shape is not None
    return setting.unit(value.shape[0]), setting.unit(value.shape[1])


def _blocks(setting: Setting) -> Equations:
    found = Equations()
    for size, columns in setting.blocks.items():
        letters = [setting.letter(name) for name in columns]
        for i, one in enumerate(letters):
            for j, other in enumerate(letters):
                value = one.T @ other
                if i == j:
                    value = value - setting.unit(setting.shape(columns[i])[1])
                found.append((value, ("blocks", size, i, j)))
        total = -setting.unit(size)
        for letter in letters:
            total = total + letter @ letter.T
        found.append((total, ("blocks", size)))
    return found


@dataclass(frozen=True, eq=False)
class Exact:
    """A polynomial as part of a source, told from others by which object it is."""

    value: Polynomial


def _read(graph: Mapping[str, Any]) -> Expression:
    """The formula of a graph."""
    made: list[Expression] = []
    for kind, *rest in graph["nodes"]:
        if kind == "pow":
            made.append(made[rest[0]] ** int(rest[1]))
        elif kind in ("number", "symbol"):
            made.append(Expression(kind, rest[0]) if kind == "number" else symbol(rest[0]))
        else:
            made.append(Expression(kind, "", tuple(made[number] for number in rest)))
    return made[-1]
