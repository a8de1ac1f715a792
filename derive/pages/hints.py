"""Hints for evidence, as lines of a page: what a proof uses besides what its statement says.

    hint stable
        using margin, poles             earlier steps that may be used; `nothing`: none
        square A by 1, left inverse B   a square A X A' of the condition or step X that is >= 0
        taken A by definite on B        A (left - right) B of the condition or step
        form (1 - L)/2                  a form without the difference that hides a sign

`aside` steps are used nowhere else, `heavy` letters are removed first, `numbers` are inner
products. `multiple` and `used` are written as `taken`. A source is the number of a condition behind
`if`, a step, `unit n`, `blocks n` or `inverse STEP left`. Of what a word makes: see
`words.statement` and `words.search`; a hint carries no authority, the checker decides.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from gainproof.derive.pages.formula import FormulaError

LISTS = ("using", "aside", "heavy", "numbers")
PRODUCTS = {"taken": "taken", "used": "used", "multiple": "multiples"}
NUMBERS = ("rank", "rounds", "above", "below")
TEXTS = {"left inverse": "left_inverse", "limit form": "limit_form", "form": "form", "side": "side"}


def read_hint(lines: Iterable[str]) -> dict[str, Any]:
    """The hint of some lines. Raises FormulaError for a line that is none."""
    found: dict[str, Any] = {}
    for line in lines:
        word, _, rest = line.partition(" ")
        if word in LISTS:
            found[word] = [] if rest == "nothing" else rest.split(", ")
        elif word == "square":
            found.setdefault("squares", []).append(_square(line, rest))
        elif word in PRODUCTS:
            before, middle, after = _parted(line, rest)
            found.setdefault(PRODUCTS[word], []).append((before, middle, after))
        elif word in NUMBERS and rest.isdigit():
            found[word] = int(rest)
        elif word == "definite":
            found[word] = _source(rest)
        else:
            for start, key in TEXTS.items():
                if line.startswith(f"{start} "):
                    found[key] = line.removeprefix(f"{start} ")
                    break
            else:
                known = ", ".join([*LISTS, "square", *PRODUCTS, *NUMBERS, "definite", *TEXTS])
                raise FormulaError(f"a hint that begins with {known} is wanted, {line!r} came")
    return found


def _square(line: str, text: str) -> tuple[Any, ...]:
    factor, by, rest = text.partition(" by ")
    source, *options = rest.split(", ")
    more: dict[str, Any] = {}
    for option in options:
        for start, key in (("left inverse ", "left_inverse"), ("weight ", "weight")):
            if option.startswith(start):
                more[key] = option.removeprefix(start)
        if option == "through":
            more[option] = True
    if not by or len(more) < len(options):
        wanted = "square F by SOURCE, left inverse G, weight W, through"
        raise FormulaError(f"{wanted!r} is wanted, what stands behind SOURCE if need be: {line!r}")
    return (factor, _source(source), more) if more else (factor, _source(source))


def _parted(line: str, text: str) -> tuple[str, Any, str]:
    before, by, rest = text.partition(" by ")
    source, on, after = rest.partition(" on ")
    if not (by and on):
        raise FormulaError(f"'L by SOURCE on R' is wanted behind the first word of {line!r}")
    return before, _source(source), after


def _source(text: str) -> Any:
    words = tuple(text.split(" "))
    return int(text) if text.isdigit() else text if len(words) == 1 else words
