"""The page of a family read in order: what is named before it is used, what refers where.

The names are taken from the relations themselves; the sentences are the text under test.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from catalogue_subjects import derived

from gainproof.derive.catalogue import CATALOGUE
from gainproof.formulas.formula_text import plain_name
from gainproof.pages.lecture_items import Item, items, numbers
from gainproof.subjects.derived import Derived

FAMILIES = (
    "random-velocity",
    "random-acceleration",
    "continuous-white-acceleration",
    "position-velocity-random-velocity",
    "position-velocity-random-acceleration",
    "position-velocity",
    "acceleration-increments",
    "wiener-acceleration",
    "random-jerk",
    "continuous-white-jerk",
)
REFERENCE = re.compile(r"@([a-z0-9-]*[a-z0-9])")


def _symbols(value: Any) -> Iterator[str]:
    """Names of the symbols in a claim: those of its graphs and those in lists of names."""
    if isinstance(value, dict):
        if "nodes" in value:
            yield from (node[1] for node in value["nodes"] if node[0] == "symbol")
            return
        for key, entry in value.items():
            if key not in {"model", "free", "variable", "point"}:
                yield from _symbols(entry)
    elif isinstance(value, list):
        for entry in value:
            if isinstance(entry, str) and re.fullmatch(r"[a-z_]+\d*", entry):
                yield entry
            else:
                yield from _symbols(entry)


def _words(text: str) -> set[str]:
    """Names in the formulas of a sentence."""
    formulas = " ".join(re.findall(r"`([^`]*)`", text))
    # P11^o and y_+ are names, z^2 a power
    return set(re.findall(r"\(FK\)[12]|[A-Za-z]_[+-]|[A-Za-z]\w*(?:\^[od]\b)?", formulas))


def _used(item: Item, page: Derived) -> set[str]:
    found = {name for step in item.steps for name in _symbols(step.claim)}
    # roots of numbers are symbols of a certificate, to a reader they are numbers
    named = {name for name in found if not name.startswith("root_")}
    return {plain_name(page.symbols.get(name, name)) for name in named}


def _unnamed(page: Derived) -> list[str]:
    """Symbols in formulas and reasons of which no sentence up to there has spoken."""
    known: set[str] = set()
    missing = []
    symbols = {plain_name(latex) for latex in page.symbols.values()}
    for item in items(page.steps):
        known |= _words(item.first.sentence)
        if item.number == 1:  # the model's quantities are named below its formulas
            known |= _words(item.first.reason) | {"T", "H", "R", "Q", "F"}
        if "rest" in {name for step in item.steps for name in _symbols(step.claim)}:
            known.add("(1 - alpha)")
        used = _used(item, page) | (_words(item.first.reason) & symbols)
        missing += [f"{item.number}: {name}" for name in sorted(used - known)]
    return missing


@pytest.mark.parametrize("name", FAMILIES)
def test_every_symbol_is_named_before_it_is_used(name: str) -> None:
    assert _unnamed(derived(name)) == []


def test_a_symbol_used_before_it_is_named_is_seen() -> None:
    page = derived("random-velocity")
    late = tuple(sorted(page.steps, key=lambda step: step.id in {"parameter", "root-s"}))
    changed = Derived(**{**vars(page), "steps": late})
    assert any(entry.endswith(": s") for entry in _unnamed(changed))
    assert any(entry.endswith(": p") for entry in _unnamed(changed))


@pytest.mark.parametrize("name", [entry.name for entry in CATALOGUE])
def test_steps_refer_to_steps_before_them(name: str) -> None:
    found = items(derived(name).steps)
    known = numbers(found)
    for item in found:
        for place in REFERENCE.findall(item.first.sentence + item.first.reason):
            assert known[place] < item.number, (item.first.id, place)


@pytest.mark.parametrize("name", FAMILIES)
def test_no_sentence_comes_twice_and_none_is_empty(name: str) -> None:
    found = items(derived(name).steps)
    sentences = [item.first.sentence for item in found]
    assert len(set(sentences)) == len(sentences)
    assert all(item.first.sentence and item.first.reason for item in found)
    assert all("_" not in re.sub(r"`[^`]*`", "", sentence) for sentence in sentences)


@pytest.mark.parametrize("name", FAMILIES)
def test_parts_have_headings(name: str) -> None:
    headings = [item.first.heading for item in items(derived(name).steps) if item.first.heading]
    assert headings[0] == "The model"
    assert len(headings) == len(set(headings)) >= 6
