"""Shown steps as the numbered items of a lecture page."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from gainproof.subjects.derived import DerivedStep


@dataclass(frozen=True)
class Item:
    """One number of the page: a step with a sentence and the steps that join it."""

    number: int
    steps: tuple[DerivedStep, ...]

    @property
    def first(self) -> DerivedStep:
        """The step whose heading, sentence and reason the item has."""
        return self.steps[0]

    def mark(self, marks: Mapping[str, str]) -> str:
        """The checker's word on the item: one word where all its steps have the same, else each
        word with the steps it is about.
        """
        by_word: dict[str, list[str]] = {}
        for step in self.steps:
            by_word.setdefault(marks[step.id], []).append(step.id)
        if len(by_word) == 1:
            return next(iter(by_word))
        return "; ".join(f"{word}: {', '.join(ids)}" for word, ids in by_word.items())


def items(steps: Iterable[DerivedStep]) -> list[Item]:
    """The items of all steps that are shown, numbered from 1."""
    groups: list[list[DerivedStep]] = []
    for step in steps:
        if not step.shown:
            continue
        if step.joins and groups:
            groups[-1].append(step)
        else:
            groups.append([step])
    return [Item(number, tuple(group)) for number, group in enumerate(groups, 1)]


def numbers(found: Sequence[Item]) -> dict[str, int]:
    """The number under which each step is shown, by the step's id."""
    return {step.id: item.number for item in found for step in item.steps}
